"""Where every link is, for the browser: joint values in, frames out."""

from collections.abc import Mapping

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.errors import RobotError
from keyphase.robot.description import RobotDescription


def link_frames(
    robot: RobotDescription,
    joints_rad: ArrayLike | None = None,
    others: Mapping[str, float] | None = None,
) -> dict[str, Array]:
    """Frame (4, 4) of every link in the root's frame, by name; copies.

    `joints_rad` (J,) moves the chain to the tool frame (by default its start posture), `others`
    any other joint by name; the rest stays at `robot.rest`. Joints that mimic others follow.

    Raises RobotError where a joint is unknown or the number of values is wrong.
    """
    values = {**robot.rest, **_chain_values(robot, joints_rad), **_known(robot, others or {})}
    for name, mimic in robot.mimics.items():
        values[name] = mimic.factor * values[mimic.joint] + mimic.offset
    # Data of our own on every call: the page asks from several threads.
    data = robot.model.createData()
    pinocchio.framesForwardKinematics(robot.model, data, configuration(robot.model, values))
    return {link: data.oMf[frame].homogeneous for link, frame in robot.frames.items()}


def configuration(model: pinocchio.Model, values: Mapping[str, float]) -> Array:
    """Pinocchio's configuration vector of joint values by name; joints not named stay neutral.

    Pinocchio orders sibling joints by name, and holds a continuous joint as cosine and sine.
    """
    q = pinocchio.neutral(model)
    for name, value in values.items():
        joint = model.joints[model.getJointId(name)]
        if joint.nq == 2:
            q[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
        else:
            q[joint.idx_q] = value
    return q


def _chain_values(robot: RobotDescription, joints_rad: ArrayLike | None) -> dict[str, float]:
    values = robot.start_rad if joints_rad is None else np.asarray(joints_rad, dtype=np.float64)
    if values.shape != robot.start_rad.shape:
        raise RobotError(
            f"{robot.name}: expected {len(robot.joint_names)} joint values "
            f"({', '.join(robot.joint_names)}), but the shape {values.shape} came."
        )
    return dict(zip(robot.joint_names, values.tolist(), strict=True))


def _known(robot: RobotDescription, others: Mapping[str, float]) -> Mapping[str, float]:
    for name in others:
        if name not in robot.rest and name not in robot.joint_names:
            raise RobotError(
                f"{robot.name}: expected a joint of this robot that moves by itself, but '{name}' "
                f"came; choose one of {', '.join((*robot.joint_names, *robot.rest))}."
            )
    return others
