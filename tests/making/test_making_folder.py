"""The folder and the command that makes it."""

import json

import pytest

from keyphase.cli import main
from keyphase.errors import MakingError
from keyphase.making import make_folder
from keyphase.readers import read


def test_the_command_writes_recordings_that_can_be_read_and_a_truth_for_each(tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main(f"make-demonstrations --output {tmp_path} --families press reach --count 2".split())
    assert ended.value.code == 0
    truth = json.loads((tmp_path / "truth.json").read_text())
    assert list(truth) == ["press/0", "press/1", "reach/0", "reach/1"]
    for key, entry in truth.items():
        assert read(tmp_path / f"{key}.npz").end_s > entry["events"][-1][0]
    assert "4 demonstrations" in capsys.readouterr().out


def test_what_was_made_in_the_folder_before_keeps_its_truth_while_it_is_there(tmp_path):
    make_folder(["press"], 2, 0, tmp_path)
    (tmp_path / "press" / "0.npz").unlink()
    target = make_folder(["reach"], 1, 0, tmp_path)
    assert list(json.loads(target.read_bytes())) == ["press/1", "reach/0"]


@pytest.mark.parametrize(
    ("families", "count", "said"),
    [(["dance"], 1, "dance"), ([], 1, "none"), (["press"], 0, "count from 1")],
)
def test_what_cannot_be_made_is_refused(families, count, said, tmp_path):
    with pytest.raises(MakingError, match=said):
        make_folder(families, count, 0, tmp_path)
