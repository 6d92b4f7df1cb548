"""The native archive: what is saved comes back, and what it refuses."""

import io
import json
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from demonstration_strategies import demonstrations
from hypothesis import HealthCheck, given, settings

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError
from keyphase.readers import read, save_npz

CHANNELS = ("time_s", "position_m", "force_N", "torque_Nm", "joints_rad")

Archive = Callable[..., Path]


@pytest.fixture
def archive(tmp_path: Path) -> Archive:
    """Writes an archive of a sound recording in which some members are replaced or left out."""

    def write(**members: Any) -> Path:
        sound = {"time_s": np.arange(5) / 10, "position_m": np.zeros((5, 3))}
        kept = {name: value for name, value in (sound | members).items() if value is not None}
        np.savez(tmp_path / "recording.npz", **kept)
        return tmp_path / "recording.npz"

    return write


@pytest.mark.slow
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(demonstration=demonstrations())
def test_what_is_saved_is_read_back(tmp_path: Path, demonstration: Demonstration) -> None:
    save_npz(demonstration, tmp_path / "recording.npz")
    back = read(tmp_path / "recording.npz")
    for channel in CHANNELS:
        np.testing.assert_array_equal(getattr(back, channel), getattr(demonstration, channel))
    if demonstration.orientation_wxyz is not None:
        np.testing.assert_allclose(
            back.orientation_wxyz, demonstration.orientation_wxyz, rtol=0, atol=1e-15
        )
    assert (back.orientation_wxyz is None) == (demonstration.orientation_wxyz is None)
    assert back.metadata == demonstration.metadata
    assert (back.events, back.wrench_estimated) == (
        demonstration.events,
        demonstration.wrench_estimated,
    )
    assert back.channels.keys() == demonstration.channels.keys()
    for name, values in demonstration.channels.items():
        np.testing.assert_array_equal(back.channels[name], values)


@pytest.mark.slow
@settings(max_examples=20, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(demonstration=demonstrations())
def test_the_same_demonstration_gives_the_same_bytes(
    tmp_path: Path, demonstration: Demonstration
) -> None:
    save_npz(demonstration, tmp_path / "one.npz")
    save_npz(demonstration, tmp_path / "other.npz")
    assert (tmp_path / "one.npz").read_bytes() == (tmp_path / "other.npz").read_bytes()
    with zipfile.ZipFile(tmp_path / "one.npz") as one:
        assert {info.date_time for info in one.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_the_order_of_metadata_does_not_change_the_bytes(tmp_path: Path) -> None:
    for name, metadata in (("one", {"a": 1, "b": 2}), ("other", {"b": 2, "a": 1})):
        save_npz(Demonstration(name, [0, 1], np.zeros((2, 3)), metadata=metadata), tmp_path / name)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "other").read_bytes()


def test_numpy_opens_what_is_saved(tmp_path: Path, archive: Archive) -> None:
    save_npz(read(archive()), tmp_path / "saved.npz")
    with np.load(tmp_path / "saved.npz", allow_pickle=False) as arrays:
        assert set(arrays) == {"time_s", "position_m"}


def test_saving_leaves_nothing_else_behind(tmp_path: Path, archive: Archive) -> None:
    save_npz(read(archive()), tmp_path / "saved.npz")
    assert {path.name for path in tmp_path.iterdir()} == {"recording.npz", "saved.npz"}


def test_saving_into_a_missing_folder_is_refused(tmp_path: Path, archive: Archive) -> None:
    with pytest.raises(DemonstrationError, match=r"nowhere.saved\.npz: .* cannot be written"):
        save_npz(read(archive()), tmp_path / "nowhere" / "saved.npz")


def test_a_demonstration_knows_its_file_and_its_hash(archive: Archive) -> None:
    import hashlib

    path = archive()
    demonstration = read(path)
    assert demonstration.name == "recording"
    assert demonstration.source is not None
    assert demonstration.source.path == path
    assert demonstration.source.sha256 == hashlib.sha256(path.read_bytes()).hexdigest()


@pytest.mark.parametrize("dtype", ["<f4", ">f8", "<i2", "<u4", "<f2"])
def test_other_real_numbers_are_converted(archive: Archive, dtype: str) -> None:
    position = np.arange(15).reshape(5, 3).astype(dtype)
    assert read(archive(position_m=position)).position_m.dtype == np.float64


def test_columns_first_memory_order_is_read_right(archive: Archive) -> None:
    position = np.asfortranarray(np.arange(15.0).reshape(5, 3))
    np.testing.assert_array_equal(read(archive(position_m=position)).position_m, position)


def test_a_compressed_archive_is_read(archive: Archive, tmp_path: Path) -> None:
    with np.load(archive()) as arrays:
        np.savez_compressed(tmp_path / "compressed.npz", **arrays)
    assert len(read(tmp_path / "compressed.npz")) == 5


def test_an_archive_is_known_without_its_suffix(archive: Archive, tmp_path: Path) -> None:
    renamed = archive().rename(tmp_path / "recording")
    assert len(read(renamed)) == 5


def test_metadata_is_read(archive: Archive) -> None:
    path = archive(metadata_json=np.array('{"robot": "YuMi", "arm": "right"}'))
    assert read(path).metadata == {"robot": "YuMi", "arm": "right"}


def test_a_member_that_is_no_channel_is_left_out_and_said(archive: Archive) -> None:
    (notice,) = read(archive(forces_N=np.zeros((5, 3)))).notices
    assert "'forces_N.npy'" in notice
    assert "did you mean force_N?" in notice


def test_a_member_outside_the_archive_is_never_written(archive: Archive, tmp_path: Path) -> None:
    path = archive()
    with zipfile.ZipFile(path, "a") as opened:
        opened.writestr("../escaped.npy", b"evil")
    assert "'../escaped.npy'" in read(path).notices[0]
    assert not (tmp_path.parent / "escaped.npy").exists()


bent = np.zeros((5, 3))
bent[3, 1] = np.nan

REFUSED = {
    "no time": ({"time_s": None}, "member time_s is missing"),
    "no position": ({"position_m": None}, "member position_m is missing"),
    "other length": ({"force_N": np.zeros((4, 3))}, r"force_N must have shape \(5, 3\)"),
    "other width": ({"force_N": np.zeros((5, 6))}, r"force_N must have shape \(5, 3\)"),
    "no axis": ({"position_m": np.zeros(())}, r"position_m must have shape"),
    "empty": ({"time_s": np.zeros(0)}, "at least two samples"),
    "NaN": ({"force_N": bent}, "force_N must be finite, but row 3, column 1 holds nan"),
    "infinity": ({"time_s": [0, 1, np.inf, 2, 3]}, "time_s must be finite, but row 2 holds inf"),
    "time stands": ({"time_s": [0, 1, 1, 2, 3]}, "row 2 has 1 s after 1 s"),
    "no unit": ({"orientation_wxyz": np.ones((5, 4))}, "row 0 has norm 2"),
    "pickled": ({"force_N": np.array([{}] * 5)}, "force_N holds pickled Python objects"),
    "complex": ({"force_N": np.zeros((5, 3), complex)}, "real numbers, but its type is complex"),
    "text": ({"force_N": np.array(["1"] * 5)}, "real numbers, but its type is <U1"),
    "truths": ({"force_N": np.zeros((5, 3), bool)}, "real numbers, but its type is bool"),
    "records": ({"force_N": np.zeros(5, "f8,f8")}, "real numbers, but its type is"),
    "no JSON": ({"metadata_json": np.array("{")}, "metadata_json must be one string of JSON"),
    "NaN in JSON": ({"metadata_json": np.array('{"a": NaN}')}, "NaN is not JSON"),
    "deep JSON": ({"metadata_json": np.array("[" * 100_000)}, "must be one string of JSON"),
    "JSON list": ({"metadata_json": np.array("[]")}, "must hold a JSON object, but holds a list"),
    "two JSONs": ({"metadata_json": np.array(["{}", "{}"])}, "must be one string of JSON"),
    "JSON bytes": ({"metadata_json": np.array(b"{}")}, "must hold text, but its type is"),
}


@pytest.mark.parametrize(("members", "reason"), REFUSED.values(), ids=REFUSED.keys())
def test_it_is_refused(archive: Archive, members: dict[str, Any], reason: str) -> None:
    with pytest.raises(DemonstrationError, match=rf"recording\.npz: (?!recording).*{reason}"):
        read(archive(**members))


def test_pickled_members_are_never_loaded(archive: Archive, tmp_path: Path) -> None:
    class Bomb:
        def __reduce__(self) -> tuple[Any, ...]:
            return Path.touch, (tmp_path / "loaded",)

    with pytest.raises(DemonstrationError, match="pickled"):
        read(archive(force_N=np.array([Bomb()] * 5, dtype=object)))
    assert not (tmp_path / "loaded").exists()


def test_an_archive_that_unpacks_to_more_than_the_limit_is_refused(
    archive: Archive, tmp_path: Path
) -> None:
    with np.load(archive(joints_rad=np.zeros((5, 900), np.int8))) as arrays:
        np.savez_compressed(tmp_path / "bomb.npz", **arrays)
    assert (tmp_path / "bomb.npz").stat().st_size < 100_000
    with pytest.raises(DemonstrationError, match=r"unpacks to \d+ bytes, more than the limit"):
        read(tmp_path / "bomb.npz", limit_bytes=30_000)


def test_a_member_that_unpacks_to_more_than_it_declares_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "liar.npz"
    honest = npy(np.zeros((5, 3)))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as opened:
        opened.writestr("time_s.npy", npy(np.arange(5.0)))
        opened.writestr("position_m.npy", honest + bytes(10_000_000))
    data = path.read_bytes()
    whole = (len(honest) + 10_000_000).to_bytes(4, "little")
    path.write_bytes(data.replace(whole, len(honest).to_bytes(4, "little")))
    with pytest.raises(DemonstrationError, match=r"liar\.npz: .*damaged"):
        read(path)


def test_an_array_shorter_than_its_shape_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "short.npz"
    with zipfile.ZipFile(path, "w") as opened:
        opened.writestr("time_s.npy", npy(np.arange(5.0))[:-8])
        opened.writestr("position_m.npy", npy(np.zeros((5, 3))))
    with pytest.raises(DemonstrationError, match=r"declares shape \(5,\) and 40 bytes, but 32"):
        read(path)


def test_a_truncated_archive_is_refused(archive: Archive) -> None:
    path = archive()
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(DemonstrationError, match=r"recording\.npz: .*damaged"):
        read(path)


def test_what_is_no_archive_is_refused(tmp_path: Path) -> None:
    (tmp_path / "no.npz").write_bytes(b"not an archive")
    with pytest.raises(DemonstrationError, match=r"no\.npz: expected a whole NPZ archive"):
        read(tmp_path / "no.npz")


def test_a_doubled_member_is_refused(archive: Archive) -> None:
    path = archive()
    with zipfile.ZipFile(path, "a") as opened, pytest.warns(UserWarning, match="Duplicate"):
        opened.writestr("time_s.npy", npy(np.arange(5.0)))
    with pytest.raises(DemonstrationError, match="holds several"):
        read(path)


def test_metadata_that_is_no_json_is_not_saved(tmp_path: Path) -> None:
    demonstration = Demonstration("odd", [0, 1], np.zeros((2, 3)), metadata={"a": object()})
    with pytest.raises(DemonstrationError, match="odd: metadata must be JSON values"):
        save_npz(demonstration, tmp_path / "odd.npz")


def npy(values: np.ndarray) -> bytes:
    stream = io.BytesIO()
    np.save(stream, values)
    return stream.getvalue()


def test_metadata_is_written_as_json(tmp_path: Path) -> None:
    demonstration = Demonstration("named", [0, 1], np.zeros((2, 3)), metadata={"b": 1, "a": "ä"})
    save_npz(demonstration, tmp_path / "named.npz")
    with np.load(tmp_path / "named.npz") as arrays:
        assert json.loads(arrays["metadata_json"].item()) == {"a": "ä", "b": 1}
