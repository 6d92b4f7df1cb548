"""What shows a replay beside the pages (the 3D scene and the tab), and what it is shown."""

from dataclasses import dataclass

from keyphase.simulation.replay.result import ReplayResult
from keyphase.simulation.shapes import Shape
from keyphase.workbench.opened import Opened
from keyphase.workbench.replay_plan import ReplayPlan
from keyphase.workbench.replay_run import Phase, ReplayRun, Tick
from keyphase.workbench.replay_settings import ReplaySettings
from keyphase.workbench.replay_trials import TrialsRun


@dataclass(frozen=True, eq=False)
class Running:
    """A replay that runs, or that is over and still shown.

    goals   names of what counts as success
    result  None until it is over
    """

    number: int
    opened: Opened
    settings: ReplaySettings
    plan: ReplayPlan
    run: ReplayRun
    shapes: tuple[Shape, ...]
    goals: tuple[str, ...]
    result: ReplayResult | None = None

    @property
    def phase(self) -> Phase:
        """Whether it runs, stands still, or is over."""
        return self.run.phase


class ReplayView:
    """Shows replays beside the pages; each overrides what concerns it."""

    def show_settings(self, settings: ReplaySettings) -> None:
        """These were chosen."""

    def show_begun(self, running: Running) -> None:
        """A replay begins."""

    def show_tick(self, running: Running, tick: Tick) -> None:
        """It has come to here."""

    def show_status(self, running: Running) -> None:
        """A skill has ended, or it stands still, goes on, is over."""

    def show_closed(self) -> None:
        """It is not shown any more."""

    def show_trials(self, trials: TrialsRun) -> None:
        """Trials are on the way, or over."""
