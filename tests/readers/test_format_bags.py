"""ROS 1 bags, ROS 2 bags and MCAP, written with rosbags and compared value by value."""

from pathlib import Path

import numpy as np
import pytest
from backports import zstd
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_typestore

from keyphase.errors import DemonstrationError
from keyphase.readers import find_recordings, parse_recipe, read

pytestmark = pytest.mark.slow

RECIPE = """
time = {column = "/pose.stamp", unit = "s"}
position = {columns = "/pose.pose.position.?", unit = "m"}
orientation = {kind = "quaternion", order = "xyzw", columns = "/pose.pose.orientation.?"}
force = {columns = "/wrench.wrench.force.?", unit = "N", time = "/wrench.stamp"}
wrench = {frame = "base", sign = 1}
"""
BEGIN = 1_700_000_000


def messages(store):
    """A pose at 50 Hz along x with 0.1 m/s, a constant wrench at 200 Hz."""
    types = store.types
    ros1 = (
        "std_msgs/msg/Header" in types
        and "seq" in types["std_msgs/msg/Header"].__dataclass_fields__
    )
    for i in range(800):
        stamp_s = i / 200
        stamp = types["builtin_interfaces/msg/Time"](BEGIN + i // 200, int(i % 200 * 5e6))
        first = {"seq": i} if ros1 else {}
        header = types["std_msgs/msg/Header"](**first, stamp=stamp, frame_id="base")
        vector, point = types["geometry_msgs/msg/Vector3"], types["geometry_msgs/msg/Point"]
        force = vector(x=1.0, y=2.0, z=3.0 + stamp_s)
        wrench = types["geometry_msgs/msg/Wrench"](force=force, torque=vector(x=0.0, y=0.0, z=0.0))
        yield "/wrench", types["geometry_msgs/msg/WrenchStamped"](header=header, wrench=wrench), i
        if i % 4 == 0:
            turn = types["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=0.6, w=0.8)
            pose = types["geometry_msgs/msg/Pose"](
                position=point(x=0.1 * stamp_s, y=0.2, z=0.3), orientation=turn
            )
            yield "/pose", types["geometry_msgs/msg/PoseStamped"](header=header, pose=pose), i


def log_ns(i: int) -> int:
    """Logged 3 ms after it was stamped."""
    return BEGIN * 10**9 + i * 5_000_000 + 3_000_000


def ros1(path: Path) -> Path:
    store = get_typestore(Stores.ROS1_NOETIC)
    with Writer1(path / "run.bag") as writer:
        topics = {}
        for topic, message, i in messages(store):
            kind = message.__msgtype__
            if topic not in topics:
                topics[topic] = writer.add_connection(topic, kind, typestore=store)
            writer.write(topics[topic], log_ns(i), store.serialize_ros1(message, kind))
    return path / "run.bag"


def ros2(path: Path, plugin: StoragePlugin, packed: CompressionMode | None = None) -> Path:
    store = get_typestore(Stores.ROS2_HUMBLE)
    opened = Writer2(path / "run", version=9, storage_plugin=plugin)
    if packed is not None:
        opened.set_compression(packed, CompressionFormat.ZSTD)
    with opened as writer:
        topics = {}
        for topic, message, i in messages(store):
            kind = message.__msgtype__
            if topic not in topics:
                topics[topic] = writer.add_connection(topic, kind, typestore=store)
            writer.write(topics[topic], log_ns(i), bytes(store.serialize_cdr(message, kind)))
    return path / "run"


@pytest.fixture(params=["ros1", "sqlite3", "mcap", "packed as a whole"])
def bag(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    if request.param == "ros1":
        return ros1(tmp_path)
    if request.param == "packed as a whole":
        return ros2(tmp_path, StoragePlugin.SQLITE3, CompressionMode.FILE)
    return ros2(tmp_path, StoragePlugin[request.param.upper()])


def test_a_bag_is_found_as_one_recording(bag: Path) -> None:
    assert [found.path for found in find_recordings([bag.parent], "any.toml")] == [bag]


def test_a_bag_is_read_value_by_value(bag: Path) -> None:
    demonstration = read(bag, parse_recipe(RECIPE, "r"))
    np.testing.assert_allclose(demonstration.rate_hz, 200, rtol=1e-6)
    np.testing.assert_allclose(demonstration.position_m[:, 0], 0.1 * demonstration.time_s)
    assert demonstration.force_N is not None
    assert demonstration.orientation_wxyz is not None
    np.testing.assert_allclose(demonstration.force_N[:, 2], 3.0 + demonstration.time_s)
    np.testing.assert_allclose(demonstration.orientation_wxyz[0], [0.8, 0, 0, 0.6])


def test_the_time_of_logging_can_be_taken_instead(bag: Path) -> None:
    recipe = RECIPE.replace(".stamp", ".log_time")
    assert read(bag, parse_recipe(recipe, "r")).start_s == pytest.approx(0.003, abs=1e-6)


def test_stamps_and_times_of_the_log_have_one_zero(bag: Path) -> None:
    """The log is 3 ms late: a force by the log and a pose by its stamp keep that apart."""
    mixed = read(bag, parse_recipe(RECIPE.replace("/wrench.stamp", "/wrench.log_time"), "r"))
    assert mixed.force_N is not None
    np.testing.assert_allclose(mixed.position_m[:, 0], 0.1 * mixed.time_s, atol=1e-9)
    np.testing.assert_allclose(mixed.force_N[:, 2], 3.0 + mixed.time_s - 0.003, atol=1e-9)


def test_a_cut_bag_is_refused(tmp_path: Path) -> None:
    path = ros1(tmp_path)
    path.write_bytes(path.read_bytes()[:5000])
    with pytest.raises(DemonstrationError, match="expected a whole bag"):
        read(path, parse_recipe(RECIPE, "r"))


@pytest.mark.parametrize("called", ["run.db3.zstd", "run.db3"])
@pytest.mark.parametrize("before", [b"", b"\x50\x2a\x4d\x18\0\0\0\0"], ids=["", "skipped frame"])
def test_a_packed_bag_that_would_fill_the_disk_is_refused_before_it_is_unpacked(
    tmp_path: Path, called: str, before: bytes
) -> None:
    """Whatever its file is called: what describes the bag says that it is packed."""
    path = ros2(tmp_path, StoragePlugin.SQLITE3, CompressionMode.FILE)
    (path / "run.db3.zstd").rename(path / called)
    (path / called).write_bytes(before + zstd.compress(bytes(80 << 20)))
    told = path / "metadata.yaml"
    told.write_text(told.read_text().replace("run.db3.zstd", called))
    with pytest.raises(DemonstrationError, match="unpacks to more than 32 times its size"):
        read(path, parse_recipe(RECIPE, "r"))
