"""A recipe for a table of two arms: their positions in columns lx ly lz and rx ry rz, at t."""

RECIPE = """
time = {column = "t", unit = "s"}
[[demonstration]]
name = "left"
position = {columns = "l?", unit = "m"}
[[demonstration]]
name = "right"
position = {columns = "r?", unit = "m"}
"""
