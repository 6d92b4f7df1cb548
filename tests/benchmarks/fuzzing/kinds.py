"""What is mutated and how it is read: one entry for each kind of file that keyphase reads."""

import csv
import io
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np

from fuzzing import more_sound, sound
from keyphase.demonstration import Demonstration


@dataclass(frozen=True)
class Kind:
    """A kind of file: makes a sound one in a folder, and uses what is at a path.

    weight  how often it comes
    target  which file of the folder is mutated: a pattern, or the sound file itself
    """

    make: Callable[[Path], Path]
    use: Callable[[Path], object]
    weight: int
    target: str = ""


def _read(path: Path) -> Demonstration:
    from keyphase.readers import read

    return read(path)


def _part(part: str) -> Callable[[Path], Demonstration]:
    from keyphase.readers import find_recordings, read

    def use(path: Path) -> Demonstration:
        find_recordings([path])
        return read(f"{path}#{part}")

    return use


def _beside(recording: str) -> Callable[[Path], Demonstration]:
    """The recording that the file which is mutated lies beside."""
    return lambda path: _read(path.with_name(recording))


def _proposal(path: Path) -> str:
    from keyphase.readers.proposing.proposal import propose

    return propose(path).recipe_text()


def _like_numpy(path: Path) -> Demonstration:
    """The numbers are those that numpy.load gives."""
    demonstration = _read(path)
    try:
        with np.load(path, allow_pickle=False) as arrays:
            others = {name: np.array(arrays[name], np.float64) for name in arrays.files
                      if name in ("time_s", "position_m", "force_N", "torque_Nm")}  # fmt: skip
    except Exception:
        return demonstration
    for name, values in others.items():
        own = getattr(demonstration, name)
        # A member without its ending is an array to NumPy, and left out with a notice by us.
        if own is not None and not np.array_equal(own, values.reshape(own.shape)):
            raise AssertionError(f"{name} differs from numpy's")
    return demonstration


def _like_csv(path: Path) -> Demonstration:
    """The numbers are those that the csv module gives."""
    demonstration = _read(path)
    try:
        text = path.read_bytes().decode("utf-8-sig")
        rows = list(csv.DictReader(io.StringIO(text, newline=""), skipinitialspace=True))
        names = {"position_m": "position_?_m", "force_N": "force_?_N"}
        others = {
            channel: np.array([[float(row[name.replace("?", a)]) for a in "xyz"] for row in rows])
            for channel, name in names.items()
            if getattr(demonstration, channel) is not None
        }
    except Exception:
        return demonstration
    torn = any("left out" in notice and "line" in notice for notice in demonstration.notices)
    for name, values in others.items():
        own = getattr(demonstration, name)
        if not np.array_equal(own, values[: len(own)] if torn else values):
            raise AssertionError(f"{name} differs from the csv module's")
    return demonstration


def _like_load(path: Path) -> Demonstration:
    demonstration = _read(path)
    try:
        values = np.load(path, allow_pickle=False)
    except Exception:
        return demonstration
    if not np.array_equal(demonstration.position_m, values[:, 1:4]):
        raise AssertionError("position_m differs from numpy's")
    return demonstration


def _segment_file(path: Path) -> object:
    from keyphase.labeling.segment_file import read_segment_file

    return read_segment_file(path)


def _journal(path: Path) -> object:
    from keyphase.labeling.storage.journal import Journal
    from keyphase.labeling.storage.summary import summarize

    recording = path.parent.parent / "run.npz"
    summarize(recording)
    with Journal(_read(recording), read_only=True) as opened:
        document = opened.document
        return (
            document.edits,
            document.parameters,
            document.done,
            msgspec.json.encode(opened.notices),
        )


def _folder(path: Path) -> object:
    from keyphase.labeling.storage.folder_settings import read_folder_settings

    return msgspec.json.encode(read_folder_settings(path.parent.parent).notice)


def _urdf(path: Path) -> object:
    from keyphase.robot.description import load_description

    return load_description(path, "tool").joint_names


KINDS = {
    "npz": Kind(sound.npz, _like_numpy, 10),
    "npz, deflated": Kind(sound.deflated, _like_numpy, 6),
    "csv": Kind(sound.csv, _like_csv, 10),
    "table by a recipe": Kind(sound.table, _read, 8),
    "recipe": Kind(sound.table, _read, 8, "run.csv.recipe.toml"),
    "npy": Kind(sound.npy, _like_load, 6),
    "mat": Kind(sound.mat, _read, 6),
    "hdf5": Kind(sound.hdf5, _part("demo_1"), 6),
    "zarr": Kind(sound.zarr_folder, _part("episode_1"), 2, "run.zarr/**/*"),
    "zarr.zip": Kind(sound.zarr_zip, _part("episode_1"), 3),
    "lerobot": Kind(sound.lerobot, _part("episode_1"), 6, "run/**/*"),
    "ros 1 bag": Kind(sound.bag, _read, 2),
    "ros 2 bag": Kind(sound.ros2, _read, 1, "run/*"),
    "mcap": Kind(sound.mcap, _read, 2, "run/*"),
    "npz of other names": Kind(more_sound.archive, _read, 2),
    "mat 7.3": Kind(more_sound.matlab_73, _read, 2),
    "parquet": Kind(more_sound.parquet, _read, 2),
    "mcap of JSON": Kind(more_sound.json_messages, _read, 2),
    "mcap of Protobuf": Kind(more_sound.protobuf_messages, _read, 2),
    "table of all sections": Kind(more_sound.sections, _part("second"), 2),
    "recipe of all sections": Kind(more_sound.sections, _part("second"), 2, "*.recipe.toml"),
    "unknown table": Kind(more_sound.unknown_table, _proposal, 2),
    "wrench in a table": Kind(more_sound.wrench_table, _beside("run.csv"), 2, "run_ft.csv"),
    "wrench in HDF5": Kind(more_sound.wrench_hdf5, _beside("run.csv"), 2, "run_ft.h5"),
    "mat of cells": Kind(more_sound.cells_of_matlab, _part("demos_2"), 2),
    "lists in cells": Kind(more_sound.list_cells, _read, 2),
    "segment file": Kind(sound.segment_file, _segment_file, 8),
    "journal": Kind(sound.journal, _journal, 8),
    "folder file": Kind(sound.folder_file, _folder, 6),
    "urdf": Kind(sound.urdf, _urdf, 2),
}
