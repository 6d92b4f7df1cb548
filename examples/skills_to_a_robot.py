"""Skills to a robot: write the file that any robot reads, or step them here at 250 Hz."""

from pathlib import Path

import keyphase
from keyphase.files.shipped import shipped
from keyphase.simulation import Reference, workcell
from keyphase.skills import Executor, Sensed
from keyphase.skills.exports.skill_file import write_skills
from keyphase.skills.exports.skill_library import library_of

demonstration = keyphase.read(shipped("data") / "setup1.npz")
moving = [piece for piece in keyphase.segment(demonstration).segments if not piece.idle]
skills = keyphase.skills_of(demonstration, moving)
write_skills(Path("setup1.skills.json"), library_of(demonstration, skills))

robot = workcell("setup1").build()  # in place of it: whatever follows an impedance and feels forces


def sensed(sample):
    return Sensed(sample.position_m, sample.orientation_wxyz, robot.tool_velocity(), sample.force_N)


executor = Executor(skills, sensed(robot.step(robot.here())))
while not executor.over:
    follow = executor.reference
    velocity, turning = follow.velocity[:3], follow.velocity[3:]
    executor.step(
        sensed(robot.step(Reference(follow.position_m, follow.orientation_wxyz, velocity, turning)))
    )
for skill, result in zip(skills, executor.results, strict=True):
    print(f"{skill.label}: {result.outcome}")
