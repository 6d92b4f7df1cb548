"""Draws the pictures of docs/making.md: one demonstration of every family with its truth.

python tests/benchmarks/draw_made.py --seed 2 --output docs/pictures/made_families.png
"""

import argparse
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from keyphase.demonstration import Demonstration
from keyphase.making import FAMILIES, Made, make

COLUMNS = 3
CONTACT, MOTION = "#d1495b", "#2f6fb3"


def main() -> None:
    """Draw and write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument("--output", type=Path, default=Path("docs/pictures/made_families.png"))
    given = parser.parse_args()
    rows = -(-len(FAMILIES) // COLUMNS)
    figure = Figure(figsize=(15.0, 2.7 * rows), layout="constrained")
    places = figure.subplots(2 * rows, COLUMNS, squeeze=False, height_ratios=[1, 1.3] * rows)
    for index, family in enumerate(FAMILIES):
        row, column = divmod(index, COLUMNS)
        draw(make(family, given.seed), places[2 * row][column], places[2 * row + 1][column])
    figure.savefig(given.output, dpi=75)


def draw_speed(it: Demonstration, above) -> None:
    """The tool's speed over time [m/s], the mean of 50 ms."""
    step = np.gradient(it.position_m, axis=0) * it.rate_hz
    width = max(1, round(0.05 * it.rate_hz))
    speed = np.convolve(np.linalg.norm(step, axis=1), np.full(width, 1 / width), "same")
    above.plot(it.time_s, speed, color="#4a5560", lw=0.8)


def draw(made: Made, above, below) -> None:
    """Speed above, the force's components below, events as lines through both."""
    it = made.demonstration
    draw_speed(it, above)
    above.set_title(f"{made.family}, {it.rate_hz:.0f} Hz", fontsize=9, loc="left")
    above.set_ylabel("m/s", fontsize=7)
    if it.force_N is None:
        below.text(0.5, 0.5, "no wrench", ha="center", transform=below.transAxes, fontsize=8)
        below.set_xlim(above.get_xlim())
    else:
        below.plot(it.time_s, it.force_N, lw=0.7)
        below.set_ylabel("N", fontsize=7)
    for event in made.events:
        colour, style = (CONTACT, "-") if event.kind == "contact" else (MOTION, ":")
        for axes in (above, below):
            axes.axvline(event.time_s, color=colour, ls=style, lw=0.9)
    for axes in (above, below):
        axes.tick_params(labelsize=6)
        axes.spines[["top", "right"]].set_visible(False)


if __name__ == "__main__":
    main()
