"""Random edits, slider moves, undo, redo and restarts, thousands of them.

python tests/benchmarks/random_edits.py --runs 200 --steps 100
"""

import argparse
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "labeling"))

from editing_machine import Editing
from hypothesis import HealthCheck, Phase, settings
from hypothesis.stateful import run_state_machine_as_test


def main() -> None:
    """Run; a failure is shrunk and printed as the steps that lead to it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--steps", type=int, default=100)
    options = parser.parse_args()
    taken = 0

    class Counted(Editing):
        def check_invariants(self, *arguments, **named):
            nonlocal taken
            taken += 1
            super().check_invariants(*arguments, **named)

    started = time.perf_counter()
    run_state_machine_as_test(
        Counted,
        settings=settings(
            max_examples=options.runs,
            stateful_step_count=options.steps,
            deadline=None,
            database=None,
            phases=[Phase.generate, Phase.shrink],
            suppress_health_check=list(HealthCheck),
        ),
    )
    print(f"{taken} steps in {options.runs} runs without failure, ", end="")
    print(f"{time.perf_counter() - started:.0f} s")


if __name__ == "__main__":
    main()
