"""The agreement of two people as a table for people and as JSON for machines."""

import json

from keyphase.labeling.comparing.agreement import Agreement, Disagreement

_SHOWN = 20


def agreement_table(found: Agreement) -> str:
    """One line for each recording, all together, then where they disagree, the worst first."""
    width = max([9, *(len(one.key) for one in found.recordings)])
    lines = [f"{'recording':{width}}  boundaries F1  same label  only first  only second"]
    for one in found.recordings:
        compared = one.comparison
        lines.append(
            f"{one.key:{width}}  {compared.f1:13.2f}  {compared.same_label:10.2f}  "
            f"{len(compared.only_first_s):10}  {len(compared.only_second_s):11}"
        )
    if found.f1 is not None and found.same_label is not None:
        lines.append(f"{'all':{width}}  {found.f1:13.2f}  {found.same_label:10.2f}")
    lines += [f"{key}: only in the first folder" for key in found.only_first]
    lines += [f"{key}: only in the second folder" for key in found.only_second]
    lines += [f"{key}: not compared: {why}" for key, why in found.refused]
    lines += ["", *map(_line, found.disagreements[:_SHOWN])]
    left = len(found.disagreements) - _SHOWN
    if left > 0:
        lines.append(f"and {left} more; all of them with --json")
    return "\n".join(lines).rstrip()


def agreement_json(found: Agreement) -> str:
    """Everything, as JSON."""
    return json.dumps(
        {
            "f1": found.f1,
            "same_label": found.same_label,
            "recordings": [
                {
                    "recording": one.key,
                    "f1": one.comparison.f1,
                    "same_label": one.comparison.same_label,
                    "covering": one.comparison.covering,
                    "only_first_s": list(one.comparison.only_first_s),
                    "only_second_s": list(one.comparison.only_second_s),
                }
                for one in found.recordings
            ],
            "only_first": list(found.only_first),
            "only_second": list(found.only_second),
            "refused": [{"recording": key, "why": why} for key, why in found.refused],
            "disagreements": disagreement_rows(found),
        },
        indent=1,
    )


def disagreement_rows(found: Agreement) -> list[dict[str, str | float]]:
    """A row for each disagreement, the recording with the least agreement first, for a queue."""
    return [
        {
            "recording": one.key,
            "start_s": one.start_s,
            "end_s": one.end_s,
            "first": one.first,
            "second": one.second,
        }
        for one in found.disagreements
    ]


def disagreement_table(found: Agreement) -> str:
    """The same rows with tabs between their columns, under a line of names."""
    rows = [
        (one.key, f"{one.start_s:.3f}", f"{one.end_s:.3f}", one.first, one.second)
        for one in found.disagreements
    ]
    named = [("recording", "start_s", "end_s", "first", "second"), *rows]
    return "\n".join("\t".join(row) for row in named)


def _line(one: Disagreement) -> str:
    if one.start_s == one.end_s:
        who = "first" if one.first else "second"
        return f"{one.key}  {one.start_s:.2f} s: a boundary of the {who} alone"
    return f"{one.key}  {one.start_s:.2f} to {one.end_s:.2f} s: “{one.first}” or “{one.second}”"
