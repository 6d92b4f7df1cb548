"""What one learns on one recording, applied to all: first as a preview, then for good."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from keyphase.labeling.comparing.matching import match_times
from keyphase.labeling.document import Document
from keyphase.labeling.label import Describe, label
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.parameter_names import parameter_text
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Segmentation

_SAME_S = 1e-3


@dataclass(frozen=True)
class Change:
    """What new parameters of the folder would do to one recording.

    comes_s, goes_s      boundaries that would appear and disappear
    moves_s              (from, to) of boundaries that would move by more than a millisecond
    newly_inapplicable   descriptions of edits whose place would be gone
    own                  parameters in which this recording departs from the folder, for people
    done                 a person has finished with it, so it is left alone unless that is wanted
    """

    comes_s: tuple[float, ...]
    goes_s: tuple[float, ...]
    moves_s: tuple[tuple[float, float], ...]
    newly_inapplicable: tuple[str, ...]
    own: tuple[str, ...]
    done: bool = False

    @property
    def is_none(self) -> bool:
        """Whether nothing would change."""
        return not (self.comes_s or self.goes_s or self.moves_s or self.newly_inapplicable)


def preview(
    document: Document,
    shared: Parameters,
    segment: Callable[[Parameters], Segmentation],
    describe: Describe | None = None,
    tolerance_s: float = 0.15,
    *,
    include_done: bool = False,
) -> Change:
    """What it would do to a document if its folder had the parameters `shared`.

    `segment` segments the document's demonstration, as `Segmenter.segment` does; `describe` is
    `Segmenter.segment_between`. What is done is left alone unless `include_done`, which opens it
    again. Edits stay; parameters set on this recording alone go on holding.
    """
    if document.done and not include_done:
        return Change((), (), (), (), _own(document), done=True)
    changed = replace(document.with_shared(shared), done_before=False)
    if document.frozen is not None:
        changed = changed.reopened()
    before = label(segment(document.parameters), document.edits, describe)
    after = label(segment(changed.parameters), changed.edits, describe)
    old, new = _times(before), _times(after)
    matches = match_times(old, new, tolerance_s)
    pairs = [(old[match.reference], new[match.found]) for match in matches]
    kept_old, kept_new = {a for a, _ in pairs}, {b for _, b in pairs}
    known = {lost.edit for lost in before.inapplicable}
    return Change(
        comes_s=tuple(time for time in new if time not in kept_new),
        goes_s=tuple(time for time in old if time not in kept_old),
        moves_s=tuple((a, b) for a, b in pairs if abs(a - b) > _SAME_S),
        newly_inapplicable=tuple(
            lost.text for lost in after.inapplicable if lost.edit not in known
        ),
        own=_own(document),
        done=document.done,
    )


def _own(document: Document) -> tuple[str, ...]:
    return tuple(parameter_text(name, value) for name, value in document.own_parameters.items())


def _times(labeling: Labeling) -> list[float]:
    return [boundary.time_s for boundary in labeling.boundaries]
