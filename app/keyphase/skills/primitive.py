"""A dynamical movement primitive of a pose: position and orientation driven by one phase.

Position and orientation share one form. With u the remaining displacement, six numbers,

    u = [g - y; 2 log(g_q * conj(q))]              metres and radians, base frame
    tau z' = alpha_z (beta_z u - z) + f(x)         velocity = z / tau
    tau x' = -alpha_x x                            the phase, from 1 towards 0
    f(x) = x (s * W psi(x) - b)                    psi: normalised radial basis functions

Position after Ijspeert et al. (2013), orientation after Ude et al. (2014). On a scaled axis s is
the whole displacement u at the start and b is zero; the motion then follows start and goal as in
Ijspeert. On an unscaled axis (no net displacement worth scaling) s is one, and b holds back the
change of the displacement against the demonstrated one until the phase has run out, after Pastor
et al. (2009), so that a moved goal is approached without a jump.
"""

from dataclasses import dataclass, field, fields
from functools import cached_property
from math import log

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import ParameterError
from keyphase.rotations import turns
from keyphase.rotations.components import Components, components, joined, number

PHASE_SPAN = 3.0
"""The duration in units of tau: the phase falls from 1 to exp(-3 alpha_x)."""

BASIS_WIDTH = 0.55
"""Standard deviation of a basis function in units of the distance to the next centre."""

_TINY = 1e-10
"""Added to the sum of the basis functions, as in `movement_primitives`."""


@dataclass(frozen=True)
class Constants:
    """Constants of the primitive and of its temporal coupling (Karlsson et al., 2017).

    alpha_z, beta_z     spring and damper of the primitive; beta_z = alpha_z / 4 is critical
    alpha_x             decay of the phase
    alpha_e             low-pass of the coupling error [1/s]
    k_c                 how strongly the error slows time down [1/m^2]
    k_p, k_v            feedback of the reference acceleration [1/s^2, 1/s]
    rotation_weight_m   metres of coupling error that one radian counts for

    Raises ParameterError for a value that is not positive.
    """

    alpha_z: float = 25.0
    beta_z: float = 6.25
    alpha_x: float = 1.0
    alpha_e: float = 5.0
    k_c: float = 1e4
    k_p: float = 25.0
    k_v: float = 10.0
    rotation_weight_m: float = 0.2

    def __post_init__(self) -> None:
        for name in (f.name for f in fields(self)):
            value = getattr(self, name)
            may_be_zero = name == "k_c" and value == 0.0
            if not (np.isfinite(value) and value > 0.0) and not may_be_zero:
                raise ParameterError(f"{name} of a primitive must be above zero, but is {value}.")

    @cached_property
    def error_weights(self) -> tuple[float, ...]:
        """Six, from metres and radians to the common measure of the coupling error [m]."""
        return (1.0,) * 3 + (self.rotation_weight_m,) * 3


@dataclass(frozen=True, eq=False)
class Primitive:
    """A fitted primitive; plain data, arrays are not to be changed.

    duration_s              of the motion it was fitted to
    start_position_m        (3,)  goal_position_m alike
    start_orientation_wxyz  (4,)  goal_orientation_wxyz alike, its sign continuous with the start
    centres, widths         (N,)  of the basis functions psi_i = exp(-widths_i/2 (x - centres_i)^2)
    weights                 (N, 6) of x y z [m] and of the rotation vector [rad]
    scaled                  (6,)  which axes scale with the displacement
    oriented                False where no orientation was recorded; it then keeps any it starts at
    """

    duration_s: float
    start_position_m: Array
    goal_position_m: Array
    start_orientation_wxyz: Array
    goal_orientation_wxyz: Array
    centres: Array
    widths: Array
    weights: Array
    scaled: Array
    oriented: bool = True
    constants: Constants = field(default_factory=Constants)

    @cached_property
    def displacement(self) -> Array:
        """(6,) from the demonstrated start to the demonstrated goal [m, rad]."""
        return remaining(
            self.goal_position_m,
            self.goal_orientation_wxyz,
            self.start_position_m,
            self.start_orientation_wxyz,
        )

    @cached_property
    def falloff(self) -> Array:
        """(N,) what the squared distance to a centre is multiplied with inside the exponential."""
        return -0.5 * self.widths

    @cached_property
    def summing_weights(self) -> Array:
        """(N, 7) the weights, and ones: what basis functions that are not normalised yet sum to."""
        return np.column_stack((self.weights, np.ones(len(self.weights))))


def tau_of(duration_s: Array | float) -> Array | float:
    """Time constant of a motion of this duration [s]."""
    return duration_s / PHASE_SPAN


def basis(count: int, alpha_x: float = 1.0) -> tuple[Array, Array]:
    """Centres and widths (count,) of basis functions that are evenly spread in time."""
    centres = np.exp(-PHASE_SPAN * alpha_x * np.arange(count) / (count - 1))
    widths = (BASIS_WIDTH * np.diff(centres)) ** -2
    return centres, np.append(widths, widths[-1])


def activations(phase: Array, centres: Array, widths: Array) -> Array:
    """Normalised basis functions (..., N) at phases (...)."""
    distance = phase[..., None] - centres
    psi = np.exp(-0.5 * widths * distance * distance)
    return psi / (np.add.reduce(psi, axis=-1, keepdims=True) + _TINY)


def remaining(goal_m: Array, goal_wxyz: Array, position_m: Array, wxyz: Array) -> Array:
    """Displacement u (..., 6) that is left to the goal: metres, then rotation vector in rad."""
    ahead = turns.difference(components(goal_wxyz), components(wxyz))
    return joined([*components(goal_m - position_m), *ahead])


def scale_and_hold(primitive: Primitive, displacement: Array) -> tuple[Array, Array]:
    """The s and b (..., 6) of the forcing term for a displacement from actual start to goal."""
    stiffness = primitive.constants.alpha_z * primitive.constants.beta_z
    scale = np.where(primitive.scaled, displacement, 1.0)
    change = stiffness * (displacement - primitive.displacement)
    return scale, np.where(primitive.scaled, 0.0, change)


def forcing(primitive: Primitive, phase: Array, scale: Array, hold: Array) -> Array:
    """Forcing term f (..., 6) at phases (...)."""
    return joined(forces(primitive, phase, components(scale), components(hold)))


def forces(primitive: Primitive, phase: Array, scale: Components, hold: Components) -> Components:
    """The same by component."""
    # Written for one phase at a time: normalising seven sums is cheaper than all basis functions.
    psi = np.subtract.outer(phase, primitive.centres)
    psi *= psi
    psi *= primitive.falloff
    *shape, total = components(np.exp(psi, psi).dot(primitive.summing_weights))
    x, share = number(phase), 1.0 / (total + _TINY)
    parts = zip(shape, scale, hold, strict=True)
    return [x * (share * w * s - b) for w, s, b in parts]


def transformation(constants: Constants, left: Array, z: Array, force: Array) -> Array:
    """tau z' (..., 6): the right-hand side of the transformation system, axis by axis."""
    return constants.alpha_z * (constants.beta_z * left - z) + force


def progress(primitive: Primitive, phase: float) -> float:
    """Fraction of the demonstrated duration that a phase stands for: 0 to 1 and beyond."""
    return -log(max(phase, 1e-300)) / (PHASE_SPAN * primitive.constants.alpha_x)
