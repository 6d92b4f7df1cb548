"""What a skill presses: the contact at its end, and the forces it keeps up on its way."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array


@dataclass(frozen=True, eq=False)
class Press:
    """What a demonstration did right after the contact that ends a skill: it stayed and pressed.

    direction   (3,) unit vector in which it pressed, base frame
    force_N     how hard
    position_m  (3,) where the tool then was
    """

    direction: Array
    force_N: float
    position_m: Array


@dataclass(frozen=True, eq=False)
class KeptForce:
    """A force that is kept up while a skill moves, evenly over its demonstrated time.

    direction  (G, 3) unit vectors in which the tool presses, base frame
    force_N    (G,) what to press with; zero where the demonstration did not press
    met        whether the contact was met by a skill before: it is then pressed in any case, and
               else only while the tool touches something
    carries    how much sideways per press was demonstrated, where that was more than what slides:
               what is carried along is then gripped as much harder as it drags; None where it slid
    pushed_N   (G, 3) what the tool exerts besides while it touches, friction or a push along its
               way: there the pose is followed, and this added to what pulls towards it; or None
    """

    direction: Array
    force_N: Array
    met: bool = True
    carries: float | None = None
    pushed_N: Array | None = None

    def pushed_at(self, fraction: float) -> Array | None:
        """What is exerted besides (3,) [N] at a fraction of the demonstrated time, if anything."""
        if self.pushed_N is None:
            return None
        place = min(max(fraction, 0.0), 1.0) * self._last
        low = int(place)
        before, after = self.pushed_N[low], self.pushed_N[min(low + 1, self._last)]
        return before + (place - low) * (after - before)

    def at(self, fraction: float) -> tuple[Array, float] | None:
        """Direction (3,) and force [N] at a fraction (0 to 1) of the demonstrated time.

        None where nothing is pressed there. The force is linear in between, the direction that of
        the nearer moment.
        """
        place = min(max(fraction, 0.0), 1.0) * self._last
        low = int(place)
        share = place - low
        near = low + (share >= 0.5)
        before, after = self._forces[low], self._forces[min(low + 1, self._last)]
        if self._forces[near] <= 0.0:
            return None
        return self.direction[near], before + share * (after - before)

    @cached_property
    def _forces(self) -> list[float]:
        return self.force_N.tolist()

    @cached_property
    def _last(self) -> int:
        return len(self.force_N) - 1


def steady(direction: Array, force_N: float | Array, met: bool = True) -> KeptForce:
    """A force in one direction (3,), constant or given over the demonstrated time (G,)."""
    forces = np.atleast_1d(np.asarray(force_N, float))
    return KeptForce(np.tile(direction, (len(forces), 1)), forces, met)
