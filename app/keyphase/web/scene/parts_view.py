"""The parts of the workcell a demonstration was recorded in, where they were at the playhead."""

import viser

from keyphase.demonstration import Demonstration
from keyphase.simulation.workcells.parts_path import PartsPath, parts_path
from keyphase.web.scene.part_figures import PartFigures
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.playback import Playhead
from keyphase.workbench.telling import Telling
from keyphase.workbench.worker import Worker

ROOT = "/parts/shown"


class PartsView:
    """Parts for demonstrations from our workcells, none for others."""

    def __init__(self, server: viser.ViserServer, telling: Telling) -> None:
        self._server = server
        self._worker = Worker(telling.report)
        self._demonstration: Demonstration | None = None
        self._shown: tuple[PartsPath, PartFigures] | None = None
        self._playhead = Playhead()

    def close(self) -> None:
        """Stop working things out."""
        self._demonstration = None
        self._worker.stop()
        self._worker.join()

    @property
    def is_free(self) -> bool:
        """Whether nothing is being worked out."""
        return self._worker.is_free()

    def wait_until_idle(self, timeout_s: float) -> bool:
        """Whether the parts are worked out within `timeout_s`."""
        return self._worker.wait_until_idle(timeout_s)

    def show_document(self, opened: DeskState) -> None:
        """Work out where the parts were, in the background."""
        demonstration = opened.demonstration
        if demonstration is not self._demonstration:
            self._demonstration = demonstration
            self._remove()
            self._worker.submit(lambda: self._work_out(demonstration), "parts")

    def show_playhead(self, playhead: Playhead) -> None:
        """Put the parts where they were."""
        self._playhead = playhead
        shown = self._shown
        if shown is not None:
            path, figures = shown
            figures.pose(path.at(playhead.time_s))

    def _work_out(self, demonstration: Demonstration) -> None:
        path = parts_path(demonstration)
        if path is None or demonstration is not self._demonstration:
            return
        with self._server.atomic():
            figures = PartFigures(self._server, ROOT, path.shapes)
            figures.pose(path.at(self._playhead.time_s))
            self._shown = path, figures

    def _remove(self) -> None:
        if self._shown is not None:
            self._shown[1].remove()
            self._shown = None
