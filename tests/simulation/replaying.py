"""Plans for the tests of replays: from the bundled recordings, or drawn."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from types import MappingProxyType

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.labeling.edits import Edit
from keyphase.labeling.label import label
from keyphase.labeling.labeling import LabeledSegment
from keyphase.readers import read
from keyphase.segmentation import Segmentation, Segmenter
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.simulation import NOMINAL, Disturbance, workcell
from keyphase.simulation.replay.replay import Replay, ReplayOptions, run
from keyphase.simulation.replay.result import ReplayResult
from keyphase.skills.connecting import minimum_jerk
from keyphase.skills.library import skills_of

NAMES = ["setup1", "setup2"]


@cache
def bundled(name: str) -> tuple[Demonstration, Segmenter, Segmentation]:
    demonstration = read(shipped("data") / f"{name}.npz")
    segmenter = Segmenter(demonstration)
    return demonstration, segmenter, segmenter.segment()


def plan(name: str, edits: Mapping[int, Edit] = MappingProxyType({})) -> list[LabeledSegment]:
    """The plan of a bundled recording; idle segments are dropped by default."""
    _, segmenter, segmentation = bundled(name)
    labeling = label(segmentation, edits, segmenter.segment_between)
    return [labeling.segments[entry.segment] for entry in labeling.plan]


def with_thresholds(segments: Sequence[LabeledSegment], factor: float) -> list[LabeledSegment]:
    ends = [segment.end_condition for segment in segments]
    return [
        replace(segment, end_condition=replace(end, threshold_N=factor * end.threshold_N))
        if isinstance(end, ContactEnd)
        else segment
        for segment, end in zip(segments, ends, strict=True)
    ]


def begun(
    name: str,
    segments: Sequence[LabeledSegment] | None = None,
    disturbance: Disturbance = NOMINAL,
    options: ReplayOptions | None = None,
) -> Replay:
    """A replay that has not been stepped."""
    demonstration = bundled(name)[0]
    skills = skills_of(demonstration, plan(name) if segments is None else segments)
    return Replay(workcell(name).build(disturbance), skills, demonstration, options)


def replayed(
    name: str,
    segments: Sequence[LabeledSegment] | None = None,
    disturbance: Disturbance = NOMINAL,
    seed: int = 0,
) -> ReplayResult:
    demonstration = bundled(name)[0]
    skills = skills_of(demonstration, plan(name) if segments is None else segments)
    return run(workcell(name).build(disturbance, seed), skills, demonstration)


@cache
def nominal(name: str) -> ReplayResult:
    """The plan of a bundled recording in its own workcell, replayed once for all tests."""
    return replayed(name)


@dataclass(frozen=True)
class Drawn:
    """A segment of a drawn demonstration."""

    start_s: float
    end_s: float
    label: str = "stroke"
    end_condition: EndCondition = field(default_factory=ConfigurationEnd)


def stroke(duration_s: float = 1.5) -> tuple[Demonstration, Drawn]:
    """A curve of 0.2 m in free space, from setup1's start: 150 mm far, 100 mm up, 40 mm aside."""
    here = workcell("setup1").build().here()
    time = np.arange(round(duration_s * 250) + 1) / 250
    course = minimum_jerk(time / time[-1])
    way = np.c_[0.15 * course, 0.04 * np.sin(np.pi * course), 0.1 * course]
    wxyz = np.tile(here.orientation_wxyz, (len(time), 1))
    return Demonstration("stroke", time, here.position_m + way, wxyz), Drawn(0.0, float(time[-1]))
