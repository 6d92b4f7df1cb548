"""The ground of the scene as one picture: bright around the path, fading into the sky, with the
shadow of what stands on it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.web.scene.palette import Theme
from keyphase.web.scene.recording.ground_shadow import PIXEL_M, GroundShadow

PIXELS = 420
"""Along either side of the picture."""

REACH = 5.0
"""Half a side, in sizes of what is looked at."""

_NEAR = 0.30
"""The ground is evenly lit to this share of its reach."""


@dataclass(frozen=True)
class Ground:
    """A square of the ground: middle (x, y, z) and half a side, in the scene's frame [m]."""

    middle_m: tuple[float, float, float]
    half_m: float

    def picture(
        self, theme: Theme, base: Placement | None, shadow: GroundShadow | None
    ) -> NDArray[np.uint8]:
        """(PIXELS, PIXELS, 3), the first row at the least y.

        `shadow` is that of a robot whose root is at `base`; without either there is none.
        """
        at = self._pixels_m()
        away = np.linalg.norm(at - self.middle_m[:2], axis=-1) / self.half_m
        share = np.clip((away - _NEAR) / (1.0 - _NEAR), 0.0, 1.0)
        share = share * share * (3.0 - 2.0 * share)
        ground, sky = np.array(theme.ground, float), np.array(theme.sky, float)
        picture = ground + share[..., None] * (sky - ground)
        if base is not None and shadow is not None:
            dark = theme.shade * covered(shadow, base, at)
            picture *= 1.0 - dark[..., None] * (1.0 - share[..., None])
        return np.round(picture).astype(np.uint8)

    def _pixels_m(self) -> Array:
        """(PIXELS, PIXELS, 2) where each pixel's middle is."""
        along = (np.arange(PIXELS) + 0.5) / PIXELS * 2.0 - 1.0
        x, y = np.meshgrid(along, along)
        return self.half_m * np.stack([x, y], axis=-1) + self.middle_m[:2]


def covered(shadow: GroundShadow, base: Placement, at_m: Array) -> Array:
    """How much of the shadow lies on points (..., 2) of the ground: (...), 0 to 1."""
    frame = base.apply(np.eye(4))
    own = (at_m - frame[:2, 3]) @ frame[:2, :2]
    low = shadow.middle_m - 0.5 * shadow.size_m
    columns, rows = ((own - low) / PIXEL_M - 0.5).reshape(-1, 2).T
    cover = map_coordinates(shadow.cover, [rows, columns], order=1, cval=0.0)
    return cover.reshape(at_m.shape[:-1])
