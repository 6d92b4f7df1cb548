"""What commands write: never over a file that keyphase did not write as it is, unless asked to."""

import shutil
from pathlib import Path

import pytest

from keyphase.cli import main
from keyphase.files.shipped import shipped

pytestmark = pytest.mark.slow

THEIRS = b"written by somebody else"


@pytest.fixture
def theirs(tmp_path: Path) -> Path:
    shutil.copy(shipped("data") / "setup1.npz", tmp_path / "one.npz")
    path = tmp_path / "theirs.svg"
    path.write_bytes(THEIRS)
    return path


def keyphase(command: str) -> int:
    with pytest.raises(SystemExit) as ended:
        main(command.split())
    return int(ended.value.code or 0)


@pytest.mark.parametrize(
    "command",
    [
        "fit --count 1 --families press --output {theirs}",
        "record setup1 --output {theirs}",
        "segment {folder}/one.npz --output {folder}/out --report {theirs}",
        "propose {folder} --output {folder}/out --report {theirs}",
        "draw {folder}/one.npz --what timeline --output {theirs}",
    ],
)
def test_somebody_elses_file_stays_and_the_way_to_replace_it_is_told(
    theirs: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert keyphase(command.format(theirs=theirs, folder=theirs.parent)) == 1
    assert theirs.read_bytes() == THEIRS
    assert "--replace" in capsys.readouterr().err


def test_it_is_replaced_where_that_is_asked_for_and_what_was_written_once_is_written_again(
    theirs: Path,
) -> None:
    make = f"make-demonstrations --families reach --count 1 --output {theirs.parent}"
    truth = theirs.rename(theirs.with_name("truth.json"))
    assert keyphase(make) == 1
    assert truth.read_bytes() == THEIRS
    assert keyphase(f"{make} --replace") == 0
    assert keyphase(make.replace("count 1", "count 2")) == 0
    assert "reach/1" in truth.read_text()


@pytest.mark.parametrize(
    "command", ["fit --output {gone}/w.json", "record setup1 --output {gone}/take.npz"]
)
def test_a_folder_that_takes_no_files_is_told_before_the_work(
    tmp_path: Path, command: str, capsys: pytest.CaptureFixture[str], monkeypatch
) -> None:
    monkeypatch.setattr("keyphase.making.make", lambda *_: pytest.fail("worked in vain"))
    monkeypatch.setattr("keyphase.simulation.record", lambda *_: pytest.fail("worked in vain"))

    assert keyphase(command.format(gone=tmp_path / "gone")) == 1
    assert "check the folder" in capsys.readouterr().err
