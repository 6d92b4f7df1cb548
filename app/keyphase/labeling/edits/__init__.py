"""Edits: what a person did to a segmentation, anchored in time; one module for each kind."""

from keyphase.labeling.edits.accept import Accept
from keyphase.labeling.edits.accept_labels import AcceptLabels
from keyphase.labeling.edits.add import Add
from keyphase.labeling.edits.base import kind_of
from keyphase.labeling.edits.beside.assess import Assess
from keyphase.labeling.edits.beside.assess_segment import AssessSegment
from keyphase.labeling.edits.beside.camera_offset import CameraOffset
from keyphase.labeling.edits.contact import Contact
from keyphase.labeling.edits.done import Done, Reopen
from keyphase.labeling.edits.drop_idle import DropIdle
from keyphase.labeling.edits.keep import Keep
from keyphase.labeling.edits.label import MAX_LABEL_LENGTH, Label, check_label
from keyphase.labeling.edits.lost_edits import BringBack, Forget
from keyphase.labeling.edits.merge import Merge
from keyphase.labeling.edits.move import Move
from keyphase.labeling.edits.parsing import Edit, edit_as_json, edit_from_json
from keyphase.labeling.edits.plan import MAX_PLAN_LENGTH, Plan
from keyphase.labeling.edits.remove import Remove
from keyphase.labeling.edits.reset import Reset
from keyphase.labeling.edits.set_end import SetEnd
from keyphase.labeling.edits.stretches.name_stretch import NameStretch
from keyphase.labeling.edits.stretches.ripple import Ripple
from keyphase.labeling.edits.take_over import TakeOver
from keyphase.labeling.edits.together.phases import DropPhase, PhaseInAll, RenamePhase

__all__ = [
    "MAX_LABEL_LENGTH",
    "MAX_PLAN_LENGTH",
    "Accept",
    "AcceptLabels",
    "Add",
    "Assess",
    "AssessSegment",
    "BringBack",
    "CameraOffset",
    "Contact",
    "Done",
    "DropIdle",
    "DropPhase",
    "Edit",
    "Forget",
    "Keep",
    "Label",
    "Merge",
    "Move",
    "NameStretch",
    "PhaseInAll",
    "Plan",
    "Remove",
    "RenamePhase",
    "Reopen",
    "Reset",
    "Ripple",
    "SetEnd",
    "TakeOver",
    "check_label",
    "edit_as_json",
    "edit_from_json",
    "kind_of",
]
