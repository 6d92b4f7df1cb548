"""A gizmo in the scene, dragged with the mouse by one of its arrows."""

import numpy as np
from driver import Box, KeyphasePage
from numpy.typing import NDArray

from keyphase.web.server import PageServer

Vector = NDArray[np.float64]

STEPS = 10
"""Mouse moves of one drag; each costs a frame drawn in software."""


TRIES = 3

NEAR_M = 0.01


class Gizmo:
    """Where the arrows of the one gizmo that is shown are on the page; its size in m."""

    def __init__(self, server: PageServer, page: KeyphasePage, size_m: float) -> None:
        self.server, self.page, self.size_m = server, page, size_m
        (self.client,) = server.viser.get_clients().values()
        self.camera = self.client.camera

    def pull(self, axis: Vector, distance_m: float) -> None:
        """Drag the arrow along a direction of the base frame with the mouse, until it is there."""
        start = np.array(self.handle.position)
        for _ in range(TRIES):
            left_m = distance_m - float((self.handle.position - start) @ axis)
            if left_m < NEAR_M:
                return
            self.hold(axis, left_m)
            self.page.page.mouse.up()
            self.page.settle()
        raise AssertionError("the gizmo was not dragged to where it should be")

    def hold(self, axis: Vector, distance_m: float) -> None:
        """Drag the arrow and keep the button down; a busy machine may need more than one try."""
        mouse = self.page.page.mouse
        for _ in range(TRIES):
            self.page.wait_for_scene()
            before = np.array(self.handle.position)
            start, end = self.grip(axis, distance_m)
            mouse.move(*start)
            self.page.settle()
            mouse.down()
            mouse.move(*end, steps=STEPS)
            for _ in range(TRIES * STEPS):
                self.page.settle()
                if np.linalg.norm(self.handle.position - before) > 0.5 * distance_m:
                    return
            mouse.up()
        raise AssertionError("the gizmo was not dragged")

    def grip(
        self, axis: Vector, distance_m: float
    ) -> tuple[tuple[float, float], tuple[float, float]]:
        """Where on the page the arrow along a direction is, and where it goes if dragged so far."""
        at = self.handle.position
        turned = _rotation(self.handle.wxyz).T @ axis
        side = np.sign(turned[np.argmax(np.abs(turned))])
        arrow = at + side * axis * self.size_m * 0.93
        return self.pixel(arrow), self.pixel(arrow + axis * distance_m)

    @property
    def handle(self):
        gizmos = self.client.scene._handle_from_transform_controls_name.values()  # type: ignore
        (shown,) = (gizmo for gizmo in gizmos if gizmo.visible)
        return shown

    def pixel(self, point_m: Vector) -> tuple[float, float]:
        """Where a point of the scene is on the page."""
        found = self.page.scene.locator("canvas").first.bounding_box()
        assert found is not None
        box = Box(**found)
        camera = self.camera
        forward = _unit(np.asarray(camera.look_at) - camera.position)
        right = _unit(np.cross(forward, camera.up_direction))
        up = np.cross(right, forward)
        away = point_m - camera.position
        scale = 0.5 * box.height / np.tan(0.5 * camera.fov) / (away @ forward)
        x, y = box.middle
        return float(x + scale * (away @ right)), float(y - scale * (away @ up))


def _unit(vector: Vector) -> Vector:
    return vector / np.linalg.norm(vector)


def _rotation(wxyz: Vector) -> Vector:
    w, x, y, z = wxyz
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
