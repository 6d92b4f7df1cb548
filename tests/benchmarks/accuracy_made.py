"""How right keyphase is on made demonstrations of families that its weights have never seen.

    python tests/benchmarks/accuracy_made.py --count 134 --taught 8 --output tests/pictures

For each family in turn the weights are fitted as those that ship (`keyphase fit --count 8`), but
without that family: on `--taught` demonstrations of each of the others (seeds from 0) and of the
two set-ups. Then `--count` of the one left out (seeds from 1 000 000) are segmented and judged.
Prints the table of docs/scoring.md and writes it, figures as JSON and the calibration as a
picture. `--shipped` judges the weights that ship instead, which have seen every family.
"""

import argparse
import json
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from keyphase.commands.fit import SET_UPS
from keyphase.demonstration import Demonstration
from keyphase.making import FAMILIES, Made, make
from keyphase.scoring import Claim, RecordingScore, Score, Tally, as_json, calibration, read_truth
from keyphase.scoring.picture import draw_score
from keyphase.scoring.score import score_recording
from keyphase.segmentation import Parameters
from keyphase.segmentation.evidence.finding import EvidenceMethod
from keyphase.segmentation.evidence.fitting.fit import fit
from keyphase.segmentation.evidence.fitting.taught import Taught, Truth, taught
from keyphase.segmentation.evidence.weights import Weights, shipped_weights
from keyphase.segmentation.motion import motion_of
from keyphase.simulation.making import recorded_set_up

FIRST_SEED = 1_000_000
"""Far from the seeds of what weights are fitted on."""


def main() -> None:
    """Fit, segment, judge, print."""
    given = _arguments()
    families = given.families or list(FAMILIES)
    given.output.mkdir(parents=True, exist_ok=True)
    lessons: list[Taught] = []
    if not given.shipped:
        lessons = taught_on(given.taught)
        print(f"{len(lessons)} demonstrations to fit on", file=sys.stderr, flush=True)
    recordings: list[RecordingScore] = []
    for family in families:
        weights = shipped_weights()
        if not given.shipped:
            weights = fit([each for each in lessons if each.family != family])
        recordings += judged(family, given.count, weights)
        (given.output / "made.json").write_text(as_json(Score(tuple(recordings), ())))
        print(f"{family} judged", file=sys.stderr, flush=True)
    score = Score(tuple(recordings), ())
    text = table(score)
    print(text)
    (given.output / "made.md").write_text(text + "\n")
    draw_score(score, given.output / "made.png")


def taught_on(count: int) -> list[Taught]:
    """`count` demonstrations of every family and of both set-ups, as the fit sees them."""
    lessons = [lesson(make(f, seed)) for f in FAMILIES for seed in range(count)]
    return lessons + [lesson(recorded_set_up(f, s)) for f in SET_UPS for s in range(count)]


def judged(family: str, count: int, weights: Weights) -> list[RecordingScore]:
    """`count` demonstrations of a family, judged as their own truth file says."""
    scores = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "truth.json"
        for seed in range(FIRST_SEED, FIRST_SEED + count):
            made = make(family, seed)
            path.write_text(json.dumps({"it": made.truth()}))
            truth = read_truth(path)["it"]
            claims = found_with(weights, made.demonstration)
            span = (made.demonstration.start_s, made.demonstration.end_s)
            scores.append(score_recording(f"{family}/{seed}", truth, claims, span))
    return scores


def found_with(weights: Weights, demonstration: Demonstration) -> list[Claim]:
    """What the boundaries claim that these weights give."""
    method = EvidenceMethod(
        demonstration, lambda: motion_of(demonstration), lambda _: "changed", weights
    )
    return [
        Claim(b.time_s, b.contact_change, b.confidence, b.origin != "force")
        for b in method.find(Parameters()).boundaries
    ]


def lesson(made: Made) -> Taught:
    """A made demonstration as the fit sees it."""
    truth = Truth(
        time_s=np.array([event.time_s for event in made.events], dtype=float),
        window_s=_pairs([event.window_s for event in made.events]),
        contact=np.array([event.kind == "contact" for event in made.events], dtype=bool),
        ignore=_pairs(made.ignore_s),
        ignore_motion=_pairs(made.ignore_motion_s),
    )
    return taught(made.family, made.demonstration, truth)


def table(score: Score) -> str:
    """One line for each family and one for all, in Markdown."""
    head = "| family | recordings | contact F1 | motion F1 | all F1 | timing | calibration error |"
    lines = [f"{head} 0.9 and more, right |", "|---" * 8 + "|"]
    of_sets = score.calibration_of_sets
    for name, group in score.grouped.items():
        kinds, sure = score.kinds(name), of_sets[name]
        cells = [
            name,
            str(len(group)),
            _f1(kinds["contact"]),
            _f1(kinds["motion"]),
            _f1(score.judged_sets[name]),
            f"{1e3 * (score.judged_sets[name].timing_error_s or 0.0):.0f} ms",
            "–" if sure.error is None else f"{sure.error:.3f}",
            f"{sure.sure_right} of {sure.sure}",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    lines.append(_last_line(score))
    return "\n".join(lines)


def _last_line(score: Score) -> str:
    whole = calibration([o for each in score.recordings for o in each.judged.outcomes])
    contact = [score.kinds(name)["contact"] for name in score.grouped]
    motion = [score.kinds(name)["motion"] for name in score.grouped]
    mean = score.judged_macro_f1
    cells = [
        "**mean of families**",
        str(len(score.recordings)),
        _mean(contact),
        _mean(motion),
        "–" if mean is None else f"{mean:.2f}",
        "",
        "–" if whole.error is None else f"{whole.error:.3f}",
        f"{whole.sure_right} of {whole.sure}",
    ]
    return f"| {' | '.join(cells)} |"


def _mean(tallies: Sequence[Tally]) -> str:
    values = [t.f1 for t in tallies if t.recall is not None and t.f1 is not None]
    return f"{np.mean(values):.2f}" if values else "–"


def _f1(tally: Tally) -> str:
    if tally.recall is None:
        return f"{tally.false} false"
    return f"{tally.f1:.2f}"


def _pairs(values: Sequence[tuple[float, float]]) -> np.ndarray:
    return np.array(values, dtype=float).reshape(-1, 2)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=134, help="judged of each family")
    parser.add_argument("--taught", type=int, default=8, help="fitted on of each family")
    parser.add_argument("--families", nargs="+", choices=list(FAMILIES))
    parser.add_argument("--shipped", action="store_true")
    parser.add_argument("--output", type=Path, default=Path("tests/pictures"))
    return parser.parse_args()


if __name__ == "__main__":
    main()
