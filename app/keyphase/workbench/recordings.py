"""Recordings as lines of a list: what is known of each without having it open."""

import hashlib
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from keyphase.errors import KeyphaseError
from keyphase.files.parts import stem_of
from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.labeling.storage.summary import summarize
from keyphase.workbench.grid.stretches import Stretch, frozen_stretches
from keyphase.workbench.showing.doubts import Piece

State = Literal["automatic", "touched", "done"]


@dataclass(frozen=True)
class Recording:
    """One line of the list.

    state, confidence, unsure, strip   what its segmentation has come to; empty until looked at
    assessment                         what a person thinks of it as a whole
    marked                             what is said of single segments
    stretches                          its segments with names; empty until they are known
    differences                        how often another person's segments differ, if there are any
    changed_since_done                 segments were changed after it was done
    error                              why it cannot be opened
    """

    id: str
    path: Path
    state: State = "automatic"
    confidence: float | None = None
    unsure: int = 0
    strip: tuple[Piece, ...] = ()
    error: str | None = None
    assessment: Assessment = NOTHING_SAID
    marked: tuple[Assessment, ...] = ()
    stretches: tuple[Stretch, ...] = ()
    differences: int | None = None
    changed_since_done: bool = False

    @property
    def name(self) -> str:
        """The file's name for people, whatever bytes it is made of."""
        return printable(stem_of(self.path))


def recording_at(path: Path) -> Recording:
    """A line for a file, with what its journal says before anybody has looked at it.

    Its id follows from where it is, so that a page finds it again after the server has restarted.
    """
    line = Recording(_id(path), path)
    try:
        said = summarize(path)
    except KeyphaseError as error:
        return replace(line, error=str(error))
    except Exception as error:
        return replace(line, error=defect(path, error))
    state = "done" if said.done else "touched" if said.touched else "automatic"
    seen = frozen_stretches(said.frozen) if said.frozen else ()
    return replace(
        line,
        state=state,
        changed_since_done=said.changed_since_done,
        assessment=said.assessment,
        marked=said.marked,
        stretches=seen,
    )


def defect(path: Path, error: Exception) -> str:
    """What is said of a recording over which keyphase itself fails; the others go on."""
    return (
        f"{printable(path.name)}: something is wrong inside keyphase with this recording "
        f"({type(error).__name__}: {printable(str(error))[:200]}); the others go on. "
        "Please report it."
    )


def folder_name(recordings: Sequence[Recording]) -> str:
    """Name of the folder all recordings share, or nothing."""
    folders = {recording.path.parent for recording in recordings}
    return printable(folders.pop().name) if len(folders) == 1 else ""


def printable(name: str) -> str:
    """A file name as text that can be sent; bytes that are no text become a mark."""
    return name.encode("utf-8", "replace").decode("utf-8")


def _id(path: Path) -> str:
    return hashlib.blake2b(os.fsencode(path.absolute()), digest_size=6).hexdigest()
