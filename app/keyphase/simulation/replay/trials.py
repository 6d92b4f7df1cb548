"""Many replays in disturbed worlds: how often the plan works where it was not demonstrated."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import ParameterError, SimulationError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.replay.ranges import Range
from keyphase.simulation.replay.replay import ReplayOptions, run
from keyphase.simulation.simulated import Cell
from keyphase.simulation.workcells.registry import workcell
from keyphase.skills.skill import Skill

_ONLY_NOMINAL_PLACE = Range(0.0, 0.0)
_ONLY_NOMINAL_FRICTION = Range(NOMINAL.friction, NOMINAL.friction)
_ONE = Range(1.0, 1.0)
_ONLY_NOMINAL_NOISE = Range(NOMINAL.sensor_noise, NOMINAL.sensor_noise)


@dataclass(frozen=True)
class Worlds:
    """What varies between worlds, each uniformly; the default is the nominal world.

    part_height_m  of the table and all on it [m]
    part_offset_m  of the part to be met, x and y alike but drawn apart [m]
    friction       between parts and table
    sensor_noise   factor on the noise of the wrist sensor
    tilt_rad       of the held part in the gripper [rad]
    part_turn_rad  of the part to be met, about the vertical [rad]
    mass           factor on the masses of the free parts
    sensor_bias_N  what the wrist sensor reads too much [N]
    sensor_drift   factor on how fast its bias wanders
    """

    part_height_m: Range = _ONLY_NOMINAL_PLACE
    part_offset_m: Range = _ONLY_NOMINAL_PLACE
    friction: Range = _ONLY_NOMINAL_FRICTION
    sensor_noise: Range = _ONLY_NOMINAL_NOISE
    tilt_rad: Range = _ONLY_NOMINAL_PLACE
    part_turn_rad: Range = _ONLY_NOMINAL_PLACE
    mass: Range = _ONE
    sensor_bias_N: Range = _ONLY_NOMINAL_PLACE
    sensor_drift: Range = _ONE


@dataclass(frozen=True)
class World:
    """One disturbed world: what is different in it, and the seed of its sensor."""

    disturbance: Disturbance
    seed: int


@dataclass(frozen=True)
class Trial:
    """What became of one replay.

    outcomes       of the skills that were begun, in the order of the plan
    checks         all that success is made of, by name, as in `ReplayResult`
    peak_force_N   largest measured force
    error          what stopped the simulation, if anything did
    """

    world: World
    outcomes: tuple[str, ...]
    checks: tuple[tuple[str, bool], ...]
    peak_force_N: float
    duration_s: float
    error: str | None = None

    @property
    def succeeded(self) -> bool:
        """Whether all of its checks held, and there were any."""
        return self.error is None and bool(self.checks) and all(holds for _, holds in self.checks)


@dataclass(frozen=True)
class Trials:
    """Results of many worlds, in their order; `labels` are those of the skills."""

    labels: tuple[str, ...]
    trials: tuple[Trial, ...]

    @property
    def successes(self) -> int:
        """How many trials succeeded."""
        return sum(trial.succeeded for trial in self.trials)

    @property
    def rate(self) -> float:
        """Successes over trials."""
        return self.successes / len(self.trials)

    def interval(self) -> tuple[float, float]:
        """95 % confidence interval of the success rate."""
        return wilson_interval(self.successes, len(self.trials))

    def outcomes(self, skill: int) -> Counter[str]:
        """How often the skill ended how; "not begun" where the plan had stopped before."""
        return Counter(
            trial.outcomes[skill] if skill < len(trial.outcomes) else "not begun"
            for trial in self.trials
        )

    def peak_forces(self) -> np.ndarray:
        """Largest measured force of each trial [N]."""
        return np.array([trial.peak_force_N for trial in self.trials])


def wilson_interval(successes: int, trials: int) -> tuple[float, float]:
    """95 % confidence interval of a rate (Wilson, 1927); right for rates near 0 and 1, too."""
    from scipy.stats import binomtest

    interval = binomtest(successes, trials).proportion_ci(0.95, method="wilson")
    return float(interval.low), float(interval.high)


def drawn_worlds(worlds: Worlds, count: int, seed: int) -> tuple[World, ...]:
    """`count` worlds; the same seed gives the same ones, and more of them begin alike."""
    seeds = np.random.SeedSequence(seed).spawn(count)
    return tuple(_drawn(worlds, each) for each in seeds)


def run_trials(
    cell: str | Cell,
    demonstration: Demonstration,
    skills: Sequence[Skill],
    worlds: Sequence[World],
    *,
    coupled: bool = True,
    jobs: int = -1,
    progress: Callable[[int, int], None] | None = None,
) -> Trials:
    """Replay `skills` in every world, `jobs` at once (-1: all cores), by joblib.

    The results do not depend on `jobs`. `progress` is told how many are done and how many there
    are. A simulation that diverges is a failed trial.

    Raises ParameterError for no jobs or worlds, SimulationError for an unknown workcell or an
    empty plan.
    """
    from joblib import Parallel, delayed

    if jobs == 0 or not worlds:
        raise ParameterError(
            f"Trials need at least one world and one job, but there are {len(worlds)} worlds and "
            f"{jobs} jobs; give more, or -1 jobs for all cores."
        )
    # By value, as what a script has registered is not known to the processes of the jobs.
    cell = workcell(cell) if isinstance(cell, str) else cell
    one = delayed(run_trial)
    options = ReplayOptions(coupled)
    todo = [one(cell, demonstration, tuple(skills), world, options) for world in worlds]
    running: Any = Parallel(n_jobs=jobs, return_as="generator")(todo)
    done: list[tuple[tuple[str, ...], Trial]] = []
    for result in running:
        done.append(result)
        if progress:
            progress(len(done), len(worlds))
    labels = max((labels for labels, _ in done), key=len)
    return Trials(labels, tuple(trial for _, trial in done))


def run_trial(
    cell: Cell,
    demonstration: Demonstration,
    skills: Sequence[Skill],
    world: World,
    options: ReplayOptions | None = None,
) -> tuple[tuple[str, ...], Trial]:
    """Replay in one world: the labels of the skills, and what became of it."""
    simulation = cell.build(world.disturbance, world.seed)
    try:
        result = run(simulation, skills, demonstration, options)
    except SimulationError as error:
        return (), Trial(world, (), (), 0.0, 0.0, str(error))
    return tuple(skill.label for skill in result.skills), Trial(
        world=world,
        outcomes=tuple(each.outcome or "stopped" for each in result.results),
        checks=tuple((name, bool(holds)) for name, holds in result.checks.items()),
        peak_force_N=result.peak_force,
        duration_s=result.duration_s,
    )


def _drawn(worlds: Worlds, drawn_from: np.random.SeedSequence) -> World:
    random = np.random.default_rng(drawn_from)
    disturbance = Disturbance(
        part_height_m=worlds.part_height_m.drawn(random),
        part_offset_m=(worlds.part_offset_m.drawn(random), worlds.part_offset_m.drawn(random)),
        friction=worlds.friction.drawn(random),
        sensor_noise=worlds.sensor_noise.drawn(random),
    )
    seed = int(random.integers(2**31))
    # Drawn after what could vary first, so that worlds drawn before stay what they were.
    return World(
        replace(
            disturbance,
            tilt_rad=worlds.tilt_rad.drawn(random),
            part_turn_rad=worlds.part_turn_rad.drawn(random),
            mass=worlds.mass.drawn(random),
            sensor_bias_N=worlds.sensor_bias_N.drawn(random),
            sensor_drift=worlds.sensor_drift.drawn(random),
        ),
        seed,
    )
