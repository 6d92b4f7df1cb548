# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A workcell: robot, table, parts, and what counts as success."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import mujoco

from keyphase.simulation.contacts import Pair, watch_contacts
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.robot_scene import YUMI_ARM, ArmNames, robot_spec
from keyphase.simulation.simulation import Simulation


@dataclass(frozen=True)
class Event:
    """Something that has to happen in a task: what it is called, and whether it happens now."""

    name: str
    holds: Callable[[Simulation], bool]


@dataclass(frozen=True)
class Workcell:
    """Plain description of a simulated scene; `build` brings it to life.

    name, title       for files and for people
    start_joints_rad  where the right arm starts, in the order of the arm's joints
    furnish           adds table and parts to the robot's specification
    parts             all bodies but the robot's; "held" is in the gripper
    pairs             contacts the simulator reports, by name
    onsets            which of these are contact changes of the task, in the order they happen
    ends_at_contact   whether the task is over at the last of them
    events            what has to happen for success, in this order, watched by a `Course`
    checks            named predicates that have to hold at the end for success
    robot             the scene without what `furnish` adds to it
    arm               what of it is the arm
    """

    name: str
    title: str
    start_joints_rad: tuple[float, ...]
    furnish: Callable[[mujoco.MjSpec, Disturbance], None]
    parts: tuple[str, ...]
    pairs: Mapping[str, Pair] = field(hash=False)
    onsets: tuple[str, ...]
    ends_at_contact: bool
    events: tuple[Event, ...]
    checks: Callable[[Simulation], Mapping[str, bool]]
    robot: Callable[[], mujoco.MjSpec] = robot_spec
    arm: ArmNames = YUMI_ARM

    def build(self, disturbance: Disturbance = NOMINAL, seed: int = 0) -> Simulation:
        """A simulation of this workcell at its start, its wrist sensor calibrated.

        `seed` sets the sensor's noise. Raises SimulationError when the scene cannot be compiled.
        """
        return Simulation(self, self.spec(disturbance).compile(), disturbance, seed)

    def spec(self, disturbance: Disturbance = NOMINAL) -> mujoco.MjSpec:
        """The scene before it is compiled."""
        spec = self.robot()
        self.furnish(spec, disturbance)
        watch_contacts(spec, self.pairs)
        return spec

    def goals(self, simulation: Simulation) -> tuple[str, ...]:
        """Names of all that success asks of this workcell, before anything has happened."""
        return (*(event.name for event in self.events), *self.checks(simulation))
