"""Confidence grows with the evidence."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from keyphase.demonstration import Demonstration
from keyphase.segmentation import Parameters, segment
from keyphase.segmentation.motion import motion_of
from keyphase.segmentation.paper.confidence import (
    force_confidence,
    joint_confidence,
    position_confidence,
)
from keyphase.segmentation.paper.peaks import Candidates

TIME = np.arange(1001) / 250.0

positive = st.floats(0.0, 1e6)
factor = st.floats(1.0, 1e3)


def confidence(height: float, ratio: float, persistence: float) -> float:
    one = np.zeros(1)
    candidate = Candidates(
        np.zeros(1, dtype=np.intp),
        one,
        one,
        one,
        one,
        np.array([height]),
        np.array([ratio]),
        np.zeros((1, 3)),
        np.array([persistence]),
    )
    return float(force_confidence(candidate, 20.0)[0])


@given(positive, positive, positive, factor)
def test_more_of_any_evidence_never_makes_a_force_boundary_less_sure(h, r, p, more):
    least = confidence(h, r, p)
    assert 0.0 <= least <= 1.0
    for changed in ((h * more, r, p), (h, r * more, p), (h, r, p * more)):
        assert confidence(*changed) >= least


def test_on_the_criterion_it_is_one_half_and_at_twice_the_amplitude_most():
    assert confidence(20.0, 1e6, 1e6) == 0.5
    assert confidence(80.0, 1e6, 1e6) == 0.8
    assert confidence(1e6, 1e6, 8.0) == 0.8


def confidence_of_turn(degrees: float, interval_s: float = 0.5) -> float:
    """Of the corner of a path of constant speed that turns halfway."""
    turned = np.radians(degrees)
    after = np.clip(TIME - 2.0, 0.0, None)[:, None] * [np.cos(turned), np.sin(turned), 0.0]
    path = np.clip(TIME, 0.0, 2.0)[:, None] * [1.0, 0.0, 0.0] + after
    motion = motion_of(Demonstration("turn", TIME, 0.1 * path))
    around = np.array([[2.0 - interval_s / 2, 2.0 + interval_s / 2]])
    return float(position_confidence(motion, np.array([2.0]), around)[0])


def test_a_sharper_turn_is_surer():
    turns = [confidence_of_turn(degrees) for degrees in range(0, 181, 15)]
    assert (np.diff(turns) > 0).all()


def test_a_narrower_interval_is_surer():
    widths = [confidence_of_turn(90.0, width) for width in (0.1, 0.5, 1.0, 3.0)]
    assert (np.diff(widths) < 0).all()


@given(st.floats(0, 1), st.floats(0, 1))
def test_two_witnesses_are_at_least_as_sure_as_either(force, position):
    joint = joint_confidence(force, position)
    assert max(force, position) - 1e-12 <= joint <= 1.0


def test_clear_contacts_are_surer_than_faint_ones():
    force = np.random.default_rng(0).normal(size=(1001, 3)) * 0.1
    force[:, 2] += np.where(TIME >= 1.5, 0.5, 0.0) + np.where(TIME >= 2.5, 8.0, 0.0)
    still = Demonstration("contacts", TIME, np.zeros_like(force), force_N=force)
    faint, clear = segment(still, Parameters(variant="paper")).boundaries
    assert faint.confidence < 0.8 < 0.95 < clear.confidence
