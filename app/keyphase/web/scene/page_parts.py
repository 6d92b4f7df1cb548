"""The parts of the workcell a demonstration was recorded in, where they were at the playhead."""

import viser

from keyphase.demonstration import Demonstration
from keyphase.simulation.workcells.parts_path import PartsPath
from keyphase.web.scene.figures.part_figures import PartFigures
from keyphase.web.scene.page_robot import Later
from keyphase.web.scene.shared import Shared
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.playback import Playhead

ROOT = "/parts/shown"


class PageParts:
    """Parts for demonstrations from our workcells, none for others, in one page's scene.

    Where they were is worked out in a thread that all pages share; all else runs in the thread that
    draws this page's scene.
    """

    def __init__(self, client: viser.ClientHandle, shared: Shared, later: Later) -> None:
        self._client, self._shared, self._later = client, shared, later
        self._demonstration: Demonstration | None = None
        self._drawn: tuple[PartsPath, PartFigures] | None = None
        self._playhead = Playhead()

    def show_document(self, shown: DeskState) -> None:
        """Work out where the parts were, in the background."""
        demonstration = shown.demonstration
        if demonstration is not self._demonstration:
            self.clear()
            self._demonstration = demonstration
            work = f"parts of {id(self)}"
            self._shared.part_paths.submit(lambda: self._work_out(demonstration), work)

    def clear(self) -> None:
        """Draw none."""
        self._demonstration = None
        if self._drawn is not None:
            self._drawn[1].remove()
            self._drawn = None

    def show_playhead(self, playhead: Playhead) -> None:
        """Put the parts where they were."""
        self._playhead = playhead
        if self._drawn is not None:
            path, figures = self._drawn
            figures.pose(path.at(playhead.time_s))

    def _work_out(self, demonstration: Demonstration) -> None:
        """Runs in the thread that all pages share."""
        if demonstration is not self._demonstration:
            return
        path = self._shared.parts(demonstration)
        if path is not None:
            self._later(lambda: self._show(demonstration, path))

    def _show(self, demonstration: Demonstration, path: PartsPath) -> None:
        if demonstration is not self._demonstration:
            return
        with self._client.atomic():
            figures = PartFigures(self._client, ROOT, path.shapes)
            figures.pose(path.at(self._playhead.time_s))
            self._drawn = path, figures
