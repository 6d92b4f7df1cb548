"""A damaged file of some kilobytes takes no more memory than it is worth, however it is misread."""

import resource
import sys
from pathlib import Path

import h5py
import mcap.writer
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from keyphase.errors import DemonstrationError
from keyphase.files.bounded_memory import memory_bounded
from keyphase.readers import read
from keyphase.readers.formats.hdf5 import opened

pytestmark = pytest.mark.skipif(
    sys.platform != "linux", reason="only Linux keeps such a bound on a process"
)


def test_what_would_take_all_memory_is_an_error_there_and_nothing_is_bounded_afterwards(
    tmp_path: Path,
) -> None:
    (tmp_path / "small").write_bytes(b"small")
    before = resource.getrlimit(resource.RLIMIT_AS)
    with pytest.raises(MemoryError), memory_bounded(tmp_path / "small"):
        bytes(200 << 20)
    assert resource.getrlimit(resource.RLIMIT_AS) == before
    assert len(bytes(200 << 20)) == 200 << 20


def test_an_hdf5_file_is_looked_into_under_such_a_bound(tmp_path: Path) -> None:
    path = tmp_path / "run.hdf5"
    with h5py.File(path, "w") as file:
        file["position"] = np.zeros((50, 3))
    with pytest.raises(DemonstrationError, match="far more memory than"), opened(path):
        bytes(200 << 20)


@pytest.mark.parametrize("profile", ["ros2", ""])
def test_a_chunk_of_an_mcap_file_that_unpacks_to_a_hundred_times_the_file_is_refused(
    tmp_path: Path, profile: str
) -> None:
    path = tmp_path / "run.mcap"
    with path.open("wb") as file:
        writer = mcap.writer.Writer(file, chunk_size=1 << 40)
        writer.start(profile=profile)
        kind = writer.register_schema("std_msgs/msg/String", "ros2msg", b"string data")
        topic = writer.register_channel("/said", "cdr" if profile else "json", kind)
        writer.add_message(topic, 0, bytes(100 << 20), 0)
        writer.finish()
    with pytest.raises(DemonstrationError, match="far more memory than"):
        read(path)


def test_a_parquet_file_of_kilobytes_with_millions_of_rows_is_refused(tmp_path: Path) -> None:
    column = pa.array(np.zeros(10_000_000))
    pq.write_table(pa.table(dict.fromkeys("txyz", column)), tmp_path / "run.parquet")
    with pytest.raises(DemonstrationError, match="far more memory than"):
        read(tmp_path / "run.parquet")
