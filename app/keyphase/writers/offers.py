"""What can be written of the recording at work, for people to choose from."""

from dataclasses import dataclass
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
    """

    name: str
    title: str
    target: Path
    not_carried: tuple[str, ...]
    remarks: tuple[str, ...]
    reads_back: str
    refusal: str


def offers(labeling: Labeling, output: Path) -> tuple[Offer, ...]:
    """Every format in order, as `labeling` would be written into the folder `output`.

    Nothing is read but the first bytes of the recording. Raises SegmentFileError where the
    recording was never saved.
    """
    item = SegmentedRecording.of_labeling(labeling)
    return tuple(_offer(writer, item, output) for writer in WRITERS)


def _offer(writer: Writer, item: SegmentedRecording, output: Path) -> Offer:
    target = writer.target(item, output)
    lines = writer.reads_back.replace("PATH", str(target))
    try:
        _require_package(writer)
        planned = planned_export([item], writer.name, output)
    except KeyphaseError as error:
        return Offer(writer.name, writer.title, target, (), (), lines, str(error))
    return Offer(writer.name, writer.title, target, planned.not_carried, planned.remarks, lines, "")


def _require_package(writer: Writer) -> None:
    if writer.module and find_spec(writer.module) is None:
        raise KeyphaseError(
            f"{writer.title} needs the package '{writer.module}'; install it: "
            f'pip install "keyphase[{writer.extra}]".'
        )
