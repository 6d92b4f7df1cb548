"""Recording by lead-through: one workcell that runs, and the takes made in it.

The simulation steps in a thread of its own; another tells what is to be shown, some 40 times a
second. What is recorded is on the disk while it is recorded, whatever becomes of the page.
"""

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Literal, Protocol

from keyphase.demonstration import Array
from keyphase.errors import RequestError, SimulationError
from keyphase.simulation.demonstrating.follower import MAX_AHEAD_M
from keyphase.simulation.demonstrating.lead_through import LeadThrough
from keyphase.simulation.workcells.registry import workcell
from keyphase.workbench.leading.status import LeadThroughStatus
from keyphase.workbench.leading.takes import Takes
from keyphase.workbench.telling import Telling
from keyphase.workbench.watcher import Watcher

SHOWN_HZ = 40.0
"""How often the workcell is shown."""


LeadAction = Literal["open", "close", "start", "stop", "reset", "undo_take", "redo_take"]


class Places(Protocol):
    """Where takes go: into the list, and out of it again."""

    def add(self, path: Path) -> None:
        """A recording more, which is opened."""
        ...

    def remove(self, path: Path) -> None:
        """A recording less."""
        ...


class LeadThroughSession:
    """The recording by hand of one page; `each` tells its watchers. For many threads."""

    def __init__(
        self,
        takes: Takes,
        places: Places,
        telling: Telling,
        each: Callable[[Callable[[Watcher], None]], None],
    ) -> None:
        self._takes, self._places, self._telling, self._each = takes, places, telling, each
        self._lock = threading.RLock()
        self._lead: LeadThrough | None = None
        self._workcell: str | None = None
        self._path: Path | None = None
        self._teller: threading.Thread | None = None
        self._opened = 0

    def greet(self, watcher: Watcher) -> None:
        """Tell one that has come how it all stands."""
        with self._lock:
            status = self.status()
            if self._lead is not None:
                watcher.show_workcell(status, self._lead.shapes)
            watcher.show_workcell_status(status)

    def turn_away(self) -> None:
        """Another recording is looked at: close the workcell, unless a take is being made."""
        with self._lock:
            if self._path is None:
                self.close()

    def status(self) -> LeadThroughStatus:
        """How things stand."""
        with self._lock:
            return LeadThroughStatus(
                self._workcell,
                None if self._lead is None else self._lead.state(),
                self._takes.can_undo,
                self._takes.can_redo,
            )

    def do(self, what: LeadAction, name: str | None) -> None:
        """What a page asks, by its name in the protocol; `open` and `start` name a workcell."""
        if what in ("open", "start"):
            if name is None:
                raise RequestError(f"A request to {what} recording must name a workcell.")
            (self.open if what == "open" else self.record)(name)
            return
        {
            "close": self.close,
            "stop": self.stop,
            "reset": self.reset,
            "undo_take": self.undo_take,
            "redo_take": self.redo_take,
        }[what]()

    def open(self, name: str) -> None:
        """Build a workcell, arm and parts at their start, and let it run.

        Raises SimulationError for a name nobody knows, or while another is recorded.
        """
        with self._lock:
            if self._path is not None:
                raise SimulationError("A take is being recorded; stop it before opening another.")
            self.close()
            self._opened += 1
            self._lead = LeadThrough(workcell(name), seed=self._opened)
            self._workcell = name
            shapes, status = self._lead.shapes, self.status()
            self._each(lambda watcher: watcher.show_workcell(status, shapes))
            self._lead.start()
            self._teller = threading.Thread(
                target=self._tell_of, args=(self._lead,), name="lead-through view", daemon=True
            )
            self._teller.start()

    def close(self) -> None:
        """Close the workcell; a take that is being recorded is finished first."""
        with self._lock:
            lead, path = self._lead, self._path
            self._lead = self._workcell = self._path = None
            if lead is None:
                return
            try:
                lead.close()
            finally:
                self._each(lambda watcher: watcher.show_workcell_closed())
                if path is not None and path.exists():
                    self._keep(path)
                self._tell()

    def record(self, name: str) -> None:
        """Begin a take in the workcell, opened first where it is not.

        Raises SimulationError where nothing can be recorded.
        """
        with self._lock:
            if self._lead is None or self._workcell != name:
                self.open(name)
            assert self._lead is not None
            path = self._takes.next_path(name)
            self._lead.start_recording(path)
            self._path = path
        self._tell()

    def stop(self) -> None:
        """End the take: it is on the disk, joins the list, and is opened; the workcell closes.

        Raises SimulationError where none is recorded.
        """
        with self._lock:
            if self._lead is None or self._path is None:
                raise SimulationError("No take is being recorded; start a recording first.")
            self.close()

    def reset(self) -> None:
        """Arm and parts back to their start. Raises SimulationError while a take is recorded."""
        with self._lock:
            if self._path is not None:
                raise SimulationError("A take is being recorded; stop it before starting again.")
            if self._workcell is not None:
                self.open(self._workcell)

    def undo_take(self) -> None:
        """Take the newest take out of the list and hide its file."""
        with self._lock:
            self._places.remove(self._takes.last())
            self._takes.undo()
        self._tell()

    def redo_take(self) -> None:
        """Bring back what was undone last."""
        with self._lock:
            self._places.add(self._takes.redo())
        self._tell()

    def pull(self, position_m: Array, wxyz: Array) -> None:
        """The hand is there now."""
        lead = self._lead
        if lead is not None:
            lead.set_target(position_m, wxyz)

    def hold(self, position_m: Array, wxyz: Array) -> tuple[Array, Array] | None:
        """The gizmo was released: the hand stays, but no further from the tool than it pulls.

        Gives back where that is, None where no workcell is open.
        """
        lead = self._lead
        if lead is None:
            return None
        tool = lead.state().sample.position_m
        away = position_m - tool
        size = float((away @ away) ** 0.5)
        held = tool + away * min(1.0, MAX_AHEAD_M / max(size, 1e-9))
        lead.set_target(held, wxyz)
        return held, wxyz

    def _keep(self, path: Path) -> None:
        self._takes.add(path)
        self._places.add(path)
        self._telling.notice("info", f"Recorded: {path.name}")

    def _tell(self) -> None:
        with self._lock:
            status = self.status()
            self._each(lambda watcher: watcher.show_workcell_status(status))

    def _tell_of(self, lead: LeadThrough) -> None:
        pause = threading.Event()
        while self._lead is lead and lead.failure is None:
            self._safely(self._tell)
            pause.wait(1.0 / SHOWN_HZ)
        if lead.failure is not None and self._lead is lead:
            self._telling.report(lead.failure)
            self._safely(self.close)

    def _safely(self, act: Callable[[], None]) -> None:
        try:
            act()
        except Exception as error:
            self._telling.report(error)
