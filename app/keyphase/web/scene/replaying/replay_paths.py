"""The paths of a replay in the scene: what was demonstrated as ghost, and what was run so far.

What was run is one node for each skill, which grows: a scene of many small nodes is slow to draw.
"""

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.web.scene.palette import IDLE, Rgb, painted, segment_color
from keyphase.workbench.replaying.plan import PlannedSkill, ReplayPlan
from keyphase.workbench.replaying.plan_paths import path_of_skill

PIECE_M = 0.003
"""The path that was run grows by pieces of this length at least."""

_GHOST_M, _DONE_M, _NOW_M = 0.0018, 0.004, 0.006
_MAX_POINTS = 60


class ReplayPaths:
    """Paths of one replay, below `root`, so thick; not for several threads at once."""

    def __init__(
        self, client: viser.ClientHandle, root: str, plan: ReplayPlan, thickness: float = 1.0
    ) -> None:
        self._scene, self._root, self._plan = client.scene, root, plan
        self._thickness = thickness
        self._run_m: list[Array] = []
        self._run: viser.LineSegmentsHandle | None = None
        self._skill: int | None = None
        for number in range(len(plan.planned)):
            self._draw_ghost(number, now=False)

    def highlight(self, before: int | None, now: int | None) -> None:
        """Draw the skill that runs thicker and in its colour, and the one before no more so."""
        for number in (before, now):
            if number is not None:
                self._draw_ghost(number, now=number == now)

    def follow(self, tool_m: Array, skill: int | None) -> None:
        """The tool has come to `tool_m`, within a skill or after all of them."""
        if not self._run_m or skill != self._skill:
            # Another skill begins where the path of the one before ends.
            self._run_m, self._run = [*self._run_m[-1:], tool_m], None
            self._skill = skill
        elif float(np.linalg.norm(tool_m - self._run_m[-1])) < PIECE_M:
            return
        else:
            self._run_m.append(tool_m)
        if len(self._run_m) > 1:
            self._draw_run()

    def _draw_run(self) -> None:
        points = np.array(self._run_m, np.float32)
        pieces = np.stack([points[:-1], points[1:]], axis=1)
        if self._run is not None:
            self._run.points = pieces
            return
        skill = self._skill
        self._run = self._scene.add_line_segments(
            f"{self._root}/done/{'rest' if skill is None else skill}",
            pieces,
            np.array(IDLE if skill is None else _color(self._plan.planned[skill]), np.uint8),
            thickness=self._thickness * _DONE_M,
        )

    def _draw_ghost(self, number: int, *, now: bool) -> None:
        one = self._plan.planned[number]
        path = path_of_skill(self._plan, one.skill)
        points = path[np.unique(np.linspace(0, len(path) - 1, _MAX_POINTS).astype(int))]
        if float(np.linalg.norm(np.ptp(points, axis=0))) < 1e-4:
            return
        self._scene.add_line_segments(
            f"{self._root}/ghost/{number}",
            np.stack([points[:-1], points[1:]], axis=1).astype(np.float32),
            np.array(_color(one) if now else IDLE, np.uint8),
            thickness=self._thickness * (_NOW_M if now else _GHOST_M),
        )


def _color(one: PlannedSkill) -> Rgb:
    return painted(IDLE if one.color is None else segment_color(one.color, True))
