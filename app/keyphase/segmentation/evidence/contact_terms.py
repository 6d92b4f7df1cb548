"""What there is to see at each place where contact may have changed.

Every term is a logarithm of a dimensionless ratio wherever that makes sense, so that sums of them
are odds. CONTACT_TERMS names them in plain words.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.force_curve import FINE, ForceCurves, force_curves, peaks
from keyphase.segmentation.evidence.friction import taken_back, with_the_way
from keyphase.segmentation.evidence.grid import MIN_CELLS, Grid
from keyphase.segmentation.evidence.placing import placed
from keyphase.segmentation.evidence.speed import Speed
from keyphase.segmentation.evidence.state_view import StateView, state_view
from keyphase.segmentation.evidence.wander import least_step
from keyphase.segmentation.evidence.windows import Sides, Windows
from keyphase.segmentation.order_statistics import median

CONTACT_TERMS: Mapping[str, str] = {
    "over_quiet_side": "step over the unrest on its quieter side",
    "over_busy_side": "step over the unrest on its busier side",
    "slow_over_quiet": "slow change over the unrest beside it",
    "stays": "the force stays changed for 0.2 s",
    "stays_long": "the force stays changed for 0.5 s",
    "stays_slow": "the force has changed a second later",
    "echo": "ringing of an earlier impact",
    "newton": "size of the step",
    "strength": "how strong the force is in this recording",
    "sharpness": "sharpness of the step",
    "dominance": "strongest step within a second",
    "vibration": "vibration begins or ends",
    "stopping": "the tool slows down or sets off",
    "near_rest": "the tool moves on both sides",
    "standing": "the tool stands on both sides",
    "over_core": "change over what the force does when nothing is touched",
    "over_wander": "change over what the force does all the time",
    "with_the_way": "the force goes with the direction of motion",
    "taken_back": "friction turns round with the motion",
    "inside_free": "smaller than contact, and free on both sides",
    "crossing": "contact as a state changes here",
    "state": "free before, in contact after, or the other way",
    "lasts": "both states last",
    "separation": "contact stands clear of free space",
    "blurred": "contact and free space run into one another",
    "contact_newton": "force while in contact",
}
"""Each term of a contact change and what it says."""

RAMP_BREADTH = 2.0
"""What no fine scale sees is seen over half a second, two of the usual minimal distances."""

ENDS_S = 0.26
"""Nearer to an end nobody sees whether the force stays changed: no candidate lies there."""

_NEW_CROSSING_S = 0.15
_STEP_GAP_S, _STEP_LENGTH_S = 0.08, 0.2
_ECHO_S = (0.1, 1.5)
_ECHO_FADES_S = 0.7
_BESIDE_S = 1.0
_PARTED = 1.0
"""Contact that is not e times as far from free space as free space is wide may be its wander."""
_STRENGTH_N = (0.5, 1.5)
"""A wrench that is never stronger than the lower one shows what it does of itself; from the upper
one on something may be touched, and more says no more."""


@dataclass(frozen=True, eq=False)
class ContactCandidates:
    """Where contact may have changed, C places in time order.

    cell (C,)       where the change is put
    seen (C,)       where it was seen: at a peak of a force curve, or a change of state
    interval (C, 2) first and last cell of the rise or fall
    terms (C, T)    one column per CONTACT_TERMS
    step (C, 3)     mean force after minus before, in sizes of the wrench
    least_step      a step smaller than this is what the force does of itself, in the same unit
    """

    cell: Indices
    seen: Indices
    interval: Indices
    terms: Array
    step: Array
    least_step: float = 0.0


def contact_candidates(grid: Grid, speed: Speed) -> ContactCandidates:
    """Every candidate of a grid with its evidence; none without force."""
    if grid.wrench is None or len(grid) < MIN_CELLS:
        return _none()
    curves, view = force_curves(grid), state_view(grid)
    at = _cells(grid, curves, view)
    if not len(at):
        return _none()
    look = _Look(grid, speed, curves, view, at)
    terms = {**_steps(look), **_persistence(look), **_around(look), **_states(look)}
    cell, interval = placed(grid, curves, view, at, look.tops)
    table = np.column_stack([terms[name] for name in CONTACT_TERMS])
    gap, length = round(_STEP_GAP_S * grid.rate_hz), grid.cells(_STEP_LENGTH_S)
    step = Sides(look.windows, cell, gap, length).jump[:, :3]
    return ContactCandidates(cell, at, interval, table, step, least_step(grid, view, speed))


def breadth(terms: Array) -> Array:
    """How many minimal distances each candidate (C,) keeps from likelier ones: a ramp right before
    or after a likelier step is the slow scales' view of that step."""
    sharpness = terms[:, list(CONTACT_TERMS).index("sharpness")]
    return np.where(sharpness < np.log(0.5), RAMP_BREADTH, 1.0)


def _none() -> ContactCandidates:
    cells, pairs = np.zeros(0, dtype=np.intp), np.zeros((0, 2), dtype=np.intp)
    return ContactCandidates(
        cells, cells, pairs, np.zeros((0, len(CONTACT_TERMS))), np.zeros((0, 3))
    )


def _cells(grid: Grid, curves: ForceCurves, view: StateView) -> Indices:
    """Peaks of the curves, and changes of state that no peak is near."""
    found = peaks(curves, grid.rate_hz)
    crossings = view.crossings
    if len(found) and len(crossings):
        after = np.searchsorted(found, crossings)
        nearest = np.minimum(
            np.abs(crossings - found[np.maximum(after - 1, 0)]),
            np.abs(crossings - found[np.minimum(after, len(found) - 1)]),
        )
        crossings = crossings[nearest > _NEW_CROSSING_S * grid.rate_hz]
    cells = np.union1d(found, crossings).astype(np.intp)
    margin = ENDS_S * grid.rate_hz
    return cells[(cells > margin) & (cells < len(grid) - 1 - margin)]


class _Look:
    """Everything the terms of one recording are computed from."""

    def __init__(
        self, grid: Grid, speed: Speed, curves: ForceCurves, view: StateView, at: Indices
    ) -> None:
        assert grid.wrench is not None
        self.grid, self.speed, self.curves, self.view, self.at = grid, speed, curves, view, at
        self.windows = Windows(grid.wrench)
        self.tops = curves.tops(at, grid.rate_hz)
        quiet = curves.quiet[:FINE, at]
        clear = np.log(self.tops[:FINE]) + np.minimum(np.log(self.tops[:FINE] / quiet), 3.0)
        self.best = clear.argmax(axis=0), np.arange(len(at))
        self.top = self.tops[:FINE][self.best]

    def sides(self, gap_s: float, length_s: float) -> Sides:
        cells = self.grid.rate_hz
        return Sides(self.windows, self.at, round(gap_s * cells), max(1, round(length_s * cells)))


def _steps(look: _Look) -> dict[str, Array]:
    """How large the step is, and beside what."""
    curves, at, top = look.curves, look.at, look.top
    quiet, busy = curves.quiet[:FINE, at][look.best], curves.busy[:FINE, at][look.best]
    slow, fast = look.tops[3], look.tops[1]
    return {
        "over_quiet_side": np.log(top / quiet).clip(-1.0, 4.0),
        "over_busy_side": np.log(top / busy).clip(-2.0, 3.0),
        "slow_over_quiet": np.log(slow / curves.quiet[3, at]).clip(-1.0, 4.0),
        "newton": np.log((top * look.grid.size_N).clip(0.05, 20.0)),
        "strength": np.full(len(at), np.log(np.clip(look.grid.size_N, *_STRENGTH_N))),
        "sharpness": np.log(fast / slow),
    }


def _persistence(look: _Look) -> dict[str, Array]:
    """Whether the force stays changed, beside its scatter on both sides."""
    spread = 2.0 * look.view.core_spread
    jump = look.sides(0.15, 0.6).jump_size + 1e-3
    return {
        "stays": _stays(look.sides(0.06, 0.2)),
        "stays_long": _stays(look.sides(0.06, 0.5)),
        "stays_slow": _stays(look.sides(0.32, 0.64)),
        "over_core": np.log(jump / (spread + 0.01)).clip(-3.0, 4.0),
        "over_wander": np.log(jump / (_wander(look) + 0.01)).clip(-3.0, 4.0),
    }


def _stays(sides: Sides) -> Array:
    scatter = sides.scatter_before + sides.scatter_after + 0.02
    return np.log((sides.jump_size + 1e-3) / scatter)


def _wander(look: _Look) -> float:
    """The ordinary change of the force over the same time: the median over the recording."""
    grid = look.grid
    cells = np.arange(0, len(grid), max(1, round(0.1 * grid.rate_hz)))
    ordinary = Sides(look.windows, cells, round(0.15 * grid.rate_hz), grid.cells(0.6))
    return median(ordinary.jump_size)


def _around(look: _Look) -> dict[str, Array]:
    """What else happens there: stronger steps, ringing, vibration, the tool's own motion."""
    from scipy.ndimage import maximum_filter1d

    grid, at = look.grid, look.at
    fine = np.maximum(look.curves.step[1], look.curves.step[2])
    strongest = maximum_filter1d(fine, 2 * grid.cells(_BESIDE_S) + 1)[at] + 1e-3
    before, after = look.speed.beside(at)
    fast = look.speed.fast_m_s
    slower, faster = np.minimum(before, after), np.maximum(before, after)
    moves = fast > 0.0
    return {
        "dominance": np.log(np.maximum(look.tops[1], look.tops[2]) / strongest),
        "echo": _echo(look),
        "vibration": _vibration(look),
        "with_the_way": with_the_way(grid, look.speed, look.windows, look.view, at),
        "taken_back": taken_back(grid, look.speed, look.windows, look.view, at),
        "stopping": np.abs(np.log((before + 0.05 * fast) / (after + 0.05 * fast)))
        if moves
        else np.zeros(len(at)),
        "near_rest": np.log((slower + 0.02 * fast) / fast) if moves else np.zeros(len(at)),
        "standing": np.maximum(0.0, -np.log((faster + 1e-3) / 1e-2)),
    }


def _echo(look: _Look) -> Array:
    """The faded echo of an earlier, stronger step over the own one."""
    grid, at, row = look.grid, look.at, look.curves.step[0]
    first, last = (round(seconds * grid.rate_hz) for seconds in _ECHO_S)
    lags = np.arange(first + 1, min(last, len(row) - 1) + 1)
    faded = np.exp(-lags / grid.rate_hz / _ECHO_FADES_S)
    earlier = at[:, None] - lags
    echoes = np.where(earlier >= 0, row[earlier], 0.0) * faded
    strongest = echoes.max(axis=1, initial=0.0)
    return np.log((strongest + 0.01) / (np.maximum(look.tops.max(axis=0), row[at]) + 0.01))


def _vibration(look: _Look) -> Array:
    vibration = look.grid.vibration
    if vibration is None:
        return np.zeros(len(look.at))
    sides = Sides(Windows(vibration), look.at, 0, look.grid.cells(0.3))
    floor = 1e-3 * float(vibration.mean()) + 1e-12
    before, after = sides.mean_before[:, 0] + floor, sides.mean_after[:, 0] + floor
    return np.abs(np.log(np.maximum(before, 0.0) / after)).clip(0.0, 6.0)


def _states(look: _Look) -> dict[str, Array]:
    """What the view of contact as a state says."""
    grid, view, at = look.grid, look.view, look.at
    crossing = lasts = np.zeros(len(at))
    if len(view.crossings):
        nearest = np.abs(_nearest(view.crossings, at)) / grid.rate_hz
        crossing = np.exp(-((nearest / 0.3) ** 2))
        edges = np.concatenate([[0], view.crossings, [len(grid)]])
        shorter = np.minimum(np.diff(edges)[:-1], np.diff(edges)[1:]) / grid.rate_hz
        lasts = np.log(shorter.clip(0.1, 3.0) / 0.1)[_nearest_index(view.crossings, at)] * crossing
    odds = Sides(Windows(view.odds), at, grid.cells(0.1), grid.cells(0.8))
    separation = np.log(view.separation).clip(-1.0, 4.0)
    contact_N = np.clip(view.contact_distance * grid.size_N, 0.05, 20.0)
    return {
        "inside_free": _inside_free(look, crossing),
        "crossing": crossing,
        "state": np.abs(odds.jump[:, 0]) / 4.0,
        "lasts": lasts,
        "separation": np.full(len(at), separation),
        "blurred": np.full(len(at), max(0.0, _PARTED - separation)),
        "contact_newton": np.full(len(at), np.log(contact_N)),
    }


def _inside_free(look: _Look, crossing: Array) -> Array:
    """How much smaller the step is than the force in contact (ln), where both sides are free.

    Stiction and wander of an estimated wrench make steps, too, but not to the level of contact.
    """
    view, grid = look.view, look.grid
    if not len(view.crossings):
        return np.zeros(len(look.at))
    states = Sides(Windows(view.contact.astype(float)), look.at, grid.cells(0.1), grid.cells(0.8))
    touching = np.maximum(states.mean_before[:, 0], states.mean_after[:, 0])
    jump = look.sides(0.15, 0.6).jump_size + 1e-3
    smaller = np.log((view.contact_distance + 1e-3) / jump).clip(0.0, 4.0)
    return smaller * (1.0 - crossing) * (touching < 0.1)


def _nearest_index(places: Indices, at: Indices) -> Indices:
    after = np.searchsorted(places, at).clip(1, max(len(places) - 1, 1))
    after = np.minimum(after, len(places) - 1)
    before = np.maximum(after - 1, 0)
    return np.where(np.abs(places[before] - at) <= np.abs(places[after] - at), before, after)


def _nearest(places: Indices, at: Indices) -> Indices:
    return places[_nearest_index(places, at)] - at
