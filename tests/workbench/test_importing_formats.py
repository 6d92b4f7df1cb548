"""Binary files nobody has described: the same questions as of a table, as far as they are open."""

from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest

from keyphase.readers import find_recordings, read
from keyphase.readers.proposing.answers import ROTATION_VECTOR
from keyphase.workbench.importing.importing import Importing
from keyphase.workbench.uploads import Upload
from strangers_files import nobodys_hdf5, nobodys_mcap
from strangers_tables import press


def test_columns_of_an_hdf5_are_proposed_with_evidence_and_only_the_rest_is_asked(tmp_path: Path):
    table = Importing().ask_about(nobodys_hdf5(tmp_path)).table

    parts = dict(zip(table.tried(table.proposed).names, table.proposed.parts, strict=True))

    assert parts["clock"] == "time"
    assert [parts[f"tool_pose[{i}]"] for i in range(3)] == ["x", "y", "z"]
    assert [parts[f"ft[{i}]"] for i in range(3)] == ["fx", "fy", "fz"]
    assert table.proposed.units["length"] == "mm"
    assert "quaternion" in table.evidence[[*parts].index("tool_pose[3]")]
    assert table.others_inside == 1
    assert table.tried(table.proposed).missing == (
        "Say whether the quaternion begins or ends with w.",
        "Say in whose axes the wrench is written.",
        "Say which way the force points when the tool presses.",
    )


def test_an_answered_hdf5_is_read_with_all_its_recordings_and_its_neighbour(tmp_path: Path):
    path = nobodys_hdf5(tmp_path)
    nobodys_hdf5(tmp_path, "session_8.h5", takes=1)
    importing = Importing()
    waiting = importing.ask_about(Path(f"{path}#take_1"))
    answers = replace(waiting.table.proposed, order="xyzw", frame="base", sign=-1)

    looked = importing.tried(waiting.id, answers).looks
    paths = importing.confirm(waiting.id, answers, "folder")

    time_s, position, force = press()
    assert waiting.others == 1
    assert looked
    assert [one.name.partition("#")[0] for one in paths].count("session_7.h5") == 2
    assert "session_8.h5" in {one.name.partition("#")[0] for one in paths}
    found = read(paths[0])
    np.testing.assert_allclose(found.time_s - found.start_s, time_s, atol=1e-9)
    np.testing.assert_allclose(found.position_m, position, atol=1e-9)
    assert found.force_N is not None
    np.testing.assert_allclose(found.force_N, force, atol=1e-9)


def test_streams_of_an_mcap_keep_their_clocks(tmp_path: Path):
    path = nobodys_mcap(tmp_path)
    importing = Importing()
    waiting = importing.ask_about(path)
    answers = replace(waiting.table.proposed, frame="base", sign=1)

    (read_path,) = importing.confirm(waiting.id, answers, "file")

    assert answers.clocks == {"force": "/sensor.stamp"}
    found = read(read_path)
    assert found.force_N is not None
    _, position, force = press()
    np.testing.assert_allclose(found.position_m, position[: len(found)], atol=1e-9)
    np.testing.assert_allclose(found.force_N[::2], force[::2][: len(found.force_N[::2])], atol=1e-6)


def test_of_a_preset_only_what_it_leaves_open_is_asked(tmp_path: Path):
    _, position, _ = press()
    data = tmp_path / "run.npz"
    turns = np.tile([0.1, 0.2, 0.3], (len(position), 1))
    np.savez(data, robot0_eef_pos=position, robot0_eef_rot_axis_angle=turns)
    sent = Upload(tmp_path, "umi.npz", data.stat().st_size)
    sent.write(data.read_bytes())
    sent.settle()
    importing = Importing()
    waiting = importing.ask_about_upload(sent)

    tried = waiting.table.tried(waiting.table.proposed)
    answers = replace(waiting.table.proposed, rate_hz=60.0)
    (path,) = importing.confirm(waiting.id, answers, "file")

    assert waiting.table.proposed.preset == "umi"
    assert tried.missing == ("Say how many rows there are a second.",)
    assert path == tmp_path / "umi.npz"
    assert read(path).rate_hz == pytest.approx(60)
    assert Path(f"{path}.recipe.toml").read_text().startswith('preset = "umi"')


def test_two_arms_in_one_file_become_two_recordings(tmp_path: Path):
    time_s, position, _ = press()
    with h5py.File(tmp_path / "pair.h5", "w") as file:
        file["t"] = time_s
        for side, aside in (("left", 0.0), ("right", 1.0)):
            file[f"{side}_tcp_pos"] = position + aside
            file[f"{side}_tcp_rotvec"] = np.tile([0.0, np.pi, 0.0], (len(time_s), 1)) + position
    importing = Importing()
    waiting = importing.ask_about(tmp_path / "pair.h5")
    answers = replace(waiting.table.proposed, sequence=ROTATION_VECTOR)

    looks = importing.tried(waiting.id, answers).looks
    paths = importing.confirm(waiting.id, answers, "file")

    assert [look.name for look in looks] == ["left", "right"]
    np.testing.assert_allclose(looks[1].path_m[0], position[0] + 1)
    assert [path.name for path in paths] == ["pair.h5#left", "pair.h5#right"]
    np.testing.assert_allclose(read(paths[1]).position_m, position + 1)


def test_a_recipe_that_a_person_wrote_counts_alone(tmp_path: Path):
    path = nobodys_hdf5(tmp_path)
    importing = Importing()
    waiting = importing.ask_about(path)
    text = 'time = {rate_hz = 10}\nposition = {columns = ["ft[0]", "ft[1]", "ft[2]"], unit = "m"}\n'

    importing.confirm(waiting.id, replace(waiting.table.proposed, text=text), "file")

    assert Path(f"{path}.recipe.toml").read_text() == text
    assert read(find_recordings([path])[0].path).rate_hz == pytest.approx(10)
