"""For how many seeds of each workcell the default parameters are right, contacts within 60 ms.

python tests/benchmarks/accuracy_recording.py --seeds 100
"""

import argparse
import sys
from pathlib import Path

from joblib import Parallel, delayed

sys.path.insert(0, str(Path(__file__).parents[1] / "simulation"))

from right_segments import PHASES, segmented_right

MIN_SHARE = 0.95


def main() -> int:
    """Count; the exit status says whether at least 95 of a hundred are right."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=100)
    seeds = range(max(parser.parse_args().seeds, 1))
    shares = []
    for name in PHASES:
        right = Parallel(n_jobs=-1)(delayed(segmented_right)(name, seed) for seed in seeds)
        wrong = [seed for seed, good in zip(seeds, right, strict=True) if not good]
        shares.append(1.0 - len(wrong) / len(seeds))
        print(f"{name}: {len(seeds) - len(wrong)} of {len(seeds)} right; wrong seeds: {wrong}")
    return 0 if min(shares) >= MIN_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
