"""The comparison as one table in Markdown, and as pictures."""

from collections.abc import Mapping
from pathlib import Path
from statistics import mean
from typing import Any

from scoring_within import Judged

Scores = Mapping[str, Mapping[str, Judged]]
Timed = tuple[float, float]
"""How long a recording is [s], and the rate of the means it is given as [1/s]."""
Times = Mapping[str, Mapping[Timed, float | str]]


def table(scores: Scores, times: Times, made: set[str]) -> str:
    """One line for each set, then macro F1, then processor time by length; one column a method."""
    methods = list(scores)
    sets = list(scores[methods[0]])
    lines = [_row("judged F1", methods), _row("---", ["---"] * len(methods))]
    for name in sets:
        values = [scores[method][name] for method in methods]
        figures = _best([each.f1 for each in values])
        cells = [_cell(each, f1) for each, f1 in zip(values, figures, strict=True)]
        lines.append(_row(name, cells))
    for title, chosen in (("made", made), ("real", set(sets) - made)):
        named = [name for name in sets if name in chosen]
        if named:
            figures = [macro({n: scores[m][n] for n in named}) for m in methods]
            lines.append(_row(f"**macro, {title}**", _best(figures)))
    for length, rate_hz in sorted({key for each in times.values() for key in each}, key=_by_rate):
        cells = [_time(times.get(method, {}).get((length, rate_hz), "–")) for method in methods]
        lines.append(_row(f"{_length(length)}, others at {rate_hz:g} Hz", cells))
    return "\n".join(lines)


def macro(sets: Mapping[str, Judged]) -> float | None:
    """Mean F1 of the sets with events, of those of which anything was done."""
    values = [each.f1 for each in sets.values() if each.f1 is not None]
    return mean(values) if values else None


def draw(scores: Scores, times: Times, made: set[str], path: Path) -> None:
    """Accuracy by set and time by length, one colour a method."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure: Any = Figure(figsize=(13.0, 7.5), layout="constrained")
    FigureCanvasAgg(figure)
    accuracy, speed = figure.subplots(1, 2, width_ratios=[2.2, 1.0])
    methods = list(scores)
    sets = [n for n, judged in scores[methods[0]].items() if judged.f1 is not None]
    for method, colour in zip(methods, _COLOURS, strict=False):
        values = [scores[method][name].f1 for name in sets]
        bold = {"s": 70, "zorder": 3} if method == "keyphase" else {"s": 28}
        places = [place for place, value in enumerate(values) if value is not None]
        known = [value for value in values if value is not None]
        accuracy.scatter(known, places, color=colour, label=method, **bold)
        _draw_times(speed, times.get(method, {}), colour)
    accuracy.set(yticks=range(len(sets)), xlim=(-0.02, 1.02), xlabel="judged F1")
    accuracy.set_yticklabels(sets)
    for label, name in zip(accuracy.get_yticklabels(), sets, strict=True):
        label.set_color("#1b1f24" if name in made else "#7a4b00")
    accuracy.invert_yaxis()
    figure.legend(*accuracy.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    scale = "log" if times else "linear"
    speed.set(xscale=scale, yscale=scale, xlabel="recording [s]", ylabel="processor time [s]")
    speed.set_title("others given 25 Hz: solid\nevery sample: dashed", fontsize=10)
    for axes in (accuracy, speed):
        axes.grid(color="#dfe4ea", lw=0.6)
        axes.spines[["top", "right"]].set_visible(False)
        axes.set_axisbelow(True)
    figure.savefig(path, dpi=100)


def _draw_times(axes: Any, times: Mapping[Timed, float | str], colour: str) -> None:
    """Of the lowest rate as a line, of higher ones dashed."""
    rates = sorted({rate_hz for _, rate_hz in times})
    for rate_hz in rates:
        taken = {s: t for (s, r), t in times.items() if r == rate_hz and isinstance(t, float)}
        style = "o-" if rate_hz == rates[0] else "o--"
        axes.plot(list(taken), list(taken.values()), style, color=colour)


def _by_rate(timed: Timed) -> tuple[float, float]:
    return timed[1], timed[0]


_COLOURS = ("#d1495b", "#2f6fb3", "#7aa6d6", "#5b8c5a", "#a3c293", "#e0a030", "#8f6fb0", "#7d8894")


def _best(values: list[float | None]) -> list[str]:
    most = max((value for value in values if value is not None), default=None)
    return ["–" if v is None else f"**{v:.2f}**" if v == most else f"{v:.2f}" for v in values]


def _cell(judged: Judged, f1: str) -> str:
    if not judged.done:
        return "stopped"
    if judged.f1 is None and judged.tally.recall is None:
        f1 = f"{judged.tally.false} false"
    return f1 if judged.whole else f"{f1} ({judged.done} of {judged.of})"


def _row(first: str, cells: list[str]) -> str:
    return "| " + " | ".join([first, *cells]) + " |"


def _time(value: float | str) -> str:
    if isinstance(value, str):
        return value
    if value < 0.01:
        return f"{1e3 * value:.1f} ms"
    return f"{1e3 * value:.0f} ms" if value < 1.0 else f"{value:.1f} s"


def _length(seconds: float) -> str:
    return f"{seconds / 3600:g} h" if seconds >= 3600 else f"{seconds:g} s"
