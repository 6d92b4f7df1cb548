"""What watches a view: the page's socket, and the 3D scene of that page."""

from collections.abc import Sequence
from pathlib import Path

from keyphase.labeling.storage.written_files import IfThere
from keyphase.simulation.part_shapes import Shape
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.exporting.beside import InTheWay
from keyphase.workbench.leading.status import LeadThroughStatus
from keyphase.workbench.placing.robot_choice import RobotChoice
from keyphase.workbench.playback import Playhead
from keyphase.workbench.recording_list import Listing
from keyphase.workbench.replaying.margin import MarginRun
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.replaying.settings import ReplaySettings
from keyphase.workbench.replaying.trials import TrialsRun
from keyphase.workbench.selection import OtherSelection, Selection
from keyphase.workbench.spread import Spread
from keyphase.workbench.tasks import TaskState
from keyphase.workbench.telling import Level


class Watcher:
    """Watches one view; each overrides what concerns it.

    Told in the thread in which it happened, and must not keep it waiting.
    """

    # -- what the page looks at

    def show_document(self, state: DeskState) -> None:
        """The document has changed, or another recording is looked at."""

    def show_nothing(self) -> None:
        """No recording is looked at any more."""

    def show_playhead(self, playhead: Playhead) -> None:
        """The playhead has moved."""

    def show_selection(self, selection: Selection) -> None:
        """Other segments are selected."""

    def show_others(self, others: Sequence[OtherSelection]) -> None:
        """What the other pages at the same recording have selected."""

    def show_range(self, recording: str, from_s: float, to_s: float) -> None:
        """So much of a recording is to be seen in the scene."""

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Parts of the scene are shown or hidden."""

    def show_theme(self, dark: bool) -> None:
        """The page has become light or dark."""

    def show_following(self, page: str | None) -> None:
        """Another page is followed, or none."""

    # -- the robot beside a recording

    def show_robot(self, choice: RobotChoice) -> None:
        """Another arm was chosen, or the robot may be moved."""

    def place_robot(self) -> None:
        """Where a person put the robot is to be forgotten."""

    # -- a replay, and trials

    def show_settings(self, settings: ReplaySettings) -> None:
        """These were chosen for the next replay."""

    def show_begun(self, running: Running) -> None:
        """A replay begins."""

    def show_tick(self, running: Running, tick: Tick) -> None:
        """It has come to here."""

    def show_status(self, running: Running) -> None:
        """A skill has ended, or it stands still, goes on, is over."""

    def show_replay_closed(self) -> None:
        """It is not shown any more."""

    def show_push(self, offered: bool) -> None:
        """Whether the gizmo that pushes the tool is offered."""

    def write_replay(self, running: Running, if_there: IfThere) -> None:
        """The replay that is over is to be written as a page of its own."""

    def show_trials(self, trials: TrialsRun) -> None:
        """Trials are on the way, or over."""

    def show_margin(self, margin: MarginRun) -> None:
        """A margin is being tried, or over."""

    # -- recording by hand

    def show_workcell(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:
        """A workcell was opened."""

    def show_workcell_status(self, status: LeadThroughStatus) -> None:
        """It is like this now."""

    def show_workcell_closed(self) -> None:
        """The workcell was closed."""

    # -- what is told beside that

    def show_recordings(self, listing: Listing, current: str | None) -> None:
        """The list has changed."""

    def show_grid(self) -> None:
        """What is known of all recordings of a folder together has changed."""

    def show_spread(self, spread: Spread) -> None:
        """What parameters would do to the recordings of a folder, as far as that is known."""

    def show_saved(self, path: Path, kind: str) -> None:
        """A file was written."""

    def show_in_the_way(self, recording: str, kind: str, files: Sequence[InTheWay]) -> None:
        """Nothing was written there, for somebody else's files would have been replaced."""

    def show_task(self, task: TaskState) -> None:
        """Something that takes long has begun, is so far, or is over."""

    def show_notice(self, level: Level, text: str) -> None:
        """A line of text."""
