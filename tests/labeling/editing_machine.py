"""A person at random: edits, sliders, undo, redo and restarts, and what must hold throughout."""

import tempfile
from itertools import pairwise
from pathlib import Path

import jsonschema
import numpy as np
from handmade import demonstration, described, segmentation
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from keyphase.errors import LabelingError
from keyphase.labeling.edits import (
    Accept,
    AcceptLabels,
    Add,
    AssessSegment,
    BringBack,
    Contact,
    DropIdle,
    DropPhase,
    Forget,
    Keep,
    Label,
    Merge,
    Move,
    NameStretch,
    Plan,
    Remove,
    RenamePhase,
    Reset,
    Ripple,
)
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import schema
from keyphase.labeling.segment_file_content import segment_file_content
from keyphase.labeling.storage.journal import Journal
from keyphase.segmentation.parameters import Parameters
from keyphase.transfer.as_edit import as_edit
from keyphase.transfer.own_boundaries import ProposedBoundary
from keyphase.transfer.proposing import ProposedPhase, Transfer

anywhere = st.floats(-0.5, 10.5, allow_nan=False)
names = st.text(max_size=12)


class Editing(RuleBasedStateMachine):
    """Any sequence of what a person can do."""

    @initialize()
    def open(self):
        self.folder = tempfile.TemporaryDirectory()
        self.demonstration = demonstration(path=Path(self.folder.name) / "demo.npz")
        self.journal = Journal(self.demonstration)
        self.document = self.journal.document

    def teardown(self):
        self.journal.close()
        self.folder.cleanup()

    @property
    def labeling(self):
        return label(found(self.document), self.document.edits, described)

    def save(self, document):
        self.journal.save(document)
        self.document = document

    def apply(self, edit):
        """Apply an edit; None where it is refused."""
        try:
            document = self.document.apply(edit, self.labeling)
        except LabelingError:
            return None
        self.save(document)
        return self.labeling

    def boundary_near(self, time_s):
        times = [boundary.time_s for boundary in self.labeling.boundaries]
        return min(times, key=lambda time: abs(time - time_s), default=time_s)

    @rule(time_s=anywhere, contact_change=st.none() | st.booleans())
    def add(self, time_s, contact_change):
        seen = self.apply(Add(time_s, contact_change))
        assert seen is None or time_s in [b.time_s for b in seen.boundaries]

    @rule(time_s=anywhere)
    def remove(self, time_s):
        time_s = self.boundary_near(time_s)
        seen = self.apply(Remove(time_s))
        assert seen is None or time_s not in [b.time_s for b in seen.boundaries]

    @rule(from_s=anywhere, by_s=st.floats(-2, 2))
    def move(self, from_s, by_s):
        from_s = self.boundary_near(from_s)
        seen = self.apply(Move(from_s, from_s + by_s))
        assert seen is None or from_s + by_s in [b.time_s for b in seen.boundaries]

    @rule(from_s=anywhere, by_s=st.floats(-2, 2))
    def move_with_all_later(self, from_s, by_s):
        from_s = self.boundary_near(from_s)
        later = [b.time_s for b in self.labeling.boundaries if b.time_s >= from_s]
        seen = self.apply(Ripple(from_s, by_s))
        if seen is not None:
            times = [b.time_s for b in seen.boundaries]
            assert [time + by_s for time in later] == times[len(times) - len(later) :]

    @rule(time_s=anywhere, name=names)
    def name(self, time_s, name):
        seen = self.apply(Label(time_s, name))
        if seen is not None and name.strip():
            named = seen.segments[seen.segment_at(time_s)]
            assert (named.label, named.proposed) == (name.strip(), False)

    @rule(from_s=anywhere, to_s=anywhere, name=names)
    def name_a_stretch(self, from_s, to_s, name):
        seen = self.apply(NameStretch(from_s, to_s, name))
        if seen is not None:
            low, high = sorted((max(from_s, 0.0), max(to_s, 0.0)))
            named = seen.segments[seen.segment_at(0.5 * (low + min(high, 10.0)))]
            assert (named.label, named.proposed) == (name.strip(), False)

    @rule(time_s=anywhere, outcome=st.sampled_from([None, "success", "failure"]), note=names)
    def mark(self, time_s, outcome, note):
        before = [(s.start_s, s.end_s, s.label, s.kept) for s in self.labeling.segments]
        seen = self.apply(AssessSegment(time_s, outcome, note=note))
        if seen is not None:
            assert seen.segments[seen.segment_at(time_s)].assessment.outcome == outcome
            assert [(s.start_s, s.end_s, s.label, s.kept) for s in seen.segments] == before

    @rule(time_s=anywhere, to_s=st.none() | anywhere, kept=st.booleans())
    def keep(self, time_s, to_s, kept):
        seen = self.apply(Keep(time_s, kept, to_s=to_s))
        for time in (time_s, time_s if to_s is None else to_s):
            assert seen is None or seen.segments[seen.segment_at(time)].kept == kept

    @rule(time_s=anywhere, contact_change=st.booleans())
    def judge(self, time_s, contact_change):
        self.apply(Contact(self.boundary_near(time_s), contact_change))

    @rule(time_s=anywhere)
    def accept(self, time_s):
        self.apply(Accept(self.boundary_near(time_s)))

    @rule(from_s=anywhere, to_s=anywhere)
    def merge(self, from_s, to_s):
        seen = self.apply(Merge(from_s, to_s))
        low, high = sorted((from_s, to_s))
        assert seen is None or not [b for b in seen.boundaries if low < b.time_s < high]

    @rule(data=st.data())
    def order(self, data):
        kept = [segment.middle_s for segment in self.labeling.segments if segment.kept]
        order = data.draw(st.lists(st.sampled_from(kept), max_size=8)) if kept else []
        seen = self.apply(Plan(tuple(order)))
        assert seen is not None
        assert [entry.time_s for entry in seen.plan] == order

    @rule(data=st.data(), to=names, step=st.sampled_from("ab"))
    def change_a_phase(self, data, to, step):
        label = data.draw(st.sampled_from([segment.label for segment in self.labeling.segments]))
        for edit in (RenamePhase(label, to, step), DropPhase(to.strip(), step)):
            seen = self.apply(edit)
            meant = [] if seen is None else [s for s in seen.segments if s.label == edit.label]
            assert not any(one.kept for one in meant)

    @rule(times=st.lists(st.integers(1, 99), max_size=6, unique=True), name=names)
    def take_over_a_proposal(self, times, name):
        times = sorted(time / 10.0 for time in times)
        seen = self.apply(as_edit(proposal(times, name), found(self.document)))
        assert seen is not None or not name.isprintable()
        if seen is not None:
            np.testing.assert_allclose([b.time_s for b in seen.boundaries], times, atol=2e-3)
            if name.strip():
                assert {segment.label for segment in seen.segments} == {name.strip()}

    @rule(edit=st.sampled_from([DropIdle(), AcceptLabels(), Reset()]))
    def decide_at_once(self, edit):
        self.apply(edit)

    @rule(kind=st.sampled_from([BringBack, Forget]), data=st.data())
    def settle_inapplicable(self, kind, data):
        lost = [each.edit for each in self.labeling.inapplicable]
        if lost:
            assert self.apply(kind(data.draw(st.sampled_from(lost)))) is not None

    @rule(
        force_ratio=st.integers(1, 8).map(float),
        gaussians=st.none() | st.integers(1, 3),
    )
    def move_sliders(self, force_ratio, gaussians):
        added = {edit.time_s for edit in self.document.edits.values() if isinstance(edit, Add)}
        added &= {boundary.time_s for boundary in self.labeling.boundaries}
        parameters = Parameters(force_ratio=force_ratio, gaussians=gaussians)
        self.save(self.document.set_parameters(parameters))
        after = self.labeling
        gone = added - {boundary.time_s for boundary in after.boundaries}
        assert len(gone) <= len(after.inapplicable)

    @rule()
    def reset_sliders(self):
        self.save(self.document.reset_parameters())
        assert self.document.parameters == Parameters()

    @rule(count=st.integers(1, 5))
    def undo(self, count):
        for _ in range(count):
            if self.document.undo_name is not None:
                self.save(self.document.undo())

    @rule(count=st.integers(1, 5))
    def redo(self, count):
        for _ in range(count):
            if self.document.redo_name is not None:
                self.save(self.document.redo())

    @rule()
    def restart(self):
        before, seen = self.document, view(self.labeling)
        self.journal.close()
        self.journal = Journal(self.demonstration)
        self.document = self.journal.document
        assert not self.journal.notices
        assert self.document.history == before.history
        assert self.document.parameters == before.parameters
        assert self.document.next_number == before.next_number
        assert view(self.labeling) == seen

    @rule()
    def export(self):
        path = Path(self.folder.name) / "demo.segments.json"
        jsonschema.validate(segment_file_content(self.labeling, path), schema())

    @invariant()
    def undo_then_redo_is_identity(self):
        if self.document.undo_name is not None:
            assert self.document.undo().redo().history == self.document.history

    @invariant()
    def segments_tile_the_recording(self):
        seen = self.labeling
        edges = [0.0, *(boundary.time_s for boundary in seen.boundaries), 10.0]
        assert all(a < b for a, b in pairwise(edges))
        assert [(s.start_s, s.end_s) for s in seen.segments] == list(pairwise(edges))
        assert all(b.interval_s[0] <= b.time_s <= b.interval_s[1] for b in seen.boundaries)
        assert len({segment.color for segment in seen.segments}) == len(seen.segments)

    @invariant()
    def the_plan_holds_kept_segments_that_exist(self):
        seen = self.labeling
        for entry in seen.plan:
            segment = seen.segments[entry.segment]
            assert segment.kept
            assert segment.start_s < entry.time_s < segment.end_s
        for index in seen.proposed_drops:
            assert seen.segments[index].idle
            assert not seen.segments[index].kept


def found(document):
    """What a program might find: boundaries come and go with one slider, wander with another."""
    strength = (3, 6, 2, 8, 5, 1, 7)
    wander = 0.07 * (document.parameters.gaussians or 0)
    times = [
        1.2 * (i + 1) + wander * (-1) ** i
        for i in range(len(strength))
        if strength[i] >= document.parameters.force_ratio / 2.5
    ]
    return segmentation(
        times,
        idle=range(1, len(times) + 1, 2),
        made_from=document.demonstration,
        parameters=document.parameters,
    )


def proposal(times, name):
    """What finished recordings might propose: boundaries at these times, phases of one name."""
    boundaries = tuple(ProposedBoundary(time, 0.8, False) for time in times)
    phases = tuple(
        ProposedPhase(start_s, end_s, name, True, 0.9)
        for start_s, end_s in pairwise([0.0, *times, 10.0])
    )
    return Transfer("demo", boundaries, phases, False, 0.2, ("taught",))


def view(labeling):
    """Everything a person sees of a labeling, to compare."""
    boundaries = [
        (b.time_s, b.origin, b.contact_change, b.was_s, b.accepted) for b in labeling.boundaries
    ]
    lost = [(each.edit, each.text) for each in labeling.inapplicable]
    return boundaries, labeling.segments, labeling.plan, labeling.proposed_drops, lost
