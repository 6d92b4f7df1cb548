"""A skill file executed by the example interpreter in a workcell, as a robot would."""

import importlib.util
from pathlib import Path

from keyphase.simulation.impedance import Reference
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.workcells.course import Course
from keyphase.skills.exports.skill_file import write_skills
from keyphase.skills.exports.skill_library import library_of

EXAMPLE = Path(__file__).parents[2] / "examples" / "execute_skills.py"


def example():
    """The module `examples/execute_skills.py`."""
    spec = importlib.util.spec_from_file_location("execute_skills", EXAMPLE)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def executed(simulation, file):
    """Outcome of every skill, and what the workcell checks, when the file alone is executed."""
    course = Course(simulation.workcell)

    def sensed(sample):
        pose = sample.position_m, sample.orientation_wxyz
        return (*pose, simulation.tool_velocity(), sample.force_N)

    plan = example().Plan(file, sensed(simulation.step(simulation.here())))
    while not plan.over:
        position, orientation, velocity = plan.reference
        reference = Reference(position, orientation, velocity[:3], velocity[3:])
        sample = simulation.step(reference)
        course.watch(simulation)
        plan.step(sensed(sample))
    return plan.outcomes, dict(course.checks(simulation))


def both(cell, skills, demonstration, disturbance, folder, seed=0):
    """The same of a replay and of the file it wrote, in two worlds that are alike."""
    replay = Replay(cell.build(disturbance, seed), skills, demonstration)
    file = folder / "plan.skills.json"
    write_skills(file, library_of(demonstration, replay.skills))
    while not replay.over:
        replay.step()
    result = replay.result()
    replayed = [each.outcome for each in result.results], dict(result.goals)
    return replayed, executed(cell.build(disturbance, seed), file)
