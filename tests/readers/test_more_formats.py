"""Archives, MATLAB 7.3, Parquet, records, MCAP without ROS and chains of transforms.

Each is written by the format's own library, read by the recipe that is proposed, and compared value
by value.
"""

import json
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import scipy.io
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from mcap.writer import CompressionType, Writer
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as BagWriter
from rosbags.typesys import Stores, get_typestore
from scipy.spatial.transform import Rotation

from keyphase.auditing.reading import given_labels
from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import find_recordings, parse_recipe, read
from keyphase.readers.formats.bags import table_of_bag
from keyphase.readers.proposing.proposal import propose
from strangers_files import nobodys_mcap

ROWS = 100
TIME = np.arange(ROWS) / 50
POSITION = np.stack([0.4 + 0.1 * TIME, 0.1 * np.sin(TIME), 0.3 - 0.1 * TIME], axis=1)
TURNS = Rotation.from_euler("xyz", np.stack([3 + 0 * TIME, 0.1 * TIME, 0.4 * TIME], axis=1))
XYZW = TURNS.as_quat()
FORCE = np.stack([0.1 * TIME, -2 * TIME, 9 * TIME], axis=1)
BEGIN_NS = 1_740_822_000_000_000_000


def archive(folder: Path) -> Path:
    wrench = np.hstack([FORCE, 0 * FORCE])
    np.savez(folder / "run.npz", t=TIME, ee_pos=POSITION, ee_quat=XYZW, ft=wrench, note="first")
    return folder / "run.npz"


def lying_in_matlab(folder: Path) -> Path:
    columns = {"t": TIME, "pos": POSITION.T, "quat": XYZW.T, "F": FORCE.T}
    scipy.io.savemat(folder / "run.mat", columns)
    return folder / "run.mat"


def matlab_73(folder: Path) -> Path:
    """As MATLAB writes it: HDF5 behind 512 bytes of its own, axes the other way round."""
    path = folder / "new.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, values in {"t": TIME[:, None], "pos": POSITION, "quat": XYZW, "F": FORCE}.items():
            file.create_dataset(f"log/{name}", data=values.T).attrs["MATLAB_class"] = np.bytes_(
                "double"
            )
    with path.open("r+b") as stream:
        stream.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(124) + b"\x00\x02IM")
    return path


def parquet(folder: Path) -> Path:
    stamps = pa.array(BEGIN_NS + np.round(1e9 * TIME).astype(np.int64), pa.timestamp("ns"))
    columns: dict[str, object] = {"stamp": stamps, "quat": list(XYZW)}
    columns |= {name: POSITION[:, i] for i, name in enumerate("xyz")}
    columns |= {f"f{name}": FORCE[:, i] for i, name in enumerate("xyz")}
    pq.write_table(pa.table(columns), folder / "run.parquet")
    return folder / "run.parquet"


def records(folder: Path) -> Path:
    kinds = [("time", "f8"), ("pose", "f8", 7), ("force", "f4", 3), ("state", "S8")]
    rows = np.zeros(ROWS, dtype=kinds)
    rows["time"], rows["pose"], rows["force"] = TIME, np.hstack([POSITION, XYZW]), FORCE
    with h5py.File(folder / "log.h5", "w") as file:
        file["log"] = rows
    return folder / "log.h5"


def json_messages(folder: Path) -> Path:
    with (folder / "json.mcap").open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library="lab")
        schema = writer.register_schema("pose", "jsonschema", b"{}")
        pose, force = (writer.register_channel(t, "json", schema) for t in ("/pose", "/force"))
        for i, seconds in enumerate(TIME):
            ns = BEGIN_NS + round(1e9 * seconds)
            stamp = {"sec": ns // 10**9, "nsec": ns % 10**9}
            place = {"position": dict(zip("xyz", POSITION[i], strict=True))}
            turn = {"orientation": dict(zip("xyzw", XYZW[i], strict=True))}
            said = {"timestamp": stamp, "frame_id": "base", **place, **turn}
            writer.add_message(pose, ns + 10**6, json.dumps(said).encode(), ns)
            loaded = {"force": FORCE[i].tolist(), "ok": True}
            writer.add_message(force, ns, json.dumps(loaded).encode(), ns)
        writer.finish()
    return folder / "json.mcap"


def protobuf_messages(folder: Path) -> Path:
    file = descriptor_pb2.FileDescriptorProto(name="lab.proto", package="lab", syntax="proto3")
    vector, state = file.message_type.add(name="Vector"), file.message_type.add(name="State")
    for number, name in enumerate("xyz"):
        vector.field.add(name=name, number=number + 1, type=1, label=1)
    state.field.add(name="stamp_ns", number=1, type=4, label=1)
    for number, name in enumerate(("position", "force")):
        state.field.add(name=name, number=number + 2, type=11, label=1, type_name=".lab.Vector")
    state.field.add(name="orientation", number=4, type=1, label=3)
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    kind = message_factory.GetMessageClass(pool.FindMessageTypeByName("lab.State"))
    with (folder / "proto.mcap").open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library="lab")
        described = descriptor_pb2.FileDescriptorSet(file=[file]).SerializeToString()
        schema = writer.register_schema("lab.State", "protobuf", described)
        channel = writer.register_channel("/state", "protobuf", schema)
        for i, seconds in enumerate(TIME):
            ns = BEGIN_NS + round(1e9 * seconds)
            said = kind(stamp_ns=ns, orientation=XYZW[i].tolist())
            for axis, name in enumerate("xyz"):
                setattr(said.position, name, float(POSITION[i, axis]))
                setattr(said.force, name, float(FORCE[i, axis]))
            writer.add_message(channel, ns, said.SerializeToString(), ns)
        writer.finish()
    return folder / "proto.mcap"


def transforms(folder: Path) -> Path:
    """world > base_link (static) > wrist > tool0 (static, 10 cm on); the wrench in tool0."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    kinds = store.types

    def header(ns: int, frame: str) -> object:
        stamp = kinds["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9)
        return kinds["std_msgs/msg/Header"](stamp=stamp, frame_id=frame)

    vector, quaternion = kinds["geometry_msgs/msg/Vector3"], kinds["geometry_msgs/msg/Quaternion"]

    def link(ns: int, parent: str, child: str, place: object, turn: object) -> object:
        inner = kinds["geometry_msgs/msg/Transform"](vector(*place), quaternion(*turn))
        return kinds["geometry_msgs/msg/TransformStamped"](header(ns, parent), child, inner)

    sent = kinds["tf2_msgs/msg/TFMessage"]
    with BagWriter(folder / "bag", version=9, storage_plugin=StoragePlugin.SQLITE3) as writer:
        topics = {
            topic: writer.add_connection(topic, kind, typestore=store)
            for topic, kind in (
                ("/tf_static", "tf2_msgs/msg/TFMessage"),
                ("/tf", "tf2_msgs/msg/TFMessage"),
                ("/ft", "geometry_msgs/msg/WrenchStamped"),
            )
        }

        def write(topic: str, ns: int, message: object) -> None:
            kind = message.__msgtype__  # type: ignore[attr-defined]
            writer.write(topics[topic], ns, store.serialize_cdr(message, kind))

        fixed = [link(BEGIN_NS, "world", "base_link", (1.0, 0.0, 0.5), (0.0, 0.0, 0.6, 0.8))]
        fixed.append(link(BEGIN_NS, "wrist", "tool0", (0.0, 0.0, 0.1), (0.0, 0.0, 0.0, 1.0)))
        write("/tf_static", BEGIN_NS, sent(fixed))
        for i, seconds in enumerate(TIME):
            ns = BEGIN_NS + round(1e9 * seconds)
            wrist = POSITION[i] - TURNS[i].apply([0, 0, 0.1])
            moving = link(ns, "base_link", "wrist", wrist.tolist(), XYZW[i].tolist())
            write("/tf", ns, sent([moving]))
            wrench = kinds["geometry_msgs/msg/Wrench"](vector(*FORCE[i].tolist()), vector(0, 0, 0))
            told = kinds["geometry_msgs/msg/WrenchStamped"](header(ns, "tool0"), wrench)
            write("/ft", ns, told)
    return folder / "bag"


FILES: tuple[Callable[[Path], Path], ...] = (
    *(archive, lying_in_matlab, matlab_73, parquet, records),
    *(json_messages, protobuf_messages, transforms),
)


@pytest.mark.parametrize("written", FILES, ids=lambda written: written.__name__)
def test_what_a_library_wrote_is_read_as_proposed(
    tmp_path: Path, written: Callable[[Path], Path]
) -> None:
    path = written(tmp_path)
    text = propose(path).recipe_text().replace("# order =", 'order = "xyzw"')
    text = text.replace('# frame = "base"', 'frame = "base"').replace("# sign = 1", "sign = 1")
    found = read(path, parse_recipe(text, "completed"))
    assert found.force_N is not None
    assert found.orientation_wxyz is not None
    np.testing.assert_allclose(found.time_s - found.time_s[0], TIME, atol=1e-6)
    np.testing.assert_allclose(found.position_m, POSITION, atol=1e-9)
    np.testing.assert_allclose(found.force_N, FORCE, atol=1e-6)
    turned = Rotation.from_quat(found.orientation_wxyz, scalar_first=True)
    np.testing.assert_allclose((turned.inv() * TURNS).magnitude(), 0, atol=1e-6)


def test_groups_that_are_numbered_are_a_recording_each(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "all.h5", "w") as file:
        for number in (2, 10):
            file[f"trial_{number}/pos"], file[f"trial_{number}/t"] = POSITION + number, TIME
    found = [one.relative.name for one in find_recordings([tmp_path])]
    assert found == ["all.h5#trial_2", "all.h5#trial_10"]
    recipe = 'time = {column = "t", unit = "s"}\nposition = {columns = "pos[*]", unit = "m"}\n'
    one = read(tmp_path / "all.h5#trial_10", parse_recipe(recipe, "r"))
    np.testing.assert_array_equal(one.position_m, POSITION + 10)


def test_a_transform_over_several_links_reaches_the_world_too(tmp_path: Path) -> None:
    recipe = (
        'time = {column = "/tf[world>tool0].stamp", unit = "s"}\n'
        'position = {columns = "/tf[world>tool0].transform.translation.?", unit = "m"}\n'
    )
    found = read(transforms(tmp_path), parse_recipe(recipe, "r"))
    expected = Rotation.from_quat([0, 0, 0.6, 0.8]).apply(POSITION) + np.array([1, 0, 0.5])
    np.testing.assert_allclose(found.position_m, expected, atol=1e-9)


def test_a_clock_that_tells_another_time_goes_with_no_other(tmp_path: Path) -> None:
    """A sensor that counts from when it was switched on; the log has times for both."""
    path = nobodys_mcap(tmp_path, sensor_ns=10**9)
    recipe = (
        'time = {column = "/robot/state.stamp", unit = "s"}\n'
        'position = {columns = "/robot/state.tcp.?", unit = "m"}\n'
        'force = {columns = "/sensor.force.?", unit = "N", time = "/sensor.stamp"}\n'
        'wrench = {frame = "base", sign = 1}\n'
    )
    with pytest.raises(RecipeError, match=r"different times .* take \.log_time for all"):
        read(path, parse_recipe(recipe, "r"))
    assert propose(path).clocks["force"] == "/sensor.log_time"
    logged = read(path, parse_recipe(recipe.replace(".stamp", ".log_time"), "r"))
    assert logged.start_s == pytest.approx(0.009, abs=1e-6)


def test_a_whole_dictionary_in_one_array_is_refused_with_the_way_out(tmp_path: Path) -> None:
    np.save(tmp_path / "fmb.npy", {"tcp_pose": POSITION}, allow_pickle=True)
    with pytest.raises(DemonstrationError, match=r"savez\(.run.npz., \*\*a\.item\(\)\)"):
        read(tmp_path / "fmb.npy")


@pytest.mark.parametrize(
    "write",
    [archive, matlab_73, parquet, records, json_messages, protobuf_messages],
    ids=lambda write: write.__name__,
)
def test_a_torn_file_is_refused_in_our_words_not_in_the_librarys(
    write: Callable[[Path], Path], tmp_path: Path
) -> None:
    path = write(tmp_path)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    with pytest.raises(DemonstrationError, match=r"\(its end is missing, as after [^:]*\); "):
        read(path)


def test_a_topic_whose_messages_nobody_defines_is_passed_over_and_told(tmp_path: Path) -> None:
    """Bags of ROS 2 before Iron hold no definitions; a laboratory's own messages are unknown."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    kind = "geometry_msgs/msg/PointStamped"
    with BagWriter(tmp_path / "old", version=8, storage_plugin=StoragePlugin.SQLITE3) as writer:
        topics = [writer.add_connection(t, kind, typestore=store) for t in ("/place", "/own")]
        for row in range(ROWS):
            stamp = store.types["builtin_interfaces/msg/Time"](sec=row, nanosec=0)
            header = store.types["std_msgs/msg/Header"](stamp=stamp, frame_id="base")
            point = store.types["geometry_msgs/msg/Point"](*POSITION[row].tolist())
            raw = store.serialize_cdr(store.types[kind](header, point), kind)
            for topic in topics:
                writer.write(topic, row * 10**9, raw)
    with closing(sqlite3.connect(tmp_path / "old" / "old.db3")) as database:
        database.execute("UPDATE topics SET type = 'lab_msgs/msg/Own' WHERE name = '/own'")
        database.execute("DELETE FROM message_definitions")
        database.commit()
    described = tmp_path / "old" / "metadata.yaml"
    before, own, after = described.read_text().rpartition("/own")
    described.write_text(before + own + after.replace(kind, "lab_msgs/msg/Own"))
    table = table_of_bag(tmp_path / "old", None, 10**9)
    assert "/place.point.x" in table.names
    assert any("/own (lab_msgs/msg/Own)" in notice for notice in table.notices)


def test_a_word_for_each_step_of_an_archive_is_read_as_events(tmp_path: Path) -> None:
    """FMB's `primitive`, saved from its pickles; a button beside it."""
    words = np.where(TIME < 1, "grasp", "insert")
    np.savez(tmp_path / "fmb.npz", t=TIME, pose=POSITION, primitive=words, button=TIME > 1)
    recipe = (
        'time = {column = "t", unit = "s"}\nposition = {columns = "pose[*]", unit = "m"}\n'
        'channels = {button = "button"}\nevents = {column = "primitive"}\n'
    )
    found = read(tmp_path / "fmb.npz", parse_recipe(recipe, "r"))
    assert [(event.time_s, event.text) for event in found.events] == [(0, "grasp"), (1, "insert")]
    assert found.channels["button"].max() == 1
    assert [one.label for one in given_labels(tmp_path / "fmb.npz", found).segments] == [
        "grasp",
        "insert",
    ]


def test_bytes_of_an_mcap_that_changed_since_it_was_written_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "run.mcap"
    with path.open("wb") as stream:
        writer = Writer(stream, compression=CompressionType.NONE)
        writer.start(profile="", library="cell")
        channel = writer.register_channel("/tool", "json", 0)
        for row in range(ROWS):
            data = b'{"x": 0.25, "y": 0.5, "z": 1.0}'
            writer.add_message(channel, BEGIN_NS + row * 10**7, data, 0)
        writer.finish()
    path.write_bytes(path.read_bytes().replace(b"0.25", b"0.75", 1))
    with pytest.raises(DemonstrationError, match="bytes were changed or lost"):
        read(path)
