"""The command `keyphase replay`: one replay, or trials in many disturbed worlds.

Everything heavy is imported where it is used, so that `--help` answers at once.
"""

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import tyro

from keyphase.commands.replay_world import WorldOptions
from keyphase.commands.saying import say
from keyphase.errors import ParameterError, SimulationError

if TYPE_CHECKING:
    from keyphase.demonstration import Demonstration
    from keyphase.labeling.segment_file import FiledSegment
    from keyphase.simulation.replay.input import PlannedReplay
    from keyphase.simulation.simulated import Cell
    from keyphase.skills.skill import Skill


@dataclass(frozen=True)
class ReplaySegments:
    """Replay the plan of a segment file in a simulated world; 0 where the task succeeds.

    With --trials in many disturbed worlds; then 0 where it succeeds in all of them. With --margin
    it says how far the world may differ until the plan fails.
    """

    segments: tyro.conf.Positional[Path]
    """The segment file."""
    others: Annotated[tuple[Path, ...], tyro.conf.arg(name="with")] = ()
    """Segment files of further recordings of the same phases: the skills are learnt from all."""
    workcell: str | None = None
    """setup1, setup2, a TOML file of your own, or `recording`, the world made from the recording;
    without, the workcell it was recorded in, and for every other recording the world made from
    it."""
    robot: Path | None = None
    """Another arm (URDF or MJCF) that moves the tool in the world made from the recording."""
    tool_frame: str | None = None
    """The body, link or site of it that is the tool point."""
    demonstration: Path | None = None
    """The recording, where it is neither where the segment file says nor beside it."""
    recipe: Path | None = None
    """How to read a table that is not in keyphase's own form (TOML)."""
    end_conditions: Literal["contact", "configuration"] = "contact"
    """`configuration` leaves the force conditions out, for comparison."""
    world: tyro.conf.OmitArgPrefixes[WorldOptions] = field(default_factory=WorldOptions)
    """How the world differs from the nominal one."""
    seed: int = 0
    """The same seed gives the same sensor noise and the same disturbed worlds."""
    trials: int = 0
    """How many disturbed worlds: a single height or offset a then means -a..a."""
    margin: bool = False
    """How much higher, lower, aside, turned, rougher the world may be until the plan fails, beside
    the same by pose alone and as one skill."""
    jobs: int = -1
    """How many trials at once; -1 takes all cores."""
    coupling: bool = True
    """Temporal coupling: a skill waits while the robot is held."""
    output: Path | None = None
    """Write the replay as a recording (NPZ)."""
    plot: Path | None = None
    """Write a picture of the trials or of the margin (SVG)."""
    skills: Path | None = None
    """Write the skills (JSON)."""
    behavior_tree: Path | None = None
    """Write the plan for BehaviorTree.CPP (XML)."""
    program: Path | None = None
    """Write the plan as a listing that people read."""
    urscript: Path | None = None
    """Write the plan as a URScript program with contact moves."""
    rapid: Path | None = None
    """Write the plan as an ABB RAPID module with contact moves."""
    replace: bool = False
    """Replace files in the way that keyphase did not write, or that were changed since."""
    json: bool = False
    """Print for machines."""

    def run(self) -> int:
        """Make the skills, write what is asked for, replay, and say what became of it."""
        from keyphase.simulation.choosing import cell_for, met_by
        from keyphase.simulation.replay.input import planned_replay, with_configuration_ends

        self._check()
        planned = planned_replay(self.segments, self.demonstration, self.recipe)
        cell = cell_for(planned.demonstration, self.workcell, self._robot())
        demonstration = met_by(planned.demonstration, cell)
        if self.margin:
            return self._run_margin(cell, replace(planned, demonstration=demonstration))
        segments = planned.segments
        if self.end_conditions == "configuration":
            segments = with_configuration_ends(segments)
        demonstration, skills = self._learnt(demonstration, segments)
        self._write_program(demonstration, skills)
        if self.trials:
            return self._run_trials(cell, demonstration, skills)
        return self._run_once(cell, demonstration, skills)

    def _learnt(
        self, demonstration: "Demonstration", segments: "tuple[FiledSegment, ...]"
    ) -> "tuple[Demonstration, tuple[Skill, ...]]":
        """The demonstration whose skills are replayed: the recording's, or the mean of all."""
        from keyphase.simulation.choosing import cell_for, met_by
        from keyphase.simulation.replay.input import planned_replay, with_configuration_ends
        from keyphase.skills.library import skills_of
        from keyphase.skills.many import mean_of, skills_of_mean

        if not self.others:
            return demonstration, skills_of(demonstration, segments)
        demonstrated = [(demonstration, segments)]
        for path in self.others:
            other = planned_replay(path, recipe=self.recipe)
            cell = cell_for(other.demonstration, self.workcell, self._robot())
            ends = self.end_conditions == "configuration"
            planned = with_configuration_ends(other.segments) if ends else other.segments
            demonstrated.append((met_by(other.demonstration, cell), planned))
        mean = mean_of(demonstrated)
        return mean.demonstration, skills_of_mean(mean, demonstrated)

    def _robot(self) -> "tuple[Path, str] | None":
        if (self.robot is None) != (self.tool_frame is None):
            raise ParameterError(
                "--robot and --tool-frame go together: the file of an arm, and which of its frames "
                "is the tool point."
            )
        return (
            None
            if self.robot is None or self.tool_frame is None
            else (
                self.robot,
                self.tool_frame,
            )
        )

    def _check(self) -> None:
        if self.trials < 0:
            raise ParameterError(f"--trials must not be below zero, but is {self.trials}.")
        if self.others and self.margin:
            raise ParameterError("A margin is of one demonstration; leave out --with or --margin.")
        if self.trials and self.margin:
            raise ParameterError("Either --trials or --margin can be asked for; leave one out.")
        if self.output and (self.trials or self.margin):
            raise ParameterError(
                "--output takes the recording of one replay; leave out --trials and --margin."
            )
        if self.plot and not (self.trials or self.margin):
            raise ParameterError("--plot is the picture of trials or of a margin; add --trials.")

    def _write_program(self, demonstration: "Demonstration", skills: "tuple[Skill, ...]") -> None:
        from keyphase.skills.exports.behavior_tree import behavior_tree
        from keyphase.skills.exports.program import program_listing
        from keyphase.skills.exports.rapid import rapid
        from keyphase.skills.exports.skill_file import skill_text
        from keyphase.skills.exports.skill_library import library_of
        from keyphase.skills.exports.urscript import urscript

        library = f"{demonstration.name}.skills.json"
        if self.skills:
            library = self.skills.name
            self._write(self.skills, skill_text(library_of(demonstration, skills)))
        if self.behavior_tree:
            self._write(self.behavior_tree, behavior_tree(skills, library))
        for path, written in (
            (self.program, program_listing),
            (self.urscript, urscript),
            (self.rapid, rapid),
        ):
            if path:
                self._write(path, written(skills, demonstration.name))

    def _write(self, path: Path, made: str | bytes) -> None:
        """Raises FileInTheWayError where somebody else's file would be replaced unasked."""
        from keyphase.commands.putting import put

        data = made.encode() if isinstance(made, str) else made
        put(path, data, self.segments.name, replace=self.replace, refusal=SimulationError)

    def _run_once(
        self, cell: "Cell", demonstration: "Demonstration", skills: "tuple[Skill, ...]"
    ) -> int:
        from keyphase.readers import npz_data
        from keyphase.simulation.replay.replay import ReplayOptions, run
        from keyphase.simulation.replay.report import as_json, replay_text, replay_values

        simulation = cell.build(self.world.disturbance(), self.seed)
        result = run(simulation, skills, demonstration, ReplayOptions(self.coupling))
        if self.output:
            self._write(self.output, npz_data(result.demonstration))
        say(as_json(replay_values(result)) if self.json else replay_text(result))
        return 0 if result.succeeded else 1

    def _run_trials(
        self, cell: "Cell", demonstration: "Demonstration", skills: "tuple[Skill, ...]"
    ) -> int:
        from tqdm import tqdm

        from keyphase.simulation.replay.report import as_json, trials_text, trials_values
        from keyphase.simulation.replay.trials import drawn_worlds, run_trials
        from keyphase.simulation.replay.trials_picture import trials_svg

        worlds = drawn_worlds(self.world.worlds(), self.trials, self.seed)
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
            title = f"{cell.name}, {self.end_conditions} end conditions"
            self._write(self.plot, trials_svg(trials, title))
        say(as_json(trials_values(trials)) if self.json else trials_text(trials))
        return 0 if trials.successes == len(trials.trials) else 1

    def _run_margin(self, cell: "Cell", planned: "PlannedReplay") -> int:
        from tqdm import tqdm

        from keyphase.simulation.replay.margin import margin_of
        from keyphase.simulation.replay.margin_plans import margin_plans
        from keyphase.simulation.replay.margin_report import margin_svg, margin_text, margin_values
        from keyphase.simulation.replay.report import as_json

        plans = margin_plans(planned.demonstration, planned.segments)
        with tqdm(unit="axis", disable=None) as bar:

            def progress(done: int, total: int) -> None:
                bar.total = total
                bar.update(done - bar.n)

            margin = margin_of(
                cell,
                planned.demonstration,
                plans,
                seed=self.seed,
                jobs=self.jobs,
                progress=progress,
            )
        if self.plot:
            title = f"{planned.demonstration.name} in {cell.name}"
            self._write(self.plot, margin_svg(margin, title))
        say(as_json(margin_values(margin)) if self.json else margin_text(margin))
        return 0 if margin.plans[0].nominal == "success" else 1
