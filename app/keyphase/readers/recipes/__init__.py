"""Recipes: what the columns of somebody else's table are, said in a file and checked."""
