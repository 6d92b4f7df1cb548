"""The examples run as they stand."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from keyphase.files.shipped import shipped

# Each in a process of its own, two with a replay whole.
pytestmark = pytest.mark.slow

EXAMPLES = Path(__file__).parents[1] / "examples"


def run(name: str, *arguments: object, cwd: Path) -> str:
    """What an example prints, run in a folder of its own."""
    command = [sys.executable, EXAMPLES / name, *map(str, arguments)]
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, env={**os.environ})
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "recordings").mkdir()
    shutil.copy(shipped("data") / "setup1.npz", tmp_path / "recordings")
    return tmp_path


def test_segment_a_folder_prints_phases_and_writes_segment_files(folder: Path) -> None:
    printed = run("segment_a_folder.py", "recordings", cwd=folder)
    assert printed.count("setup1: ") >= 4
    assert (folder / "setup1.segments.json").is_file()


def test_read_with_a_recipe_says_what_was_done(tmp_path: Path) -> None:
    assert run("read_with_a_recipe.py", cwd=tmp_path).startswith("1.98 s")


def test_an_own_method_segments(tmp_path: Path) -> None:
    assert run("own_method.py", cwd=tmp_path).count(" s  ") > 2


def test_an_own_workcell_is_replayed(tmp_path: Path) -> None:
    assert "success" in run("own_workcell.py", cwd=tmp_path)


def test_skills_drive_a_robot_to_their_ends(tmp_path: Path) -> None:
    ended = run("skills_to_a_robot.py", cwd=tmp_path).splitlines()
    assert len(ended) > 2
    assert all(line.endswith((": contact", ": reached")) for line in ended)
    assert (tmp_path / "setup1.skills.json").is_file()
