"""When a segment is over: at a contact (force threshold) or a configuration (near the goal)."""

from keyphase.segmentation.end_condition.agreement import agrees
from keyphase.segmentation.end_condition.derived import end_condition_at, ends_in_contact
from keyphase.segmentation.end_condition.values import (
    ConfigurationEnd,
    ContactEnd,
    EndCondition,
    GripperEnd,
)

__all__ = [
    "ConfigurationEnd",
    "ContactEnd",
    "EndCondition",
    "GripperEnd",
    "agrees",
    "end_condition_at",
    "ends_in_contact",
]
