"""What a force does of itself while the tool rests is no contact; what is lighter elsewhere is."""

import itertools

import numpy as np

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.making import make
from keyphase.segmentation import Parameters, Segmentation, segment
from keyphase.segmentation.evidence.probability import CLEAR, CONTACT_COLUMNS
from keyphase.segmentation.evidence.stage import evidence_of
from keyphase.segmentation.evidence.telling.told import NONE_CLEAR
from keyphase.segmentation.evidence.weights import shipped_weights
from keyphase.segmentation.motion import motion_of

RATE_HZ = 50.0
PRESSED_S, RELEASED_S = 16.0, 20.0
SLIPS = ((4.0, (-0.1, -0.5, 0.3)), (7.5, (-0.15, 0.7, 0.05)), (10.0, (0.1, -0.6, -0.4)))


def press_after_a_long_rest(newton: float, slips: bool, noise_N: float) -> Demonstration:
    """Still for 12 s, aside, down until a press that lasts 4 s, up, still for 8 s."""
    rng = np.random.default_rng(5)
    places = ((0.0, 0.0), (-0.15, 0.0), (-0.15, -0.03), (-0.15, -0.03), (-0.15, 0.0))
    ends_s = (12.0, 14.0, PRESSED_S, RELEASED_S, 22.0)
    time = np.arange(0.0, 30.0, 1.0 / RATE_HZ)
    position = np.zeros((len(time), 3))
    for place, (begin, end) in enumerate(itertools.pairwise(ends_s)):
        part = synthetic.minimum_jerk(np.clip((time - begin) / (end - begin), 0.0, 1.0))
        way = np.subtract(places[place + 1], places[place])
        position[:, 1:] += part[:, None] * way
    force = np.tile([0.15, 0.0, -1.4], (len(time), 1))
    for at_s, slip in SLIPS if slips else ():
        force[time >= at_s] += slip
    force[(time >= PRESSED_S) & (time < RELEASED_S), 2] += newton
    force += rng.normal(0.0, noise_N, force.shape)
    return Demonstration("press", time, position + rng.normal(0.0, 1e-5, force.shape), None, force)


def contacts_s(found: Segmentation) -> list[float]:
    return [boundary.time_s for boundary in found.boundaries if boundary.contact_change]


def test_steps_of_a_wandering_estimate_at_rest_are_no_contact():
    found = segment(press_after_a_long_rest(8.7, slips=True, noise_N=0.017))
    np.testing.assert_allclose(contacts_s(found), [PRESSED_S, RELEASED_S], atol=0.06)
    assert found.automatic_least_step_N is not None
    assert 0.7 < found.automatic_least_step_N < 0.25 * 8.7
    held = {each.parameter: each.count for each in found.held_back}
    assert held["least_step_N"] >= 2


def test_a_light_touch_beside_a_quiet_rest_is_a_contact():
    found = segment(press_after_a_long_rest(0.4, slips=False, noise_N=0.01))
    np.testing.assert_allclose(contacts_s(found), [PRESSED_S, RELEASED_S], atol=0.06)
    assert found.automatic_least_step_N is not None
    assert found.automatic_least_step_N < 0.05


def test_a_least_step_of_zero_holds_nothing_back():
    found = segment(
        press_after_a_long_rest(8.7, slips=True, noise_N=0.017), Parameters(least_step_N=0.0)
    )
    assert len(contacts_s(found)) > 2
    assert "least_step_N" not in {each.parameter for each in found.held_back}


def test_a_force_that_is_never_strong_speaks_against_contact():
    weights = shipped_weights()
    said = []
    for newton in (0.3, 3.0):
        recording = press_after_a_long_rest(newton, slips=False, noise_N=0.01)
        terms = evidence_of(recording, motion_of(recording), weights).contact.terms
        added = weights.step.contributions(terms, CONTACT_COLUMNS)
        said.append(added[0, weights.step.names.index("strength")])
    assert said[0] < -0.5 < 0.0 < said[1]


def test_where_no_contact_change_is_clear_all_are_doubted():
    found = segment(make("carry", 6_000_019).demonstration)
    assert contacts_s(found) == []
    doubted = [c for c in found.candidates if c.kind == "contact"]
    assert doubted
    for candidate in doubted:
        (lost,) = [r.contribution for r in candidate.reasons if r.name == NONE_CLEAR]
        assert lost < -0.2
    pressed = segment(press_after_a_long_rest(8.7, slips=True, noise_N=0.017))
    assert NONE_CLEAR not in {r.name for c in pressed.candidates for r in c.reasons}


def test_a_force_that_wanders_slowly_as_a_tool_is_moved_about_is_no_contact():
    time = np.arange(0.0, 40.0, 0.01)
    part = synthetic.minimum_jerk(np.clip(2.0 * (time % 4.0) / 4.0, 0.0, 1.0))
    back = (time // 4.0) % 2 == 1
    position = np.outer(np.where(back, 1.0 - part, part), [0.3, 0.1, 0.0])
    rng = np.random.default_rng(3)
    force = rng.normal(0.0, 0.05, (len(time), 3))
    for hz in (0.06, 0.11, 0.19, 0.31):
        phases = rng.uniform(0.0, 2.0 * np.pi, 3)
        force += 1.2 * np.sin(2.0 * np.pi * hz * time[:, None] + phases)
    assert contacts_s(segment(Demonstration("wander", time, position, None, force))) == []


def test_a_weak_contact_that_stands_clear_of_free_space_is_not_doubted():
    found = segment(press_after_a_long_rest(0.25, slips=False, noise_N=0.03))
    np.testing.assert_allclose(contacts_s(found), [PRESSED_S, RELEASED_S], atol=0.06)
    likeliest = max(c.probability for c in found.candidates if c.kind == "contact")
    assert likeliest < CLEAR
    assert NONE_CLEAR not in {r.name for c in found.candidates for r in c.reasons}
