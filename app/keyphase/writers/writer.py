"""What a writer is: one format that segments can be written in, and what it can hold of them."""

import json
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from keyphase.labeling.storage.written_files import IfThere
from keyphase.writers.carried import Carried
from keyphase.writers.segmented import SegmentedRecording


@dataclass(frozen=True)
class Options:
    """What a person may choose about an export.

    trim_idle  leave out the idle stretches before and after what was kept, where the format can
    if_there   what becomes of a file in the way that keyphase did not write as it is
    """

    trim_idle: bool = False
    if_there: IfThere = "ask"


Items = Sequence[SegmentedRecording]


def _nothing(_items: Items, _options: Options) -> Iterable[str]:
    return ()


def _takes_any(_item: SegmentedRecording) -> None:
    return None


@dataclass(frozen=True)
class Writer:
    """A format that segments are written in.

    name       what `--to` takes, and the page
    title      the format's name
    ending     how the names of its files end; "" where it is a copy of what was recorded
    extra      what installs it: pip install "keyphase[EXTRA]"; "" where nothing is needed
    carries    what it holds; all else is said before it is written
    write      recordings, target and options in; the files that were written out
    one_for    one file for each recording, or one for each file or dataset of recordings
    reads_back three lines of Python that read it; PATH stands for the file
    remarks    what else a person should know, always
    warn       what else these recordings lose
    trims      it can leave out idle ends
    copies     it writes a copy of what was recorded, which is never written over unasked
    requires   raises ExportError for a recording that it cannot hold
    module     the package that the extra installs, as it is imported
    """

    name: str
    title: str
    ending: str
    extra: str
    carries: frozenset[Carried]
    write: Callable[[Items, Path, Options], tuple[Path, ...]]
    reads_back: str
    one_for: Literal["recording", "container"] = "recording"
    remarks: tuple[str, ...] = ()
    warn: Callable[[Items, Options], Iterable[str]] = field(default=_nothing)
    trims: bool = False
    copies: bool = False
    requires: Callable[[SegmentedRecording], None] = field(default=_takes_any)
    module: str = ""

    def lines_reading(self, path: Path) -> str:
        """Three lines of Python that read what was written to `path`, whatever its name."""
        return self.reads_back.replace("PATH", json.dumps(str(path), ensure_ascii=False)[1:-1])

    def target(self, item: SegmentedRecording, output: Path) -> Path:
        """The file or folder that holds the recording, in the folder `output`."""
        if self.one_for == "container":
            return output / item.container.name
        return output / f"{item.name}{self.ending}"
