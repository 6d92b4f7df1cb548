"""The scripts beside the YuMi make what lies beside them."""

import subprocess
import sys
from pathlib import Path

import pytest
import trimesh

from keyphase.files.shipped import shipped

FOLDER = shipped("static_robots") / "yumi"


def run(script: str, *arguments: str) -> None:
    subprocess.run([sys.executable, "-B", str(FOLDER / script), *arguments], check=True)


def test_the_description_is_what_its_script_writes(tmp_path):
    run("generate_urdf.py", "--to", str(tmp_path / "yumi.urdf"))

    assert (tmp_path / "yumi.urdf").read_text() == (FOLDER / "yumi.urdf").read_text()


def test_the_shells_are_what_their_script_makes_every_time(tmp_path):
    pytest.importorskip("skimage", reason="needs the extra `shells`")
    pytest.importorskip("fast_simplification", reason="needs the extra `shells`")
    first, again = tmp_path / "first", tmp_path / "again"
    for folder in (first, again):
        run("generate_shells.py", "finger", "link_7", "--to", str(folder))

    for name in ("finger", "link_7"):
        assert (first / f"{name}.glb").read_bytes() == (again / f"{name}.glb").read_bytes()
        made, kept = (
            trimesh.load_scene(Path(folder) / f"{name}.glb")
            for folder in (first, FOLDER / "shells")
        )
        assert made.bounds == pytest.approx(kept.bounds, abs=2e-4)
        assert len(made.geometry) == len(kept.geometry)
