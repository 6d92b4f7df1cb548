"""A task: the ordered list of phases that its recordings go through."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Literal, get_args

from keyphase.errors import LabelingError
from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.labeling import LabeledSegment, Labeling
from keyphase.labeling.vocabulary import VocabularyLabel
from keyphase.segmentation.end_condition import ContactEnd

PhaseEnd = Literal["contact", "release", "configuration", "gripper"]
"""What a phase ends with: a force that rises, one that falls, a place, or what the gripper does."""

PHASE_ENDS: tuple[str, ...] = get_args(PhaseEnd)
MAX_PHASES = 500
"""All tasks of a folder together."""

_NEAR_S = 1e-3


@dataclass(frozen=True)
class TaskPhase:
    """A phase of a task: its name, colour (`#rrggbb`) and kind of end.

    optional  not every recording has it
    repeated  a recording may have it several times, one after another

    Raises LabelingError for another form of any.
    """

    name: str
    color: str
    end: PhaseEnd
    optional: bool = False
    repeated: bool = False

    def __post_init__(self) -> None:
        VocabularyLabel(self.name, self.color)
        if self.end not in PHASE_ENDS:
            raise LabelingError(
                f"Expected “{self.name}” to end with one of {', '.join(PHASE_ENDS)}, but got "
                f"{self.end!r:.40}."
            )
        if not (isinstance(self.optional, bool) and isinstance(self.repeated, bool)):
            raise LabelingError(f"Expected “{self.name}” to be optional or repeated, or not.")


@dataclass(frozen=True)
class Task:
    """A task by its name, and its phases in their order, each name once."""

    name: str
    phases: tuple[TaskPhase, ...]

    def __post_init__(self) -> None:
        VocabularyLabel(self.name, SEGMENT_COLORS[0])
        if len({phase.name for phase in self.phases}) < len(self.phases):
            raise LabelingError(f"Each phase stands in the task “{self.name}” once.")

    def with_phase(self, phase: TaskPhase) -> "Task":
        """With one phase more at its end, or with another of the same name in its place."""
        if any(each.name == phase.name for each in self.phases):
            phases = tuple(phase if each.name == phase.name else each for each in self.phases)
            return replace(self, phases=phases)
        return replace(self, phases=(*self.phases, phase))

    def renamed(self, name: str, to: str) -> "Task":
        """With a phase called otherwise; the same where it is not there, or that name is taken."""
        names = {phase.name for phase in self.phases}
        if name not in names or to in names:
            return self
        phases = (replace(one, name=to) if one.name == name else one for one in self.phases)
        return replace(self, phases=tuple(phases))

    def as_json(self) -> list[dict[str, Any]]:
        """One flat object for each phase, so that damage costs only itself."""
        return [
            {
                "task": self.name,
                "name": phase.name,
                "color": phase.color,
                "end": phase.end,
                "optional": phase.optional,
                "repeated": phase.repeated,
            }
            for phase in self.phases
        ]


def task_of(name: str, labeling: Labeling) -> Task:
    """The task that a finished recording shows: its kept segments that have names, in order.

    A name that comes again is repeated. Raises LabelingError for a name that cannot be one.
    """
    task = Task(name, ())
    for segment in labeling.segments:
        if segment.kept and segment.label:
            known = next((each for each in task.phases if each.name == segment.label), None)
            color = SEGMENT_COLORS[segment.color % len(SEGMENT_COLORS)]
            shown = TaskPhase(segment.label, color, _end_of(segment, labeling))
            task = task.with_phase(shown if known is None else replace(known, repeated=True))
    return task


def plain_or(name: str, otherwise: str) -> str:
    """The name where it can be a task's; a folder may be called anything."""
    try:
        return Task(name, ()).name
    except LabelingError:
        return otherwise


def numbered_labels(tasks: Iterable[Task]) -> tuple[VocabularyLabel, ...]:
    """The phases as labels, in the order in which number keys give them."""
    found: dict[str, VocabularyLabel] = {}
    for task in tasks:
        for phase in task.phases:
            found.setdefault(phase.name, VocabularyLabel(phase.name, phase.color))
    return tuple(found.values())


def with_task(tasks: tuple[Task, ...], task: Task) -> tuple[Task, ...]:
    """With this task in the place of the one of its name, or after the others.

    Raises LabelingError where these are more phases than a folder keeps.
    """
    known = named_task(tasks, task.name) is not None
    changed = tuple(task if each.name == task.name else each for each in tasks)
    changed = changed if known else (*tasks, task)
    count = sum(len(each.phases) for each in changed)
    if count > MAX_PHASES:
        raise LabelingError(f"A folder keeps at most {MAX_PHASES} phases, but these are {count}.")
    return changed


def named_task(tasks: Iterable[Task], name: str) -> Task | None:
    """The task of this name."""
    return next((task for task in tasks if task.name == name), None)


def _end_of(segment: LabeledSegment, labeling: Labeling) -> PhaseEnd:
    acting = (b.time_s for b in labeling.segmentation.boundaries if b.gripper)
    if any(abs(time - segment.end_s) <= _NEAR_S for time in acting):
        return "gripper"
    end = segment.end_condition
    if not isinstance(end, ContactEnd):
        return "configuration"
    return "release" if end.release else "contact"
