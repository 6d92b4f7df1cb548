"""Moving what follows along where a contact was met elsewhere than demonstrated."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.skill import Skill


def shift_after(skill: Skill, ended_m: Array, shift_m: Array) -> Array:
    """How far (3,) the skills that follow are to be moved against their demonstration [m].

    Where a contact was met higher, lower or aside of the demonstrated one, what follows happens
    there: the difference along the contact's direction adds to the shift this skill ran with.
    ended_m (3,) is where it ended. Where the demonstration stayed in the contact, it is counted
    between where both pressed: that is there to the tenth of a millimetre, whenever exactly the
    segment was cut. Where it moved on, from the place where it met it to where it was cut: a tool
    that ends in between has met it where it was.

    A soft contact says little about where it is: there only what is missing by more than
    `skill.shift_beyond_m` counts, or nothing at all where that is None.
    """
    if skill.travel_direction is None or skill.shift_beyond_m is None:
        return shift_m
    press = skill.press
    direction = np.asarray(skill.travel_direction) if press is None else press.direction
    met_m = skill.end_position_m if skill.met_m is None else skill.met_m
    there = (skill.end_position_m, met_m) if press is None else (press.position_m,)
    places = [float(place @ direction) for place in there]
    at = float((ended_m - shift_m) @ direction)
    missing = at - min(max(at, min(places)), max(places))
    return shift_m + direction * missing if abs(missing) > skill.shift_beyond_m else shift_m
