"""The command `keyphase tidy`: what kills and renamed recordings have left in folders."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import tyro

from keyphase.commands.saying import complain, say
from keyphase.errors import KeyphaseError

if TYPE_CHECKING:
    from keyphase.labeling.storage.elsewhere import Elsewhere


@dataclass(frozen=True)
class Tidy:
    """Clear up after kills, and find the edits of recordings that were renamed or moved.

    Edits are found by the hash of the recording and only told, unless --take-over is given.
    """

    paths: tyro.conf.Positional[tuple[Path, ...]]
    """Recordings or folders of recordings."""
    take_over: bool = False
    """Give each renamed or moved recording the edits that were made under its former name."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""

    def run(self) -> int:
        """Clear up, then tell or take over; 1 where something could not be done."""
        from keyphase.labeling.storage.elsewhere import edits_elsewhere
        from keyphase.readers import find_recordings
        from keyphase.workbench.leftovers import clear_up

        if not self.paths:
            raise KeyphaseError("Name at least one recording or folder to tidy.")
        found = [one.path for one in find_recordings(self.paths, self.recipe)]
        folders = [path if path.is_dir() else path.parent for path in self.paths]
        for line in clear_up([*folders, *(path.parent for path in found)]):
            say(line)
        refused = 0
        for path in found:
            try:
                elsewhere = edits_elsewhere(path)
                if elsewhere is not None:
                    say(self._told(path, elsewhere))
            except KeyphaseError as error:
                complain(f"keyphase: {error}")
                refused += 1
        return 1 if refused else 0

    def _told(self, path: Path, elsewhere: "Elsewhere") -> str:
        edits = f"{elsewhere.steps} edits" if elsewhere.steps != 1 else "1 edit"
        if not self.take_over:
            return f"{path}: {edits} were made as {elsewhere.name} (--take-over takes them over)"
        from keyphase.labeling.storage.journal import Journal
        from keyphase.readers import load_recipe, read

        with Journal(read(path, load_recipe(self.recipe) if self.recipe else None)) as journal:
            journal.take_over(elsewhere)
        return f"{path}: took over {edits} made as {elsewhere.name}"
