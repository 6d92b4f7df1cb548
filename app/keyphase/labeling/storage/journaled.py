"""What a journal's records say: the recording they are about, its history, whether it is done."""

from bisect import bisect_right
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any

from keyphase import __version__
from keyphase.demonstration import Demonstration
from keyphase.errors import JournalError, KeyphaseError
from keyphase.labeling.edits import edit_as_json, edit_from_json
from keyphase.labeling.history import FolderChange, History, ParameterChange, Step
from keyphase.labeling.storage.records import Record
from keyphase.segmentation.parameters import Parameters, parameters_before_variant

FORMAT = 2
"""Version of the records; a change that old readers cannot follow raises it. 2: what was seen when
a recording was done is kept."""

_WITHOUT_VARIANT = 1
_MAX_NUMBER = 2**53
_MAX_NAME_LENGTH = 300


@dataclass(frozen=True)
class Journaled:
    """The state a journal leads to.

    name         of the recording then
    sha256       of the recording when a person last agreed to it; None in an empty journal
    own_before   parameters of this recording alone that an older version had without saying so
    done_before  it was finished by a version that did not keep what was seen
    recipe       name and SHA-256 of the recipe it was read with then; None where nobody wrote that
    refused      how many whole records could not be understood
    """

    sha256: str | None = None
    history: History = field(default_factory=History)
    next_number: int = 0
    own_before: Mapping[str, Any] = field(default_factory=dict)
    done_before: bool = False
    recipe: Mapping[str, Any] | None = None
    refused: int = 0
    name: str = ""


def state_after(records: Iterable[Record]) -> Journaled:
    """The state that records, in order, lead to.

    Steps name the step they followed and undo and redo the step they led to, always as the
    number of that step, so a record that is lost costs no other. Raises JournalError for records
    of a later format.
    """
    following = _Following()
    earlier = False
    for record in records:
        try:
            earlier = earlier or record.get("format") == _WITHOUT_VARIANT
            following.follow(_as_of_now(record) if earlier else record)
        except JournalError:
            raise
        except (KeyphaseError, ArithmeticError, LookupError, TypeError, ValueError):
            following.refused += 1
    return following.state()


def opening(demonstration: Demonstration) -> Record:
    """The record of the recording that a journal is about, as it is now."""
    source = demonstration.source
    assert source is not None
    return {
        "op": "recording",
        "format": FORMAT,
        "software": f"keyphase {__version__}",
        "name": source.path.name,
        "sha256": source.sha256,
        "recipe": {"name": source.recipe, "sha256": source.recipe_sha256},
    }


def changes(before: History, after: History, next_number: int) -> list[Record]:
    """The records that lead from one history to another whose new steps count from a number."""
    records: list[Record] = []
    at = _number(before.last_done)
    for place, step in enumerate(after.steps):
        if step.number >= next_number:
            records.append(_step(step, after.steps[place - 1] if place else None))
            at = step.number
    if at != _number(after.last_done):
        records.append({"op": "at", "number": _number(after.last_done)})
    return records


def compact(state: Journaled, first: Record) -> list[Record]:
    """The fewest records that lead to a state again, after `first` about the recording."""
    recording = {**first, "sha256": state.sha256 or first["sha256"], "next": state.next_number}
    if state.sha256 is not None:
        recording["recipe"] = state.recipe
    if state.own_before:
        recording["own"] = dict(state.own_before)
    empty = History()
    return [
        recording,
        *changes(empty, state.history, next_number=0),
        *([{"op": "done", "done": True}] if state.done_before else []),
    ]


class _Following:
    """A journal while it is followed, record after record; the same time for each."""

    def __init__(self) -> None:
        self.refused = 0
        self._told = Journaled()
        self._steps: list[Step] = []
        self._numbers: list[int] = []
        self._position = 0
        self._next_number = 0

    def state(self) -> Journaled:
        """Where it has led to."""
        return replace(
            self._told,
            history=History(tuple(self._steps), self._position),
            next_number=max(self._told.next_number, self._next_number),
            refused=self.refused,
        )

    def follow(self, record: Record) -> None:
        """Raises JournalError for a later format, other errors for what is not understood."""
        match record["op"]:
            case "recording":
                self._told = _with_recording(self._told, record)
            case "step":
                self._take_step(record)
            case "at":
                self._position = self._after(record["number"])
            case "done":
                self._told = replace(self._told, done_before=bool(record["done"]))
            case _:
                raise ValueError("an operation this version does not know")

    def _take_step(self, record: Record) -> None:
        number = _whole(record["number"])
        step = Step(number, _plain(str(record["name"])), _change(record))
        position = self._after(record["after"])
        if position and number <= self._numbers[position - 1]:
            raise ValueError("numbers of steps ascend")
        del self._steps[position:], self._numbers[position:]
        self._steps.append(step)
        self._numbers.append(number)
        self._position = position + 1
        self._next_number = max(self._next_number, number + 1)

    def _after(self, number: Any) -> int:
        """How many steps are in force after step `number`; where it was lost, those before it."""
        return 0 if number is None else bisect_right(self._numbers, _whole(number))


def _with_recording(state: Journaled, record: Record) -> Journaled:
    if _whole(record["format"]) > FORMAT:
        name, software = (_plain(str(record.get(key))) for key in ("name", "software"))
        raise JournalError(
            f"The journal of {name} was written by {software}, in a "
            f"form that keyphase {__version__} cannot read; update keyphase."
        )
    number = max(state.next_number, _whole(record.get("next", 0)))
    own = _own(record.get("own", {}))
    recipe = record.get("recipe")
    return replace(
        state,
        name=_plain(str(record.get("name", ""))),
        sha256=str(record["sha256"]),
        next_number=number,
        own_before=own,
        recipe=recipe if isinstance(recipe, Mapping) else None,
    )


def _as_of_now(record: Record) -> Record:
    """A record from before there were variants of the method, when it was the paper's."""
    match record["op"]:
        case "recording":
            return {**record, "own": parameters_before_variant({})}
        case "step" if isinstance(record.get("parameters"), Mapping):
            return {**record, "parameters": parameters_before_variant(record["parameters"])}
        case _:
            return record


def _own(values: Any) -> dict[str, Any]:
    """Parameters of one recording. Raises KeyphaseError or ValueError where they cannot be."""
    known = {each.name for each in fields(Parameters)}
    if not isinstance(values, Mapping) or not known.issuperset(values):
        raise ValueError("parameters this version does not know")
    Parameters(**values)
    return dict(values)


def _whole(value: Any) -> int:
    """A number of a step. Raises ValueError for anything else."""
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= _MAX_NUMBER:
        raise ValueError("no number of a step")
    return value


def _plain(name: str) -> str:
    """A name of a step that a page can show, whatever the journal held."""
    return "".join(c if c.isprintable() else "?" for c in name[:_MAX_NAME_LENGTH])


def _change(record: Record) -> Any:
    if "edit" in record:
        return edit_from_json(record["edit"])
    return ParameterChange(_own(record["parameters"]), _folder_change(record.get("folder")))


def _folder_change(content: Any) -> FolderChange | None:
    """What was done to the whole folder; one that cannot be understood cannot be taken back."""
    if content is None:
        return None
    try:
        reopened = tuple(map(str, content["reopened"]))
        return FolderChange(_own(content["before"]), _own(content["after"]), reopened)
    except (KeyphaseError, ArithmeticError, LookupError, TypeError, ValueError):
        return None


def _step(step: Step, previous: Step | None) -> Record:
    shared = {
        "op": "step",
        "number": step.number,
        "after": _number(previous),
        "name": step.name,
    }
    if isinstance(step.change, ParameterChange):
        folder = step.change.folder
        whole = {"folder": asdict(folder)} if folder else {}
        return {**shared, "parameters": dict(step.change.own), **whole}
    return {**shared, "edit": edit_as_json(step.change)}


def _number(step: Step | None) -> int | None:
    return step.number if step else None
