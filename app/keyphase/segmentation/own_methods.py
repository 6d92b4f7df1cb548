"""Methods of other people's: a function that finds boundaries, registered by a name.

    def halves(demonstration, parameters):
        return [FoundBoundary(demonstration.start_s + 0.5 * demonstration.duration_s)]

    register_method("halves", halves)
    segment(demonstration, Parameters(variant="halves"))

Segments, labels and end conditions are made from its boundaries as from our own. A package of its
own registers one by an entry point in the group `keyphase.methods`, so that commands and page find
it without an import.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import entry_points
from typing import TYPE_CHECKING, Protocol

from keyphase.errors import ParameterError

if TYPE_CHECKING:
    from keyphase.demonstration import Demonstration
    from keyphase.segmentation.parameters import Parameters

OWN_VARIANTS = ("evidence", "paper")
"""The names that are taken: those of our own methods."""

ENTRY_POINTS = "keyphase.methods"


@dataclass(frozen=True)
class FoundBoundary:
    """A boundary as a method of one's own finds it.

    time_s          within the demonstration
    contact_change  whether contact was made, lost or changed there
    confidence      0 to 1
    interval_s      (earliest, latest) it may lie; None: no wider than it is
    """

    time_s: float
    contact_change: bool = False
    confidence: float = 1.0
    interval_s: tuple[float, float] | None = None


class BoundaryMethod(Protocol):
    """Finds the boundaries of a demonstration, in any order."""

    def __call__(
        self, demonstration: "Demonstration", parameters: "Parameters", /
    ) -> Iterable[FoundBoundary]:
        """Raises KeyphaseError for a demonstration it cannot work on."""
        ...


class Methods:
    """Methods by name; those of installed packages are loaded when first asked for."""

    def __init__(self) -> None:
        self._registered: dict[str, BoundaryMethod] = {}

    def register(self, name: str, method: BoundaryMethod) -> None:
        """Make a method known; the same name again takes the place of the former one.

        Raises ParameterError for a name that is one of ours or no plain word.
        """
        if name in OWN_VARIANTS or not name.isidentifier():
            raise ParameterError(
                f"A method's name must be a plain word other than {', '.join(OWN_VARIANTS)}, "
                f"but is {name!r}."
            )
        self._registered[name] = method

    @property
    def names(self) -> tuple[str, ...]:
        """All names, those of installed packages included."""
        packaged = (entry.name for entry in entry_points(group=ENTRY_POINTS))
        return tuple(dict.fromkeys((*OWN_VARIANTS, *self._registered, *packaged)))

    def get(self, name: str) -> BoundaryMethod:
        """The method of this name. Raises ParameterError where there is none."""
        if name not in self._registered:
            for entry in entry_points(group=ENTRY_POINTS, name=name):
                self.register(name, entry.load())
        if name not in self._registered:
            raise ParameterError(f"variant must be one of {', '.join(self.names)}, not {name!r}.")
        return self._registered[name]


METHODS = Methods()
"""The one register of a program."""


def register_method(name: str, method: BoundaryMethod) -> None:
    """Make a method of one's own known under a name that `Parameters.variant` may then be.

    Raises ParameterError for a name that is one of ours or no plain word.
    """
    METHODS.register(name, method)


def checked(found: Iterable[FoundBoundary], start_s: float, end_s: float) -> list[FoundBoundary]:
    """What a method found, in order; raises ParameterError for what no boundary can be."""
    boundaries = sorted(found, key=lambda boundary: boundary.time_s)
    for i, one in enumerate(boundaries):
        inside = math.isfinite(one.time_s) and start_s < one.time_s < end_s
        apart = i == 0 or one.time_s > boundaries[i - 1].time_s
        if not (inside and apart and 0.0 <= one.confidence <= 1.0):
            raise ParameterError(
                f"A method must find boundaries within ({start_s:g}, {end_s:g}) s, each once and "
                f"with a confidence from 0 to 1, but found {one}."
            )
    return boundaries
