"""The command `keyphase replay`: one replay, or trials in many disturbed worlds.

Everything heavy is imported where it is used, so that `--help` answers at once.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import tyro

from keyphase.errors import ParameterError, SimulationError

if TYPE_CHECKING:
    from keyphase.demonstration import Demonstration
    from keyphase.simulation.disturbance import Disturbance
    from keyphase.simulation.replay.spread import Spread
    from keyphase.simulation.replay.trials import Worlds
    from keyphase.skills.skill import Skill


@dataclass(frozen=True)
class ReplaySegments:
    """Replay the plan of a segment file in a simulated workcell; 0 where the task succeeds.

    With --trials in many disturbed worlds; then 0 where it succeeds in all of them.
    """

    segments: tyro.conf.Positional[Path]
    """The segment file."""
    workcell: str | None = None
    """setup1 or setup2; without, the one the demonstration was recorded in."""
    demonstration: Path | None = None
    """The recording, where it is neither where the segment file says nor beside it."""
    recipe: Path | None = None
    """How to read a table that is not in keyphase's own form (TOML)."""
    end_conditions: Literal["contact", "configuration"] = "contact"
    """`configuration` leaves the force conditions out, for comparison."""
    part_height: str = "0"
    """How much higher table and parts are, such as 10mm."""
    part_offset: str = "0"
    """How far aside the part lies, such as 5mm: to the left in a replay, in x and y in trials."""
    friction: str = "0.3"
    """Friction between parts and table, such as 0.2..0.6."""
    sensor_noise: str = "1"
    """Factor on the noise of the wrist sensor."""
    seed: int = 0
    """The same seed gives the same sensor noise and the same disturbed worlds."""
    trials: int = 0
    """How many disturbed worlds: a single height or offset a then means -a..a."""
    jobs: int = -1
    """How many trials at once; -1 takes all cores."""
    coupling: bool = True
    """Temporal coupling: a skill waits while the robot is held."""
    output: Path | None = None
    """Write the replay as a recording (NPZ)."""
    plot: Path | None = None
    """Write a picture of the trials (SVG)."""
    skills: Path | None = None
    """Write the skills (JSON)."""
    behavior_tree: Path | None = None
    """Write the plan for BehaviorTree.CPP (XML)."""
    program: Path | None = None
    """Write the plan as a listing that people read."""
    json: bool = False
    """Print for machines."""

    def run(self) -> int:
        """Make the skills, write what is asked for, replay, and say what became of it."""
        from keyphase.simulation.replay.input import planned_replay, with_configuration_ends
        from keyphase.skills.library import skills_of

        self._check()
        planned = planned_replay(self.segments, self.demonstration, self.recipe)
        segments = planned.segments
        if self.end_conditions == "configuration":
            segments = with_configuration_ends(segments)
        skills = skills_of(planned.demonstration, segments)
        cell = self._workcell(planned.demonstration)
        self._write_program(planned.demonstration, skills)
        if self.trials:
            return self._run_trials(cell, planned.demonstration, skills)
        return self._run_once(cell, planned.demonstration, skills)

    def _check(self) -> None:
        if self.trials < 0:
            raise ParameterError(f"--trials must not be below zero, but is {self.trials}.")
        if self.trials and self.output:
            raise ParameterError("--output takes the recording of one replay; leave out --trials.")
        if self.plot and not self.trials:
            raise ParameterError("--plot is the picture of trials; add --trials.")

    def _workcell(self, demonstration: "Demonstration") -> str:
        name = self.workcell or demonstration.metadata.get("workcell")
        if not isinstance(name, str):
            raise SimulationError(
                f"{demonstration.name} was not recorded in a workcell of keyphase; "
                "choose one with --workcell."
            )
        return name

    def _write_program(self, demonstration: "Demonstration", skills: "tuple[Skill, ...]") -> None:
        from keyphase.files.writing import write_whole
        from keyphase.skills.behavior_tree import behavior_tree
        from keyphase.skills.program import program_listing
        from keyphase.skills.skill_file import SkillLibrary, write_skills

        library = f"{demonstration.name}.skills.json"
        if self.skills:
            library = self.skills.name
            write_skills(self.skills, SkillLibrary(demonstration.name, skills))
        if self.behavior_tree:
            tree = behavior_tree(skills, library)
            write_whole(self.behavior_tree, tree.encode(), refusal=SimulationError)
        if self.program:
            listing = program_listing(skills, demonstration.name)
            write_whole(self.program, listing.encode(), refusal=SimulationError)

    def _run_once(
        self, cell: str, demonstration: "Demonstration", skills: "tuple[Skill, ...]"
    ) -> int:
        from keyphase.readers import save_npz
        from keyphase.simulation.replay.replay import ReplayOptions, run
        from keyphase.simulation.replay.report import as_json, replay_text, replay_values
        from keyphase.simulation.workcells.registry import workcell

        simulation = workcell(cell).build(self._disturbance(), self.seed)
        result = run(simulation, skills, demonstration, ReplayOptions(self.coupling))
        if self.output:
            save_npz(result.demonstration, self.output)
        print(as_json(replay_values(result)) if self.json else replay_text(result))
        return 0 if result.succeeded else 1

    def _run_trials(
        self, cell: str, demonstration: "Demonstration", skills: "tuple[Skill, ...]"
    ) -> int:
        from tqdm import tqdm

        from keyphase.files.writing import write_whole
        from keyphase.simulation.replay.report import as_json, trials_text, trials_values
        from keyphase.simulation.replay.trials import drawn_worlds, run_trials
        from keyphase.simulation.replay.trials_picture import trials_svg

        worlds = drawn_worlds(self._worlds(), self.trials, self.seed)
        with tqdm(unit="world", disable=None) as bar:

            def progress(done: int, total: int) -> None:
                bar.total = total
                bar.update(done - bar.n)

            trials = run_trials(
                cell,
                demonstration,
                skills,
                worlds,
                coupled=self.coupling,
                jobs=self.jobs,
                progress=progress,
            )
        if self.plot:
            title = f"{cell}, {self.end_conditions} end conditions"
            write_whole(self.plot, trials_svg(trials, title).encode(), refusal=SimulationError)
        print(as_json(trials_values(trials)) if self.json else trials_text(trials))
        return 0 if trials.successes == len(trials.trials) else 1

    def _worlds(self) -> "Worlds":
        from keyphase.simulation.replay.spread import spread_of
        from keyphase.simulation.replay.trials import Worlds

        return Worlds(
            part_height_m=spread_of(self.part_height, "--part-height", symmetric=True),
            part_offset_m=spread_of(self.part_offset, "--part-offset", symmetric=True),
            friction=spread_of(self.friction, "--friction"),
            sensor_noise=spread_of(self.sensor_noise, "--sensor-noise"),
        )

    def _disturbance(self) -> "Disturbance":
        from keyphase.simulation.disturbance import Disturbance
        from keyphase.simulation.replay.spread import spread_of

        return Disturbance(
            part_height_m=_single(spread_of(self.part_height, "--part-height")),
            part_offset_m=(0.0, _single(spread_of(self.part_offset, "--part-offset"))),
            friction=_single(spread_of(self.friction, "--friction")),
            sensor_noise=_single(spread_of(self.sensor_noise, "--sensor-noise")),
        )


def _single(spread: "Spread") -> float:
    if spread.single is None:
        raise ParameterError(
            f"One replay takes one value, but {spread.low:g}..{spread.high:g} is a range; "
            "add --trials."
        )
    return spread.single
