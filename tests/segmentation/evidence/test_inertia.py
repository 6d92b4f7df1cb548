"""A heavy tool behind the sensor shows newtons as it sets off and stops; that is no contact."""

import numpy as np
import pytest

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.making import make
from keyphase.segmentation import segment
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.evidence.tool.inertia import without_inertia
from keyphase.segmentation.motion import motion_of

TOUCHED_S, LEFT_S = 4.0, 6.5


def there_and_back_with_a_tool(mass_kg: float) -> Demonstration:
    """Aside, down until contact, up, aside; the tool's weight and inertia are left in."""
    rng = np.random.default_rng(8)
    time = np.arange(0.0, 12.0, 0.01)
    position = np.zeros((len(time), 3))
    for begin, end, way in (
        (1.0, 2.0, (0.25, 0.1, 0.0)),
        (2.8, TOUCHED_S, (0.0, 0.0, -0.06)),
        (LEFT_S, 7.6, (0.0, 0.0, 0.06)),
        (8.6, 9.8, (-0.2, 0.1, 0.0)),
    ):
        part = synthetic.minimum_jerk(np.clip((time - begin) / (end - begin), 0.0, 1.0))
        position += part[:, None] * np.array(way)
    acceleration = np.gradient(np.gradient(position, time, axis=0), time, axis=0)
    force = mass_kg * (acceleration - [0.0, 0.0, 9.81])
    force[(time >= TOUCHED_S) & (time < LEFT_S), 2] += 8.0
    force += rng.normal(0.0, 0.05, force.shape)
    return Demonstration("tool", time, position + rng.normal(0.0, 2e-5, force.shape), None, force)


def test_setting_off_and_stopping_with_a_heavy_tool_is_no_contact():
    found = segment(there_and_back_with_a_tool(2.0))
    contacts = [b.time_s for b in found.boundaries if b.contact_change]
    np.testing.assert_allclose(contacts, [TOUCHED_S, LEFT_S], atol=0.1)


def test_a_light_tool_is_taken_as_it_was_recorded():
    found = segment(there_and_back_with_a_tool(0.0))
    contacts = [b.time_s for b in found.boundaries if b.contact_change]
    np.testing.assert_allclose(contacts, [TOUCHED_S, LEFT_S], atol=0.06)


@pytest.mark.parametrize(("family", "seed"), [("screw", 1_000_004), ("insert", 1_000_007)])
def test_a_contact_that_rattles_while_the_tool_all_but_stands_tells_of_no_mass(family, seed):
    recorded = make(family, seed).demonstration
    grid = grid_of(recorded, motion_of(recorded))
    assert without_inertia(grid, speed_of(grid)) is grid
