"""Reading by libraries in C in a process of its own, which a damaged file may end."""
