"""How near boundaries are to grasps and releases of a simulated gripper; parts that slip are told.

python tests/benchmarks/accuracy_gripper.py --count 100
"""

import argparse

import numpy as np

from keyphase import segment
from keyphase.simulation.making.simulated import make_simulated

WITHIN_S = 0.06
FAMILY = "simulated-pick-and-place"


def main() -> None:
    """Print how many of the events have a boundary of the gripper's near, and how near."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    apart: list[float] = []
    given = slips = 0
    for seed in range(asked.seed, asked.seed + asked.count):
        made = make_simulated(FAMILY, seed)
        boundaries = segment(made.demonstration).boundaries
        slips += sum(event.label == "slip" for event in made.gripped)
        for event in made.gripped:
            if event.label == "slip":
                continue
            times = [one.time_s for one in boundaries if one.gripper == event.label]
            nearest = min((abs(time - event.time_s) for time in times), default=np.inf)
            apart.append(nearest)
            if nearest > WITHIN_S:
                print(
                    f"seed {seed}: {event.label} at {event.time_s:.3f} s, nearest {nearest:.3f} s"
                )
        given += sum(bool(one.gripper) for one in boundaries)
    near = sum(each <= WITHIN_S for each in apart)
    print(f"{near} of {len(apart)} within {WITHIN_S * 1e3:.0f} ms; {given} given; {slips} slips")
    print(f"median {np.median(apart) * 1e3:.0f} ms, 98 % {np.quantile(apart, 0.98) * 1e3:.0f} ms")


if __name__ == "__main__":
    main()
