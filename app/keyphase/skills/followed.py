"""The force a skill follows by the recorded state of contact, and what it drags along with it."""

import numpy as np
from scipy.ndimage import uniform_filter1d

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.end_condition.travel import RATE_HZ, sampled
from keyphase.skills.pressed import KeptForce
from keyphase.skills.skill import Skill

FOLLOWED_N = 1.0
"""A recorded force above this is followed."""

MAX_ALONG = 0.7
"""It is not followed where more than this part of it lies along the way: there it is a push."""

SLOW_M_S = 0.008
"""A tool slower than this does not move."""

SETTLED_S = 0.1
"""A contact that is made within a skill is followed from so long after it on."""

MET_S, TOWARDS = 0.3, 0.5
"""What is exerted so shortly before a contact ends the skill, and by more than this part towards
it, is that contact, and not followed."""

MIN_FORCE_N = 0.5
"""A demonstration that presses less than this keeps no contact."""

MIN_SLIDE_M = 0.01
"""A way shorter than this says nothing about the surface."""

WINDOW_S = 0.2
"""The demonstrated force is averaged over this time: the hand's tremor is not to be repeated."""

SLIDES_BELOW = 0.8
"""What is pushed aside by less than this part of its press may slide; by more, it is carried."""

_CARRIED_QUANTILE = 0.9

GRID_PER_S, MIN_GRID, MAX_GRID = 25.0, 51, 1001
"""Directions and forces are kept so often, within these numbers."""

_FORCE_WINDOW_S, _WAY_WINDOW_S = 0.2, 0.1


def followed_force(demonstration: Demonstration, skill: Skill, free_N: Array) -> KeptForce | None:
    """Where the demonstration of a skill presses without moving along its force, that force.

    The direction presses against the recorded force, without the friction that lies along the
    way; the force is averaged over 0.2 s. What was exerted besides, that friction or a push along
    the way, is what is pushed. None where nothing is to be followed. `free_N` (3,) is
    the force in free space.
    """
    if skill.demonstrated_s is None or demonstration.force_N is None:
        return None
    moments, position, force = sampled(demonstration, *skill.demonstrated_s)
    assert force is not None
    if len(moments) < 3:
        return None
    smooth = _mean(force - free_N, _FORCE_WINDOW_S)
    velocity = np.gradient(_mean(position, _WAY_WINDOW_S), 1.0 / RATE_HZ, axis=0)
    speed = np.linalg.norm(velocity, axis=1)
    moves = speed > SLOW_M_S
    way = velocity / np.maximum(speed, 1e-9)[:, None]
    # Friction lies along the way: what presses the surface is square to it.
    friction = np.where(moves, (smooth * way).sum(axis=1), 0.0)
    normal = smooth - friction[:, None] * way
    size = np.linalg.norm(normal, axis=1)
    along = np.abs((smooth * way).sum(axis=1)) / np.maximum(np.linalg.norm(smooth, axis=1), 1e-9)
    pressed = size > FOLLOWED_N
    direction = -normal / np.maximum(size, 1e-9)[:, None]
    free = _ends_it(skill, moments, -smooth)
    follows = _settled(pressed) & (~moves | (along < MAX_ALONG)) & ~free
    touched = (np.linalg.norm(smooth, axis=1) > FOLLOWED_N) & ~free
    if not touched.any():
        return None
    pushed = np.where(
        touched[:, None], -smooth - np.where(follows, size, 0.0)[:, None] * direction, 0.0
    )
    count = int(np.clip(round(GRID_PER_S * (moments[-1] - moments[0])), MIN_GRID, MAX_GRID))
    rows = np.round(np.linspace(0, len(moments) - 1, count)).astype(int)
    profile = np.where(follows, size, 0.0)[rows]
    return KeptForce(direction[rows], profile, met=False, pushed_N=pushed[rows])


def _ends_it(skill: Skill, moments: Array, exerted_N: Array) -> np.ndarray:
    """Where what the tool exerts (N, 3) is the contact that is to end the skill.

    Followed, it would never rise beyond what was followed.
    """
    end = skill.end_condition
    if not isinstance(end, ContactEnd) or end.release:
        return np.zeros(len(moments), bool)
    towards = -exerted_N @ np.asarray(end.direction)
    near = moments > moments[-1] - MET_S
    return near & (towards > TOWARDS * np.linalg.norm(exerted_N, axis=1))


def _settled(pressed: np.ndarray) -> np.ndarray:
    """Where it is pressed and has been so for 0.1 s, or since the beginning."""
    window = max(round(SETTLED_S * RATE_HZ), 1)
    padded = np.concatenate([np.full(window, pressed[0]), pressed])
    held = np.cumsum(padded)
    return (held[window:] - held[:-window]) >= window


def _mean(values: Array, window_s: float) -> Array:
    return uniform_filter1d(values, max(round(window_s * RATE_HZ), 1), axis=0, mode="nearest")


def before_contact(skill: Skill) -> tuple[float, float]:
    """The stretch in which nothing but what is kept resists: not the contact that ends a skill."""
    assert skill.demonstrated_s is not None
    start_s, end_s = skill.demonstrated_s
    end = skill.end_condition
    met = isinstance(end, ContactEnd) and not end.release
    return start_s, max(end_s - MET_S, 0.5 * (start_s + end_s)) if met else end_s


def carried(force_N: Array, path: Array, direction: Array, rate_hz: float) -> float | None:
    """Drag per force pressed, where it was too much for anything to slide; else None.

    What is carried along drags against the way; a wall that is slid along pushes square to it.
    """
    slid = path[-1] - path[0]
    slid = slid - float(slid @ direction) * direction
    length = float(np.linalg.norm(slid))
    if length < MIN_SLIDE_M:
        return None
    pressed = -(force_N @ direction)
    aside = np.maximum(-(force_N @ (slid / length)), 0.0)
    smooth = smoothed(pressed, rate_hz)
    firm = smooth >= MIN_FORCE_N
    if not firm.any():
        return None
    share = float(np.quantile(smoothed(aside, rate_hz)[firm] / smooth[firm], _CARRIED_QUANTILE))
    return share if share > SLIDES_BELOW else None


def smoothed(values: Array, rate_hz: float) -> Array:
    """Running mean; at the ends over what is there."""
    window = np.ones(min(max(1, round(WINDOW_S * rate_hz)), len(values)))
    return np.convolve(values, window, "same") / np.convolve(np.ones(len(values)), window, "same")
