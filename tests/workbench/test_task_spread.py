"""How far finished demonstrations of a task lie apart, for the scene."""

from itertools import pairwise

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.errors import SkillError
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary, Segment, Segmentation
from keyphase.workbench.showing.task_spread import task_spread


def labeled(aside_m: float, names: tuple[str, ...] = ("reach", "wait", "place")) -> Labeling:
    """Along x for three seconds, `aside_m` away along y; the middle phase is idle."""
    time = np.arange(301) / 100.0
    position = np.column_stack([0.1 * time, np.full_like(time, aside_m), 0 * time])
    edges = (0.0, 1.0, 2.0, 3.0)
    return label(
        Segmentation(
            Demonstration("one", time, position),
            Parameters(),
            tuple(Boundary(t, "position", (t, t), 0.9, False, None) for t in edges[1:-1]),
            tuple(
                Segment(a, b, name, name == "wait", ConfigurationEnd())
                for name, (a, b) in zip(names, pairwise(edges), strict=True)
            ),
            (),
            None,
            (),
            None,
        )
    )


def test_it_is_the_distance_from_the_mean_in_each_phase_that_is_executed():
    spread = task_spread(labeled(0.0), [labeled(0.02)])
    assert spread.count == 2
    np.testing.assert_allclose(spread.position_m[:, 1], 0.01, atol=1e-9)
    np.testing.assert_allclose(spread.spread_m, 0.01, atol=1e-9)
    assert set(spread.segment.tolist()) == {0, 2}
    assert not ((spread.position_m[:, 0] > 0.101) & (spread.position_m[:, 0] < 0.199)).any()


def test_recordings_with_other_phases_are_left_out():
    other = labeled(0.5, ("reach", "wait", "push"))
    assert task_spread(labeled(0.0), [other, labeled(0.02)]).count == 2


def test_without_another_of_the_same_phases_it_says_what_is_missing():
    with pytest.raises(SkillError, match="done \\(K\\) and has the same phases: reach, place"):
        task_spread(labeled(0.0), [labeled(0.5, ("reach", "wait", "push"))])
