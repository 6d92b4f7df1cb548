"""What a batch does: recordings, where their segment files go, and what became of each."""

import os
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from keyphase.errors import ParameterError, SegmentFileError
from keyphase.files.parts import stem_of
from keyphase.labeling.segment_file import SUFFIX
from keyphase.readers import Found

_SHARD = re.compile(r"(\d{1,9})/(\d{1,9})")


@dataclass(frozen=True)
class Written:
    """A recording and the segment file that was written for it.

    notices      what was done to the numbers on reading
    seconds      how long reading, segmenting and writing took
    went_before  it was done by an earlier run and is as it was
    known_by     by what a later run sees that nothing has changed since, as the manifest says it
    """

    recording: Path
    segment_file: Path
    notices: tuple[str, ...] = ()
    seconds: float = 0.0
    went_before: bool = False
    known_by: Mapping[str, Any] = field(default_factory=dict[str, Any], compare=False)


@dataclass(frozen=True)
class Refusal:
    """A recording that was refused, and why."""

    path: Path
    reason: str


@dataclass(frozen=True)
class BatchReport:
    """What became of the recordings, each list in the order they were found."""

    written: tuple[Written, ...]
    refused: tuple[Refusal, ...]


def report_of(results: Iterable[Written | Refusal]) -> BatchReport:
    """The results of a batch, told apart."""
    every = tuple(results)
    return BatchReport(
        tuple(result for result in every if isinstance(result, Written)),
        tuple(result for result in every if isinstance(result, Refusal)),
    )


def tasks_of(found: Iterable[Found], output: Path) -> list[Written]:
    """What is to be written where; two recordings for one file are refused."""
    tasks: dict[str, Written] = {}
    for recording, relative in found:
        target = output / relative.with_name(stem_of(relative) + SUFFIX)
        other = tasks.setdefault(os.path.normcase(target), Written(recording, target))
        if other.recording != recording:
            raise SegmentFileError(
                f"{other.recording} and {recording} would both be written to {target}; segment "
                "them into different folders."
            )
    return list(tasks.values())


def shard_of(tasks: list[Written], shard: str | None) -> list[Written]:
    """Every n-th task, `3/16` being the third of sixteen machines; all of them together are all.

    Raises ParameterError for what is no such fraction.
    """
    if shard is None:
        return tasks
    match = _SHARD.fullmatch(shard)
    number, count = (int(match[1]), int(match[2])) if match else (0, 0)
    if not 1 <= number <= count:
        raise ParameterError(f"A shard must be such as 3/16, from 1/16 to 16/16, but is {shard!r}.")
    return tasks[number - 1 :: count]
