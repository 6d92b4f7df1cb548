"""Binary files as other people's recorders write them, by the formats' own libraries.

Each holds the press of `strangers_tables`: down for two seconds, on the table for two, 5 N upwards.
"""

import json
from pathlib import Path

import h5py
import numpy as np
from mcap.writer import Writer

from strangers_tables import press

XYZW = (0.0, 1.0, 0.0, 0.0)
"""How the tool is turned: it points down."""

_BEGIN_NS = 1_740_822_000_000_000_000


def nobodys_hdf5(folder: Path, name: str = "session_7.h5", takes: int = 2) -> Path:
    """Takes in groups, pose and wrench at one rate, in mm, with names no preset knows; a camera."""
    time_s, position, force = press()
    turned = np.tile(XYZW, (len(time_s), 1))
    with h5py.File(folder / name, "w") as file:
        for take in range(takes):
            group = file.create_group(f"takes/take_{take}")
            group["clock"] = 12.5 + time_s
            group["clock"].attrs["unit"] = "s"
            group["tool_pose"] = np.hstack([1000 * position + take, turned])
            group["ft"] = np.hstack([-force, 0 * force])
            group["motor_current"] = np.random.default_rng(take).normal(1, 0.1, (len(time_s), 7))
            group["camera"] = np.zeros((len(time_s), 4, 4, 3), np.uint8)
    return folder / name


def nobodys_mcap(folder: Path, sensor_ns: int = _BEGIN_NS) -> Path:
    """JSON messages without ROS: a pose at 125 Hz and a force at 62.5 Hz, each with its stamp; the
    clock of the sensor begins at `sensor_ns`.
    """
    time_s, position, force = press()
    with (folder / "cell_4.mcap").open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library="cell")
        schema = writer.register_schema("any", "jsonschema", b"{}")
        pose = writer.register_channel("/robot/state", "json", schema)
        loaded = writer.register_channel("/sensor", "json", schema)
        for i, seconds in enumerate(time_s):
            ns = _BEGIN_NS + round(1e9 * seconds)
            stamp = _stamp(ns)
            place = dict(zip("xyz", position[i].tolist(), strict=True))
            said = {"stamp": stamp, "tcp": place, "speed": 0.1 * i}
            writer.add_message(pose, ns + 10**6, json.dumps(said).encode(), ns)
            if i % 2 == 0:
                told = _stamp(ns - _BEGIN_NS + sensor_ns)
                felt = {"stamp": told, "force": dict(zip("xyz", force[i].tolist(), strict=True))}
                writer.add_message(loaded, ns + 2 * 10**6, json.dumps(felt).encode(), ns)
        writer.finish()
    return folder / "cell_4.mcap"


def _stamp(ns: int) -> dict[str, int]:
    return {"sec": ns // 10**9, "nsec": ns % 10**9}
