"""When the tool touches something, whatever constant the force sensor shows in free space."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.recorded_force import wander_at_rest
from keyphase.segmentation.bins import bins_of
from keyphase.segmentation.free_force import free_force, least_contact
from keyphase.segmentation.order_statistics import quantile
from keyphase.segmentation.paper.force import noise_variance
from keyphase.segmentation.segmentation import Change
from keyphase.segmentation.windows import WIDE_AFTER_S, WIDE_BEFORE_S

_NOISE_LEVELS = 6.0
_WANDERS = 2.0
_SHARE_OF_STRONGEST = 0.25
"""An estimated force wanders on: so many times what it does within some seconds is no contact, if
that is no more than this part of the strongest."""
_FALLEN = 0.75


@dataclass(frozen=True, eq=False)
class ContactForce:
    """The force of a recording above its free level, in bins.

    time_s (n,), force_N (n, 3) and touching (n,): whether it is more than noise and handling
    """

    time_s: Array
    force_N: Array
    touching: np.ndarray

    def change_at(self, time_s: float) -> Change:
        """What became of the contact at a contact change.

        Made out of free space, lost to it, released where the force falls by a quarter and stays
        a contact, else changed.
        """
        before, touching = self._around(time_s, WIDE_BEFORE_S)
        after, touching_after = self._around(time_s, WIDE_AFTER_S)
        if touching != touching_after:
            return "made" if touching_after else "lost"
        if not touching:
            return "made" if after > before else "lost"
        return "released" if after < _FALLEN * before else "changed"

    def _around(self, time_s: float, window_s: tuple[float, float]) -> tuple[float, bool]:
        """Size of the mean force [N] in a window, and whether most of it is contact."""
        first, last = np.searchsorted(self.time_s, (time_s + window_s[0], time_s + window_s[1]))
        first = min(int(first), len(self.time_s) - 1)
        window = slice(first, max(int(last), first + 1))
        mean = self.force_N[window].mean(axis=0)
        return float(np.sqrt(mean @ mean)), bool(self.touching[window].mean() > 0.5)


def contact_force_of(demonstration: Demonstration) -> ContactForce | None:
    """The force above the free level; None where none was recorded."""
    force = contact_force(demonstration)
    if force is None:
        return None
    touching = in_contact(force, wander_at_rest(demonstration))
    return ContactForce(bins_of(demonstration).time_s, force, touching)


def contact_force(demonstration: Demonstration) -> Array | None:
    """Binned force (n, 3) [N] above the level in free space; None where no force was recorded."""
    force = bins_of(demonstration).force
    return None if force is None else force - free_force(demonstration)


def in_contact(force_N: Array, wander_N: float = 0.0) -> np.ndarray:
    """In which bins (n,) a force above the free level is more than noise and handling.

    `wander_N` is what it does of itself while the tool stands still.
    """
    size = np.linalg.norm(force_N, axis=1)
    wander = min(_WANDERS * wander_N, _SHARE_OF_STRONGEST * quantile(size, 0.95))
    noise = float(np.sqrt(noise_variance(force_N).sum()))
    return size > max(least_contact(size), _NOISE_LEVELS * noise, wander)
