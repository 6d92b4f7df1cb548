"""What the curve of a force says beside its steps."""

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.segmentation.evidence.force_curve import force_curves
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.motion import motion_of


def test_the_force_beside_an_end_is_as_unquiet_as_elsewhere():
    time = np.arange(0.0, 12.0, 0.02)
    force = np.random.default_rng(4).normal(0.0, 1.0, (len(time), 3))
    position = np.zeros((len(time), 3))
    recording = Demonstration("noise", time, position, None, force)
    quiet = force_curves(grid_of(recording, motion_of(recording))).quiet
    ends = np.minimum(quiet[:3, 20], quiet[:3, -20])
    assert (ends > 0.4 * np.median(quiet[:3], axis=1)).all()
