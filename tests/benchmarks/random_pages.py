"""Two pages that act at random on five recordings, slow fits among it; checked by their journals.

python tests/benchmarks/random_pages.py --actions 2000 --seed 1
"""

import argparse
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "workbench"))

from two_pages import run_pages


def main() -> None:
    """Run; an assertion says which recording is not what its journal says."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--actions", type=int, default=1000, help="of each page")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    for round in range(options.rounds):
        started = time.perf_counter()
        with tempfile.TemporaryDirectory() as folder:
            count = run_pages(
                Path(folder), actions=options.actions, seed=options.seed + round, slow=0.01
            )
        print(
            f"{count} actions without failure, {time.perf_counter() - started:.0f} s, "
            f"{_resident_mb():.0f} MB resident, {threading.active_count()} threads"
        )


def _resident_mb() -> float:
    status = Path("/proc/self/status").read_text()
    return int(status.split("VmRSS:")[1].split()[0]) / 1024


if __name__ == "__main__":
    main()
