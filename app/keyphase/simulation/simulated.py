"""What a replay needs of a world it runs in, and of what builds it.

A `Workcell` builds a `Simulation`; a world made from a recording is another such pair.
"""

from collections.abc import Mapping
from typing import Any, Protocol

from keyphase.demonstration import Array
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.impedance import Gains, Reference
from keyphase.simulation.part_shapes import Shape
from keyphase.simulation.simulation import Sample

Poses = Mapping[str, tuple[Array, Array]]
"""Position (3,) and orientation (4,), w x y z, by name, base frame."""


class Simulated(Protocol):
    """Something in motion, with a tool in it on an impedance; lengths in metres, base frame."""

    start_parts: Poses

    @property
    def workcell(self) -> "Cell":
        """What built it."""
        ...

    @property
    def disturbance(self) -> Disturbance:
        """How it differs from the nominal world."""
        ...

    @property
    def gains(self) -> Gains:
        """Of the impedance."""
        ...

    @property
    def bodies(self) -> tuple[str, ...]:
        """Names of all that can be drawn: links, then parts."""
        ...

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of what `Sample.contact_N` holds."""
        ...

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Of the driven joints, in the order of `Sample.joints_rad`; none without a robot."""
        ...

    def step(self, reference: Reference) -> Sample:
        """One control tick of 4 ms."""
        ...

    def be_at(self, moment_s: float | None, span_s: tuple[float, float] | None) -> None:
        """The moment of the demonstration that is being repeated, and the skill's stretch of it."""
        ...

    def exert(self, force_N: Array, torque_Nm: Array) -> None:
        """A hand on the tool exerts this until told otherwise; no sensor feels it."""
        ...

    def tool_pose(self) -> tuple[Array, Array]:
        """Position (3,) and orientation (4,)."""
        ...

    def tool_velocity(self) -> Array:
        """Velocity (6,) in m/s and rad/s."""
        ...

    def here(self) -> Reference:
        """The reference that keeps the tool where it is."""
        ...

    def frame(self) -> tuple[Array, Array]:
        """Positions (B, 3) and orientations (B, 4) of `bodies`."""
        ...

    def part_poses(self) -> Poses:
        """Where the parts are."""
        ...

    def shapes(self) -> tuple[Shape, ...]:
        """What the parts look like."""
        ...


class Cell(Protocol):
    """What builds worlds, and says what success in them is."""

    @property
    def name(self) -> str:
        """For commands and files."""
        ...

    @property
    def title(self) -> str:
        """For people."""
        ...

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the bodies that are no robot."""
        ...

    @property
    def onsets(self) -> tuple[str, ...]:
        """Which contacts are contact changes of the task."""
        ...

    @property
    def events(self) -> tuple[Any, ...]:
        """What has to happen, in this order."""
        ...

    def build(self, disturbance: Disturbance = NOMINAL, seed: int = 0) -> Simulated:
        """A world at its start."""
        ...

    def checks(self, world: Any, /) -> Mapping[str, bool]:
        """What has to hold at the end."""
        ...

    def goals(self, world: Any, /) -> tuple[str, ...]:
        """Names of all that success asks."""
        ...
