"""Known recordings as they would be, had they been recorded in another way."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation
from transferring.known import Known

from keyphase.demonstration import Demonstration

Channels = dict[str, Any]
Vary = Callable[[Known, np.random.Generator], Known]

_NAMES = ("time_s", "position_m", "orientation_wxyz", "force_N", "torque_Nm", "gripper")
_BACK_S = 1.0
_ASIDE_S = 1.2


def at_rate(rate_hz: float) -> Vary:
    """Sampled at another rate."""

    def vary(known: Known, _: np.random.Generator) -> Known:
        channels = _channels(known)
        time_s = channels["time_s"]
        grid = np.arange(time_s[0], time_s[-1], 1.0 / rate_hz)
        sampled = {name: _at(grid, time_s, values) for name, values in channels.items()}
        turns = sampled["orientation_wxyz"]
        sampled["orientation_wxyz"] = turns / np.linalg.norm(turns, axis=1, keepdims=True)
        return _known(known, sampled)

    return vary


def turned(vector_rad: Sequence[float]) -> Vary:
    """By a robot whose base stands otherwise."""
    turn = Rotation.from_rotvec(vector_rad)

    def vary(known: Known, _: np.random.Generator) -> Known:
        channels = _channels(known)
        for name in ("position_m", "force_N", "torque_Nm"):
            channels[name] = channels[name] @ turn.as_matrix().T
        own = Rotation.from_quat(channels["orientation_wxyz"], scalar_first=True)
        channels["orientation_wxyz"] = (turn * own).as_quat(scalar_first=True)
        return _known(known, channels)

    return vary


def mirrored(known: Known, _: np.random.Generator) -> Known:
    """By the other hand, all to the other side."""
    channels = _channels(known)
    aside = np.array([1.0, -1.0, 1.0])
    channels["position_m"] = channels["position_m"] * aside
    channels["force_N"] = channels["force_N"] * aside
    channels["torque_Nm"] = channels["torque_Nm"] * -aside
    channels["orientation_wxyz"] = channels["orientation_wxyz"] * [1.0, -1.0, 1.0, -1.0]
    return _known(known, channels)


def with_force(constant_N: float, drift_N: float) -> Vary:
    """By a sensor that reads too much, and ever more, in one direction."""

    def vary(known: Known, rng: np.random.Generator) -> Known:
        channels = _channels(known)
        share = (channels["time_s"] - channels["time_s"][0]) / np.ptp(channels["time_s"])
        wrong_N = (constant_N + drift_N * share)[:, None] * _direction(rng)
        channels["force_N"] = channels["force_N"] + wrong_N
        return _known(known, channels)

    return vary


def without_force(known: Known, _: np.random.Generator) -> Known:
    """By a robot without a sensor."""
    channels = _channels(known)
    del channels["force_N"], channels["torque_Nm"]
    return _known(known, channels)


def begun_aside(away_m: float) -> Vary:
    """Coming from another place to where the other recordings begin."""

    def vary(known: Known, rng: np.random.Generator) -> Known:
        channels = _channels(known)
        count = int(_ASIDE_S / _step_s(channels))
        way = _held(channels, 0, count)
        from_there = rng.normal(size=3)
        from_there[2] = abs(from_there[2])
        from_there /= np.linalg.norm(from_there)
        share = 1.0 - _eased(count)
        way["position_m"] = way["position_m"] + away_m * share * from_there
        longer, lasting_s = _inserted(channels, 0, way)
        return _known(known, longer, [end + lasting_s for end in known.ends_s], known.names)

    return vary


def rested(where: str, lasting_s: float) -> Vary:
    """With a rest: at the "start", at the "end", or somewhere "within" a phase."""

    def vary(known: Known, rng: np.random.Generator) -> Known:
        channels = _channels(known)
        edges, time_s = _edges(known), channels["time_s"]
        number = int(rng.integers(len(known.names)))
        middle_s = 0.5 * (edges[number] + edges[number + 1])
        at_s = {"start": edges[0], "end": edges[-1], "within": middle_s}[where]
        at = min(int(np.searchsorted(time_s, at_s)), len(time_s) - 1)
        still = _held(channels, at, int(lasting_s / _step_s(channels)))
        still["force_N"] = still["force_N"] + 0.05 * rng.normal(size=still["force_N"].shape)
        longer, took_s = _inserted(channels, at, still)
        return _known(known, longer, [e + took_s * (e >= at_s) for e in known.ends_s], known.names)

    return vary


def without_a_phase(known: Known, rng: np.random.Generator) -> Known:
    """One phase that is not done; what follows begins where it would have."""
    channels, edges = _channels(known), _edges(known)
    out = int(rng.integers(1, len(known.names) - 1))
    first, last = _samples(channels, edges[out : out + 2])
    for name, values in channels.items():
        after = values[last:]
        if name in ("time_s", "position_m"):
            after = after - (values[last] - values[first])
        channels[name] = np.concatenate([values[:first], after])
    lasting_s = edges[out + 1] - edges[out]
    ends = [e - lasting_s * (e > edges[out]) for i, e in enumerate(known.ends_s) if i != out]
    return _known(known, channels, ends, [n for i, n in enumerate(known.names) if i != out])


def with_a_phase_twice(known: Known, rng: np.random.Generator) -> Known:
    """One phase that is done again, after a way back of a second."""
    channels, edges = _channels(known), _edges(known)
    twice = int(rng.integers(1, len(known.names) - 1))
    first, last = _samples(channels, edges[twice : twice + 2])
    share = _eased(int(_BACK_S / _step_s(channels)))
    again: Channels = {}
    for name, values in channels.items():
        columns = values.reshape(len(values), -1)
        back = columns[last] * (1.0 - share) + columns[first] * share
        if name == "position_m":
            back = back + [0.0, 0.0, 0.03] * np.sin(np.pi * np.linspace(0, 1, len(share)))[:, None]
        both = np.concatenate([back, columns[first:last]])
        again[name] = both.reshape(len(both), *values.shape[1:])
    longer, took_s = _inserted(channels, last, again)
    after = [edges[twice + 1] + _BACK_S, *(e + took_s for e in edges[twice + 1 : -1])]
    names = [*known.names[: twice + 1], "back", *known.names[twice:]]
    return _known(known, longer, [*known.ends_s[: twice + 1], *after], names)


def swapped(known: Known, rng: np.random.Generator) -> Known:
    """Two phases in the other order, each from where the one before ends."""
    channels, edges, names = _channels(known), _edges(known), list(known.names)
    one = int(rng.integers(0, len(names) - 2))
    first, middle, last = _samples(channels, edges[one : one + 3])
    for name, values in channels.items():
        if name == "time_s":
            continue
        before, after = values[first:middle], values[middle:last]
        if name == "position_m":
            after = after - values[middle] + values[first]
            before = before - values[first] + after[-1]
        channels[name] = np.concatenate([values[:first], after, before, values[last:]])
    ends = list(known.ends_s)
    ends[one] = edges[one] + edges[one + 2] - edges[one + 1]
    names[one], names[one + 1] = names[one + 1], names[one]
    return _known(known, channels, ends, names)


def begun_late(known: Known, _: np.random.Generator) -> Known:
    """Recorded from the second phase on."""
    channels = _channels(known)
    first = int(np.searchsorted(channels["time_s"], known.ends_s[0]))
    cut = {name: values[first:] for name, values in channels.items()}
    return _known(known, cut, known.ends_s[1:], known.names[1:])


def stopped_early(known: Known, _: np.random.Generator) -> Known:
    """Recorded up to the last phase."""
    channels = _channels(known)
    last = int(np.searchsorted(channels["time_s"], known.ends_s[-1]))
    cut = {name: values[:last] for name, values in channels.items()}
    return _known(known, cut, known.ends_s[:-1], known.names[:-1])


VARIED: dict[str, Vary] = {
    "25 Hz": at_rate(25.0),
    "60 Hz": at_rate(60.0),
    "1000 Hz": at_rate(1000.0),
    "turned by 90 degrees": turned([0.0, 0.0, 0.5 * np.pi]),
    "turned by 180 degrees": turned([0.0, 0.0, np.pi]),
    "upside down": turned([np.pi, 0.0, 0.0]),
    "at a wall": turned([0.0, 0.5 * np.pi, 0.0]),
    "mirror image": mirrored,
    "20 N too much": with_force(20.0, 0.0),
    "drift of 3 N": with_force(0.0, 3.0),
    "no force": without_force,
    "began 0.1 m aside": begun_aside(0.1),
    "5 s of rest before": rested("start", 5.0),
    "5 s of rest after": rested("end", 5.0),
    "5 s of rest within": rested("within", 5.0),
    "a phase missing": without_a_phase,
    "a phase twice": with_a_phase_twice,
    "two phases swapped": swapped,
    "began late": begun_late,
    "stopped early": stopped_early,
}


def _channels(known: Known) -> Channels:
    values = {name: getattr(known.demonstration, name) for name in _NAMES}
    return {name: np.array(value) for name, value in values.items() if value is not None}


def _known(
    known: Known,
    channels: Channels,
    ends_s: Sequence[float] | None = None,
    names: Sequence[str] | None = None,
) -> Known:
    return replace(
        known,
        demonstration=Demonstration(known.demonstration.name, **channels),
        ends_s=known.ends_s if ends_s is None else tuple(ends_s),
        names=known.names if names is None else tuple(names),
    )


def _edges(known: Known) -> list[float]:
    return [known.demonstration.start_s, *known.ends_s, known.demonstration.end_s]


def _samples(channels: Channels, times_s: Sequence[float]) -> list[int]:
    found = np.searchsorted(channels["time_s"], times_s)
    return np.minimum(found, len(channels["time_s"]) - 1).tolist()


def _step_s(channels: Channels) -> float:
    return float(np.median(np.diff(channels["time_s"])))


def _at(grid: np.ndarray, time_s: np.ndarray, values: np.ndarray) -> np.ndarray:
    columns = values.reshape(len(values), -1).T
    found = np.column_stack([np.interp(grid, time_s, column) for column in columns])
    return found.reshape(len(grid), *values.shape[1:])


def _direction(rng: np.random.Generator) -> np.ndarray:
    towards = rng.normal(size=3)
    return towards / np.linalg.norm(towards)


def _eased(count: int) -> np.ndarray:
    return (0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, count)))[:, None]


def _held(channels: Channels, at: int, count: int) -> Channels:
    return {name: np.repeat(values[at][None], count, 0) for name, values in channels.items()}


def _inserted(channels: Channels, at: int, piece: Channels) -> tuple[Channels, float]:
    """With a piece before a sample, and how long it takes [s]; its own times do not count."""
    count, step_s = len(piece["position_m"]), _step_s(channels)
    longer = {
        name: np.concatenate([values[:at], piece[name], values[at:]])
        for name, values in channels.items()
    }
    time_s = channels["time_s"]
    during = time_s[at] + step_s * np.arange(count)
    longer["time_s"] = np.concatenate([time_s[:at], during, time_s[at:] + count * step_s])
    return longer, count * step_s
