"""HDF5 as robomimic and REASSEMBLE write it, made with h5py and compared value by value."""

import json
from pathlib import Path

import h5py
import numpy as np
import pytest

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import find_recordings, fingerprint, parse_recipe, read
from keyphase.readers.formats import hdf5

T = np.arange(200) / 20.0
PLACE = np.column_stack([0.1 * T, np.sin(T), 0.0 * T])
XYZW = np.tile([0.0, 0.6, 0.0, 0.8], (200, 1))


@pytest.fixture
def robomimic(tmp_path: Path) -> Path:
    path = tmp_path / "low_dim.hdf5"
    with h5py.File(path, "w") as file:
        data = file.create_group("data")
        data.attrs["env_args"] = json.dumps({"env_kwargs": {"control_freq": 20}})
        for number in range(12):
            obs = data.create_group(f"demo_{number}/obs")
            obs["robot0_eef_pos"] = PLACE + number
            obs["robot0_eef_quat"] = XYZW
            obs["agentview_image"] = np.zeros((200, 4, 4, 3), np.uint8)
    return path


def test_a_file_of_many_demonstrations_is_a_list_in_natural_order(robomimic: Path) -> None:
    names = [found.path.name for found in find_recordings([robomimic.parent])]
    assert names == [f"low_dim.hdf5#demo_{number}" for number in range(12)]


def test_robomimic_is_read_without_a_recipe(robomimic: Path) -> None:
    demonstration = read(f"{robomimic}#demo_3")
    assert demonstration.name == "low_dim#demo_3"
    np.testing.assert_array_equal(demonstration.time_s, T)
    np.testing.assert_array_equal(demonstration.position_m, PLACE + 3)
    assert demonstration.orientation_wxyz is not None
    np.testing.assert_allclose(demonstration.orientation_wxyz[0], [0.8, 0.0, 0.6, 0.0])
    assert "Time is counted at the control rate the file states, 20 Hz." in demonstration.notices


def test_a_demonstration_is_known_by_its_own_numbers(robomimic: Path) -> None:
    before = fingerprint(f"{robomimic}#demo_3")
    with h5py.File(robomimic, "a") as file:
        file["data/demo_4/obs/robot0_eef_pos"][0, 0] = 7.0
    assert fingerprint(f"{robomimic}#demo_3") == before
    with h5py.File(robomimic, "a") as file:
        file["data/demo_3/obs/robot0_eef_pos"][0, 0] = 7.0
    assert fingerprint(f"{robomimic}#demo_3") != before


@pytest.mark.parametrize("part", ["", "#demo_99"])
def test_a_demonstration_that_is_not_there_is_refused_with_those_that_are(
    robomimic: Path, part: str
) -> None:
    with pytest.raises(DemonstrationError, match=r"demo_0, demo_1, .*12 in all.*#demo_0"):
        read(f"{robomimic}{part}")


def reassemble(path: Path, word: str = "compensated") -> None:
    """Pose at 100 Hz, force at 500 Hz, each with its own clock in absolute seconds."""
    pose_s, force_s = 1.7e9 + np.arange(300) / 100, 1.7e9 + 0.05 + np.arange(1400) / 500
    with h5py.File(path, "w") as file:
        file["robot_state/pose"] = np.column_stack(
            [pose_s - 1.7e9, np.zeros((300, 2)), np.tile([1.0, 0, 0, 0], (300, 1))]
        )
        file["robot_state/compensated_base_force"] = np.tile([1.0, 2.0, 3.0], (1400, 1))
        file[f"robot_state/{word}_base_torque"] = np.tile([0.1, 0.2, 0.3], (1400, 1))
        file["timestamps/pose"] = pose_s
        file["timestamps/compensated_base_force"] = force_s
        file[f"timestamps/{word}_base_torque"] = force_s
        file["hama1"] = np.frombuffer(b"\0\0\0\x18ftypmp42" * 100, np.uint8)


@pytest.mark.parametrize("word", ["compensated", "compenseted"])
def test_streams_at_their_own_rates_are_brought_to_the_fastest(tmp_path: Path, word: str) -> None:
    path = tmp_path / "run.h5"
    reassemble(path, word)
    preset = "reassemble" if word == "compensated" else "reassemble_misspelt"
    demonstration = read(path, parse_recipe(f'preset = "{preset}"\nwrench.sign = -1', "one.toml"))
    np.testing.assert_allclose(demonstration.rate_hz, 500, rtol=1e-3)
    np.testing.assert_allclose(demonstration.position_m[:, 0], demonstration.time_s, atol=1e-6)
    assert demonstration.force_N is not None
    np.testing.assert_array_equal(demonstration.force_N[0], [-1.0, -2.0, -3.0])
    assert any("Interpolated position_m (100 Hz)" in notice for notice in demonstration.notices)


def test_what_a_format_leaves_open_is_asked_for(tmp_path: Path) -> None:
    reassemble(tmp_path / "run.h5")
    with pytest.raises(RecipeError, match=r"preset 'reassemble', which leaves .*'sign' is missing"):
        read(tmp_path / "run.h5")


def test_columns_nobody_knows_are_listed(tmp_path: Path) -> None:
    with h5py.File(tmp_path / "own.h5", "w") as file:
        file["arm/tool"] = np.zeros((10, 2))
    with pytest.raises(RecipeError, match=r"a recipe must say.*arm/tool\[0\], arm/tool\[1\]"):
        read(tmp_path / "own.h5")


def test_links_to_other_files_are_not_followed(tmp_path: Path, robomimic: Path) -> None:
    path = tmp_path / "links.h5"
    with h5py.File(path, "w") as file:
        file["own"] = np.zeros((10, 3))
        file["data"] = h5py.ExternalLink(str(robomimic), "data")
    with pytest.raises(RecipeError, match=r"there are own\[0\], own\[1\], own\[2\]"):
        read(path)


def test_an_empty_dataset_is_passed_over(tmp_path: Path, robomimic: Path) -> None:
    with h5py.File(robomimic, "a") as file:
        file["data/demo_2/note"] = h5py.Empty("f8")
    assert len(read(f"{robomimic}#demo_2")) > 2


def test_a_recording_larger_than_the_limit_is_refused_before_it_is_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.h5"
    with h5py.File(path, "w") as file:
        file.create_dataset("pose", (10**9, 7), dtype="f4", chunks=(1000, 7), compression="gzip")
    assert path.stat().st_size < 10_000
    with pytest.raises(DemonstrationError, match="more than the limit"):
        read(path)


def test_a_cut_file_is_refused(robomimic: Path) -> None:
    cut = robomimic.with_name("cut.hdf5")
    cut.write_bytes(robomimic.read_bytes()[:3000])
    with pytest.raises(DemonstrationError, match="expected a whole HDF5 file"):
        read(f"{cut}#demo_0")


def test_the_demonstrations_of_a_file_are_looked_for_once_not_at_each_of_them(
    robomimic: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sorting, looks = hdf5.in_natural_order, []
    monkeypatch.setattr(hdf5, "in_natural_order", lambda names: looks.append(1) or sorting(names))
    for found in find_recordings([robomimic]):
        read(found.path)
    assert len(looks) == 1
    with h5py.File(robomimic, "a") as file:
        file.copy("data/demo_3", "data/demo_12")
    assert read(f"{robomimic}#demo_12").name == "low_dim#demo_12"
