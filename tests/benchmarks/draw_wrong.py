"""Draws what is wrong on made demonstrations of families that the weights have never seen.

    python tests/benchmarks/draw_wrong.py --families wipe screw --output docs/pictures
    python tests/benchmarks/draw_wrong.py --real FOLDER --output docs/pictures

For each family the weights are fitted without it, as accuracy_made.py does; of its demonstrations
those with the most wrong contact changes are drawn: speed, force, the true changes as broad green
lines, those that were given in blue where they are right and in red where they are false, with
their confidence. What was missed is a green line alone.

With `--real`, a folder with a truth.json of whose recordings only contact is labelled, the most
wrong recording of each set is drawn as the weights that ship see it, broad lines the labels.
"""

import argparse
import json
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from accuracy_made import FIRST_SEED, found_with, taught_on
from draw_made import draw_speed
from matplotlib.figure import Figure

from keyphase.demonstration import Demonstration
from keyphase.making import FAMILIES, Made, make
from keyphase.readers import read
from keyphase.scoring import Claim, judge, read_truth
from keyphase.scoring.truth import Judged, ReferenceEvent
from keyphase.segmentation.evidence.fitting.fit import fit
from keyphase.segmentation.evidence.weights import Weights, shipped_weights

RIGHT, FALSE, TRUE = "#2f6fb3", "#d1495b", "#5b8c5a"


@dataclass(frozen=True)
class Seen:
    """A recording with what was given of it: claims of contact, which of them are not false, how
    many are false or missed, and where contact truly changed [s]."""

    name: str
    demonstration: Demonstration
    claims: list[Claim]
    right: list[bool]
    wrong: int
    changes_s: list[float]


def main() -> None:
    """Fit, segment, draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--families", nargs="+", choices=list(FAMILIES), default=[])
    parser.add_argument("--real", type=Path)
    parser.add_argument("--count", type=int, default=12, help="looked at of each family")
    parser.add_argument("--drawn", type=int, default=3, help="drawn of each family")
    parser.add_argument("--taught", type=int, default=8)
    parser.add_argument("--output", type=Path, default=Path("tests/pictures"))
    given = parser.parse_args()
    given.output.mkdir(parents=True, exist_ok=True)
    if given.real:
        draw_all(worst_of_sets(given.real), given.output / "wrong_real.png")
    lessons = taught_on(given.taught) if given.families else []
    for family in given.families:
        weights = fit([each for each in lessons if each.family != family])
        seeds = range(FIRST_SEED, FIRST_SEED + given.count)
        found = [of_made(make(family, seed), weights) for seed in seeds]
        found.sort(key=lambda each: (-each.wrong, each.name))
        draw_all(found[: given.drawn], given.output / f"wrong_{family}.png")
        wrong = [f"{each.name}: {each.wrong}" for each in found if each.wrong]
        print(f"{family}: {len(wrong)} of {len(found)} with something wrong; {', '.join(wrong)}")


def of_made(made: Made, weights: Weights) -> Seen:
    """A made demonstration as some weights see it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "truth.json"
        path.write_text(json.dumps({"it": made.truth()}))
        truth = read_truth(path)["it"].judged
    contact = tuple(event for event in truth.events if event.kind == "contact")
    return seen(made.demonstration.name, made.demonstration, truth, contact, weights)


def worst_of_sets(folder: Path) -> list[Seen]:
    """The recording of each set with the most wrong contact changes, where any is."""
    worst: dict[str, Seen] = {}
    for key, truth in read_truth(folder / "truth.json").items():
        judged = truth.judged
        if judged.what == "contact":
            it = read(folder / f"{key}.npz")
            found = seen(key, it, judged, judged.events, shipped_weights())
            of_set = key.partition("/")[0]
            if found.wrong > (worst[of_set].wrong if of_set in worst else 0):
                worst[of_set] = found
    return list(worst.values())


def seen(
    name: str,
    demonstration: Demonstration,
    truth: Judged,
    events: tuple[ReferenceEvent, ...],
    weights: Weights,
) -> Seen:
    """What is given of a recording, and how much of it is wrong."""
    claims = [c for c in found_with(weights, demonstration) if c.contact_change]
    contact = replace(truth, what="contact", events=events)
    whole = judge(contact, claims).tally
    right = [judge(contact, [claim]).tally.false == 0 for claim in claims]
    changes_s = [event.time_s for event in events]
    return Seen(name, demonstration, claims, right, whole.missed + whole.false, changes_s)


def draw_all(recordings: list[Seen], path: Path) -> None:
    """One below the other."""
    figure = Figure(figsize=(12.0, 3.6 * len(recordings)), layout="constrained")
    heights = [1, 2] * len(recordings)
    axes = figure.subplots(len(heights), 1, squeeze=False, height_ratios=heights)
    for row, each in enumerate(recordings):
        draw(each, axes[2 * row][0], axes[2 * row + 1][0])
    figure.savefig(path, dpi=70)


def draw(each: Seen, above, below) -> None:
    """Speed above, the force's components below."""
    it = each.demonstration
    draw_speed(it, above)
    above.set_title(f"{each.name}, {it.rate_hz:.0f} Hz", fontsize=9, loc="left")
    above.set_ylabel("m/s", fontsize=7)
    if it.force_N is not None:
        below.plot(it.time_s, it.force_N - np.median(it.force_N, axis=0), lw=0.7)
    below.set_ylabel("N", fontsize=7)
    for time_s in each.changes_s:
        below.axvline(time_s, color=TRUE, lw=5, alpha=0.35)
    for claim, good in zip(each.claims, each.right, strict=True):
        below.axvline(claim.time_s, color=RIGHT if good else FALSE, lw=1.2)
        top = below.get_ylim()[1]
        below.text(claim.time_s, top, f"{claim.confidence:.2f}", fontsize=6, rotation=45)
    for axes in (above, below):
        axes.set_xlim(it.start_s, it.end_s)
        axes.tick_params(labelsize=6)
        axes.spines[["top", "right"]].set_visible(False)


if __name__ == "__main__":
    main()
