"""The labels of a folder and what its recordings share."""

import pytest

from keyphase.errors import LabelingError
from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.vocabulary import (
    MAX_LABELS,
    Vocabulary,
    VocabularyLabel,
)


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
    assert [label.color for label in words.labels] == [*SEGMENT_COLORS, SEGMENT_COLORS[0]]
    assert words.without_label("b").with_label("i").color("i") == SEGMENT_COLORS[1]


def test_a_label_stands_in_the_vocabulary_once():
    words = vocabulary("insert")
    assert words.with_label("  insert ") is words
    assert words.with_label("") is words
    with pytest.raises(LabelingError, match="once"):
        Vocabulary(
            (VocabularyLabel("a", SEGMENT_COLORS[0]), VocabularyLabel("a", SEGMENT_COLORS[1]))
        )


def test_a_vocabulary_has_an_end():
    words = vocabulary(*map(str, range(MAX_LABELS)))
    assert words.with_label("one more") is words


@pytest.mark.parametrize(
    ("name", "color"),
    [("", "#000000"), ("a\nb", "#000000"), (" a", "#000000"), ("a", "red;}</style>"), ("a", "")],
)
def test_a_malformed_label_is_refused(name, color):
    with pytest.raises(LabelingError):
        VocabularyLabel(name, color)
