"""What arrives on recordings that were made otherwise than those that teach.

python tests/benchmarks/transfer_varied.py --cache CACHE

Six recordings of each simulated task teach, one or three of them; others are changed in one way
each. Told are F1 of what is proposed, outliers, those told to differ, and boundaries and names
that are wrong though they were given with 0.9 or more. Last, how many made recordings of every
family by formula, of other tasks all, are told apart, as they are and without force and gripper.
The cache is that of accuracy_transfer.py.
"""

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from joblib import Memory
from transferring.known import GRIPPER, WORKCELLS, Known, made, simulated
from transferring.trying import taught_by_truth, tries_of
from transferring.varying import VARIED

from keyphase.demonstration import Demonstration
from keyphase.making import FAMILIES, make
from keyphase.scoring.counting import together
from keyphase.transfer.proposing import propose, usual_cost_of
from keyphase.transfer.taught import Taught

SURE = 0.9
STRANGERS, PLAIN_STRANGERS = "made, of other tasks", "made, without force"
TEACHING = 6


def main() -> int:
    """Print a line for each way and task."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cache", type=Path, required=True, help="where recordings are kept")
    parser.add_argument("--count", type=int, default=8, help="recordings of each task")
    parser.add_argument("--only", default="", help="only ways with this in their name")
    asked = parser.parse_args()
    cached = Memory(asked.cache, verbose=0).cache(made)
    for task in (*WORKCELLS, GRIPPER):
        known = first_known(cached, task, TEACHING + asked.count)
        taught = [taught_by_truth(one) for one in known[:TEACHING]]
        for way, vary in VARIED.items():
            if asked.only in way:
                others = enumerate(known[TEACHING:])
                varied = [vary(one, np.random.default_rng([5, i])) for i, one in others]
                line = " | ".join(_line(some, varied) for some in (taught[3:4], taught[:3]))
                print(f"{task:26}{way:24}{line}", flush=True)
        plainly = [taught_by_truth(_plain(one)) for one in known[:TEACHING]]
        for way, all_taught in ((STRANGERS, taught), (PLAIN_STRANGERS, plainly)):
            if asked.only in way:
                strangers = _strangers(asked.count, plain=way == PLAIN_STRANGERS)
                parts = (all_taught[3:4], all_taught[:3])
                line = " | ".join(_told_apart(some, strangers) for some in parts)
                print(f"{task:26}{way:24}{line}", flush=True)
    return 0


def _strangers(count: int, *, plain: bool) -> list[Demonstration]:
    found = [make(family, seed).demonstration for family in FAMILIES for seed in range(count)]
    return [without_channels(one) for one in found] if plain else found


def _plain(known: Known) -> Known:
    return replace(known, demonstration=without_channels(known.demonstration))


def without_channels(demonstration: Demonstration) -> Demonstration:
    """Pose alone."""
    return replace(demonstration, force_N=None, torque_Nm=None, gripper=None)


def _told_apart(taught: Sequence[Taught], strangers: Sequence[Demonstration]) -> str:
    usual = usual_cost_of(taught)
    away = sum(propose(taught, one, usual_cost=usual).outlier for one in strangers)
    return f"{len(taught)}: {away} of {len(strangers)} outliers"


def first_known(cached, task: str, count: int) -> list[Known]:
    """The first recordings of a simulated task that did not fail."""
    found: list[Known] = []
    seed = 0
    while len(found) < count:
        one = cached(task, seed)
        found += [] if one is None else [simulated(task, seed, one)]
        seed += 1
    return found


def _line(taught: Sequence[Taught], varied: Sequence[Known]) -> str:
    tried = tries_of(taught, varied)
    fit = [one for one in tried if not one.outlier]
    f1 = together([one.counts["proposed"] for one in fit]).f1 if fit else None
    told = "outliers only" if f1 is None else f"F1 {f1:.3f}"
    wrong = [
        sum(sure >= SURE and not right for one in fit for sure, right in getattr(one, what))
        for what in ("sure_boundaries", "sure_names")
    ]
    away = len(tried) - len(fit)
    differ = sum(one.differs for one in fit)
    sure = f"sure and wrong {wrong[0]} and {wrong[1]} names"
    return f"{len(taught)}: {told}, {away} outliers, {differ} differ, {sure}"


if __name__ == "__main__":
    sys.exit(main())
