"""How a replay is seen: before a YuMi, or alone in the world made from its recording."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.simulation.simulation import Simulation
from keyphase.web.scene.figures.force_arrow import ArrowScale
from keyphase.web.scene.recording.path_geometry import MAX_ARROW, MIN_SIZE_M, path_of, radius_of
from keyphase.web.scene.recording.viewpoint import Viewpoint, viewpoint_of, viewpoint_with_robot
from keyphase.workbench.replaying.plan_paths import path_of_skill
from keyphase.workbench.replaying.running import Running

WITH_YUMI_M = 0.36
"""So much is seen where a YuMi runs."""

_GROUND_BELOW_M = 0.03
"""So far below the path the ground is where no robot stands on it."""

_MIN_FULL_FORCE_N = 1.0
"""A demonstration without force, or with hardly any, has arrows as if it had reached this."""


@dataclass(frozen=True, eq=False)
class SeenReplay:
    """Where it is looked at from, its ground, and how large things are drawn.

    ground_m  (3,) the middle of the ground
    size_m    how large what is seen is
    base      where the robot stands that runs; None where none does
    """

    view: Viewpoint
    ground_m: Array
    size_m: float
    base: Placement | None

    @property
    def thickness(self) -> float:
        """How thick paths are drawn, as a share of beside a YuMi."""
        return min(1.0, self.size_m / WITH_YUMI_M)


def seen_replay(running: Running) -> SeenReplay:
    """Without a robot it is seen as its recording is."""
    plan = running.plan
    path_m = np.concatenate([path_of_skill(plan, one.skill) for one in plan.planned])
    x, y, z = 0.5 * (path_m.min(axis=0) + path_m.max(axis=0))
    if _has_yumi(running):
        base, middle = Placement(), np.array([x, y, z])
        view = viewpoint_with_robot(middle, WITH_YUMI_M, base)
        return SeenReplay(view, np.array([x, y, 0.0]), WITH_YUMI_M, base)
    whole = path_of(plan.demonstration)
    ground = np.array([x, y, float(path_m[:, 2].min()) - _GROUND_BELOW_M])
    return SeenReplay(viewpoint_of(whole), ground, whole.size_m, None)


def arrow_scale(running: Running) -> ArrowScale:
    """How the measured force is drawn: without a robot, the largest as in its recording."""
    if _has_yumi(running):
        return ArrowScale()
    demonstration = running.plan.demonstration
    size_m = max(float(np.linalg.norm(np.ptp(demonstration.position_m, axis=0))), MIN_SIZE_M)
    force = demonstration.force_N
    top_N = 0.0 if force is None else float(np.linalg.norm(force, axis=1).max())
    return ArrowScale(
        beside_m=(0.0, 0.0, 0.0),
        metres_per_N=MAX_ARROW * size_m / max(top_N, _MIN_FULL_FORCE_N),
        radius_m=0.7 * radius_of(size_m),
    )


def _has_yumi(running: Running) -> bool:
    return isinstance(running.run.replay.simulation, Simulation)
