"""The parts of a workcell drawn in the scene."""

from collections.abc import Mapping, Sequence

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.simulation.part_shapes import Shape
from keyphase.web.scene.palette import PART_GAMMA, Rgb, painted

TABLE_TOP = "table"
"""The table itself is not drawn: the ground is it."""

UNSEEN = 1e-6
"""Metres, or parts of a quaternion, that nobody sees a part move by."""

GREYER = 0.25
"""How far the colours of parts are from what they are to grey."""

LEAST_BRIGHT = 0.68
"""The brightest of red, green and blue; what is darker is lost on the ground of the dark theme."""


class PartFigures:
    """One frame for each part, its shapes below it; not for several threads at once."""

    def __init__(self, client: viser.ClientHandle, root: str, shapes: Sequence[Shape]) -> None:
        self._client, self._scene = client, client.scene
        self._root = root
        self.base = self._scene.add_frame(root, show_axes=False)
        drawn = [shape for shape in shapes if shape.name != TABLE_TOP]
        self._parts = {
            name: self._scene.add_frame(f"{root}/{name}", show_axes=False)
            for name in dict.fromkeys(shape.body for shape in drawn)
        }
        self._shown = np.full((len(self._parts), 7), np.nan)
        for shape in drawn:
            self._add(f"{root}/{shape.body}/{shape.name}", shape)

    def pose(self, poses: Mapping[str, tuple[Array, Array]]) -> None:
        """Put each part where it is: position (3,) and orientation (4,), w x y z, by name."""
        wanted = np.array([np.concatenate(poses[name]) for name in self._parts])
        moved = ~(np.abs(wanted - self._shown) <= UNSEEN)
        if not moved.any():
            return
        with self._client.atomic():
            for row, handle in enumerate(self._parts.values()):
                if moved[row].any():
                    handle.position, handle.wxyz = wanted[row, :3], wanted[row, 3:]
                    self._shown[row] = wanted[row]

    def remove(self) -> None:
        """Draw them no more."""
        self._scene.remove_by_name(self._root)

    def _add(self, name: str, shape: Shape) -> None:
        color = _rgb(shape.rgba)
        x, y, z = shape.size_m.tolist()
        if shape.kind == "box":
            handle = self._scene.add_box(name, color, (x, y, z))
        else:
            handle = self._scene.add_cylinder(name, 0.5 * x, z, color)
        handle.position, handle.wxyz = shape.position_m, shape.orientation_wxyz


def _rgb(rgba: tuple[float, float, float, float]) -> Rgb:
    """The colour of a part, a little greyer, so that the path and the forces stand out."""
    color = np.array(rgba[:3])
    muted = color + GREYER * (color.mean() - color)
    muted = muted * max(1.0, LEAST_BRIGHT / max(float(muted.max()), 0.01))
    red, green, blue = np.round(255.0 * muted).astype(int).tolist()
    return painted((red, green, blue), PART_GAMMA)
