"""A wrench that a sensor logged into a file of its own, at its own rate and on its own clock."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.errors import DemonstrationError, RecipeError, SegmentFileError
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import (
    read_segment_file,
    require_same_reading,
    write_segment_file,
)
from keyphase.readers import parse_recipe, read
from keyphase.segmentation import segment

RECIPE = """
time = {column = "t", unit = "s", from_zero = true}
position = {columns = ["x", "y", "z"], unit = "m"}
force = {columns = ["fx", "fy", "fz"], unit = "N", clock_offset_s = -0.1}
wrench = {frame = "base", sign = 1}
wrench_file = {path = "%s", separator = "whitespace", column = "ms", unit = "ms"}
"""
BEGIN = 1000.0


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """A place at 50 Hz, and a force of so many newtons as seconds have passed, at 200 Hz."""
    time = np.arange(100) / 50
    places = [f"{BEGIN + t:.3f},{t:.4f},0,{t * t:.6f}" for t in time]
    (tmp_path / "run_7.csv").write_text("\n".join(["t,x,y,z", *places, ""]))
    late = np.arange(440) / 200 - 0.05
    forces = [f"{1000 * (BEGIN + t + 0.1):.1f} {t:.6f} 0 0" for t in late]
    (tmp_path / "run_7_ft.txt").write_text("\n".join(["ms fx fy fz", *forces, ""]))
    return tmp_path / "run_7.csv"


def test_force_is_read_from_its_own_file_on_the_recordings_clock(recording: Path) -> None:
    found = read(recording, parse_recipe(RECIPE % "{stem}_ft.txt", "r"))
    assert found.force_N is not None
    assert found.rate_hz == pytest.approx(200)
    np.testing.assert_allclose(found.force_N[:, 0], found.time_s, atol=1e-6)
    np.testing.assert_allclose(found.position_m[:, 0], found.time_s, atol=1e-6)
    assert any("run_7_ft.txt" in notice for notice in found.notices)


def test_what_was_labeled_with_another_wrench_is_refused(recording: Path) -> None:
    recipe = parse_recipe(RECIPE % "{stem}_ft.txt", "r")
    written = recording.with_suffix(".segments.json")
    write_segment_file(label(segment(read(recording, recipe))), written)
    beside = recording.with_name("run_7_ft.txt")
    beside.write_text(beside.read_text().replace(" 0 0", " 1 0"))
    with pytest.raises(SegmentFileError, match="or the wrench file it names has"):
        require_same_reading(read_segment_file(written), read(recording, recipe))


def test_a_file_that_is_not_there_is_told(recording: Path) -> None:
    with pytest.raises(DemonstrationError, match="there is no such file"):
        read(recording, parse_recipe(RECIPE % "{stem}_force.txt", "r"))


@pytest.mark.parametrize("path", ["../secret.txt", "/etc/passwd"])
def test_no_file_outside_the_folder_is_read(recording: Path, path: str) -> None:
    with pytest.raises(RecipeError, match="must lie in the recording's folder"):
        read(recording, parse_recipe(RECIPE % path, "r"))
