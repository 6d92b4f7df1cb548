"""The document: a demonstration, parameters and the history of edits. Everything else follows."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.errors import LabelingError
from keyphase.labeling.edits import Edit, Reopen, edit_as_json, edit_from_json
from keyphase.labeling.finished import frozen_of, is_done, needs_freezing
from keyphase.labeling.frozen import Frozen
from keyphase.labeling.history import FolderChange, History, ParameterChange, Step
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.parameter_names import parameters_name
from keyphase.segmentation.parameters import Parameters

FOR_ALL = "Parameters for all recordings"
"""What a step is called that gives a folder other parameters, also where it opens a recording."""


@dataclass(frozen=True, eq=False)
class Document:
    """One demonstration under a person's hands; immutable, every change gives a new one.

    `shared` are the parameters of the folder; what was changed on this recording alone is in the
    history. `own_before` and `done_before` are what older versions had written: parameters of this
    recording alone, and that it was done, without what was seen.

    Its labeling is `label(segment(demonstration, parameters), edits)`.
    """

    demonstration: Demonstration
    shared: Parameters = field(default_factory=Parameters)
    history: History = field(default_factory=History)
    next_number: int = 0
    own_before: Mapping[str, Any] = field(default_factory=dict)
    done_before: bool = False

    @property
    def frozen(self) -> Frozen | None:
        """What was seen when a person finished with it; None where it is not done."""
        return frozen_of(self.history)

    @property
    def done(self) -> bool:
        """Whether a person has finished with it."""
        return is_done(self.history, done_before=self.done_before)

    @property
    def needs_freezing(self) -> bool:
        """Whether it was finished by a version that did not keep what was seen."""
        return needs_freezing(self.history, done_before=self.done_before)

    @property
    def edits(self) -> dict[int, Edit]:
        """The edits in force, by number, in the order they were made."""
        return {
            step.number: step.change
            for step in self.history.done
            if not isinstance(step.change, ParameterChange)
        }

    @property
    def own_parameters(self) -> Mapping[str, Any]:
        """The parameters in which this recording departs from its folder."""
        for step in reversed(self.history.done):
            if isinstance(step.change, ParameterChange):
                return step.change.own
        return self.own_before

    @property
    def parameters(self) -> Parameters:
        """The parameters in force; of a finished recording those that had made it."""
        frozen = self.frozen
        if frozen is not None:
            return frozen.made_with()
        return replace(self.shared, **self.own_parameters)

    @property
    def undo_name(self) -> str | None:
        """What undo would take back."""
        step = self.history.last_done
        return step.name if step else None

    @property
    def redo_name(self) -> str | None:
        """What redo would make again."""
        step = self.history.next_undone
        return step.name if step else None

    def apply(self, edit: Edit, labeling: Labeling) -> "Document":
        """With one edit more, as a person made it on `labeling`, which is this document's.

        What a journal could not read back is refused here, before it is confirmed. Raises
        LabelingError, with the reason, for an edit that cannot be made there.
        """
        complete = edit_from_json(edit_as_json(edit.anchored(labeling)))
        return self._with(complete.step_name(labeling), complete)

    def reopened(self, name: str = "Mark as not done") -> "Document":
        """With the mark that it is done taken away, as a step; the same where it is not done."""
        return self._with(name, Reopen()) if self.done else self

    def set_parameters(self, parameters: Parameters) -> "Document":
        """With other parameters for this recording; the same document where none differs."""
        self._refuse_if_done()
        before, after = asdict(self.parameters), asdict(parameters)
        changes = {name: after[name] for name in after if after[name] != before[name]}
        if not changes:
            return self
        change = ParameterChange({**self.own_parameters, **changes})
        return self._with(parameters_name(changes), change)

    def reset_parameters(self) -> "Document":
        """With the folder's parameters again; the same document where it has no others."""
        self._refuse_if_done()
        if not self.own_parameters:
            return self
        return self._with("Reset parameters", ParameterChange({}))

    def share_parameters(self, reopened: Sequence[str] = ()) -> "Document":
        """With the parameters in force as its folder's, and none of its own any more.

        The step says what the folder had before, so that taking it back can bring that back, and
        which recordings are `reopened` with it. The same document where nothing differs.
        """
        shared = self.with_shared(self.parameters)
        if not self.own_parameters and self.shared == self.parameters and not reopened:
            return shared
        folder = FolderChange(asdict(self.shared), asdict(self.parameters), tuple(reopened))
        return shared._with(FOR_ALL, ParameterChange({}, folder))

    def with_shared(self, shared: Parameters) -> "Document":
        """Under other parameters of the folder; not a step of this recording's history."""
        return replace(self, shared=shared)

    def undo(self) -> "Document":
        """With the last step taken back. Raises LabelingError where there is none."""
        return replace(self, history=self.history.undone())

    def redo(self) -> "Document":
        """With the next step made again. Raises LabelingError where there is none."""
        return replace(self, history=self.history.redone())

    def _refuse_if_done(self) -> None:
        if self.frozen is not None:
            raise LabelingError(
                "This recording is done, so its boundaries no longer follow the parameters; mark "
                "it as not done first."
            )

    def _with(self, name: str, change: Edit | ParameterChange) -> "Document":
        step = Step(self.next_number, name, change)
        history = self.history.with_step(step)
        return replace(self, history=history, next_number=self.next_number + 1)
