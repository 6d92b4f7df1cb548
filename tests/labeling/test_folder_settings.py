"""What all recordings of a folder share, and what is left of it when its file was damaged."""

import json
import multiprocessing
from dataclasses import replace

import pytest

from keyphase.errors import JournalError
from keyphase.labeling.storage.folder_settings import (
    FolderSettings,
    change_folder_settings,
    read_folder_settings,
)
from keyphase.labeling.vocabulary import Vocabulary
from keyphase.segmentation.parameters import Parameters


@pytest.fixture(autouse=True)
def own_state(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def learn(*names):
    """The change that puts names into the vocabulary."""

    def change(settings):
        vocabulary = settings.vocabulary
        for name in names:
            vocabulary = vocabulary.with_label(name)
        return replace(settings, vocabulary=vocabulary)

    return change


def names(settings):
    return [label.name for label in settings.vocabulary.labels]


def spoil(folder, change):
    """Change the JSON values on disk by hand."""
    path = folder / ".keyphase" / "folder.json"
    content = json.loads(path.read_bytes())
    change(content)
    path.write_text(json.dumps(content))
    return path


def test_settings_of_a_folder_are_there_again(tmp_path):
    change_folder_settings(tmp_path, learn("insert “peg”"))
    settings = change_folder_settings(
        tmp_path, lambda s: replace(s, parameters=Parameters(merge_tolerance_s=0.2))
    )
    assert read_folder_settings(tmp_path) == settings
    assert names(settings) == ["insert “peg”"]
    assert settings.parameters.merge_tolerance_s == 0.2


def test_a_folder_without_settings_has_the_defaults(tmp_path):
    assert read_folder_settings(tmp_path) == FolderSettings()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("data", [b"", b"[]", b"{", b"\xff", b"[" * 100_000])
def test_settings_of_which_nothing_can_be_read_are_kept_before_others_are_written(tmp_path, data):
    change_folder_settings(tmp_path, learn("a"))
    path = tmp_path / ".keyphase" / "folder.json"
    path.write_bytes(data)
    settings = read_folder_settings(tmp_path)
    assert settings.parameters == Parameters()
    assert "folder.json" in (settings.notice or "")
    assert path.read_bytes() == data
    after = change_folder_settings(tmp_path, learn("b"))
    assert "folder.old-1" in (after.notice or "")
    assert path.with_suffix(".old-1").read_bytes() == data
    assert names(read_folder_settings(tmp_path)) == ["b"]


@pytest.mark.parametrize(
    ("damage", "left", "ratio"),
    [
        (lambda text: text[: text.index('"c"')], ["a", "b"], 20.0),
        (lambda text: text[: text.index('"force_ratio"') + 16], ["a", "b", "c"], 20.0),
        (lambda text: text[: text.index('"min_distance_s"')], ["a", "b", "c"], 7.0),
        (lambda text: text.replace('"b"', '"b'), ["a", "c"], 7.0),
        (lambda text: text.replace('"labels"', "<<<<<<< mine"), ["a", "b", "c"], 7.0),
        (lambda text: text.replace("7.0", "9" * 5000), ["a", "b", "c"], 20.0),
        (lambda text: text.replace("7.0", "[" * 9999 + "]" * 9999), ["a", "b", "c"], 20.0),
    ],
)
def test_of_settings_that_are_no_json_any_more_what_is_whole_is_kept(tmp_path, damage, left, ratio):
    change_folder_settings(tmp_path, learn("a", "b", "c"))
    change_folder_settings(tmp_path, lambda s: replace(s, parameters=Parameters(force_ratio=7.0)))
    path = tmp_path / ".keyphase" / "folder.json"
    path.write_text(damage(path.read_text()))
    damaged = path.read_bytes()
    after = change_folder_settings(tmp_path, learn("d"))
    assert names(read_folder_settings(tmp_path)) == [*left, "d"]
    assert after.parameters.force_ratio == ratio
    assert path.with_suffix(".old-1").read_bytes() == damaged


def test_settings_of_a_later_version_that_were_cut_are_not_written_over(tmp_path):
    change_folder_settings(tmp_path, learn("a"))
    path = tmp_path / ".keyphase" / "folder.json"
    path.write_text('{"version": 2, "labels": [{"name": "b", "color": "#')
    with pytest.raises(JournalError, match="later version"):
        change_folder_settings(tmp_path, learn("c"))


def test_settings_of_millions_of_values_are_not_unfolded(tmp_path):
    change_folder_settings(tmp_path, learn("a"))
    path = tmp_path / ".keyphase" / "folder.json"
    path.write_text('{"version": 1, "more": [' + "[]," * 1_000_000 + "[]]}")
    assert "more than the 100000" in (read_folder_settings(tmp_path).notice or "")


@pytest.mark.parametrize(
    ("change", "left", "told"),
    [
        (lambda c: c["labels"][1].update(color="red"), ["a", "b", "c"], "colour of “b”"),
        (lambda c: c["labels"][1].update(color=7), ["a", "b", "c"], "colour of “b”"),
        (lambda c: c["labels"][1].update(name="x\ud800"), ["a", "c"], "label 2"),
        (lambda c: c["labels"].insert(1, None), ["a", "b", "c"], "label 2"),
        (lambda c: c.update(labels=7), [], "the labels"),
        (lambda c: c["parameters"].update(force_threshold=10**400), ["a", "b", "c"], "force_thr"),
        (lambda c: c["parameters"].update(dance=1), ["a", "b", "c"], "dance"),
        (lambda c: c.update(parameters=[]), ["a", "b", "c"], "the parameters"),
    ],
)
def test_what_is_damaged_costs_only_itself(tmp_path, change, left, told):
    change_folder_settings(tmp_path, learn("a", "b", "c"))
    path = spoil(tmp_path, change)
    spoilt = path.read_bytes()
    settings = read_folder_settings(tmp_path)
    assert names(settings) == left
    assert told in (settings.notice or "")
    after = change_folder_settings(tmp_path, learn("d"))
    assert names(after) == [*left, "d"]
    assert path.with_suffix(".old-1").read_bytes() == spoilt


def test_a_number_beyond_floats_costs_only_its_parameter(tmp_path):
    change_folder_settings(
        tmp_path,
        lambda s: replace(s, parameters=Parameters(merge_tolerance_s=0.2, force_ratio=7.0)),
    )
    path = tmp_path / ".keyphase" / "folder.json"
    path.write_text(path.read_text().replace("7.0", "1e400"))
    settings = read_folder_settings(tmp_path)
    assert settings.parameters == Parameters(merge_tolerance_s=0.2)
    assert "force_ratio" in (settings.notice or "")


@pytest.mark.parametrize("version", [2, 1.5, "2", "two"])
def test_settings_of_a_later_version_are_used_as_far_as_possible_and_never_written_over(
    tmp_path, version
):
    change_folder_settings(tmp_path, learn("a"))
    path = spoil(tmp_path, lambda c: c.update(version=version, more={"x": 1}))
    later = path.read_bytes()
    settings = read_folder_settings(tmp_path)
    assert names(settings) == ["a"]
    assert f"version {version!r}" in (settings.notice or "")
    with pytest.raises(JournalError, match="later version"):
        change_folder_settings(tmp_path, learn("b"))
    assert path.read_bytes() == later


def test_fields_this_version_does_not_know_stay(tmp_path):
    change_folder_settings(tmp_path, learn("a"))
    path = spoil(tmp_path, lambda c: c.update(more={"x": 1}))
    change_folder_settings(tmp_path, learn("b"))
    assert json.loads(path.read_bytes())["more"] == {"x": 1}


def _write_names(folder, first):
    for number in range(20):
        change_folder_settings(folder, learn(f"{first}{number}"))


@pytest.mark.slow
def test_two_programs_that_write_at_once_lose_nothing(tmp_path):
    context = multiprocessing.get_context("fork")
    writers = [context.Process(target=_write_names, args=(tmp_path, first)) for first in "ab"]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join()
    assert set(names(read_folder_settings(tmp_path))) == {
        f"{first}{number}" for first in "ab" for number in range(20)
    }


def test_settings_of_a_folder_that_cannot_be_written_are_kept_with_the_user(tmp_path):
    folder = tmp_path / "recordings"
    folder.mkdir()
    (folder / ".keyphase").write_text("in the way")
    settings = change_folder_settings(folder, learn("insert"))
    assert read_folder_settings(folder) == settings
    assert list((tmp_path / "state").rglob("folder.json"))


def test_settings_that_can_be_written_nowhere_are_refused(tmp_path):
    (tmp_path / ".keyphase").write_text("in the way")
    (tmp_path / "state").write_text("in the way")
    with pytest.raises(JournalError, match="neither"):
        change_folder_settings(tmp_path, learn("a"))


def test_settings_with_vocabulary_are_equal_however_they_were_made(tmp_path):
    change_folder_settings(tmp_path, lambda s: replace(s, vocabulary=Vocabulary().with_label("a")))
    assert read_folder_settings(tmp_path) == change_folder_settings(tmp_path, learn("a"))
