"""How far apart recordings of different tasks are, by the kinds of signals that both have.

python tests/benchmarks/unlike_costs.py --cache CACHE

Every two of the made families and of the simulated tasks are aligned. Told are the median of the
mean distance for each choice of kinds, what `unlike` takes it for, and the least squares of its
square, which are the constants in transfer/signals.py. The cache is that of accuracy_transfer.py.
"""

import argparse
import sys
from itertools import combinations
from pathlib import Path

import numpy as np
from joblib import Memory, Parallel, delayed
from transfer_varied import first_known
from transferring.known import GRIPPER, WORKCELLS, made

from keyphase.making import FAMILIES, make
from keyphase.transfer.alignment import align
from keyphase.transfer.signals import Signals, in_common, signals_of, unlike

KINDS = ("turn", "force", "gripper")
FIRST_SEED, OF_A_FAMILY, OF_A_TASK = 100, 3, 2


def main() -> int:
    """Print a line for each choice of kinds, and the constants."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cache", type=Path, required=True, help="where recordings are kept")
    cached = Memory(parser.parse_args().cache, verbose=0).cache(made)
    seeds = range(FIRST_SEED, FIRST_SEED + OF_A_FAMILY)
    some = [(one, signals_of(make(one, seed).demonstration)) for one in FAMILIES for seed in seeds]
    for task in (*WORKCELLS, GRIPPER):
        known = first_known(cached, task, OF_A_TASK)
        some += [(task, signals_of(one.demonstration)) for one in known]
    pairs = [(a, b) for (task, a), (other, b) in combinations(some, 2) if task != other]
    rows = np.array(Parallel(n_jobs=-1)(delayed(_row)(a, b) for a, b in pairs))
    kinds, cost = rows[:, :-1], rows[:, -1]
    for choice in np.unique(kinds, axis=0):
        at = (kinds == choice).all(axis=1)
        names = tuple(name for name, there in zip(KINDS, choice, strict=True) if there)
        median = float(np.median(cost[at]))
        print(f"{', '.join(names) or 'neither':24}{at.sum():6}{median:8.2f}{unlike(names):8.2f}")
    columns = np.c_[np.ones(len(kinds)), kinds]
    found = np.linalg.lstsq(columns, cost**2, rcond=None)[0]
    print("least squares:", ", ".join(f"{value:.2f}" for value in found))
    return 0


def _row(first: Signals, second: Signals) -> list[float]:
    shared = in_common(first, second)[0].kinds
    return [*(float(kind in shared) for kind in KINDS), align(first, second).residual.mean()]


if __name__ == "__main__":
    sys.exit(main())
