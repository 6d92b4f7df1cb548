"""What a page's requests do to the session."""

from collections.abc import Callable
from dataclasses import replace

from keyphase.errors import KeyphaseError, RequestError
from keyphase.labeling.edits import edit_from_json
from keyphase.segmentation.parameters import Parameters
from keyphase.web.protocol import requests as ask
from keyphase.web.protocol.controls import Controls
from keyphase.web.transport.page_sockets import Page
from keyphase.workbench.comparing import comparison_message, take_over
from keyphase.workbench.opened import Opened
from keyphase.workbench.session import Cause, Session
from keyphase.workbench.signals import signals_frame
from keyphase.workbench.uploads import Upload, upload_folder


def hear(session: Session, page: Page, message: str | bytes) -> None:
    """Do what a page asks, or answer it why not; nothing it sends can end the server."""
    try:
        if isinstance(message, bytes) and page.upload is not None:
            _take_piece(session, page, page.upload, message)
            return
        request = ask.parse(message)
        if page.is_looking and not isinstance(request, ask.LOOKING_REQUESTS):
            raise RequestError("This page was opened by the link for looking only.")
        _do(session, request, page)
    except KeyphaseError as error:
        page.send({"type": "notice", "level": "warning", "text": str(error)})
    except Exception as error:
        session.telling.report(error)


def _do(session: Session, request: ask.Request, page: Page) -> None:
    """Requests about the document and the list here, the rest below."""

    def change(action: Callable[[Opened], None], cause: Cause | None = None) -> None:
        page.wait_for(session.change(action, cause))

    match request:
        case ask.Open():
            session.queue.open(request.id)
        case ask.Set():
            _set(session, request, page)
        case ask.Reset():
            change(Opened.reset_parameters)
        case ask.Edit():
            edit = edit_from_json(request.edit)
            change(lambda opened: opened.apply(edit), _cause(request.event, page))
        case ask.Undo():
            change(Opened.undo)
        case ask.Redo():
            change(Opened.redo)
        case ask.Done():
            change(lambda opened: opened.mark_done(request.done))
        case ask.KeepLabels():
            change(Opened.keep_labels)
        case ask.ForgetLabel():
            change(lambda opened: opened.folder.forget(request.label))
        case ask.Export():
            _export(session, request.kind)
        case ask.Spread():
            _spread(session, request.step)
        case ask.Compare():
            page.send(comparison_message(session.current(), request.other))
        case ask.TakeOver():
            change(lambda opened: take_over(opened, request.other))
        case ask.Upload():
            _begin_upload(session, request, page)
        case _:
            _show(session, request, page)


def _show(session: Session, request: ask.Request, page: Page) -> None:
    """Requests that change no document."""
    match request:
        case ask.UploadCancel():
            _cancel_upload(page)
        case ask.Select():
            session.select(request.segment)
        case ask.Seek():
            session.move_playhead(lambda playhead: playhead.at(request.time_s))
        case ask.Play():
            session.move_playhead(
                lambda head: head.played(request.playing, request.speed, request.loop)
            )
        case ask.Signals():
            _send_signals(session, request, page)
        case ask.Show():
            session.show(request.what, request.visible)
        case ask.Theme():
            session.set_theme(request.dark)
        case ask.Replay():
            _replay(session, request)
        case ask.Trials():
            session.replay.run_trials(request.count)
        case ask.TrialsCancel():
            session.replay.cancel_trials()
        case ask.ReplaySettings() | ask.Push() | ask.Record() | ask.Robot():
            _control(_controls(session), request)
        case ask.Latency():
            session.latencies_ms.append(request.milliseconds)


def _control(
    controls: Controls, request: ask.ReplaySettings | ask.Push | ask.Record | ask.Robot
) -> None:
    match request:
        case ask.ReplaySettings():
            controls.choose(request)
        case ask.Push():
            controls.push(request.offered)
        case ask.Record():
            controls.record(request)
        case ask.Robot():
            controls.move_robot(request)


def _controls(session: Session) -> Controls:
    if not isinstance(session.controls, Controls):
        raise RequestError("The server is still starting; try again in a moment.")
    return session.controls


def _export(session: Session, kind: str) -> None:
    if kind == "page":
        _controls(session).share()
    else:
        session.export(kind)


def _replay(session: Session, request: ask.Replay) -> None:
    speed = request.speed
    if speed is not None:
        session.replay.configure(lambda settings: replace(settings, speed=speed))
    session.replay.do(request.do)


def _set(session: Session, request: ask.Set, page: Page) -> None:
    session.set_parameters(
        lambda parameters: with_parameter(parameters, request.parameter, request.value),
        held=request.held,
        cause=_cause(request.event, page),
    )


def _send_signals(session: Session, request: ask.Signals, page: Page) -> None:
    opened = session.current()
    frame = signals_frame(
        opened.tracks,
        request=request.request,
        recording=opened.recording.id,
        names=request.tracks,
        from_s=request.from_s,
        to_s=request.to_s,
        width=request.width,
    )
    page.send(frame)


def _spread(session: Session, step: str) -> None:
    def share(opened: Opened) -> None:
        opened.share_parameters()
        session.queue.follow_folder(opened)

    if step == "look":
        session.queue.preview_spread(session.current())
        return
    session.queue.leave_spread()
    if step == "apply":
        session.change(share)


def _begin_upload(session: Session, request: ask.Upload, page: Page) -> None:
    if page.upload is not None:
        page.upload.abandon()
        page.upload = None
    open_first = [session.opened.recording.path] if session.opened else []
    folder = upload_folder([*open_first, *(one.path for one in session.queue.recordings)])
    try:
        page.upload = Upload(folder, request.name, request.size, session.upload_limit_bytes)
    except RequestError as error:
        page.send({"type": "upload_refused", "text": str(error)})
        return
    page.send({"type": "upload_ready", "name": page.upload.name})


def _cancel_upload(page: Page) -> None:
    """Nothing to answer where the file is whole already: what becomes of it is told anyway."""
    if page.upload is None:
        return
    name = page.upload.name
    page.upload.abandon()
    page.upload = None
    page.send({"type": "upload_cancelled", "name": name})


def _take_piece(session: Session, page: Page, upload: Upload, piece: bytes) -> None:
    try:
        upload.write(piece)
    except RequestError as error:
        page.upload = None
        page.send({"type": "upload_refused", "text": str(error)})
        return
    if upload.is_whole:
        page.upload = None
        session.queue.take_in(upload, session.opened, page.send)


def with_parameter(parameters: Parameters, name: str, value: float | str | None) -> Parameters:
    """The parameters with one changed; whole numbers may come as 5.0.

    Raises RequestError for an unknown name, ParameterError for a value out of range.
    """
    if name not in Parameters.__dataclass_fields__:
        known = ", ".join(Parameters.__dataclass_fields__)
        raise RequestError(f"There is no parameter {name!r}; the parameters are {known}.")
    if name in ("gaussians", "seed") and isinstance(value, float) and value.is_integer():
        value = int(value)
    if name == "variant" and value != parameters.variant:
        # The threshold's unit is another one.
        parameters = replace(parameters, force_threshold=None)
    return replace(parameters, **{name: value})


def _cause(event: int | None, page: Page) -> Cause | None:
    return None if event is None else Cause(event, page.id)
