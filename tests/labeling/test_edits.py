"""Edits come from browsers and journals as JSON, and nothing else gets through."""

import json

import msgspec
import pytest
from handmade import segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import (
    MAX_PLAN_LENGTH,
    Accept,
    AcceptLabels,
    Add,
    BringBack,
    Contact,
    DropIdle,
    Edit,
    Forget,
    Keep,
    Label,
    Merge,
    Move,
    Plan,
    Remove,
    Reset,
    TakeOver,
    edit_as_json,
    edit_from_json,
)
from keyphase.labeling.label import label

EVERY_KIND = [
    Add(1.5),
    Add(1.5, True),
    Remove(2.0),
    Move(1.0, 2.0),
    Label(1.0, "insert “peg” <b>"),
    Label(1.0, "", (0.5, 1.5)),
    Keep(1.0, False, (0.5, 1.5)),
    Contact(1.0, True),
    Accept(1.0),
    Merge(1.0, 2.0),
    Plan((1.0, 2.0, 1.0)),
    Plan((1.0,), ((0.5, 1.5),), ((2.0, 3.0),)),
    DropIdle(),
    AcceptLabels(),
    AcceptLabels((Label(1.0, "a", (0.5, 1.5)),)),
    BringBack(3),
    Forget(0),
    Reset(),
    TakeOver("anna.segments.json", (Remove(1.0), Add(2.0, True), Label(1.0, "a"), Keep(1.0, True))),
]


@pytest.mark.parametrize("edit", EVERY_KIND, ids=repr)
def test_every_edit_survives_json(edit):
    assert edit_from_json(json.loads(json.dumps(edit_as_json(edit)))) == edit


def test_whole_numbers_are_times_too():
    assert edit_from_json({"kind": "add", "time_s": 2}) == Add(2.0)


def test_spaces_around_a_label_are_not_part_of_it():
    assert edit_from_json({"kind": "label", "time_s": 1, "label": "  a b "}) == Label(1.0, "a b")


@pytest.mark.parametrize(
    "content",
    [
        None,
        [],
        "add",
        {},
        {"kind": None},
        {"kind": "format_disk"},
        {"kind": "add"},
        {"kind": "add", "time_s": "1"},
        {"kind": "add", "time_s": True},
        {"kind": "add", "time_s": None},
        {"kind": "add", "time_s": float("nan")},
        {"kind": "add", "time_s": float("inf")},
        {"kind": "add", "time_s": 1e300},
        {"kind": "add", "time_s": 10**400},
        {"kind": "add", "time_s": 1.0, "__class__": "x"},
        {"kind": "add", "time_s": 1.0, "contact_change": 1},
        {"kind": "keep", "time_s": 1.0, "kept": "yes"},
        {"kind": "label", "time_s": 1.0, "label": 3},
        {"kind": "label", "time_s": 1.0, "label": "x" * 201},
        {"kind": "label", "time_s": 1.0, "label": "a\nb"},
        {"kind": "label", "time_s": 1.0, "label": "\ud800"},
        {"kind": "label", "time_s": 1.0, "label": "a", "span_s": [1.0]},
        {"kind": "accept_labels", "labels": [{"time_s": 1.0, "label": "a\x00"}]},
        {"kind": "plan", "order": "1"},
        {"kind": "plan", "order": [1.0, None]},
        {"kind": "plan", "order": [float("nan")]},
        {"kind": "plan", "order": [1.0], "spans_s": []},
        {"kind": "plan", "order": [1.0] * (MAX_PLAN_LENGTH + 1)},
        {"kind": "bring_back", "edit": -1},
        {"kind": "bring_back", "edit": 1.5},
        {"kind": "reset", "time_s": 1.0},
        {"kind": "take_over", "source": "a", "edits": [{"kind": "reset"}]},
        {
            "kind": "take_over",
            "source": "a",
            "edits": [{"kind": "label", "time_s": 1, "label": "a\nb"}],
        },
        {"kind": "take_over", "source": "a", "edits": [{"kind": "add", "time_s": float("nan")}]},
    ],
    ids=lambda content: repr(content)[:60],
)
def test_anything_else_is_refused_with_a_reason(content):
    with pytest.raises(LabelingError, match=r"\w+ \w+"):
        edit_from_json(content)


@pytest.mark.parametrize("edit", EVERY_KIND, ids=repr)
def test_every_kind_of_edit_has_a_name_that_says_more_than_its_kind(edit):
    name = edit.step_name(label(segmentation()))
    assert name[0].isupper()
    assert " " in name


def test_an_edit_inside_a_message_is_parsed_with_the_message():
    class Message(msgspec.Struct):
        edit: Edit

    message = msgspec.json.decode(
        b'{"edit": {"kind": "move", "from_s": 1, "to_s": 2}}', type=Message
    )
    assert message.edit == Move(1.0, 2.0)
