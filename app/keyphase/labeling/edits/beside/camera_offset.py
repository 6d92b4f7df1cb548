"""Laying a camera's video on the recording's clock by hand."""

from collections.abc import Mapping
from typing import ClassVar

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.reset import Reset
from keyphase.labeling.labeling import Labeling

MAX_OFFSET_S = 1e6
MAX_CAMERA_NAME = 200


class CameraOffset(BaseEdit, frozen=True, tag="camera_offset"):
    """Show the video of `camera` later by `offset_s` [s] than its file says; below 0: earlier."""

    changes_segments: ClassVar[bool] = False

    camera: str
    offset_s: float

    def checked(self) -> "CameraOffset":
        """By no more than a recording can last."""
        super().checked()
        if abs(self.offset_s) > MAX_OFFSET_S or len(self.camera) > MAX_CAMERA_NAME:
            raise LabelingError(
                f"The offset of a camera must lie within {MAX_OFFSET_S:g} s, and its name have at "
                f"most {MAX_CAMERA_NAME} characters."
            )
        return self

    def step_name(self, labeling: Labeling) -> str:
        """With how far it is moved now."""
        return f"Offset of camera {self.camera}: {1e3 * self.offset_s:+.0f} ms"


def camera_offsets(edits: Mapping[int, BaseEdit]) -> dict[str, float]:
    """How far a person has moved each camera [s]; the latest edit of each counts."""
    offsets: dict[str, float] = {}
    for edit in edits.values():
        if isinstance(edit, Reset):
            offsets.clear()
        elif isinstance(edit, CameraOffset):
            offsets[edit.camera] = edit.offset_s
    return offsets
