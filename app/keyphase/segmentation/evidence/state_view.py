"""Contact as a state: a tight core of the wrench, free space, against everything else.

Steps alone miss a contact that comes over a second while the force swings. This second view asks
in which of two states each tenth of a second is, and where the state changes. Block means at
10 Hz, a mixture of two diagonal Gaussians by expectation maximisation from several starts, and
the most likely sequence of states, a change costing SWITCH nats.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.order_statistics import column_medians, median, quantile

RATE_HZ = 10.0
MIN_DURATION_S = 6.0
"""Shorter recordings show no state."""

SWITCH = 6.0
"""What a change of state costs, in nats."""

CLIP = 2.0
"""What a tenth of a second can say of its state, in nats."""

_ROUNDS = 25
_STARTS = 6
_START_S = 0.6
_FLOOR = 0.004
_APART = 0.15
_LEVEL = 0.25
_PRIOR = (0.05, 0.95)
_MAX_LOG = 50.0


@dataclass(frozen=True, eq=False)
class StateView:
    """Where a recording's wrench is free and where it is in contact.

    odds (n,)          log-odds of contact at each cell, -2 to 2
    contact (n,)       the most likely state
    crossings (X,)     cells at which it changes
    distance (n,)      of the wrench from the core, in sizes of the wrench
    core_spread        standard deviation of the core, over all channels
    separation         median distance in contact over the 95 % distance while free
    contact_distance   that median
    """

    odds: Array
    contact: np.ndarray
    crossings: Indices
    distance: Array
    core_spread: float
    separation: float
    contact_distance: float


def state_view(grid: Grid) -> StateView:
    """The view of a grid's wrench; one without crossings where the recording is too short."""
    assert grid.wrench is not None
    block = max(1, round(grid.rate_hz / RATE_HZ))
    count = len(grid) // block
    means = grid.wrench[: count * block].reshape(count, block, -1).mean(axis=1)
    if count < MIN_DURATION_S * RATE_HZ or grid.rate_hz < 0.5 * RATE_HZ:
        return _no_view(grid.wrench)
    odds, core, spread = _core_and_rest(means)
    odds = np.clip(odds, -CLIP, CLIP)
    states = most_likely_states(odds)
    if _begins_on_a_level(means, states, core):
        # Nothing is touched at first: the tight place is a hold, and what is around it is free.
        odds, states = -odds, ~states
        core, spread = np.median(means[~states], axis=0), means[~states].std(axis=0) + _FLOOR
    cells = np.arange(len(grid))
    middle = (np.arange(count) + 0.5) * block
    contact = states[np.minimum(cells // block, count - 1)]
    distance = np.linalg.norm(grid.wrench - core, axis=1)
    free = distance[~contact] if (~contact).any() else distance[:1]
    touching = median(distance[contact]) if contact.any() else median(free)
    return StateView(
        np.interp(cells, middle, odds),
        contact,
        (np.flatnonzero(np.diff(states)) + 1) * block,
        distance,
        float(np.linalg.norm(spread)),
        (touching + 0.01) / (quantile(free, 0.95) + 0.01),
        touching,
    )


def _begins_on_a_level(means: Array, contact: np.ndarray, core: Array) -> bool:
    """Whether a recording begins outside its core, on a level almost as tight beside the way
    between both."""
    if not contact[0] or contact.all():
        return False
    outside = means[contact]
    way = float(np.linalg.norm(np.median(outside, axis=0) - core))
    return float(np.linalg.norm(outside.std(axis=0))) < _LEVEL * way


def _no_view(wrench: Array) -> StateView:
    core = column_medians(wrench)
    distance = np.linalg.norm(wrench - core, axis=1)
    spread = float(np.linalg.norm(wrench.std(axis=0))) + _FLOOR
    none = np.zeros(0, dtype=np.intp)
    zero = np.zeros(len(wrench))
    return StateView(zero, zero > 0.0, none, distance, spread, 1.0, median(distance))


def _core_and_rest(means: Array) -> tuple[Array, Array, Array]:
    """Log-odds of "rest" (M,), mean and standard deviation (D,) of the core.

    All starts at once; the likeliest wins, a core far from the median wrench counting less.
    """
    core, start_var = _tight_places(means)
    channels, middle = means.shape[1], means.mean(axis=0)
    # What Gaussians without covariance and their moments need of every block.
    table = np.column_stack([means * means, means, np.ones(len(means))])
    sums = table.sum(axis=0)
    rest = np.repeat(middle[None], len(core), axis=0)
    rest_var = np.repeat((1.5 * means.var(axis=0) + _FLOOR**2)[None], len(core), axis=0)
    # Both Gaussians of every start in one array, the core first.
    mean = np.stack([core, rest])
    variance = np.stack([np.repeat(start_var[:, None], channels, axis=1), rest_var])
    prior = np.full((2, len(core)), 0.5)
    for _ in range(_ROUNDS):
        density = _density(mean, variance, prior)
        share = 1.0 / (1.0 + np.exp(np.minimum((density[1] - density[0]) @ table.T, _MAX_LOG)))
        inside = share @ table
        mean, variance = _moments(np.stack([inside, sums - inside]), channels)
        variance[0] += _FLOOR**2
        np.maximum(variance[1], 2.0 * variance[0], out=variance[1])
        prior[0] = np.minimum(np.maximum(inside[:, -1] / len(means), _PRIOR[0]), _PRIOR[1])
        prior[1] = 1.0 - prior[0]
    density = _density(mean, variance, prior)
    core, a, b = mean[0], density[0] @ table.T, density[1] @ table.T
    worth = np.logaddexp(a, b).mean(axis=1) - _APART * np.linalg.norm(core, axis=1)
    best = int(np.argmax(worth))
    return b[best] - a[best], core[best], np.sqrt(variance[0, best])


def _density(mean: Array, variance: Array, prior: Array) -> Array:
    """Log of prior times density, but for a constant, as factors (2, S, 2 D + 1) of the table."""
    channels, precision = mean.shape[-1], 1.0 / variance
    factors = np.empty((*prior.shape, 2 * channels + 1))
    np.multiply(precision, -0.5, out=factors[..., :channels])
    np.multiply(mean, precision, out=factors[..., channels:-1])
    constant = (mean * mean * precision + np.log(variance)).sum(axis=-1)
    factors[..., -1] = np.log(prior) - 0.5 * constant
    return factors


def _moments(sums: Array, channels: int) -> tuple[Array, Array]:
    """Mean and variance (2, S, D) from sums (2, S, 2 D + 1) over blocks."""
    count = sums[..., -1:] + 1e-9
    mean = sums[..., channels:-1] / count
    return mean, np.maximum(sums[..., :channels] / count - mean * mean, 0.0)


def _tight_places(means: Array) -> tuple[Array, Array]:
    """Mean (S, D) and start variance (S,) of the first, last and tightest windows."""
    width = round(_START_S * RATE_HZ)
    zero = np.zeros((1, means.shape[1]))
    sums = np.vstack([zero, np.cumsum(means, axis=0)])
    squares = np.vstack([zero, np.cumsum(means * means, axis=0)])
    mean = (sums[width:] - sums[:-width]) / width
    square = (squares[width:] - squares[:-width]) / width
    variance = np.maximum(square - mean * mean, 0.0).sum(axis=1)
    starts = [0, len(mean) - 1]
    apart = np.linalg.norm(mean - mean[0], axis=1)
    apart = np.minimum(apart, np.linalg.norm(mean - mean[-1], axis=1))
    while len(starts) < _STARTS and (apart > _APART).any():
        tightest = int(np.argmin(np.where(apart > _APART, variance, np.inf)))
        starts.append(tightest)
        apart = np.minimum(apart, np.linalg.norm(mean - mean[tightest], axis=1))
    start_var = 4.0 * variance[starts] / means.shape[1] + (3.0 * _FLOOR) ** 2
    return mean[starts], start_var


def most_likely_states(odds: Array) -> np.ndarray:
    """Which blocks (M,) are in contact, by dynamic programming over log-odds (M,) of contact."""
    stays = np.zeros((len(odds), 2), dtype=bool)
    free = touching = 0.0
    for block, half in enumerate((0.5 * odds).tolist()):
        from_free, from_touching = touching - SWITCH < free, free - SWITCH < touching
        stays[block] = from_free, from_touching
        free, touching = (
            (free if from_free else touching - SWITCH) - half,
            (touching if from_touching else free - SWITCH) + half,
        )
    states = np.zeros(len(odds), dtype=bool)
    state = touching > free
    for block in range(len(odds) - 1, -1, -1):
        states[block] = state
        if not stays[block, int(state)]:
            state = not state
    return states
