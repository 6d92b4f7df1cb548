"""The plan beside pose-only ends and one single skill, all in the same disturbed worlds.

    python tests/benchmarks/disturbed_worlds.py setup1 setup2 [--worlds 40] [--seed 1] [--plans …]

Everything is disturbed at once: height by 10 mm, place by 5 mm, turn by 5°, tilt by 2°, friction
0.2 to 0.6, mass half to double, the sensor's bias, drift and noise. Prints how many worlds succeed,
and how often what failed: the checks that did not hold, and how the last skill ended.
"""

import argparse
from collections import Counter

from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.readers import read
from keyphase.segmentation import Segmenter
from keyphase.simulation.choosing import cell_for, met_by
from keyphase.simulation.replay.margin_plans import margin_plans
from keyphase.simulation.replay.ranges import range_of
from keyphase.simulation.replay.trials import Trial, Worlds, drawn_worlds, run_trials

EVERYTHING = Worlds(
    part_height_m=range_of("10mm", "height", symmetric=True),
    part_offset_m=range_of("5mm", "offset", symmetric=True),
    part_turn_rad=range_of("5deg", "turn", symmetric=True),
    tilt_rad=range_of("2deg", "tilt", symmetric=True),
    friction=range_of("0.2..0.6", "friction"),
    mass=range_of("0.5..2", "mass"),
    sensor_bias_N=range_of("1", "bias"),
    sensor_drift=range_of("5", "drift"),
    sensor_noise=range_of("2", "noise"),
)


def failure(trial: Trial) -> str:
    """What failed in one world."""
    if trial.error is not None:
        return trial.error
    missing = ", ".join(name for name, holds in trial.checks if not holds)
    return f"skill {len(trial.outcomes)} {trial.outcomes[-1]}; not {missing}"


def main() -> None:
    """Print a line for each plan, and below it what failed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("workcells", nargs="+")
    parser.add_argument("--worlds", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--plans", nargs="*", default=[])
    asked = parser.parse_args()
    for name in asked.workcells:
        demonstration = read(shipped("data") / f"{name}.npz")
        cell = cell_for(demonstration, name)
        met = met_by(demonstration, cell)
        segmenter = Segmenter(met)
        labeling = label(segmenter.segment(), {}, segmenter.segment_between)
        plans = margin_plans(met, [labeling.segments[entry.segment] for entry in labeling.plan])
        worlds = drawn_worlds(EVERYTHING, asked.worlds, asked.seed)
        for plan, skills in plans.items():
            if asked.plans and plan not in asked.plans:
                continue
            trials = run_trials(cell, met, skills, worlds, jobs=1)
            peak = max(trials.peak_forces())
            print(f"{name}, {plan}: {trials.successes} of {asked.worlds}, at most {peak:.1f} N")
            failed = [(place, t) for place, t in enumerate(trials.trials) if not t.succeeded]
            for what, count in Counter(failure(trial) for _, trial in failed).most_common():
                where = [place for place, trial in failed if failure(trial) == what]
                print(f"  {count} times {what}: worlds {where}", flush=True)


if __name__ == "__main__":
    main()
