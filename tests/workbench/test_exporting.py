"""What the page exports lies beside the recordings, and replaces nobody's file unasked."""

import json
import shutil
from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np
import pytest
from two_pages import TalkingPage, workbench_on

from keyphase.readers import find_recordings
from keyphase.workbench.workbench import Settings, Workbench


@pytest.fixture
def workbench(tmp_path: Path) -> Iterator[Workbench]:
    made = workbench_on(tmp_path, "ab")
    yield made
    made.close()


def _export(page: TalkingPage, kind: str, answer: str, **how: str) -> dict[str, object]:
    page.told.pop(answer, None)
    page.say("export", page.document(), kind=kind, **how)
    page.wait_for(lambda: answer in page.told)
    return page.told[answer]


def test_a_strangers_file_is_asked_about_and_replaced_only_then(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    file = tmp_path / "a.segments.json"
    file.write_text("{}")
    told = _export(page, "json", "in_the_way")
    assert told["files"] == [{"name": file.name, "whose": "keyphase did not write it"}]
    assert file.read_text() == "{}"
    assert str(_export(page, "json", "saved", if_there="keep both")["path"]).endswith(
        "a_2.segments.json"
    )
    _export(page, "json", "saved", if_there="replace")
    assert file.stat().st_size > 100
    _export(page, "json", "saved")


def test_a_behaviour_tree_is_written_beside_a_hand_written_robot_description(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    (tmp_path / "a.xml").write_text("<robot/>")
    told = _export(page, "behavior-tree", "saved")
    assert str(told["path"]).endswith("a.tree.xml")
    assert (tmp_path / "a.xml").read_text() == "<robot/>"


def test_two_recordings_of_one_name_are_refused_alone_and_among_all(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    page.document()
    table = tmp_path / "a.csv"
    shutil.copy(tmp_path / "b.npz", table)
    workbench.recordings.add(table)
    told = _export(page, "json", "refused")
    assert "a.npz and a.csv would both be written" in str(told["text"])
    told = _export(page, "json", "notice", scope="all")
    assert sorted(file.name for file in tmp_path.glob("*.segments.json")) == ["b.segments.json"]


def test_exporting_all_writes_what_is_free_and_asks_about_the_rest(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    (tmp_path / "b.segments.json").write_text("{}")
    told = _export(page, "json", "in_the_way", scope="all")
    assert [file["name"] for file in told["files"]] == ["b.segments.json"]  # type: ignore[attr-defined]
    assert (tmp_path / "a.segments.json").is_file()


def test_a_dataset_is_copied_once_with_all_its_recordings_and_is_none_itself(
    tmp_path: Path,
) -> None:
    path, rate_hz, count = tmp_path / "many.hdf5", 20.0, 100
    with h5py.File(path, "w") as file:
        file.create_group("data").attrs["env_args"] = json.dumps(
            {"env_kwargs": {"control_freq": rate_hz}}
        )
        for number in range(2):
            demo = file.create_group(f"data/demo_{number}")
            demo["actions"] = np.zeros((count, 7))
            demo["obs/robot0_eef_pos"] = np.linspace([0, 0, 0.3], [0.2, 0, 0.1], count)
            demo["obs/robot0_eef_quat"] = np.tile([0.0, 0.0, 0.0, 1.0], (count, 1))
    found = [one.path for one in find_recordings([tmp_path])]
    workbench = Workbench(found, Settings(folder=tmp_path, arms=("left", "right")))
    page = TalkingPage(workbench, "page")
    first = _export(page, "robomimic", "saved", scope="all")
    assert first["path"] == str(tmp_path / "keyphase_exports/robomimic/many.hdf5")
    with h5py.File(str(first["path"])) as file:
        assert len(file["mask/segmented"]) == 2  # type: ignore[arg-type]
    assert _export(page, "robomimic", "in_the_way", scope="all")["files"]
    second = _export(page, "robomimic", "saved", scope="all", if_there="keep both")
    assert second["path"] == str(tmp_path / "keyphase_exports/robomimic_2/many.hdf5")
    assert [one.path for one in find_recordings([tmp_path])] == found
    workbench.close()
