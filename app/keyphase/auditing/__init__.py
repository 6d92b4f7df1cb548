"""Labels that others made: read, compared with what keyphase finds, and taken over."""

from keyphase.auditing.audit import Audited, audit, taken_over, taking_over_given
from keyphase.auditing.given import UNLABELLED, GivenLabels, GivenSegment
from keyphase.auditing.reading import given_labels

__all__ = [
    "UNLABELLED",
    "Audited",
    "GivenLabels",
    "GivenSegment",
    "audit",
    "given_labels",
    "taken_over",
    "taking_over_given",
]
