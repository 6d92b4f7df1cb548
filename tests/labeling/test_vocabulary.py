"""The labels of a folder and what its recordings share."""

import pytest

from keyphase.errors import JournalError, LabelingError
from keyphase.labeling.storage.folder_settings import (
    FolderSettings,
    read_folder_settings,
    write_folder_settings,
)
from keyphase.labeling.vocabulary import (
    COLORS,
    MOST_LABELS,
    Vocabulary,
    VocabularyLabel,
    vocabulary_from_json,
)
from keyphase.segmentation.parameters import Parameters


@pytest.fixture(autouse=True)
def own_state(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def vocabulary(*names):
    words = Vocabulary()
    for name in names:
        words = words.with_label(name)
    return words


def test_each_new_label_takes_the_colour_least_used():
    words = vocabulary(*"abcdefgh")
    assert [label.color for label in words.labels] == [*COLORS, COLORS[0]]
    assert words.without_label("b").with_label("i").color("i") == COLORS[1]


def test_a_label_stands_in_the_vocabulary_once():
    words = vocabulary("insert")
    assert words.with_label("  insert ") is words
    assert words.with_label("") is words
    with pytest.raises(LabelingError, match="once"):
        Vocabulary((VocabularyLabel("a", COLORS[0]), VocabularyLabel("a", COLORS[1])))


def test_a_vocabulary_has_an_end():
    words = vocabulary(*map(str, range(MOST_LABELS)))
    assert words.with_label("one more") is words


def test_completion_puts_beginnings_first():
    words = vocabulary("Move down", "move up", "remove", "insert")
    assert words.completions("MOVE") == ("Move down", "move up", "remove")
    assert words.completions("") == ("Move down", "move up", "remove", "insert")
    assert words.completions("x") == ()


@pytest.mark.parametrize(
    "content",
    [
        None,
        {},
        ["a"],
        [{"name": "a"}],
        [{"name": "a", "color": 3}],
        [{"name": "", "color": "#000000"}],
        [{"name": "a\nb", "color": "#000000"}],
        [{"name": "a", "color": "red;}</style>"}],
        [{"name": "a", "color": "#000000", "more": "x"}],
    ],
)
def test_a_malformed_vocabulary_is_refused(content):
    with pytest.raises(LabelingError):
        vocabulary_from_json(content)


def test_settings_of_a_folder_are_there_again(tmp_path):
    settings = FolderSettings(vocabulary("insert “peg”"), Parameters(force_ratio=5.0))
    write_folder_settings(tmp_path, settings)
    assert read_folder_settings(tmp_path) == settings


def test_a_folder_without_settings_has_the_defaults(tmp_path):
    assert read_folder_settings(tmp_path) == FolderSettings()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "data",
    [b"", b"[]", b"{", b'{"version": 2}', b'{"version": 1, "labels": [], "parameters": {"x": 1}}'],
)
def test_damaged_settings_give_the_defaults_and_a_notice(tmp_path, data):
    write_folder_settings(tmp_path, FolderSettings())
    (tmp_path / ".keyphase" / "folder.json").write_bytes(data)
    settings = read_folder_settings(tmp_path)
    assert settings.parameters == Parameters()
    assert settings.notice is not None
    assert "folder.json" in settings.notice


def test_settings_of_a_folder_that_cannot_be_written_are_kept_with_the_user(tmp_path):
    folder = tmp_path / "recordings"
    folder.mkdir()
    (folder / ".keyphase").write_text("in the way")
    settings = FolderSettings(vocabulary("insert"))
    write_folder_settings(folder, settings)
    assert read_folder_settings(folder) == settings
    assert list((tmp_path / "state").rglob("folder.json"))


def test_settings_that_can_be_written_nowhere_are_refused(tmp_path):
    (tmp_path / ".keyphase").write_text("in the way")
    (tmp_path / "state").write_text("in the way")
    with pytest.raises(JournalError, match="neither"):
        write_folder_settings(tmp_path, FolderSettings())
