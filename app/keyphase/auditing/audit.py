"""Labels that others made against what keyphase finds in the same recording."""

from dataclasses import dataclass
from pathlib import Path
from statistics import median

from keyphase.auditing.given import GivenLabels
from keyphase.auditing.reading import given_labels
from keyphase.labeling.comparing.comparison import DEFAULT_TOLERANCE_S, Comparison, Outline, compare
from keyphase.labeling.edits import MAX_LABEL_LENGTH, Add, Contact, Label, Remove, TakeOver
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.readers import read
from keyphase.segmentation import Parameters, Segmentation, segment

_SAME_S = 1e-6


@dataclass(frozen=True, eq=False)
class Audited:
    """A recording, the labels somebody gave it, and how keyphase's segmentation agrees with them.

    comparison  `first` are the given labels, `second` keyphase's
    labeling    the given ones taken over, to be looked at and corrected
    """

    recording: Path
    given: GivenLabels
    comparison: Comparison
    labeling: Labeling

    @property
    def timing_s(self) -> float | None:
        """Median distance of boundaries that both have; None where there are none."""
        distances = [abs(pair.distance_s) for pair in self.comparison.shared]
        return float(median(distances)) if distances else None


def audit(
    recording: Path | str,
    recipe: Path | None = None,
    parameters: Parameters | None = None,
    tolerance_s: float = DEFAULT_TOLERANCE_S,
) -> Audited:
    """Compare the labels in a recording's own file with what keyphase finds in it.

    Raises DemonstrationError where it cannot be read, ExportError where it has no labels.
    """
    recording = Path(recording)
    demonstration = read(recording, recipe)
    given = given_labels(recording, demonstration, recipe)
    segmentation = segment(demonstration, parameters)
    found = Outline.of_labeling(label(segmentation))
    result = compare(given.outline, found, tolerance_s)
    return Audited(recording, given, result, taken_over(segmentation, given, tolerance_s))


def taken_over(
    segmentation: Segmentation, given: GivenLabels, tolerance_s: float = DEFAULT_TOLERANCE_S
) -> Labeling:
    """The given labels as a person's edits over the segmentation."""
    return label(segmentation, {0: taking_over_given(segmentation, given, tolerance_s)})


def taking_over_given(
    segmentation: Segmentation, given: GivenLabels, tolerance_s: float = DEFAULT_TOLERANCE_S
) -> TakeOver:
    """The one edit that makes given labels the segmentation's.

    Whether contact changes at a boundary is what keyphase found near it, since labels do not say.
    """
    times = given.outline.boundaries_s
    there = [b for b in segmentation.boundaries if any(abs(b.time_s - t) <= _SAME_S for t in times)]
    edits: list[Remove | Add | Contact | Label] = [
        Remove(b.time_s) for b in segmentation.boundaries if b not in there
    ]
    known = {b.time_s for b in there}
    for time in times:
        if not any(abs(time - at) <= _SAME_S for at in known):
            edits.append(Add(time, _is_contact_change(segmentation, time, tolerance_s)))
    for one in given.segments:
        middle = 0.5 * (one.start_s + one.end_s)
        edits.append(Label(middle, _plain(one.label), (one.start_s, one.end_s)))
    return TakeOver(_plain(given.source), tuple(edits)).checked()


def _is_contact_change(segmentation: Segmentation, time_s: float, tolerance_s: float) -> bool:
    near = [b for b in segmentation.boundaries if abs(b.time_s - time_s) <= tolerance_s]
    nearest = min(near, key=lambda b: abs(b.time_s - time_s), default=None)
    return nearest is not None and nearest.contact_change


def _plain(name: str) -> str:
    """A label as labels may be: what is no plain text in it becomes a question mark."""
    plain = "".join(c if c.isprintable() else "?" for c in name).strip()[:MAX_LABEL_LENGTH]
    return plain or "unnamed"
