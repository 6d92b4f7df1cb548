"""keyphase turns a recorded robot demonstration into key phases.

    import keyphase

    demonstration = keyphase.read("recording.npz")
    labeling = keyphase.label(keyphase.segment(demonstration))
    keyphase.write_segment_file(labeling, "recording.segments.json")

What stands here is what the commands use; each name is loaded when it is first asked for, so that
`import keyphase` costs nothing. All but `replay` runs where neither viser nor MuJoCo, Pinocchio or
yourdfpy is installed (`requirements-core.txt`).
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from keyphase.errors import KeyphaseError

if TYPE_CHECKING:
    from keyphase.auditing.audit import audit
    from keyphase.demonstration import Demonstration
    from keyphase.labeling.comparing.agreement import agreement
    from keyphase.labeling.document import Document
    from keyphase.labeling.label import label
    from keyphase.labeling.segment_file import read_segment_file, write_segment_file
    from keyphase.pictures.drawing import draw
    from keyphase.readers import read
    from keyphase.scoring import score
    from keyphase.segmentation import Parameters, Segmentation, Segmenter, segment
    from keyphase.segmentation.own_methods import FoundBoundary, register_method
    from keyphase.simulation.replay.by_file import replay
    from keyphase.skills.library import skills_of
    from keyphase.skills.many import skills_of_many
    from keyphase.transfer.proposing import propose
    from keyphase.transfer.taught import taught_by
    from keyphase.writers.writing import write

__version__ = "0.2.0.dev0"

__all__ = [
    "Demonstration",
    "Document",
    "FoundBoundary",
    "KeyphaseError",
    "Parameters",
    "Segmentation",
    "Segmenter",
    "agreement",
    "audit",
    "draw",
    "label",
    "propose",
    "read",
    "read_segment_file",
    "register_method",
    "replay",
    "score",
    "segment",
    "skills_of",
    "skills_of_many",
    "taught_by",
    "write",
    "write_segment_file",
]

_HOMES = {
    "Demonstration": "keyphase.demonstration",
    "Document": "keyphase.labeling.document",
    "FoundBoundary": "keyphase.segmentation.own_methods",
    "Parameters": "keyphase.segmentation.parameters",
    "Segmentation": "keyphase.segmentation.segmentation",
    "Segmenter": "keyphase.segmentation.segmenter",
    "agreement": "keyphase.labeling.comparing.agreement",
    "audit": "keyphase.auditing.audit",
    "draw": "keyphase.pictures.drawing",
    "label": "keyphase.labeling.label",
    "propose": "keyphase.transfer.proposing",
    "read": "keyphase.readers",
    "read_segment_file": "keyphase.labeling.segment_file",
    "register_method": "keyphase.segmentation.own_methods",
    "replay": "keyphase.simulation.replay.by_file",
    "score": "keyphase.scoring",
    "segment": "keyphase.segmentation.segmenter",
    "skills_of": "keyphase.skills.library",
    "skills_of_many": "keyphase.skills.many",
    "taught_by": "keyphase.transfer.taught",
    "write": "keyphase.writers.writing",
    "write_segment_file": "keyphase.labeling.segment_file",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
