"""Archives made to take memory or time, or to end the program that reads them."""

import bz2
import io
import lzma
import os
import tracemalloc
import zipfile
import zlib

import numpy as np
import pytest

from keyphase.errors import DemonstrationError
from keyphase.readers import read

ROWS = 40


def npy(array):
    """The bytes of an array file."""
    data = io.BytesIO()
    np.save(data, array)
    return data.getvalue()


def sound():
    """The members of a small recording."""
    return {
        "time_s": npy(np.arange(ROWS) / 100),
        "position_m": npy(np.arange(3.0 * ROWS).reshape(ROWS, 3) / 1000),
    }


def write(path, members, packing=zipfile.ZIP_STORED):
    with zipfile.ZipFile(path, "w", packing) as archive:
        for name, data in members.items():
            archive.writestr(f"{name}.npy", data)
    return path


def packed(path, name, data, method, declared):
    """An archive one member of which is `data` as it stands, said to unpack to `declared`."""
    others = {other: content for other, content in sound().items() if other != name}
    write(path, others)
    with zipfile.ZipFile(path, "a") as archive:
        archive.writestr(f"{name}.npy", b"x" * len(data))
    raw = bytearray(path.read_bytes())
    with zipfile.ZipFile(path) as archive:
        info = archive.getinfo(f"{name}.npy")
        start = info.header_offset + 30 + len(info.filename)
        raw[start : start + len(data)] = data
        central = raw.rindex(f"{name}.npy".encode()) - 46
    for at, method_at, size_at in ((info.header_offset, 8, 22), (central, 10, 24)):
        raw[at + method_at : at + method_at + 2] = method.to_bytes(2, "little")
        raw[at + size_at : at + size_at + 4] = declared.to_bytes(4, "little")
    path.write_bytes(raw)
    return path


def refused(path, reason):
    """The refusal, made with little memory."""
    tracemalloc.start()
    try:
        with pytest.raises(DemonstrationError, match=reason) as caught:
            read(path)
        assert tracemalloc.get_traced_memory()[1] < 6 * 1024**2
    finally:
        tracemalloc.stop()
    assert path.name in str(caught.value)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("compress", "method"),
    [(lambda data: bz2.compress(data), 12), (lambda data: lzma.compress(data), 14)],
)
def test_only_stored_and_deflated_members_are_unpacked(tmp_path, compress, method):
    bomb = compress(bytes(16 * 1024**2))
    refused(packed(tmp_path / "bomb.npz", "position_m", bomb, method, 1088), "stored or deflated")


def test_a_deflated_member_is_not_unpacked_past_what_it_declares(tmp_path):
    squeeze = zlib.compressobj(9, zlib.DEFLATED, -15)
    head = sound()["position_m"]
    bomb = squeeze.compress(head + bytes(16 * 1024**2)) + squeeze.flush()
    path = packed(tmp_path / "bomb.npz", "position_m", bomb, 8, len(head))
    refused(path, r"damaged|more than it declares")


def test_shapes_are_compared_with_time_before_anything_is_unpacked(tmp_path):
    members = sound() | {"force_N": npy(np.zeros((500_000, 3)))}
    path = write(tmp_path / "wide.npz", members, zipfile.ZIP_DEFLATED)
    refused(path, r"force_N must have shape \(40, 3\)")


def test_the_limit_counts_numbers_as_they_will_lie_in_memory(tmp_path):
    path = write(
        tmp_path / "small.npz", sound() | {"joints_rad": npy(np.zeros((ROWS, 900), np.int8))}
    )
    with pytest.raises(DemonstrationError, match="more than the limit"):
        read(path, limit_bytes=100_000)


@pytest.mark.parametrize(
    "time",
    [np.float64(1.0), np.zeros(0), np.zeros((ROWS, 2)), np.zeros((1, ROWS)), np.zeros((1,) * 30)],
    ids=lambda time: str(np.shape(time)),
)
def test_time_of_another_shape_is_refused(tmp_path, time):
    path = write(tmp_path / "time.npz", sound() | {"time_s": npy(time)})
    refused(path, "time_s must be one column of at least two samples")


def test_time_in_one_column_of_a_matrix_is_taken(tmp_path):
    column = (np.arange(ROWS) / 100).reshape(ROWS, 1)
    path = write(tmp_path / "column.npz", sound() | {"time_s": npy(column)})
    assert read(path).time_s.shape == (ROWS,)


@pytest.mark.parametrize("last", [1e11, 1e300, 1e308])
def test_times_no_clock_has_are_refused(tmp_path, last):
    time = np.arange(ROWS) / 100
    time[-1] = last
    refused(write(tmp_path / "far.npz", sound() | {"time_s": npy(time)}), "must lie within 1e")


def test_steps_no_recorder_has_are_refused(tmp_path):
    time = np.arange(ROWS) * 5e-324
    refused(write(tmp_path / "fast.npz", sound() | {"time_s": npy(time)}), "steps of at least")


@pytest.mark.parametrize("junk", [b"", b"\x93NUMPY\x01\x00\xff\xff{", b"\x93NUMPY\x09\x00v\x00"])
def test_a_member_that_is_no_array_is_refused(tmp_path, junk):
    refused(write(tmp_path / "junk.npz", sound() | {"position_m": junk}), "damaged|version|follow")


def test_a_pipe_is_refused_without_waiting_for_it(tmp_path):
    os.mkfifo(tmp_path / "pipe.csv")
    with pytest.raises(DemonstrationError, match="no regular file"):
        read(tmp_path / "pipe.csv")
