"""Phases of a task: written by a finished recording or typed, kept with the folder."""

import json
from dataclasses import replace

import pytest
from handmade import Person, segmentation

from keyphase.cli import main
from keyphase.errors import LabelingError
from keyphase.labeling.edits import Keep, Label
from keyphase.labeling.storage.folder_settings import change_folder_settings, read_folder_settings
from keyphase.labeling.tasks.task import Task, TaskPhase, task_of
from keyphase.workbench.desks.folder import Folder

REACH = TaskPhase("reach", "#58A2F2", "configuration")
INSERT = TaskPhase("insert", "#EFB63A", "contact", optional=True)
ASSEMBLY = Task("assembly", (REACH, INSERT))


@pytest.fixture(autouse=True)
def own_state(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


@pytest.fixture
def folder(tmp_path):
    """A folder that keeps a task."""
    folder = tmp_path / "recordings"
    folder.mkdir()
    change_folder_settings(folder, lambda settings: replace(settings, tasks=(ASSEMBLY,)))
    return folder


def test_a_finished_recording_shows_its_kept_phases_and_what_comes_again():
    person = Person(segmentation())
    person.makes(Label(1.0, "reach"), Label(3.0, "press"), Label(5.0, "press"), Keep(9.0, False))
    shown = task_of("assembly", person.labeling)
    assert [(phase.name, phase.repeated) for phase in shown.phases] == [
        ("reach", False),
        ("press", True),
        ("part 4", False),
    ]
    assert {phase.end for phase in shown.phases} == {"configuration"}


def test_the_first_finished_recording_writes_them_and_later_ones_leave_them(tmp_path):
    person = Person(segmentation())
    person.makes(Label(1.0, "reach"))
    Folder(tmp_path).show_task(person.labeling)
    first = read_folder_settings(tmp_path).tasks
    assert first[0].phases[0].name == "reach"
    person.makes(Label(1.0, "approach"))
    Folder(tmp_path).show_task(person.labeling)
    assert read_folder_settings(tmp_path).tasks == first


def test_tasks_of_a_folder_are_there_again(folder):
    assert read_folder_settings(folder).tasks == (ASSEMBLY,)


def test_a_damaged_phase_costs_only_itself(folder):
    path = folder / ".keyphase" / "folder.json"
    content = json.loads(path.read_bytes())
    content["phases"][0]["end"] = "magic"
    path.write_text(json.dumps(content))
    read = read_folder_settings(folder)
    assert read.tasks == (Task("assembly", (INSERT,)),)
    assert "phase 1" in (read.notice or "")


def test_phases_are_found_in_a_file_that_was_cut(folder):
    path = folder / ".keyphase" / "folder.json"
    path.write_bytes(path.read_bytes().rstrip()[:-6])
    read = read_folder_settings(folder)
    assert read.tasks[0].phases[0] == REACH
    assert read.vocabulary.labels == ()


@pytest.mark.parametrize("wrong", [{"end": "magic"}, {"color": "red"}, {"name": ""}])
def test_what_is_no_phase_is_refused(wrong):
    with pytest.raises(LabelingError):
        replace(REACH, **wrong)


def test_phases_are_typed_and_shown(tmp_path, capsys):
    def keyphase(*arguments):
        with pytest.raises(SystemExit) as ended:
            main(["phases", *map(str, arguments)])
        return ended.value.code, capsys.readouterr()

    code, told = keyphase(tmp_path, "--write", "reach", "insert:contact:optional")
    assert code == 0
    assert "insert" in told.out
    kept = read_folder_settings(tmp_path).tasks[0]
    assert [(p.name, p.end, p.optional) for p in kept.phases] == [
        ("reach", "configuration", False),
        ("insert", "contact", True),
    ]
    code, told = keyphase(tmp_path, "--write", "reach:magic")
    assert code == 1
    assert "magic" in told.err
    assert read_folder_settings(tmp_path).tasks == (kept,)
