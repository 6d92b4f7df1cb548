"""Correct, name and order what the program found, and never lose any of it."""
