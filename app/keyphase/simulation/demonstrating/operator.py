"""A scripted operator: looks at the workcell, then leads the tool through the task by hand."""

from collections.abc import Callable

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError
from keyphase.simulation.demonstrating.hand_path import Habits, HandPath, X, Y, Z, minimum_jerk
from keyphase.simulation.impedance import RATE_HZ, Reference
from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.parts import HOUSING_M, TOOL_TO_MATING_FACE_M


def hand_path(simulation: Simulation, start: Reference, random: np.random.Generator) -> HandPath:
    """The path of one demonstration of the simulated workcell's task, from the pose `start`.

    The operator sees where the parts are, a little wrong. Raises SimulationError for a workcell
    nobody has shown the operator.
    """
    name = simulation.workcell.name
    if name not in _TASKS:
        raise SimulationError(
            f"The scripted operator knows {', '.join(_TASKS)}, but not the workcell '{name}'."
        )
    path = HandPath(start, Habits.drawn(random), random)
    _TASKS[name](path, simulation, random)
    return path


def _setup1(path: HandPath, simulation: Simulation, random: np.random.Generator) -> None:
    from keyphase.simulation.workcells.rim import OUTER_M
    from keyphase.simulation.workcells.setup1 import WALL_FACE_Y_M

    mating = _mating_pose(simulation)
    seen = random.normal(size=3) * 0.5e-3 * (X + Y)
    above = mating + seen + random.uniform(0.075, 0.095) * Z
    path.stroke("forward", above, random.uniform(1.4, 2.0))
    path.pause("idle", random.uniform(0.6, 1.2))
    pressed = random.uniform(2.4e-3, 3.2e-3)
    path.stroke("down until contact", mating + seen - pressed * Z, random.uniform(1.3, 1.9))
    eased = random.uniform(0.45, 0.6) * pressed
    path.pause("idle", random.uniform(0.7, 1.2), eased * Z)
    gap = WALL_FACE_Y_M - OUTER_M / 2 - simulation.part_poses()["housing"][0][1]
    beyond = path.here_m + (gap + random.uniform(4e-3, 6e-3)) * Y
    path.stroke("sideways until contact", beyond, random.uniform(1.8, 2.6), on_table=True)


def _setup2(path: HandPath, simulation: Simulation, random: np.random.Generator) -> None:
    from keyphase.simulation.workcells.setup2 import GAP_M, HOUSING_POSITION_M, START_TURN_RAD

    mating = _mating_pose(simulation)
    path.turn("rotate", -START_TURN_RAD * Z, random.uniform(1.2, 1.8))
    seen = random.normal(size=3) * 0.5e-3
    pressed = random.uniform(1.6e-3, 2.4e-3)
    goal = mating + seen * (X + Y) - pressed * Z
    path.stroke(
        "down until contact", goal, random.uniform(1.4, 1.9), overlap_s=random.uniform(0.1, 0.2)
    )
    gap = HOUSING_POSITION_M[1] + GAP_M - simulation.part_poses()["housing"][0][1]
    speeds, met = _pushing_speeds(gap, random)
    path.push("sideways until contact", Y, speeds[:met], random.uniform(0.25, 0.35))
    path.push("on with contact kept", Y, speeds[met:])


def _pushing_speeds(gap_m: float, random: np.random.Generator) -> tuple[Array, int]:
    """Speed per tick of a push that meets resistance after `gap_m`, and the tick where it does.

    The hand gets up to speed, is slowed by what it meets, and brakes to rest.
    """
    fast = random.uniform(0.045, 0.065)
    slow = fast * random.uniform(0.4, 0.6)
    start_s, slow_s, brake_s = random.uniform(0.45, 0.7), 0.12, random.uniform(0.4, 0.6)
    # A smooth start covers half of what full speed would.
    cruise_s = (gap_m - fast * start_s / 2) / fast
    on_s = random.uniform(0.035, 0.045) / slow - brake_s / 2
    time = np.arange(1, round((start_s + cruise_s + on_s + brake_s) * RATE_HZ) + 1) / RATE_HZ
    met_s = start_s + cruise_s
    rise = minimum_jerk(time / start_s) * fast
    slowed = (fast - slow) * minimum_jerk((time - met_s) / slow_s)
    brake = 1.0 - minimum_jerk((time - met_s - on_s) / brake_s)
    return (rise - slowed) * brake, round(met_s * RATE_HZ)


def _mating_pose(simulation: Simulation) -> Array:
    """Tool point at which the held part sits on the housing."""
    return simulation.part_poses()["housing"][0] + (HOUSING_M[2] + TOOL_TO_MATING_FACE_M) * Z


_TASKS: dict[str, Callable[[HandPath, Simulation, np.random.Generator], None]] = {
    "setup1": _setup1,
    "setup2": _setup2,
}
