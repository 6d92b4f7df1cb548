"""A small sound file of every kind keyphase reads, each made by its format's own library."""

import json
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import scipy.io
import zarr
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_typestore

from keyphase.demonstration import Demonstration, Source
from keyphase.labeling.edits import Add, Done, Keep, Label
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import write_segment_file
from keyphase.labeling.storage.folder_settings import change_folder_settings
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.vocabulary import Vocabulary, VocabularyLabel
from keyphase.readers import read, save_csv, save_npz
from keyphase.segmentation import segment

ROWS = 60
T = np.arange(ROWS) / 50.0
PLACE = np.column_stack([0.1 * T, np.where(T > 0.6, 0.2 * (T - 0.6), 0.0), 0.3 - 0.05 * T])
WXYZ = np.column_stack([np.cos(T / 4), np.sin(T / 4), 0 * T, 0 * T])
FORCE = np.column_stack([0 * T, 0 * T, np.where(T > 0.6, 8.0, 0.02 * np.sin(40 * T))])

RECIPE = """
[table]
separator = ","
[time]
column = "time_s"
unit = "s"
from_zero = true
[position]
columns = "position_?_m"
unit = "m"
[orientation]
kind = "quaternion"
order = "wxyz"
columns = "orientation_?"
normalise = true
[force]
columns = ["force_x_N", "force_y_N", "force_z_N"]
unit = "N"
offset_from_first_s = 0.2
[wrench]
frame = "tool"
sign = -1
[rows]
repeated = "drop"
irregular = "resample"
rate_hz = 100
held = "interpolate"
outliers = "drop"
"""
ARRAY_RECIPE = """
time = {column = "array[0]", unit = "s"}
position = {columns = ["array[1]", "array[2]", "array[3]"], unit = "m"}
"""
MAT_RECIPE = """
time = {column = "t", unit = "s"}
position = {columns = "robot.place[*]", unit = "m"}
"""
PLAIN_RECIPE = """
time = {column = "timestamp", unit = "s"}
position = {columns = "place[*]", unit = "m"}
"""
BAG_RECIPE = """
time = {column = "/pose.stamp", unit = "s"}
position = {columns = "/pose.pose.position.?", unit = "m"}
"""
URDF = """<?xml version="1.0"?>
<robot name="r"><link name="base"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual>
</link><link name="tool"><visual><origin xyz="0 0 0.1" rpy="0 0 0"/><geometry>
<cylinder radius="0.1" length="0.2"/></geometry></visual><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="jaw"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="tool"/>
<origin xyz="0 0 0.1" rpy="0 0 0"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
<joint name="j2" type="prismatic"><parent link="tool"/><child link="jaw"/><axis xyz="0 1 0"/>
<limit lower="0" upper="1" velocity="1" effort="1"/><mimic joint="j1" multiplier="2"/></joint>
</robot>
"""


def demonstration(path: Path | None = None) -> Demonstration:
    """A tool that goes one way and then another, in contact."""
    source = None if path is None else Source(path, "0" * 64)
    return Demonstration("run", T, PLACE, WXYZ, FORCE, 0.1 * FORCE, np.sin(PLACE), source=source)


def npz(folder: Path) -> Path:
    save_npz(demonstration(), folder / "run.npz")
    return folder / "run.npz"


def deflated(folder: Path) -> Path:
    with np.load(npz(folder)) as arrays:
        np.savez_compressed(folder / "run.npz", **arrays)
    return folder / "run.npz"


def csv(folder: Path) -> Path:
    save_csv(demonstration(), folder / "run.csv")
    return folder / "run.csv"


def table(folder: Path) -> Path:
    (folder / "run.csv.recipe.toml").write_text(RECIPE)
    return csv(folder)


def npy(folder: Path) -> Path:
    (folder / "run.npy.recipe.toml").write_text(ARRAY_RECIPE)
    np.save(folder / "run.npy", np.column_stack([T, PLACE]))
    return folder / "run.npy"


def mat(folder: Path) -> Path:
    (folder / "run.mat.recipe.toml").write_text(MAT_RECIPE)
    scipy.io.savemat(folder / "run.mat", {"t": T, "robot": {"place": PLACE}}, do_compression=True)
    return folder / "run.mat"


def hdf5(folder: Path) -> Path:
    with h5py.File(folder / "run.hdf5", "w") as file:
        file.create_group("data").attrs["env_args"] = json.dumps(
            {"env_kwargs": {"control_freq": 20}}
        )
        for number in range(2):
            obs = file.create_group(f"data/demo_{number}/obs")
            obs.create_dataset("robot0_eef_pos", data=PLACE, chunks=(20, 3), compression="gzip")
            obs["robot0_eef_quat"] = np.roll(WXYZ, -1, axis=1)
    return folder / "run.hdf5"


def _fill(root: zarr.Group) -> None:
    data = {"timestamp": T, "place": PLACE}
    for group, arrays in (("data", data), ("meta", {"episode_ends": np.array([30, ROWS])})):
        inside = root.create_group(group)
        for name, values in arrays.items():
            inside.create_array(name, shape=values.shape, dtype=values.dtype)[...] = values


def zarr_folder(folder: Path) -> Path:
    (folder / "recipe.toml").write_text(PLAIN_RECIPE)
    _fill(zarr.open_group(folder / "run.zarr", mode="w", zarr_format=2))
    return folder / "run.zarr"


def zarr_zip(folder: Path) -> Path:
    (folder / "recipe.toml").write_text(PLAIN_RECIPE)
    with zarr.storage.ZipStore(folder / "run.zarr.zip", mode="w") as store:
        _fill(zarr.open_group(store, mode="w", zarr_format=3))
    return folder / "run.zarr.zip"


def lerobot(folder: Path) -> Path:
    dataset = folder / "run"
    (dataset / "meta" / "episodes" / "chunk-000").mkdir(parents=True)
    (dataset / "data" / "chunk-000").mkdir(parents=True)
    (folder / "recipe.toml").write_text(PLAIN_RECIPE)
    where = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
    info = {"codebase_version": "v3.0", "fps": 50, "total_episodes": 2, "data_path": where}
    (dataset / "meta" / "info.json").write_text(json.dumps(info | {"features": {}}))
    place = pa.FixedSizeListArray.from_arrays(PLACE.ravel(), 3)
    episodes = np.repeat([0, 1], ROWS // 2)
    rows = pa.table({"timestamp": T, "place": place, "episode_index": episodes})
    pq.write_table(rows, dataset / "data/chunk-000/file-000.parquet", row_group_size=ROWS // 2)
    index = {"episode_index": [0, 1], "data/chunk_index": [0, 0], "data/file_index": [0, 0]}
    pq.write_table(pa.table(index), dataset / "meta/episodes/chunk-000/file-000.parquet")
    return dataset


def _poses(store: object, first: dict[str, int]) -> list[object]:
    types = store.types
    found = []
    for at, (x, y, z) in zip(T, PLACE, strict=True):
        stamp = types["builtin_interfaces/msg/Time"](100 + int(at), int(at % 1 * 1e9))
        header = types["std_msgs/msg/Header"](**first, stamp=stamp, frame_id="base")
        turn = types["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=0.0, w=1.0)
        pose = types["geometry_msgs/msg/Pose"](
            position=types["geometry_msgs/msg/Point"](x=x, y=y, z=z), orientation=turn
        )
        found.append(types["geometry_msgs/msg/PoseStamped"](header=header, pose=pose))
    return found


def bag(folder: Path) -> Path:
    (folder / "recipe.toml").write_text(BAG_RECIPE)
    store = get_typestore(Stores.ROS1_NOETIC)
    with Writer1(folder / "run.bag") as writer:
        topic = writer.add_connection("/pose", "geometry_msgs/msg/PoseStamped", typestore=store)
        for i, message in enumerate(_poses(store, {"seq": 0})):
            raw = store.serialize_ros1(message, "geometry_msgs/msg/PoseStamped")
            writer.write(topic, 10**11 + i * 20_000_000, raw)
    return folder / "run.bag"


def _ros2(folder: Path, plugin: StoragePlugin) -> Path:
    (folder / "recipe.toml").write_text(BAG_RECIPE)
    store = get_typestore(Stores.ROS2_HUMBLE)
    with Writer2(folder / "run", version=9, storage_plugin=plugin) as writer:
        topic = writer.add_connection("/pose", "geometry_msgs/msg/PoseStamped", typestore=store)
        for i, message in enumerate(_poses(store, {})):
            raw = bytes(store.serialize_cdr(message, "geometry_msgs/msg/PoseStamped"))
            writer.write(topic, 10**11 + i * 20_000_000, raw)
    return folder / "run"


def ros2(folder: Path) -> Path:
    return _ros2(folder, StoragePlugin.SQLITE3)


def mcap(folder: Path) -> Path:
    return _ros2(folder, StoragePlugin.MCAP)


def urdf(folder: Path) -> Path:
    (folder / "r.urdf").write_text(URDF)
    return folder / "r.urdf"


def segment_file(folder: Path) -> Path:
    write_segment_file(label(segment(read(npz(folder)))), folder / "run.segments.json")
    return folder / "run.segments.json"


def journal(folder: Path) -> Path:
    """A journal of a few edits, beside the recording it belongs to."""
    recording = read(npz(folder))
    with Journal(recording) as opened:
        for edit in (Add(0.3), Label(0.4, "press"), Keep(0.1, False), Done()):
            found = label(segment(recording), opened.document.edits)
            opened.save(opened.document.apply(edit, found))
        return opened.path


def folder_file(folder: Path) -> Path:
    words = Vocabulary((VocabularyLabel("insert", "#58A2F2"), VocabularyLabel("push", "#EFB63A")))
    change_folder_settings(folder, lambda settings: replace(settings, vocabulary=words))
    return next(folder.rglob("folder.json"))
