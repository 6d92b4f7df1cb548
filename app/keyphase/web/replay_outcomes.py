"""What became of each skill of a replay, as a table of viser's panel."""

from html import escape

from keyphase.simulation.replay.result import SkillResult, went_on
from keyphase.web.protocol.document_message import unmeasured
from keyphase.web.scene.replay_view import Running

_GOOD, _BAD, _NOW = (
    "light-dark(#2b8a3e, #69db7c)",
    "light-dark(#c92a2a, #ff8787)",
    "light-dark(#1864ab, #a5d8ff)",
)
_TABLE = (
    "width: 100%; table-layout: fixed; border-collapse: collapse; padding: 0 4px; font-size: 12px; "
    "line-height: 21px; font-variant-numeric: tabular-nums; white-space: nowrap"
)
_FAINT = "font-weight: 600; opacity: .75"
_HEAD = (
    ("Skill", "38%", "left"),
    ("Outcome", "25%", "left"),
    ("Time", "19%", "right"),
    ("Peak", "18%", "right"),
)
_CUT = "overflow: hidden; text-overflow: ellipsis"


def outcome_table(running: Running) -> str:
    """A row for each skill that began: its outcome, how long it took, its largest force.

    HTML; what people wrote is escaped.
    """
    results = running.run.replay.results
    rows = [_row(running, result) for result in results]
    if running.phase != "over" and len(results) < len(running.plan.planned):
        rows.append(_cells(_name(running, len(results)), _colored(running.phase, _NOW), "", ""))
    head = "".join(
        f'<th style="width: {width}; text-align: {side}; {_FAINT}">{title}</th>'
        for title, width, side in _HEAD
    )
    table = f'<table style="{_TABLE}"><tr>{head}</tr>{"".join(rows)}</table>'
    return f'<div style="padding: 0 8px 4px">{table}{_verdict(running)}</div>'


def _row(running: Running, result: SkillResult) -> str:
    outcome = _colored(result.outcome or "stopped", _GOOD if went_on(result) else _BAD)
    took_s = result.end_s - result.start_s
    return _cells(
        _name(running, result.skill), outcome, f"{took_s:.2f} s", f"{result.peak_force_N:.1f} N"
    )


def _cells(name: str, outcome: str, time: str, peak: str) -> str:
    return (
        f'<tr><td style="{_CUT}">{name}</td><td style="{_CUT}">{outcome}</td>'
        f'<td style="text-align: right">{time}</td><td style="text-align: right">{peak}</td></tr>'
    )


def _name(running: Running, skill: int) -> str:
    """Number and short label, the whole label under the pointer."""
    planned = running.plan.planned[skill]
    label = planned.skill.label
    if planned.segment is None:
        return f'<span title="{escape(label)}">connect</span>'
    short = unmeasured(label).removeprefix("Move ")
    name = f"{planned.segment + 1} {short[:1].upper()}{short[1:]}"
    return f'<span title="{escape(label)}">{escape(name)}</span>'


def _verdict(running: Running) -> str:
    if running.result is None:
        return ""
    verdict = ("Success", _GOOD) if running.result.succeeded else ("No success", _BAD)
    goals = ", ".join(
        f"{escape(name)} {'✓' if holds else '✗'}" for name, holds in running.result.checks.items()
    )
    return (
        '<div style="margin-top: 6px; font-size: 12px; line-height: 18px">'
        f"<b>{_colored(*verdict)}</b>: {goals}</div>"
    )


def _colored(text: str, color: str) -> str:
    return f'<span style="color: {color}" title="{escape(text)}">{escape(text)}</span>'
