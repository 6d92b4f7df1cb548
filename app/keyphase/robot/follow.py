"""An arm that follows a whole demonstration, continuously, and says where it cannot."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import ArrayLike

from keyphase.demonstration import Array, Demonstration
from keyphase.robot.arm import Arm
from keyphase.robot.inverse import (
    ANGLE_TOLERANCE_RAD,
    ARM_LENGTH_M,
    POSITION_TOLERANCE_M,
    Solution,
    nearest,
    starts,
)
from keyphase.robot.pose import TOOL_DOWN_WXYZ, Placement, matrices

POSTURE_LENGTH_M = 0.3
"""Way of the tool over which the posture is drawn back to the start posture by 63 %."""

SMALL_STEP_RAD = 0.02
"""A step a joint may always make: the noise of a recording is not taken for fast motion."""

SAME_STRETCH_S = 0.1
"""Samples the arm could not follow that are no further apart than this are reported together."""

PREVIEW_HZ = 20.0
"""Rate at which ways to start are compared before the best is followed in full."""

PREVIEWS = 8
"""How many ways to start are compared at most."""

MAX_PREVIEWED = 2000
"""So many poses of the path decide between ways to start."""

MAX_FOLLOWED = 20_000
"""So many poses are followed of any demonstration; `posture_at` finds what lies between."""

_POSES_PER_PROGRESS = 20

Progress = Callable[[float], None]


@dataclass(frozen=True)
class Unreached:
    """A stretch the arm could not follow, and how far from it the tool was at worst."""

    start_s: float
    end_s: float
    distance_m: float
    angle_rad: float


@dataclass(frozen=True, eq=False)
class JointPath:
    """The joints of an arm over a demonstration.

    time_s      (N,)   the demonstration's, or of a long one evenly some
    joints_rad  (N, J) within limits, continuous: no step is faster than the joints can move
    distance_m  (N,)   from the tool point to the recorded position
    angle_rad   (N,)   between the tool's and the recorded orientation
    """

    time_s: Array
    joints_rad: Array
    distance_m: Array
    angle_rad: Array

    @cached_property
    def reached(self) -> np.ndarray:
        """(N,) whether the tool is where the demonstration was, to 2 micrometres."""
        near = self.distance_m <= POSITION_TOLERANCE_M
        return near & (self.angle_rad <= ANGLE_TOLERANCE_RAD)

    @cached_property
    def unreached(self) -> tuple[Unreached, ...]:
        """The stretches that were not reached, in order; those less than 0.1 s apart as one."""
        missed = np.flatnonzero(~self.reached)
        apart = max(SAME_STRETCH_S, 1.5 * float(np.median(np.diff(self.time_s))))
        breaks = np.flatnonzero(np.diff(self.time_s[missed]) > apart) + 1
        return tuple(self._stretch(rows) for rows in np.split(missed, breaks) if len(rows))

    def _stretch(self, rows: np.ndarray) -> Unreached:
        return Unreached(
            float(self.time_s[rows[0]]),
            float(self.time_s[rows[-1]]),
            float(self.distance_m[rows].max()),
            float(self.angle_rad[rows].max()),
        )


def follow(
    arm: Arm,
    demonstration: Demonstration,
    placement: Placement | None = None,
    start_rad: ArrayLike | None = None,
    progress: Progress | None = None,
    seed: int = 0,
) -> JointPath:
    """Joints that move the tool frame along the placed demonstration.

    Of several postures to start from (`start_rad`, by default that of recorded joints if they are
    as many as the arm's; the arm's own; random ones of `seed`) the first is taken from which all
    of the path is reached, or else the one that reaches most. A demonstration without orientation
    is followed with the tool pointing down. `progress` hears the share that is done, none while
    starts are compared; what it raises ends it all. Of a demonstration of more than MAX_FOLLOWED
    samples so many at most are followed.
    """
    if start_rad is None:
        start_rad = _recorded_start(arm, demonstration)
    every = -(-len(demonstration) // MAX_FOLLOWED)
    rows = np.arange(0, len(demonstration), every)
    poses = (placement or Placement()).apply(tool_poses(demonstration, rows))
    goals = [pinocchio.SE3(pose) for pose in poses]
    time = demonstration.time_s[rows]
    stride = max(1, round(demonstration.rate_hz / PREVIEW_HZ / every))
    stride = max(stride, -(-len(goals) // MAX_PREVIEWED))
    start = _best_start(arm, goals[::stride], time[::stride], start_rad, seed, progress)
    return _followed(arm, goals, time, start, progress)


def posture_at(
    arm: Arm,
    demonstration: Demonstration,
    path: JointPath,
    time_s: float,
    placement: Placement | None = None,
) -> tuple[Array, bool]:
    """Joints (J,) for the sample at a time, and whether they reach it.

    Where `path` has no joints for that sample they are found from those around it.
    """
    row = demonstration.index_at(time_s)
    if len(path.time_s) == len(demonstration):
        return path.joints_rad[row], bool(path.reached[row])
    between = [np.interp(demonstration.time_s[row], path.time_s, q) for q in path.joints_rad.T]
    pose = (placement or Placement()).apply(tool_poses(demonstration, np.array([row])))[0]
    lower, upper, data = arm.robot.lower_rad, arm.robot.upper_rad, arm.model.createData()
    found = nearest(arm, pinocchio.SE3(pose), np.array(between), lower, upper, data)
    return found.joints_rad, found.reached


def tool_poses(demonstration: Demonstration, rows: np.ndarray | None = None) -> Array:
    """Recorded poses (N, 4, 4), of all or of some samples; pointing down where no orientation
    was recorded."""
    position, orientation = demonstration.position_m, demonstration.orientation_wxyz
    if rows is not None:
        position = position[rows]
        orientation = None if orientation is None else orientation[rows]
    if orientation is None:
        orientation = np.tile(TOOL_DOWN_WXYZ, (len(position), 1))
    return matrices(position, orientation)


def _recorded_start(arm: Arm, demonstration: Demonstration) -> Array | None:
    joints = demonstration.joints_rad
    if joints is None or joints.shape[1] != len(arm.robot.joint_names):
        return None
    return joints[0]


def _best_start(
    arm: Arm,
    goals: list[pinocchio.SE3],
    time: Array,
    start_rad: ArrayLike | None,
    seed: int,
    progress: Progress | None,
) -> Array:
    def none_of_it(_: float) -> None:
        if progress is not None:
            progress(0.0)

    best, fewest = arm.robot.start_rad, np.inf
    for start in _first_postures(arm, goals[0], start_rad, seed):
        path = _followed(arm, goals, time, start, none_of_it)
        missed = float(np.sum(~path.reached)) + float(path.distance_m.sum())
        if path.reached.all():
            return start
        if missed < fewest:
            best, fewest = start, missed
    return best


def _first_postures(
    arm: Arm, goal: pinocchio.SE3, start_rad: ArrayLike | None, seed: int
) -> list[Array]:
    """Different postures for the first pose: those that reach it, or the nearest."""
    data = arm.model.createData()
    lower, upper = arm.robot.lower_rad, arm.robot.upper_rad
    found: list[Solution] = []
    for start in starts(arm, start_rad, seed):
        solution = nearest(arm, goal, start, lower, upper, data)
        if all(np.ptp(solution.joints_rad - other.joints_rad) > 0.2 for other in found):
            found.append(solution)
        if sum(solution.reached for solution in found) == PREVIEWS:
            break
    found.sort(key=lambda solution: 0.0 if solution.reached else solution.error)
    return [solution.joints_rad for solution in found[:PREVIEWS]]


def _followed(
    arm: Arm,
    goals: list[pinocchio.SE3],
    time: Array,
    start: Array,
    progress: Progress | None = None,
) -> JointPath:
    data = arm.model.createData()
    robot = arm.robot
    solution = nearest(arm, goals[0], start, robot.lower_rad, robot.upper_rad, data)
    solutions = [solution]
    for number, (before, goal) in enumerate(pairwise(goals), start=1):
        joints = solution.joints_rad
        seconds = time[number] - time[number - 1]
        reach = np.maximum(robot.speed_rad_s * seconds, SMALL_STEP_RAD)
        lower = np.maximum(robot.lower_rad, joints - reach)
        upper = np.minimum(robot.upper_rad, joints + reach)
        drawn = joints + _towards_start_posture(arm, joints, before, goal, data)
        solution = nearest(arm, goal, drawn, lower, upper, data)
        solutions.append(solution)
        if progress is not None and number % _POSES_PER_PROGRESS == 0:
            progress(number / len(goals))
    if progress is not None:
        progress(1.0)
    return JointPath(
        time,
        np.stack([solution.joints_rad for solution in solutions]),
        np.array([solution.distance_m for solution in solutions]),
        np.array([solution.angle_rad for solution in solutions]),
    )


def _towards_start_posture(
    arm: Arm, joints: Array, before: pinocchio.SE3, goal: pinocchio.SE3, data: pinocchio.Data
) -> Array:
    """A motion of the joints that leaves the tool where it is, as far as the tool moves."""
    way = np.linalg.norm(goal.translation - before.translation)
    way += ARM_LENGTH_M * np.linalg.norm(pinocchio.log3(before.rotation.T @ goal.rotation))
    pull = -np.expm1(-way / POSTURE_LENGTH_M) * (arm.robot.start_rad - joints)
    _, jacobian = arm.pose_and_jacobian(joints, data)
    spread = jacobian @ jacobian.T
    spread.flat[::7] += 1e-8
    return pull - jacobian.T @ np.linalg.solve(spread, jacobian @ pull)
