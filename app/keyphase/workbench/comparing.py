"""Another segmentation of the open recording beside the one that is shown."""

from collections.abc import Sequence
from statistics import median
from typing import Any

from keyphase.errors import KeyphaseError, RequestError
from keyphase.files.parts import stem_of
from keyphase.labeling.comparison import Outline, compare
from keyphase.labeling.edits import Reset
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import SUFFIX, SegmentFile, read_segment_file
from keyphase.labeling.taking_over import taking_over
from keyphase.workbench.opened import Opened
from keyphase.workbench.recordings import printable

AUTOMATIC = "automatic"
"""Compare with what the program found, without anybody's edits."""

MOST_FILES = 50
"""So many segment files of a folder are offered."""


def comparison_message(opened: Opened, other: str | None) -> dict[str, Any]:
    """The `comparison` message: with what the recording can be compared, and how `other` agrees.

    `other` is None, "automatic", or the name of a segment file beside the recording. Raises
    RequestError for a name that is not offered, SegmentFileError and LabelingError for a file
    that cannot be compared.
    """
    names = _segment_files(opened)
    options = [AUTOMATIC, *map(printable, names)]
    message: dict[str, Any] = {"type": "comparison", "options": options, "with": other}
    if other is None:
        return message
    if other not in options:
        raise _unknown()
    index = options.index(other)
    second = _automatic(opened) if index == 0 else Outline.of_file(_filed(opened, names[index - 1]))
    result = compare(Outline.of_labeling(opened.kept_labeling), second)
    distances = [abs(pair.distance_s) for pair in result.shared]
    return {
        **message,
        "boundaries_s": _plain(second.boundaries_s),
        "labels": list(second.labels),
        "shared": [_plain((pair.first_s, pair.second_s)) for pair in result.shared],
        "only_first_s": _plain(result.only_first_s),
        "only_second_s": _plain(result.only_second_s),
        "f1": float(result.f1),
        "timing_s": float(median(distances)) if distances else None,
        "covering": float(result.covering),
        "same_label": float(result.same_label),
    }


def take_over(opened: Opened, other: str) -> None:
    """Make another segmentation this recording's, as one edit; the program's own resets it.

    Raises as `comparison_message` does, and JournalError where it cannot be kept.
    """
    names = _segment_files(opened)
    if other == AUTOMATIC:
        opened.apply(Reset())
    elif other in map(printable, names):
        name = next(name for name in names if printable(name) == other)
        opened.apply(taking_over(_filed(opened, name), opened.kept_labeling.segmentation))
    else:
        raise _unknown()


def _plain(times_s: Sequence[float]) -> list[float]:
    """Times as JSON takes them, which knows no numbers of numpy's."""
    return [float(time) for time in times_s]


def _unknown() -> RequestError:
    return RequestError("There is no such segment file beside this recording.")


def _segment_files(opened: Opened) -> Sequence[str]:
    """Names of segment files in the recording's folder; its own first."""
    path = opened.recording.path
    found = sorted(file.name for file in path.parent.glob(f"*{SUFFIX}"))
    own = stem_of(path) + SUFFIX
    found.sort(key=lambda name: (name != own, not name.startswith(stem_of(path))))
    return found[:MOST_FILES]


def _automatic(opened: Opened) -> Outline:
    return Outline.of_labeling(label(opened.kept_labeling.segmentation))


def _filed(opened: Opened, name: str) -> SegmentFile:
    """A segment file, which must be about the same bytes."""
    file = read_segment_file(opened.recording.path.parent / name, check_recording=False)
    source = opened.demonstration.source
    if source is None or file.demonstration.sha256 != source.sha256:
        raise KeyphaseError(
            f"{printable(name)} is about another recording than {opened.recording.name}; choose a "
            "segment file of this one."
        )
    return file
