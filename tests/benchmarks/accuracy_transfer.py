"""How well phases arrive on other recordings of their task, beside two things that are simpler.

python tests/benchmarks/accuracy_transfer.py --cache CACHE [--real ../shared/real_demonstrations]

For each task some recordings teach their true phases to all the others, one at a time and three at
a time. Beside: the boundaries the program finds by itself, and the taught ones stretched in time.
Simulated recordings take a while to make and are kept in CACHE.
"""

import argparse
import sys
from collections.abc import Iterable, Sequence
from itertools import combinations
from math import comb
from pathlib import Path

import numpy as np
from joblib import Memory, Parallel, delayed
from transferring.known import GRIPPER, WORKCELLS, Known, made, real_sets, simulated
from transferring.outliers import outliers
from transferring.repeated import REPEATED, repeated
from transferring.trying import METHODS, Tried, row, tries

TEACHERS = (1, 3)


def main() -> int:
    """Print the tables; the exit status says whether the goals are met."""
    asked = _asked()
    cached = Memory(asked.cache, verbose=0).cache(made)
    tasks = {
        task: _enough(cached, task, count, asked)
        for task, count in [*((one, asked.count) for one in WORKCELLS), (GRIPPER, asked.grips)]
        if count
    }
    by_simulation = set(tasks)
    by_goal = set(tasks)
    if asked.again:
        again = {name: repeated(name, seed, asked.again) for name, seed in REPEATED.items()}
        tasks |= again
        by_goal |= set(again)
    if asked.real is not None:
        tasks |= real_sets(asked.real)
    if asked.only:
        tasks = {name: known for name, known in tasks.items() if asked.only in name}
    good = True
    print(f"{'task':28}{'taught':>7}" + "".join(f"{name:>22}" for name in METHODS))
    everything: list[Tried] = []
    for name, known in tasks.items():
        for count in TEACHERS:
            tried = _tried(known, count, asked)
            everything += tried
            line, met = row(name, count, tried, simulated=name in by_goal)
            good &= met
            print(line, flush=True)
    good &= _calibrated(everything)
    good &= outliers({name: known for name, known in tasks.items() if name in by_simulation})
    return 0 if good else 1


def _asked() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cache", type=Path, required=True, help="where recordings are kept")
    parser.add_argument("--real", type=Path, help="folder of real recordings with its truth.json")
    parser.add_argument("--count", type=int, default=40, help="recordings of each workcell")
    parser.add_argument("--grips", type=int, default=40, help="recordings of the pick and place")
    parser.add_argument("--again", type=int, default=20, help="recordings of each made task")
    parser.add_argument("--only", default="", help="only tasks with this in their name")
    parser.add_argument("--seed", type=int, default=0, help="of who teaches")
    parser.add_argument("--first", type=int, default=0, help="seed of the first recording")
    parser.add_argument("--draws", type=int, default=5, help="choices of teachers; all, if fewer")
    parser.add_argument("--jobs", type=int, default=1)
    return parser.parse_args()


def _enough(cached, task: str, count: int, asked: argparse.Namespace) -> list[Known]:
    """The first `count` recordings of a task that did not fail."""
    found: list[Known] = []
    seed = asked.first
    while len(found) < count:
        seeds = range(seed, seed + count - len(found))
        some = Parallel(n_jobs=asked.jobs)(delayed(cached)(task, one) for one in seeds)
        found += [
            simulated(task, one, each)
            for one, each in zip(seeds, some, strict=True)
            if each is not None
        ]
        seed = seeds.stop
    return found


def _tried(known: Sequence[Known], count: int, asked: argparse.Namespace) -> list[Tried]:
    """All the others of a task, taught by every choice of `count`, or by as many as asked for."""
    if len(known) <= count:
        return []
    drawn = _choices(len(known), count, asked)
    results = Parallel(n_jobs=asked.jobs)(delayed(tries)(known, one) for one in drawn)
    return [tried for some in results for tried in some]


def _choices(known: int, count: int, asked: argparse.Namespace) -> list[list[int]]:
    """Which ones teach: every choice where there are no more than wanted, else drawn ones."""
    if comb(known, count) <= asked.draws:
        return [list(one) for one in combinations(range(known), count)]
    rng = np.random.default_rng(asked.seed)
    return [rng.choice(known, count, replace=False).tolist() for _ in range(asked.draws)]


def _calibrated(tried: Iterable[Tried]) -> bool:
    from keyphase.scoring.calibration import calibration

    tried = list(tried)
    good = True
    for what in ("boundaries", "names"):
        found = calibration([pair for one in tried for pair in getattr(one, f"sure_{what}")])
        if found.error is None:
            continue
        print(
            f"\nconfidences of {what}: {found.count}, expected calibration error {found.error:.3f}"
        )
        for each in found.bins:
            print(
                f"  {each.low:.1f} to {each.high:.1f}: {each.count:6} given {each.confidence:.2f} "
                f"right {each.right:.2f}"
            )
        good &= found.error < 0.1
    return good


if __name__ == "__main__":
    sys.exit(main())
