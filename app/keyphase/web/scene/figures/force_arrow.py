"""The measured force in the scene of a workcell: an arrow beside the gripper."""

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


class ForceArrow:
    """An arrow below `root`, without its size unless `label` asks for it."""

    def __init__(self, client: viser.ClientHandle, root: str) -> None:
        self._is_labeled = False
        self._arrow = client.scene.add_arrows(
            f"{root}/force",
            np.array([[[0.0, 0.0, 0.0], [0.0, 0.0, 0.01]]], np.float32),
            np.array(_COLOR, np.uint8),
            shaft_radius=0.004,
            head_radius=0.009,
            head_length=0.02,
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
            start = tool_m + BESIDE_M
            tip = start + METRES_PER_NEWTON * force_N
            self._arrow.points = np.array([[start, tip]], np.float32)
            if self._is_labeled:
                self._size.position, self._size.text = tip, f"{size:.1f} N"


def _put(handle: viser.ArrowsHandle | viser.LabelHandle, visible: bool) -> None:
    if handle.visible != visible:
        handle.visible = visible
