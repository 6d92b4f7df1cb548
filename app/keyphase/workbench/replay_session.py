"""Replay in the page: what was chosen for it, the one that runs, and whoever watches it."""

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SimulationError
from keyphase.readers import save_npz
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.replay.result import ReplayResult
from keyphase.simulation.workcells.registry import workcell
from keyphase.web.protocol.replay_messages import Streamed, replay_message
from keyphase.web.scene.replay_view import ReplayView, Running
from keyphase.web.transport.page_sockets import Page
from keyphase.workbench.opened import Opened
from keyphase.workbench.recording_queue import RecordingQueue
from keyphase.workbench.recordings import printable
from keyphase.workbench.replay_exports import export_plan
from keyphase.workbench.replay_plan import ReplayPlan, plan_of
from keyphase.workbench.replay_run import ReplayRun, Tick
from keyphase.workbench.replay_settings import WORKCELLS, Action, ReplaySettings
from keyphase.workbench.replay_trials import ReplayTrials
from keyphase.workbench.telling import Telling
from keyphase.workbench.worker import Worker


class ReplaySession:
    """Methods may be called from any thread."""

    def __init__(
        self, current: Callable[[], Opened], queue: RecordingQueue, telling: Telling
    ) -> None:
        self.settings = ReplaySettings()
        self.running: Running | None = None
        self._current, self._queue, self._telling = current, queue, telling
        self._views: tuple[ReplayView, ...] = ()
        self._lock = threading.RLock()
        self._worker = Worker(telling.report)
        self._trials = ReplayTrials(
            telling, lambda trials: self._each(lambda view: view.show_trials(trials))
        )
        self._streamed: Streamed | None = None
        self._count = 0
        self._building = False
        self._proposed: Demonstration | None = None

    def add(self, view: ReplayView) -> None:
        """Show replays in `view` from now on."""
        self._views = (*self._views, view)
        view.show_settings(self.settings)

    def close(self) -> None:
        """End everything."""
        self._trials.stop()
        self._worker.stop()
        self._worker.join()
        self.leave()

    # -- what people ask

    def configure(self, change: Callable[[ReplaySettings], ReplaySettings]) -> None:
        """Choose the world of the next replay; the speed is that of the present one, too.

        Raises ParameterError for what cannot be chosen.
        """
        with self._lock:
            before, self.settings = self.settings, change(self.settings)
            if self.running and self.settings.speed != before.speed:
                self.running.run.set_speed(self.settings.speed)
        self._each(lambda view: view.show_settings(self.settings))

    def propose(self, demonstration: Demonstration) -> None:
        """Choose the workcell a demonstration was recorded in, once when it is opened."""
        recorded_in = demonstration.metadata.get("workcell")
        with self._lock:
            before, self._proposed = self._proposed, demonstration
        if before is not demonstration and recorded_in in WORKCELLS:
            self.configure(lambda settings: replace(settings, workcell=str(recorded_in)))

    def begin(self, *, one_skill: bool = False) -> None:
        """Replay the plan of the open recording, from its start, in place of any other."""
        opened = self._current()
        with self._lock:
            if self._building:
                return
            self._building = True
        self._worker.submit(lambda: self._build(opened, one_skill))

    def go_on(self) -> None:
        """Go on where it stands still; begin where none runs."""
        running = self.running
        if running is None or running.phase == "over":
            self.begin()
        else:
            running.run.pause(False)

    def pause(self) -> None:
        """Stand still."""
        if self.running:
            self.running.run.pause(True)

    def next_skill(self) -> None:
        """Go on until the skill that runs has ended; begin where none runs."""
        running = self.running
        if running is None or running.phase == "over":
            self.begin(one_skill=True)
        else:
            running.run.next_skill()

    def hold(self, held: bool) -> None:
        """Hold the tool where it is, or let it go."""
        if self.running:
            self.running.run.hold(held)

    def push(self, force_N: Array) -> None:
        """Push the tool point with a force (3,), base frame, until told otherwise."""
        if self.running:
            self.running.run.push(force_N)

    def stop(self) -> None:
        """End the replay at once; what it did so far stays to be seen."""
        if self.running:
            self.running.run.stop()

    def leave(self) -> None:
        """Stop the replay and show it no more."""
        with self._lock:
            running, self.running, self._streamed = self.running, None, None
        if running is None:
            return
        running.run.stop()
        running.run.join()
        self._each(lambda view: view.show_closed())
        self._telling.all({"type": "replay", "phase": None})

    def keep(self) -> None:
        """Write the recording of the replay beside the demonstration and open it.

        Raises SimulationError where no replay is over, or its recording cannot be written.
        """
        running = self.over()
        assert running.result is not None
        path = free_path(running.opened.recording.path)
        try:
            save_npz(running.result.demonstration, path)
        except OSError as error:
            raise SimulationError(
                f"{path} must be writable, but is not ({error.strerror}); check the folder."
            ) from error
        self._telling.notice("info", f"Recorded: {path.name}")
        self._queue.add(path)
        self.leave()

    def export(self, kind: str) -> None:
        """Write the open recording's plan: its `skills`, a `behavior tree`, or a `program`."""
        opened = self._current()
        plan = plan_of(opened.labeling, self.settings.end_by)
        path = export_plan(plan, opened.recording.path, kind)
        self._telling.all({"type": "saved", "path": printable(str(path))})

    def run_trials(self, count: int) -> None:
        """Run the open recording's plan in `count` disturbed worlds, in the background."""
        self._trials.run(self._current(), self.settings, count)

    def cancel_trials(self) -> None:
        """Give up the trials that run."""
        self._trials.cancel()

    def over(self) -> Running:
        """The replay that is over. Raises SimulationError where there is none."""
        running = self.running
        if running is None or running.result is None:
            raise SimulationError("No replay is over yet; run one to its end, or stop it.")
        return running

    def do(self, what: Action) -> None:
        """What a page asks, by its name in the protocol."""
        {
            "run": self.go_on,
            "again": self.begin,
            "pause": self.pause,
            "next": self.next_skill,
            "hold": lambda: self.hold(True),
            "release": lambda: self.hold(False),
            "stop": self.stop,
            "leave": self.leave,
            "keep": self.keep,
            "speed": lambda: None,
        }[what]()

    def greet(self, page: Page) -> None:
        """Tell a new page of the replay that is shown, with all that was told before."""
        with self._lock:
            if self.running and self._streamed:
                page.send(self._message(self.running))
                page.send(self._streamed.everything())

    # -- inside

    def _build(self, opened: Opened, one_skill: bool) -> None:
        self._telling.progress("Building the workcell", None)
        try:
            self.leave()
            settings = self.settings
            plan = plan_of(opened.labeling, settings.end_by)
            cell = workcell(settings.workcell)
            simulation = cell.build(settings.disturbance, settings.seed)
            replay_ = Replay(simulation, plan.skills, plan.demonstration)
            self._begin(opened, settings, plan.begun_with(replay_.skills), replay_, one_skill)
        finally:
            self._building = False
            self._telling.progress_done()

    def _begin(
        self,
        opened: Opened,
        settings: ReplaySettings,
        plan: ReplayPlan,
        replay_: Replay,
        one_skill: bool,
    ) -> None:
        with self._lock:
            self._count += 1
            number = self._count
            run = ReplayRun(
                replay_, settings.speed, self._ticked, self._changed, self._telling.report
            )
            simulation = replay_.simulation
            shapes, goals = simulation.shapes(), simulation.workcell.goals(simulation)
            self.running = Running(number, opened, settings, plan, run, shapes, goals)
            self._streamed = Streamed(number, plan)
            running = self.running
            # Told before anything of it is, and all of it before anyone can leave it again.
            self._telling.all(self._message(running))
            self._each(lambda view: view.show_begun(running))
            run.start(one_skill=one_skill)

    def _ticked(self, tick: Tick) -> None:
        with self._lock:
            running = self.running
            if running is None:
                return
            self._tell_samples(running)
        self._each(lambda view: view.show_tick(running, tick))

    def _changed(self) -> None:
        """A skill ended, or the phase changed: told in the run's own thread."""
        with self._lock:
            running = self.running
            if running is None:
                return
            if running.phase == "over":
                running = self.running = replace(running, result=_result(running.run.replay))
                self._tell_samples(running)
            self._telling.all(self._message(running))
        self._each(lambda view: view.show_status(running))

    def _tell_samples(self, running: Running) -> None:
        assert self._streamed is not None
        message = self._streamed.more(running.run.replay.states, running.run.factor)
        if message is not None:
            self._telling.all(message)

    def _message(self, running: Running) -> dict[str, Any]:
        return replay_message(
            number=running.number,
            recording=running.opened.recording,
            settings=running.settings,
            plan=running.plan,
            goals=running.goals,
            run=running.run,
            result=running.result,
        )

    def _each(self, show: Callable[[ReplayView], None]) -> None:
        for view in self._views:
            try:
                show(view)
            except Exception as error:
                self._telling.report(error)


def _result(replay_: Replay) -> ReplayResult | None:
    """What came of it; nothing where it was stopped before it had moved."""
    return replay_.result() if len(replay_.states) > 1 else None


def free_path(recording: Path) -> Path:
    """A name for the recording of a replay that no file has: setup1_replay_01.npz, …"""
    number = 1
    while (path := recording.with_name(f"{recording.stem}_replay_{number:02d}.npz")).exists():
        number += 1
    return path
