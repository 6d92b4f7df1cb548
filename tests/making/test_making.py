"""Demonstrations made by formula: the same for a seed, their truth borne out by the numbers."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from keyphase.errors import MakingError
from keyphase.making import FAMILIES, make
from keyphase.making.contact import Change, Contact, settled
from keyphase.readers import save_npz

seeds = st.integers(0, 2**31)
families = st.sampled_from(sorted(FAMILIES))


@given(families, seeds)
@settings(max_examples=30)
def test_events_lie_inside_the_recording_in_order(family, seed):
    made = make(family, seed)
    times = [event.time_s for event in made.events]
    assert times == sorted(times)
    assert all(made.demonstration.start_s < time < made.demonstration.end_s for time in times)


@given(families, seeds)
@settings(max_examples=20)
def test_contact_changes_are_far_enough_apart_to_be_told_apart(family, seed):
    made = make(family, seed)
    times = [event.time_s for event in made.events if event.kind == "contact"]
    assert np.all(np.diff(times) > 0.2)


@pytest.mark.parametrize("family", sorted(FAMILIES))
def test_the_same_seed_gives_the_same_bytes(family, tmp_path):
    for name in ("once", "again"):
        save_npz(make(family, 5).demonstration, tmp_path / f"{name}.npz")
    assert (tmp_path / "once.npz").read_bytes() == (tmp_path / "again.npz").read_bytes()


def test_another_seed_gives_another_demonstration():
    first, second = make("press", 1), make("press", 2)
    assert len(first.demonstration) != len(second.demonstration)


def test_the_wrench_differs_before_and_after_contact_is_made():
    """On most: noise below a tenth of the contact's force leaves no doubt once it has come."""
    seen = []
    for seed in range(20):
        made = make("snap", seed)
        demonstration = made.demonstration
        assert demonstration.force_N is not None
        for event in made.events:
            if event.label == "contact made":
                before = _mean(demonstration, event.time_s - 0.2, event.time_s - 0.02)
                after = _mean(demonstration, event.time_s + 0.02, event.time_s + 0.3)
                seen.append(np.linalg.norm(after - before))
    assert np.mean(np.array(seen) > 0.05) > 0.95


def test_nothing_is_touched_when_something_is_only_carried():
    assert all(event.kind == "motion" for seed in range(10) for event in make("carry", seed).events)


def test_the_tool_stands_still_from_the_end_of_a_motion_to_the_next():
    made = make("reach", 3)
    demonstration = made.demonstration
    speed = np.linalg.norm(np.diff(demonstration.position_m, axis=0), axis=1)
    speed = np.convolve(speed * demonstration.rate_hz, np.ones(9) / 9, "same")
    for ended, began in zip(made.events, made.events[1:], strict=False):
        if ended.label == "motion ended":
            a, b = demonstration.index_at(ended.time_s), demonstration.index_at(began.time_s)
            assert np.median(speed[a:b]) < 0.1 * speed.max()


def test_an_unknown_family_is_refused_by_name():
    with pytest.raises(MakingError, match=r"families.*wipe.*but got 'dance'"):
        make("dance", 0)


def _mean(demonstration, start_s, end_s):
    inside = (demonstration.time_s >= start_s) & (demonstration.time_s <= end_s)
    if not inside.any():
        inside[demonstration.index_at(start_s)] = True
    return demonstration.force_N[inside].mean(axis=0)


def test_what_settles_after_contact_begins_there_and_passes():
    time_s = np.arange(0.0, 12.0, 0.01)
    contact = Contact()
    level = np.array([0.0, 0.0, 5.0, 0.0, 0.0, 0.0])
    contact.changes.append(Change(2.0, 0.02, level, "smooth", "contact made"))
    contact.changes.append(Change(9.0, 0.02, np.zeros(6), "smooth", "contact lost"))
    size = np.linalg.norm(settled(np.random.default_rng(0), contact, time_s, 1.0), axis=1)
    assert not size[time_s < 2.0].any()
    assert size[(time_s > 2.0) & (time_s < 3.0)].max() > 0.5
    assert size[time_s > 9.0].max() < 0.01
    assert not settled(np.random.default_rng(0), contact, time_s, 0.0).any()
