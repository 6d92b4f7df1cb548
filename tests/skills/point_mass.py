"""A robot of one mass on its impedance, with floors that push back: enough to execute skills."""

import numpy as np

from keyphase.rotations import quaternions
from keyphase.skills import Sensed

MASS_KG, STIFFNESS, DAMPING = 2.0, 2000.0, 180.0
FLOOR_N_M, SUBSTEPS, H = 2e4, 40, 0.004


class PointMass:
    """A tool at `position_m` over a floor at height `floor_m`, followed at 250 Hz."""

    def __init__(self, position_m, floor_m=-10.0):
        self.position_m, self.velocity = np.array(position_m, float), np.zeros(3)
        self.floor_m = floor_m

    def force(self):
        depth = self.floor_m - self.position_m[2]
        push = max(FLOOR_N_M * depth - 40.0 * self.velocity[2], 0.0) if depth > 0.0 else 0.0
        return np.array([0.0, 0.0, push])

    def sense(self):
        velocity = np.concatenate((self.velocity, np.zeros(3)))
        upright = np.array(quaternions.IDENTITY)
        return Sensed(self.position_m.copy(), upright, velocity, self.force())

    def follow(self, reference):
        step = H / SUBSTEPS
        for _ in range(SUBSTEPS):
            spring = STIFFNESS * (reference.position_m - self.position_m)
            damper = DAMPING * (reference.velocity[:3] - self.velocity)
            self.velocity = self.velocity + step * (spring + damper + self.force()) / MASS_KG
            self.position_m = self.position_m + step * self.velocity
        return self.sense()


def executed(executor, robot, most_s=30.0, each_tick=None):
    """Run a plan to its end on a robot."""
    for _ in range(round(most_s / H)):
        sensed = robot.follow(executor.reference)
        if each_tick is not None:
            each_tick(sensed)
        executor.step(sensed)
        if executor.over:
            return executor
    raise AssertionError("the plan does not end")
