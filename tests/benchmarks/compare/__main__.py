"""keyphase beside other methods: accuracy by set and time by length, in one run.

    make compare
    python tests/benchmarks/compare --count 10 --real FOLDER --claspy PYTHON --output DIR

prints one table in Markdown and writes it beside pictures. `--claspy` names the interpreter of an
environment with claspy, which needs older packages than keyphase; without it that column is left
out, and the output says so. No method may take longer than `--budget` seconds of processor time
over all recordings, nor than `--limit` for one length: the table says who was stopped, and how many
recordings of a set it had done by then. So the whole ends within minutes.
"""

import argparse
import json
import sys
import tempfile
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import clasp
import methods
from report import Timed, draw, macro, table
from scoring_within import Judged, by_set, in_turns, scored
from sets import Recording, made_recordings, real_recordings
from timing import LENGTHS_S, MEANS_HZ, RATES_HZ, long_demonstration, timed

from keyphase.scoring import judge


def main() -> None:
    """Compare, print, write."""
    given = _arguments()
    warnings.filterwarnings("ignore")
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        if given.choose_penalty:
            recordings = list(made_recordings(given.count, scratch, first=6_000_000))
            _choose_penalty(recordings, given.budget)
            return
        recordings = list(made_recordings(given.count, scratch))
        if given.real:
            recordings += real_recordings(given.real)
        recordings = in_turns(recordings)
        scores, times = {}, {}
        for method in methods.METHODS:
            scores[method.name] = scored(method.name, recordings, given.budget)
            _say(method.name, scores[method.name])
            if not given.no_times:
                times[method.name] = _times(method.name, given.limit)
        if given.claspy:
            scores[clasp.NAME] = _scored_claspy(given, recordings, scratch / "accuracy")
            if not given.no_times:
                times[clasp.NAME] = _times_claspy(given, scratch)
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
    parser.add_argument("--budget", type=float, default=60.0, help="for accuracy, a method [s]")
    parser.add_argument("--limit", type=float, default=30.0, help="for one length, a method [s]")
    parser.add_argument("--no-times", action="store_true")
    parser.add_argument("--choose-penalty", action="store_true")
    return parser.parse_args()


def _say(name: str, sets: Mapping[str, Judged]) -> None:
    done, of = sum(each.done for each in sets.values()), sum(each.of for each in sets.values())
    print(json.dumps([name, f"{done} of {of}", macro(sets)]), file=sys.stderr, flush=True)


def _scored_claspy(
    given: argparse.Namespace, recordings: Sequence[Recording], scratch: Path
) -> dict[str, Judged]:
    known = {each.key: each for each in recordings}
    answers = clasp.run(given.claspy, known, scratch, given.budget)
    tallies = {
        key: judge(known[key].truth.judged, methods.found_by_others(found, known[key].truth)).tally
        for key, (found, _) in answers.items()
    }
    sets = by_set(recordings, tallies)
    _say(clasp.NAME, sets)
    return sets


def _times(name: str, limit_s: float) -> dict[Timed, float | str]:
    times: dict[Timed, float | str] = {}
    for length in LENGTHS_S:
        for rate_hz in RATES_HZ:
            times[length, rate_hz] = timed(name, length, rate_hz, limit_s)
            said = [name, length, rate_hz, times[length, rate_hz]]
            print(json.dumps(said), file=sys.stderr, flush=True)
    return times


def _times_claspy(given: argparse.Namespace, scratch: Path) -> dict[Timed, float | str]:
    times: dict[Timed, float | str] = {}
    for length in LENGTHS_S:
        recording = Recording("", "long", *long_demonstration(length), made=True)
        answers = clasp.run(given.claspy, {"long": recording}, scratch / f"{length:g}", given.limit)
        taken = answers["long"][1] if "long" in answers else f"> {given.limit:.0f} s"
        times[length, MEANS_HZ] = taken
        print(json.dumps([clasp.NAME, length, MEANS_HZ, taken]), file=sys.stderr, flush=True)
    return times


def _choose_penalty(recordings: Sequence[Recording], budget_s: float) -> None:
    name = "ruptures, penalty"
    for penalty in (0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 6.0, 12.0, 25.0):
        methods.PENALTY = penalty
        print(penalty, macro(scored(name, in_turns(recordings), budget_s)), flush=True)


if __name__ == "__main__":
    main()
