"""The gizmo by which a person pushes the tool of a replay: a spring between it and the tool."""

from collections.abc import Callable

import numpy as np
import viser

from keyphase.demonstration import Array

STIFFNESS_N_M = 200.0
"""Of the spring."""

GIZMO_M = 0.11

_SPRING = (28, 126, 214)
_THICK_M = 0.002


class PushGizmo:
    """Follows the tool until it is dragged; `push` is told the force (3,) [N] from then on."""

    def __init__(
        self, client: viser.ClientHandle, name: str, tool_m: Array, push: Callable[[Array], None]
    ) -> None:
        self._push, self._tool_m = push, tool_m
        self._pulled_to_m: Array | None = None
        self._scene, self._name = client.scene, f"{name}_spring"
        self._spring: tuple[viser.LineSegmentsHandle, viser.LabelHandle] | None = None
        self._gizmo = client.scene.add_transform_controls(
            name, scale=GIZMO_M, disable_rotations=True, depth_test=False, position=tool_m
        )
        self._gizmo.on_update(self._dragged)

    def follow(self, tool_m: Array) -> None:
        """The tool is at `tool_m` now, which stretches the spring or takes the gizmo along."""
        self._tool_m = tool_m
        if self._pulled_to_m is None:
            self._gizmo.position = tool_m
        self._pull()

    def remove(self) -> None:
        """Draw it no more, and let go."""
        self._let_go()
        self._gizmo.remove()

    async def _dragged(self, event: viser.TransformControlsEvent) -> None:
        if event.phase == "end":
            self._let_go()
        else:
            self._pulled_to_m = np.array(event.target.position)
            self._pull()

    def _pull(self) -> None:
        if self._pulled_to_m is not None:
            force = STIFFNESS_N_M * (self._pulled_to_m - self._tool_m)
            self._push(force)
            self._draw_spring(self._tool_m, self._pulled_to_m, float(np.linalg.norm(force)))

    def _draw_spring(self, from_m: Array, to_m: Array, force_N: float) -> None:
        """A line from the tool to the hand, with how hard it pulls.

        A page needs a moment to write a label: one made anew at every step would never be seen.
        """
        ends = np.array([[from_m, to_m]], dtype=np.float32)
        middle_m, text = 0.5 * (from_m + to_m), f"{force_N:.0f} N"
        if self._spring is None:
            self._spring = (
                self._scene.add_line_segments(self._name, ends, _SPRING, thickness=_THICK_M),
                self._scene.add_label(
                    f"{self._name}/force", text, position=middle_m, anchor="bottom-center"
                ),
            )
            return
        line, label = self._spring
        line.points, label.position = ends, middle_m
        if label.text != text:
            label.text = text

    def _let_go(self) -> None:
        if self._pulled_to_m is not None:
            self._pulled_to_m = self._spring = None
            self._scene.remove_by_name(self._name)
            self._push(np.zeros(3))
