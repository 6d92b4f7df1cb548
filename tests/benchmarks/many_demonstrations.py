"""A skill from ten recorded demonstrations beside each of the ten, in the same disturbed worlds.

python tests/benchmarks/many_demonstrations.py --worlds 40

Simulated operators do the same task; each recording is segmented with the default parameters. The
first ten that were cut into the phases most of them have are taken. What the softness is for is
shown first: how hard the tool pulls at a hand that holds it in free space.
"""

import argparse
import sys
from collections import Counter
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.labeling.label import label
from keyphase.labeling.labeling import LabeledSegment
from keyphase.segmentation import segment
from keyphase.simulation import record
from keyphase.simulation.replay.ranges import Range
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.replay.trials import Worlds, drawn_worlds, run_trials
from keyphase.simulation.simulated import Cell
from keyphase.simulation.workcells.registry import workcell
from keyphase.skills.library import skills_of
from keyphase.skills.many import mean_of, skills_of_mean
from keyphase.skills.skill import Skill

Plan = tuple[str, Demonstration, tuple[Skill, ...]]

# As in docs/replay.md, with everything disturbed.
WORLDS = Worlds(
    part_height_m=Range(-0.01, 0.01),
    part_offset_m=Range(-0.005, 0.005),
    part_turn_rad=Range(-np.radians(5.0), np.radians(5.0)),
    tilt_rad=Range(-np.radians(2.0), np.radians(2.0)),
    friction=Range(0.2, 0.6),
    mass=Range(0.5, 2.0),
    sensor_noise=Range(2.0, 2.0),
    sensor_bias_N=Range(1.0, 1.0),
    sensor_drift=Range(5.0, 5.0),
)


def kept_of(demonstration: Demonstration) -> tuple[LabeledSegment, ...]:
    """What a plan is made of, as the program finds it."""
    return tuple(one for one in label(segment(demonstration)).segments if one.kept)


def plans(task: str, count: int) -> list[Plan]:
    """The mean of all first, then each alone."""
    recorded = (record(task, seed=seed) for seed in range(3 * count))
    found = [(one, kept_of(one)) for one in recorded]
    usual = Counter(tuple(s.label for s in kept) for _, kept in found).most_common(1)[0][0]
    alike = [(one, kept) for one, kept in found if tuple(s.label for s in kept) == usual][:count]
    print(f"{task}: {len(alike)} recordings with the phases {', '.join(usual)}")
    mean = mean_of(alike)
    spread_mm = 1e3 * mean.spread_m
    print(f"their spread: median {np.median(spread_mm):.1f} mm, at most {spread_mm.max():.1f} mm")
    together = (f"the mean of {len(alike)}", mean.demonstration, skills_of_mean(mean, alike))
    return [together, *((one.name, one, skills_of(one, kept)) for one, kept in alike)]


def pull_of(cell: Cell, demonstration: Demonstration, skills: tuple[Skill, ...]) -> float:
    """How hard the tool pulls at a hand that holds it for 0.5 s in the first skill, at most [N]."""
    simulation = cell.build()
    replay, pulls = Replay(simulation, skills, demonstration), list[float]()
    while replay.step().fraction < 0.4:
        pass
    replay.hold(simulation.here())
    for _ in range(125):
        state = replay.step()
        off_m = state.reference.position_m - state.sample.position_m
        pulls.append(simulation.gains.stiffness_N_m * float(np.linalg.norm(off_m)))
    return max(pulls)


def main() -> int:
    """Compare; 0 where the mean succeeds in at least as many worlds as the best single one."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--task", default="setup1")
    parser.add_argument("--demonstrations", type=int, default=10)
    parser.add_argument("--worlds", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=-1)
    options = parser.parse_args()
    worlds = drawn_worlds(WORLDS, options.worlds, options.seed)
    cell, succeeded = workcell(options.task), list[int]()
    compared = plans(options.task, options.demonstrations)
    _, mean, soft = compared[0]
    stiff = tuple(replace(skill, spread=None) for skill in soft)
    pulls = (pull_of(cell, mean, each) for each in (soft, stiff))
    print("held, the tool pulls with {:.1f} N, {:.1f} N where nothing is soft".format(*pulls))
    for name, demonstration, skills in compared:
        trials = run_trials(cell, demonstration, skills, worlds, jobs=options.jobs)
        succeeded.append(trials.successes)
        print(f"{name}: {trials.successes} of {options.worlds}", flush=True)
    together, *alone = succeeded
    print(f"together {together}, the best alone {max(alone)}, the median {np.median(alone):g}")
    return 0 if together >= max(alone) else 1


if __name__ == "__main__":
    sys.exit(main())
