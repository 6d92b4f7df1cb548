"""A world made from a recording: what it met is there to be met again."""
