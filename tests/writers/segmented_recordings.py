"""Small recordings with segments that a person named, for tests of what is written of them."""

from itertools import pairwise
from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.files.parts import stem_of
from keyphase.labeling.edits import Keep, Label, Plan
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import SUFFIX, write_segment_file
from keyphase.readers import read, save_npz
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary, Segment, Segmentation
from keyphase.writers import SegmentedRecording

RATE_HZ = 50.0
EDGES_S = (0.0, 1.0, 2.5, 4.0, 5.0)
NAMES = ("approach", "insert", "wait", "retract")
KEPT = (True, True, False, True)


def moving(rate_hz=RATE_HZ, duration_s=5.0):
    """Time, position, orientation and force of a tool that goes down, presses, rests and rises."""
    time = np.arange(round(duration_s * rate_hz) + 1) / rate_hz
    height = np.interp(time, (0, 1, 2.5, 4, 5), (0.2, 0.1, 0.05, 0.05, 0.2))
    position = np.stack([0.3 + 0.02 * time, 0 * time, height], axis=1)
    wxyz = np.tile([1.0, 0.0, 0.0, 0.0], (len(time), 1))
    force = np.zeros_like(position)
    force[(time > 1) & (time < 4), 2] = 8.0
    return time, position, wxyz, force


def labeled(demonstration, plan=None):
    """Its four segments with a person's names; the third is dropped."""
    edges = [demonstration.start_s + edge for edge in EDGES_S[1:-1]]
    times = [demonstration.start_s, *edges, demonstration.end_s]
    contact = ContactEnd((0.0, 0.0, 1.0), 2.0)
    ends = (contact, ConfigurationEnd(), ConfigurationEnd(), ConfigurationEnd())
    segmentation = Segmentation(
        demonstration,
        Parameters(),
        tuple(Boundary(t, "both", (t - 0.02, t + 0.02), 0.9, t == edges[0]) for t in edges),
        tuple(
            Segment(a, b, "move", i == 2, end)
            for i, (a, b, end) in enumerate(zip(times[:-1], times[1:], ends, strict=True))
        ),
        (),
        None,
        (),
        None,
    )
    middles = [(a + b) / 2 for a, b in pairwise(times)]
    spans = list(pairwise(times))
    edits = [Label(m, name, span) for m, name, span in zip(middles, NAMES, spans, strict=True)]
    edits += [Keep(m, kept, span) for m, kept, span in zip(middles, KEPT, spans, strict=True)]
    if plan is not None:
        order = [middles[i] for i in plan]
        edits.append(Plan(tuple(order), tuple(spans[i] for i in plan), ()))
    return label(segmentation, dict(enumerate(edits)))


def saved(folder: Path, name="run", plan=None):
    """The labeling of a recording that lies in `folder` as an archive."""
    time, position, wxyz, force = moving()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name}.npz"
    save_npz(Demonstration(name, time, position, wxyz, force), path)
    return labeled(read(path), plan)


def item(folder: Path, name="run", plan=None):
    """The same as writers are given it."""
    return SegmentedRecording.of_labeling(saved(folder, name, plan))


def with_segment_file(folder: Path, recording: Path, recipe=None):
    """Write the segment file of a recording that is there; its path."""
    demonstration = read(recording, recipe)
    path = folder / f"{stem_of(recording)}{SUFFIX}"
    write_segment_file(labeled(demonstration), path)
    return path
