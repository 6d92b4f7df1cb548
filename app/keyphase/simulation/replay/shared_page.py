"""What a shared replay says beside its film: recording, verdict, skills, timeline, versions."""

import platform
from collections.abc import Sequence
from html import escape

import numpy as np

from keyphase import __version__
from keyphase.demonstration import Demonstration
from keyphase.simulation.choosing import world_in_words
from keyphase.simulation.replay.result import ReplayResult
from keyphase.skills.execution.result import SkillResult, went_on
from keyphase.skills.skill import DISAGREES, Skill, until

WIDTH, BAR, FORCE = 1000.0, 18.0, 60.0
"""Of the timeline: its width, the height of its bars and of its force, in its own units."""

_MAX_POINTS = 500
_GOOD, _BAD, _NEUTRAL = "#0a7d55", "#b3261e", "#5b6472"

_STYLE = """
.keyphase{position:fixed;left:12px;bottom:12px;max-width:min(720px,calc(100vw - 24px));z-index:10;
max-height:55vh;overflow:auto;background:#fffffff2;color:#1c2430;border-radius:8px;
padding:12px 16px;font:13px/1.45 system-ui,sans-serif;box-shadow:0 2px 12px #0003}
.keyphase summary{font-weight:600;cursor:pointer}
.keyphase table{font:inherit}
.keyphase table{border-collapse:collapse;width:100%;margin:8px 0;font-variant-numeric:tabular-nums}
.keyphase td,.keyphase th{text-align:left;padding:2px 10px 2px 0;vertical-align:top;font-weight:400}
.keyphase th{color:#5b6472}.keyphase svg{width:100%;height:auto}.keyphase p{margin:6px 0}
"""


def with_summary(film: str, result: ReplayResult, demonstration: Demonstration) -> str:
    """The page of a film with a panel that says what it shows; all text in it is escaped.

    `demonstration` is what was replayed.
    """
    panel = f"<style>{_STYLE}</style>{summary(result, demonstration)}"
    before, end, after = film.rpartition("</body>")
    return f"{before}{panel}{end}{after}" if end else f"{film}{panel}"


def summary(result: ReplayResult, demonstration: Demonstration) -> str:
    """The panel itself."""
    color = _GOOD if result.succeeded else _BAD
    verdict = f'<b style="color:{color}">{escape(result.outcome())}</b>'
    workcell = world_in_words(str(result.demonstration.metadata.get("workcell", "")))
    about = (
        f"{demonstration.duration_s:.1f} s recorded, replayed in {escape(workcell)} in "
        f"{result.duration_s:.1f} s, at most {result.peak_force:.1f} N."
    )
    return (
        f'<details open class="keyphase"><summary>{escape(demonstration.name)}: {verdict}</summary>'
        f"<p>{about}</p>{_goals(result)}{timeline(result)}{_table(result)}"
        f'<p style="color:{_NEUTRAL}">{escape(_versions(result))}</p></details>'
    )


def timeline(result: ReplayResult) -> str:
    """The skills over the replay's time, and the size of the measured force under them (SVG)."""
    per_s = WIDTH / max(result.duration_s, 1e-9)
    bars = "".join(_bar(each, per_s) for each in result.results)
    picked = result.states[:: max(len(result.states) // _MAX_POINTS, 1)]
    force = np.array([np.linalg.norm(state.sample.force_N) for state in picked])
    most = max(float(force.max()), 1.0)
    points = " ".join(
        f"{state.elapsed_s * per_s:.1f},{BAR + 6 + FORCE * (1.0 - size / most):.1f}"
        for state, size in zip(picked, force.tolist(), strict=True)
    )
    return (
        f'<svg viewBox="0 0 {WIDTH:.0f} {BAR + FORCE + 22:.0f}" role="img" '
        f'aria-label="skills and force over time">{bars}'
        f'<polyline points="{points}" fill="none" stroke="#2b5fa8" stroke-width="1.5"/>'
        f'<text x="0" y="{BAR + FORCE + 19:.0f}" font-size="12">0 s</text>'
        f'<text x="{WIDTH:.0f}" y="{BAR + FORCE + 19:.0f}" font-size="12" text-anchor="end">'
        f"{result.duration_s:.1f} s, force up to {most:.1f} N</text></svg>"
    )


def _bar(each: SkillResult, per_s: float) -> str:
    start, width = each.start_s * per_s, max((each.end_s - each.start_s) * per_s - 2.0, 1.0)
    color = _GOOD if went_on(each) else _BAD
    return (
        f'<rect x="{start:.1f}" y="0" width="{width:.1f}" height="{BAR}" rx="3" fill="{color}">'
        f"<title>{escape(_printable(each.label))}</title></rect>"
        f'<text x="{start + 4:.1f}" y="13" font-size="12" fill="#fff">{each.skill + 1}</text>'
    )


def _table(result: ReplayResult) -> str:
    head = (
        "<tr><th></th><th>skill</th><th>ended</th><th>time</th><th>at most</th><th>until</th></tr>"
    )
    ended = {each.skill: each for each in result.results}
    rows = "".join(_row(k, skill, ended.get(k)) for k, skill in enumerate(result.skills))
    return f"<table>{head}{rows}</table>"


def _row(number: int, skill: Skill, each: SkillResult | None) -> str:
    doubt = f" ({DISAGREES})" if skill.agrees is False else ""
    cells: Sequence[str]
    if each is None:
        cells = ("not begun", "", "")
    else:
        time = f"{each.start_s:.2f} to {each.end_s:.2f} s"
        cells = (each.outcome or "stopped", time, f"{each.peak_force_N:.1f} N")
    texts = (str(number + 1), skill.label, *cells, until(skill) + doubt)
    return "<tr>" + "".join(f"<td>{escape(_printable(text))}</td>" for text in texts) + "</tr>"


def _goals(result: ReplayResult) -> str:
    marks = (f"{'✓' if holds else '✗'} {escape(name)}" for name, holds in result.checks.items())
    return f"<p>{' · '.join(marks)}</p>"


def _versions(result: ReplayResult) -> str:
    simulator = str(result.demonstration.metadata.get("simulator", ""))
    return f"keyphase {__version__}, {simulator}, Python {platform.python_version()}".strip(", ")


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)
