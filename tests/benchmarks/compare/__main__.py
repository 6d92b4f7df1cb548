"""keyphase beside other methods: accuracy by set and time by length, in one run.

    make compare
    python tests/benchmarks/compare --count 10 --real FOLDER --claspy PYTHON --output DIR

prints one table in Markdown and writes it beside pictures. `--claspy` names the interpreter of an
environment with claspy, which needs older packages than keyphase; without it that column is left
out, and the output says so.
"""

import argparse
import json
import sys
import tempfile
import warnings
from collections.abc import Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import clasp
import methods
from report import draw, macro, table
from sets import Recording, made_recordings, real_recordings
from timing import LENGTHS_S, long_demonstration, timed

from keyphase.scoring import Claim, Tally, judge
from keyphase.scoring.counting import together


def main() -> None:
    """Compare, print, write."""
    given = _arguments()
    warnings.filterwarnings("ignore")
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        if given.choose_penalty:
            _choose_penalty(list(made_recordings(given.count, scratch, first=6_000_000)))
            return
        recordings = list(made_recordings(given.count, scratch))
        if given.real:
            recordings += real_recordings(given.real)
        scores = {m.name: _scored(recordings, m.find) for m in methods.METHODS}
        times = {m.name: _times(m.name) for m in methods.METHODS} if not given.no_times else {}
        if given.claspy:
            scores[clasp.NAME] = _scored_claspy(given.claspy, recordings, scratch / "accuracy")
            times[clasp.NAME] = _times_claspy(given.claspy, scratch)
        else:
            print("without claspy: no --claspy PYTHON was given", file=sys.stderr)
    made = {each.set for each in recordings if each.made}
    text = table(scores, times, made)
    print(text)
    given.output.mkdir(parents=True, exist_ok=True)
    (given.output / "compare.md").write_text(text + "\n")
    draw(scores, times, made, given.output / "compare.png")


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10, help="made recordings of each family")
    parser.add_argument("--real", type=Path, help="a folder of recordings with a truth.json")
    parser.add_argument("--claspy", type=Path, help="python of an environment with claspy")
    parser.add_argument("--output", type=Path, default=Path("tests/pictures"))
    parser.add_argument("--no-times", action="store_true")
    parser.add_argument("--choose-penalty", action="store_true")
    return parser.parse_args()


def _scored(recordings: Sequence[Recording], find) -> dict[str, Tally]:
    sets: dict[str, list[Tally]] = {}
    for each in recordings:
        claims: list[Claim] = find(each.demonstration, each.truth)
        sets.setdefault(each.set, []).append(judge(each.truth.judged, claims).tally)
    return {name: together(tallies) for name, tallies in sets.items()}


def _scored_claspy(python: Path, recordings: Sequence[Recording], scratch: Path) -> dict:
    answers = clasp.run(python, {each.key: each for each in recordings}, scratch, 1800.0)

    def find(demonstration, truth):
        key = next(each.key for each in recordings if each.demonstration is demonstration)
        return methods.found_by_others(answers.get(key, ([], 0.0))[0], truth)

    return _scored(recordings, find)


def _times(name: str) -> dict[float, float | str]:
    times: dict[float, float | str] = {}
    for length in LENGTHS_S:
        times[length] = timed(name, length)
        print(json.dumps([name, length, times[length]]), file=sys.stderr, flush=True)
    return times


def _times_claspy(python: Path, scratch: Path) -> dict[float, float | str]:
    times: dict[float, float | str] = {}
    for length in LENGTHS_S:
        recording = Recording("", "long", *long_demonstration(length), made=True)
        answers = clasp.run(python, {"long": recording}, scratch / f"{length:g}", 240.0)
        times[length] = answers["long"][1] if "long" in answers else "> 240 s"
    return times


def _choose_penalty(recordings: Sequence[Recording]) -> None:
    for penalty in (3.0, 6.0, 12.0, 25.0, 50.0, 100.0):
        methods.PENALTY = penalty
        print(penalty, macro(_scored(recordings, methods.kernel_penalty)))


if __name__ == "__main__":
    main()
