"""Tables as other people's recorders write them, each with the demonstration that is in it.

Every table holds the same press: down for two seconds, on the table for two, 5 N upwards.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array

SAMPLES, RATE_HZ = 500, 125.0


@dataclass(frozen=True)
class Stranger:
    """A table, and what a person would have to say of it: frame and sign of the wrench."""

    name: str
    data: bytes
    frame: str
    sign: int


def press() -> tuple[Array, Array, Array]:
    """Time [s], position [m] and force [N] of the press, (N,), (N, 3), (N, 3)."""
    time_s = np.arange(SAMPLES) / RATE_HZ
    noise = np.random.default_rng(3).normal(0, 0.02, (SAMPLES, 3))
    down = np.clip(time_s / 2, 0, 1)
    position = np.column_stack([0.40 + 0.02 * time_s, 0.01 + 0 * time_s, 0.30 - 0.12 * down])
    force = noise + np.column_stack([0 * time_s, 0 * time_s, np.where(time_s >= 2, 5.0, 0.0)])
    return time_s, position, force


def strangers() -> tuple[Stranger, ...]:
    """Six of them, each with habits of its own."""
    return (_german(), _plain(), _radians(), _tabs(), _two_part_stamp(), _no_time())


def _german() -> Stranger:
    """cp1252, a comment line, `;`, decimal comma, ms since boot, mm, x y z w, the tool's wrench."""
    time_s, position, force = press()
    turned = np.tile([0.0, 0.0, 0.0, 1.0], (SAMPLES, 1))
    columns = np.column_stack([1000 * position, turned, -force, 50 + 0 * time_s])
    names = "zeit_ms;Pos X (mm);Pos Y (mm);Pos Z (mm);qx;qy;qz;qw;Fx [N];Fy [N];Fz [N];Greifer (mm)"
    rows = _rows([1_234_567 + round(1000 * t) for t in time_s], columns, ";", _comma)
    text = "\r\n".join(["# Prüfstand 3", names + ";Bemerkung", *(row + ";läuft" for row in rows)])
    return Stranger("lauf_3.csv", (text + "\r\n").encode("cp1252"), "tool", -1)


def _plain() -> Stranger:
    time_s, position, force = press()
    rows = _rows(time_s, np.column_stack([position, force]), ",", _point)
    return Stranger("log.csv", _text("t,tcp_x,tcp_y,tcp_z,fx,fy,fz", rows), "base", 1)


def _radians() -> Stranger:
    """Roll, pitch and yaw, in metres, nanoseconds since 1970."""
    time_s, position, force = press()
    columns = np.column_stack([position, 0.01 * position, force])
    stamps = [1_700_000_000_000_000_000 + round(1e9 * t) for t in time_s]
    names = "timestamp_ns,pose.x,pose.y,pose.z,roll,pitch,yaw,force.x,force.y,force.z"
    return Stranger("merged.csv", _text(names, _rows(stamps, columns, ",", _point)), "base", 1)


def _tabs() -> Stranger:
    """Blanks between numbers, a header behind `#`, millimetres."""
    time_s, position, force = press()
    rows = _rows(time_s, np.column_stack([1000 * position, force]), "\t", _point)
    names = "# time[s]\tx[mm]\ty[mm]\tz[mm]\tFx[N]\tFy[N]\tFz[N]"
    return Stranger("robot.txt", _text(names, rows), "base", 1)


def _two_part_stamp() -> Stranger:
    time_s, position, force = press()
    columns = np.column_stack([position, np.tile([0.0, 0.0, 0.0, 1.0], (SAMPLES, 1)), force])
    stamps = [f"{1_700_000_000 + int(t)},{round(1e9 * (t - int(t)))}" for t in time_s]
    names = (
        "header.stamp.secs,header.stamp.nsecs,pose.position.x,pose.position.y,pose.position.z,"
        "pose.orientation.x,pose.orientation.y,pose.orientation.z,pose.orientation.w,"
        "wrench.force.x,wrench.force.y,wrench.force.z"
    )
    return Stranger("topic.csv", _text(names, _rows(stamps, columns, ",", _point)), "base", 1)


def _no_time() -> Stranger:
    """No header and no time: thirteen numbers in a row, at a rate a person knows."""
    _, position, force = press()
    columns = np.column_stack([position, np.tile([1.0, 0.0, 0.0, 0.0], (SAMPLES, 1)), force])
    rows = [" ".join(f"{cell:.6f}" for cell in row) for row in columns]
    return Stranger("trajectory.dat", ("\n".join(rows) + "\n").encode(), "base", 1)


def _rows(
    first: Sequence[object], columns: Array, separator: str, write: Callable[[float], str]
) -> list[str]:
    return [
        separator.join([str(one), *map(write, row)])
        for one, row in zip(first, columns.tolist(), strict=True)
    ]


def _comma(value: float) -> str:
    return f"{value:.4f}".replace(".", ",")


def _point(value: float) -> str:
    return f"{value:.6f}"


def _text(names: str, rows: Sequence[str]) -> bytes:
    return ("\n".join([names, *rows]) + "\n").encode()
