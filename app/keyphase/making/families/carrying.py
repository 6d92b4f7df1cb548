"""Moving things: pushing parts along, picking and placing them with a gripper."""

import numpy as np

from keyphase.making.contact import wrench
from keyphase.making.draws import chance, log_uniform
from keyphase.making.script import APART_S, Script


def push(script: Script) -> None:
    """Against a part, along with it, against the next one, and away."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 4)):
        script.strokes(1, 2, 0.4)
        script.touch(
            script.approach(0.5),
            script.press(script.newton(0.3, 1.0)),
            log_uniform(rng, 0.005, 0.3),
        )
        if chance(rng, 0.3):
            script.wait_until(script.contact.settled_s)
            script.rest(0.4, 2.0)
        for _ in range(rng.integers(0, 3)):
            begun = script.now_s
            at = script.approach(log_uniform(rng, 0.5, 1.5), script.facing)
            script.swing(begun, rng.uniform(0.02, 0.25))
            meeting = script.contact.level + script.press(script.newton(0.4, 1.2))
            script.touch(at, meeting, log_uniform(rng, 0.005, 0.3), "contact changed")
        begun = script.now_s
        script.stroke(script.way(log_uniform(rng, 0.3, 1.0), script.facing), script.turn(0.2))
        script.swing(begun, rng.uniform(0.02, 0.25))
        if chance(rng, 0.7):
            script.rest(0.3, 2.0)
        script.leave(log_uniform(rng, 0.01, 0.5))
    script.end()


def pick_and_place(script: Script) -> None:
    """Down, close the gripper, lift the part's weight, carry, set it down, open, and up again."""
    rng = script.rng
    up = np.array([0.0, 0.0, 1.0])
    script.begin()
    for _ in range(rng.integers(1, 4)):
        script.strokes(1, 1, 0.4)
        script.stroke(script.way(log_uniform(rng, 0.2, 0.6), -up), script.turn(0.2))
        script.path.rest(log_uniform(rng, 0.4, 1.5))
        load = wrench(rng, script.newton(0.2, 1.0), -up)
        at = max(script.now_s, script.contact.settled_s + APART_S)
        script.wait_until(at)
        script.touch(at, load, log_uniform(rng, 0.03, 0.4), "contact made")
        script.stroke(script.way(log_uniform(rng, 0.2, 0.6), up), script.turn(0.2))
        script.strokes(0, 1, 0.3)
        script.stroke(turn=script.turn(1.5))
        script.facing = -up
        at = script.approach(log_uniform(rng, 0.2, 0.6), -up)
        script.touch(
            at,
            script.press(script.newton(0.2, 0.6)),
            log_uniform(rng, 0.01, 0.3),
            "contact changed",
        )
        script.wait_until(script.contact.settled_s)
        script.path.rest(log_uniform(rng, 0.4, 1.5))
        script.leave(log_uniform(rng, 0.02, 0.3), log_uniform(rng, 0.2, 0.6))
    script.end()
