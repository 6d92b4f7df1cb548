"""One replay in real time: a thread that steps it as fast as the clock says, no faster.

What people ask of it goes through a queue of orders that the thread obeys between two ticks, so
that nothing is ever changed in the middle of one and a stop takes no longer than a tick.
"""

import queue
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from keyphase.demonstration import Array
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.replay.result import ReplayState
from keyphase.skills.execution.executor import STEP_S

Phase = Literal["running", "paused", "over"]

BATCHES_PER_S = 60.0
"""How often ticks that are due are stepped, all at once."""

LATEST_S = 0.1
"""A replay further behind the clock than this does not catch up: it goes on from where it is."""

MEASURED_S = 1.0
"""Speed is measured over this time."""

Order = Callable[[], None]


@dataclass(frozen=True, eq=False)
class Tick:
    """The newest tick, and where the parts are: position (3,) and wxyz (4,) by name."""

    state: ReplayState
    parts: Mapping[str, tuple[Array, Array]]


class ReplayRun:
    """Runs a replay; methods may be called from any thread.

    `on_ticks` is told after each batch of ticks, `on_change` when a skill or the phase changed,
    `on_error` what ended it. All three are called in the run's own thread.
    """

    def __init__(
        self,
        replay: Replay,
        speed: float,
        on_ticks: Callable[[Tick], None],
        on_change: Callable[[], None],
        on_error: Callable[[Exception], None],
    ) -> None:
        self.replay = replay
        self.phase: Phase = "running"
        self.held = False
        self.met_s: dict[int, float] = {}
        self.failure: Exception | None = None
        self._speed = speed
        self._on_ticks, self._on_change, self._on_error = on_ticks, on_change, on_error
        self._orders: queue.SimpleQueue[Order] = queue.SimpleQueue()
        self._ticks = 0
        self._only_skill: int | None = None
        self._anchor = (0.0, 0.0)
        self._next_s = 0.0
        self._measured: deque[tuple[float, float]] = deque()
        self._thread = threading.Thread(target=self._live, name="replay", daemon=True)

    # -- what people ask

    def start(self, *, one_skill: bool = False) -> None:
        """Begin; with `one_skill` it pauses when the first one has ended."""
        if one_skill:
            self._only_skill = 0
        self._thread.start()

    def pause(self, paused: bool) -> None:
        """Stand still, or go on."""
        self._orders.put(lambda: self._go("paused" if paused else "running"))

    def next_skill(self) -> None:
        """Go on until the skill that runs now has ended."""

        def order() -> None:
            self._only_skill = len(self.replay.results)
            self._go("running")

        self._orders.put(order)

    def set_speed(self, speed: float) -> None:
        """So much replay time per real time from now on."""

        def order() -> None:
            self._speed = speed
            self._anchor_now()

        self._orders.put(order)

    def hold(self, held: bool) -> None:
        """Hold the tool where it is now, or let it go."""

        def order() -> None:
            self.held = held
            self.replay.hold(self.replay.simulation.here() if held else None)
            self._on_change()

        self._orders.put(order)

    def push(self, force_N: Array) -> None:
        """Push the tool point with a force (3,), base frame, until told otherwise."""
        self._orders.put(lambda: self.replay.push(force_N))

    def stop(self) -> None:
        """End it at once."""

        def order() -> None:
            # That nothing moves any more is told before its result is worked out.
            self._go("paused")
            self.replay.stop()

        self._orders.put(order)

    def join(self, timeout_s: float | None = None) -> bool:
        """Wait until it is over; whether it is."""
        self._thread.join(timeout_s)
        return not self._thread.is_alive()

    # -- how it is

    @property
    def elapsed_s(self) -> float:
        """Replay time so far."""
        return self._ticks * STEP_S

    @property
    def factor(self) -> float:
        """Replay time per real time over the last second, in which it may have stood still."""
        if len(self._measured) < 2:
            return 0.0
        (wall, elapsed), (last_wall, last_elapsed) = self._measured[0], self._measured[-1]
        return (last_elapsed - elapsed) / max(last_wall - wall, 1e-9)

    # -- the thread

    def _live(self) -> None:
        try:
            self._anchor_now()
            while not self.replay.over:
                self._obey()
                if self.phase == "running":
                    self._catch_up()
        except Exception as error:
            self.failure = error
            self.replay.stop()
        self.phase = "over"
        self._on_change()
        if self.failure is not None:
            self._on_error(self.failure)

    def _obey(self) -> None:
        """Obey what was ordered, waiting for it until the next batch is due, or paused for ever."""
        left = None if self.phase == "paused" else max(self._next_s - time.perf_counter(), 0.0)
        try:
            self._orders.get(timeout=left)()
            while True:
                self._orders.get_nowait()()
        except queue.Empty:
            return

    def _catch_up(self) -> None:
        """Step all ticks that are due by now, unless an order comes in between."""
        now = time.perf_counter()
        self._next_s = now + 1.0 / BATCHES_PER_S
        wall, elapsed = self._anchor
        latest_s = self.elapsed_s + LATEST_S * self._speed
        due_s = elapsed + (now - wall) * self._speed
        if due_s > latest_s:
            due_s = latest_s
            self._anchor = (now, due_s)
        while self.elapsed_s + STEP_S <= due_s and self._orders.empty() and self._may_go_on():
            self._step()
        self._measure(now)
        if self._ticks:
            self._on_ticks(Tick(self.replay.state, self.replay.simulation.part_poses()))

    def _step(self) -> None:
        before = len(self.replay.results)
        state = self.replay.step()
        self._ticks += 1
        if state.stage == "pressing" and state.skill is not None:
            self.met_s.setdefault(state.skill, state.elapsed_s)
        if len(self.replay.results) != before or self._ticks == 1:
            if self._only_skill is not None and before >= self._only_skill and self._ticks > 1:
                self._only_skill = None
                self.phase = "paused"
            self._on_change()

    def _may_go_on(self) -> bool:
        return self.phase == "running" and not self.replay.over

    def _go(self, phase: Phase) -> None:
        self.phase = phase
        self._measured.clear()
        self._anchor_now()
        self._on_change()

    def _anchor_now(self) -> None:
        self._anchor = (time.perf_counter(), self.elapsed_s)

    def _measure(self, now: float) -> None:
        self._measured.append((now, self.elapsed_s))
        while now - self._measured[0][0] > MEASURED_S:
            self._measured.popleft()
