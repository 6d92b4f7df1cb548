# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""What a simulation's samples become: a demonstration, with the simulator's ground truth beside."""

from collections.abc import Mapping, Sequence
from typing import Any

import mujoco
import numpy as np

from keyphase import __version__
from keyphase.demonstration import Demonstration
from keyphase.simulation.simulated import Simulated
from keyphase.simulation.simulation import Sample

ONSET_FORCE_N = 0.2
"""Normal force from which two parts count as touching, in the simulator's own view."""


def as_demonstration(
    samples: Sequence[Sample], name: str, metadata: Mapping[str, Any]
) -> Demonstration:
    """The samples of one recording, time counted from its first one.

    A world without a robot knows neither joints nor torques, one without a gripper no opening.
    """

    def column(channel: str) -> np.ndarray:
        return np.array([getattr(sample, channel) for sample in samples])

    time, has_robot = column("time_s"), bool(samples[0].joints_rad.size)
    return Demonstration(
        name=name,
        # Rounded to whole nanoseconds, so that equal steps are written equal.
        time_s=np.round(time - time[0], 9),
        position_m=column("position_m"),
        orientation_wxyz=column("orientation_wxyz"),
        force_N=column("force_N"),
        torque_Nm=column("torque_Nm") if has_robot else None,
        joints_rad=column("joints_rad") if has_robot else None,
        gripper=None if samples[0].gripper is None else column("gripper"),
        metadata=metadata,
    )


def provenance(world: Simulated, operator: str) -> dict[str, Any]:
    """Where a recording comes from, as metadata: program, simulator, operator, workcell."""
    return {
        "recorder": f"keyphase {__version__}",
        "simulator": f"MuJoCo {mujoco.__version__}",
        "operator": operator,
        "workcell": world.workcell.name,
        "disturbance": world.disturbance.as_json(),
        "joint_names": list(world.joint_names),
        "contact_names": list(world.contact_names),
        "contact_changes": list(world.workcell.onsets),
    }


def ground_truth(samples: Sequence[Sample], origin: Mapping[str, Any]) -> dict[str, Any]:
    """When the simulator saw parts touch for the first time, from the recording's start.

    `origin` is the recording's provenance. `contact_changes_s` lists those that are contact
    changes of the task, in the order of the workcell, as far as they happened.
    """
    touching = np.array([sample.contact_N for sample in samples]) > ONSET_FORCE_N
    start_s = samples[0].time_s
    onsets = {
        name: round(samples[int(np.argmax(touching[:, index]))].time_s - start_s, 9)
        for index, name in enumerate(origin["contact_names"])
        if touching[:, index].any()
    }
    changes = [onsets[name] for name in origin["contact_changes"] if name in onsets]
    return {"contact_onsets_s": onsets, "contact_changes_s": changes}
