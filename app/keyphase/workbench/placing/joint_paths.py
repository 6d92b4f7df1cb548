"""How an arm must move to follow a recording: worked out once, and remembered."""

import time
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.robot.arm import Arm
from keyphase.robot.follow import JointPath, Unreached, follow
from keyphase.robot.pose import Placement
from keyphase.robot.recorded import recorded_path
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.telling import Telling

KEPT = 8
"""So many joint paths are remembered."""

_NAMED = 3
_PROGRESS = 0.02
_GIVEN_WAY_S = 0.01


class OvertakenError(Exception):
    """Another recording, arm or placement is wanted by now."""


@dataclass(frozen=True, eq=False)
class Task:
    """What the arm is to follow; `placement` None: wherever it reaches it."""

    opened: DeskState
    arm: Arm
    placement: Placement | None

    @property
    def demonstration(self) -> Demonstration:
        """What is followed."""
        return self.opened.demonstration


class JointPaths:
    """The newest paths. One is worked out at a time, another thread may ask for known ones.

    `gives_way` says whether something more urgent is being worked out. Two threads that compute at
    once hinder each other: numpy lets go of the interpreter at every array and has to wait for it.
    """

    def __init__(self) -> None:
        self.gives_way: Callable[[], bool] = lambda: False
        self._known: OrderedDict[tuple[object, ...], JointPath] = OrderedDict()

    def known(self, task: Task) -> JointPath | None:
        """The path of a task, if it has been worked out."""
        return self._known.get(_key(task))

    def path(self, task: Task, is_wanted: Callable[[], bool], telling: Telling) -> JointPath:
        """The path of a task with a placement; the page that asked is told what it cannot reach.

        Raises OvertakenError as soon as it is no longer wanted.
        """
        path = self.known(task)
        if path is None:
            path = self._worked_out(task, is_wanted, telling)
            if path.unreached:
                telling.notice("warning", _unreached_sentence(task.arm, path.unreached))
        self._known[_key(task)] = path
        while len(self._known) > KEPT:
            self._known.popitem(last=False)
        return path

    def _worked_out(self, task: Task, is_wanted: Callable[[], bool], telling: Telling) -> JointPath:
        if task.placement == Placement():
            recorded = recorded_path(task.arm, task.demonstration)
            if recorded is not None:
                return recorded
        told = -1.0

        def progress(share: float) -> None:
            nonlocal told
            while is_wanted() and self.gives_way():
                time.sleep(_GIVEN_WAY_S)
            if not is_wanted():
                raise OvertakenError
            if share - told >= _PROGRESS:
                told = share
                at_work.at(share)

        with telling.tasks.begin(f"{task.opened.recording.name}: the robot's joints") as at_work:
            return follow(task.arm, task.demonstration, task.placement, progress=progress)


def _key(task: Task) -> tuple[object, ...]:
    source = task.demonstration.source
    return (source or id(task.demonstration), task.arm.robot.tool_frame, task.placement)


def _unreached_sentence(arm: Arm, stretches: Sequence[Unreached]) -> str:
    """What was not reached, the longest stretches by name."""
    longest = sorted(stretches, key=lambda one: one.start_s - one.end_s)[:_NAMED]
    named = ", ".join(_stretch(one) for one in sorted(longest, key=lambda one: one.start_s))
    more = len(stretches) - len(longest)
    rest = f", and {more} more" if more else ""
    return (
        f"The robot's {arm.robot.tool_frame} cannot follow {named}{rest}; there it is grey and as "
        "near as it gets."
    )


def _stretch(one: Unreached) -> str:
    off = f"{1e3 * one.distance_m:.3g} mm"
    if one.distance_m < 1e-4:
        off = f"{np.degrees(one.angle_rad):.3g}°"
    if one.start_s == one.end_s:
        return f"{one.start_s:.3f} s ({off} away)"
    return f"{one.start_s:.3f} to {one.end_s:.3f} s (up to {off} away)"
