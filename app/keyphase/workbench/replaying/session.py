"""Replay for one page: what was chosen for it, the one that runs, trials beside it."""

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import RequestError, SimulationError
from keyphase.labeling.storage.written_files import IfThere
from keyphase.readers import save_npz
from keyphase.simulation.choosing import RECORDING, cell_for, recorded_in
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.replay.result import ReplayResult
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.replaying.exports import export_plan
from keyphase.workbench.replaying.margin import ReplayMargin
from keyphase.workbench.replaying.plan import ReplayPlan, plan_of
from keyphase.workbench.replaying.run import ReplayRun, Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.replaying.settings import Action, ReplaySettings
from keyphase.workbench.replaying.trials import ReplayTrials
from keyphase.workbench.telling import Telling
from keyphase.workbench.watcher import Watcher
from keyphase.workbench.worker import Worker


class ReplaySession:
    """The replay of one page; methods may be called from any thread.

    `current` is what the page looks at, `add` puts a recording into the list and opens it, `each`
    tells the page's watchers.
    """

    def __init__(
        self,
        current: Callable[[], DeskState],
        add: Callable[[Path], None],
        telling: Telling,
        each: Callable[[Callable[[Watcher], None]], None],
    ) -> None:
        self.settings = ReplaySettings()
        self.running: Running | None = None
        self._current, self._add, self._telling, self._each = current, add, telling, each
        self._lock = threading.RLock()
        self._worker = Worker(telling.report)
        self._trials = ReplayTrials(
            telling, lambda trials: self._each(lambda watcher: watcher.show_trials(trials))
        )
        self._margin = ReplayMargin(
            telling, lambda margin: self._each(lambda watcher: watcher.show_margin(margin))
        )
        self._count = 0
        self._building = False
        self._proposed: Demonstration | None = None

    def greet(self, watcher: Watcher) -> None:
        """Tell one that has come how it all stands."""
        with self._lock:
            watcher.show_settings(self.settings)
            if self.running is not None:
                watcher.show_begun(self.running)

    def close(self) -> None:
        """End everything."""
        self._trials.stop()
        self._margin.stop()
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
            settings = self.settings
            if self.running and settings.speed != before.speed:
                self.running.run.set_speed(settings.speed)
        self._each(lambda watcher: watcher.show_settings(settings))

    def turn_to(self, state: DeskState) -> None:
        """Another recording is looked at: a replay of one before is shown no more.

        The workcell it was recorded in is chosen; for every other, the world made from it.
        """
        chosen = recorded_in(state.demonstration) or RECORDING
        with self._lock:
            before, self._proposed = self._proposed, state.demonstration
            running = self.running
        if running and running.opened.demonstration is not state.demonstration:
            self._worker.submit(self.leave)
        if before is not state.demonstration:
            self.configure(lambda settings: replace(settings, workcell=chosen))

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
            running, self.running = self.running, None
        if running is None:
            return
        running.run.stop()
        running.run.join()
        self._each(lambda watcher: watcher.show_replay_closed())

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
        self._add(path)
        self.leave()

    def export(self, state: DeskState, kind: str, if_there: IfThere = "ask") -> None:
        """Write the plan of a recording: its `skills`, a `behavior-tree`, or a `program`.

        Or the replay that is over, as a `page`. Raises SkillError for what cannot be executed,
        FileInTheWayError where somebody else's file would be replaced.
        """
        if kind == "page":
            running = self.over()
            if running.opened.recording.id != state.recording.id:
                raise RequestError("The replay that is over is of another recording.")
            self._each(lambda watcher: watcher.write_replay(running, if_there))
            return
        plan = plan_of(state.labeling, self.settings.end_by)
        path = export_plan(plan, state.recording.path, kind, if_there)
        self._each(lambda watcher: watcher.show_saved(path, kind))

    def run_trials(self, count: int) -> None:
        """Run the open recording's plan in `count` disturbed worlds, in the background."""
        self._trials.run(self._current(), self.settings, count)

    def cancel_trials(self) -> None:
        """Give up the trials that run."""
        self._trials.cancel()

    def try_margin(self) -> None:
        """Try how far the world may differ until the open recording's plan fails."""
        self._margin.run(self._current(), self.settings)

    def cancel_margin(self) -> None:
        """Give up the margin that is being tried."""
        self._margin.cancel()

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

    # -- inside

    def _build(self, opened: DeskState, one_skill: bool) -> None:
        try:
            with self._telling.tasks.begin("Building the workcell"):
                self.leave()
                settings = self.settings
                cell = cell_for(opened.demonstration, settings.workcell)
                plan = plan_of(opened.labeling, settings.end_by, cell)
                simulation = cell.build(settings.disturbance, settings.seed)
                replay_ = Replay(simulation, plan.skills, plan.demonstration)
                self._begin(opened, settings, plan.begun_with(replay_.skills), replay_, one_skill)
        finally:
            self._building = False

    def _begin(
        self,
        opened: DeskState,
        settings: ReplaySettings,
        plan: ReplayPlan,
        replay_: Replay,
        one_skill: bool,
    ) -> None:
        with self._lock:
            self._count += 1
            run = ReplayRun(
                replay_, settings.speed, self._ticked, self._changed, self._telling.report
            )
            simulation = replay_.simulation
            shapes, goals = simulation.shapes(), simulation.workcell.goals(simulation)
            running = Running(self._count, opened, settings, plan, run, shapes, goals)
            self.running = running
            # Told before anything of it is, and all of it before anyone can leave it again.
            self._each(lambda watcher: watcher.show_begun(running))
            run.start(one_skill=one_skill)

    def _ticked(self, tick: Tick) -> None:
        with self._lock:
            running = self.running
        if running is not None:
            self._each(lambda watcher: watcher.show_tick(running, tick))

    def _changed(self) -> None:
        """A skill ended, or the phase changed: told in the run's own thread."""
        with self._lock:
            running = self.running
            if running is None:
                return
            if running.phase == "over":
                running = self.running = replace(running, result=_result(running.run.replay))
        self._each(lambda watcher: watcher.show_status(running))


def _result(replay_: Replay) -> ReplayResult | None:
    """What came of it; nothing where it was stopped before it had moved."""
    return replay_.result() if len(replay_.states) > 1 else None


def free_path(recording: Path) -> Path:
    """A name for the recording of a replay that no file has: setup1_replay_01.npz, …"""
    number = 1
    while (path := recording.with_name(f"{recording.stem}_replay_{number:02d}.npz")).exists():
        number += 1
    return path
