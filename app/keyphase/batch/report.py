"""What became of a batch, as lines for people and as JSON for machines."""

import json
from collections.abc import Iterator, Sequence
from itertools import groupby
from pathlib import Path

from keyphase.batch.tasks import BatchReport, Refusal
from keyphase.files.parts import split_part
from keyphase.printable import printable_line


def report_json(report: BatchReport) -> str:
    """Every recording with its segment file, notices and seconds, or the reason it was refused."""
    content = {
        "done": [
            {
                "recording": str(one.recording),
                "segment_file": str(one.segment_file),
                "notices": list(one.notices),
                "seconds": round(one.seconds, 3),
                "went_before": one.went_before,
            }
            for one in report.written
        ],
        "refused": [{"recording": str(one.path), "reason": one.reason} for one in report.refused],
    }
    return json.dumps(content, indent=1)


def report_lines(report: BatchReport) -> Iterator[str]:
    """What a person should know of each: the notices, under the recording's name."""
    for one in report.written:
        if one.notices:
            yield f"{printable_line(str(one.recording))}:"
            yield from (f"  {notice}" for notice in one.notices)


def refusal_lines(refused: Sequence[Refusal]) -> Iterator[str]:
    """Why each was refused; recordings of one file that were for one reason in one line."""

    def reason(refusal: Refusal) -> tuple[Path, str]:
        file, part = split_part(refusal.path)
        return file, refusal.reason if part is None else refusal.reason.replace(f"#{part}", "")

    for (file, _), group in groupby(refused, reason):
        first, *others = group
        likewise = f" ({len(others)} more of {file.name} likewise)" if others else ""
        yield f"{first.reason}{likewise}"
