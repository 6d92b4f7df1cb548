"""All that a person does with recordings."""
