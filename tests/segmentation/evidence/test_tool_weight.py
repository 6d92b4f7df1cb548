"""A tool whose weight nobody subtracted shows newtons as it is turned; that is no contact."""

import numpy as np
from scipy.spatial.transform import Rotation

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation import segment

TOUCHED_S, LEFT_S = 8.0, 11.0


def turned_about_and_pressed(mass_kg: float) -> Demonstration:
    """Three turns on the way, then down until contact and up again; the sensor sits askew."""
    rng = np.random.default_rng(3)
    time = np.arange(0.0, 15.0, 0.01)
    position, turn = np.zeros((len(time), 3)), np.zeros((len(time), 3))
    for begin, end, way, angle in (
        (1.0, 2.2, (0.2, 0.1, 0.0), (1.2, 0.0, 0.0)),
        (3.0, 4.1, (0.0, 0.2, 0.1), (0.0, 0.9, 0.3)),
        (4.9, 6.0, (-0.2, 0.0, 0.1), (-0.7, 0.2, 0.0)),
        (6.8, TOUCHED_S, (0.0, 0.0, -0.08), (0.0, 0.0, 0.0)),
        (LEFT_S, 12.2, (0.0, 0.1, 0.08), (0.0, -0.6, 0.0)),
    ):
        part = synthetic.minimum_jerk(np.clip((time - begin) / (end - begin), 0.0, 1.0))[:, None]
        position, turn = position + part * np.array(way), turn + part * np.array(angle)
    rotation = Rotation.from_rotvec(turn)
    askew = Rotation.from_rotvec([0.4, -1.0, 0.7])
    weight = (rotation * askew).inv().apply([0.0, 0.0, -9.81 * mass_kg])
    force = weight + rng.normal(0.0, 0.05, weight.shape)
    torque = np.cross([0.0, 0.02, 0.09], weight) + rng.normal(0.0, 0.003, weight.shape)
    force[(time >= TOUCHED_S) & (time < LEFT_S)] += [1.0, -2.0, 6.0]
    wxyz = rotation.as_quat(scalar_first=True)
    return Demonstration("askew", time, position, wxyz, force, torque)


def test_turning_a_heavy_tool_is_no_contact():
    found = segment(turned_about_and_pressed(1.5))
    contacts = [b.time_s for b in found.boundaries if b.contact_change]
    np.testing.assert_allclose(contacts, [TOUCHED_S, LEFT_S], atol=0.1)
