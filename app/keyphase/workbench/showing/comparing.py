"""Another segmentation of the open recording beside the one that is shown."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from statistics import median

from keyphase.auditing import GivenLabels, given_labels, taking_over_given
from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError, RequestError
from keyphase.files.parts import stem_of
from keyphase.labeling.comparing.comparison import Comparison as ComparisonResult
from keyphase.labeling.comparing.comparison import Outline, compare
from keyphase.labeling.comparing.taking_over import taking_over
from keyphase.labeling.edits import Reset, TakeOver
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import SUFFIX, SegmentFile, read_segment_file
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.recordings import printable
from keyphase.workbench.showing.found_now import NOW

AUTOMATIC = "automatic"
"""Compare with what the program found, without anybody's edits."""

PROPOSED = "proposed"
"""Compare with what is proposed from other recordings that are done."""

SECOND = "another person"
"""Compare with another person's segment file of the same recording."""

GIVEN = "given"
"""Compare with the labels that others left in the recording's own file."""

MAX_FILES = 50
"""So many segment files of a folder are offered."""


@dataclass(frozen=True)
class Comparison:
    """With what a recording can be compared, and how one of these agrees with what is kept."""

    options: tuple[str, ...]
    other: str | None = None
    outline: Outline | None = None
    result: ComparisonResult | None = None

    @property
    def timing_s(self) -> float | None:
        """Median distance of shared boundaries; None where there are none."""
        pairs = self.result.shared if self.result else ()
        return float(median(abs(pair.distance_s) for pair in pairs)) if pairs else None


def comparison(
    state: DeskState,
    other: str | None,
    proposed: Outline | None = None,
    second: SegmentFile | None = None,
) -> Comparison:
    """With what the recording can be compared, and how `other` agrees.

    `other` is None, "automatic", "found now" for a recording that is done, "given" where its own
    file holds labels, "proposed" where something is, "another person" where there is one, or the
    name of a segment file beside the recording. Raises RequestError for a name that is not offered,
    SegmentFileError and LabelingError for a file that cannot be compared.
    """
    names = _segment_files(state)
    ours = {AUTOMATIC: lambda: _automatic(state)}
    if (now := state.found_now) is not None:
        ours[NOW] = lambda: Outline.of_labeling(now)
    given = _given(state.recording.path, state.demonstration)
    if given is not None:
        ours[GIVEN] = lambda: given.outline
    if proposed is not None:
        ours[PROPOSED] = lambda: proposed
    if second is not None:
        ours[SECOND] = lambda: Outline.of_file(_same_bytes(state, second))
    options = (*ours, *map(printable, names))
    if other is None:
        return Comparison(options)
    if other not in options:
        raise _unknown()
    if other in ours:
        outline = ours[other]()
    else:
        file = names[options.index(other) - len(ours)]
        outline = Outline.of_file(_filed(state, file))
    result = compare(Outline.of_labeling(state.kept_labeling), outline)
    return Comparison(options, other, outline, result)


def take_over(opened: OpenRecording, other: str) -> None:
    """Make another segmentation this recording's, as one edit; the program's own resets it.

    Raises as `comparison_message` does, and JournalError where it cannot be kept.
    """
    names = _segment_files(opened)
    if other == AUTOMATIC:
        opened.apply(Reset())
    elif other == NOW:
        opened.mark_done(False)
    elif other == GIVEN:
        _take_given(opened)
    elif other in map(printable, names):
        name = next(name for name in names if printable(name) == other)
        opened.apply(taking_over(_filed(opened, name), opened.kept_labeling.segmentation))
    else:
        raise _unknown()


def _take_given(opened: OpenRecording) -> None:
    given = _given(opened.recording.path, opened.demonstration)
    if given is None:
        raise _unknown()
    opened.apply(taking_over_given(opened.kept_labeling.segmentation, given))


@lru_cache(maxsize=8)
def _given(recording: Path, demonstration: Demonstration) -> GivenLabels | None:
    """The labels in the recording's own file; None where there are none, or none can be read."""
    try:
        return given_labels(recording, demonstration)
    except KeyphaseError:
        return None


def _unknown() -> RequestError:
    return RequestError("There is no such segment file beside this recording.")


def _segment_files(opened: DeskState | OpenRecording) -> Sequence[str]:
    """Names of segment files in the recording's folder; its own first."""
    path = opened.recording.path
    found = sorted(file.name for file in path.parent.glob(f"*{SUFFIX}"))
    own = stem_of(path) + SUFFIX
    found.sort(key=lambda name: (name != own, not name.startswith(stem_of(path))))
    return found[:MAX_FILES]


def _automatic(opened: DeskState | OpenRecording) -> Outline:
    return Outline.of_labeling(label(opened.kept_labeling.segmentation))


def _filed(opened: DeskState | OpenRecording, name: str) -> SegmentFile:
    """A segment file, which must be about the same bytes."""
    file = read_segment_file(opened.recording.path.parent / name, check_recording=False)
    return _same_bytes(opened, file, printable(name))


def of_another(state: DeskState, file: SegmentFile) -> TakeOver:
    """What makes another person's segments the recording's own. Raises KeyphaseError likewise."""
    return taking_over(_same_bytes(state, file), state.kept_labeling.segmentation)


def _same_bytes(
    opened: DeskState | OpenRecording, file: SegmentFile, name: str = "The other person's file"
) -> SegmentFile:
    source = opened.demonstration.source
    if source is None or file.demonstration.sha256 != source.sha256:
        raise KeyphaseError(
            f"{name} is about another recording than {opened.recording.name}; choose a "
            "segment file of this one."
        )
    return file
