"""robomimic, MimicGen and REASSEMBLE: what is added in a copy, read as their own code reads it."""

import json

import h5py
import numpy as np
import pytest
from segmented_recordings import EDGES_S, NAMES, RATE_HZ, moving, with_segment_file

from keyphase.errors import ExportError
from keyphase.files.parts import with_part
from keyphase.writers import SegmentedRecording, planned_export


@pytest.fixture(scope="module")
def robomimic(tmp_path_factory):
    """Three demonstrations, of which two are segmented; and the segment files."""
    path = tmp_path_factory.mktemp("robomimic") / "low_dim.hdf5"
    time, position, wxyz, _ = moving()
    with h5py.File(path, "w") as file:
        data = file.create_group("data")
        data.attrs["env_args"] = json.dumps({"env_kwargs": {"control_freq": RATE_HZ}})
        for number in range(3):
            demo = data.create_group(f"demo_{number}")
            demo["actions"] = np.zeros((len(time), 7))
            demo["obs/robot0_eef_pos"] = position + 0.01 * number
            demo["obs/robot0_eef_quat"] = np.roll(wxyz, -1, axis=1)
        file["mask/train"] = np.array(["demo_1"], dtype="S")
    files = [with_segment_file(path.parent, with_part(path, f"demo_{n}")) for n in (0, 2)]
    return path, files


def export(files, to, output):
    items = [SegmentedRecording.of_file(file) for file in files]
    ((written,),) = planned_export(items, to, output).write()
    return written


def datasets(file):
    found = {}
    file.visititems(
        lambda name, one: found.update({name: one[()]}) if isinstance(one, h5py.Dataset) else None
    )
    return found


@pytest.mark.parametrize("to", ["robomimic", "mimicgen"])
def test_all_that_was_in_the_file_is_as_it_was(robomimic, to, tmp_path):
    written = export(robomimic[1], to, tmp_path)
    with h5py.File(robomimic[0]) as before, h5py.File(written) as after:
        there = datasets(after)
        for name, values in datasets(before).items():
            assert there[name].tobytes() == values.tobytes(), name
        assert dict(before["data"].attrs) == dict(after["data"].attrs)


def test_filter_keys_choose_demonstrations_as_robomimic_reads_them(robomimic, tmp_path):
    with h5py.File(export(robomimic[1], "robomimic", tmp_path)) as file:
        read = {
            key: [one.decode("utf-8") for one in np.array(file[f"mask/{key}"])]
            for key in file["mask"]
        }
        assert read["train"] == ["demo_1"]
        assert read["segmented"] == read["has_insert"] == ["demo_0", "demo_2"]
        assert "has_wait" not in read
        rows = file["data/demo_2/segment_id"][()]
        assert json.loads(file["data/demo_2"].attrs["segment_names"]) == list(NAMES)
        assert (np.flatnonzero(np.diff(rows)) + 1).tolist() == [50, 125, 200]
        assert "segment_id" not in file["data/demo_1"]


def subtask_ends(file, demo, signals):
    """How MimicGen's parse_source_dataset finds where subtasks end."""
    ends, before = [], 0
    for name in signals:
        values = file[f"data/{demo}/datagen_info/subtask_term_signals/{name}"][:]
        changes = (values[1:] - values[:-1]).nonzero()[0]
        end = next(int(i) + 1 for i in changes if int(i) + 1 >= before)
        before = end + 1
        ends.append(before)
    return [*ends, file[f"data/{demo}/actions"].shape[0]]


def test_mimicgen_finds_each_kept_segment_where_it_ends(robomimic, tmp_path):
    with h5py.File(export(robomimic[1], "mimicgen", tmp_path)) as file:
        info = file["data/demo_0/datagen_info"]
        assert sorted(info["subtask_term_signals"]) == ["approach", "insert"]
        assert subtask_ends(file, "demo_0", ["approach", "insert"]) == [50, 125, 251]
        assert info["eef_pose"].shape == (251, 4, 4)
        np.testing.assert_allclose(info["eef_pose"][:, :3, 3], moving()[1])


def test_mimicgen_refuses_different_numbers_of_subtasks(robomimic, tmp_path):
    path, files = robomimic
    content = json.loads(files[0].read_text())
    content["segments"][2]["kept"] = True
    other = path.parent / "other" / files[0].name
    other.parent.mkdir()
    content["demonstration"]["path"] = f"../{content['demonstration']['path']}"
    other.write_text(json.dumps(content))
    with pytest.raises(ExportError, match="the same number of kept segments"):
        export([other, files[1]], "mimicgen", tmp_path)


def test_reassemble_has_the_segments_in_the_clock_of_its_sensors(tmp_path):
    path = tmp_path / "assembly.h5"
    time, position, wxyz, force = moving()
    with h5py.File(path, "w") as file:
        file["robot_state/pose"] = np.hstack([position, wxyz])
        for name in ("force", "torque"):
            file[f"robot_state/compensated_base_{name}"] = force
            file[f"timestamps/compensated_base_{name}"] = 1.7e9 + time
        file["timestamps/pose"] = 1.7e9 + time
        file["segments_info/0/start"] = 1.0
    (tmp_path / "recipe.toml").write_text('preset = "reassemble"\n[wrench]\nsign = 1\n')
    written = export([with_segment_file(tmp_path, path)], "reassemble", tmp_path / "out")
    with h5py.File(written) as file:
        info = file["segments_info"]
        read = [(info[str(i)]["start"][()], info[str(i)]["text"][()].decode()) for i in range(4)]
        assert [name for _, name in read] == list(NAMES)
        np.testing.assert_allclose([at - 1.7e9 for at, _ in read], EDGES_S[:-1], atol=1e-6)
        assert [bool(info[str(i)]["success"][()]) for i in range(4)] == [True, True, False, True]
        assert file["timestamps/pose"][0] == 1.7e9


def test_a_recording_of_another_format_is_refused(tmp_path):
    from segmented_recordings import item

    with pytest.raises(ExportError, match="expected an HDF5 file of robomimic"):
        list(planned_export([item(tmp_path)], "robomimic", tmp_path / "out").write())
