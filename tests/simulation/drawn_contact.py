"""A drawn demonstration of contact: down onto a table, pressing, sideways in contact."""

from dataclasses import replace

import numpy as np
from replaying import Drawn

from keyphase.demonstration import Demonstration
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills.connecting import minimum_jerk

PRESSED_N, FRICTION, DEPTH_M, SLID_M = 6.0, 0.2, 0.06, 0.04
DOWN_S, PRESS_S, SLIDE_S = 1.2, 0.5, 1.5


def pressed_slide(offset_N: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Demonstration:
    """Positions and forces at 250 Hz; the sensor reads `offset_N` in free space, too."""
    time = np.arange(round((DOWN_S + PRESS_S + SLIDE_S) * 250) + 1) / 250
    down = minimum_jerk(np.clip(time / DOWN_S, 0.0, 1.0))
    along = minimum_jerk(np.clip((time - DOWN_S - PRESS_S) / SLIDE_S, 0.0, 1.0))
    position = np.c_[0.4 + SLID_M * along, np.zeros_like(time), 0.2 - DEPTH_M * down]
    pressed = PRESSED_N * np.clip((time - DOWN_S + 0.25) / 0.04, 0.0, 1.0)
    rubbed = -FRICTION * pressed * (np.gradient(along, time) > 0.01)
    force = np.c_[rubbed, np.zeros_like(time), pressed] + np.array(offset_N)
    wxyz = np.tile([1.0, 0.0, 0.0, 0.0], (len(time), 1))
    return Demonstration("pressed slide", time, position, wxyz, force)


def its_plan() -> list[Drawn]:
    touched_s = DOWN_S - 0.25
    return [
        Drawn(0.0, touched_s, "down until contact", ContactEnd((0.0, 0.0, 1.0), 3.0)),
        Drawn(touched_s, DOWN_S + PRESS_S + SLIDE_S, "slide"),
    ]


def reversed_force(demonstration: Demonstration) -> Demonstration:
    assert demonstration.force_N is not None
    return replace(demonstration, force_N=-demonstration.force_N)
