"""How well two people agree about a folder of recordings, and where they do not."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from keyphase.errors import LabelingError
from keyphase.labeling.comparing.comparison import (
    DEFAULT_TOLERANCE_S,
    Comparison,
    Outline,
    compare,
    label_at,
)
from keyphase.labeling.segment_file import SUFFIX, SegmentFile, read_segment_file

MIN_STRETCH_S = 0.1
"""Other names for less than this follow from boundaries that lie a little apart."""


@dataclass(frozen=True)
class Disagreement:
    """A boundary that only one has (then it lasts no time), or a stretch with two names.

    first, second  what each says: "boundary" or "" of a boundary, else the label
    """

    key: str
    start_s: float
    end_s: float
    first: str
    second: str


@dataclass(frozen=True)
class RecordingAgreement:
    """How two people agree about one recording; `key` is its place in both folders."""

    key: str
    duration_s: float
    comparison: Comparison
    disagreements: tuple[Disagreement, ...]


@dataclass(frozen=True)
class Agreement:
    """How two people agree about all recordings both have a segment file of.

    only_first, only_second  keys of recordings the other has no segment file of
    refused                  why a pair cannot be compared, by key
    """

    recordings: tuple[RecordingAgreement, ...]
    only_first: tuple[str, ...]
    only_second: tuple[str, ...]
    refused: tuple[tuple[str, str], ...]

    @property
    def f1(self) -> float | None:
        """Of all boundaries together; 1 where neither has any, None without recordings."""
        if not self.recordings:
            return None
        each = [one.comparison for one in self.recordings]
        shared = sum(len(one.shared) for one in each)
        alone = sum(len(one.only_first_s) + len(one.only_second_s) for one in each)
        return 2 * shared / (2 * shared + alone) if shared + alone else 1.0

    @property
    def same_label(self) -> float | None:
        """Part of all time in which both have the same label; None without recordings."""
        total = sum(one.duration_s for one in self.recordings)
        if not total:
            return None
        same = sum(one.duration_s * one.comparison.same_label for one in self.recordings)
        return same / total

    @property
    def disagreements(self) -> tuple[Disagreement, ...]:
        """All of them, those of the recording with the least agreement first."""
        worst = sorted(
            self.recordings, key=lambda one: (one.comparison.same_label, one.comparison.f1)
        )
        return tuple(each for one in worst for each in one.disagreements)


def agreement(first: Path, second: Path, tolerance_s: float = DEFAULT_TOLERANCE_S) -> Agreement:
    """Compare two folders of segment files of the same recordings, by their names.

    A pair that cannot be compared stops nothing. Raises LabelingError where a folder is missing,
    and where they have no segment file in common.
    """
    ours, theirs = _files_in(first), _files_in(second)
    both = [key for key in ours if key in theirs]
    if not both:
        raise LabelingError(
            f"Expected segment files of the same names (such as NAME{SUFFIX}) in {first} and "
            f"{second}, but they share none; name the folders two people's files were written to."
        )
    found: list[RecordingAgreement] = []
    refused: list[tuple[str, str]] = []
    for key in both:
        try:
            found.append(_of_pair(key, ours[key], theirs[key], tolerance_s))
        except LabelingError as error:
            refused.append((key, str(error)))
    alone = tuple(key for key in ours if key not in theirs)
    return Agreement(
        tuple(found), alone, tuple(key for key in theirs if key not in ours), tuple(refused)
    )


def disagreements(
    key: str, first: Outline, second: Outline, comparison: Comparison
) -> Iterator[Disagreement]:
    """What two segmentations of one recording do not share, in its order."""
    found = [Disagreement(key, t, t, "boundary", "") for t in comparison.only_first_s]
    found += [Disagreement(key, t, t, "", "boundary") for t in comparison.only_second_s]
    edges = sorted({*first.span_s, *first.boundaries_s, *second.boundaries_s})
    for low, high in pairwise(edges):
        middle = 0.5 * (low + high)
        names = label_at(first, middle), label_at(second, middle)
        if names[0] != names[1] and high - low >= MIN_STRETCH_S:
            found.append(Disagreement(key, low, high, *names))
    yield from sorted(found, key=lambda one: (one.start_s, one.end_s))


def _of_pair(key: str, first: Path, second: Path, tolerance_s: float) -> RecordingAgreement:
    ours, theirs = _read(first), _read(second)
    if ours.demonstration.sha256 != theirs.demonstration.sha256:
        raise LabelingError(
            f"Expected two segmentations of one recording, but {first} and {second} are about "
            "different files of the same name; compare folders of the same recordings."
        )
    a, b = Outline.of_file(ours), Outline.of_file(theirs)
    compared = compare(a, b, tolerance_s)
    return RecordingAgreement(
        key, a.span_s[1] - a.span_s[0], compared, tuple(disagreements(key, a, b, compared))
    )


def _read(path: Path) -> SegmentFile:
    return read_segment_file(path, check_recording=False)


def _files_in(folder: Path) -> dict[str, Path]:
    """Segment files below a folder by their key. Raises LabelingError where it is missing."""
    if not folder.is_dir():
        what = "is a file" if folder.exists() else "does not exist"
        raise LabelingError(
            f"Expected a folder of segment files, but {folder} {what}; name the folder that a "
            "person's files were written to."
        )
    found = sorted(folder.rglob(f"*{SUFFIX}"))
    return {path.relative_to(folder).as_posix().removesuffix(SUFFIX): path for path in found}
