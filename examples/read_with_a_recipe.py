"""Read a table of one's own: write a recipe, and keyphase says what it did with the numbers."""

from pathlib import Path

import keyphase

RECIPE = """
[table]
separator = ";"
decimal = ","
[time]
column = "t"
unit = "ms"
[position]
columns = ["x", "y", "z"]
unit = "mm"
"""
Path("log.csv").write_text("t;x;y;z\n" + "".join(f"{20 * i};{i},5;0,0;1,0\n" for i in range(100)))
Path("log.csv.recipe.toml").write_text(RECIPE)
demonstration = keyphase.read("log.csv")
print(f"{demonstration.duration_s:.2f} s, {demonstration.position_m[-1]} m", *demonstration.notices)
