"""A wrench that a sensor logged into a file of its own, at its own rate and on its own clock."""

from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from keyphase.errors import DemonstrationError, RecipeError, SegmentFileError
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import (
    read_segment_file,
    require_same_reading,
    write_segment_file,
)
from keyphase.readers import parse_recipe, read
from keyphase.readers.recipes.clocks import on_one_clock
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


@pytest.mark.parametrize("ending", [".h5", ".npz", ".parquet"])
def test_a_wrench_may_lie_in_a_binary_file(recording: Path, ending: str) -> None:
    rows = np.loadtxt(recording.with_name("run_7_ft.txt"), skiprows=1)
    path = recording.with_name(f"run_7_ft{ending}")
    columns = dict(zip(("ms", "fx", "fy", "fz"), rows.T, strict=True))
    if ending == ".h5":
        with h5py.File(path, "w") as file:
            file.update(columns)
    elif ending == ".npz":
        np.savez(path, **columns)
    else:
        pq.write_table(pa.table(columns), path)
    recipe = RECIPE.replace(', separator = "whitespace"', "") % f"{{stem}}_ft{ending}"

    found = read(recording, parse_recipe(recipe, "r"))

    assert found.force_N is not None
    np.testing.assert_allclose(found.force_N[:, 0], found.time_s, atol=1e-6)


def test_the_wrench_of_one_of_many_is_that_of_the_same_name(recording: Path) -> None:
    rows = np.loadtxt(recording.with_name("run_7_ft.txt"), skiprows=1)
    place = np.loadtxt(recording, skiprows=1, delimiter=",")
    with h5py.File(recording.with_name("all.h5"), "w") as file:
        for number in range(2):
            for at, name in enumerate("txyz"):
                file[f"demo_{number}/{name}"] = place[:, at]
    with h5py.File(recording.with_name("all_ft.h5"), "w") as file:
        for number in range(2):
            for at, name in enumerate(("ms", "fx", "fy", "fz")):
                file[f"demo_{number}/{name}"] = rows[:, at] + (number if at == 2 else 0)
    recipe = RECIPE.replace(', separator = "whitespace"', "") % "{stem}_ft.h5"

    found = read(recording.with_name("all.h5#demo_1"), parse_recipe(recipe, "r"))

    assert found.force_N is not None
    np.testing.assert_allclose(found.force_N[:, 1], 1.0)


@pytest.mark.parametrize("count", [0, 1])
def test_a_channel_with_fewer_than_two_samples_is_refused(count: int) -> None:
    time = {"position_m": np.arange(9) / 10, "force_N": np.arange(count) / 10}
    channels = {name: np.zeros((len(clock), 3)) for name, clock in time.items()}
    with pytest.raises(RecipeError, match=f"force_N has {count} sample"):
        on_one_clock(channels, time, "r.toml")
