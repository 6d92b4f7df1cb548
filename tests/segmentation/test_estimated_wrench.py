"""A wrench worked out of joint torques makes small steps of its own: they count for less."""

from dataclasses import replace

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.segmentation import Parameters, segment


def pressed(estimated: bool, step_N: float = 1.2) -> Demonstration:
    """A tool that moves down, presses a little for three seconds, and rises."""
    time = np.arange(1000) / 100
    height = np.interp(time, [1, 3, 6, 8], [0.2, 0.05, 0.05, 0.2])
    position = np.stack([0 * time + 0.4, 0 * time, height], axis=1)
    force = np.random.default_rng(0).normal(0, 0.02, position.shape)
    force[(time > 3.0) & (time < 6.0), 2] += step_N
    return Demonstration("run", time, position, force_N=force, wrench_estimated=estimated)


def contact_changes(demonstration: Demonstration, **parameters: float) -> int:
    found = segment(demonstration, replace(Parameters(), **parameters))
    return sum(boundary.contact_change for boundary in found.boundaries)


def test_a_step_of_little_more_than_a_newton_counts_only_where_it_was_measured() -> None:
    assert contact_changes(pressed(estimated=False)) == 2
    assert contact_changes(pressed(estimated=True)) == 0


def test_the_step_of_a_real_contact_counts_all_the_same() -> None:
    assert contact_changes(pressed(estimated=True, step_N=6.0)) == 2


def test_a_person_says_which_step_counts() -> None:
    assert contact_changes(pressed(estimated=True), least_step_N=0.5) == 2
