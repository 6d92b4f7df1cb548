"""All recordings of a folder beside each other: what each has come to, and changes of all."""
