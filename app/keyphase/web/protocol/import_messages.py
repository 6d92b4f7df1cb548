"""What a page is told of recordings nobody has described yet."""

from msgspec import Struct

from keyphase.readers.proposing.answers import PARTS, Part
from keyphase.readers.recipes.units import Quantity, units_of
from keyphase.web.protocol.import_requests import TableAnswers, table_answers
from keyphase.workbench.importing.importing import Waiting
from keyphase.workbench.importing.unknown_table import Look, Tried

_QUANTITIES: dict[str, Quantity] = {
    "time": "time",
    "length": "length",
    "angle": "angle",
    "force": "force",
    "torque": "torque",
    "joints": "angle",
    "gripper": "opening",
}


class TableLook(Struct, frozen=True):
    """The recording as it would be read.

    name      which of the tools side by side in the file it is, "" where there is one
    path_m    points of the tool's path [m], in the robot's base frame
    time_s    when the force was as it is in `force_N` [s]
    force_N   sizes of the force [N]; null without a force
    notices   what would be done to it on reading
    """

    name: str
    samples: int
    duration_s: float
    rate_hz: float
    path_m: list[list[float]]
    time_s: list[float] | None
    force_N: list[float] | None
    notices: tuple[str, ...]


class TableProposal(Struct, frozen=True, tag_field="type", tag="table"):
    """A recording that waits for a person to say how it is read; what the answers come to so far.

    others           so many more files of its folder and kind nobody has described either
    is_text          whether it is a table of text; else columns of a binary format
    others_inside    so many more recordings are in the same file and read alike
    asked            what is asked beside columns and units
    clocks           columns that rise like a time
    names, rows      its columns and first rows, as the answers split them
    evidence         why each column was proposed to be what it is, "" where it was not
    layout_evidence  the same for encoding, separator, decimal and header
    missing          what is still to be said, or why it cannot be read so
    looks            the recording, where nothing is missing; of two tools in it one each
    recipe           the recipe (TOML), where nothing is missing
    choices          what a column can be
    units            what each quantity can be written in
    """

    id: str
    name: str
    others: int
    answers: TableAnswers
    is_text: bool
    others_inside: int
    asked: tuple[str, ...]
    clocks: tuple[str, ...]
    names: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    evidence: tuple[str, ...]
    layout_evidence: dict[str, str]
    missing: tuple[str, ...]
    looks: tuple[TableLook, ...]
    recipe: str | None
    choices: tuple[Part, ...]
    units: dict[str, tuple[str, ...]]


class TableDone(Struct, frozen=True, tag_field="type", tag="table_done"):
    """A table does not wait any more: it was taken in, or left."""

    id: str


def table_proposal(waiting: Waiting, tried: Tried) -> TableProposal:
    """The message about a table and the answers that were tried."""
    table, answers = waiting.table, tried.answers
    return TableProposal(
        id=waiting.id,
        name=table.name,
        others=waiting.others,
        answers=table_answers(answers),
        is_text=table.is_text,
        others_inside=table.others_inside,
        asked=answers.asked(),
        clocks=table.clocks,
        names=tried.names,
        rows=tried.rows,
        evidence=table.evidence,
        layout_evidence=table.layout_evidence,
        missing=tried.missing,
        looks=tuple(map(_look, tried.looks)),
        recipe=tried.recipe,
        choices=PARTS,
        units={name: units_of(quantity) for name, quantity in _QUANTITIES.items()},
    )


def _look(look: Look) -> TableLook:
    force = look.force_N
    return TableLook(
        name=look.name,
        samples=look.samples,
        duration_s=look.duration_s,
        rate_hz=look.rate_hz,
        path_m=look.path_m.tolist(),
        time_s=None if force is None else force[0].tolist(),
        force_N=None if force is None else force[1].tolist(),
        notices=look.notices,
    )
