"""The tail of the tool: the last of its way before the playhead, fading, seen as it moves."""

import numpy as np
import trimesh
import viser
from numpy.typing import NDArray

from keyphase.demonstration import Demonstration
from keyphase.web.scene.palette import Theme, painted

NAME = "/frame/tail"
TAIL_S = 0.5
"""So much of the way before the playhead."""

_BALLS = 24
_THICKEST, _THINNEST = 1.9, 0.5
"""In radii of the path."""

_SOLID, _FAINT = 0.9, 0.08
"""Opacity at the tool, and at the end of the tail."""


class Tail:
    """Balls along the way, each thinner and fainter than the one after it, for one recording."""

    def __init__(self, client: viser.ClientHandle, radius_m: float, theme: Theme) -> None:
        share = np.linspace(1.0, 0.0, _BALLS, dtype=np.float32)
        ball = trimesh.creation.icosphere(subdivisions=1, radius=1.0)
        self._balls = client.scene.add_batched_meshes_simple(
            NAME,
            np.asarray(ball.vertices),
            np.asarray(ball.faces, np.uint32),
            np.tile([1.0, 0.0, 0.0, 0.0], (_BALLS, 1)),
            np.zeros((_BALLS, 3)),
            batched_scales=radius_m * (_THINNEST + (_THICKEST - _THINNEST) * share),
            batched_colors=_colors(theme),
            batched_opacities=_FAINT + (_SOLID - _FAINT) * share,
            lod="off",
            cast_shadow=False,
            receive_shadow=False,
        )

    def paint(self, theme: Theme) -> None:
        """Take the colour of the playhead in a theme."""
        self._balls.batched_colors = _colors(theme)

    def follow(self, demonstration: Demonstration, time_s: float) -> None:
        """End at where the tool was at that time."""
        self._balls.batched_positions = tail_m(demonstration, time_s).astype(np.float32)


def tail_m(demonstration: Demonstration, time_s: float) -> NDArray[np.float64]:
    """Where the tool was in the last TAIL_S before a time, the latest first, shape (N, 3) [m].

    Before the recording begins it was where it began.
    """
    times_s = time_s - np.linspace(0.0, TAIL_S, _BALLS)
    recorded_s = demonstration.time_s
    return np.stack(
        [np.interp(times_s, recorded_s, axis) for axis in demonstration.position_m.T], axis=1
    )


def _colors(theme: Theme) -> NDArray[np.uint8]:
    return np.tile(np.array(painted(theme.origins["user"]), np.uint8), (_BALLS, 1))
