"""The same equations as an independent implementation, to 1e-9.

`movement_primitives` spans the phase differently (tau is the duration, alpha_x = -ln 0.01), does
not scale with the displacement, and evaluates the phase one sample ahead of the state. Its basis
and derivatives are taken over and its integration emulated here, with our equations inside.
"""

import numpy as np
import pytest
from movement_primitives import dmp
from numpy.testing import assert_allclose
from strokes import DURATION_S, TIME_S, H, stroke, turn

from keyphase.rotations import quaternions
from keyphase.skills.fitting import least_squares_weights
from keyphase.skills.primitive import (
    PHASE_SPAN,
    Constants,
    Primitive,
    forcing,
    remaining,
    transformation,
)

ONES, NOTHING = np.ones(6), np.zeros(6)


@pytest.fixture(scope="module")
def theirs():
    model = dmp.CartesianDMP(DURATION_S, dt=H, n_weights_per_dim=25, int_dt=H)
    model.imitate(TIME_S, np.hstack([stroke(), turn(90.0)]))
    return model


@pytest.fixture(scope="module")
def ours(theirs):
    """Their basis and weights in our primitive."""
    term = theirs.forcing_term_pos
    weights = np.hstack([term.weights_.T, theirs.forcing_term_rot.weights_.T])
    return Primitive(
        duration_s=PHASE_SPAN * DURATION_S,
        start_position_m=stroke()[0],
        goal_position_m=stroke()[-1],
        start_orientation_wxyz=turn(90.0)[0],
        goal_orientation_wxyz=turn(90.0)[-1],
        centres=term.centers,
        widths=2.0 * term.widths,
        weights=weights,
        scaled=np.zeros(6, dtype=bool),
        constants=Constants(alpha_x=term.alpha_z),
    )


def phase_at(primitive, time_s):
    return np.array(np.exp(-primitive.constants.alpha_x * time_s / DURATION_S))


def acceleration(primitive, position, wxyz, velocity, phase):
    left = remaining(primitive.goal_position_m, primitive.goal_orientation_wxyz, position, wxyz)
    force = forcing(primitive, phase, ONES, NOTHING)
    z = DURATION_S * velocity
    return transformation(primitive.constants, left, z, force) / DURATION_S**2


def runge_kutta(primitive, count):
    """Positions by their fourth-order steps, the phase one sample ahead."""
    identity = primitive.goal_orientation_wxyz
    position, velocity = primitive.start_position_m, np.zeros(3)
    path = [position]

    def slope(position, velocity, time):
        full = np.append(velocity, np.zeros(3))
        return acceleration(primitive, position, identity, full, phase_at(primitive, time))[:3]

    for k in range(1, count):
        ahead = k * H
        one = slope(position, velocity, ahead)
        two = slope(position + H / 2 * velocity, velocity + H / 2 * one, ahead + H / 2)
        half = velocity + H / 2 * one
        three = slope(position + H / 2 * half, velocity + H / 2 * two, ahead + H / 2)
        half = velocity + H / 2 * two
        four = slope(position + H * half, velocity + H * three, ahead + H)
        position = position + H * (velocity + H / 6 * (one + two + three))
        velocity = velocity + H / 6 * (one + 2 * two + 2 * three + four)
        path.append(position)
    return np.array(path)


def semi_implicit_orientation(primitive, count):
    """Orientations by their Euler steps, the phase one sample ahead."""
    wxyz, velocity = primitive.start_orientation_wxyz, np.zeros(6)
    goal = primitive.goal_position_m
    path = [wxyz]
    for k in range(1, count):
        rate = acceleration(primitive, goal, wxyz, velocity, phase_at(primitive, k * H))
        velocity = velocity + H * rate
        turned = quaternions.from_rotation_vector(H * velocity[3:])
        wxyz = quaternions.product(turned, wxyz)
        path.append(wxyz)
    return np.array(path)


def test_the_weights_of_a_least_squares_fit_agree(theirs):
    position_only = dmp.DMP(3, DURATION_S, dt=H, n_weights_per_dim=25, int_dt=H)
    position_only.imitate(TIME_S, stroke())
    term = position_only.forcing_term
    velocity = np.gradient(stroke(), axis=0) / H
    velocity[-1] = 0.0
    rate = np.gradient(velocity, axis=0) / H
    rate[-1] = 0.0
    spring = 25.0 * (6.25 * (stroke()[-1] - stroke()) - DURATION_S * velocity)
    phase = np.exp(-term.alpha_z * TIME_S / DURATION_S)
    drive = np.repeat(phase[:, None], 3, axis=1)
    weights = least_squares_weights(
        phase, drive, DURATION_S**2 * rate - spring, term.centers, 2.0 * term.widths
    )
    assert_allclose(weights.T, term.weights_, rtol=0, atol=1e-9 * np.abs(term.weights_).max())


def test_positions_agree_when_integrated_alike(theirs, ours):
    theirs.reset()
    _, poses = theirs.open_loop(step_function="rk4-cython")
    assert_allclose(runge_kutta(ours, len(poses)), poses[:, :3], rtol=0, atol=1e-9)


def test_orientations_agree_when_integrated_alike(theirs, ours):
    theirs.reset()
    _, poses = theirs.open_loop(quaternion_step_function="cython")
    assert_allclose(semi_implicit_orientation(ours, len(poses)), poses[:, 3:], rtol=0, atol=1e-9)
