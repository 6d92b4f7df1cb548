# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""The simulator's own view of which parts touch, against MuJoCo's contacts one by one."""

import mujoco
import numpy as np

from keyphase.simulation import Reference, Simulation
from keyphase.simulation.workcells.setup1 import SETUP1

DOWN_M_S = 0.05


def summed_one_by_one(simulation: Simulation) -> np.ndarray:
    """Normal forces from `mj_contactForce`, each contact asked for the names of its geoms."""
    model, data = simulation.model, simulation.data
    total, wrench = np.zeros(len(simulation.contacts.names)), np.zeros(6)
    for number in range(data.ncon):
        first, second = (model.geom(geom).name for geom in data.contact[number].geom)
        mujoco.mj_contactForce(model, data, number, wrench)
        for index, (these, those) in enumerate(simulation.workcell.pairs.values()):
            if (first in these and second in those) or (second in these and first in those):
                total[index] += wrench[0]
    return total


def test_forces_follow_what_touches_as_parts_meet_and_part() -> None:
    simulation = SETUP1.build(seed=1)
    above = simulation.part_poses()["housing"][0] + [0.0, 0.0, 0.09]
    wxyz = simulation.here().orientation_wxyz
    touched = []
    for tick in range(1500):
        lower = DOWN_M_S * min(tick, 1500 - tick) / 250.0
        simulation.step(Reference(above - [0.0, 0.0, lower], wxyz))
        forces = simulation.contacts.normal_forces(simulation.data.sensordata)
        assert np.allclose(forces, summed_one_by_one(simulation), atol=1e-9)
        touched.append(bool(forces.any()))
    assert any(touched)
    assert not touched[0]
    assert not touched[-1]
