"""What would be found today of a recording that is done: offered as a comparison, never put in."""

from keyphase.labeling.document import Document
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.segmentation import Segmenter

_SAME_S = 1e-3


def found_now(document: Document, segmenter: Segmenter, shown: Labeling) -> Labeling | None:
    """The labeling as it would be were it opened again: today's method, the folder's parameters.

    None where the recording is not done, or no boundary would lie elsewhere.
    """
    if document.frozen is None:
        return None
    opened = document.reopened()
    found = label(segmenter.segment(opened.parameters), opened.edits, segmenter.segment_between)
    return None if elsewhere(shown, found) == 0 else found


def elsewhere(one: Labeling, other: Labeling) -> int:
    """How many boundaries only one of the two has, of the one that has more such."""
    times, others = ([b.time_s for b in each.boundaries] for each in (one, other))
    return max(_without(times, others), _without(others, times))


def told(shown: Labeling, found: Labeling) -> str:
    """What a person should know of it."""
    count = elsewhere(shown, found)
    boundaries = "1 boundary" if count == 1 else f"{count} boundaries"
    return (
        f"This is kept as it was when it was done. With the folder's parameters and the method as "
        f"they are now, {boundaries} would lie elsewhere; compare with “{NOW}”."
    )


NOW = "found now"
"""What the comparison is called."""


def _without(times: list[float], others: list[float]) -> int:
    return sum(all(abs(time - other) > _SAME_S for other in others) for time in times)
