"""A plan replayed: it succeeds from the bundled data, survives edits, and says how it ended."""

import hashlib
from dataclasses import replace

import numpy as np
import pytest
from replaying import NAMES, begun, bundled, nominal, plan, replayed, stroke, with_thresholds

from keyphase.errors import SimulationError
from keyphase.labeling.edits import Move
from keyphase.readers import read, save_npz
from keyphase.segmentation import segment
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.simulation import Disturbance, workcell
from keyphase.simulation.replay.replay import Replay, run
from keyphase.skills.execution.seeking import SEATING_S
from keyphase.skills.library import skills_of

MOVED_S = 0.2
STRONGEST_N = 15.0


def digest(result, folder) -> str:
    save_npz(result.demonstration, folder / "replay.npz")
    return hashlib.sha256((folder / "replay.npz").read_bytes()).hexdigest()


@pytest.mark.parametrize("name", NAMES)
def test_the_plan_of_a_bundled_recording_succeeds(name) -> None:
    result = nominal(name)
    assert result.succeeded
    assert result.completed
    assert result.outcome() == "success"
    assert result.peak_force < 12.0


@pytest.mark.parametrize("name", NAMES)
def test_each_skill_ends_as_its_end_condition_says(name) -> None:
    result = nominal(name)
    expected = [
        "contact" if isinstance(skill.end_condition, ContactEnd) else "reached"
        for skill in result.skills
    ]
    assert [each.outcome for each in result.results] == expected
    assert "contact" in expected


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_it_succeeds_after_any_boundary_was_moved_by_200_ms(name) -> None:
    for boundary in bundled(name)[2].boundaries:
        for by in (-MOVED_S, MOVED_S):
            moved = plan(name, {0: Move(boundary.time_s, boundary.time_s + by)})
            result = replayed(name, moved)
            assert result.succeeded, (boundary.time_s, by, result.outcome())
            assert result.peak_force < STRONGEST_N, (boundary.time_s, by)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("factor", [0.5, 2.0])
def test_it_succeeds_with_thresholds_halved_and_doubled(name, factor) -> None:
    result = replayed(name, with_thresholds(plan(name), factor))
    assert result.succeeded, result.outcome()
    assert result.completed


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_with_repeats_runs_through_connecting_moves(name) -> None:
    # A detent that has snapped is not felt again: of Setup 1 only the way to it is repeated.
    repeated = len(plan(name)) if name == "setup2" else 1
    segments = [one for k, one in enumerate(plan(name)) for _ in range(2 if k < repeated else 1)]
    result = replayed(name, segments)
    assert result.completed, result.outcome()
    assert sum(skill.connecting for skill in result.skills) >= repeated


def test_a_plan_that_cannot_work_in_its_order_says_where_it_ended() -> None:
    forward, down, *_, slide = plan("setup1")
    result = replayed("setup1", [forward, slide, down])
    assert not result.succeeded
    assert result.results[-1].outcome in ("timeout", "too far", "unexpected contact")
    assert result.results[-1].label in result.outcome()


def test_a_skill_that_ends_otherwise_stops_the_plan() -> None:
    segments = [
        type(each)(**{**vars(each), "end_condition": ConfigurationEnd()}) for each in plan("setup1")
    ]
    result = replayed("setup1", segments, Disturbance(part_height_m=0.009))
    assert result.results[-1].outcome == "unexpected contact"
    assert len(result.results) < len(result.skills)
    assert "unexpected contact" in result.outcome()


def test_a_goal_that_the_arm_does_not_reach_is_said_to_be_one() -> None:
    curve, segment = stroke(1.0)
    start = curve.position_m[0]
    far = replace(curve, position_m=start + 4.0 * (curve.position_m - start))
    part = replace(segment, end_condition=ConfigurationEnd(timeout_s=1.0))
    result = run(workcell("setup1").build(), skills_of(far, [part]), far)
    assert result.outcome().endswith(
        "ended with timeout: nothing is in its way, the arm does not reach its goal"
    )


def test_where_the_arm_is_away_from_the_start_it_is_connected_first() -> None:
    replay = begun("setup1")
    first = replay.skills[0]
    assert first.connecting
    start = plan("setup1")[0]
    there = bundled("setup1")[0].position_m[bundled("setup1")[0].index_at(start.start_s)]
    assert np.allclose(first.end_position_m, there, atol=1e-3)


@pytest.mark.parametrize("name", NAMES)
def test_the_recording_of_a_replay_can_be_saved_opened_and_segmented(name, tmp_path) -> None:
    result = nominal(name)
    save_npz(result.demonstration, tmp_path / "replay.npz")
    again = read(tmp_path / "replay.npz")
    assert again.metadata["operator"] == "replay"
    found = [b.time_s for b in segment(again).boundaries if b.contact_change]
    snap = again.metadata["ground_truth"]["contact_changes_s"][0]
    assert min(abs(time - snap) for time in found) < 0.1


def test_the_recording_of_a_replay_can_be_replayed() -> None:
    again = nominal("setup2").demonstration
    kept = [each for each in segment(again).segments if not each.idle]
    result = run(workcell("setup2").build(), skills_of(again, kept), again)
    assert result.succeeded, result.outcome()


@pytest.mark.parametrize("name", NAMES)
def test_the_same_seed_gives_the_same_bytes(name, tmp_path) -> None:
    assert digest(replayed(name), tmp_path) == digest(nominal(name), tmp_path)


def test_another_seed_gives_another_replay(tmp_path) -> None:
    assert digest(replayed("setup1", seed=1), tmp_path) != digest(nominal("setup1"), tmp_path)


@pytest.mark.parametrize("name", NAMES)
def test_every_tick_says_which_skill_runs_and_what_is_repeated(name) -> None:
    result = nominal(name)
    running = [state.skill for state in result.states if state.skill is not None]
    assert running == sorted(running)
    assert set(running) == set(range(len(result.skills)))
    for state in result.states:
        span = None if state.skill is None else result.skills[state.skill].demonstrated_s
        assert (state.demonstrated_s is None) == (span is None)
        if span is not None and state.demonstrated_s is not None:
            assert span[0] <= state.demonstrated_s <= span[1]


def test_it_takes_about_as_long_as_the_kept_segments() -> None:
    result = nominal("setup2")
    demonstrated = sum(each.end_s - each.start_s for each in plan("setup2"))
    searching = [state.stage for state in result.states].count("searching")
    (squaring,) = [skill.squaring for skill in result.skills if skill.squaring]
    assert 0.0 < 0.004 * searching < squaring.duration_s
    demonstrated += 0.004 * searching + 2.0 * SEATING_S
    assert demonstrated < result.duration_s < demonstrated + 3.0


def test_the_force_profile_of_a_skill_is_what_was_measured_in_it() -> None:
    result = nominal("setup1")
    down = next(each for each in result.results if "down" in each.label)
    time, force = result.profile(down.skill)
    assert time[0] == 0.0
    assert np.linalg.norm(force, axis=1).max() == pytest.approx(down.peak_force_N)


def test_the_frames_show_links_and_parts_at_25_hz() -> None:
    result = nominal("setup1")
    assert {"held", "housing", "yumi_link_7_r"} <= set(result.bodies)
    assert result.frames[1].time_s - result.frames[0].time_s == pytest.approx(0.04)
    assert result.frames[0].position_m.shape == (len(result.bodies), 3)
    held = result.bodies.index("held")
    assert np.ptp([frame.position_m[held] for frame in result.frames], axis=0).max() > 0.1


def test_a_replay_that_is_stopped_moves_no_more() -> None:
    replay = begun("setup1")
    for _ in range(200):
        replay.step()
    replay.stop()
    stopped = replay.state
    assert replay.over
    assert replay.step() is stopped
    result = replay.result()
    assert result.stopped
    assert not result.succeeded
    assert "stopped by you in “" in result.outcome()


def test_a_plan_without_skills_is_refused() -> None:
    with pytest.raises(SimulationError, match="at least one skill"):
        Replay(workcell("setup1").build(), (), bundled("setup1")[0])
