"""Edits from JSON and to JSON: one tagged union, and nothing else gets through."""

from collections.abc import Mapping
from typing import Any

import msgspec

from keyphase.errors import LabelingError
from keyphase.labeling.edits.accept import Accept
from keyphase.labeling.edits.accept_labels import AcceptLabels
from keyphase.labeling.edits.add import Add
from keyphase.labeling.edits.beside.assess import Assess
from keyphase.labeling.edits.beside.assess_segment import AssessSegment
from keyphase.labeling.edits.beside.camera_offset import CameraOffset
from keyphase.labeling.edits.contact import Contact
from keyphase.labeling.edits.done import Done, Reopen
from keyphase.labeling.edits.drop_idle import DropIdle
from keyphase.labeling.edits.keep import Keep
from keyphase.labeling.edits.label import Label
from keyphase.labeling.edits.lost_edits import BringBack, Forget
from keyphase.labeling.edits.merge import Merge
from keyphase.labeling.edits.move import Move
from keyphase.labeling.edits.plan import Plan
from keyphase.labeling.edits.remove import Remove
from keyphase.labeling.edits.reset import Reset
from keyphase.labeling.edits.set_end import SetEnd
from keyphase.labeling.edits.stretches.name_stretch import NameStretch
from keyphase.labeling.edits.stretches.ripple import Ripple
from keyphase.labeling.edits.take_over import TakeOver
from keyphase.labeling.edits.together.phases import DropPhase, RenamePhase

Edit = (
    Add
    | Remove
    | Move
    | Label
    | Keep
    | Contact
    | Accept
    | Merge
    | Plan
    | DropIdle
    | AcceptLabels
    | BringBack
    | Forget
    | Reset
    | TakeOver
    | Done
    | Reopen
    | SetEnd
    | CameraOffset
    | Assess
    | AssessSegment
    | NameStretch
    | Ripple
    | RenamePhase
    | DropPhase
)
"""Everything a person can do; msgspec tells the kinds apart by their field `kind`."""

_MAX_REASON_LENGTH = 200


def edit_as_json(edit: Edit) -> dict[str, Any]:
    """The edit as JSON values: its kind and its fields, those that say nothing left out."""
    return msgspec.to_builtins(edit)


def edit_from_json(content: Any) -> Edit:
    """The edit that JSON values describe, with its values checked.

    Raises LabelingError where kind or fields are unknown, missing, of another type, not finite,
    or too long.
    """
    if not isinstance(content, Mapping):
        raise LabelingError("An edit must be an object with a kind, such as {kind: add, time_s: 1}")
    try:
        edit: Edit = msgspec.convert(content, Edit)
    except (msgspec.ValidationError, OverflowError) as error:
        raise LabelingError(
            f"Expected an edit, but this one is malformed: {str(error)[:_MAX_REASON_LENGTH]}."
        ) from error
    return edit.checked()
