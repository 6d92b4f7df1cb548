"""Draws what is wrong on made demonstrations of families that the weights have never seen.

    python tests/benchmarks/draw_wrong.py --families wipe screw --output docs/pictures

For each family the weights are fitted without it, as accuracy_made.py does; of its demonstrations
those with the most wrong contact changes are drawn: speed, force, the true changes as broad green
lines, those that were given in blue where they are right and in red where they are false, with
their confidence. What was missed is a green line alone.
"""

import argparse
import json
import tempfile
from pathlib import Path

import numpy as np
from accuracy_made import FIRST_SEED, found_with, taught_on
from draw_made import draw_speed
from matplotlib.figure import Figure

from keyphase.making import FAMILIES, Made, make
from keyphase.scoring import Claim, judge, read_truth
from keyphase.segmentation.evidence.fitting.fit import fit

RIGHT, FALSE, TRUE = "#2f6fb3", "#d1495b", "#5b8c5a"


def main() -> None:
    """Fit, segment, draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--families", nargs="+", choices=list(FAMILIES), required=True)
    parser.add_argument("--count", type=int, default=12, help="looked at of each family")
    parser.add_argument("--drawn", type=int, default=3, help="drawn of each family")
    parser.add_argument("--taught", type=int, default=8)
    parser.add_argument("--output", type=Path, default=Path("tests/pictures"))
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    lessons = taught_on(given.taught)
    for family in given.families:
        weights = fit([each for each in lessons if each.family != family])
        found = []
        for seed in range(FIRST_SEED, FIRST_SEED + given.count):
            made = make(family, seed)
            claims = [c for c in found_with(weights, made.demonstration) if c.contact_change]
            wrong, right = judged(made, claims)
            found.append((wrong, made, claims, right))
        found.sort(key=lambda each: (-each[0], each[1].demonstration.name))
        figure = Figure(figsize=(12.0, 3.6 * given.drawn), layout="constrained")
        axes = figure.subplots(
            2 * given.drawn, 1, squeeze=False, height_ratios=[1, 2] * given.drawn
        )
        for row, (_, made, claims, right) in enumerate(found[: given.drawn]):
            draw(made, claims, right, axes[2 * row][0], axes[2 * row + 1][0])
        figure.savefig(given.output / f"wrong_{family}.png", dpi=70)
        wrong = [f"{each[1].demonstration.name}: {each[0]}" for each in found if each[0]]
        print(f"{family}: {len(wrong)} of {len(found)} with something wrong; {', '.join(wrong)}")


def judged(made: Made, claims: list[Claim]) -> tuple[int, list[bool]]:
    """How many contact changes are missed or false, and which claims are right or lie where nobody
    knows."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "truth.json"
        path.write_text(json.dumps({"it": made.truth()}))
        truth = read_truth(path)["it"].judged
    contact = judge(truth, claims).kinds["contact"]
    alone = [judge(truth, [claim]).kinds["contact"] for claim in claims]
    return contact.missed + contact.false, [tally.false == 0 for tally in alone]


def draw(made: Made, claims: list[Claim], right: list[bool], above, below) -> None:
    """Speed above, the force's components below."""
    it = made.demonstration
    draw_speed(it, above)
    above.set_title(f"{it.name}, {it.rate_hz:.0f} Hz", fontsize=9, loc="left")
    above.set_ylabel("m/s", fontsize=7)
    if it.force_N is not None:
        below.plot(it.time_s, it.force_N - np.median(it.force_N, axis=0), lw=0.7)
    below.set_ylabel("N", fontsize=7)
    for event in made.events:
        if event.kind == "contact":
            below.axvline(event.time_s, color=TRUE, lw=5, alpha=0.35)
    for claim, good in zip(claims, right, strict=True):
        below.axvline(claim.time_s, color=RIGHT if good else FALSE, lw=1.2)
        top = below.get_ylim()[1]
        below.text(claim.time_s, top, f"{claim.confidence:.2f}", fontsize=6, rotation=45)
    for axes in (above, below):
        axes.set_xlim(it.start_s, it.end_s)
        axes.tick_params(labelsize=6)
        axes.spines[["top", "right"]].set_visible(False)


if __name__ == "__main__":
    main()
