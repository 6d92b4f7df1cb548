"""Recordings that wait for a person at one page to say how they are read."""

import itertools
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from keyphase.errors import KeyphaseError, RequestError
from keyphase.files.parts import split_part
from keyphase.files.writing import write_whole
from keyphase.readers import FOLDER_RECIPE, RECIPE_SUFFIX, find_recordings
from keyphase.readers.proposing.answers import Answers
from keyphase.workbench.apart.apart import Calls, right_here
from keyphase.workbench.importing.alike_tables import alike_tables
from keyphase.workbench.importing.unknown_table import Tried, UnknownTable
from keyphase.workbench.uploads import Upload

Scope = Literal["file", "folder"]
"""Whether a recipe is for one file or for all tables of its folder."""


@dataclass(frozen=True)
class Waiting:
    """A recording that waits; `upload` is there where it was sent and has no name of its own yet.

    others  so many more files of its kind in its folder, or sent with it, nobody has described
            either
    """

    id: str
    table: UnknownTable
    folder: Path
    upload: Upload | None
    others: int


class Importing:
    """The tables one page is asked about, in the order they came. For many threads.

    calls  how what reads them is called: here, or in another process
    """

    def __init__(self, calls: Calls = right_here) -> None:
        self._calls = calls
        self._lock = threading.Lock()
        self._waiting: dict[str, Waiting] = {}
        self._numbers = itertools.count(1)

    @property
    def ids(self) -> set[str]:
        """Those that wait now."""
        with self._lock:
            return set(self._waiting)

    def ask_about_upload(self, upload: Upload) -> Waiting:
        """Wait for what a person says of a file that was sent.

        Raises DemonstrationError where it holds no numbers.
        """
        table = UnknownTable(upload.part, upload.name, self._calls)
        return self._wait(table, upload.folder, upload)

    def ask_about(self, path: Path) -> Waiting:
        """Wait for what a person says of a recording on disk; once, however often it is asked.

        Of one in a file of many the file is asked about. Raises DemonstrationError where it holds
        no numbers.
        """
        path = split_part(path)[0]
        with self._lock:
            known = next((one for one in self._waiting.values() if one.table.path == path), None)
        return known or self._wait(UnknownTable(path, path.name, self._calls), path.parent, None)

    def find(self, id: str) -> Waiting:
        """One that waits. Raises RequestError where it does not any more."""
        with self._lock:
            if id not in self._waiting:
                raise RequestError("That file is not waiting any more; add it again.")
            return self._waiting[id]

    def tried(self, id: str, answers: Answers) -> Tried:
        """What answers come to. Raises RequestError for a table that does not wait any more."""
        return self.find(id).table.tried(answers)

    def confirm(self, id: str, answers: Answers, scope: Scope) -> tuple[Path, ...]:
        """Write the recipe beside the file, or for its folder; what can be opened by it now.

        Raises RequestError for answers that do not make a recording, and where another recipe is
        in the way: it is never replaced.
        """
        waiting = self.find(id)
        tried = waiting.table.tried(answers)
        if tried.recipe is None:
            raise RequestError(" ".join(tried.missing))
        if scope == "folder":
            return self._confirm_folder(waiting, tried.recipe)
        path = self._named(waiting, tried.recipe)
        _write_recipe(path.with_name(path.name + RECIPE_SUFFIX), tried.recipe)
        self._forget(waiting.id)
        return _recordings_in(path)

    def try_again(self) -> tuple[Path, ...]:
        """Take in what was sent and can be read by now, because a recipe has come for it."""
        with self._lock:
            waiting = tuple(self._waiting.values())
        paths: list[Path] = []
        for one in waiting:
            try:
                file = (
                    one.table.path if one.upload is None else one.upload.finish(calls=self._calls)
                )
                paths += _recordings_in(file)
            except KeyphaseError:
                continue
            self._forget(one.id)
        return tuple(paths)

    def leave(self, id: str) -> None:
        """A table is not to be read after all; nothing is left of one that was sent."""
        with self._lock:
            waiting = self._waiting.pop(id, None)
        if waiting is not None and waiting.upload is not None:
            waiting.upload.abandon()

    def close(self) -> None:
        """The page has gone."""
        with self._lock:
            ids = tuple(self._waiting)
        for id in ids:
            self.leave(id)

    def _confirm_folder(self, waiting: Waiting, recipe: str) -> tuple[Path, ...]:
        """The recipe of the folder; what waits from the same folder and fits is taken in, too."""
        alike = alike_tables(waiting.table, waiting.folder)
        _write_recipe(waiting.folder / FOLDER_RECIPE, recipe)
        named = list(_recordings_in(self._named(waiting, recipe)))
        self._forget(waiting.id)
        with self._lock:
            beside = [one for one in self._waiting.values() if one.folder == waiting.folder]
        for one in beside:
            try:
                named += _recordings_in(self._named(one, recipe))
            except KeyphaseError:
                continue
            self._forget(one.id)
        there = (one for path in alike for one in _recordings_in(path))
        return tuple(dict.fromkeys((*named, *there)))

    def _named(self, waiting: Waiting, recipe: str) -> Path:
        if waiting.upload is None:
            return waiting.table.path
        return waiting.upload.finish(waiting.table.recipe(recipe), calls=self._calls)

    def _wait(self, table: UnknownTable, folder: Path, upload: Upload | None) -> Waiting:
        there = alike_tables(table, folder)
        with self._lock:
            sent = [one for one in self._waiting.values() if one.upload and one.folder == folder]
            waiting = Waiting(
                str(next(self._numbers)), table, folder, upload, len(there) + len(sent)
            )
            self._waiting[waiting.id] = waiting
        return waiting

    def _forget(self, id: str) -> None:
        with self._lock:
            self._waiting.pop(id, None)


def _recordings_in(file: Path) -> tuple[Path, ...]:
    """Each recording in a file that can be read now."""
    return tuple(found.path for found in find_recordings([file]))


def _write_recipe(path: Path, text: str) -> None:
    if path.exists():
        raise RequestError(
            f"{path} is there already and is never replaced; correct it, or move it away first."
        )
    write_whole(path, text.encode(), refusal=RequestError)
