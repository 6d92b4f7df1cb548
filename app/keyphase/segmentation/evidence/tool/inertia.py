"""The inertia of an unsubtracted tool, taken out of the wrench where it explains the force.

A sensor behind a tool of a kilogram or two shows newtons as the hand sets off and stops. Where mass
times acceleration explains most of the force of the free moments, that much is taken away.
"""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.speed import SMOOTHING_HZ, Speed
from keyphase.segmentation.evidence.tool.lever import lever
from keyphase.segmentation.filters import smoothed
from keyphase.segmentation.order_statistics import column_medians, median, quantile

EXPLAINED = 0.5
"""Share of the force's variance that inertia must explain."""

JUMPS_EXPLAINED = 0.3
"""And of the force's changes within a tenth of a second where the acceleration changes most: a
contact that rattles while the tool all but stands agrees with any mass."""

MASSES_KG = (0.05, 15.0)
"""Of what is taken for a tool; forces may be told with either sign."""

_MIN_RATE_HZ = 8.0
_MIN_CELLS = 30
_MOVING = 0.1
_FREE_SHARE = 0.6
_ROUNDS = 6
_JUMP_S = 0.1
_FASTEST = 0.3


def without_inertia(grid: Grid, speed: Speed) -> Grid:
    """The grid with the tool's inertia taken out of its wrench, or the same grid."""
    if grid.wrench is None or speed.fast_m_s <= 0.0 or grid.rate_hz < _MIN_RATE_HZ:
        return grid
    step_s = 1.0 / grid.rate_hz
    velocity = np.gradient(speed.pose_m[:, :3], step_s, axis=0)
    acceleration = np.gradient(velocity, step_s, axis=0)
    force = grid.wrench[:, :3] * grid.size_N
    force = smoothed(force, min(SMOOTHING_HZ, 0.35 * grid.rate_hz), grid.rate_hz)
    moving = speed.speed_m_s > _MOVING * speed.fast_m_s
    mass, explained, free = _mass_kg(force[moving], acceleration[moving])
    if explained < EXPLAINED or not MASSES_KG[0] <= abs(mass) <= MASSES_KG[1]:
        return grid
    if _jumps_explained(force, acceleration, moving, mass, grid.cells(_JUMP_S)) < JUMPS_EXPLAINED:
        return grid
    wrench = grid.wrench * grid.size_N
    wrench[:, :3] -= mass * acceleration
    if wrench.shape[1] > 3:
        cells = np.flatnonzero(moving)[free]
        wrench[:, 3:] -= np.cross(lever(wrench[cells, 3:], acceleration[cells]), acceleration)
    return grid.with_wrench(wrench)


def _jumps_explained(
    force: Array, acceleration: Array, moving: np.ndarray, mass: float, lag: int
) -> float:
    """Share of the squared changes of the force over `lag` cells that mass times the change of
    acceleration explains, in the median of the moments at which that changes most."""
    force = (force[lag:] - force[:-lag])[moving[lag:]]
    acceleration = (acceleration[lag:] - acceleration[:-lag])[moving[lag:]]
    if len(force) < _MIN_CELLS:
        return 0.0
    changed = np.square(acceleration).sum(axis=1)
    most = changed >= quantile(changed, 1.0 - _FASTEST)
    whole = median(np.square(force[most]).sum(axis=1))
    left = median(np.square(force[most] - mass * acceleration[most]).sum(axis=1))
    return 1.0 - left / (whole + 1e-12)


def _mass_kg(force: Array, acceleration: Array) -> tuple[float, float, np.ndarray]:
    """Force over acceleration, the share of variance that explains, and of which moments (n,), by
    least trimmed squares: those count that fit best, in the others something may be touched.
    """
    if len(force) < _MIN_CELLS:
        return 0.0, 0.0, np.zeros(len(force), dtype=bool)
    kept, mass = np.ones(len(force), dtype=bool), 0.0
    around, misfit = force, np.zeros(len(force))
    for _ in range(_ROUNDS):
        around = force - column_medians(force[kept])
        square = float(np.square(acceleration[kept]).sum())
        mass = float((around[kept] * acceleration[kept]).sum()) / (square + 1e-12)
        misfit = np.square(around - mass * acceleration).sum(axis=1)
        before, kept = kept, misfit <= quantile(misfit, _FREE_SHARE)
        if np.array_equal(before, kept):
            break
    whole = float(np.square(around[kept]).sum())
    return mass, 1.0 - float(misfit[kept].sum()) / (whole + 1e-12), kept
