"""Done is done: what a person saw stays, whatever the program finds later."""

import json
from dataclasses import astuple, replace

import pytest
from handmade import Person, boundary, demonstration, labels, peak, plan, segmentation, times
from hypothesis import given
from hypothesis import strategies as st

from keyphase.errors import LabelingError
from keyphase.labeling.edits import (
    Accept,
    Add,
    Contact,
    Done,
    DropIdle,
    Keep,
    Label,
    Move,
    Plan,
    Remove,
    Reopen,
    edit_as_json,
    edit_from_json,
)
from keyphase.labeling.finished import changed_since_done
from keyphase.labeling.frozen import end_condition_as_json
from keyphase.labeling.segment_file import write_segment_file
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.storage.records import encode
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.parameters import Parameters

OTHERS = [
    segmentation(()),
    segmentation((1.0, 2.02, 3.0, 4.5, 6.1, 7.0, 8.0, 9.0)),
    segmentation((2.0, 4.0, 6.0, 8.0), idle=(0, 1, 2, 3, 4)),
    segmentation((5.0,), parameters=Parameters(force_ratio=3.0)),
]


def values(labeling):
    """All a person sees of a labeling, without the evidence behind it."""
    boundaries = [astuple(replace(each, automatic=None)) for each in labeling.boundaries]
    return boundaries, labeling.segments, labeling.plan, labeling.proposed_drops


def worked():
    """A person who has edited in every way that changes what is seen."""
    person = Person(segmentation(idle=(0, 3), peaks=(peak(7.0),)))
    person.makes(
        Move(4.0, 4.4),
        Remove(2.0),
        Add(1.0),
        Add(7.0),
        Contact(6.0, True),
        Accept(8.0),
        Label(5.0, "insert"),
        Keep(9.0, False),
        Plan((5.0, 0.5, 5.0)),
    )
    return person


@pytest.mark.parametrize("other", OTHERS, ids=range(len(OTHERS)))
def test_what_was_done_is_seen_again_over_any_other_result(other):
    person = worked()
    before = person.labeling
    person.makes(Done())
    seen = person.sees(other)
    assert values(seen) == values(before)
    assert seen.done
    assert not seen.changed_since_done


def test_done_survives_the_journals_json():
    person = worked()
    person.makes(Done())
    done = list(person.document.edits.values())[-1]
    assert edit_from_json(json.loads(json.dumps(edit_as_json(done)))) == done


def test_an_end_in_contact_that_was_frozen_is_equal_to_the_one_the_journal_gives_back():
    frozen = end_condition_as_json(ContactEnd((0.0, 0.0, 1.0), 2.0))
    assert json.loads(json.dumps(frozen)) == frozen


def test_the_segment_file_of_what_is_done_stays_the_same_to_the_byte(tmp_path):
    person = Person(segmentation(idle=(1,), made_from=demonstration(path=tmp_path / "a.npz")))
    person.makes(Label(5.0, "insert"), Done())
    write_segment_file(person.labeling, tmp_path / "before.segments.json")
    other = segmentation(
        (1.0, 5.0),
        made_from=person.segmentation.demonstration,
        parameters=Parameters(force_ratio=3.0),
    )
    write_segment_file(person.sees(other), tmp_path / "after.segments.json")
    before, after = (tmp_path / f"{name}.segments.json" for name in ("before", "after"))
    assert before.read_bytes() == after.read_bytes()


def test_undo_takes_done_back():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"), Done())
    assert person.document.undo_name == "Mark done"
    person.document = person.document.undo()
    assert not person.document.done
    assert times(person.sees(segmentation((1.0, 5.0)))) == [1.0, 5.0]


def test_an_edit_after_done_lies_over_what_was_frozen_and_says_so():
    person = Person(segmentation())
    person.makes(Done())
    person.sees(segmentation((1.0, 5.0)))
    seen = person.makes(Move(4.0, 4.5), Label(1.0, "reach"))
    assert times(seen) == [2.0, 4.5, 6.0, 8.0]
    assert labels(seen) == ["reach", "new", "new", "part 4", "part 5"]
    assert seen.done
    assert seen.changed_since_done
    assert changed_since_done(person.document.history)


def test_done_once_more_keeps_what_is_seen_by_then():
    person = Person(segmentation())
    person.makes(Done(), Remove(4.0), Done())
    seen = person.sees(segmentation((1.0, 5.0)))
    assert times(seen) == [2.0, 6.0, 8.0]
    assert not seen.changed_since_done
    assert not changed_since_done(person.document.history)


def test_opened_again_all_edits_lie_over_the_present_result():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"), Done(), Remove(8.0), Done(), Reopen())
    seen = person.sees(segmentation((2.0, 4.0, 6.0, 7.0, 8.0)))
    assert times(seen) == [2.0, 4.0, 6.0, 7.0]
    assert labels(seen)[2] == "insert"
    assert not seen.done


def test_a_plan_from_before_counts_again_when_opened_again():
    person = Person(segmentation())
    person.makes(Plan((5.0, 1.0)), Done(), Reopen())
    assert plan(person.labeling)[:2] == [2, 0]


def test_parameters_of_what_is_done_are_those_that_had_made_it():
    person = Person(segmentation())
    person.makes(Done())
    assert person.document.with_shared(Parameters(force_ratio=3.0)).parameters == Parameters()
    with pytest.raises(LabelingError, match="done"):
        person.document.set_parameters(Parameters(force_ratio=3.0))


def test_done_twice_and_opening_what_is_open_are_refused():
    person = Person(segmentation())
    with pytest.raises(LabelingError, match="not done"):
        person.makes(Reopen())
    person.makes(Done())
    with pytest.raises(LabelingError, match="done already"):
        person.makes(Done())


def test_boundaries_keep_their_evidence_where_the_program_still_finds_it():
    person = Person(segmentation())
    person.makes(Done())
    seen = person.sees(replace(segmentation(), boundaries=(boundary(4.0, confidence=0.1),)))
    assert [b.automatic is not None for b in seen.boundaries] == [False, True, False, False]
    assert seen.boundaries[1].confidence == 0.8


def test_a_journal_done_by_an_older_version_asks_to_be_frozen(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    demo = demonstration(path=tmp_path / "demo.npz")
    with Journal(demo) as journal:
        path = journal.path
    lines = [
        {
            "op": "recording",
            "format": 1,
            "software": "keyphase 0.1.0",
            "sha256": demo.source.sha256,
        },
        {
            "op": "step",
            "number": 0,
            "after": None,
            "name": "Add",
            "edit": {"kind": "add", "time_s": 3.0},
        },
        {"op": "done", "done": True},
    ]
    path.write_bytes(b"".join(map(encode, lines)))
    person = Person(segmentation(made_from=demo))
    with Journal(demo) as journal:
        assert journal.document.done
        assert journal.document.needs_freezing
        person.document = journal.document
        person.makes(Done())
        journal.save(person.document)
    with Journal(demo) as journal:
        assert journal.document.done
        assert not journal.document.needs_freezing
        person.document = journal.document
        assert times(person.sees(segmentation(()))) == [2.0, 3.0, 4.0, 6.0, 8.0]


@pytest.mark.parametrize(
    "change",
    [
        lambda frozen: frozen["segments"].clear(),
        lambda frozen: frozen["segments"].pop(),
        lambda frozen: frozen["boundaries"].reverse(),
        lambda frozen: frozen["boundaries"][0].update(time_s=float("nan")),
        lambda frozen: frozen["plan"].append(99),
        lambda frozen: frozen["segments"][0].update(end_condition={"kind": "contact"}),
    ],
)
def test_frozen_values_that_contradict_each_other_are_refused(change):
    person = Person(segmentation())
    person.makes(Done())
    content = json.loads(json.dumps(edit_as_json(person.document.edits[0])))
    change(content["frozen"])
    with pytest.raises(LabelingError):
        edit_from_json(content)


@given(
    found=st.lists(st.floats(0.1, 9.9), max_size=6, unique_by=lambda t: round(t, 1)),
    other=st.lists(st.floats(0.1, 9.9), max_size=6, unique_by=lambda t: round(t, 1)),
    named=st.floats(0.0, 10.0),
)
def test_whatever_was_found_and_is_found_later(found, other, named):
    person = Person(segmentation(tuple(sorted(found)), idle=(1,)))
    person.makes(Label(named, "mine"), *([DropIdle()] if found else []))
    before = person.labeling
    person.makes(Done())
    assert values(person.sees(segmentation(tuple(sorted(other))))) == values(before)
