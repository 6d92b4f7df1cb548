"""The measured force in the scene of a workcell: an arrow beside the gripper."""

from dataclasses import dataclass

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.web.scene.palette import LIGHT, Rgb, painted
from keyphase.web.scene.recording.path_geometry import METRES_PER_NEWTON

MIN_FORCE_N = 0.6
"""What the sensor reads in free space is not drawn."""

BESIDE_M = (0.055, 0.0, 0.0)
"""The arrow stands in front of the gripper, which would hide it; base frame."""

_COLOR: Rgb = painted(LIGHT.origins["force"])


@dataclass(frozen=True)
class ArrowScale:
    """Where an arrow begins beside the tool, how long it is for each newton, and how thick."""

    beside_m: tuple[float, float, float] = BESIDE_M
    metres_per_N: float = METRES_PER_NEWTON
    radius_m: float = 0.004


class ForceArrow:
    """An arrow below `root`, without its size unless `label` asks for it."""

    def __init__(
        self, client: viser.ClientHandle, root: str, scale: ArrowScale | None = None
    ) -> None:
        self._is_labeled = False
        self._scale = scale or ArrowScale()
        radius = self._scale.radius_m
        self._arrow = client.scene.add_arrows(
            f"{root}/force",
            np.array([[[0.0, 0.0, 0.0], [0.0, 0.0, 0.01]]], np.float32),
            np.array(_COLOR, np.uint8),
            shaft_radius=radius,
            head_radius=2.25 * radius,
            head_length=5.0 * radius,
            visible=False,
        )
        self._size = client.scene.add_label(
            f"{root}/force_size", "", visible=False, anchor="center-left"
        )

    def label(self, wanted: bool) -> None:
        """Whether the size is a label of the scene, for where no page lays its own over it."""
        self._is_labeled = wanted
        _put(self._size, wanted and self._arrow.visible)

    def show(self, tool_m: Array, force_N: Array) -> None:
        """Show a force (3,) at the tool (3,), base frame."""
        size = float(np.linalg.norm(force_N))
        seen = size >= MIN_FORCE_N
        _put(self._arrow, seen)
        _put(self._size, seen and self._is_labeled)
        if seen:
            start = tool_m + self._scale.beside_m
            tip = start + self._scale.metres_per_N * force_N
            self._arrow.points = np.array([[start, tip]], np.float32)
            if self._is_labeled:
                self._size.position, self._size.text = tip, f"{size:.1f} N"


def _put(handle: viser.ArrowsHandle | viser.LabelHandle, visible: bool) -> None:
    if handle.visible != visible:
        handle.visible = visible
