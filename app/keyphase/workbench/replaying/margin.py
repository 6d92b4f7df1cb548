"""The margin from the page: how far the world may differ until the plan fails."""

from collections.abc import Callable
from dataclasses import dataclass

from keyphase.errors import SimulationError
from keyphase.simulation.choosing import cell_for, met_by
from keyphase.simulation.replay.margin import margin_of
from keyphase.simulation.replay.margin_plans import margin_plans
from keyphase.simulation.replay.margin_report import margin_svg, margin_verdict
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.replaying.beside import WorkBeside
from keyphase.workbench.replaying.settings import ReplaySettings
from keyphase.workbench.tasks import Task
from keyphase.workbench.telling import Telling

JOBS = -1
"""A margin is tried on all cores."""


@dataclass(frozen=True)
class MarginRun:
    """A margin on the way, or what came of it.

    done, count  axes of all plans that were tried, and how many there are
    outcome      the verdict in one line, once it is over
    svg          its picture; None on the way, and where it was given up
    """

    count: int
    done: int = 0
    over: bool = False
    title: str = ""
    outcome: str | None = None
    svg: str | None = None


class ReplayMargin:
    """Tries margins one after another; `show` is told how they go and what came of them."""

    def __init__(self, telling: Telling, show: Callable[[MarginRun], None]) -> None:
        self._show = show
        self._beside = WorkBeside(telling)

    def run(self, opened: DeskState, settings: ReplaySettings) -> None:
        """Try how far the open recording's plan reaches, on all cores."""
        self._beside.begin(
            f"Margin of {opened.recording.name}",
            "margin",
            lambda task: self._run_and_tell(opened, settings, task),
            lambda why: self._show(MarginRun(1, over=True, outcome=why)),
        )

    def cancel(self) -> None:
        """Give up the one that runs."""
        self._beside.give_up()

    def stop(self) -> None:
        """End everything."""
        self._beside.stop()

    def _run_and_tell(self, opened: DeskState, settings: ReplaySettings, task: Task) -> None:
        def progress(done: int, total: int) -> None:
            self._beside.go_on()
            task.at(done / total)
            self._show(MarginRun(total, done))

        progress(0, 1)
        cell = cell_for(opened.demonstration, settings.workcell)
        demonstration = met_by(opened.demonstration, cell)
        labeling = opened.labeling
        segments = [labeling.segments[entry.segment] for entry in labeling.plan]
        if not segments:
            raise SimulationError(
                "A margin needs a plan of at least one segment; keep one, or add one."
            )
        margin = margin_of(
            cell,
            demonstration,
            margin_plans(demonstration, segments),
            seed=settings.seed,
            jobs=JOBS,
            progress=progress,
        )
        title = f"{opened.recording.name} in {settings.workcell}"
        picture = margin_svg(margin, title)
        self._show(MarginRun(1, 1, True, title, margin_verdict(margin), picture))
