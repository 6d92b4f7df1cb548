"""Workcells by name: the two that come with keyphase, and those that others add."""

from keyphase.errors import SimulationError
from keyphase.simulation.workcells.workcell import Workcell

_added: dict[str, Workcell] = {}
"""The one place where workcells from outside are kept; `register` writes it."""


def register(cell: Workcell) -> None:
    """Make `cell` known by its name to everything that takes the name of a workcell.

    Raises SimulationError for a name that is taken by another workcell.
    """
    taken = _known().get(cell.name)
    if taken is not None and taken is not cell:
        raise SimulationError(
            f"The name of a workcell must be its own, but '{cell.name}' is that of "
            f"'{taken.title}'; give yours another name."
        )
    _added[cell.name] = cell


def workcell_names() -> tuple[str, ...]:
    """Names of all workcells there are."""
    return tuple(_known())


def workcell(name: str) -> Workcell:
    """The workcell called `name`.

    Raises SimulationError for a name nobody knows.
    """
    known = _known()
    if name not in known:
        raise SimulationError(
            f"The workcell must be one of {', '.join(known)}, but is '{name}'; choose one of these."
        )
    return known[name]


def _known() -> dict[str, Workcell]:
    from keyphase.simulation.workcells.setup1 import SETUP1
    from keyphase.simulation.workcells.setup2 import SETUP2

    return {cell.name: cell for cell in (SETUP1, SETUP2)} | _added
