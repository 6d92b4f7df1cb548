"""How often segmentations are right on synthetic demonstrations, and how far boundaries are off.

    PYTHONPATH=tests python tests/benchmarks/accuracy_segmentation.py [--demonstrations 200]

prints the tables of docs/method.md. Demonstrations are seeded from 5000 on, or `--first-seed`;
`--force-only` leaves out the tables of position alone.
"""

import argparse
from collections.abc import Callable
from concurrent.futures import Executor, ProcessPoolExecutor
from functools import partial

import numpy as np

import synthetic
from keyphase.segmentation import Parameters, segment

FIRST_SEED = 5000
LEVELS: tuple[synthetic.Level, ...] = ("easy", "real")


def main() -> None:
    """Print all tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--demonstrations", type=int, default=200)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED)
    parser.add_argument("--force-only", action="store_true")
    given = parser.parse_args()
    seeds = range(given.first_seed, given.first_seed + given.demonstrations)
    with ProcessPoolExecutor(given.processes) as pool:
        if not given.force_only:
            print_position_alone(pool, seeds)
        print_with_force(pool, seeds)


def print_position_alone(pool: Executor, seeds: range) -> None:
    """The table of Setup 1 by position alone."""
    print("| Setup 1, position alone | level | five segments | vs switch times | vs 5 % speed |")
    print("|---|---|---|---|---|")
    for name, parameters in position_variants().items():
        for level in LEVELS:
            outcomes = list(pool.map(partial(setup1_errors, parameters, level), seeds))
            cells = " | ".join(row(outcomes, kinds=2))
            print(f"| {name} | {level} | {cells} |", flush=True)


def print_with_force(pool: Executor, seeds: range) -> None:
    """The table of both set-ups by position and force together."""
    print("\n| with force | level | right number | all within 0.3 s | vs switch times |")
    print("|---|---|---|---|---|")
    for name, make in (("Setup 1", synthetic.setup1), ("Setup 2", synthetic.setup2)):
        for level in LEVELS:
            outcomes = list(pool.map(partial(force_errors, make, level), seeds))
            near = np.mean([bool(errors) and errors[0].max() < 0.3 for _, errors in outcomes])
            number, *errors = row(outcomes, kinds=1)
            cells = " | ".join([number, f"{near:.3f}", *errors])
            print(f"| {name} | {level} | {cells} |", flush=True)


def position_variants() -> dict[str, Parameters]:
    """What is compared."""
    return {
        "keyphase": Parameters(),
        "keyphase, weight crossing": Parameters(estimator="weight-crossing"),
        "scikit-learn, K = 5 given": Parameters(mixture="scikit-learn", gaussians=5),
        "scikit-learn, K by BIC": Parameters(mixture="scikit-learn"),
    }


def setup1_errors(
    parameters: Parameters, level: synthetic.Level, seed: int
) -> tuple[bool, list[np.ndarray]]:
    """Whether Setup 1 gave five segments, and boundary errors against both references [s]."""
    made = synthetic.setup1(seed, level)
    times = boundary_times(segment(made.demonstration, parameters))
    if len(times) != len(made.switches_s) or made.slow_s is None:
        return False, []
    return True, [np.abs(times - made.switches_s), np.abs(times - made.slow_s)]


def force_errors(
    make: Callable[..., synthetic.Synthetic], level: synthetic.Level, seed: int
) -> tuple[bool, list[np.ndarray]]:
    """Whether there are as many segments as there should be, and boundary errors [s]."""
    made = make(seed, level, forces=True)
    times = boundary_times(segment(made.demonstration))
    if len(times) != len(made.switches_s):
        return False, []
    return True, [np.abs(times - made.switches_s)]


def boundary_times(found) -> np.ndarray:
    """Times of all boundaries [s]."""
    return np.array([boundary.time_s for boundary in found.boundaries])


def row(outcomes: list[tuple[bool, list[np.ndarray]]], kinds: int) -> list[str]:
    """Success rate, then median and 90th percentile of each kind of error [ms]."""
    cells = [f"{np.mean([right for right, _ in outcomes]):.3f}"]
    all_errors = list(zip(*(errors for _, errors in outcomes if errors), strict=True))
    for errors in all_errors:
        milliseconds = 1e3 * np.concatenate(errors)
        cells.append(f"{np.median(milliseconds):.0f}, {np.percentile(milliseconds, 90):.0f} ms")
    return cells + ["–"] * (kinds - len(all_errors))


if __name__ == "__main__":
    main()
