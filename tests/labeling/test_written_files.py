"""Exports never replace, unasked, what keyphase did not write as it is."""

import stat
from pathlib import Path

import pytest

from keyphase.errors import FileInTheWayError
from keyphase.labeling.storage.written_files import NAME, write_unasked


def _write(path: Path, data: bytes, made_from: str = "run.npz", **how: object) -> Path:
    return write_unasked(path, data, made_from, ending=".segments.json", **how)  # type: ignore[arg-type]


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "run.segments.json"


def test_what_keyphase_wrote_is_replaced_by_what_it_writes_next(path: Path) -> None:
    _write(path, b"first")
    _write(path, b"second")
    assert path.read_bytes() == b"second"


def test_a_strangers_file_is_left_and_named(path: Path) -> None:
    path.write_bytes(b"by hand")
    with pytest.raises(FileInTheWayError, match="keyphase did not write it") as refused:
        _write(path, b"new")
    assert refused.value.path == path
    assert path.read_bytes() == b"by hand"


def test_a_file_that_somebody_changed_since_is_left(path: Path) -> None:
    _write(path, b"first")
    path.write_bytes(b"first, and a remark")
    with pytest.raises(FileInTheWayError, match="changed since keyphase wrote it"):
        _write(path, b"second")


def test_what_was_written_for_another_recording_is_left(path: Path) -> None:
    _write(path, b"of the table", "run.csv")
    with pytest.raises(FileInTheWayError, match=r"keyphase wrote it for run\.csv"):
        _write(path, b"of the archive", "run.npz")


def test_the_same_bytes_are_no_loss_whoever_wrote_them(path: Path) -> None:
    path.write_bytes(b"same")
    assert _write(path, b"same") == path


def test_replacing_it_can_be_asked_for(path: Path) -> None:
    path.write_bytes(b"by hand")
    _write(path, b"new", if_there="replace")
    assert path.read_bytes() == b"new"


def test_both_can_be_kept_under_a_name_that_still_says_what_it_is(path: Path) -> None:
    path.write_bytes(b"by hand")
    assert _write(path, b"new", if_there="keep both").name == "run_2.segments.json"
    assert _write(path, b"newer", if_there="keep both").name == "run_3.segments.json"
    assert path.read_bytes() == b"by hand"


def test_mode_and_link_of_what_is_replaced_are_kept(path: Path, tmp_path: Path) -> None:
    real = tmp_path / "elsewhere.json"
    path.symlink_to(real)
    _write(path, b"first")
    real.chmod(0o640)
    _write(path, b"second")
    assert path.is_symlink()
    assert real.read_bytes() == b"second"
    assert stat.S_IMODE(real.stat().st_mode) == 0o640


def test_a_line_that_a_kill_cut_off_costs_only_itself(path: Path, tmp_path: Path) -> None:
    _write(path, b"first")
    written = tmp_path / ".keyphase" / NAME
    with written.open("ab") as file:
        file.write(b'0123abcd {"name": "oth')
    _write(path, b"second")
    _write(path, b"third")
    assert path.read_bytes() == b"third"
