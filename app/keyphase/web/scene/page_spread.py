"""How far the finished demonstrations of the task lie apart, as a sleeve around their mean."""

import numpy as np
import trimesh
import viser

from keyphase.errors import KeyphaseError
from keyphase.web.scene.page_robot import Later
from keyphase.web.scene.palette import painted, segment_color
from keyphase.web.scene.shared import Shared
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.showing.task_spread import TaskSpread, task_spread
from keyphase.workbench.view import View

PART = "spread"
BALLS = f"/{PART}/balls"
OPACITY = 0.22
LEAST_M = 0.0005
"""Demonstrations that agree are drawn so thick."""


class PageSpread:
    """The sleeve in one page's scene, while it is wanted.

    It is worked out in a thread that all pages share; all else runs in the thread that draws this
    page's scene.
    """

    def __init__(
        self, client: viser.ClientHandle, shared: Shared, view: View, later: Later
    ) -> None:
        self._client, self._shared, self._view, self._later = client, shared, view, later
        self._wanted = False
        self._shown: DeskState | None = None
        self._drawn: tuple[object, ...] = ()

    def show_document(self, shown: DeskState) -> None:
        """Another recording, or other segments of it."""
        self._shown = shown
        self._ask()

    def show_parts(self, hidden: frozenset[str]) -> None:
        """A person wants to see it, or no longer."""
        wanted, self._wanted = PART not in hidden, PART not in hidden
        if wanted and not self._drawn:
            self._ask()

    def clear(self) -> None:
        """Draw none."""
        self._shown, self._drawn = None, ()
        self._client.scene.remove_by_name(BALLS)

    def _ask(self) -> None:
        shown = self._shown
        if shown is None or not self._wanted:
            return
        seen = (shown.demonstration, shown.labeling.segments, shown.labeling.plan)
        if seen == self._drawn:
            return
        self._drawn = seen
        self._shared.part_paths.submit(lambda: self._work_out(shown), f"spread of {id(self)}")

    def _work_out(self, shown: DeskState) -> None:
        """Runs in the thread that all pages share."""
        if shown is not self._shown:
            return
        try:
            spread = task_spread(shown.labeling, self._shared.finished_beside(shown.recording))
        except KeyphaseError as error:
            self._view.telling.report(error)
            self._later(lambda: self._client.scene.remove_by_name(BALLS))
        else:
            self._later(lambda: self._draw(shown, spread))

    def _draw(self, shown: DeskState, spread: TaskSpread) -> None:
        if shown is not self._shown:
            return
        segments = [shown.labeling.segments[number] for number in spread.segment.tolist()]
        colors = [painted(segment_color(one.color, one.kept)) for one in segments]
        radii = np.maximum(spread.spread_m, LEAST_M).astype(np.float32)
        ball = trimesh.creation.icosphere(subdivisions=2, radius=1.0)
        with self._client.atomic():
            self._client.scene.add_batched_meshes_simple(
                BALLS,
                np.asarray(ball.vertices),
                np.asarray(ball.faces),
                np.tile([1.0, 0.0, 0.0, 0.0], (len(radii), 1)),
                spread.position_m,
                batched_scales=radii,
                batched_colors=np.array(colors, np.uint8),
                opacity=OPACITY,
                lod="off",
                cast_shadow=False,
                receive_shadow=False,
            )
        self._client.flush()
