"""Kill a server that is being edited, again and again, and count what was lost.

python tests/benchmarks/kill_server.py --times 200
"""

import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "web"))

from killing_server import Aftermath, kill_once, write_short_recording
from serving import Serving, many_servings


def main() -> int:
    """Kill as often as asked; the exit status says whether anything confirmed was lost."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1000)
    options = parser.parse_args()
    with many_servings() as serve:
        rounds = [_kill_in_a_new_folder(options.seed + i, serve) for i in range(options.times)]
    lost = [i for i, each in enumerate(rounds) if not each.is_safe]
    confirmed = sum(each.confirmed for each in rounds)
    beyond = sum(len(each.found) - each.confirmed for each in rounds)
    print(f"{len(rounds)} kills after {confirmed} confirmed edits")
    print(f"{beyond} more were whole on disk before they could be confirmed")
    print(f"{len(lost)} lost something confirmed" + (f": rounds {lost}" if lost else ""))
    return 1 if lost else 0


def _kill_in_a_new_folder(seed: int, serve: Serving) -> Aftermath:
    with tempfile.TemporaryDirectory() as folder:
        recording = write_short_recording(Path(folder) / "run.npz")
        return kill_once(recording, seed, serve)


if __name__ == "__main__":
    sys.exit(main())
