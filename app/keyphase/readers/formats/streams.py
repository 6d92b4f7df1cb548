"""The topics of a bag while it is read: columns and clocks of each, within a limit of memory."""

from array import array
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields, is_dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.notices import Caution
from keyphase.readers.beginnings import Zero, Zeros, zeros_of
from keyphase.readers.formats.damage import UnfitError
from keyphase.readers.formats.messages import Plain, numbers_in, stamp_of
from keyphase.readers.formats.numeric import MAX_NUMBERS_A_ROW

_MAX_DEPTH = 8
STATIC = "/tf_static["
"""How the topics of transforms begin that hold for good and are sent once."""


@dataclass
class _Stream:
    """One topic as it is read, eight bytes a number.

    frame    what the header of its first message names
    numbers  of each column, message by message; None where their count changes
    sizes    how many numbers of each column one message holds; 0 for a plain number
    """

    getters: dict[str, Callable[[Any], Any]]
    stamped: bool
    frame: str = ""
    numbers: dict[str, "array[float] | None"] = field(default_factory=dict)
    sizes: dict[str, int] = field(default_factory=dict)
    stamps_ns: "array[int]" = field(default_factory=lambda: array("q"))
    logs_ns: "array[int]" = field(default_factory=lambda: array("q"))

    def append(self, name: str, value: Any) -> None:
        """One value more of a column."""
        size = np.size(value) if np.ndim(value) else 0
        held = self.numbers.setdefault(name, array("d"))
        if held is None or size != self.sizes.setdefault(name, size):
            self.numbers[name] = None
        elif size:
            held.extend(float(one) for one in np.ravel(value))
        else:
            held.append(float(value))

    def column(self, name: str) -> NDArray[np.float64] | None:
        """All numbers of a column, (N,) or (N, D), or None where their count changes."""
        held, size = self.numbers[name], self.sizes[name]
        if held is None:
            return None
        values = np.frombuffer(held, dtype=np.float64)
        return values.reshape(-1, size) if size else values


class Streams:
    """All topics; messages are added in the order of the file."""

    def __init__(self, file: str, limit_bytes: int, of_ros: bool = True) -> None:
        self._file, self._limit, self._of_ros = file, limit_bytes, of_ros
        self._streams: dict[str, _Stream] = {}
        self._undefined: dict[str, str] = {}
        self._numbers = 0

    def pass_over(self, topic: str, kind: str) -> None:
        """A topic whose messages nobody can read, and what they are."""
        self._undefined[topic] = kind

    def passes_over(self, topic: str) -> bool:
        """Whether its messages need not be looked at."""
        return topic in self._undefined

    def add(self, topic: str, log_ns: int, message: Any) -> None:
        """One message of ROS more."""
        if topic not in self._streams:
            stamped = hasattr(message, "header")
            frame = str(getattr(message.header, "frame_id", "")) if stamped else ""
            self._streams[topic] = _Stream(dict(_numbers_of(message)), stamped, frame)
        stream = self._streams[topic]
        stamp = message.header.stamp if stream.stamped else None
        ns = None if stamp is None else stamp.sec * 10**9 + stamp.nanosec
        self._append(stream, log_ns, ns, message)

    def add_plain(self, topic: str, log_ns: int, content: Plain) -> None:
        """One message in JSON or Protobuf more."""
        numbers, ns = dict(numbers_in(content)), stamp_of(content)
        if topic not in self._streams:
            getters = {name: _getter(name) for name in numbers}
            frame = str(content.get("frame_id", ""))[:100]
            self._streams[topic] = _Stream(getters, ns is not None, frame)
        stream = self._streams[topic]
        if not stream.getters.keys() <= numbers.keys() or (stream.stamped and ns is None):
            missing = sorted(stream.getters.keys() - numbers.keys())[:3] or ["its stamp"]
            raise UnfitError(f"a message of {topic} goes without {', '.join(missing)}")
        self._append(stream, log_ns, ns, numbers)

    def _append(self, stream: _Stream, log_ns: int, stamp_ns: int | None, message: Any) -> None:
        for name, get in stream.getters.items():
            value = get(message)
            self._numbers += int(np.size(value))
            stream.append(name, value)
        self._numbers += 2
        if 8 * self._numbers > self._limit:
            raise DemonstrationError(
                f"{self._file}: the bag takes more memory than the limit of {self._limit} bytes; "
                "cut it, leave topics out, or raise the limit."
            )
        stream.logs_ns.append(log_ns)
        if stream.stamped and stamp_ns is not None:
            stream.stamps_ns.append(stamp_ns)

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Columns and clocks of every topic with at least two messages, and static transforms."""
        if self._undefined and not self._streams:
            raise DemonstrationError(f"{self._file}: {self._nothing_known()}.")
        used = self._used()
        zeros = self._zeros()
        kept = used | {t: one for t, one in self._streams.items() if t.startswith(STATIC)}
        found: dict[str, NDArray[Any]] = {}
        for topic, one in kept.items():
            found[f"{topic}.log_time"] = (np.array(one.logs_ns) - zeros.log.own_ns) * 1e-9
            if one.stamped:
                zero = zeros.stamps.get(topic, zeros.log)
                found[f"{topic}.stamp"] = (np.array(one.stamps_ns) - zero.own_ns) * 1e-9
            for name in one.numbers:
                values = one.column(name)
                if values is not None:
                    found[f"{topic}.{name}" if name else topic] = values
        return found

    def _nothing_known(self) -> str:
        kinds = ", ".join(sorted(set(self._undefined.values()))[:3])
        if not self._of_ros:
            return (
                f"expected messages in JSON or Protobuf, but they are written in {kinds}; record "
                "them so, or with ROS 2's own tools"
            )
        return (
            "expected messages of known kinds, but of those in it there is no definition "
            f"({kinds}); convert it to MCAP where their packages are installed: ros2 bag convert"
        )

    def zeros(self) -> dict[str, Zero]:
        """From when each clock counts that is among the arrays."""
        zeros = self._zeros()
        stamps = {f"{topic}.stamp": zeros.stamps.get(topic, zeros.log) for topic in self._streams}
        return stamps | {f"{topic}.log_time": zeros.log for topic in self._streams}

    def _used(self) -> dict[str, _Stream]:
        return {topic: one for topic, one in self._streams.items() if len(one.logs_ns) > 1}

    def _zeros(self) -> Zeros:
        used = self._used().items()
        return zeros_of({t: (s.logs_ns[0], s.stamps_ns[0] if s.stamped else None) for t, s in used})

    def notices(self) -> tuple[str, ...]:
        """Which topics said too little to be read."""
        few = [
            topic
            for topic, one in self._streams.items()
            if len(one.logs_ns) < 2 and not topic.startswith(STATIC)
        ]
        told = ()
        if few:
            told += (Caution(f"Topics of one message were passed over: {', '.join(few[:5])}."),)
        if self._undefined:
            shown = ", ".join(f"{t} ({kind})" for t, kind in list(self._undefined.items())[:5])
            why = "the bag does not define" if self._of_ros else "are not in JSON or Protobuf"
            said = f"Topics were passed over whose messages {why}: {shown}."
            told += (Caution(said),)
        return told

    def remarks(self) -> tuple[str, ...]:
        """Whose clock tells another time than the recorder's; in whose axes topics are written."""
        named = {t: s.frame for t, s in self._streams.items() if s.frame and ">" not in t}
        apart = tuple(
            f"{topic} is stamped by a clock that tells another time than the recorder's"
            for topic, zero in self._zeros().stamps.items()
            if zero.clock
        )
        return apart + tuple(f"{topic} is in the frame {frame!r}" for topic, frame in named.items())


def _getter(name: str) -> Callable[[dict[str, Any]], Any]:
    return lambda numbers: numbers[name]


def _numbers_of(
    value: Any,
    before: str = "",
    get: Callable[[Any], Any] = lambda message: message,
    depth: int = 0,
) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """The numbers in a message, by the path to each, and how to fetch it from another one."""
    if depth > _MAX_DEPTH:
        return
    for one in fields(value):
        if one.name in ("header", "__msgtype__") or one.name.startswith("_"):
            continue
        inner = getattr(value, one.name)
        name = f"{before}{one.name}"

        def fetch(message: Any, get: Callable[[Any], Any] = get, key: str = one.name) -> Any:
            return getattr(get(message), key)

        if is_dataclass(inner):
            yield from _numbers_of(inner, f"{name}.", fetch, depth + 1)
        elif isinstance(inner, bool | int | float) or _is_row(inner):
            yield name, fetch


def _is_row(value: Any) -> bool:
    is_numbers = isinstance(value, np.ndarray) and value.dtype.kind in "fiub"
    return is_numbers and 0 < value.size <= MAX_NUMBERS_A_ROW
