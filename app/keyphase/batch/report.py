"""What became of a batch, as lines for people and as JSON for machines."""

import json
from collections.abc import Iterator

from keyphase.batch.tasks import BatchReport


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
            yield f"{one.recording}:"
            yield from (f"  {notice}" for notice in one.notices)
