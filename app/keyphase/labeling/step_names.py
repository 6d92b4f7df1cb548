"""What undo and redo call a step, such as "Move boundary 2" or "Threshold 23.9"."""

from collections.abc import Mapping

from keyphase.labeling.edits import (
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
)
from keyphase.labeling.labeling import Labeling

_LONGEST_SHOWN = 24

_PARAMETERS: Mapping[str, str] = {
    "force_threshold": "Threshold",
    "force_ratio": "Ratio",
    "min_distance_s": "Minimal distance",
    "persistence": "Persistence",
    "process_noise_ratio": "Process noise ratio",
    "measurement_noise": "Measurement noise",
    "engine": "Engine",
    "gaussians": "Gaussians",
    "variant": "Variant",
    "estimator": "Estimator",
    "seed": "Seed",
    "merge_tolerance_s": "Merge tolerance",
}


def edit_name(edit: Edit, labeling: Labeling) -> str:
    """Name of an anchored edit, its boundaries and segments numbered as they were seen."""
    match edit:
        case Add(time_s):
            return f"Add boundary at {time_s:.2f} s"
        case Remove(time_s):
            return f"Remove boundary {_boundary(time_s, labeling)}"
        case Move(from_s):
            return f"Move boundary {_boundary(from_s, labeling)}"
        case Contact(time_s, contact_change):
            what = "a contact change" if contact_change else "no contact change"
            return f"Boundary {_boundary(time_s, labeling)} is {what}"
        case Accept(time_s):
            return f"Accept boundary {_boundary(time_s, labeling)}"
        case Label(time_s, label) if label:
            return f"Label segment {_segment(time_s, labeling)} “{_short(label)}”"
        case Label(time_s):
            return f"Give segment {_segment(time_s, labeling)} its proposed label"
        case Keep(time_s, kept):
            return f"{'Keep' if kept else 'Drop'} segment {_segment(time_s, labeling)}"
        case Merge(from_s, to_s):
            return f"Merge segments {_segment(from_s, labeling)} to {_segment(to_s, labeling)}"
        case _:
            return _name_of_whole(edit, labeling)


def parameters_name(changes: Mapping[str, object]) -> str:
    """Name of a change of parameters, given the new value of each."""
    if len(changes) != 1:
        return f"Change {len(changes)} parameters"
    ((name, value),) = changes.items()
    return parameter_text(name, value)


def parameter_text(name: str, value: object) -> str:
    """A parameter and its value, such as "Gaussians 5" or "Threshold automatic"."""
    shown = "automatic" if value is None else f"{value:.4g}" if isinstance(value, float) else value
    return f"{_PARAMETERS.get(name, name)} {shown}"


def _name_of_whole(edit: Edit, labeling: Labeling) -> str:
    match edit:
        case Plan():
            return "Change the plan"
        case DropIdle():
            count = sum(
                s.idle and (s.kept or i in labeling.proposed_drops)
                for i, s in enumerate(labeling.segments)
            )
            return f"Drop {_count(count, 'idle segment')}"
        case AcceptLabels(labels):
            return f"Accept {_count(len(labels or ()), 'label')}"
        case BringBack():
            return "Bring back an edit"
        case Forget():
            return "Forget an edit"
        case Reset():
            return "Reset to automatic"
        case TakeOver(source):
            return f"Take over “{_short(source)}”"
        case _:
            return edit.kind


def _boundary(time_s: float, labeling: Labeling) -> int:
    return labeling.segment_at(time_s)


def _segment(time_s: float, labeling: Labeling) -> int:
    return labeling.segment_at(time_s) + 1


def _count(number: int, what: str) -> str:
    return f"{number} {what}" + ("" if number == 1 else "s")


def _short(label: str) -> str:
    return label if len(label) <= _LONGEST_SHOWN else f"{label[: _LONGEST_SHOWN - 1]}…"
