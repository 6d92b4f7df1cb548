"""What a page's requests do: those about a document to its desk, the rest to the page's view."""

import threading
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, assert_never

import msgspec
from msgspec import UNSET

from keyphase.errors import RequestError
from keyphase.labeling.segment_file import SegmentFile
from keyphase.labeling.tasks.task import Task
from keyphase.segmentation.parameters import Parameters
from keyphase.web.protocol import requests as ask
from keyphase.web.protocol.comparison_messages import comparison_message, lanes_message
from keyphase.web.protocol.control_messages import cameras_message
from keyphase.web.protocol.export_messages import offers_message
from keyphase.web.protocol.signals_frame import signals_frame
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.desks.parameters import with_parameter
from keyphase.workbench.exporting.beside import Beside
from keyphase.workbench.exporting.formats import offered
from keyphase.workbench.exporting.segment_files import ENDINGS
from keyphase.workbench.leading.cutting import write_cut
from keyphase.workbench.replaying.exports import PLAN_KINDS
from keyphase.workbench.showing.comparing import PROPOSED, SECOND, of_another
from keyphase.workbench.showing.lanes import lanes_of
from keyphase.workbench.uploads import copy_of_shipped
from keyphase.writers import Options, writer_named

if TYPE_CHECKING:
    from keyphase.web.protocol.conversation import Conversation


def do(page: "Conversation", request: ask.DispatchedRequest) -> None:
    """Do what a page asks. Raises KeyphaseError for what is refused at once."""
    match request:
        case ask.Select():
            page.view.select(request.segment, request.recording, request.revision, request.to)
        case ask.Signals():
            with page.workbench.library.at(request.recording) as desk:
                _send_signals(page, desk, request)
        case ask.Cameras():
            _find_cameras(page, request)
        case ask.OnDocument():
            with page.workbench.library.at(request.recording) as desk:
                _at_desk(page, desk, request)
        case ask.Replay() | ask.ReplaySettings() | ask.Push():
            _replay(page, request)
        case ask.Trials() | ask.TrialsCancel() | ask.Margin():
            _beside_replay(page, request)
        case ask.Record():
            page.view.lead.do(request.do, request.workcell)
        case _:
            _look(page, request)


def _at_desk(page: "Conversation", desk: Desk, request: ask.EditingRequest) -> None:
    """Requests about one document, bound to its desk now, whatever is opened meanwhile."""
    asked = page.asked(request)
    match request:
        case ask.Edit():
            page.wait_for(desk.edit(request.edit.checked(), asked))
        case ask.Set():
            _set(page, desk, request)
        case ask.Reset():
            page.wait_for(desk.reset_parameters(asked))
        case ask.Undo():
            page.wait_for(page.workbench.sharing.undo(desk, asked, page.view))
        case ask.Redo():
            page.wait_for(page.workbench.sharing.redo(desk, asked, page.view))
        case ask.Done():
            page.wait_for(desk.mark_done(request.done, asked))
        case ask.KeepLabels():
            page.wait_for(desk.keep_labels(asked))
        case ask.TakeJournal():
            page.wait_for(desk.take_journal(asked))
        case ask.ForgetLabel():
            page.wait_for(desk.forget_label(request.label, asked))
        case ask.TakeOver():
            _take_over(page, desk, request)
        case ask.Cut():
            page.view.errands.submit(lambda: page.view.add(_cut(desk, request)))
        case ask.Offers() | ask.Export():
            _exporting(page, desk, request)
        case ask.Compare():
            proposal = page.workbench.proposals.of(request.recording)
            second = _another(page, desk)
            page.send(comparison_message(desk.opened(), request.other, proposal, second))
        case ask.Lanes():
            page.view.errands.submit(lambda: _send_lanes(page, desk), "lanes")
        case ask.Spread():
            _spread(page, desk, request)
        case ask.PhaseForAll() | ask.PhaseUndo() | ask.Phases():
            page.wait_for(_phases(page, desk, request))
        case _:
            assert_never(request)


def _send_lanes(page: "Conversation", desk: Desk) -> None:
    """A recording that was closed meanwhile needs none."""
    if desk.state is None:
        return
    listed = page.workbench.recordings.recordings
    found = lanes_of(desk.state, listed, page.workbench.library)
    page.send(lanes_message(desk.recording.id, found))


def _another(page: "Conversation", desk: Desk) -> SegmentFile | None:
    second = page.workbench.second
    return second.file_of(desk.recording.path) if second else None


def _take_over(page: "Conversation", desk: Desk, request: ask.TakeOver) -> None:
    asked = page.asked(request)
    second = _another(page, desk)
    if request.other == SECOND and second is not None:
        page.wait_for(desk.edit(of_another(desk.opened(), second), asked))
        return
    if request.other != PROPOSED:
        page.wait_for(desk.take_over(request.other, asked))
        return
    proposal = page.workbench.proposals.of(request.recording)
    if proposal is None or proposal.edit is None:
        raise RequestError("Nothing is proposed for this recording by now.")
    page.wait_for(desk.edit(proposal.edit, asked))


def _set(page: "Conversation", desk: Desk, request: ask.Set) -> None:
    def change(parameters: Parameters) -> Parameters:
        return with_parameter(parameters, request.parameter, request.value)

    desk.set_parameters(change, page.asked(request), held=request.held)


def _cut(desk: Desk, request: ask.Cut) -> Path:
    demonstration = desk.opened().demonstration
    return write_cut(demonstration, desk.recording.path, request.from_s, request.to_s)


def _exporting(page: "Conversation", desk: Desk, request: ask.Offers | ask.Export) -> None:
    """Tell what can be written of the recording of a desk, or write it."""
    match request:
        case ask.Offers():
            recording = desk.recording
            found = offered(desk.opened().kept_labeling, recording.path)
            page.send(offers_message(recording.id, Beside(recording.path).folder, found))
        case ask.Export(kind="page"):
            page.view.replay.export(desk.opened(), "page", request.if_there)
        case ask.Export():
            writer_named(request.kind)
            _write(page, desk, request)
        case _:
            assert_never(request)


def _write(page: "Conversation", desk: Desk, request: ask.Export) -> None:
    """A segment file is written when all that was asked of its desk before is done."""
    view, kind, scope = page.view, request.kind, request.scope
    options = Options(request.trim_idle, request.if_there)
    if scope != "this":
        chosen = page.workbench.recordings.chosen(scope, request.picked)
        view.errands.submit(lambda: page.workbench.export_all(view, chosen, kind, options))
        return
    page.workbench.require_own_names(desk.recording)
    if kind in ENDINGS:

        def saved(path: Path) -> None:
            view.each(lambda watcher: watcher.show_saved(path, kind))

        page.wait_for(desk.export(kind, page.asked(request), saved, request.if_there))
    elif kind in PLAN_KINDS:
        view.replay.export(desk.opened(), kind, request.if_there)
    else:
        state = desk.opened()
        view.errands.submit(lambda: page.workbench.export_one(view, state, kind, options))


def _spread(page: "Conversation", desk: Desk, request: ask.Spread) -> None:
    workbench = page.workbench
    match request.step:
        case "look":
            workbench.look_into_spread(desk, page.view, include_done=request.include_done)
        case "apply":
            workbench.leave_spread(page.view)
            sharing, done = workbench.sharing, request.include_done
            page.wait_for(sharing.share(desk, page.asked(request), page.view, include_done=done))
        case "leave":
            workbench.leave_spread(page.view)
        case _:
            assert_never(request.step)


def _write_task(page: "Conversation", task: Task, opened: OpenRecording) -> None:
    """Keep it; whether a recording differs depends on what its task lets be missing."""
    opened.folder.write_task(task)
    page.workbench.proposals.begin()


def _phases(
    page: "Conversation", desk: Desk, request: ask.PhaseForAll | ask.PhaseUndo | ask.Phases
) -> threading.Event:
    for_all, asked, view = page.workbench.for_all, page.asked(request), page.view
    match request:
        case ask.Phases():
            return desk.change(partial(_write_task, page, request.task()), asked)
        case ask.PhaseUndo():
            return for_all.undo(desk, asked, view)
        case ask.PhaseForAll(label=label, to=to, include_done=done):
            if to is None:
                return for_all.drop(desk, label, asked, view, include_done=done)
            return for_all.rename(desk, label, to, asked, view, include_done=done)
        case _:
            assert_never(request)


def _find_cameras(page: "Conversation", request: ask.Cameras) -> None:
    with page.workbench.library.at(request.recording) as desk:
        state = desk.opened()
    page.workbench.footage.find(
        state.recording,
        state.demonstration.start_s,
        lambda lent: page.send(cameras_message(lent)),
    )


def _send_signals(page: "Conversation", desk: Desk, request: ask.Signals) -> None:
    page.send(signals_frame(desk.opened().tracks, request))


def _look(page: "Conversation", request: ask.LookRequest) -> None:
    """Requests about what this page looks at."""
    view = page.view
    match request:
        case ask.Open():
            view.open(request.id)
        case ask.OpenDemonstration():
            folder = page.workbench.settings.folder
            view.errands.submit(lambda: view.add(copy_of_shipped(folder)))
        case ask.Follow():
            view.follow(request.page)
        case ask.Seek():
            view.move_playhead(lambda playhead: playhead.at(request.time_s))
        case ask.Play():
            playing, speed, loop = request.playing, request.speed, request.loop
            view.move_playhead(lambda head: head.played(playing, speed, loop))
        case ask.PlayAround():
            view.move_playhead(lambda head: head.around(request.time_s))
        case ask.Show():
            view.scene.show(request.what, request.visible)
        case ask.InView():
            view.scene.look_at(request.recording, request.from_s, request.to_s)
        case ask.Theme():
            view.scene.set_theme(request.dark)
        case ask.Robot():
            view.scene.choose_robot(arm=request.arm, moving=request.moving)
            if request.place is not None:
                view.scene.place_robot()
        case ask.Grid():
            page.grid.show(request.shown)
        case ask.Latency():
            page.latency(request.milliseconds)
        case _:
            assert_never(request)


def _replay(page: "Conversation", request: ask.ReplayRequest) -> None:
    replay = page.view.replay
    match request:
        case ask.Replay():
            if (speed := request.speed) is not None:
                replay.configure(lambda settings: replace(settings, speed=speed))
            replay.do(request.do)
        case ask.ReplaySettings():
            values = msgspec.structs.asdict(request).items()
            chosen = {name: value for name, value in values if value is not UNSET}
            replay.configure(lambda settings: replace(settings, **chosen))
        case ask.Push():
            page.view.scene.offer_push(request.offered)
        case _:
            assert_never(request)


def _beside_replay(page: "Conversation", request: ask.BesideReplayRequest) -> None:
    replay = page.view.replay
    match request:
        case ask.Trials():
            replay.run_trials(request.count)
        case ask.TrialsCancel():
            replay.cancel_trials()
        case ask.Margin(do="begin"):
            replay.try_margin()
        case ask.Margin():
            replay.cancel_margin()
        case _:
            assert_never(request)
