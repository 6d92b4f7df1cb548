"""The path in the scene: a tube in the colours of the segments that can be clicked.

With segments selected those are solid and the rest faint; only what lies in the time that the
timeline shows is drawn. Chevrons say which way it goes.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import trimesh
import viser
from numpy.typing import NDArray

from keyphase.labeling.labeling import Labeling
from keyphase.web.scene.palette import painted, segment_color
from keyphase.web.scene.recording.path_geometry import (
    MAX_PIECES,
    Path,
    bent,
    chevron,
    spaced,
    tube,
)

FAINT = 0.15
"""Opacity of what is not selected, while something is."""

_SELECTED = 1.7
_CHEVRON_LENGTH, _CHEVRON_RADIUS = 4.5, 1.8
"""Of a chevron, in radii of the path."""

_DARKER = 0.55
_CHEVRONS = "/path/chevrons"


class ScenePath:
    """The whole path, and over it the selected segments thicker. `on_click` is told a time."""

    def __init__(
        self, client: viser.ClientHandle, path: Path, on_click: Callable[[float], None]
    ) -> None:
        self._client = client
        self._path = path
        self._on_click = on_click
        self._color_of_piece = np.zeros((len(path.time_s), 3), np.uint8)
        self._segment_of_piece = np.zeros(len(path.time_s), np.intp)
        self._selected: tuple[int, int] | None = None
        self._in_view = np.ones(len(path.time_s), np.bool_)
        self._shown: tuple[object, ...] = ()
        self._chevrons: tuple[object, ...] = ()
        self._tube = self._add("/path", path.drawn, path.radius_m)

    def color(self, labeling: Labeling) -> None:
        """Give each piece the colour of its segment."""
        cuts = np.array([boundary.time_s for boundary in labeling.boundaries])
        self._segment_of_piece = np.searchsorted(cuts, self._path.time_s, side="left")
        colors = np.array(
            [painted(segment_color(s.color, s.kept)) for s in labeling.segments], np.uint8
        )
        self._color_of_piece = colors[self._segment_of_piece]
        if self._tube is not None:
            self._tube.paint(self._color_of_piece)
        self._emphasize()

    def select(self, stretch: tuple[int, int] | None) -> None:
        """Draw the segments from a first to a last thicker, and the others faintly."""
        if stretch != self._selected:
            self._selected = stretch
            self._emphasize()

    def limit(self, from_s: float, to_s: float) -> bool:
        """Draw what was passed in this time only; whether that is anything else than before."""
        in_view = (self._path.time_s >= from_s) & (self._path.time_s <= to_s)
        if np.array_equal(in_view, self._in_view):
            return False
        self._in_view = in_view
        self._client.scene.remove_by_name("/path/pieces")
        self._client.scene.remove_by_name("/path/joints")
        drawn = self._path.drawn[in_view[self._path.drawn]]
        self._tube = self._add("/path", drawn, self._path.radius_m)
        if self._tube is not None:
            self._tube.paint(self._color_of_piece)
        self._emphasize()
        return True

    def _emphasize(self) -> None:
        """What is selected as it is, the rest faint."""
        if self._tube is not None:
            opaque = self._is_selected() | np.array(self._selected is None)
            self._tube.fade(np.where(opaque, 1.0, FAINT).astype(np.float32))
        self._draw_selected()
        self._draw_chevrons()

    def _is_selected(self) -> NDArray[np.bool_]:
        """(M,) which pieces of the path belong to what is selected."""
        first, last = self._selected or (1, 0)
        return (self._segment_of_piece >= first) & (self._segment_of_piece <= last)

    def _draw_selected(self) -> None:
        """All of what is selected, whatever of it was left out of the whole path."""
        chosen = np.flatnonzero(self._is_selected() & self._in_view)
        chosen = chosen[:: -(-len(chosen) // MAX_PIECES)] if len(chosen) else chosen
        shown = (chosen.tobytes(), self._color_of_piece[chosen].tobytes())
        if shown == self._shown:
            return
        self._shown = shown
        self._client.scene.remove_by_name("/path/selected")
        thick = self._add("/path/selected", chosen, _SELECTED * self._path.radius_m)
        if thick is not None:
            thick.paint(self._color_of_piece)

    def _draw_chevrons(self) -> None:
        """Along what is selected, or along all."""
        of_them = self._in_view if self._selected is None else self._in_view & self._is_selected()
        chosen = spaced(self._path, np.flatnonzero(of_them))
        colors = (_DARKER * self._color_of_piece[chosen]).astype(np.uint8)
        thick = 1.0 if self._selected is None else 0.8 * _SELECTED
        shown = (chosen.tobytes(), colors.tobytes(), thick)
        if shown == self._chevrons:
            return
        self._chevrons = shown
        self._client.scene.remove_by_name(_CHEVRONS)
        if len(chosen) == 0:
            return
        scales = np.full((len(chosen), 3), thick * self._path.radius_m, np.float32)
        scales *= np.array([_CHEVRON_RADIUS, _CHEVRON_RADIUS, _CHEVRON_LENGTH], np.float32)
        batch = _batch(
            self._client,
            _CHEVRONS,
            chevron(),
            self._path.wxyz[chosen],
            self._path.middle_m[chosen],
            scales,
        )
        batch.batched_colors = colors

    def _add(self, name: str, chosen: NDArray[np.intp], radius_m: float) -> "_Tube | None":
        if len(chosen) == 0:
            return None
        tube = _tube_of(self._client, name, self._path, chosen, radius_m)
        time_s = self._path.time_s[chosen]

        @tube.pieces.on_click
        def _(event: viser.SceneNodePointerEvent[viser.BatchedMeshHandle]) -> None:
            index = event.instance_index
            if index is not None and 0 <= index < len(time_s):
                self._on_click(float(time_s[index]))

        return tube


@dataclass(frozen=True, eq=False)
class _Tube:
    """Two batches: straight pieces, and balls at its ends and wherever it bends.

    chosen  (D,) which pieces of the path these are
    joined  (J,) the piece of the path that each ball takes its colour from
    """

    pieces: viser.BatchedMeshHandle
    joints: viser.BatchedMeshHandle
    chosen: NDArray[np.intp]
    joined: NDArray[np.intp]

    def paint(self, color_of_piece: NDArray[np.uint8]) -> None:
        """Take the colours (M, 3) of the path's pieces."""
        self.pieces.batched_colors = color_of_piece[self.chosen]
        self.joints.batched_colors = color_of_piece[self.joined]

    def fade(self, opacity_of_piece: NDArray[np.float32]) -> None:
        """Take the opacities (M,) of the path's pieces."""
        solid = bool((opacity_of_piece == 1.0).all())
        for batch, which in ((self.pieces, self.chosen), (self.joints, self.joined)):
            batch.batched_opacities = None if solid else opacity_of_piece[which]


def _tube_of(
    client: viser.ClientHandle, name: str, path: Path, chosen: NDArray[np.intp], radius_m: float
) -> _Tube:
    scales = np.full((len(chosen), 3), radius_m, np.float32)
    scales[:, 2] = path.length_m[chosen]
    pieces = _batch(
        client, f"{name}/pieces", tube(), path.wxyz[chosen], path.middle_m[chosen], scales
    )
    ends, joined = _joints(path, chosen)
    upright = np.tile([1.0, 0.0, 0.0, 0.0], (len(ends), 1))
    radii = np.full(len(ends), radius_m, np.float32)
    ball = _ball(len(ends))
    joints = _batch(client, f"{name}/joints", ball, upright, path.position_m[ends], radii)
    return _Tube(pieces, joints, chosen, joined)


def _joints(path: Path, chosen: NDArray[np.intp]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Points of the path that need a ball, and for each the piece it belongs to."""
    directions = np.diff(path.position_m, axis=0)[chosen]
    breaks = np.diff(chosen) != 1
    bends = bent(directions)
    starts = chosen[np.concatenate([[True], breaks])]
    after = chosen[np.concatenate([breaks | bends, [True]])]
    return np.concatenate([starts, after + 1]), np.concatenate([starts, after])


def _batch(
    client: viser.ClientHandle,
    name: str,
    shape: tuple[NDArray[np.float64], NDArray[np.uint32]],
    wxyz: NDArray[np.float64],
    position_m: NDArray[np.float64],
    scales: NDArray[np.float32],
) -> viser.BatchedMeshHandle:
    vertices, faces = shape
    return client.scene.add_batched_meshes_simple(
        name,
        vertices,
        faces,
        wxyz,
        position_m,
        batched_scales=scales,
        batched_colors=np.zeros((len(position_m), 3), np.uint8),
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )


def _ball(count: int) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    """Round; where there are very many, so that they can still be drawn, a little less."""
    ball = trimesh.creation.icosphere(subdivisions=2 if count <= 150 else 1, radius=1.0)
    return np.asarray(ball.vertices), np.asarray(ball.faces, np.uint32)
