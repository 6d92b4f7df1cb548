"""The playhead: where it is, whether it runs, and the clock that moves it."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

AROUND_S = 0.7
"""So much before and after a doubt is played with it."""

STEPS_PER_S = 60.0
"""How often a running playhead is told to the pages."""


@dataclass(frozen=True)
class Playhead:
    """Where playback is; times in the demonstration's own clock.

    speed      below zero it runs backwards
    between_s  the stretch that is played again and again, as around a doubt, until it is left
    """

    time_s: float = 0.0
    start_s: float = 0.0
    end_s: float = 0.0
    playing: bool = False
    speed: float = 1.0
    loop: bool = False
    between_s: tuple[float, float] | None = None

    def at(self, time_s: float) -> "Playhead":
        """The same, moved to `time_s` or as near as the recording goes.

        Whoever moves it while a stretch is played again and again wants to see that place.
        """
        playing = self.playing and self.between_s is None
        time_s = min(max(time_s, self.start_s), self.end_s)
        return replace(self, time_s=time_s, playing=playing, between_s=None)

    def advanced(self, elapsed_s: float) -> "Playhead":
        """After `elapsed_s` of real time; at the end it stops, or begins again if it loops.

        Backwards the start is the end.
        """
        if not self.playing:
            return self
        time_s = self.time_s + elapsed_s * self.speed
        if self.between_s is not None:
            from_s, to_s = self.between_s
            return replace(self, time_s=from_s + (time_s - from_s) % (to_s - from_s))
        forwards = self.speed > 0.0
        if (time_s < self.end_s) if forwards else (time_s > self.start_s):
            return replace(self, time_s=time_s)
        if self.loop and self.end_s > self.start_s:
            duration = self.end_s - self.start_s
            return replace(self, time_s=self.start_s + (time_s - self.start_s) % duration)
        return replace(self, time_s=self.end_s if forwards else self.start_s, playing=False)

    def played(self, playing: bool, speed: float, loop: bool) -> "Playhead":
        """The same, playing or paused; playing at the end begins at the start.

        Backwards it is the other way round.
        """
        ends_s, begins_s = self.end_s, self.start_s
        if speed < 0.0:
            ends_s, begins_s = begins_s, ends_s
        time_s = begins_s if playing and not self.playing and self.time_s == ends_s else self.time_s
        between_s = self.between_s if playing else None
        return replace(
            self, time_s=time_s, playing=playing, speed=speed, loop=loop, between_s=between_s
        )

    def around(self, time_s: float) -> "Playhead":
        """Playing what is right before and after `time_s`, again and again."""
        from_s = max(time_s - AROUND_S, self.start_s)
        to_s = min(time_s + AROUND_S, self.end_s)
        if not from_s < to_s:
            return self
        between_s, speed = (from_s, to_s), abs(self.speed)
        return replace(self, time_s=from_s, playing=True, speed=speed, between_s=between_s)


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
