"""Trials from the page: the plan in many disturbed worlds, in the background."""

import threading
from collections.abc import Callable

from keyphase.simulation.replay.report import trials_outcome
from keyphase.simulation.replay.spread import Spread
from keyphase.simulation.replay.trials import Worlds, drawn_worlds, run_trials
from keyphase.simulation.replay.trials_picture import trials_svg
from keyphase.workbench.opened import Opened
from keyphase.workbench.replay_plan import plan_of
from keyphase.workbench.replay_settings import ReplaySettings
from keyphase.workbench.telling import Telling
from keyphase.workbench.worker import Worker

WORLDS = Worlds(
    part_height_m=Spread(-0.01, 0.01),
    part_offset_m=Spread(-0.005, 0.005),
    friction=Spread(0.2, 0.6),
    sensor_noise=Spread(2.0, 2.0),
)
"""Parts ±10 mm in height and ±5 mm aside, friction 0.2 to 0.6, sensor noise doubled."""


class _CancelledError(Exception):
    """A person gave the trials up."""


class ReplayTrials:
    """Runs trials one after another; pages get progress, then the picture.

    `show_progress` is told how many worlds are done and how many there are, `show_outcome` what
    came of them in one line.
    """

    def __init__(
        self,
        telling: Telling,
        show_progress: Callable[[int, int], None],
        show_outcome: Callable[[str], None],
    ) -> None:
        self._telling = telling
        self._show_progress, self._show_outcome = show_progress, show_outcome
        self._worker = Worker(telling.report)
        self._cancelled = threading.Event()

    def run(self, opened: Opened, settings: ReplaySettings, count: int) -> None:
        """Run the open recording's plan in `count` disturbed worlds on all cores."""
        self._worker.submit(lambda: self._run(opened, settings, count), "trials")

    def cancel(self) -> None:
        """Give up those that run; what came of their worlds is forgotten."""
        self._cancelled.set()

    def stop(self) -> None:
        """End everything."""
        self.cancel()
        self._worker.stop()

    def _run(self, opened: Opened, settings: ReplaySettings, count: int) -> None:
        self._cancelled.clear()
        try:
            self._run_and_tell(opened, settings, count)
        except _CancelledError:
            self._show_outcome("Cancelled.")
        except Exception:
            self._show_outcome("")
            raise
        finally:
            self._telling.progress_done()

    def _run_and_tell(self, opened: Opened, settings: ReplaySettings, count: int) -> None:
        plan = plan_of(opened.labeling, settings.end_by)
        worlds = drawn_worlds(WORLDS, count, settings.seed)
        what = f"Trials of {opened.recording.name}"

        def progress(done: int, total: int) -> None:
            if self._cancelled.is_set():
                raise _CancelledError
            self._telling.progress(what, done / total)
            self._show_progress(done, total)

        progress(0, count)
        trials = run_trials(
            settings.workcell, plan.demonstration, plan.skills, worlds, progress=progress
        )
        title = f"{opened.recording.name} in {settings.workcell}, {settings.end_by} end conditions"
        outcome, picture = trials_outcome(trials), trials_svg(trials, title)
        self._show_outcome(outcome)
        self._telling.all({"type": "trials", "title": title, "outcome": outcome, "svg": picture})
