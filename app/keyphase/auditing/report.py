"""An audit as a table for people and as JSON for machines."""

import json
from collections.abc import Sequence

from keyphase.auditing.audit import Audited


def as_table(done: Sequence[Audited]) -> str:
    """A line for each recording, those whose labels agree least with keyphase first."""
    if not done:
        return "no labels were found"
    width = max(len(one.recording.name) for one in done)
    lines = [f"{'recording':{width}}  given  found  both    F1  same  timing  labels from"]
    for one in sorted(done, key=lambda one: one.comparison.f1):
        result = one.comparison
        both = len(result.shared)
        timing = "–" if one.timing_s is None else f"{1e3 * one.timing_s:.0f} ms"
        lines.append(
            f"{one.recording.name:{width}}  {both + len(result.only_first_s):5}  "
            f"{both + len(result.only_second_s):5}  {both:4}  {result.f1:.2f}  "
            f"{result.covering:.2f}  {timing:>6}  {one.given.source}"
        )
    return "\n".join(lines)


def as_json(done: Sequence[Audited]) -> str:
    """Every recording with the given segments and where the two differ; times in s."""
    content = [
        {
            "recording": str(one.recording),
            "source": one.given.source,
            "segments": [[s.start_s, s.end_s, s.label] for s in one.given.segments],
            "f1": one.comparison.f1,
            "covering": one.comparison.covering,
            "timing_s": one.timing_s,
            "only_given_s": list(one.comparison.only_first_s),
            "only_found_s": list(one.comparison.only_second_s),
        }
        for one in done
    ]
    return json.dumps(content, indent=1)
