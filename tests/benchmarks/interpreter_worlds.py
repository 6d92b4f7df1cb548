"""The example interpreter and Replay in the same disturbed worlds of both set-ups.

    PYTHONPATH=tests/simulation python tests/benchmarks/interpreter_worlds.py [--worlds 50]

prints how often outcomes of all skills and the workcell's checks were the same.
"""

import argparse
from pathlib import Path
from tempfile import TemporaryDirectory

from file_alone import both
from replaying import NAMES, bundled, plan

from keyphase.simulation import workcell
from keyphase.simulation.replay.ranges import range_of
from keyphase.simulation.replay.trials import Worlds, drawn_worlds
from keyphase.skills.library import skills_of


def main() -> None:
    """Print a line for each world that differs, then the sums."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--worlds", type=int, default=50)
    count = parser.parse_args().worlds
    worlds = Worlds(
        part_height_m=range_of("10mm", "height", symmetric=True),
        part_offset_m=range_of("5mm", "offset", symmetric=True),
        friction=range_of("0.2..0.6", "friction"),
        sensor_noise=range_of("2", "noise"),
    )
    for name in NAMES:
        demonstration = bundled(name)[0]
        skills = skills_of(demonstration, plan(name))
        same = succeeded = 0
        with TemporaryDirectory() as folder:
            for world in drawn_worlds(worlds, count, seed=1):
                replayed, alone = both(
                    workcell(name),
                    skills,
                    demonstration,
                    world.disturbance,
                    Path(folder),
                    world.seed,
                )
                same += replayed == alone
                succeeded += all(replayed[1].values())
                if replayed != alone:
                    print(name, world, replayed, alone)
        print(f"{name}: {same} of {count} worlds alike, {succeeded} of them done", flush=True)


if __name__ == "__main__":
    main()
