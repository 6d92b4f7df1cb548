"""The parts of a workcell drawn in the scene."""

from collections.abc import Mapping, Sequence

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.simulation.shapes import Shape
from keyphase.web.palette import PART_GAMMA, Rgb, painted

TABLE_TOP = "table"
"""The table itself is not drawn: the ground is it."""


class PartFigures:
    """One frame for each part, its shapes below it; not for several threads at once."""

    def __init__(self, server: viser.ViserServer, root: str, shapes: Sequence[Shape]) -> None:
        self._scene = server.scene
        self._root = root
        self.base = self._scene.add_frame(root, show_axes=False)
        drawn = [shape for shape in shapes if shape.name != TABLE_TOP]
        self._parts = {
            name: self._scene.add_frame(f"{root}/{name}", show_axes=False)
            for name in dict.fromkeys(shape.body for shape in drawn)
        }
        for shape in drawn:
            self._add(f"{root}/{shape.body}/{shape.name}", shape)

    def pose(self, poses: Mapping[str, tuple[Array, Array]]) -> None:
        """Put each part where it is: position (3,) and orientation (4,), w x y z, by name."""
        for name, handle in self._parts.items():
            position, wxyz = poses[name]
            if np.abs(handle.position - position).max() > 1e-6:
                handle.position = position
            if np.abs(handle.wxyz - wxyz).max() > 1e-6:
                handle.wxyz = wxyz

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
    red, green, blue = (round(255 * value) for value in rgba[:3])
    return painted((red, green, blue), PART_GAMMA)
