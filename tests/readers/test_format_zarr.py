"""Zarr replay buffers as UMI, RDP and ManipForce write them, made with zarr."""

import gzip
import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numcodecs
import numpy as np
import pytest
import zarr
from zarr.codecs import BloscCodec, BytesCodec, ShardingCodec, ZstdCodec

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import find_recordings, parse_recipe, read


def store(path: Path, data: dict[str, np.ndarray], meta: dict[str, list[int]]) -> Path:
    root = zarr.open_group(path, mode="w", zarr_format=2)
    for group, arrays in (("data", data), ("meta", meta)):
        inside = root.create_group(group)
        for name, values in arrays.items():
            array = np.asarray(values)
            inside.create_array(name, shape=array.shape, dtype=array.dtype)[...] = array
    return path


@pytest.fixture
def umi(tmp_path: Path) -> Path:
    place = np.arange(300).reshape(100, 3) / 1000.0
    data = {
        "robot0_eef_pos": place,
        "robot0_eef_rot_axis_angle": np.zeros((100, 3)),
        "robot0_gripper_width": np.linspace(0, 0.08, 100)[:, None],
    }
    return store(tmp_path / "umi.zarr", data, {"episode_ends": [40, 100]})


@pytest.mark.slow
def test_a_replay_buffer_is_a_list_of_episodes(umi: Path) -> None:
    names = [found.path.name for found in find_recordings([umi.parent])]
    assert names == ["umi.zarr#episode_0", "umi.zarr#episode_1"]


def test_an_episode_is_read_by_its_ends_through_a_preset_and_a_rate(umi: Path) -> None:
    recipe = parse_recipe(
        'preset = "umi"\ntime.rate_hz = 60\n'
        'gripper = {columns = "robot0_gripper_width[*]", unit = "m"}',
        "umi.toml",
    )
    demonstration = read(f"{umi}#episode_1", recipe)
    place = np.arange(300).reshape(100, 3)[40:] / 1000.0
    np.testing.assert_array_equal(demonstration.position_m, place)
    np.testing.assert_allclose(demonstration.rate_hz, 60)
    assert demonstration.gripper is not None
    np.testing.assert_array_equal(demonstration.gripper, np.linspace(0, 0.08, 100)[40:])


def test_the_rate_nobody_states_is_asked_for(umi: Path) -> None:
    with pytest.raises(RecipeError, match=r"preset 'umi', which leaves .*\[time\] is missing"):
        read(f"{umi}#episode_0")


def test_rot6d_and_a_wrench_in_the_tools_frame_as_rdp_has_them(tmp_path: Path) -> None:
    turned = np.tile([0.0, 1, 0, -1, 0, 0], (50, 1))
    pose = np.column_stack([np.arange(50) / 100, np.zeros((50, 2)), turned])
    data = {
        "left_robot_tcp_pose": pose,
        "left_robot_tcp_wrench": np.tile([5.0, 0, 0, 0, 0, 0], (50, 1)),
        "timestamp": 1.7e9 + np.arange(50) / 30,
    }
    path = store(tmp_path / "rdp.zarr", data, {"episode_ends": [50]})
    recipe = parse_recipe('preset = "rdp"\nwrench.sign = 1', "rdp.toml")
    demonstration = read(f"{path}#episode_0", recipe)
    assert demonstration.force_N is not None
    np.testing.assert_allclose(demonstration.force_N[0], [0.0, 5.0, 0.0], atol=1e-12)


def test_each_stream_has_ends_of_its_own(tmp_path: Path) -> None:
    data = {
        "state": np.arange(60.0).reshape(20, 3) / 100,
        "img_timestamps": np.tile(np.arange(10) / 10, 2),
        "ft_data": np.arange(200.0).reshape(200, 1) * [1, 0, 0],
        "ft_timestamps": np.tile(np.arange(100) / 100, 2),
    }
    ends = {"episode_ends": [10, 20], "episode_ft_ends": [100, 200]}
    path = store(tmp_path / "mf.zarr", data, ends)
    recipe = parse_recipe(
        'time = {column = "img_timestamps", unit = "s"}\n'
        'position = {columns = "state[*]", unit = "m"}\n'
        'force = {columns = "ft_data[*]", unit = "N", time = "ft_timestamps"}\n'
        'wrench = {frame = "base", sign = 1}',
        "mf.toml",
    )
    demonstration = read(f"{path}#episode_1", recipe)
    assert demonstration.force_N is not None
    assert demonstration.force_N[0, 0] == 100.0
    np.testing.assert_allclose(demonstration.position_m[0], [0.30, 0.31, 0.32])


@pytest.mark.parametrize("ends", [[40, 30], [1000]])
def test_ends_that_do_not_fit_are_refused(tmp_path: Path, ends: list[int]) -> None:
    path = store(tmp_path / "bad.zarr", {"state": np.zeros((40, 3))}, {"episode_ends": ends})
    with pytest.raises(DemonstrationError, match="expected a whole Zarr store"):
        read(
            f"{path}#episode_0",
            parse_recipe("time.rate_hz = 9\nposition = {columns='state[*]', unit='m'}", "r"),
        )


RATED = "time.rate_hz = 60\nposition = {columns='robot0_eef_pos[*]', unit='m'}"
A_BOMB = bytes(80 << 20)


def lying_blosc(chunk: bytes) -> bytes:
    """It says it is longer than it is; the codec would read on past its end."""
    return chunk[:12] + (1 << 29).to_bytes(4, "little") + chunk[16:]


@pytest.mark.parametrize(
    ("codec", "changed"),
    [
        (numcodecs.Blosc("lz4"), lying_blosc),
        (numcodecs.Blosc("lz4"), lambda chunk: chunk[:4] + b"\xff\xff\xff\x7f" + chunk[8:]),
        (numcodecs.Blosc("lz4"), lambda chunk: chunk[:9]),
        (numcodecs.GZip(), lambda _chunk: gzip.compress(A_BOMB, 1)),
        (numcodecs.Zstd(), lambda _chunk: numcodecs.Zstd(1).encode(A_BOMB)),
        (numcodecs.LZ4(), lambda chunk: b"\xff\xff\xff\x7f" + chunk[4:]),
    ],
    ids=["blosc past its end", "blosc of 2 GB", "blosc cut", "gzip", "zstd", "lz4 of 2 GB"],
)
def test_a_chunk_that_is_not_what_it_says_is_refused_before_it_is_unpacked(
    tmp_path: Path, codec: Any, changed: Callable[[bytes], bytes]
) -> None:
    path = tmp_path / "run.zarr"
    root = zarr.open_group(path, mode="w", zarr_format=2)
    place = np.arange(300.0).reshape(100, 3)
    array = root.create_group("data").create_array(
        "robot0_eef_pos", shape=place.shape, dtype=place.dtype, compressors=codec
    )
    array[...] = place
    recipe = parse_recipe(RATED, "r.toml")
    np.testing.assert_array_equal(read(path, recipe).position_m, place)
    chunk = path / "data/robot0_eef_pos/0.0"
    chunk.write_bytes(changed(chunk.read_bytes()))
    with pytest.raises(DemonstrationError, match=r"0\.0 (is not as long|unpacks to more)"):
        read(path, recipe)


def test_an_entry_of_a_zip_file_that_unpacks_to_more_than_its_array_is_refused(
    tmp_path: Path,
) -> None:
    place, packed = np.arange(300.0).reshape(100, 3), tmp_path / "run.zarr.zip"
    path = store(tmp_path / "run.zarr", {"robot0_eef_pos": place}, {})
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as file:
        for part in sorted(path.rglob("*")):
            large = part.name == "0.0"
            if part.is_file():
                file.writestr(str(part.relative_to(path)), A_BOMB if large else part.read_bytes())
    with pytest.raises(DemonstrationError, match=r"robot0_eef_pos/0\.0 unpacks to more than"):
        read(packed, parse_recipe(RATED, "r.toml"))


def in_shards(path: Path, place: np.ndarray, **sharding: Any) -> Path:
    """A store of version 3 whose one chunk file is a shard of ten, and what is in it."""
    root = zarr.open_group(path, mode="w", zarr_format=3)
    codec = ShardingCodec(chunk_shape=(10, 3), **sharding)
    array = root.create_group("data").create_array(
        "robot0_eef_pos", shape=place.shape, chunks=place.shape, dtype=place.dtype,
        serializer=codec, compressors=None,
    )  # fmt: skip
    array[...] = place
    ends = root.create_group("meta").create_array("episode_ends", shape=(2,), dtype="i8")
    ends[...] = [40, 100]
    return path / "data/robot0_eef_pos/c/0/0"


PACKED = [BytesCodec(), BloscCodec()]


@pytest.mark.parametrize("part", ["#episode_0", ""], ids=["some", "all"])
@pytest.mark.parametrize("where", ["start", "end"])
def test_a_chunk_within_a_shard_that_lies_of_its_size_is_refused(
    tmp_path: Path, where: str, part: str
) -> None:
    path, place = tmp_path / "run.zarr", np.random.default_rng(0).normal(size=(100, 3))
    shard = in_shards(path, place, codecs=PACKED, index_location=where)
    if not part:
        shutil.rmtree(path / "meta")
    recipe = parse_recipe(RATED, "r.toml")
    whole = shard.read_bytes()
    np.testing.assert_array_equal(
        read(f"{path}{part}", recipe).position_m, place[: 40 if part else 100]
    )
    first = 0 if where == "end" else 164
    shard.write_bytes(whole[:first] + lying_blosc(whole[first:]))
    with pytest.raises(DemonstrationError, match="0/0 is not as long as it says"):
        read(f"{path}{part}", recipe)


@pytest.mark.parametrize("part", ["#episode_0", ""], ids=["some", "all"])
def test_chunks_of_a_shard_that_lie_outside_it_or_over_its_index_are_refused(
    tmp_path: Path, part: str
) -> None:
    path, place = tmp_path / "run.zarr", np.zeros((100, 3))
    index = {"index_codecs": [BytesCodec()], "index_location": "start"}
    shard = in_shards(path, place + 1.0, codecs=PACKED, **index)
    if not part:
        shutil.rmtree(path / "meta")
    whole = shard.read_bytes()
    for offset, said in ((0, "over the index"), (len(whole) - 4, "is not as long as")):
        shard.write_bytes(offset.to_bytes(8, "little") + whole[8:])
        with pytest.raises(DemonstrationError, match=said):
            read(f"{path}{part}", parse_recipe(RATED, "r.toml"))


@pytest.mark.parametrize(
    ("codecs", "said"),
    [
        ([BytesCodec(), ZstdCodec(), BloscCodec()], "packed more than once"),
        ([ShardingCodec(chunk_shape=(5, 3), codecs=PACKED)], "or hold shards"),
    ],
)
def test_what_cannot_be_looked_at_in_a_shard_is_refused(
    tmp_path: Path, codecs: list[Any], said: str
) -> None:
    in_shards(tmp_path / "run.zarr", np.ones((100, 3)), codecs=codecs)
    with pytest.raises(DemonstrationError, match=said):
        read(f"{tmp_path}/run.zarr#episode_0", parse_recipe(RATED, "r.toml"))
