"""A score as one picture: F1 of each set, calibration of confidences, timing of what was found."""

import io
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.errors import MissingPackageError, ScoreError
from keyphase.files.writing import write_whole
from keyphase.scoring.calibration import Calibration
from keyphase.scoring.score import Score

SUFFIXES = (".png", ".svg", ".pdf")
_JUDGED, _STRICT, _GRID = "#2f6fb3", "#b9c4d0", "#dfe4ea"


def draw_score(score: Score, path: Path) -> None:
    """Write the picture of a score to `path`; a file that is there is replaced.

    Raises as `score_picture` does, and ScoreError for a folder that takes no files.
    """
    write_whole(path, score_picture(score, path), ScoreError)


def score_picture(score: Score, path: Path) -> bytes:
    """The picture of a score as the file `path` (.png, .svg or .pdf) would hold it.

    Raises MissingPackageError without matplotlib, ScoreError for another ending.
    """
    if path.suffix.lower() not in SUFFIXES:
        raise ScoreError(f"{path}: expected a picture named *{', *'.join(SUFFIXES)}.")
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError as error:
        raise MissingPackageError(
            "A picture needs the package 'matplotlib', which is not installed; "
            'pip install "keyphase[pictures]".'
        ) from error
    rows = len(score.grouped)
    figure: Any = Figure(figsize=(12.0, max(3.4, 0.42 * rows + 1.4)), layout="constrained")
    FigureCanvasAgg(figure)
    of_sets, calibrated, timed = figure.subplots(1, 3, width_ratios=[1.7, 1.0, 1.0])
    _draw_sets(of_sets, score)
    _draw_calibration(calibrated, score.calibration)
    _draw_timing(timed, score)
    file, kind = io.BytesIO(), path.suffix.lower()
    dateless = {"Date": None} if kind == ".svg" else None
    figure.savefig(file, format=kind[1:], dpi=110, metadata=dateless)
    return file.getvalue()


def _draw_sets(axes: Any, score: Score) -> None:
    names = list(score.grouped)
    at = np.arange(len(names))
    judged = [score.judged_sets[name] for name in names]
    strict = [score.sets[name].f1 or 0.0 for name in names]
    values = [each.f1 or 0.0 for each in judged]
    axes.barh(at - 0.19, values, 0.36, color=_JUDGED, label="judged")
    axes.barh(at + 0.19, strict, 0.36, color=_STRICT, label="strict")
    for place, each, value in zip(at, judged, values, strict=True):
        text = f"{value:.2f}" if each.recall is not None else f"no events, {each.false} false"
        axes.text(max(value, 0.0) + 0.01, place - 0.19, text, va="center", fontsize=8)
    axes.set(yticks=at, xlim=(0, 1.12), xlabel="F1", title=f"F1, macro {_two(score)}")
    axes.set_yticklabels(names, fontsize=8)
    axes.invert_yaxis()
    axes.legend(fontsize=8, loc="lower right", frameon=False)
    _plain(axes)


def _draw_calibration(axes: Any, calibration: Calibration) -> None:
    axes.plot([0, 1], [0, 1], color=_STRICT, lw=1)
    if calibration.error is not None:
        most = max(each.count for each in calibration.bins)
        for each in calibration.bins:
            area = 20.0 + 180.0 * each.count / most
            axes.scatter(each.confidence, each.right, area, color=_JUDGED, alpha=0.8)
        title = f"calibration error {calibration.error:.3f}"
        axes.set_title(f"{title}\n{calibration.sure_right} of {calibration.sure} sure ones right")
    axes.set(xlim=(0, 1.04), ylim=(0, 1.04), xlabel="confidence", ylabel="share right")
    _plain(axes)


def _draw_timing(axes: Any, score: Score) -> None:
    distances = [d for each in score.recordings for d in each.judged.tally.distances_s]
    if distances:
        axes.hist(1e3 * np.array(distances), 24, color=_JUDGED)
        axes.set_title(f"timing, median {1e3 * np.median(distances):.0f} ms")
    axes.set(xlabel="distance from the event [ms]", ylabel="boundaries")
    _plain(axes)


def _plain(axes: Any) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(color=_GRID, lw=0.6)
    axes.set_axisbelow(True)


def _two(score: Score) -> str:
    figures = (score.judged_macro_f1, score.macro_f1)
    return " judged, ".join("–" if f is None else f"{f:.2f}" for f in figures) + " strict"
