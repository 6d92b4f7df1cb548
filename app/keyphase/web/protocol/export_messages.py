"""What can be written, what was, and what is in the way of it."""

from collections.abc import Iterable
from pathlib import Path

from msgspec import Struct

from keyphase.workbench.exporting.beside import InTheWay
from keyphase.workbench.recordings import printable
from keyphase.writers import Offer, writer_named


class OfferLine(Struct, frozen=True):
    """A format as the recording can be written in it.

    file         the name of what it would become, from the folder of the recording
    not_carried  what of this recording it leaves behind
    remarks      what else a person should know
    reads_back   three lines of Python that read it
    refusal      why it cannot be written, or ""
    install      the command that brings what is missing, or ""
    copies       it is a copy of what was recorded
    trims        idle ends can be left out
    """

    name: str
    title: str
    file: str
    not_carried: tuple[str, ...]
    remarks: tuple[str, ...]
    reads_back: str
    refusal: str
    install: str
    copies: bool
    trims: bool


class OffersMessage(Struct, frozen=True, tag_field="type", tag="offers"):
    """The formats in which a recording can be written."""

    recording: str
    items: tuple[OfferLine, ...]


class Saved(Struct, frozen=True, tag_field="type", tag="saved"):
    """A file was written; `reads_back` are three lines of Python that read it, or ""."""

    path: str
    reads_back: str


class InTheWayMessage(Struct, frozen=True, tag_field="type", tag="in_the_way"):
    """Files that were not replaced, since keyphase did not write them as they are.

    kind  of the export that met them; ask again with `if_there` "replace" or "keep both"
    """

    recording: str
    kind: str
    files: tuple[InTheWay, ...]


def offers_message(recording: str, folder: Path, offers: Iterable[Offer]) -> OffersMessage:
    """Formats as a page is told of them; their files are named from `folder`."""
    return OffersMessage(recording, tuple(_line(offer, folder) for offer in offers))


def saved_message(path: Path, kind: str) -> Saved:
    """A file that was written in a format, or as a `page`."""
    lines = "" if kind == "page" else writer_named(kind).lines_reading(path)
    return Saved(printable(str(path)), printable(lines))


def _line(offer: Offer, folder: Path) -> OfferLine:
    target = offer.target
    inside = target.relative_to(folder) if target.is_relative_to(folder) else target
    return OfferLine(
        name=offer.name,
        title=offer.title[:1].upper() + offer.title[1:],
        file=printable(str(inside)),
        not_carried=offer.not_carried,
        remarks=offer.remarks,
        reads_back=printable(offer.reads_back),
        refusal=printable(offer.refusal),
        install=offer.install,
        copies=offer.copies,
        trims=offer.trims,
    )
