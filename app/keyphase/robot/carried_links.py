"""Where links are as seen from the links that carry them: most of them only turn there."""

from collections.abc import Mapping, Sequence

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.robot.description import RobotDescription
from keyphase.robot.link_frames import configuration

_W_FIRST = [0, 1, 2, 6, 3, 4, 5]
"""Pinocchio's quaternions are x y z w."""


class CarriedLinks:
    """The links named in `carriers`, each with the link that carries it ("" for the root).

    Made for one posture after another: what does not depend on the posture is worked out once.
    Not for several threads at once.
    """

    def __init__(self, robot: RobotDescription, carriers: Mapping[str, str]) -> None:
        self._model, self._data = robot.model, robot.model.createData()
        frames = [
            (robot.frames[link], robot.frames[carrier] if carrier else None)
            for link, carrier in carriers.items()
        ]
        values = {**robot.rest, **dict.fromkeys(robot.joint_names, 0.0)}
        for name, mimic in robot.mimics.items():
            values[name] = mimic.factor * values[mimic.joint] + mimic.offset
        self._rest = configuration(robot.model, values)
        self._driven = _Driven(robot)
        self._resting = self._carried(self._rest, frames)
        self._moving = [row for row, pair in enumerate(frames) if self._moves(*pair)]
        self._frames = [frames[row] for row in self._moving]

    def poses(self, joints_rad: Array) -> Array:
        """(L, 7) position and wxyz of each link in its carrier's frame, in the order given.

        `joints_rad` (J,) moves the chain to the tool frame; every other joint is at its rest.
        """
        poses = self._resting.copy()
        q = self._driven.put(self._rest.copy(), joints_rad)
        poses[self._moving] = self._carried(q, self._frames)
        return poses

    def _carried(self, q: Array, frames: Sequence[tuple[int, int | None]]) -> Array:
        """Poses of frames in the frames that carry them, in a configuration."""
        pinocchio.framesForwardKinematics(self._model, self._data, q)
        placed = self._data.oMf
        seen = [
            placed[link] if carrier is None else placed[carrier].actInv(placed[link])
            for link, carrier in frames
        ]
        return np.reshape([pinocchio.SE3ToXYZQUAT(pose) for pose in seen], (-1, 7))[:, _W_FIRST]

    def _moves(self, link: int, carrier: int | None) -> bool:
        """Whether a driven joint lies between a link and the one that carries it."""
        before = set() if carrier is None else set(self._joints_to(carrier))
        return not self._driven.joints.isdisjoint(set(self._joints_to(link)) - before)

    def _joints_to(self, frame: int) -> Sequence[int]:
        return self._model.supports[self._model.frames[frame].parentJoint].tolist()


class _Driven:
    """Which entries of Pinocchio's configuration follow the joints of the chain, and how."""

    def __init__(self, robot: RobotDescription) -> None:
        chain = {name: k for k, name in enumerate(robot.joint_names)}
        follow = [(name, k, 1.0, 0.0) for name, k in chain.items()]
        follow += [
            (name, chain[mimic.joint], mimic.factor, mimic.offset)
            for name, mimic in robot.mimics.items()
            if mimic.joint in chain
        ]
        numbers = [robot.model.getJointId(name) for name, *_ in follow]
        self.joints = frozenset(numbers)
        joints = [robot.model.joints[number] for number in numbers]
        self._source = np.array([k for _, k, _, _ in follow])
        self._factor = np.array([factor for *_, factor, _ in follow])
        self._offset = np.array([offset for *_, offset in follow])
        self._at = np.array([joint.idx_q for joint in joints])
        self._turns: NDArray[np.bool_] = np.array([joint.nq == 2 for joint in joints])

    def put(self, q: Array, joints_rad: Array) -> Array:
        """The configuration with these joints; a continuous joint is held as cosine and sine."""
        values = self._factor * joints_rad[self._source] + self._offset
        plain, turning = ~self._turns, self._turns
        q[self._at[plain]] = values[plain]
        q[self._at[turning]] = np.cos(values[turning])
        q[self._at[turning] + 1] = np.sin(values[turning])
        return q
