"""Where the parts were while a demonstration was recorded in a workcell, worked out for display.

Recordings hold the robot, not the parts. The workcell is built again and its robot led along the
recording by a hand that pulls as the force sensor says it did; the parts move as physics has them.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation.disturbance import Disturbance
from keyphase.simulation.impedance import RATE_HZ, Gains, Reference
from keyphase.simulation.part_shapes import Shape
from keyphase.simulation.robot_scene import ARM_JOINTS
from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.registry import workcell

KEPT_HZ = 60.0
"""How often the parts' poses are kept."""


@dataclass(frozen=True, eq=False)
class PartsPath:
    """What the parts look like and where they were.

    time_s        (K,)
    position_m    (K, 3) of each part, base frame, by name
    orientation_wxyz (K, 4) likewise
    """

    shapes: tuple[Shape, ...]
    time_s: Array
    position_m: Mapping[str, Array]
    orientation_wxyz: Mapping[str, Array]

    def at(self, time_s: float) -> dict[str, tuple[Array, Array]]:
        """Position and orientation of each part at a time."""
        row = int(np.searchsorted(self.time_s, time_s).clip(0, len(self.time_s) - 1))
        return {
            name: (positions[row], self.orientation_wxyz[name][row])
            for name, positions in self.position_m.items()
        }


def parts_path(demonstration: Demonstration) -> PartsPath | None:
    """The parts along a demonstration; None where it was not recorded in a workcell of ours."""
    simulation = _workcell_of(demonstration)
    if simulation is None:
        return None
    kept = max(1, round(RATE_HZ / KEPT_HZ))
    time, poses = [], []
    for tick, (time_s, reference) in enumerate(_hand(demonstration)):
        simulation.step(reference)
        if tick % kept == 0:
            time.append(time_s)
            poses.append(simulation.part_poses())
    return PartsPath(
        simulation.shapes(),
        np.array(time),
        {name: np.array([pose[name][0] for pose in poses]) for name in poses[0]},
        {name: np.array([pose[name][1] for pose in poses]) for name in poses[0]},
    )


def _workcell_of(demonstration: Demonstration) -> Simulation | None:
    metadata: Mapping[str, Any] = demonstration.metadata
    channels = (demonstration.joints_rad, demonstration.force_N, demonstration.orientation_wxyz)
    if metadata.get("joint_names") != list(ARM_JOINTS) or any(one is None for one in channels):
        return None
    assert demonstration.joints_rad is not None
    try:
        disturbance = Disturbance(**metadata.get("disturbance", {}))
        cell = replace(
            workcell(str(metadata.get("workcell"))),
            start_joints_rad=tuple(demonstration.joints_rad[0].tolist()),
        )
        return cell.build(disturbance)
    except (SimulationError, TypeError):
        # Metadata are anyone's: what we cannot build is not drawn.
        return None


def _hand(demonstration: Demonstration) -> Iterator[tuple[float, Reference]]:
    """The hand at each tick of the controller.

    The tool was where it was recorded because the hand pulled as much as the parts pushed:
    x_hand = x - F / stiffness.
    """
    force, wxyz = demonstration.force_N, demonstration.orientation_wxyz
    assert force is not None
    assert wxyz is not None
    pulled = demonstration.position_m - force / Gains().stiffness_N_m
    ticks = np.arange(demonstration.start_s, demonstration.end_s, 1.0 / RATE_HZ)
    rows = [demonstration.index_at(time_s) for time_s in ticks.tolist()]
    velocity = np.gradient(demonstration.position_m[rows], 1.0 / RATE_HZ, axis=0)
    turns = Rotation.from_quat(wxyz[rows], scalar_first=True)
    turning = (turns[1:] * turns[:-1].inv()).as_rotvec() * RATE_HZ
    turning = np.concatenate([turning, turning[-1:]])
    for tick, row in enumerate(rows):
        yield (
            float(ticks[tick]),
            Reference(pulled[row], wxyz[row], velocity[tick], turning[tick]),
        )
