"""Scoring segment files: one recording after the other, by sets, and all together."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from statistics import mean

from keyphase.errors import ScoreError
from keyphase.labeling.comparing.matching import covering
from keyphase.labeling.segment_file import SUFFIX, SegmentFile, read_segment_file
from keyphase.scoring.calibration import Calibration, calibration
from keyphase.scoring.counting import Tally, tally, together
from keyphase.scoring.judging import Claim, Verdict, judge
from keyphase.scoring.truth import Kind, Truth, read_truth


@dataclass(frozen=True)
class RecordingScore:
    """Score of one recording.

    tally     the strict count: every boundary against every event
    judged    only what the reference can judge
    covering  how well the segments cover the reference's; None where it has no events
    """

    key: str
    tally: Tally
    judged: Verdict
    covering: float | None
    duration_s: float

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
        """The strict counts of each set's recordings, taken together."""
        return self._of_sets(lambda each: each.tally)

    @property
    def judged_sets(self) -> dict[str, Tally]:
        """The judged counts of each set's recordings, taken together."""
        return self._of_sets(lambda each: each.judged.tally)

    @property
    def macro_f1(self) -> float | None:
        """Mean strict F1 of the sets that have events; None where none has."""
        return _macro(self.sets.values())

    @property
    def judged_macro_f1(self) -> float | None:
        """Mean judged F1 of the sets that have events; None where none has."""
        return _macro(self.judged_sets.values())

    @property
    def calibration(self) -> Calibration:
        """Of the confidences of all judged boundaries."""
        return calibration([o for each in self.recordings for o in each.judged.outcomes])

    @property
    def calibration_of_sets(self) -> dict[str, Calibration]:
        """The same for each set."""
        return {
            name: calibration([outcome for each in group for outcome in each.judged.outcomes])
            for name, group in self.grouped.items()
        }

    @property
    def grouped(self) -> dict[str, list[RecordingScore]]:
        """The recordings of each set."""
        groups: dict[str, list[RecordingScore]] = {}
        for recording in self.recordings:
            groups.setdefault(recording.set_name, []).append(recording)
        return groups

    def kinds(self, name: str) -> dict[Kind, Tally]:
        """Counts of contact changes and of motion alone in a set, where its references tell."""
        each = [recording.judged.kinds for recording in self.grouped[name]]
        if not all(each):
            return {}
        return {kind: together([kinds[kind] for kinds in each]) for kind in each[0]}

    def _of_sets(self, of: Callable[[RecordingScore], Tally]) -> dict[str, Tally]:
        return {name: together([of(r) for r in group]) for name, group in self.grouped.items()}


def unjudged_per_minute(recordings: Iterable[RecordingScore]) -> float:
    """Boundaries that nobody judged, per minute of these recordings."""
    chosen = list(recordings)
    minutes = sum(each.duration_s for each in chosen) / 60.0
    return sum(each.judged.tally.ignored for each in chosen) / max(minutes, 1e-9)


def score(truth: Path, segments: Path) -> Score:
    """Score a folder of segment files, or one of them, against a reference (docs/scoring.md).

    In a folder the segment file of a recording is KEY.segments.json; one file belongs to the key
    its path ends with, or else to the only key of its name. Raises ScoreError where the reference
    is malformed or nothing matches, SegmentFileError for a malformed segment file.
    """
    truths = read_truth(truth)
    files = _in_folder(truths, segments) if segments.is_dir() else _one_file(truths, segments)
    if not files:
        raise ScoreError(
            f"{segments}: expected segment files such as {next(iter(truths))}{SUFFIX}, but found "
            "none; name the folder they were written to."
        )
    scored = tuple(
        score_recording(key, truths[key], *_claims(read_segment_file(path, check_recording=False)))
        for key, path in files.items()
    )
    return Score(scored, tuple(key for key in truths if key not in files))


def score_recording(
    key: str, truth: Truth, claims: list[Claim], span_s: tuple[float, float]
) -> RecordingScore:
    """The score of one recording that lasts from `span_s[0]` to `span_s[1]`."""
    found = [claim.time_s for claim in claims]
    cover = covering(truth.events_s, found, span_s) if truth.events_s else None
    judged = judge(truth.judged, claims)
    return RecordingScore(key, tally(truth, found), judged, cover, span_s[1] - span_s[0])


def _claims(file: SegmentFile) -> tuple[list[Claim], tuple[float, float]]:
    claims = [
        Claim(b.time_s, b.contact_change, b.confidence, b.origin != "force")
        for b in file.boundaries
    ]
    return claims, (file.segments[0].start_s, file.segments[-1].end_s)


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


def _macro(tallies: Iterable[Tally]) -> float | None:
    values = [t.f1 for t in tallies if t.recall is not None and t.f1 is not None]
    return mean(values) if values else None
