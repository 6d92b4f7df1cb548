"""A page's talk about recordings nobody has described yet: proposed, tried, confirmed or left."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import assert_never

from keyphase.errors import KeyphaseError, RequestError
from keyphase.files.parts import split_part
from keyphase.web.protocol import requests as ask
from keyphase.web.protocol.import_messages import TableDone, table_proposal
from keyphase.web.protocol.voice import Send
from keyphase.workbench.importing.importing import Importing, Waiting
from keyphase.workbench.uploads import Upload
from keyphase.workbench.view import View
from keyphase.workbench.workbench import Workbench


class Describing:
    """Asks the person at one page how recordings are read. What takes long runs beside the talk."""

    def __init__(self, workbench: Workbench, view: View, send: Send) -> None:
        self._workbench, self._view, self._send = workbench, view, send
        self._importing = Importing(workbench.library.reading.call)

    def close(self) -> None:
        """The page has left; nothing is left of what it sent."""
        self._importing.close()

    def waits_for(self, upload: Upload) -> bool:
        """Ask how a file that was sent is read; whether one can be asked about it."""
        if not self._workbench.is_undescribed(upload):
            return False
        try:
            self._propose(self._importing.ask_about_upload(upload))
        except KeyphaseError:
            return False
        return True

    def do(self, request: ask.DescribeRequest) -> None:
        """Do what the page says. Raises KeyphaseError for what is refused at once."""
        match request:
            case ask.Describe():
                path = self._workbench.recordings.find(request.recording).path
                self._beside(lambda: self._propose(self._importing.ask_about(path)))
            case ask.DescribeTry():
                self._beside(lambda: self._try(request))
            case ask.DescribeConfirm():
                self._beside(lambda: self._confirm(request))
            case ask.DescribeLeave():
                self._importing.leave(request.id)
                self._send(TableDone(request.id))
            case _:
                assert_never(request)

    def recipe_arrived(self) -> None:
        """Read by a recipe that was sent what waits for one, and what could not be read before."""
        before = self._importing.ids
        paths = self._importing.try_again()
        for id in before - self._importing.ids:
            self._send(TableDone(id))
        broken = [line.path for line in self._workbench.recordings.recordings if line.error]
        if paths or broken:
            self.take_in((*paths, *broken))

    def _beside(self, what: Callable[[], None]) -> None:
        self._view.errands.submit(what)

    def _propose(self, waiting: Waiting) -> None:
        tried = waiting.table.tried(waiting.table.proposed)
        self._send(table_proposal(waiting, tried))

    def _try(self, request: ask.DescribeTry) -> None:
        waiting = self._importing.find(request.id)
        self._send(table_proposal(waiting, waiting.table.tried(request.answers.answers())))

    def _confirm(self, request: ask.DescribeConfirm) -> None:
        before = self._importing.ids
        paths = self._importing.confirm(request.id, request.answers.answers(), request.scope)
        for id in before - self._importing.ids:
            self._send(TableDone(id))
        files = {split_part(path)[0] for path in paths}
        for line in self._workbench.recordings.recordings:
            if line.error and line.path not in paths and split_part(line.path)[0] in files:
                # It is listed by its tools now.
                self._workbench.remove(line.path)
        self.take_in(paths)

    def take_in(self, paths: tuple[Path, ...]) -> None:
        """The first is looked at, the others come into the list."""
        recordings = self._workbench.recordings
        lines = [recordings.add(path) for path in paths]
        for line in lines:
            recordings.update(replace(line, error=None))
        if not lines:
            raise RequestError("Nothing of this folder can be read by that recipe.")
        self._view.open(lines[0].id)
        self._workbench.looking.begin()
