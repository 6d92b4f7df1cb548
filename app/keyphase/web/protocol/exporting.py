"""What a page asks about files that are written of its recording."""

from pathlib import Path
from typing import TYPE_CHECKING, assert_never

from keyphase.web.protocol.document_requests import Export, Offers
from keyphase.web.protocol.export_messages import offers_message
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.exporting.beside import Beside
from keyphase.workbench.exporting.formats import offered
from keyphase.workbench.exporting.segment_files import ENDINGS
from keyphase.workbench.replaying.exports import PLAN_KINDS
from keyphase.writers import Options, writer_named

if TYPE_CHECKING:
    from keyphase.web.protocol.conversation import Conversation


def exporting(page: "Conversation", desk: Desk, request: Offers | Export) -> None:
    """Tell what can be written of the recording of a desk, or write it."""
    match request:
        case Offers():
            recording = desk.recording
            found = offered(desk.opened().kept_labeling, recording.path)
            page.send(offers_message(recording.id, Beside(recording.path).folder, found))
        case Export(kind="page"):
            page.view.replay.export(desk.opened(), "page", request.if_there)
        case Export():
            writer_named(request.kind)
            _write(page, desk, request)
        case _:
            assert_never(request)


def _write(page: "Conversation", desk: Desk, request: Export) -> None:
    """A segment file is written when all that was asked of its desk before is done."""
    view, kind, scope = page.view, request.kind, request.scope
    options = Options(request.trim_idle, request.if_there)
    if scope != "this":
        view.errands.submit(lambda: page.workbench.export_all(view, kind, scope, options))
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
