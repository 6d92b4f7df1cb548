"""From when the clocks of a recording count: one zero for all that tell the same time.

Computers of one laboratory tell the same time to within seconds, while a clock that counts since it
was switched on, or a simulated one, is years away. Those that agree share one zero, so that they go
together; the others count from their own.
"""

from collections.abc import Mapping
from dataclasses import dataclass

_AGREE_NS = 1800 * 10**9
"""Further apart no two clocks are that somebody has set; zones of time differ by more."""


@dataclass(frozen=True)
class Zero:
    """From when a clock counts.

    clock   which clock it is; those with the same number go together, 0 is the recorder's own
    own_ns  the zero in the time of that clock [ns]
    log_ns  the same in the time of the log [ns]
    """

    clock: int
    own_ns: int
    log_ns: int


@dataclass(frozen=True)
class Zeros:
    """The zero of the log, and those of the stamps of each stream that has them."""

    log: Zero
    stamps: Mapping[str, Zero]

    def of_stamp(self, first_ns: int) -> Zero | None:
        """The zero of the clock that told this stamp, or None where no stream goes by it."""
        zeros = (self.log, *self.stamps.values())
        return next((one for one in zeros if abs(one.own_ns - first_ns) < _AGREE_NS), None)


def zeros_of(firsts: Mapping[str, tuple[int, int | None]]) -> Zeros:
    """From when each clock counts.

    `firsts` has of each stream the first time in the log and the first stamp [ns], None or 0 where
    it has none.
    """
    begin = min((log for log, _ in firsts.values()), default=0)
    stamps = {name: stamp for name, (_, stamp) in firsts.items() if stamp}
    agreeing = [one for one in stamps.values() if abs(one - begin) < _AGREE_NS]
    first = min([begin, *agreeing])
    log = Zero(0, first, first)
    zeros = {name: log for name, one in stamps.items() if abs(one - begin) < _AGREE_NS}
    others = sorted((one, name) for name, one in stamps.items() if name not in zeros)
    last = None
    for one, name in others:
        if last is None or one - last.own_ns >= _AGREE_NS:
            last = Zero(1 if last is None else last.clock + 1, one, begin)
        zeros[name] = last
    return Zeros(log, zeros)
