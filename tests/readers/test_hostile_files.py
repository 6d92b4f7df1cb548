"""Whatever a file holds, reading it succeeds or says in one sentence why not.

Sound files that were damaged are tried in test_mutated_files.py.
"""

import io
import pickle
import zipfile
from pathlib import Path

import numpy as np
import pytest
from demonstration_strategies import random_orientations
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError
from keyphase.readers import read, save_csv

ROWS = 12

fuzz = settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("hostile")
    rows = np.arange(3.0 * ROWS).reshape(ROWS, 3)
    demonstration = Demonstration(
        "valid",
        np.arange(ROWS) / 100,
        rows,
        random_orientations(ROWS, 0),
        force_N=rows,
        torque_Nm=rows,
        joints_rad=rows,
        metadata={"robot": "YuMi", "nested": [1, 2.5, None]},
    )
    save_csv(demonstration, folder / "valid.csv")
    return folder


def reads_or_says_why(path: Path) -> None:
    try:
        assert len(read(path)) >= 2
    except DemonstrationError as error:
        refusal = str(error)
    else:
        return
    assert path.name in refusal
    assert "\n" not in refusal


@pytest.mark.slow
@fuzz
@given(data=st.binary(max_size=300))
@example(data=b"\xff\xfe\x00")
@example(data=b"PK\x03\x04")
@example(data=b"\n\n\n")
@example(data=b'"')
def test_arbitrary_bytes_read_or_say_why(folder: Path, data: bytes) -> None:
    for name in ("arbitrary.npz", "arbitrary.csv"):
        (folder / name).write_bytes(data)
        reads_or_says_why(folder / name)


@fuzz
@given(cells=st.lists(st.text(max_size=12), min_size=14, max_size=14))
def test_arbitrary_cells_read_or_say_why(folder: Path, cells: list[str]) -> None:
    header = (folder / "valid.csv").read_text().splitlines()[0]
    table = "\n".join([header, ",".join(["0"] * 17), ",".join([*cells, "1", "2", "3"])])
    path = folder / "cells.csv"
    path.write_bytes(table.encode("utf-8", errors="surrogatepass"))
    reads_or_says_why(path)


@fuzz
@given(header=st.binary(max_size=120), body=st.binary(max_size=60))
@example(header=b"(" * 100, body=b"")
@example(header=b"{'descr': '<f8', 'fortran_order': False, 'shape': (-1,)}", body=b"")
@example(header=b"{'descr': '<f8', 'fortran_order': False, 'shape': (10**99,)}", body=b"")
def test_an_arbitrary_array_header_reads_or_says_why(
    folder: Path, header: bytes, body: bytes
) -> None:
    path = folder / "header.npz"
    member = b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header + body
    good = io.BytesIO()
    np.save(good, np.zeros((3, 3)))
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("time_s.npy", member)
        archive.writestr("position_m.npy", good.getvalue())
    reads_or_says_why(path)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (pickle.dumps({"a": [1.0, 2.0]}, protocol=0), "never loaded"),
        (pickle.dumps({"a": [1.0, 2.0]}, protocol=1), "never loaded"),
        (pickle.dumps({"a": [1.0, 2.0]}), "never loaded"),
        (b"FEA1" + bytes(40), "write its table as Parquet"),
        (b"run.csv".ljust(257, b"\0") + b"ustar\0" + bytes(249), "unpack it first"),
        (b"TDSm" + bytes(40), "LabVIEW"),
        (b"\x02\x50\x02\x00" + bytes(508), "C3D"),
        (b"\0\0\0\x20ftypisom" + bytes(40), "beside a recording of the same name"),
    ],
)
def test_a_file_of_another_kind_is_named_with_the_way_out(
    data: bytes, said: str, tmp_path: Path
) -> None:
    (tmp_path / "run.csv").write_bytes(data)
    with pytest.raises(DemonstrationError, match=f"expected a recording, but it is .*{said}"):
        read(tmp_path / "run.csv")
