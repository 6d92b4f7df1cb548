"""Scoring segment files against reference events that people or controllers noted."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from statistics import mean, median
from typing import Any

from keyphase.errors import ScoreError
from keyphase.labeling.matching import covering, match_times
from keyphase.labeling.segment_file import SUFFIX, SegmentFile, read_segment_file


@dataclass(frozen=True)
class Truth:
    """What is known of one recording.

    events_s     times of the reference events
    ignore_s     intervals in which an unmatched boundary counts neither way
    tolerance_s  how far a boundary may be from an event and still be its own
    """

    events_s: tuple[float, ...]
    ignore_s: tuple[tuple[float, float], ...]
    tolerance_s: float


@dataclass(frozen=True)
class Tally:
    """Counts of boundaries, and the distances of the matched ones from their events [s].

    found, missed   events with and without a boundary of their own
    false, ignored  boundaries without an event, outside and inside the intervals to ignore
    """

    found: int
    missed: int
    false: int
    ignored: int
    distances_s: tuple[float, ...]

    @property
    def precision(self) -> float | None:
        """Part of the boundaries that belong to an event; None without boundaries."""
        return _ratio(self.found, self.found + self.false)

    @property
    def recall(self) -> float | None:
        """Part of the events that have a boundary; None without events."""
        return _ratio(self.found, self.found + self.missed)

    @property
    def f1(self) -> float | None:
        """Harmonic mean of precision and recall; None without boundaries and events."""
        return _ratio(2 * self.found, 2 * self.found + self.false + self.missed)

    @property
    def timing_error_s(self) -> float | None:
        """Median distance of the matched boundaries from their events; None without any."""
        return median(self.distances_s) if self.distances_s else None


@dataclass(frozen=True)
class RecordingScore:
    """Score of one recording; `covering` is None where the reference has no events."""

    key: str
    tally: Tally
    covering: float | None

    @property
    def set_name(self) -> str:
        """The first folder of the key; "." where it has none."""
        folder, separator, _ = self.key.partition("/")
        return folder if separator else "."


@dataclass(frozen=True)
class Score:
    """Scores of all recordings for which there was a segment file; `missing` are the others."""

    recordings: tuple[RecordingScore, ...]
    missing: tuple[str, ...]

    @property
    def sets(self) -> dict[str, Tally]:
        """The counts of each set's recordings, taken together."""
        groups: dict[str, list[Tally]] = {}
        for recording in self.recordings:
            groups.setdefault(recording.set_name, []).append(recording.tally)
        return {name: _together(tallies) for name, tallies in groups.items()}

    @property
    def macro_f1(self) -> float | None:
        """Mean F1 of the sets that have events; None where none has."""
        values = [t.f1 for t in self.sets.values() if t.recall is not None and t.f1 is not None]
        return mean(values) if values else None

    def as_json(self) -> str:
        """Everything, for machines; null where a figure is undefined."""
        content = {
            "macro_f1": self.macro_f1,
            "sets": {name: _figures(tally) for name, tally in self.sets.items()},
            "recordings": {
                each.key: {**_figures(each.tally), "covering": each.covering}
                for each in self.recordings
            },
            "missing": list(self.missing),
        }
        return json.dumps(content, indent=1, ensure_ascii=False)

    def as_text(self) -> str:
        """A table for people."""
        names = [each.key for each in self.recordings] + list(self.sets)
        width = max(len("recording"), *map(len, names))
        lines = [_HEADER.format("recording", width=width)]
        lines += [_line(each.key, each.tally, each.covering, width) for each in self.recordings]
        lines += ["", _HEADER.format("set", width=width)]
        lines += [_line(name, tally, None, width) for name, tally in self.sets.items()]
        lines += ["", f"macro F1 over sets with events: {_shown(self.macro_f1)}"]
        if self.missing:
            lines.append(f"without a segment file: {', '.join(self.missing)}")
        return "\n".join(lines)


def score(truth: Path, segments: Path) -> Score:
    """Score a folder of segment files, or one of them, against a reference.

    `truth` is a JSON object that gives for each recording, by a key such as `set/name`, its
    `events` ([time_s, label]), `tolerance_s` and `ignore` intervals. In a folder the segment file
    of a recording is KEY.segments.json; one file belongs to the key its path ends with, or else
    to the only key of its name. Raises ScoreError where the reference is malformed or nothing
    matches, SegmentFileError for a malformed segment file.
    """
    truths = read_truth(truth)
    files = _in_folder(truths, segments) if segments.is_dir() else _one_file(truths, segments)
    if not files:
        raise ScoreError(
            f"{segments}: expected segment files such as {next(iter(truths))}{SUFFIX}, but found "
            "none; name the folder they were written to."
        )
    scored = tuple(
        RecordingScore(key, *_scored(truths[key], read_segment_file(path, check_recording=False)))
        for key, path in files.items()
    )
    return Score(scored, tuple(key for key in truths if key not in files))


def tally(truth: Truth, found_s: Sequence[float]) -> Tally:
    """Count what boundaries at `found_s` are worth against a reference."""
    matches = match_times(truth.events_s, found_s, truth.tolerance_s)
    matched = {match.found for match in matches}
    others = [time for i, time in enumerate(found_s) if i not in matched]
    ignored = sum(any(a <= time <= b for a, b in truth.ignore_s) for time in others)
    return Tally(
        found=len(matches),
        missed=len(truth.events_s) - len(matches),
        false=len(others) - ignored,
        ignored=ignored,
        distances_s=tuple(abs(truth.events_s[m.reference] - found_s[m.found]) for m in matches),
    )


def read_truth(path: Path) -> dict[str, Truth]:
    """The references in a truth.json, by key. Raises ScoreError where it is malformed."""
    try:
        content = json.loads(path.read_bytes())
    except OSError as error:
        raise ScoreError(f"{path}: cannot be read ({error.strerror}); check the path.") from error
    except (ValueError, RecursionError) as error:
        raise ScoreError(f"{path}: expected JSON, but it cannot be parsed ({error}).") from error
    if not isinstance(content, dict) or not content:
        raise ScoreError(f"{path}: expected a JSON object with an entry for each recording.")
    for key in content:
        if Path(key).is_absolute() or ".." in Path(key).parts:
            raise ScoreError(f"{path}: expected keys such as set/name, but got {key!r}.")
    return {key: _truth(path, key, entry) for key, entry in content.items()}


def _truth(path: Path, key: str, entry: Any) -> Truth:
    try:
        truth = Truth(
            tuple(sorted(float(event[0]) for event in entry["events"])),
            tuple((float(low), float(high)) for low, high in entry.get("ignore", ())),
            float(entry["tolerance_s"]),
        )
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise ScoreError(
            f"{path}: {key} must have events [[time_s, label], …], ignore [[from_s, to_s], …] and "
            f"tolerance_s, but they cannot be read ({type(error).__name__}: {error})."
        ) from error
    numbers = [*truth.events_s, *sum(truth.ignore_s, ()), truth.tolerance_s]
    if not all(map(isfinite, numbers)) or truth.tolerance_s < 0:
        raise ScoreError(f"{path}: the times of {key} must be finite, its tolerance not negative.")
    return truth


def _in_folder(truths: Mapping[str, Truth], folder: Path) -> dict[str, Path]:
    paths = {key: folder / f"{key}{SUFFIX}" for key in truths}
    return {key: path for key, path in paths.items() if path.is_file()}


def _one_file(truths: Mapping[str, Truth], path: Path) -> dict[str, Path]:
    name = path.absolute().as_posix().removesuffix(SUFFIX)
    exact = [key for key in truths if name.endswith(f"/{key}")]
    last = [key for key in truths if key.rpartition("/")[2] == name.rpartition("/")[2]]
    keys = exact or last
    if len(keys) != 1:
        which = f"could be any of {', '.join(keys)}" if keys else "is none of the reference's"
        raise ScoreError(
            f"{path}: expected a segment file named KEY{SUFFIX}, but it {which}; put it into a "
            "folder of the set's name."
        )
    return {keys[0]: path}


def _scored(truth: Truth, file: SegmentFile) -> tuple[Tally, float | None]:
    found = [boundary.time_s for boundary in file.boundaries]
    span = (file.segments[0].start_s, file.segments[-1].end_s)
    cover = covering(truth.events_s, found, span) if truth.events_s else None
    return tally(truth, found), cover


def _together(tallies: Sequence[Tally]) -> Tally:
    return Tally(
        found=sum(each.found for each in tallies),
        missed=sum(each.missed for each in tallies),
        false=sum(each.false for each in tallies),
        ignored=sum(each.ignored for each in tallies),
        distances_s=tuple(distance for each in tallies for distance in each.distances_s),
    )


def _ratio(part: int, whole: int) -> float | None:
    return part / whole if whole else None


def _figures(tally: Tally) -> dict[str, Any]:
    return {
        "precision": tally.precision,
        "recall": tally.recall,
        "f1": tally.f1,
        "timing_error_s": tally.timing_error_s,
        "found": tally.found,
        "missed": tally.missed,
        "false": tally.false,
        "ignored": tally.ignored,
    }


_COLUMNS = ("precision", "recall", "F1", "timing ms", "found", "missed", "false", "covering")
_HEADER = "{:<{width}}" + "".join(f"{name:>11}" for name in _COLUMNS)


def _line(name: str, tally: Tally, cover: float | None, width: int) -> str:
    timing = None if tally.timing_error_s is None else f"{1e3 * tally.timing_error_s:.0f}"
    cells = [
        _shown(tally.precision),
        _shown(tally.recall),
        _shown(tally.f1),
        timing or "–",
        str(tally.found),
        str(tally.missed),
        str(tally.false),
        _shown(cover),
    ]
    return f"{name:<{width}}" + "".join(f"{cell:>11}" for cell in cells)


def _shown(value: float | None) -> str:
    return "–" if value is None else f"{value:.3f}"
