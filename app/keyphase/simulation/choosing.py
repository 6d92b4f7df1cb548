"""Which world a recording is replayed in, and whether one that was chosen fits it."""

from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation.recorded.cell import NAME as RECORDING
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.simulated import Cell
from keyphase.simulation.workcells.own_cell import own_cell
from keyphase.simulation.workcells.registry import workcell, workcell_names

OWN = ".toml"
"""The name of a workcell that ends so is that of a file with one's own."""

AWAY_M, TURNED_RAD = 0.15, np.radians(45.0)
"""A recording that begins further from where a workcell's arm stands was made elsewhere."""


def cell_for(
    demonstration: Demonstration, name: str | None = None, robot: tuple[Path, str] | None = None
) -> Cell:
    """The workcell called `name`, one's own in a TOML file, or the world made from the recording.

    Without a name it is the workcell the recording was made in, and for every other recording the
    world made from it. `robot` is the file of another arm, URDF or MJCF, and its tool frame: it
    moves the tool in the world made from the recording.

    Raises SimulationError for a name nobody knows, a workcell that does not fit, an arm that does
    not reach the recording, and where a world would have to be made from one without force.
    """
    if robot is not None:
        if name not in (None, RECORDING):
            raise SimulationError(
                f"Another robot replays in the world made from the recording, but {name} was "
                "chosen, which has an arm of its own; leave --workcell or --robot out."
            )
        return RecordedCell(demonstration, robot)
    chosen = name or recorded_in(demonstration) or RECORDING
    if chosen == RECORDING:
        return RecordedCell(demonstration)
    if not chosen.endswith(OWN) and chosen not in workcell_names():
        raise SimulationError(
            f"Expected a workcell among {', '.join(world_names())}, or a file NAME{OWN} with one "
            f"of your own, but got '{chosen}'; choose one of these."
        )
    cell = own_cell(Path(chosen)) if chosen.endswith(OWN) else workcell(chosen)
    why = unfit(demonstration, cell)
    if why is not None:
        raise SimulationError(why)
    return cell


def world_names() -> tuple[str, ...]:
    """Names of all that a recording can be replayed in: workcells, and the world made from it."""
    return (*workcell_names(), RECORDING)


def world_in_words(name: str) -> str:
    """A world as people read of it: "setup1", "the world made from it"."""
    return "the world made from it" if name == RECORDING else name


def met_by(demonstration: Demonstration, cell: Cell) -> Demonstration:
    """What skills are made from for a workcell: in a world made from it, without its offset."""
    return cell.demonstration if isinstance(cell, RecordedCell) else demonstration


def recorded_in(demonstration: Demonstration) -> str | None:
    """The name of the workcell a recording was made in; None for a stranger's."""
    name = demonstration.metadata.get("workcell")
    return name if isinstance(name, str) and name in workcell_names() else None


def unfit(demonstration: Demonstration, cell: Cell) -> str | None:
    """Why a recording cannot be replayed in a workcell; None where it can be tried."""
    if isinstance(cell, RecordedCell):
        return None
    position, wxyz = cell.build().tool_pose()
    away = float(np.linalg.norm(demonstration.position_m[0] - position))
    turned = 0.0
    if demonstration.orientation_wxyz is not None:
        cosine = min(1.0, abs(float(wxyz @ demonstration.orientation_wxyz[0])))
        turned = 2.0 * float(np.arccos(cosine))
    if away <= AWAY_M and turned <= TURNED_RAD:
        return None
    return (
        f"{demonstration.name} does not fit {cell.name}: it begins {1e3 * away:.0f} mm and "
        f"{np.degrees(turned):.0f}° away from where the arm stands there. Replay it in the world "
        f"made from it (workcell '{RECORDING}'), or in a workcell of your own."
    )
