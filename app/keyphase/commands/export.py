"""The command `keyphase export`: segments into other people's files."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import tyro

from keyphase.commands.saying import complain, say
from keyphase.errors import KeyphaseError

if TYPE_CHECKING:
    from keyphase.writers import SegmentedRecording


@dataclass(frozen=True)
class ExportSegments:
    """Write segments in another format; what it cannot carry is listed first."""

    segments: tyro.conf.Positional[tuple[Path, ...]]
    """Segment files, or folders of them."""
    to: str | None = None
    """The format; without, all formats are listed."""
    output: Path | None = None
    """Folder to write into; without, that of the segment files."""
    recipe: Path | None = None
    """How the recordings are read, where their own or their folder's recipe is not it (TOML)."""
    trim_idle: bool = False
    """Leave out idle ends, where the format can."""
    replace: bool = False
    """Replace files that keyphase did not write as they are."""
    dry_run: bool = False
    """Say what would be written and what is not carried, and write nothing."""

    def run(self) -> int:
        """List what is lost, then write, and name each file; what is refused comes last."""
        if self.to is None:
            return _list_formats()
        if not self.segments:
            raise KeyphaseError("Name at least one segment file or folder of them.")
        from keyphase.writers import Options, planned_export

        options = Options(self.trim_idle, "replace" if self.replace else "ask")
        items, refused = self._items(self.to)
        if refused and not items:
            return _refusals(refused)
        planned = planned_export(items, self.to, self._folder(), options)
        if planned.not_carried:
            say(f"{planned.writer.title} does not carry:")
        for one in planned.not_carried:
            say(f"  {one}")
        for one in planned.remarks:
            say(f"Note: {one}.")
        if self.dry_run:
            for file in planned.files:
                say(f"would write {file.target}")
            return _refusals(refused)
        for written in planned.write_each():
            if isinstance(written, KeyphaseError):
                refused.append(written)
            else:
                say(*written)
        return _refusals(refused)

    def _folder(self) -> Path:
        """Where to write: never just where somebody happens to stand."""
        if self.output is not None:
            return self.output
        folders = {one if one.is_dir() else one.parent for one in self.segments}
        if len(folders) > 1:
            raise KeyphaseError(
                "The segment files lie in several folders; say where to write with --output FOLDER."
            )
        return folders.pop()

    def _items(self, to: str) -> "tuple[list[SegmentedRecording], list[KeyphaseError]]":
        """The recordings that the format can hold, and why the others are refused."""
        from keyphase.writers import SegmentedRecording, found_segment_files, writer_named

        writer, items, refused = writer_named(to), [], list[KeyphaseError]()
        for file in found_segment_files(self.segments):
            try:
                item = SegmentedRecording.of_file(file, recipe=self.recipe)
                writer.requires(item)
                items.append(item)
            except KeyphaseError as error:
                refused.append(error)
        return items, refused


def _refusals(refused: list[KeyphaseError]) -> int:
    """Tell them; a single one as every command does."""
    if len(refused) == 1:
        raise refused[0]
    if refused:
        complain(f"{len(refused)} refused:")
    for error in refused:
        complain(f"  {error}")
    return 1 if refused else 0


def _list_formats() -> int:
    from keyphase.writers import WRITERS

    for writer in WRITERS:
        needs = f' (pip install "keyphase[{writer.extra}]")' if writer.extra else ""
        say(f"{writer.name:16} {writer.title}{needs}")
    return 0
