"""Phases as a person types them."""

from keyphase.errors import LabelingError
from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.tasks.task import PHASE_ENDS, TaskPhase

_MORE = ("optional", "repeated")


def typed_phase(text: str, number: int) -> TaskPhase:
    """The phase NAME, NAME:END or NAME:END:optional:repeated; `number` chooses its colour.

    Raises LabelingError for what is none.
    """
    name, *words = (part.strip() for part in text.split(":"))
    unknown = [word for word in words if word not in (*PHASE_ENDS, *_MORE)]
    ends = [word for word in words if word in PHASE_ENDS]
    if unknown or len(ends) > 1:
        wrong = unknown[0] if unknown else ends[1]
        raise LabelingError(
            f"Expected a phase such as “insert:contact:optional”, with one of "
            f"{', '.join(PHASE_ENDS)} and then {' or '.join(_MORE)}, but got “{wrong}” in {text!r}."
        )
    end = ends[0] if ends else "configuration"
    color = SEGMENT_COLORS[number % len(SEGMENT_COLORS)]
    return TaskPhase(name, color, end, "optional" in words, "repeated" in words)  # pyright: ignore[reportArgumentType]
