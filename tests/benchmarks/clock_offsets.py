"""Clock offsets proposed for real recordings whose force was made late by known times.

    python tests/benchmarks/clock_offsets.py      # reads KEYPHASE_REAL_DATA, or ../shared/…

Prints for each set how many are sure and how far they are off; exits with 1 where one that is
sure is further off than 0.06 s, or where there are no recordings.
"""

import os
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from keyphase.clock_offset import clock_offset
from keyphase.demonstration import Demonstration
from keyphase.readers import read

LATER_S = (0.0, 0.3, -0.4)
MOST_OFF_S = 0.06
BESIDE = Path(__file__).resolve().parents[3] / "shared" / "real_demonstrations"


def main() -> int:
    """Judge every recording with a force."""
    folder = Path(os.environ.get("KEYPHASE_REAL_DATA", BESIDE))
    off: dict[str, list[float]] = {}
    tried: dict[str, int] = {}
    for path in sorted(folder.glob("*/*.npz")):
        demonstration = read(path)
        if demonstration.force_N is None:
            continue
        for later_s in LATER_S:
            found = clock_offset(late(demonstration, later_s))
            tried[path.parent.name] = tried.get(path.parent.name, 0) + 1
            if found is not None and found.is_sure:
                off.setdefault(path.parent.name, []).append(found.offset_s + later_s)
    for name, count in tried.items():
        sure = np.abs(off.get(name, []))
        told = f", at most {sure.max():.3f} s off" if len(sure) else ""
        print(f"{name}: {len(sure)} of {count} sure{told}")
    worst = max((abs(one) for each in off.values() for one in each), default=0.0)
    return 0 if tried and worst <= MOST_OFF_S else 1


def late(demonstration: Demonstration, later_s: float) -> Demonstration:
    """The same with its force so much later; what is not known at the ends is held."""
    time, force = demonstration.time_s, demonstration.force_N
    assert force is not None
    moved = np.column_stack([np.interp(time - later_s, time, column) for column in force.T])
    return replace(demonstration, force_N=moved)


if __name__ == "__main__":
    sys.exit(main())
