"""The weight of an unsubtracted tool, taken out of the wrench where it turns with the tool.

A sensor behind a tool sees its weight turn as the tool is turned: newtons come and go with nothing
touched. Where a weight that always points down explains nearly all of the force of the free
moments, it is taken away. How the sensor's axes lie in the tool is not known: any rotation of
them, or mirror, may be.
"""

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.grid import LEVER_M, Grid
from keyphase.segmentation.evidence.tool.lever import lever
from keyphase.segmentation.order_statistics import median, quantile

EXPLAINED = 0.9
"""Share of the force's variance that a weight must explain in the free moments."""

CHANGES_EXPLAINED = 0.3
"""And of the force's changes within a third of a second where the tool is turned most: two levels
that were there before and after one turn agree with any weight."""

TURNED = 0.15
"""The direction of gravity, seen from the tool, must spread by this much (root mean square)."""

_EVERY_S, _CHANGE_S = 0.1, 0.3
_MIN_CELLS = 30
_FREE_SHARE = 0.6
_ROUNDS = 6
_MOST_TURNED = 0.3


def without_weight(grid: Grid) -> Grid:
    """The grid with the tool's weight taken out of its wrench, or the same grid."""
    if grid.wrench is None or grid.pose_m.shape[1] < 6:
        return grid
    cells = np.arange(0, len(grid), grid.cells(_EVERY_S))
    down = _down(grid.pose_m[:, 3:] / LEVER_M)
    if len(cells) < _MIN_CELLS or down[cells].std(axis=0).max() < TURNED:
        return grid
    wrench = grid.wrench * grid.size_N
    felt, free, explained = _felt(wrench[cells, :3], down[cells])
    weight = down @ felt
    if explained < EXPLAINED:
        return grid
    if _changes_explained(wrench[cells, :3], weight[cells]) < CHANGES_EXPLAINED:
        return grid
    wrench[:, :3] -= weight
    if wrench.shape[1] > 3:
        known = weight[cells[free]]
        around = known - known.mean(axis=0)
        wrench[:, 3:] -= np.cross(lever(wrench[cells[free], 3:], around), weight)
    less = grid.with_wrench(wrench)
    # What leaves more than there was is no weight.
    return less if less.size_N <= grid.size_N else grid


def _down(rotation_rad: Array) -> Array:
    """Where down is (n, 3), seen from a tool that has turned by these rotation vectors (n, 3)."""
    angle = np.linalg.norm(rotation_rad, axis=1, keepdims=True)
    axis = -rotation_rad / np.maximum(angle, 1e-12)
    down = np.array([0.0, 0.0, -1.0])
    along = (axis @ down)[:, None] * (1.0 - np.cos(angle))
    return np.cos(angle) * down + np.sin(angle) * np.cross(axis, down) + along * axis


def _felt(force: Array, down: Array) -> tuple[Array, NDArray[np.bool_], float]:
    """The map (3, 3) from down to the weight that is felt, a rotation or mirror times newtons; of
    which moments (n,); and the share of their variance that it explains.

    By least trimmed squares: those moments count that fit best, in the others something may be
    touched.
    """
    kept, felt = np.ones(len(force), dtype=bool), np.zeros((3, 3))
    misfit = around = np.zeros(0)
    for _ in range(_ROUNDS):
        off, turned = force - force[kept].mean(axis=0), down - down[kept].mean(axis=0)
        left, stretch, right = np.linalg.svd(turned[kept].T @ off[kept])
        newton = stretch.sum() / (np.square(turned[kept]).sum() + 1e-12)
        felt = newton * left @ right
        around, misfit = np.square(off).sum(axis=1), np.square(off - turned @ felt).sum(axis=1)
        before, kept = kept, misfit <= quantile(misfit, _FREE_SHARE)
        if np.array_equal(before, kept):
            break
    return felt, kept, 1.0 - float(misfit[kept].sum()) / (float(around[kept].sum()) + 1e-12)


def _changes_explained(force: Array, weight: Array) -> float:
    """Share of the squared changes of the force that those of the weight explain, in the median of
    the moments at which the weight changes most."""
    lag = round(_CHANGE_S / _EVERY_S)
    force, weight = force[lag:] - force[:-lag], weight[lag:] - weight[:-lag]
    changed = np.square(weight).sum(axis=1)
    most = changed >= quantile(changed, 1.0 - _MOST_TURNED)
    whole = median(np.square(force[most]).sum(axis=1))
    return 1.0 - median(np.square(force[most] - weight[most]).sum(axis=1)) / (whole + 1e-12)
