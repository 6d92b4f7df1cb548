"""Another segmentation of the open recording beside the one that is shown."""

from collections.abc import Sequence
from typing import Any

from keyphase.errors import KeyphaseError, RequestError
from keyphase.labeling.comparison import Outline, compare
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import SUFFIX, read_segment_file
from keyphase.web.opened import Opened
from keyphase.web.recordings import printable

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
        raise RequestError("There is no such segment file beside this recording.")
    index = options.index(other)
    second = _automatic(opened) if index == 0 else _filed(opened, names[index - 1])
    result = compare(Outline.of_labeling(opened.kept_labeling), second)
    return {
        **message,
        "boundaries_s": list(second.boundaries_s),
        "labels": list(second.labels),
        "shared": [[pair.first_s, pair.second_s] for pair in result.shared],
        "only_first_s": list(result.only_first_s),
        "only_second_s": list(result.only_second_s),
        "f1": result.f1,
        "covering": result.covering,
        "same_label": result.same_label,
    }


def _segment_files(opened: Opened) -> Sequence[str]:
    """Names of segment files in the recording's folder; its own first."""
    path = opened.recording.path
    found = sorted(file.name for file in path.parent.glob(f"*{SUFFIX}"))
    own = path.stem + SUFFIX
    found.sort(key=lambda name: (name != own, not name.startswith(path.stem)))
    return found[:MOST_FILES]


def _automatic(opened: Opened) -> Outline:
    return Outline.of_labeling(label(opened.kept_labeling.segmentation))


def _filed(opened: Opened, name: str) -> Outline:
    """The outline of a segment file, which must be about the same bytes."""
    file = read_segment_file(opened.recording.path.parent / name, check_recording=False)
    source = opened.demonstration.source
    if source is None or file.demonstration.sha256 != source.sha256:
        raise KeyphaseError(
            f"{printable(name)} is about another recording than {opened.recording.name}; choose a "
            "segment file of this one."
        )
    return Outline.of_file(file)
