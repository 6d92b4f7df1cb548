"""Forces no sensor gives: constant, saturated, wandering at rest, helping the motion."""

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.doubtful_force import doubtful_force
from keyphase.oddities.oddity import Oddity, at_row, first_few
from keyphase.recorded_force import WINDOW_S, wander_at_rest

_MAX_FORCE_N = 5000.0
_MIN_FORCE_N = 0.05
_MIN_ROWS = 50
_MIN_RUN = 5
_MIN_LIMIT_N = 2.0
_SATURATED_SHARE = 0.01
_MIN_LEVELS = 30
_FROZEN_S, _FROZEN_TIMES, _FROZEN_M = 0.5, 10.0, 2e-3


def odd_size(demonstration: Demonstration) -> list[Oddity]:
    """Forces no arm bears, or too small for any contact."""
    force = demonstration.force_N
    if force is None:
        return []
    most = float(np.linalg.norm(force, axis=1).max())
    if most > _MAX_FORCE_N:
        text = f"The force reaches {most:.4g} N; is the unit of force_N right?"
    elif 0.0 < most < _MIN_FORCE_N:
        text = f"The force never exceeds {most:.2g} N; were kilonewtons read as newtons?"
    else:
        return []
    return [Oddity("scale", "warning", text)]


def constant_force(demonstration: Demonstration) -> list[Oddity]:
    """A component that never changes while the recording goes on."""
    force = demonstration.force_N
    if force is None or len(force) < _MIN_ROWS:
        return []
    still = [axis for axis, moved in zip("xyz", np.ptp(force, axis=0), strict=True) if not moved]
    if not still:
        return []
    what = "force_N never changes" if len(still) == 3 else f"force_N {' and '.join(still)} never"
    text = f"{what}{'' if len(still) == 3 else ' changes'}: was it measured?"
    return [Oddity("constant", "warning" if len(still) == 3 else "note", text)]


def frozen_force(demonstration: Demonstration) -> list[Oddity]:
    """A force that stands exactly still for long while the tool moves, and changes elsewhere.

    A force of zero is none: what subtracts small forces gives it where nothing is touched.
    """
    force, place = demonstration.force_N, demonstration.position_m
    if force is None or len(force) < _MIN_ROWS:
        return []
    edges = np.flatnonzero((force[1:] != force[:-1]).any(axis=1)) + 1
    first, last = np.append(0, edges), np.append(edges, len(force)) - 1
    lasting = demonstration.time_s[last] - demonstration.time_s[first]
    usual = float(np.quantile(lasting, 0.9))
    found = []
    for run in np.flatnonzero(lasting >= max(_FROZEN_S, _FROZEN_TIMES * usual)):
        rows = slice(int(first[run]), int(last[run]) + 1)
        moved = float(np.linalg.norm(np.ptp(place[rows], axis=0)))
        if len(lasting) < _MIN_ROWS or not force[rows.start].any() or moved < _FROZEN_M:
            continue
        text = (
            f"The force stands exactly still for {lasting[run]:.1f} s "
            f"{at_row(demonstration, rows.start)}, while the tool moves by {1e3 * moved:.0f} mm: "
            "the sensor or its link may have stopped; no contact is seen there."
        )
        span = float(demonstration.time_s[rows.start]), float(demonstration.time_s[last[run]])
        found.append(Oddity("frozen", "warning", text, span))
    return first_few(found)


def saturated_force(demonstration: Demonstration) -> list[Oddity]:
    """A component that stays at its greatest or least value, as a sensor at its limit does."""
    force = demonstration.force_N
    if force is None or len(force) < _MIN_ROWS:
        return []
    found = []
    for axis, column in zip("xyz", force.T, strict=True):
        if len(np.unique(column[:10_000])) < _MIN_LEVELS:
            continue
        for limit in (float(column.max()), float(column.min())):
            if abs(limit) < _MIN_LIMIT_N:
                continue
            at_limit = column == limit
            runs = _longest_run(at_limit)
            if runs >= _MIN_RUN and at_limit.mean() >= _SATURATED_SHARE:
                share = 100 * at_limit.mean()
                text = f"force_N {axis} stays at {limit:.4g} N for {share:.0f} % of the rows: " \
                    "the sensor may have been at its limit."  # fmt: skip
                found.append(Oddity("saturated", "warning", text))
    return found


def wandering_force(demonstration: Demonstration) -> list[Oddity]:
    """A force that changes while the tool stands still, as an estimated one does."""
    wander = wander_at_rest(demonstration)
    if wander == 0.0:
        return []
    text = (
        f"While the tool stands still the force wanders by {wander:.2g} N within {WINDOW_S:g} s; "
        "steps of that size are no contacts."
    )
    return [Oddity("wander", "warning", text)]


def helping_force(demonstration: Demonstration) -> list[Oddity]:
    """A force that helps the motion, though surroundings take power from a tool and give none."""
    doubt = doubtful_force(demonstration) if len(demonstration) >= _MIN_ROWS else None
    return [Oddity("sign", "warning", doubt)] if doubt else []


def _longest_run(flags: np.ndarray) -> int:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(np.int8), [0]])))
    return int((edges[1::2] - edges[::2]).max(initial=0))
