"""A segment file replayed: the call behind `keyphase.replay`."""

from pathlib import Path

from keyphase.errors import SimulationError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.replay.input import planned_replay
from keyphase.simulation.replay.replay import run
from keyphase.simulation.replay.result import ReplayResult
from keyphase.simulation.workcells.registry import workcell as workcell_named
from keyphase.skills.library import skills_of


def replay(
    segment_file: Path | str,
    workcell: str | None = None,
    *,
    demonstration: Path | str | None = None,
    recipe: Path | str | None = None,
    disturbance: Disturbance = NOMINAL,
    seed: int = 0,
) -> ReplayResult:
    """Replay the plan of a segment file in a simulated workcell, to its end.

    Without `workcell` it is the one the demonstration was recorded in; `demonstration` is the
    recording where it is neither where the file says nor beside it. The same `seed` gives the same
    sensor noise. What came of it is in the result: `succeeded`, outcomes, forces, the recording.

    Raises SegmentFileError for a file or recording that does not fit, SkillError for a segment
    that cannot be made executable, SimulationError for a workcell that is not known.
    """
    planned = planned_replay(
        Path(segment_file),
        None if demonstration is None else Path(demonstration),
        None if recipe is None else Path(recipe),
    )
    name = workcell or planned.demonstration.metadata.get("workcell")
    if not isinstance(name, str):
        raise SimulationError(
            f"{planned.demonstration.name} was not recorded in a workcell of keyphase; name one."
        )
    skills = skills_of(planned.demonstration, planned.segments)
    simulation = workcell_named(name).build(disturbance, seed)
    return run(simulation, skills, planned.demonstration)
