"""How many contact skills end where their own demonstration did, and which do not say so.

    PYTHONPATH=tests python tests/benchmarks/agreement_skills.py [RECORDINGS…] [--recorded 100]

Segmented by evidence, or with `--variant paper` by the paper's method.

RECORDINGS are files or folders; without, the bundled recordings and the real ones beside the
checkout. `--recorded N` records N demonstrations of the set-ups instead. A skill agrees if its
monitor, fed the recorded poses and forces, says "contact" within 0.25 s of the segment's end.
With `--moved` each contact boundary is moved by 50 to 200 ms either way, as a person would, and
counted is how often that changes its end condition's direction (10°) or threshold (20 %).
"""

import argparse
import math
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path

from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError, SkillError
from keyphase.labeling.edits import Move
from keyphase.labeling.label import label
from keyphase.readers import read
from keyphase.segmentation import Parameters, Segmenter, segment
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.end_condition.agreement import WITHIN_S
from keyphase.skills.agreement import outcome_on
from keyphase.skills.library import cut_at_contacts, skill_of

CHECKOUT = Path(__file__).parents[2]
MOVED_S = (-0.2, -0.15, -0.1, -0.05, 0.05, 0.1, 0.15, 0.2)
REAL = CHECKOUT.parent.parent / "shared" / "real_demonstrations"


def main() -> None:
    """Print a line for each skill that does not agree, then the sums."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("recordings", nargs="*", type=Path)
    parser.add_argument("--recorded", type=int, default=0)
    parser.add_argument("--variant", choices=("evidence", "paper"), default="evidence")
    parser.add_argument("--moved", action="store_true")
    given = parser.parse_args()
    kinds = MOVED if given.moved else COUNTED
    sums: dict[str, Counter[str]] = {}
    for group, demonstration in demonstrations(given.recordings, given.recorded):
        if demonstration.force_N is not None:
            parameters = Parameters(variant=given.variant)
            count = (moved if given.moved else counted)(demonstration, parameters)
            sums.setdefault(group, Counter()).update(count)
    print(f"| set | {' | '.join(kinds)} |")
    print("|---" * (1 + len(kinds)) + "|")
    for group, count in {**sums, "all": sum(sums.values(), Counter())}.items():
        cells = [count[key] for key in kinds]
        print(f"| {group} | {' | '.join(map(str, cells))} |")


COUNTED = ("contact skills", "agree", "say that they do not", "wrongly say that they do")
MOVED = (
    "moved boundaries",
    "end condition changed",
    "of them did not agree",
    "skill does not agree",
)


def counted(demonstration: Demonstration, parameters: Parameters) -> Counter[str]:
    """Contact skills of one demonstration: how many, and how many agree, say so, are wrong."""
    count: Counter[str] = Counter()
    for part in segment(demonstration, parameters).segments:
        if part.idle or not isinstance(part.end_condition, ContactEnd):
            continue
        try:
            skill = skill_of(demonstration, part)
        except SkillError as refused:
            print(f"{demonstration.name}: {refused}")
            continue
        outcome, time_s = outcome_on(skill, demonstration)
        late_s = time_s - part.end_s
        agrees = outcome == "contact" and abs(late_s) < WITHIN_S
        count["contact skills"] += 1
        count["agree"] += agrees
        count["say that they do not"] += skill.agrees is False
        count["wrongly say that they do"] += bool(skill.agrees) and not agrees
        if not agrees:
            print(f"{demonstration.name}, {part.label} until {part.end_s:.2f} s: {outcome}", end="")
            print(f" at {late_s:+.2f} s, says {skill.agrees}")
    return count


def moved(demonstration: Demonstration, parameters: Parameters) -> Counter[str]:
    """Contact boundaries moved by hand, one at a time: what becomes of their end conditions."""
    count: Counter[str] = Counter()
    segmenter = Segmenter(demonstration)
    proposed = segmenter.segment(parameters)
    for place, part in enumerate(proposed.segments[:-1]):
        was, after = part.end_condition, proposed.segments[place + 1]
        if not isinstance(was, ContactEnd):
            continue
        for moved_s in MOVED_S:
            at_s = part.end_s + moved_s
            if not part.start_s + 0.1 < at_s < after.end_s - 0.05:
                continue
            edits = {0: Move(part.end_s, at_s)}
            segments = label(proposed, edits, segmenter.segment_between).segments
            if len(segments) < len(proposed.segments):
                continue  # It took its neighbour's place.
            count["moved boundaries"] += 1
            now = segments[place].end_condition
            changed = not isinstance(now, ContactEnd) or is_changed(was, now)
            count["end condition changed"] += changed
            count["of them did not agree"] += changed and not was.agrees
            cut = cut_at_contacts(demonstration, segments[place : place + 2])[0]
            count["skill does not agree"] += skill_of(demonstration, cut).agrees is False
    return count


def is_changed(was: ContactEnd, now: ContactEnd) -> bool:
    """Whether the direction differs by more than 10°, or the threshold by more than 20 %."""
    cosine = sum(a * b for a, b in zip(was.direction, now.direction, strict=True))
    return (
        cosine < math.cos(math.radians(10.0)) or not 0.8 < now.threshold_N / was.threshold_N < 1.2
    )


def _made(cell: str) -> Iterator[Demonstration]:
    """Demonstrations of a set-up by the scripted operator; a few seeds do not accomplish it."""
    from keyphase.simulation import record

    for seed in range(100_000):
        with suppress(SimulationError):
            yield record(cell, seed=seed)


def demonstrations(paths: list[Path], recorded: int) -> Iterator[tuple[str, Demonstration]]:
    """Recordings with the name of their group."""
    if recorded:
        for cell in ("setup1", "setup2"):
            yield from ((cell, made) for made in islice(_made(cell), recorded // 2))
        return
    for path in paths or [CHECKOUT / "data", REAL]:
        files = sorted(path.rglob("*.npz")) if path.is_dir() else [path]
        for file in (f for f in files if f.parent.name != "raw"):
            yield file.parent.name, read(file)


if __name__ == "__main__":
    main()
