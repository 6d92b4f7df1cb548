"""The results of trials as a picture: SVG, for a page and for a document alike."""

from collections.abc import Iterator
from html import escape

import numpy as np

from keyphase.simulation.replay.report import trials_outcome
from keyphase.simulation.replay.trials import Trial, Trials

WIDTH, HEIGHT = 960, 420
GOOD, BAD = "#1098ad", "#e8590c"
OUTCOME_COLORS = {
    "contact": "#1098ad",
    "reached": "#74c0fc",
    "timeout": "#ffa94d",
    "too far": "#f76707",
    "unexpected contact": "#c92a2a",
    "stopped": "#868e96",
    "not begun": "#ced4da",
}

_LEFT, _TOP, _PLOT_WIDTH, _PLOT_HEIGHT = 64, 92, 400, 252
_BARS_LEFT, _BARS_WIDTH = 738, 198
_INK, _FAINT = "#343a40", "#dee2e6"


def trials_svg(trials: Trials, title: str) -> str:
    """Peak force over part height, one mark for each world, beside how the skills ended.

    Text is dark on white, so that it reads the same in light and dark surroundings.
    """
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
        f'width="{WIDTH}" height="{HEIGHT}" font-family="system-ui, sans-serif" font-size="13">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
        _text(_LEFT, 28, title, weight="600", size=16),
        _text(_LEFT, 50, trials_outcome(trials)),
        *_scatter(trials),
        *_bars(trials),
        "</svg>",
    ]
    return "\n".join(parts) + "\n"


def _scatter(trials: Trials) -> Iterator[str]:
    heights = np.array([1e3 * t.world.disturbance.part_height_m for t in trials.trials])
    reach = 2.0 * max(1.0, float(np.ceil(abs(heights).max() / 2.0)))
    most = 5.0 * max(1.0, float(np.ceil(trials.peak_forces().max() / 5.0)))
    for force in np.arange(0.0, most + 1.0, 5.0):
        y = _down(force, most)
        yield _line(_LEFT, y, _LEFT + _PLOT_WIDTH, y, _FAINT)
        yield _text(_LEFT - 8, y + 4, f"{force:g}", anchor="end")
    for height in np.linspace(-reach, reach, 5):
        x = _across(height, reach)
        yield _line(x, _TOP + _PLOT_HEIGHT, x, _TOP + _PLOT_HEIGHT + 5, _INK)
        yield _text(x, _TOP + _PLOT_HEIGHT + 20, f"{height:g}", anchor="middle")
    for trial, height in zip(trials.trials, heights, strict=True):
        yield _mark(_across(height, reach), _down(trial.peak_force_N, most), trial)
    yield _text(_LEFT + _PLOT_WIDTH / 2, HEIGHT - 34, "part height [mm]", anchor="middle")
    yield _text(_LEFT - 40, _TOP - 14, "peak force [N]")
    yield _legend(_LEFT, HEIGHT - 12, [("succeeded", GOOD), ("failed", BAD)])


def _mark(x: float, y: float, trial: Trial) -> str:
    color = GOOD if trial.succeeded else BAD
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.2" fill="{color}" fill-opacity="0.7"/>'


def _bars(trials: Trials) -> Iterator[str]:
    """One bar for each skill, divided by how it ended."""
    count = max(len(trials.labels), 1)
    pitch = min(44.0, _PLOT_HEIGHT / count)
    seen = [o for o in OUTCOME_COLORS if any(trials.outcomes(i)[o] for i in range(count))]
    yield _text(_BARS_LEFT, _TOP - 14, "how the skills ended")
    for index, label in enumerate(trials.labels):
        y = _TOP + index * pitch
        shown = label if len(label) <= 32 else label[:31] + "…"
        yield _text(_BARS_LEFT - 10, y + 0.5 * pitch + 4, shown, anchor="end")
        x = float(_BARS_LEFT)
        for outcome in seen:
            wide = _BARS_WIDTH * trials.outcomes(index)[outcome] / len(trials.trials)
            yield (
                f'<rect x="{x:.1f}" y="{y + 0.15 * pitch:.1f}" width="{wide:.1f}" '
                f'height="{0.7 * pitch:.1f}" fill="{OUTCOME_COLORS[outcome]}"/>'
            )
            x += wide
    yield _legend(_BARS_LEFT - 206, HEIGHT - 12, [(o, OUTCOME_COLORS[o]) for o in seen])


def _legend(left: float, y: float, entries: list[tuple[str, str]]) -> str:
    parts, x = [], left
    for name, color in entries:
        parts.append(f'<rect x="{x:.1f}" y="{y - 9}" width="10" height="10" fill="{color}"/>')
        parts.append(_text(x + 15, y, name))
        x += 32 + 7.0 * len(name)
    return "\n".join(parts)


def _across(height_mm: float, reach: float) -> float:
    return _LEFT + _PLOT_WIDTH * (height_mm + reach) / (2.0 * reach)


def _down(force_N: float, most: float) -> float:
    return _TOP + _PLOT_HEIGHT * (1.0 - force_N / most)


def _line(x1: float, y1: float, x2: float, y2: float, color: str) -> str:
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}"/>'


def _text(
    x: float, y: float, text: str, *, anchor: str = "start", weight: str = "400", size: int = 13
) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-weight="{weight}" '
        f'font-size="{size}" fill="{_INK}">{escape(_plain(text))}</text>'
    )


def _plain(text: str) -> str:
    """Without the characters that XML cannot hold at all."""
    return "".join(c if c.isprintable() else " " for c in text)
