"""Fit a primitive to a path, by least squares or by locally weighted regression."""

import math
from typing import Literal

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import ParameterError, SkillError
from keyphase.rotations import quaternions
from keyphase.rotations.courses import angular_velocity
from keyphase.skills.primitive import (
    PHASE_SPAN,
    Constants,
    Primitive,
    activations,
    basis,
    remaining,
    tau_of,
)

Fit = Literal["least squares", "locally weighted"]

BASIS_COUNT: dict[Fit, int] = {"least squares": 25, "locally weighted": 15}
"""Basis functions per axis; fifteen, regressed locally, is what the paper does."""

PER_S, MOST = 8.0, 200
"""By least squares there are so many for each second of a long path, within the second number: who
wipes does so as fast in a long stretch as in a short one."""

SAMPLES_EACH, LEAST = 4, 5
"""And so many samples for each of a brief one, down to the second number: one of 60 ms with more
would follow the noise of its acceleration, which sets off with a kick."""

MIN_DISPLACEMENT = np.array([1e-3] * 3 + [1e-2] * 3)
"""Axes whose net displacement is below (1 mm, 0.01 rad) are not scaled."""

MAX_EXCURSION = 2.0
"""Nor are axes that swing wider than this many net displacements: scaling would magnify it."""

MIN_SAMPLES = 5
MAX_TURN_RAD = math.radians(225.0)
"""Beyond half a turn the logarithm pulls the long way round, and small errors across it grow; up
to here they stay below 0.5 degrees."""


def fit_primitive(
    time_s: Array,
    position_m: Array,
    orientation_wxyz: Array | None = None,
    *,
    fit: Fit = "least squares",
    basis_count: int | None = None,
    constants: Constants | None = None,
) -> Primitive:
    """Primitive that reproduces a path.

    time_s (M,) increasing, position_m (M, 3), orientation_wxyz (M, 4) continuous in sign or None.
    The weights make the forcing term follow f = tau^2 u'' - alpha_z (beta_z u - tau u') of the
    path, its derivatives by central differences.

    Raises SkillError for fewer than five samples, a path without duration, or a rotation by more
    than 225 degrees; ParameterError for fewer than two basis functions.
    """
    constants = constants or Constants()
    _refuse_short(time_s)
    count = _basis_count(fit, basis_count, time_s)
    wxyz = _orientations(orientation_wxyz, len(time_s))
    centres, widths = basis(count, constants.alpha_x)
    tau = float(tau_of(time_s[-1] - time_s[0]))
    left = remaining(position_m[-1], wxyz[-1], position_m, wxyz)
    _refuse_large_turn(left)
    scaled = _scaled_axes(left)
    phase = np.exp(-constants.alpha_x * (time_s - time_s[0]) / tau)
    target = _forcing_of_path(time_s, position_m, wxyz, left, tau, constants)
    drive = phase[:, None] * np.where(scaled, left[0], 1.0)
    weigh = least_squares_weights if fit == "least squares" else locally_weighted_weights
    return Primitive(
        duration_s=PHASE_SPAN * tau,
        start_position_m=position_m[0].copy(),
        goal_position_m=position_m[-1].copy(),
        start_orientation_wxyz=wxyz[0].copy(),
        goal_orientation_wxyz=wxyz[-1].copy(),
        centres=centres,
        widths=widths,
        weights=weigh(phase, drive, target, centres, widths),
        scaled=scaled,
        oriented=orientation_wxyz is not None,
        constants=constants,
    )


def _basis_count(fit: Fit, wanted: int | None, time_s: Array) -> int:
    if wanted is None:
        if fit != "least squares":
            return BASIS_COUNT[fit]
        of_long = min(math.ceil(PER_S * float(time_s[-1] - time_s[0])), MOST)
        of_brief = max(len(time_s) // SAMPLES_EACH, LEAST)
        return min(max(BASIS_COUNT[fit], of_long), of_brief)
    if wanted < 2:
        raise ParameterError(f"A primitive needs at least 2 basis functions, but got {wanted}.")
    return wanted


def least_squares_weights(
    phase: Array, drive: Array, target: Array, centres: Array, widths: Array
) -> Array:
    """Weights (N, D) with which drive * psi(phase) @ weights is nearest to the target (M, D).

    phase (M,), drive (M, D) is what multiplies the basis functions on each axis. As a drive
    is the phase times one factor per axis, one factorisation serves all axes.
    """
    design = activations(phase, centres, widths) * phase[:, None]
    weights = np.linalg.lstsq(design, target, rcond=None)[0]
    return weights * (phase[0] / drive[0])


def locally_weighted_weights(
    phase: Array, drive: Array, target: Array, centres: Array, widths: Array
) -> Array:
    """Weights (N, D), each fitted alone under its own basis function (Ijspeert et al., 2013)."""
    psi = np.exp(-0.5 * widths * (phase[:, None] - centres) ** 2)
    return (psi.T @ (drive * target)) / (psi.T @ (drive * drive) + 1e-12)


def _forcing_of_path(
    time_s: Array, position_m: Array, wxyz: Array, left: Array, tau: float, constants: Constants
) -> Array:
    velocity = np.hstack([np.gradient(position_m, time_s, axis=0), angular_velocity(time_s, wxyz)])
    acceleration = np.gradient(velocity, time_s, axis=0)
    spring = constants.alpha_z * (constants.beta_z * left - tau * velocity)
    return tau**2 * acceleration - spring


def _scaled_axes(left: Array) -> Array:
    net = np.abs(left[0])
    excursion = np.ptp(left, axis=0)
    return (net >= MIN_DISPLACEMENT) & (excursion <= MAX_EXCURSION * net)


def _orientations(wxyz: Array | None, rows: int) -> Array:
    return np.tile(quaternions.IDENTITY, (rows, 1)) if wxyz is None else wxyz


def _refuse_short(time_s: Array) -> None:
    if len(time_s) < MIN_SAMPLES or not time_s[-1] > time_s[0]:
        raise SkillError(
            f"A segment needs at least {MIN_SAMPLES} samples to become a skill, but has "
            f"{len(time_s)}; drop it or merge it with its neighbour."
        )


def _refuse_large_turn(left: Array) -> None:
    largest = float(np.sqrt((left[:, 3:] ** 2).sum(axis=1)).max())
    if largest > MAX_TURN_RAD:
        raise SkillError(
            f"A skill can turn by up to {np.degrees(MAX_TURN_RAD):.0f} degrees, but this "
            f"segment turns by {np.degrees(largest):.0f}; split it in two."
        )
