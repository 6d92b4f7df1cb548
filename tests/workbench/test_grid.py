"""The grid: every recording of a folder told once, a phase changed in all, and one undo."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest
from two_pages import Message, TalkingPage, workbench_on

from keyphase.labeling.storage.folder_settings import read_folder_settings
from keyphase.workbench.workbench import Workbench


class GridPage(TalkingPage):
    """A page that shows the grid; it keeps the rows it was told."""

    def __init__(self, workbench: Workbench, page: str) -> None:
        self.rows: dict[str, Message] = {}
        self.told_rows: list[str] = []
        super().__init__(workbench, page)

    def _hear(self, message: msgspec.Struct | bytes, may_drop: bool = False) -> None:
        if not isinstance(message, bytes) and message.__struct_config__.tag == "grid":
            for row in msgspec.json.decode(msgspec.json.encode(message))["rows"]:
                self.rows[row["name"]] = row
                self.told_rows.append(row["name"])
        super()._hear(message, may_drop)

    def watch(self, names: str) -> None:
        """Show the grid, and wait until all is known."""
        self.document()
        self.say("grid", shown=True)
        self.wait_for(lambda: all(self.names(name) for name in names))

    def names(self, name: str) -> list[str]:
        """What the segments of a recording are called; those that are dropped not."""
        row = self.rows.get(name, {"stretches": ()})
        return [one["label"] for one in row["stretches"] if one["color"] is not None]

    def name_first(self, name: str, label: str, *, done: bool = False) -> None:
        """Name the first segment of a recording."""
        document = self.open(name)
        edit = {"kind": "label", "time_s": document["start_s"] + 0.1, "label": label}
        self.say("edit", document, edit=edit)
        self.wait_for(lambda: self.told["document"]["segments"][0]["label"] == label)
        if done:
            self.say("done", self.told["document"], done=True)
            self.wait_for(lambda: self.told["document"]["state"] == "done")

    def change(self, kind: str, told: str, **fields: object) -> None:
        """Ask for a change of all, and wait until it is told."""
        self.told.pop("notice", None)
        self.say(kind, self.told["document"], **fields)
        self.wait_for(lambda: self.told.get("notice", {}).get("text") == told)


@pytest.fixture
def workbench(tmp_path: Path) -> Iterator[Workbench]:
    workbench = workbench_on(tmp_path, "abcd")
    yield workbench
    workbench.close()


def test_every_recording_is_told_and_then_only_what_changes(workbench: Workbench) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    assert len(page.told["grid"]["ids"]) == 4
    ends = [one["end_s"] for one in page.rows["b"]["stretches"]]
    assert ends == [one["end_s"] for one in page.document()["segments"]]
    page.told_rows.clear()
    page.name_first("c", "Reach")
    page.wait_for(lambda: page.names("c")[:1] == ["Reach"])
    assert set(page.told_rows) == {"c"}
    assert page.rows["c"]["state"] == "touched"


def test_what_is_proposed_is_shown_and_a_rename_leaves_it_alone(workbench: Workbench) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    page.name_first("a", "Reach", done=True)
    page.wait_for(lambda: page.rows["b"]["proposed_from"] == ["a"])
    page.wait_for(lambda: page.rows["d"]["proposed_from"] == ["a"])
    assert page.names("b")[0] == "Reach"
    page.change("phase_for_all", "Changed in 0 recordings.", label="Reach", to="Approach")
    assert page.open("b")["edits"] == 0


def test_a_rename_leaves_done_ones_and_one_undo_anywhere_takes_it_back(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    for name in "ab":
        page.name_first(name, "Reach")
    page.name_first("c", "Reach", done=True)
    journal = (tmp_path / ".keyphase" / "c.npz.journal").read_bytes()

    page.change("phase_for_all", "Changed in 2 recordings.", label="Reach", to="Approach")
    assert [page.names(name)[0] for name in "abc"] == ["Approach", "Approach", "Reach"]
    assert (tmp_path / ".keyphase" / "c.npz.journal").read_bytes() == journal
    assert read_folder_settings(tmp_path).tasks[0].phases[0].name == "Approach"
    assert page.told["grid"]["undo"] == "Rename “Reach”"

    page.open("b")
    page.change("undo", "Taken back in 2 recordings.")
    assert [page.names(name)[0] for name in "ab"] == ["Reach", "Reach"]
    assert read_folder_settings(tmp_path).tasks[0].phases[0].name == "Reach"
    assert page.told["grid"]["undo"] is None
    page.change("redo", "Made again in 2 recordings.")
    assert [page.names(name)[0] for name in "ab"] == ["Approach", "Approach"]


def test_with_the_box_done_ones_are_changed_and_stay_done_and_a_restart_can_undo(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    for name in "ab":
        page.name_first(name, "Reach", done=True)
    told = "Changed in 2 recordings."
    page.change("phase_for_all", told, label="Reach", to="Approach", include_done=True)
    assert [page.rows[name]["state"] for name in "ab"] == ["done", "done"]
    page.name_first("b", "Mine")
    workbench.close()

    again = Workbench([tmp_path / f"{name}.npz" for name in "abcd"])
    page = GridPage(again, "two")
    page.watch("abcd")
    page.open("a")
    page.change("undo", "Taken back in 1 recording.")
    assert [page.names(name)[0] for name in "ab"] == ["Reach", "Mine"]
    assert any("b was worked on since" in refused["text"] for refused in page.refused)
    again.close()


def test_a_phase_is_dropped_in_all_and_the_grid_takes_it_back(workbench: Workbench) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    name = page.names("a")[0]
    before = {one: page.names(one) for one in "abcd"}
    page.change("phase_for_all", "Changed in 4 recordings.", label=name)
    assert all(name not in page.names(one) for one in "abcd")
    page.change("phase_undo", "Taken back in 4 recordings.")
    assert {one: page.names(one) for one in "abcd"} == before


def test_phases_are_written_in_their_order_which_is_that_of_the_number_keys(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    page.name_first("a", "Rest")
    insert = {"name": "Insert", "color": "#26C397", "end": "contact", "repeated": True}
    reach = {"name": "Reach", "color": "#EFB63A", "end": "configuration"}
    page.say("phases", page.told["document"], name="assembly", phases=[reach, insert])
    page.wait_for(lambda: len(page.told["grid"]["phases"]) == 2)
    page.wait_for(lambda: len(page.told["document"]["labels"]) == 3)
    labels = [(one["name"], one["color"]) for one in page.told["document"]["labels"]]
    assert labels[:2] == [("Reach", "#EFB63A"), ("Insert", "#26C397")]
    assert labels[2][0] == "Rest"
    kept = read_folder_settings(tmp_path).tasks
    assert [(one.name, one.repeated) for one in kept[0].phases] == [
        ("Reach", False),
        ("Insert", True),
    ]
    page.say("phases", page.told["document"], name="assembly", phases=[reach, reach])
    page.wait_for(lambda: page.refused != [])
    assert "once" in page.refused[0]["text"]


def test_of_what_is_done_the_row_is_known_before_anybody_has_looked(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = GridPage(workbench, "one")
    page.watch("abcd")
    page.name_first("a", "Reach", done=True)
    workbench.close()
    copy = Path(shutil.copytree(tmp_path, tmp_path / "copy"))
    listed = Workbench([copy / "a.npz", copy / "b.npz"]).recordings.recordings
    assert [bool(line.stretches) for line in listed] == [True, False]
