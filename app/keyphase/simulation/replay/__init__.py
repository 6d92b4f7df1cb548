"""A plan replayed in a workcell, once or in many disturbed worlds."""
