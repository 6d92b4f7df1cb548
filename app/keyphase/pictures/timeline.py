"""The timeline: segments, position, force, and the evidence that boundaries rest on."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.labeling.labeling import Labeling
from keyphase.pictures.look import AXES, CONTACT, INK, MOTION, color_of, plain, shortened
from keyphase.segmentation.segmentation import Segmentation

HEIGHTS = (0.62, 1.5, 1.5, 1.3)
"""Of segments, position, force and evidence."""

_CHARACTERS_A_SPAN = 125
"""How many characters of a label fit along the whole timeline."""


def rows_of(segmentation: Segmentation) -> tuple[str, ...]:
    """What there is to draw: force and evidence only where they are."""
    force = segmentation.demonstration.force_N is not None
    evidence = segmentation.track is not None or segmentation.curve is not None
    return (
        "segments",
        "position",
        *(("force",) if force else ()),
        *(("evidence",) if evidence else ()),
    )


def draw_timeline(rows: Sequence[Any], labeling: Labeling) -> None:
    """Draw on axes that share their time, one for each of `rows_of`."""
    demonstration = labeling.segmentation.demonstration
    by_name = dict(zip(rows_of(labeling.segmentation), rows, strict=True))
    _draw_segments(by_name["segments"], labeling)
    _draw_channels(
        by_name["position"],
        demonstration,
        1e2 * demonstration.position_m,
        "position from start [cm]",
    )
    if demonstration.force_N is not None:
        _draw_channels(by_name["force"], demonstration, demonstration.force_N, "force [N]")
    if "evidence" in by_name:
        _draw_evidence(by_name["evidence"], labeling.segmentation)
    for axes in rows[1:]:
        plain(axes)
        for boundary in labeling.boundaries:
            axes.axvline(
                boundary.time_s,
                color=CONTACT if boundary.contact_change else MOTION,
                lw=0.8,
                ls="-" if boundary.contact_change else (0, (4, 3)),
            )
    for axes in rows[:-1]:
        axes.tick_params(labelbottom=False)
    rows[-1].set_xlabel("time [s]", fontsize=9)
    rows[-1].set_xlim(demonstration.start_s, demonstration.end_s)


def _draw_segments(axes: Any, labeling: Labeling) -> None:
    demonstration = labeling.segmentation.demonstration
    for segment in labeling.segments:
        width = segment.end_s - segment.start_s
        axes.barh(
            0,
            width,
            left=segment.start_s,
            height=0.8,
            color=color_of(segment),
            edgecolor="white",
            lw=1.2,
            alpha=0.9 if segment.kept else 0.5,
        )
        room = int(_CHARACTERS_A_SPAN * width / demonstration.duration_s)
        if room >= 3:
            axes.text(
                segment.start_s + width / 2,
                0,
                shortened(segment.label, room),
                ha="center",
                va="center",
                fontsize=8,
                color=INK,
                clip_on=True,
            )
    axes.set(yticks=[], ylim=(-0.5, 0.5))
    axes.set_frame_on(False)
    axes.tick_params(bottom=False)


def _draw_channels(axes: Any, demonstration: Demonstration, values: Array, name: str) -> None:
    """Three channels; position is drawn from where it began, so that all three are seen."""
    shown = values - values[0] if "position" in name else values
    at = _thinned(len(demonstration))
    for axis, color, column in zip("xyz", AXES, shown.T, strict=True):
        axes.plot(demonstration.time_s[at], column[at], color=color, lw=1.1, label=axis)
    axes.set_ylabel(name, fontsize=9)
    axes.legend(ncols=3, fontsize=7, frameon=False, loc="upper left", handlelength=1.2)


def _thinned(count: int) -> NDArray[np.intp]:
    """At most about 4000 samples, so that a long recording is no large file."""
    return np.arange(0, count, max(1, count // 4000))


def _draw_evidence(axes: Any, segmentation: Segmentation) -> None:
    track = segmentation.track
    if track is None:
        _draw_curve(axes, segmentation)
        return
    if track.contact is not None:
        axes.fill_between(track.time_s, track.contact, color=CONTACT, alpha=0.35, lw=0)
        axes.plot(track.time_s, track.contact, color=CONTACT, lw=0.9, label="contact changes")
    axes.plot(track.time_s, track.motion, color=MOTION, lw=0.9, label="motion changes")
    lines = ((segmentation.threshold, CONTACT), (segmentation.motion_threshold, MOTION))
    for line, color in lines:
        if line is not None and line <= 1.0:
            axes.axhline(line, color=color, lw=0.8, ls=":")
    axes.set(ylim=(0, 1.05))
    axes.set_ylabel("probability", fontsize=9)
    axes.legend(ncols=2, fontsize=7, frameon=False, loc="upper left", handlelength=1.2)


def _draw_curve(axes: Any, segmentation: Segmentation) -> None:
    """The paper's variant: normalized error of the force filter and its threshold."""
    curve = segmentation.curve
    if curve is None:
        return
    axes.plot(curve.time_s, np.maximum(curve.error, 1e-2), color=INK, lw=0.8)
    if segmentation.threshold is not None:
        axes.axhline(segmentation.threshold, color=CONTACT, lw=0.8, ls=":")
    axes.set_yscale("log")
    axes.set_ylabel("normalized error", fontsize=9)
