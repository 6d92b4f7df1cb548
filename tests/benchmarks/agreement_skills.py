"""How many contact skills end where their own demonstration did, and which do not say so.

    PYTHONPATH=tests python tests/benchmarks/agreement_skills.py [RECORDINGS…] [--recorded 100]

Segmented by evidence, or with `--variant paper` by the paper's method.

RECORDINGS are files or folders; without, the bundled recordings and the real ones beside the
checkout. `--recorded N` records N demonstrations of the set-ups instead. A skill agrees if its
monitor, fed the recorded poses and forces, says "contact" within 0.25 s of the segment's end.
"""

import argparse
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path

from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError, SkillError
from keyphase.readers import read
from keyphase.segmentation import Parameters, segment
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.end_condition.agreement import WITHIN_S
from keyphase.skills.agreement import outcome_on
from keyphase.skills.library import skill_of

CHECKOUT = Path(__file__).parents[2]
REAL = CHECKOUT.parent.parent / "shared" / "real_demonstrations"


def main() -> None:
    """Print a line for each skill that does not agree, then the sums."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("recordings", nargs="*", type=Path)
    parser.add_argument("--recorded", type=int, default=0)
    parser.add_argument("--variant", choices=("evidence", "paper"), default="evidence")
    given = parser.parse_args()
    sums: dict[str, Counter[str]] = {}
    for group, demonstration in demonstrations(given.recordings, given.recorded):
        if demonstration.force_N is not None:
            parameters = Parameters(variant=given.variant)
            sums.setdefault(group, Counter()).update(counted(demonstration, parameters))
    print("| set | contact skills | agree | say that they do not | wrongly say that they do |")
    print("|---|---|---|---|---|")
    for group, count in {**sums, "all": sum(sums.values(), Counter())}.items():
        cells = [count[key] for key in ("skills", "agree", "say so", "wrong")]
        print(f"| {group} | {' | '.join(map(str, cells))} |")


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
        count["skills"] += 1
        count["agree"] += agrees
        count["say so"] += skill.agrees is False
        count["wrong"] += bool(skill.agrees) and not agrees
        if not agrees:
            print(f"{demonstration.name}, {part.label} until {part.end_s:.2f} s: {outcome}", end="")
            print(f" at {late_s:+.2f} s, says {skill.agrees}")
    return count


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
