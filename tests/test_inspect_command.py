"""`keyphase inspect`: facts, oddities and a proposed recipe, with exit codes for machines."""

import io
import json
import os
import shutil
import sys
from pathlib import Path

import h5py
import numpy as np
import pytest

from keyphase.cli import main
from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.printable import printable_line
from keyphase.readers import save_npz


def inspect(*arguments: object) -> int:
    with pytest.raises(SystemExit) as ended:
        main(["inspect", *map(str, arguments)])
    return int(ended.value.code or 0)


def test_a_sound_recording_is_told_in_facts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(shipped("data") / "setup1.npz", tmp_path)
    assert inspect(tmp_path) == 0
    assert "position_m (3), orientation_wxyz (4), force_N (3)" in capsys.readouterr().out


def test_a_channel_that_never_changes_is_odd(tmp_path: Path) -> None:
    time = np.arange(100) / 50
    place = np.column_stack([time, time, time])
    save_npz(Demonstration("a", time, place, force_N=np.zeros((100, 3))), tmp_path / "a.npz")
    assert inspect(tmp_path / "a.npz") == 1


def test_an_unknown_table_gets_a_recipe_to_complete(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows = "".join(f"{i / 50},{i},5,5\n" for i in range(50))
    (tmp_path / "log.csv").write_text(f"t,x [mm],y [mm],z [mm]\n{rows}")
    assert inspect(tmp_path, "--write") == 2
    assert (tmp_path / "log.csv.recipe.toml").is_file()
    capsys.readouterr()
    assert inspect(tmp_path, "--json") == 0
    (result,) = json.loads(capsys.readouterr().out)
    assert result["facts"]["rate_hz"] == 50


def test_a_recipe_that_is_there_already_is_not_written_over_unasked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "log.csv").write_text("t,x [mm],y [mm],z [mm]\n" + "0,1,2,3\n0.1,2,3,4\n")
    recipe = tmp_path / "log.csv.recipe.toml"
    recipe.write_text("# mine, half done\n")
    assert inspect(tmp_path / "log.csv", "--write") == 2
    assert recipe.read_text() == "# mine, half done\n"
    assert "--replace" in capsys.readouterr().out
    inspect(tmp_path / "log.csv", "--write", "--replace")
    assert "[position]" in recipe.read_text()


@pytest.mark.parametrize("name", [b"run.hdf5", b"run\xff.hdf5", b"a\nb.hdf5"])
def test_names_in_files_and_of_files_cannot_steer_the_terminal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: bytes
) -> None:
    path = Path(os.fsdecode(bytes(tmp_path) + b"/" + name))
    with h5py.File(path, "w") as file:
        file["\x1b[31mred"], file["\u202edesrever"] = np.zeros((9, 3)), np.zeros((9, 3))
        file["دما"] = np.zeros((9, 3))
    terminal = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")
    monkeypatch.setattr(sys, "stdout", terminal)
    assert inspect(path) == 2
    terminal.seek(0)
    printed = terminal.read()
    assert "\x1b" not in printed
    assert "\u202e" not in printed
    assert r"\x1b[31mred" in printed
    assert "دما" in printed
    assert printed.startswith(printable_line(str(path)))
