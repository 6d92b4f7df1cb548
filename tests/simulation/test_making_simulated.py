"""Demonstrations made in the simulator: their truth is the simulator's own contacts."""

import numpy as np
import pytest

from keyphase.errors import MakingError
from keyphase.readers import save_npz
from keyphase.simulation.making import make_simulated, recorded_set_up
from keyphase.simulation.making.bench import RATE_HZ
from keyphase.simulation.making.touching import contact_events, felt

FREE = frozenset()
ON_BENCH = frozenset({("bench", "tool")})
AT_WALL = frozenset({("bench", "tool"), ("tool", "wall")})


@pytest.fixture(scope="module")
def pressed():
    return make_simulated("simulated-press", 0)


def test_the_force_comes_and_goes_with_contact(pressed):
    made, lost = (event for event in pressed.events if event.kind == "contact")
    assert (made.label, lost.label) == ("contact made", "contact lost")
    demonstration = pressed.demonstration
    inside = (demonstration.time_s > made.time_s + 0.5) & (demonstration.time_s < lost.time_s - 0.5)
    before = demonstration.time_s < made.time_s - 0.1
    change = demonstration.force_N[inside].mean(axis=0) - demonstration.force_N[before].mean(axis=0)
    assert np.linalg.norm(change) > 0.3


def test_the_same_seed_gives_the_same_bytes(pressed, tmp_path):
    save_npz(pressed.demonstration, tmp_path / "once.npz")
    save_npz(make_simulated("simulated-press", 0).demonstration, tmp_path / "again.npz")
    assert (tmp_path / "once.npz").read_bytes() == (tmp_path / "again.npz").read_bytes()


def test_contact_is_made_changed_and_lost_as_what_touches_does():
    pairs = _for_a_second(FREE, ON_BENCH, AT_WALL, FREE)
    events, ignored = contact_events(pairs, _forces(pairs))
    assert [event.label for event in events] == ["contact made", "contact changed", "contact lost"]
    np.testing.assert_allclose([event.time_s for event in events], [1.0, 2.0, 3.0], atol=0.01)
    assert ignored == []


def test_a_contact_that_chatters_is_not_judged():
    short = round(0.05 * RATE_HZ)
    pairs = [*_for_a_second(FREE), *[ON_BENCH] * short, *_for_a_second(FREE)]
    events, ignored = contact_events(pairs, _forces(pairs))
    assert events == []
    assert len(ignored) == 1


def test_a_change_that_moves_no_force_is_not_judged():
    pairs = _for_a_second(FREE, ON_BENCH)
    events, ignored = contact_events(pairs, np.zeros((len(pairs), 3)))
    assert events == []
    assert ignored[0][0] < 1.0 < ignored[0][1]


def test_a_part_that_is_pushed_against_another_is_felt_and_its_standing_is_not():
    alone = frozenset({("part 1", "tool"), ("bench", "part 1"), ("bench", "part 2")})
    both = alone | {("part 1", "part 2")}
    (first, second) = felt([alone, both], held=False)
    assert first == frozenset({("tool", "part 1")})
    assert second == first | {("part 1", "part 2")}


def test_an_unknown_family_is_refused():
    with pytest.raises(MakingError, match="simulated-press"):
        make_simulated("dance", 0)


def _for_a_second(*states):
    return [state for state in states for _ in range(round(RATE_HZ))]


def _forces(pairs):
    return np.array([[float(len(each)), 0.0, 0.0] for each in pairs])


def test_a_set_up_is_a_family_with_the_contacts_between_its_phases():
    made = recorded_set_up("setup2", 0)
    assert [event.label for event in made.events] == [
        "motion began",
        "contact made",
        "contact changed",
    ]
    with pytest.raises(MakingError, match="setup1, setup2"):
        recorded_set_up("setup3", 0)
