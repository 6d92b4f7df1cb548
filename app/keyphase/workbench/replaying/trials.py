"""Trials from the page: the plan in many disturbed worlds, in the background."""

from collections.abc import Callable
from dataclasses import dataclass

from keyphase.simulation.choosing import cell_for
from keyphase.simulation.replay.ranges import Range
from keyphase.simulation.replay.report import trials_outcome
from keyphase.simulation.replay.trials import Worlds, drawn_worlds, run_trials
from keyphase.simulation.replay.trials_picture import trials_svg
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.replaying.beside import WorkBeside
from keyphase.workbench.replaying.plan import plan_of
from keyphase.workbench.replaying.settings import ReplaySettings
from keyphase.workbench.tasks import Task
from keyphase.workbench.telling import Telling

WORLDS = Worlds(
    part_height_m=Range(-0.01, 0.01),
    part_offset_m=Range(-0.005, 0.005),
    friction=Range(0.2, 0.6),
    sensor_noise=Range(2.0, 2.0),
)
"""Parts ±10 mm in height and ±5 mm aside, friction 0.2 to 0.6, sensor noise doubled."""


@dataclass(frozen=True)
class TrialsRun:
    """Trials on the way, or what came of them.

    outcome    in one line, once they are over
    svg        their picture; None on the way, and where they were given up
    succeeded  in how many worlds the plan did; None likewise
    """

    count: int
    done: int = 0
    over: bool = False
    title: str = ""
    outcome: str | None = None
    svg: str | None = None
    succeeded: int | None = None


class ReplayTrials:
    """Runs trials one after another; `show` is told how they go and what came of them."""

    def __init__(self, telling: Telling, show: Callable[[TrialsRun], None]) -> None:
        self._show = show
        self._beside = WorkBeside(telling)

    def run(self, opened: DeskState, settings: ReplaySettings, count: int) -> None:
        """Run the open recording's plan in `count` disturbed worlds on all cores."""
        self._beside.begin(
            f"Trials of {opened.recording.name}",
            "trials",
            lambda task: self._run_and_tell(opened, settings, count, task),
            lambda why: self._show(TrialsRun(count, over=True, outcome=why)),
        )

    def cancel(self) -> None:
        """Give up those that run; what came of their worlds is forgotten."""
        self._beside.give_up()

    def stop(self) -> None:
        """End everything."""
        self._beside.stop()

    def _run_and_tell(
        self, opened: DeskState, settings: ReplaySettings, count: int, task: Task
    ) -> None:
        cell = cell_for(opened.demonstration, settings.workcell)
        plan = plan_of(opened.labeling, settings.end_by, cell)
        worlds = drawn_worlds(WORLDS, count, settings.seed)

        def progress(done: int, total: int) -> None:
            self._beside.go_on()
            task.at(done / total)
            self._show(TrialsRun(total, done))

        progress(0, count)
        trials = run_trials(cell, plan.demonstration, plan.skills, worlds, progress=progress)
        title = f"{opened.recording.name} in {settings.workcell}, {settings.end_by} end conditions"
        outcome, picture = trials_outcome(trials), trials_svg(trials, title)
        succeeded = sum(trial.succeeded for trial in trials.trials)
        self._show(TrialsRun(count, count, True, title, outcome, picture, succeeded))
