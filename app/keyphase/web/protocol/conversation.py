"""One page's conversation: greeted, heard, answered; and the files it sends."""

import threading
from collections import deque
from collections.abc import Callable
from dataclasses import asdict

from keyphase.errors import FileInTheWayError, KeyphaseError, RequestError
from keyphase.readers import find_recordings
from keyphase.segmentation.parameters import Parameters
from keyphase.web.protocol import list_messages as say
from keyphase.web.protocol import requests as ask
from keyphase.web.protocol.describing import Describing
from keyphase.web.protocol.dispatch import do
from keyphase.web.protocol.voice import GridVoice, Send, Voice
from keyphase.workbench.desks.asked import Asked
from keyphase.workbench.exporting.beside import InTheWay
from keyphase.workbench.telling import in_words
from keyphase.workbench.uploads import Upload, upload_folder
from keyphase.workbench.workbench import Workbench

MAX_CHANGES = 8
"""So many changes of one page may wait to be made; with more, the page itself waits."""


class Conversation:
    """What one page says and is told; used by the page's own thread.

    `latency` is told how long the page took from an input to the frame that shows it.
    """

    def __init__(
        self,
        workbench: Workbench,
        page: str,
        send: Send,
        *,
        looking: bool,
        latency: Callable[[float], None],
    ) -> None:
        self.workbench, self.page, self.send, self.latency = workbench, page, send, latency
        self._looking = looking
        self._changes: deque[threading.Event] = deque()
        self._upload: Upload | None = None
        self.send(_hello(page, looking))
        self.view = workbench.enter(page)
        self._describing = Describing(workbench, self.view, send)
        self.grid = GridVoice(send, workbench, self.view)
        self._voice = Voice(send, page, lambda: self.view.selected, self.grid)
        self.view.watch(self._voice)

    def end(self) -> None:
        """The page has left."""
        if self._upload is not None:
            self._upload.abandon()
        self._describing.close()
        self.view.unwatch(self._voice)
        self.workbench.leave(self.page)

    def hear(self, message: str | bytes) -> None:
        """Do what the page asks, or answer it why not; nothing it sends can end the server."""
        if isinstance(message, bytes) and self._upload is not None:
            self._take_piece(self._upload, message)
            return
        try:
            request = ask.parse(message)
        except KeyphaseError as error:
            kind, event = ask.about(message)
            self.send(say.Refused(kind, None, event, str(error)))
            return
        try:
            if self._looking and not isinstance(request, ask.LOOKING_REQUESTS):
                raise RequestError("This page was opened by the link for looking only.")
            self._do(request)
        except Exception as error:
            self.refuse(request, error)

    def refuse(self, request: ask.Request | ask.OnDocument, error: Exception) -> None:
        """Tell this page alone that a request was not done, and give an edit back."""
        if isinstance(error, FileInTheWayError) and isinstance(request, ask.Export):
            files = (InTheWay.of(error),)
            self._voice.show_in_the_way(request.recording, request.kind, files)
            return
        _, text = in_words(error)
        about = request if isinstance(request, ask.OnDocument) else None
        self.send(
            say.Refused(
                request=str(request.__struct_config__.tag),
                recording=about.recording if about else None,
                event=about.event if about else None,
                text=text,
            )
        )

    def asked(self, request: ask.OnDocument) -> Asked:
        """A request about a recording as a desk takes it."""
        return Asked(
            self.page, request.revision, lambda error: self.refuse(request, error), request.event
        )

    def wait_for(self, change: threading.Event) -> None:
        """Wait until few of this page's changes are still to be made, so that others' are, too."""
        self._changes.append(change)
        while len(self._changes) > MAX_CHANGES:
            self._changes.popleft().wait()

    def _do(self, request: ask.Request) -> None:
        match request:
            case ask.Upload():
                self._begin_upload(request)
            case ask.UploadCancel():
                self._cancel_upload()
            case ask.Describe() | ask.DescribeTry() | ask.DescribeConfirm() | ask.DescribeLeave():
                self._describing.do(request)
            case _:
                do(self, request)

    # -- files

    def _begin_upload(self, request: ask.Upload) -> None:
        if self._upload is not None:
            self._upload.abandon()
            self._upload = None
        state = self.view.state
        first = [state.recording.path] if state else []
        listed = [one.path for one in self.workbench.recordings.recordings]
        folder = upload_folder([*first, *listed])
        try:
            limit = self.workbench.settings.upload_limit_bytes
            self._upload = Upload(folder, request.name, request.size, limit)
        except RequestError as error:
            self.send(say.UploadRefused(str(error)))
            return
        self.send(say.UploadReady(self._upload.name))

    def _cancel_upload(self) -> None:
        """Nothing to answer where the file is whole already: what becomes of it is told anyway."""
        if self._upload is None:
            return
        name = self._upload.name
        self._upload.abandon()
        self._upload = None
        self.send(say.UploadCancelled(name))

    def _take_piece(self, upload: Upload, piece: bytes) -> None:
        try:
            upload.write(piece)
        except RequestError as error:
            self._upload = None
            self.send(say.UploadRefused(str(error)))
            return
        if upload.is_whole:
            self._upload = None
            state = self.view.state
            source = state.demonstration.source if state else None
            beside = source.sha256 if source else None
            self.view.errands.submit(lambda: self._take_in(upload, beside))

    def _take_in(self, upload: Upload, beside: str | None) -> None:
        try:
            path = self.workbench.take_in(upload, beside)
        except KeyphaseError as error:
            if self._describing.waits_for(upload):
                return
            upload.abandon()
            self.send(say.UploadRefused(str(error)))
            return
        self.send(say.Uploaded(path.name, upload.is_segment_file))
        if upload.is_recipe:
            self._describing.recipe_arrived()
        elif not upload.is_segment_file:
            self._describing.take_in(tuple(found.path for found in find_recordings([path])))


def _hello(page: str, looking: bool) -> say.Hello:
    return say.Hello(
        client=page,
        read_only=looking,
        defaults=asdict(Parameters()),
    )
