"""The playhead: where it is, whether it runs, and the clock that moves it."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

STEPS_PER_S = 60.0
"""How often a running playhead is told to the pages."""


@dataclass(frozen=True)
class Playhead:
    """Where playback is; times in the demonstration's own clock."""

    time_s: float = 0.0
    start_s: float = 0.0
    end_s: float = 0.0
    playing: bool = False
    speed: float = 1.0
    loop: bool = False

    def at(self, time_s: float) -> "Playhead":
        """The same, moved to `time_s` or as near as the recording goes."""
        return replace(self, time_s=min(max(time_s, self.start_s), self.end_s))

    def advanced(self, elapsed_s: float) -> "Playhead":
        """After `elapsed_s` of real time; at the end it stops, or begins again if it loops."""
        if not self.playing:
            return self
        time_s = self.time_s + elapsed_s * self.speed
        if time_s < self.end_s:
            return replace(self, time_s=time_s)
        if self.loop and self.end_s > self.start_s:
            duration = self.end_s - self.start_s
            return replace(self, time_s=self.start_s + (time_s - self.start_s) % duration)
        return replace(self, time_s=self.end_s, playing=False)

    def played(self, playing: bool, speed: float, loop: bool) -> "Playhead":
        """The same, playing or paused; playing at the end begins at the start."""
        begins = playing and not self.playing and self.time_s >= self.end_s
        time_s = self.start_s if begins else self.time_s
        return replace(self, time_s=time_s, playing=playing, speed=speed, loop=loop)


class Clock:
    """Calls `step` with the seconds since the last call, while it is awake."""

    def __init__(self, step: Callable[[float], bool]) -> None:
        self._step = step
        self._awake = threading.Event()
        self._stopped = False
        self._thread = threading.Thread(target=self._run, name="playback", daemon=True)
        self._thread.start()

    def wake(self) -> None:
        """Begin stepping; it goes on until `step` returns False."""
        self._awake.set()

    def stop(self) -> None:
        """End the thread."""
        self._stopped = True
        self._awake.set()

    def _run(self) -> None:
        while self._awake.wait() and not self._stopped:
            self._awake.clear()
            due = before = time.perf_counter()
            going = True
            while going and not self._stopped:
                # By the clock, so that what a step and waking up take does not add up.
                due = max(due + 1.0 / STEPS_PER_S, before)
                time.sleep(max(due - time.perf_counter(), 0.0))
                now = time.perf_counter()
                going = self._step(now - before)
                before = now
