"""The camera of a page: where the scene says, then where a person turned it, also after a break."""

from dataclasses import dataclass

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.web.scene.recording.viewpoint import FIELD_OF_VIEW_RAD, Viewpoint

_SAME = 0.01
"""A camera this near to where it was put, as a share of its distance, is where it was put."""


@dataclass
class LastCamera:
    """Where a page's camera was last, and at what; kept while its frame connects again.

    `of` is what was looked at: where a person `turned` it, the same again is seen from there.
    """

    of: object = None
    turned: bool = False
    position_m: Array | None = None
    look_at_m: Array | None = None
    up: Array | None = None


class Camera:
    """Points the camera of one client, and remembers in `last` where a person turned it."""

    def __init__(self, client: viser.ClientHandle, last: LastCamera) -> None:
        self._client, self._last = client, last
        self._has_arrived = False
        client.camera.on_update(self._moved)

    def look(self, view: Viewpoint, of: object) -> None:
        """Look from `view`, or from where a person turned to the same."""
        last = self._last
        if of is not last.of:
            last.of, last.turned = of, False
        if last.turned and last.position_m is not None and last.look_at_m is not None:
            self.point(last.position_m, last.look_at_m, last.up)
        else:
            self.point(view.position_m, view.look_at_m, None)

    def point(self, position_m: Array, look_at_m: Array, up: Array | None) -> None:
        """Put it there at once."""
        camera = self._client.camera
        self._has_arrived = False
        with self._client.atomic():
            camera.fov = FIELD_OF_VIEW_RAD
            if up is not None:
                camera.up_direction = up
            camera.position, camera.look_at = position_m, look_at_m
        self._last.position_m, self._last.look_at_m, self._last.up = position_m, look_at_m, up

    async def _moved(self, camera: viser.CameraHandle) -> None:
        """A person turned it; but what viser's client says before it is where it was put is none.

        That comes when it was on its way as the camera was pointed.
        """
        last = self._last
        if last.position_m is None or last.look_at_m is None:
            return
        position, look_at = np.array(camera.position), np.array(camera.look_at)
        near = _SAME * float(np.linalg.norm(last.position_m - last.look_at_m))
        moved = np.linalg.norm(position - last.position_m) > near
        if not moved and np.linalg.norm(look_at - last.look_at_m) <= near:
            self._has_arrived = True
        elif self._has_arrived:
            last.turned = True
            last.position_m, last.look_at_m = position, look_at
            last.up = np.array(camera.up_direction)
