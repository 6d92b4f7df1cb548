"""The camera of a page: where the scene says, then where a person turned it, also after a break."""

from dataclasses import dataclass

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.web.scene.recording.viewpoint import FIELD_OF_VIEW_RAD, Viewpoint


@dataclass
class LastCamera:
    """Where a page's camera was last, and at what; kept while its frame connects again.

    `of` is what was looked at: the same again is seen from where it was seen before.
    """

    of: object = None
    position_m: Array | None = None
    look_at_m: Array | None = None
    up: Array | None = None


class Camera:
    """Points the camera of one client, and remembers in `last` where a person turned it."""

    def __init__(self, client: viser.ClientHandle, last: LastCamera) -> None:
        self._client, self._last = client, last
        self._pointed = False
        client.camera.on_update(self._moved)

    def look(self, view: Viewpoint, of: object) -> None:
        """Look from `view`, or from where the same was seen last."""
        last = self._last
        if of is not last.of or last.position_m is None or last.look_at_m is None:
            last.of = of
            self.point(view.position_m, view.look_at_m, None)
        else:
            self.point(last.position_m, last.look_at_m, last.up)

    def point(self, position_m: Array, look_at_m: Array, up: Array | None) -> None:
        """Put it there at once."""
        camera = self._client.camera
        self._pointed = True
        with self._client.atomic():
            camera.fov = FIELD_OF_VIEW_RAD
            if up is not None:
                camera.up_direction = up
            camera.position, camera.look_at = position_m, look_at_m
        self._last.position_m, self._last.look_at_m, self._last.up = position_m, look_at_m, up

    async def _moved(self, camera: viser.CameraHandle) -> None:
        """A person turned it; but what viser's client says before it was pointed is no choice."""
        if not self._pointed:
            return
        last = self._last
        last.position_m, last.look_at_m = np.array(camera.position), np.array(camera.look_at)
        last.up = np.array(camera.up_direction)
