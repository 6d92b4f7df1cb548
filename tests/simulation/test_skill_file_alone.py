"""What is exported is what was proved: the file alone does what the replay does."""

from dataclasses import replace

import numpy as np
import pytest
from drawn_contact import DOWN_S, FRICTION, PRESS_S, PRESSED_N, SLIDE_S, pressed_slide
from file_alone import both, example
from replaying import Drawn, bundled, plan

from keyphase.segmentation.end_condition import ConfigurationEnd, GripperEnd
from keyphase.simulation import Disturbance, workcell
from keyphase.skills import Executor, Sensed
from keyphase.skills.exports.skill_file import write_skills
from keyphase.skills.exports.skill_library import library_of
from keyphase.skills.library import skills_of
from keyphase.skills.spread import Spread


@pytest.mark.parametrize(
    ("name", "world", "last"),
    [
        ("setup1", Disturbance(part_height_m=0.007), "contact"),
        ("setup2", Disturbance(part_height_m=-0.006), "reached"),
        ("setup1", Disturbance(part_offset_m=(0.0, 0.02)), "timeout"),
    ],
)
def test_the_example_interpreter_does_what_the_replay_does(name, world, last, tmp_path) -> None:
    """In the last one no seat is within reach of the search: both must fail alike."""
    demonstration = bundled(name)[0]
    skills = skills_of(demonstration, plan(name))
    replayed, alone = both(workcell(name), skills, demonstration, world, tmp_path)
    assert alone == replayed
    assert alone[0][-1] == last


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"version": 2', '"version": 1', "no skill file of version 2"),
        ('"step_s"', '"steps_s"', "has no 'step_s'"),
    ],
)
def test_a_file_that_the_example_cannot_execute_is_refused_in_one_line(
    old, new, said, tmp_path
) -> None:
    demonstration = pressed_slide()
    part = Drawn(0.0, 0.1, "stand")
    file = tmp_path / "stand.skills.json"
    skills = skills_of(demonstration, [part])
    write_skills(file, library_of(demonstration, skills))
    file.write_text(file.read_text().replace(old, new))
    here = demonstration.position_m[0], np.array([1.0, 0.0, 0.0, 0.0]), np.zeros(6), np.zeros(3)
    with pytest.raises((ValueError, AttributeError), match=said):
        example().Plan(file, here)


def same_reference(executor, alone):
    """What the executor wants, which the example interpreter wants, too."""
    wanted = executor.reference
    np.testing.assert_allclose(alone.reference[0], wanted.position_m, atol=1e-9)
    np.testing.assert_allclose(alone.reference[2], wanted.velocity, atol=1e-7)
    return wanted


def test_the_example_interpreter_pushes_what_was_recorded_besides_what_is_pressed(tmp_path) -> None:
    """Tick by tick in a slide that no skill came into contact for, while its friction is felt."""
    demonstration = pressed_slide()
    skills = skills_of(demonstration, [Drawn(DOWN_S, DOWN_S + PRESS_S + SLIDE_S, "slide")])
    assert skills[0].kept[0].pushed_N is not None
    file = tmp_path / "slide.skills.json"
    write_skills(file, library_of(demonstration, skills))
    position, wxyz = skills[0].primitive.start_position_m, np.array([1.0, 0.0, 0.0, 0.0])
    force, velocity = np.array([-FRICTION * PRESSED_N, 0.0, PRESSED_N]), np.zeros(6)
    executor = Executor(skills, Sensed(position, wxyz, velocity, force))
    alone = example().Plan(file, (position, wxyz, velocity, force))
    for _ in range(400):
        wanted = same_reference(executor, alone)
        velocity = np.r_[0.5 * wanted.velocity[:3], np.zeros(3)]
        position = position + 0.004 * velocity[:3]
        executor.step(Sensed(position, wxyz, velocity, force))
        alone.step((position, wxyz, velocity, force))


@pytest.mark.parametrize(
    ("change", "from_to", "ticks"),
    [("grasp", (0.08, 0.02), 138), ("grasp", (0.08, 0.05), 165), ("release", (0.02, 0.08), 103)],
)
def test_the_example_interpreter_waits_for_the_gripper(change, from_to, ticks, tmp_path) -> None:
    """It moves between ticks 100 and 140: as far as demonstrated, or stalls at something wider."""
    end = ConfigurationEnd(gripper=GripperEnd(change, 0.02, 0.004, stalled_s=0.1))
    skills = skills_of(bundled("setup1")[0], [Drawn(0.3, 0.5, "go", end)])
    file = tmp_path / "gripped.skills.json"
    write_skills(file, library_of(bundled("setup1")[0], skills))
    start = skills[0].primitive
    position, wxyz = start.start_position_m, start.start_orientation_wxyz
    felt = np.zeros(6), np.zeros(3)
    executor = Executor(skills, Sensed(position, wxyz, *felt))
    alone = example().Plan(file, (position, wxyz, *felt))
    ended = []
    for tick in range(170):
        opening = float(np.interp(tick, (100, 140), from_to))
        reference = same_reference(executor, alone)
        position, wxyz = reference.position_m, reference.orientation_wxyz
        felt = reference.velocity, np.zeros(3)
        executor.step(Sensed(position, wxyz, *felt, opening))
        alone.step((position, wxyz, *felt, opening))
        if executor.results and not ended:
            ended = [tick, executor.results[0].outcome, *alone.outcomes]
    assert ended == [ticks, "reached", "reached"]


def test_the_example_interpreter_is_as_soft_as_the_executor(tmp_path) -> None:
    """Tick by tick on a tool that goes half of the way and is pushed, where the spread narrows."""
    demonstration = bundled("setup1")[0]
    spread = Spread(10, np.linspace(0.04, 0.0, 21))
    skills = [replace(each, spread=spread) for each in skills_of(demonstration, plan("setup1"))]
    file = tmp_path / "soft.skills.json"
    write_skills(file, library_of(demonstration, skills))
    start = skills[0].primitive
    position, wxyz = start.start_position_m, start.start_orientation_wxyz
    force = np.array([0.0, 1.0, 2.0])
    velocity = np.zeros(6)
    executor = Executor(skills, Sensed(position, wxyz, velocity, force))
    alone = example().Plan(file, (position, wxyz, velocity, force))
    for _ in range(1000):
        wanted = same_reference(executor, alone)
        velocity = np.r_[0.5 * wanted.velocity[:3], np.zeros(3)]
        position, wxyz = (position + wanted.position_m) / 2.0, wanted.orientation_wxyz
        executor.step(Sensed(position, wxyz, velocity, force))
        alone.step((position, wxyz, velocity, force))
    assert executor.results
