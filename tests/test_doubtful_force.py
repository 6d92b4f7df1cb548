"""A force that stands in another frame than is said is told, and no other one."""

from dataclasses import replace

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.doubtful_force import doubtful_force, power_share
from keyphase.recorded_force import evenly
from keyphase.rotations import quaternions

PRESSED_N, FRICTION, RADIUS_M, TURNED_RAD = 12.0, 0.3, 0.2, 1.2


def over_a_ball(seconds: float = 4.0) -> Demonstration:
    """A tool slides over a quarter of a cylinder and turns with it; friction is against its way."""
    time = np.arange(round(250 * seconds)) / 250
    angle = TURNED_RAD * (1.0 - np.cos(np.pi * time / seconds)) / 2.0
    zero = np.zeros_like(time)
    normal = np.c_[np.sin(angle), zero, np.cos(angle)]
    way = np.c_[np.cos(angle), zero, -np.sin(angle)]
    wxyz = quaternions.from_rotation_vector(np.c_[zero, angle, zero])
    force = PRESSED_N * (normal - FRICTION * way)
    return Demonstration("ball", time, RADIUS_M * normal, wxyz, force)


def over_a_table(seconds: float = 4.0) -> Demonstration:
    """A tool is tilted to and fro while it slides to and fro on a table."""
    time = np.arange(round(250 * seconds)) / 250
    tilt, place = 0.9 * np.sin(2.0 * time), 0.1 * np.sin(3.0 * time)
    zero = np.zeros_like(time)
    rubbed = -0.1 * PRESSED_N * np.tanh(np.gradient(place, time) / 0.01)
    force = np.c_[rubbed, zero, zero + PRESSED_N]
    wxyz = quaternions.from_rotation_vector(np.c_[zero, tilt, zero])
    return Demonstration("table", time, np.c_[place, 0.02 * time, zero], wxyz, force)


def seen(demonstration: Demonstration, wxyz: np.ndarray) -> Demonstration:
    """The recording with its force turned."""
    assert demonstration.force_N is not None
    pure = np.c_[np.zeros(len(demonstration)), demonstration.force_N]
    turned = quaternions.product(quaternions.product(wxyz, pure), quaternions.conjugate(wxyz))
    return replace(demonstration, force_N=turned[:, 1:])


def firmer(demonstration: Demonstration) -> np.ndarray:
    """Forces (N, 1) that begin soft, as one that is there from the beginning is an offset."""
    return PRESSED_N * np.minimum(0.2 + demonstration.time_s, 1.0)[:, None]


def turns(demonstration: Demonstration) -> np.ndarray:
    assert demonstration.orientation_wxyz is not None
    return demonstration.orientation_wxyz


def test_a_force_that_turns_with_the_surface_or_stays_on_a_table_is_not_doubted() -> None:
    assert doubtful_force(over_a_ball()) is None
    assert doubtful_force(over_a_table()) is None


def test_a_force_that_keeps_its_direction_while_way_and_tool_turn_is_doubted() -> None:
    ball = over_a_ball()
    up = firmer(ball) * [0.0, 0.0, 1.0]
    steep = replace(ball, position_m=ball.position_m @ [[0.6, 0, -0.8], [0, 1, 0], [0.8, 0, 0.6]])
    told = str(doubtful_force(replace(steep, force_N=up)))
    assert "keeps its direction in the base" in told
    assert "the sensor's frame" in told


def test_what_is_lifted_and_turned_keeps_its_direction_and_is_not_doubted() -> None:
    ball = over_a_ball()
    weight = firmer(ball) * [0.0, 0.0, -1.0]
    lifted = replace(ball, position_m=ball.position_m[::-1])
    assert doubtful_force(replace(lifted, force_N=weight)) is None


def test_a_force_of_the_base_that_is_said_to_be_the_tools_is_doubted() -> None:
    table = over_a_table()
    told = str(doubtful_force(seen(table, turns(table))))
    assert "explained by contact if it is the base's, not the tool's" in told


def test_a_force_of_the_tool_that_is_said_to_be_the_bases_is_doubted() -> None:
    table = over_a_table()
    told = str(doubtful_force(seen(table, quaternions.conjugate(turns(table)))))
    assert "explained by contact if it is the tool's, not the base's" in told


def test_a_force_that_helps_in_one_moment_alone_is_not_doubted() -> None:
    ball = over_a_ball()
    force = np.array(ball.force_N)
    force[400:550] *= -1.0
    found = power_share(evenly(replace(ball, force_N=force)))
    assert found is not None
    share, error = found
    assert share < 3.0 * error
    assert doubtful_force(replace(ball, force_N=force)) is None
