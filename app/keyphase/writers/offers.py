"""What can be written of the recording at work, for people to choose from."""

from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.labeling.labeling import Labeling
from keyphase.writers.exporting import planned_export
from keyphase.writers.registry import WRITERS
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Writer


@dataclass(frozen=True)
class Offer:
    """A format as the recording at work can be written in it.

    target       the file or folder it would become
    not_carried  what of this recording the format leaves behind
    remarks      what else a person should know
    reads_back   three lines of Python that read the target
    refusal      why it cannot be written, or "" where it can
    install      the command that brings what is missing, or ""
    copies       it is a copy of what was recorded
    trims        idle ends can be left out
    """

    name: str
    title: str
    target: Path
    not_carried: tuple[str, ...]
    remarks: tuple[str, ...]
    reads_back: str
    refusal: str
    install: str = ""
    copies: bool = False
    trims: bool = False


def offers(labeling: Labeling, output: Path, copies: Path | None = None) -> tuple[Offer, ...]:
    """Every format in order, as `labeling` would be written into the folder `output`.

    Copies of what was recorded would go into the folder `copies`, below it one of each format's
    name. Nothing is read but the first bytes of the recording. Raises SegmentFileError where the
    recording was never saved.
    """
    item = SegmentedRecording.of_labeling(labeling)
    return tuple(
        _offer(
            writer,
            item,
            copies / writer.name if copies and writer.one_for == "container" else output,
        )
        for writer in WRITERS
    )


def _offer(writer: Writer, item: SegmentedRecording, output: Path) -> Offer:
    target = writer.target(item, output)
    offer = Offer(
        name=writer.name,
        title=writer.title,
        target=target,
        not_carried=(),
        remarks=(),
        reads_back=writer.lines_reading(target),
        refusal="",
        copies=writer.copies,
        trims=writer.trims,
    )
    if writer.module and find_spec(writer.module) is None:
        install = f'pip install "keyphase[{writer.extra}]"'
        needs = f"{writer.title} needs the package '{writer.module}'; install it: {install}."
        return replace(offer, refusal=needs, install=install)
    try:
        planned = planned_export([item], writer.name, output)
    except KeyphaseError as error:
        return replace(offer, refusal=str(error))
    return replace(offer, not_carried=planned.not_carried, remarks=planned.remarks)
