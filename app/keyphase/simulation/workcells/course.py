"""The course of a task: what has to happen in a workcell, in which order, and whether it did."""

from collections.abc import Mapping

from keyphase.simulation.simulated import Cell, Simulated

ASKED_EVERY = 5
"""Events are asked for every so many ticks (20 ms): they last, or they are none."""


class Course:
    """Watches a simulation while something is done in it.

    An event that lies behind another in the workcell's list counts only if that one has happened
    before it: a cap pushed to the wall before it was snapped on has not been brought there.
    """

    def __init__(self, cell: Cell) -> None:
        self._cell = cell
        self._happened: dict[str, int] = {}
        self._ticks = 0

    def watch(self, simulation: Simulated) -> None:
        """Take in the newest tick."""
        self._ticks += 1
        if self._ticks % ASKED_EVERY:
            return
        for event in self._cell.events:
            if event.name not in self._happened and event.holds(simulation):
                self._happened[event.name] = self._ticks

    def checks(self, simulation: Simulated) -> Mapping[str, bool]:
        """Every goal of the workcell by name: its events in their order, then what holds now."""
        return {**self._in_order(), **self._cell.checks(simulation)}

    def _in_order(self) -> dict[str, bool]:
        latest, found = 0, {}
        for event in self._cell.events:
            at = self._happened.get(event.name)
            found[event.name] = at is not None and at >= latest
            latest = max(latest, self._ticks + 1 if at is None else at)
        return found
