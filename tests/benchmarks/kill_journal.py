"""Kill a program that edits a journal, again and again, and count what was lost.

python tests/benchmarks/kill_journal.py --times 200
"""

import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "labeling"))

from handmade import demonstration
from killing import kill_once


def main() -> int:
    """Kill as often as asked; the exit status says whether anything confirmed was lost."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1000)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        recording = Path(folder) / "demo.npz"
        demonstration(path=recording)
        rounds = [kill_once(recording, options.seed + i) for i in range(options.times)]
    lost = [i for i, each in enumerate(rounds) if not each.is_safe]
    under_way = sum(each.next is not None for each in rounds)
    written = sum(each.found == each.next for each in rounds)
    print(f"{len(rounds)} kills after {sum(each.saves for each in rounds)} confirmed saves")
    print(f"{under_way} of them during a save, {written} of those saves were whole on disk")
    print(f"{len(lost)} lost something confirmed" + (f": rounds {lost}" if lost else ""))
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main())
