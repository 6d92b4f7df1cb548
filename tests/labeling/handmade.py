"""Segmentations made by hand, so that labeling is tested without the segmentation's own choices."""

import hashlib
from itertools import pairwise

import numpy as np

from keyphase.demonstration import Demonstration, Source
from keyphase.labeling.document import Document
from keyphase.labeling.label import label
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary, Peak, Segment, Segmentation


def demonstration(duration_s=10.0, rate_hz=100.0, path=None, name="demo"):
    """A recording of ten seconds; one that was read from a file where a path is given."""
    time = np.arange(round(duration_s * rate_hz) + 1) / rate_hz
    position = np.stack([time, 0 * time, 0 * time], axis=1)
    source = None
    if path is not None:
        path.write_bytes(path.read_bytes() if path.exists() else b"a recording")
        source = Source(path, hashlib.sha256(path.read_bytes()).hexdigest())
    return Demonstration(name, time, position, force_N=np.zeros_like(position), source=source)


def boundary(time_s, origin="position", confidence=0.8, contact_change=False, peak=None):
    """A boundary of the program with an interval of a tenth of a second."""
    interval = (time_s - 0.05, time_s + 0.05)
    return Boundary(time_s, origin, interval, confidence, contact_change, peak)


def peak(time_s, persistence=10.0, rejection=""):
    """A peak of the normalized error after which the force stays changed."""
    return Peak(time_s, time_s, 50.0, 30.0, (0.0, 0.0, 3.0), None, persistence, rejection)


def described(start_s, end_s, contact_change):
    """What the program says of a segment with new ends, made up."""
    suffix = " until contact" if contact_change else ""
    return Segment(start_s, end_s, f"new{suffix}", False, ConfigurationEnd())


def segmentation(times=(2.0, 4.0, 6.0, 8.0), idle=(), made_from=None, peaks=(), parameters=None):
    """Boundaries at `times`; segments are called "part 1", …, those in `idle` are idle."""
    made_from = made_from or demonstration()
    edges = [made_from.start_s, *times, made_from.end_s]
    segments = tuple(
        Segment(a, b, "idle" if i in idle else f"part {i + 1}", i in idle, ConfigurationEnd())
        for i, (a, b) in enumerate(pairwise(edges))
    )
    return Segmentation(
        made_from,
        parameters or Parameters(),
        tuple(boundary(time) for time in times),
        segments,
        (),
        None,
        tuple(peaks),
        None,
    )


class Person:
    """Makes edits one after another on a segmentation, as the page does."""

    def __init__(self, segmentation):
        self.segmentation = segmentation
        self.document = Document(segmentation.demonstration)

    @property
    def labeling(self):
        """What is in view now."""
        return label(self.segmentation, self.document.edits, described)

    def makes(self, *edits):
        """The labeling after edits."""
        for edit in edits:
            self.document = self.document.apply(edit, self.labeling)
        return self.labeling

    def sees(self, segmentation):
        """The same edits over another automatic result, as after a slider has moved."""
        self.segmentation = segmentation
        return self.labeling


def times(labeling):
    """Times of the boundaries."""
    return [round(boundary.time_s, 6) for boundary in labeling.boundaries]


def labels(labeling):
    """Labels of the segments."""
    return [segment.label for segment in labeling.segments]


def kept(labeling):
    """Which segments are kept."""
    return [i for i, segment in enumerate(labeling.segments) if segment.kept]


def plan(labeling):
    """Indices of the segments in the order in which they are executed."""
    return [entry.segment for entry in labeling.plan]
