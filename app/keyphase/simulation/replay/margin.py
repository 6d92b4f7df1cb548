"""How far the world may differ until a plan fails: a margin instead of a bit.

A plan that succeeds where it was demonstrated may hang by a millimetre. Along each axis the
furthest world is tried first, then the distance is halved until it is known to the resolution, and
worlds on the way there are tried, too. Right segmentations are told from wrong ones by how far they
reach.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import ParameterError, SimulationError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.simulated import Cell
from keyphase.skills.skill import Skill

BETWEEN = (0.25, 0.5, 0.75)
"""Where, of the way to the furthest world that a plan bears, it is tried as well."""


@dataclass(frozen=True)
class Axis:
    """One way in which the world differs more and more.

    most, resolution  in the unit; what is further than `most` is not tried
    nominal           the value of the nominal world
    world             the disturbance of a value
    """

    name: str
    unit: str
    most: float
    resolution: float
    world: Callable[[float], Disturbance]
    nominal: float = 0.0


@dataclass(frozen=True)
class Reach:
    """How far a plan reaches along an axis.

    value      the furthest value that succeeded; None where not even the nominal world does
    unbounded  whether that is the end of the axis, so that it may reach further
    failed     what failed just beyond it
    """

    axis: str
    unit: str
    value: float | None
    unbounded: bool
    failed: str


@dataclass(frozen=True)
class PlanMargin:
    """The margin of one plan: what became of it in the nominal world, and how far it reaches."""

    plan: str
    nominal: str
    reaches: tuple[Reach, ...]

    def reach(self, axis: str) -> Reach:
        """The reach along the axis of that name."""
        return next(reach for reach in self.reaches if reach.axis == axis)


@dataclass(frozen=True)
class Margin:
    """The margins of plans in one workcell, the one in question first."""

    workcell: str
    plans: tuple[PlanMargin, ...]


def margin_of(
    cell: Cell,
    demonstration: Demonstration,
    plans: Mapping[str, Sequence[Skill]],
    *,
    axes: Sequence[str] | None = None,
    seed: int = 0,
    jobs: int = 1,
    progress: Callable[[int, int], None] | None = None,
) -> Margin:
    """How far each of `plans`, by name, reaches along the axes of the workcell, or those named.

    `progress` is told how many axes of all plans are done and how many there are; what it raises
    gives the margin up. The results do not depend on `jobs`.

    Raises ParameterError without plans, SimulationError for a plan without skills.
    """
    from joblib import Parallel, delayed

    if not plans:
        raise ParameterError("A margin needs at least one plan; give the one in question.")
    along = [axis for axis in axes_of(cell) if axes is None or axis.name in axes]
    parallel: Any = Parallel(n_jobs=jobs, return_as="generator")
    in_nominal = parallel(
        delayed(_failure)(cell, demonstration, skills, NOMINAL, seed) for skills in plans.values()
    )
    failures = _counted(in_nominal, progress, 0, len(plans) * (1 + len(along)))
    failed = dict(zip(plans, failures, strict=True))
    working = [name for name in plans if failed[name] is None]
    reaches = parallel(
        delayed(_reach_in)(cell, demonstration, plans[name], axis.name, seed)
        for name in working
        for axis in along
    )
    found = iter(_counted(reaches, progress, len(plans), len(plans) + len(working) * len(along)))
    none = tuple(Reach(axis.name, axis.unit, None, False, "") for axis in along)
    return Margin(
        cell.name,
        tuple(
            PlanMargin(name, "success", tuple(next(found) for _ in along))
            if reason is None
            else PlanMargin(name, reason, none)
            for name, reason in failed.items()
        ),
    )


def _counted(
    results: Iterable[Any], progress: Callable[[int, int], None] | None, before: int, total: int
) -> list[Any]:
    """The results, each told as one more of `total` when it comes."""
    found = []
    for result in results:
        found.append(result)
        if progress:
            progress(before + len(found), total)
    return found


def axes_of(cell: Cell) -> tuple[Axis, ...]:
    """The ways in which a workcell differs; a recorded world along what was met first.

    What a recording begins in nobody came to: it counts only where nothing else was touched.
    """
    if isinstance(cell, RecordedCell):
        return _recorded_axes(cell)
    return (
        Axis("higher", "mm", 30.0, 1.5, lambda mm: Disturbance(part_height_m=1e-3 * mm)),
        Axis("lower", "mm", 30.0, 1.5, lambda mm: Disturbance(part_height_m=-1e-3 * mm)),
        Axis("ahead", "mm", 20.0, 1.5, lambda mm: Disturbance(part_offset_m=(1e-3 * mm, 0.0))),
        Axis("aside", "mm", 20.0, 1.5, lambda mm: Disturbance(part_offset_m=(0.0, 1e-3 * mm))),
        Axis("turned", "°", 20.0, 1.5, lambda deg: Disturbance(part_turn_rad=np.radians(deg))),
        Axis("rougher", "", 1.5, 0.1, lambda mu: Disturbance(friction=mu), NOMINAL.friction),
    )


def _recorded_axes(cell: RecordedCell) -> tuple[Axis, ...]:
    if not cell.surfaces:
        return ()
    met = [one for one in cell.surfaces if one.made_s > cell.begins_s] or cell.surfaces
    towards = met[0].normal[:10].mean(axis=0)
    towards /= np.linalg.norm(towards)
    across = np.cross(towards, np.eye(3)[int(np.abs(towards).argmin())])
    across /= np.linalg.norm(across)

    def moved(way: np.ndarray) -> Callable[[float], Disturbance]:
        def world(mm: float) -> Disturbance:
            x, y, z = (1e-3 * mm * way).tolist()
            return Disturbance(part_height_m=z, part_offset_m=(x, y))

        return world

    most = 20.0
    return (
        Axis("towards the tool", "mm", most, 1.5, moved(towards)),
        Axis("away from it", "mm", most, 1.5, moved(-towards)),
        Axis("aside", "mm", most, 1.5, moved(across)),
        Axis("turned", "°", 20.0, 1.5, lambda deg: Disturbance(part_turn_rad=np.radians(deg))),
        Axis("rougher", "", 1.5, 0.1, lambda mu: Disturbance(friction=mu), NOMINAL.friction),
    )


def _reach_in(
    cell: Cell, demonstration: Demonstration, skills: Sequence[Skill], axis: str, seed: int
) -> Reach:
    """The reach along an axis of a plan that succeeds in the nominal world."""
    along = next(each for each in axes_of(cell) if each.name == axis)

    def failure(value: float) -> str | None:
        return _failure(cell, demonstration, skills, along.world(value), seed)

    value, failed = _furthest(failure, along)
    return Reach(along.name, along.unit, value, failed is None, failed or "")


def _furthest(failure: Callable[[float], str | None], axis: Axis) -> tuple[float, str | None]:
    """The furthest value that succeeds, known to succeed at the nominal one, and what failed.

    A plan that fails in a near world may succeed in a far one by chance: a quarter, a half and
    three quarters of the way there have to succeed, too.
    """
    failed = failure(axis.most)
    good, failed = (
        (axis.most, None)
        if failed is None
        else _halved(failure, axis.nominal, axis.most, failed, axis)
    )
    nearer, whole = axis.nominal, good - axis.nominal
    for share in BETWEEN:
        there = axis.nominal + share * whole
        if there - nearer < axis.resolution:
            continue
        now = failure(there)
        if now is not None:
            return _halved(failure, nearer, there, now, axis)
        nearer = there
    return good, failed


def _halved(
    failure: Callable[[float], str | None], good: float, bad: float, failed: str, axis: Axis
) -> tuple[float, str]:
    """Between a value that succeeds and one that failed, known to the axis' resolution."""
    while bad - good > axis.resolution:
        middle = 0.5 * (good + bad)
        now = failure(middle)
        if now is None:
            good = middle
        else:
            bad, failed = middle, now
    return good, failed


def _failure(
    cell: Cell,
    demonstration: Demonstration,
    skills: Sequence[Skill],
    disturbance: Disturbance,
    seed: int,
) -> str | None:
    """Why a replay fails in one world; None where it succeeds."""
    try:
        replay = Replay(cell.build(disturbance, seed), skills, demonstration)
        while not replay.over:
            replay.step()
    except SimulationError as error:
        return str(error)
    result = replay.result()
    return None if result.succeeded else result.outcome()
