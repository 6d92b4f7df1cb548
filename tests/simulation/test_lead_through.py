"""Leading the tool by a target: what a page sees and what is recorded."""

import threading

import numpy as np
import pytest

from keyphase.errors import SimulationError
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.simulation import RATE_HZ
from keyphase.simulation.demonstrating.lead_through import LeadThrough
from keyphase.simulation.demonstrating.recorder import take_of
from keyphase.simulation.workcells.setup1 import SETUP1
from keyphase.simulation.workcells.setup2 import SETUP2


def advance(session: LeadThrough, seconds: float) -> None:
    for _ in range(round(seconds * RATE_HZ)):
        session.advance()


def drag(session: LeadThrough, goal, seconds: float) -> None:
    """Move the target as a mouse does: some twenty jumps a second."""
    start = session.state().sample
    jumps = max(1, round(seconds * 20))
    for jump in range(1, jumps + 1):
        at = start.position_m + (np.array(goal) - start.position_m) * jump / jumps
        session.set_target(at, start.orientation_wxyz)
        advance(session, seconds / jumps)


def over_the_housing(session: LeadThrough) -> np.ndarray:
    state = session.state()
    way = state.parts["housing"][0] - state.parts["held"][0]
    return state.sample.position_m + way * [1.0, 1.0, 0.0]


def test_the_tool_follows_the_target() -> None:
    session = LeadThrough(SETUP1)
    goal = session.state().sample.position_m + np.array([0.05, 0.02, -0.03])
    drag(session, goal, 1.0)
    advance(session, 0.5)
    assert session.state().sample.position_m == pytest.approx(goal, abs=5e-4)


def test_the_tool_turns_with_the_target() -> None:
    session = LeadThrough(SETUP2)
    state = session.state().sample
    aligned = np.array([0.0, 0.0, 1.0, 0.0])
    session.set_target(state.position_m, aligned)
    advance(session, 2.0)
    turned = session.state().sample.orientation_wxyz
    assert abs(float(turned @ aligned)) > np.cos(np.radians(0.5))


def test_dragging_down_is_stopped_by_the_part_and_felt() -> None:
    session = LeadThrough(SETUP1)
    drag(session, over_the_housing(session), 1.5)
    free = session.state().sample.force_N
    drag(session, session.state().sample.position_m - [0.0, 0.0, 0.2], 2.0)
    advance(session, 0.5)
    pressed = session.state().sample.force_N
    assert np.linalg.norm(free) < 0.6
    assert 10.0 < pressed[2] < 25.0, "a far target presses, but not with all its might"


def test_a_recorded_drag_shows_its_contact_in_the_segmentation(tmp_path) -> None:
    session = LeadThrough(SETUP1)
    path = tmp_path / "drag.npz"
    session.start_recording(path)
    drag(session, over_the_housing(session), 1.5)
    advance(session, 0.6)
    drag(session, session.state().sample.position_m - [0.0, 0.0, 0.105], 1.5)
    advance(session, 0.6)
    session.stop_recording()
    demonstration = read(path)
    onset = demonstration.metadata["ground_truth"]["contact_onsets_s"]["snap"]
    changes = [b.time_s for b in segment(demonstration).boundaries if b.contact_change]
    assert any(abs(change - onset) < 0.06 for change in changes)


def test_state_tells_where_everything_is() -> None:
    state = LeadThrough(SETUP1).state()
    assert set(state.parts) == set(SETUP1.parts)
    assert {"yumi_link_1_r", "gripper_r_base", "yumi_link_7_l"} <= set(state.links)
    assert not set(state.parts) & set(state.links)
    assert state.recorded_s is None


def test_recording_counts_what_is_recorded(tmp_path) -> None:
    session = LeadThrough(SETUP1)
    advance(session, 0.2)
    session.start_recording(tmp_path / "a.npz")
    advance(session, 0.4)
    assert session.state().recorded_s == pytest.approx(0.4)
    recorded = session.stop_recording()
    assert recorded.duration_s == pytest.approx(0.4 - 1.0 / RATE_HZ)
    assert recorded.metadata["operator"] == "by hand"
    assert session.state().recorded_s is None


def test_one_take_at_a_time(tmp_path) -> None:
    session = LeadThrough(SETUP1)
    session.start_recording(tmp_path / "a.npz")
    with pytest.raises(SimulationError, match=r"a\.npz still is; stop it first"):
        session.start_recording(tmp_path / "b.npz")


def test_stopping_what_was_not_started_is_refused() -> None:
    with pytest.raises(SimulationError, match="start a recording first"):
        LeadThrough(SETUP1).stop_recording()


def test_a_reset_puts_everything_back_and_drops_the_take(tmp_path) -> None:
    session = LeadThrough(SETUP1)
    start = session.state()
    session.start_recording(tmp_path / "a.npz")
    drag(session, start.sample.position_m + np.array([0.05, 0.0, 0.0]), 1.0)
    session.reset()
    session.advance()
    assert session.state().sample.position_m == pytest.approx(start.sample.position_m, abs=1e-3)
    assert not take_of(tmp_path / "a.npz").exists()


def test_letting_go_leaves_the_tool_where_it_is() -> None:
    session = LeadThrough(SETUP1)
    start = session.state().sample
    session.set_target(start.position_m + np.array([0.1, 0.0, 0.0]), start.orientation_wxyz)
    advance(session, 0.3)
    session.let_go()
    there = session.state().sample.position_m
    advance(session, 1.0)
    assert np.linalg.norm(session.state().sample.position_m - there) < 0.03


@pytest.mark.parametrize(
    ("position", "wxyz"),
    [
        ((0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),
        ((0.0, 0.0, float("nan")), (1.0, 0.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0)),
        ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)),
    ],
)
def test_targets_that_are_no_pose_are_refused(position, wxyz) -> None:
    with pytest.raises(SimulationError, match="A target must be"):
        LeadThrough(SETUP1).set_target(position, wxyz)


def test_running_in_real_time_takes_targets_from_other_threads(tmp_path) -> None:
    session = LeadThrough(SETUP1)
    start = session.state().sample
    stepped = threading.Event()
    count = 0
    advance_once = session.advance

    def counted():
        nonlocal count
        count += 1
        if count == 250:
            stepped.set()
        return advance_once()

    session.advance = counted
    session.start_recording(tmp_path / "a.npz")
    session.start()
    session.set_target(start.position_m + np.array([0.0, 0.0, 0.02]), start.orientation_wxyz)
    assert stepped.wait(timeout=60.0)
    assert session.state().sample.position_m[2] > start.position_m[2] + 0.01
    session.close()
    assert session.failure is None
    assert len(read(tmp_path / "a.npz")) >= 250, "closing finishes the take"


def test_a_failing_simulation_stops_the_run_and_is_kept(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    session = LeadThrough(SETUP1)
    failed = SimulationError("diverged")

    def fails():
        raise failed

    session.advance = fails
    session.start()
    session.close()
    assert session.failure is failed


def test_ticks_are_due_every_four_milliseconds() -> None:
    session = LeadThrough(SETUP1)
    now, advanced = 0.0, []

    class Stop(threading.Event):
        def wait(self, timeout=None):
            nonlocal now
            now += timeout or 0.0
            return len(advanced) >= 250

    session._stop = Stop()
    session.advance = lambda: advanced.append(now)
    session.run(clock=lambda: now)
    assert np.diff(advanced) == pytest.approx([1.0 / RATE_HZ] * 249)
