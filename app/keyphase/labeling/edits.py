"""Edits: what a person did to a segmentation, anchored in time, and their JSON form.

An edit first says what a person wants (`Label(4.2, "insert")`). `anchored` completes it with what
it needs to find its place again when thresholds have moved: exact times of boundaries, spans of
segments. The optional fields here are those.
"""

import math
import unicodedata
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, ClassVar

import msgspec

from keyphase.errors import LabelingError

Span = tuple[float, float]
"""Start and end of a segment when it was edited [s]."""

LONGEST_LABEL = 200
"""Characters."""

LONGEST_PLAN = 10_000
"""Entries."""

TAKEN_OVER = ("remove", "add", "contact", "label", "keep", "plan")
"""Kinds of edits of which taking over consists."""

MOST_TAKEN_OVER = 100_000

_FARTHEST_S = 1e10
_NOT_TEXT = frozenset({"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"})


@dataclass(frozen=True)
class Add:
    """Put a boundary at `time_s`; None for contact change: as the force there says."""

    kind: ClassVar[str] = "add"
    time_s: float
    contact_change: bool | None = None


@dataclass(frozen=True)
class Remove:
    """Take the boundary at `time_s` away."""

    kind: ClassVar[str] = "remove"
    time_s: float


@dataclass(frozen=True)
class Move:
    """Move the boundary at `from_s` to `to_s`."""

    kind: ClassVar[str] = "move"
    from_s: float
    to_s: float


@dataclass(frozen=True)
class Label:
    """Name the segment around `time_s`; an empty label gives it back the proposed one."""

    kind: ClassVar[str] = "label"
    time_s: float
    label: str
    span_s: Span | None = None


@dataclass(frozen=True)
class Keep:
    """Keep or drop the segment around `time_s`."""

    kind: ClassVar[str] = "keep"
    time_s: float
    kept: bool
    span_s: Span | None = None


@dataclass(frozen=True)
class Contact:
    """Say whether the boundary at `time_s` is a contact change."""

    kind: ClassVar[str] = "contact"
    time_s: float
    contact_change: bool


@dataclass(frozen=True)
class Accept:
    """The boundary at `time_s` has been seen and found right."""

    kind: ClassVar[str] = "accept"
    time_s: float


@dataclass(frozen=True)
class Merge:
    """Make one segment of all from `from_s` to `to_s`: every boundary strictly between goes."""

    kind: ClassVar[str] = "merge"
    from_s: float
    to_s: float


@dataclass(frozen=True)
class Plan:
    """Execute the segments around these times, in this order; a time may come again.

    spans_s     the segments' spans, one for each time
    left_out_s  spans of the kept segments that are not to be executed
    """

    kind: ClassVar[str] = "plan"
    order: tuple[float, ...]
    spans_s: tuple[Span, ...] | None = None
    left_out_s: tuple[Span, ...] = ()


@dataclass(frozen=True)
class DropIdle:
    """Drop every idle segment."""

    kind: ClassVar[str] = "drop_idle"


@dataclass(frozen=True)
class AcceptLabels:
    """Take the proposed label of every kept segment as it stands; `labels` is what they were."""

    kind: ClassVar[str] = "accept_labels"
    labels: tuple[Label, ...] | None = None


@dataclass(frozen=True)
class BringBack:
    """Make edit number `edit`, whose place is gone, apply again by adding its boundaries."""

    kind: ClassVar[str] = "bring_back"
    edit: int


@dataclass(frozen=True)
class Forget:
    """Leave out edit number `edit`, whose place is gone, from now on."""

    kind: ClassVar[str] = "forget"
    edit: int


@dataclass(frozen=True)
class Reset:
    """Back to what the program found; all edits before count no more."""

    kind: ClassVar[str] = "reset"


@dataclass(frozen=True)
class TakeOver:
    """Take over another's segmentation of this recording; edits before count no more.

    source  where it came from, for people
    edits   what makes it of the automatic segmentation, in order; see `taking_over`
    """

    kind: ClassVar[str] = "take_over"
    source: str
    edits: tuple["Edit", ...]


Edit = (
    Add
    | Remove
    | Move
    | Label
    | Keep
    | Contact
    | Accept
    | Merge
    | Plan
    | DropIdle
    | AcceptLabels
    | BringBack
    | Forget
    | Reset
    | TakeOver
)

_KINDS: Mapping[str, type[Edit]] = {
    edit.kind: edit
    for edit in (
        Add,
        Remove,
        Move,
        Label,
        Keep,
        Contact,
        Accept,
        Merge,
        Plan,
        DropIdle,
        AcceptLabels,
        BringBack,
        Forget,
        Reset,
        TakeOver,
    )
}


def edit_as_json(edit: Edit) -> dict[str, Any]:
    """The edit as JSON values: its kind and its fields, None left out."""
    if isinstance(edit, TakeOver):
        edits = [edit_as_json(each) for each in edit.edits]
        return {"kind": edit.kind, "source": edit.source, "edits": edits}
    content = asdict(edit, dict_factory=lambda items: {k: v for k, v in items if v is not None})
    return {"kind": edit.kind, **content}


def edit_from_json(content: Any) -> Edit:
    """The edit that JSON values describe.

    Raises LabelingError where kind or fields are unknown, missing, of another type, not finite,
    or too long.
    """
    if not isinstance(content, Mapping) or not isinstance(content.get("kind"), str):
        raise LabelingError("An edit must be an object with a kind, such as {kind: add, time_s: 1}")
    kind = _KINDS.get(content["kind"])
    if kind is None:
        raise LabelingError(
            f"Expected an edit of one of the kinds {', '.join(_KINDS)}, "
            f"but got {content['kind'][:40]!r}."
        )
    values = {key: value for key, value in content.items() if key != "kind"}
    return _taken_over(values) if kind is TakeOver else _checked(kind, values)


def check_label(label: str) -> str:
    """The label without surrounding spaces.

    Raises LabelingError where it is too long or holds anything but text, such as line breaks and
    marks that turn the writing direction.
    """
    label = label.strip()
    if len(label) > LONGEST_LABEL:
        raise LabelingError(
            f"A label has at most {LONGEST_LABEL} characters, but this one has {len(label)}; "
            "shorten it."
        )
    strange = next((c for c in label if unicodedata.category(c) in _NOT_TEXT), None)
    if strange is not None:
        raise LabelingError(
            f"A label must be plain text in one line, but this one holds U+{ord(strange):04X}; "
            "leave that character out."
        )
    return label


def _taken_over(values: dict[str, Any]) -> TakeOver:
    source, edits = values.get("source"), values.get("edits")
    if set(values) != {"source", "edits"} or not isinstance(source, str):
        raise LabelingError("An edit of kind take_over has a source and edits, and nothing else.")
    if not isinstance(edits, list | tuple) or len(edits) > MOST_TAKEN_OVER:
        raise LabelingError(f"An edit of kind take_over has at most {MOST_TAKEN_OVER} edits.")
    kinds = [each.get("kind") if isinstance(each, Mapping) else None for each in edits]
    strange = next((kind for kind in kinds if kind not in TAKEN_OVER), None)
    if strange is not None or None in kinds:
        raise LabelingError(
            f"An edit of kind take_over holds edits of the kinds {', '.join(TAKEN_OVER)} only."
        )
    return TakeOver(check_label(source), tuple(map(edit_from_json, edits)))


def _checked(kind: type[Edit], values: dict[str, Any]) -> Edit:
    unknown = values.keys() - {field.name for field in fields(kind)}
    if unknown:
        raise LabelingError(
            f"An edit of kind {kind.kind} has no field {sorted(map(str, unknown))[0][:40]!r}."
        )
    try:
        edit = msgspec.convert(values, kind)
    except msgspec.ValidationError as error:
        raise LabelingError(f"An edit of kind {kind.kind} is malformed: {error}.") from error
    return _with_checked_values(edit)


def _with_checked_values(edit: Edit) -> Edit:
    if not all(math.isfinite(t) and abs(t) <= _FARTHEST_S for t in _times(asdict(edit))):
        raise LabelingError(f"The times of an edit of kind {edit.kind} must be finite seconds.")
    match edit:
        case Label(time_s, label, span_s):
            return Label(time_s, check_label(label), span_s)
        case AcceptLabels(labels) if labels is not None:
            return AcceptLabels(
                tuple(Label(e.time_s, check_label(e.label), e.span_s) for e in labels)
            )
        case Plan(order, spans_s) if len(order) > LONGEST_PLAN or (
            spans_s is not None and len(spans_s) != len(order)
        ):
            raise LabelingError(
                f"A plan has at most {LONGEST_PLAN} entries and a span for each or none, but this "
                f"one has {len(order)}."
            )
        case BringBack(number) | Forget(number) if number < 0:
            raise LabelingError(f"Edits are counted from 0, but edit {number} was named.")
    return edit


def _times(value: Any) -> list[float]:
    if isinstance(value, float):
        return [value]
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list | tuple):
        return [time for item in value for time in _times(item)]
    return []
