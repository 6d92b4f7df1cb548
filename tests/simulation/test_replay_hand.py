"""A person holds or pushes the robot while it replays: it waits, gives way, and comes back."""

import numpy as np
import pytest
from replaying import begun, stroke
from scipy.spatial import cKDTree

from keyphase.errors import SimulationError
from keyphase.simulation import workcell
from keyphase.simulation.impedance import Reference
from keyphase.simulation.replay.replay import Replay, ReplayOptions
from keyphase.skills.library import skills_of

HELD_S = 1.0
OFF_THE_PATH_M = 0.006
GENTLE_M_S2 = 3.0


def held_and_released(coupled: bool) -> tuple[float, float]:
    """Largest distance from the demonstrated path [m], and reference acceleration [m/s²]."""
    demonstration, segment = stroke()
    skills = skills_of(demonstration, [segment])
    simulation = workcell("setup1").build()
    replay = Replay(simulation, skills, demonstration, ReplayOptions(coupled))
    path = cKDTree(finely(demonstration.position_m))
    off, pulled, since = 0.0, 0.0, None
    while not replay.over:
        state = replay.step()
        if since is None and state.fraction >= 0.4:
            since = state.elapsed_s
            replay.hold(simulation.here())
        if since is not None and state.held and state.elapsed_s >= since + HELD_S:
            replay.hold(None)
        off = max(off, float(path.query(state.sample.position_m)[0]))
        pulled = max(pulled, float(np.linalg.norm(state.acceleration[:3])))
    assert replay.results[-1].outcome == "reached"
    return off, pulled


def finely(path_m):
    return np.concatenate([path_m[:-1] + u * np.diff(path_m, axis=0) for u in np.arange(0, 1, 0.1)])


def test_held_for_a_second_it_returns_to_the_path_gently() -> None:
    off, pulled = held_and_released(coupled=True)
    assert off < OFF_THE_PATH_M
    assert pulled < GENTLE_M_S2


def test_without_coupling_it_does_worse() -> None:
    off, _ = held_and_released(coupled=False)
    assert off > 2 * OFF_THE_PATH_M


def test_it_waits_as_long_as_it_is_held() -> None:
    replay = begun("setup1")
    state = replay.step()
    while state.skill != 1 or state.fraction < 0.3:
        state = replay.step()
    timeout_s = replay.skills[1].timeout_s
    replay.hold(replay.simulation.here())
    before = replay.state.fraction
    for _ in range(round((timeout_s + 1.0) * 250)):
        replay.step()
    assert replay.state.skill == 1
    crept = (replay.state.fraction - before) * replay.skills[1].primitive.duration_s
    assert crept < 0.15 * (timeout_s + 1.0)
    replay.hold(None)
    while not replay.over:
        replay.step()
    assert replay.result().succeeded


def test_a_push_moves_the_tool_but_the_sensor_does_not_feel_it() -> None:
    replay, other = begun("setup1"), begun("setup1")
    replay.push((0.0, 20.0, 0.0))
    aside, felt = [], []
    for _ in range(75):
        pushed, free = replay.step(), other.step()
        aside.append(pushed.sample.position_m[1] - free.sample.position_m[1])
        felt.append(pushed.sample.force_N[1])
    assert replay.state.held
    assert max(aside) > 0.003
    # What it does feel is the mass of the gripper, as long as the push accelerates it.
    assert abs(np.mean(felt)) < 1.0


def test_a_push_that_ends_leaves_the_replay_to_succeed() -> None:
    replay = begun("setup2")
    replay.push((0.0, 8.0, 0.0))
    for _ in range(150):
        replay.step()
    replay.push((0.0, 0.0, 0.0))
    while not replay.over:
        replay.step()
    assert replay.result().succeeded


def test_held_elsewhere_it_follows_the_hand() -> None:
    replay = begun("setup1")
    here = replay.simulation.here()
    up = here.position_m + np.array([0.0, 0.0, 0.03])
    replay.hold(Reference(up, here.orientation_wxyz))
    for _ in range(250):
        replay.step()
    assert np.linalg.norm(replay.state.sample.position_m - up) < 0.005


@pytest.mark.parametrize("force", [(1.0, 2.0), (0.0, 0.0, float("nan"))])
def test_what_is_no_force_is_refused(force) -> None:
    with pytest.raises(SimulationError, match="three finite numbers"):
        begun("setup1").push(force)
