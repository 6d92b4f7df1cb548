"""The floor of a page's scene: ground, grid, the robot's shadow, and a stand under its base."""

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.web.scene.palette import Theme
from keyphase.web.scene.recording.ground import REACH, Ground
from keyphase.web.scene.recording.ground_shadow import GroundShadow
from keyphase.web.scene.recording.path_geometry import Path

_ABOVE_GROUND_M = 0.001
"""The grid lies so far above the ground, so that it is seen."""

_MIN_STAND_M = 0.01
"""A robot whose base is nearer to the ground than this stands on it."""

_STAND = "/stand"


class Floor:
    """Drawn anew for each recording; `shadow` is the one a robot throws that stands there."""

    def __init__(self, client: viser.ClientHandle, shadow: GroundShadow | None) -> None:
        self._scene, self._shadow = client.scene, shadow

    def clear(self) -> None:
        """Draw none."""
        for name in ("/grid/ground", "/grid/lines", _STAND):
            self._scene.remove_by_name(name)

    def draw_below(self, theme: Theme, path: Path, base: Placement | None) -> None:
        """Below a path, and at the feet of the robot at `base`, if one is seen."""
        self.draw(theme, ground_of(path, base), path.size_m, base)

    def draw(self, theme: Theme, at_m: Array, size_m: float, base: Placement | None) -> None:
        """A picture of the ground, and the lines of a grid just above it."""
        x, y, z = at_m.tolist()
        ground = Ground((x, y, z), REACH * size_m)
        cell, side = _round_length(size_m / 3), 2.0 * ground.half_m
        self._scene.add_image(
            "/grid/ground",
            ground.picture(theme, base, self._shadow),
            side,
            side,
            format="png",
            cast_shadow=False,
            receive_shadow=False,
            position=at_m,
        )
        self._scene.add_grid(
            "/grid/lines",
            side,
            side,
            cell_size=cell,
            section_size=5 * cell,
            cell_color=theme.cell,
            section_color=theme.section,
            plane_opacity=0.0,
            shadow_opacity=theme.shade,
            fade_distance=0.9 * ground.half_m,
            fade_strength=1.5,
            fade_from="origin",
            position=(x, y, z + _ABOVE_GROUND_M),
        )
        self._draw_stand(theme, z, base)

    def _draw_stand(self, theme: Theme, ground_m: float, base: Placement | None) -> None:
        """What carries a base that is above the ground, as wide as the shadow's robot is."""
        height = 0.0 if base is None else base.position_m[2] - ground_m
        if base is None or self._shadow is None or height < _MIN_STAND_M:
            self._scene.remove_by_name(_STAND)
            return
        x, y, _ = base.position_m
        self._scene.add_cylinder(
            _STAND,
            0.5 * float(min(self._shadow.size_m)) * 0.5,
            height,
            theme.section,
            position=(x, y, ground_m + 0.5 * height),
        )


def ground_of(path: Path, base: Placement | None) -> Array:
    """Where the ground is: at the robot's feet, or where they would be if that is just below.

    It never hides the path, which may go below the robot's feet.
    """
    x, y = (0.5 * (path.low_m + path.high_m)[:2]).tolist()
    lowest = float(path.low_m[2])
    if base is not None:
        height = min(base.position_m[2], lowest - 2.0 * path.radius_m)
    elif 2.0 * path.radius_m <= lowest <= 0.6 * path.size_m:
        height = 0.0
    else:
        height = lowest - 0.08 * path.size_m
    return np.array([x, y, height])


def _round_length(length_m: float) -> float:
    """The nearest of 1, 2 and 5 times a power of ten."""
    steps = np.array([1.0, 2.0, 5.0, 10.0]) * 10.0 ** np.floor(np.log10(length_m))
    return float(steps[np.argmin(np.abs(np.log(steps / length_m)))])
