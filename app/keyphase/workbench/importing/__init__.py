"""Reading tables nobody has described yet: a person says what each column is."""
