"""What the other methods are given: the same recording at an even rate, every channel to scale."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration

RATE_HZ = 25.0
TURN_M_PER_RAD = 0.2


@dataclass(frozen=True)
class Samples:
    """Block means at a rate, at most the recording's own: time (N,), pose (N, 3 or 6), wrench
    (N, 3 or 6) or None, speed (N,) in m/s with turning counted by 0.2 m/rad."""

    time_s: np.ndarray
    pose: np.ndarray
    wrench: np.ndarray | None
    speed_m_s: np.ndarray

    def features(self, wrench_alone: bool) -> np.ndarray:
        """(N, d) for detectors of changes of level: velocity of the pose and wrench, each channel
        by its own spread; the wrench alone where only contact is labelled."""
        if wrench_alone and self.wrench is not None:
            return _scaled(self.wrench)
        velocity = np.gradient(self.pose, axis=0)
        parts = [velocity] if self.wrench is None else [velocity, self.wrench]
        return np.hstack([_scaled(part) for part in parts])


def samples(demonstration: Demonstration, rate_hz: float = RATE_HZ) -> Samples:
    """The samples of a demonstration."""
    step = max(1.0 / rate_hz, 1.0 / demonstration.rate_hz)
    edges = np.arange(demonstration.start_s, demonstration.end_s, step)
    which = np.searchsorted(edges, demonstration.time_s, side="right") - 1
    pose = [demonstration.position_m]
    if demonstration.orientation_wxyz is not None:
        turned = Rotation.from_quat(demonstration.orientation_wxyz, scalar_first=True)
        pose.append(TURN_M_PER_RAD * (turned[0].inv() * turned).as_rotvec())
    parts = [demonstration.force_N, demonstration.torque_Nm]
    wrench = [part for part in parts if part is not None]
    mean_pose = _block_means(np.hstack(pose), which, len(edges))
    speed = np.linalg.norm(np.gradient(mean_pose, step, axis=0), axis=1)
    return Samples(
        edges + 0.5 * step,
        mean_pose,
        _block_means(np.hstack(wrench), which, len(edges)) if wrench else None,
        speed,
    )


def _block_means(values: np.ndarray, which: np.ndarray, blocks: int) -> np.ndarray:
    count = np.bincount(which, minlength=blocks)[:, None]
    total = np.stack([np.bincount(which, column, blocks) for column in values.T], axis=1)
    filled = np.flatnonzero(count[:, 0])
    means = total[filled] / count[filled]
    at = np.arange(blocks)
    return np.stack([np.interp(at, filled, column) for column in means.T], axis=1)


def _scaled(values: np.ndarray) -> np.ndarray:
    spread = values.std(axis=0)
    return (values - values.mean(axis=0)) / np.where(spread > 0.0, spread, 1.0)
