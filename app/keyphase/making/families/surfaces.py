"""On a surface: pressing, wiping, sliding along edges, peeling."""

import numpy as np

from keyphase.making.draws import beside, chance, log_uniform
from keyphase.making.script import Script


def press(script: Script) -> None:
    """Down, hold, sometimes harder or softer, and off; contact comes in a click or in seconds."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 5)):
        script.strokes(1, 2, 0.35)
        rise = log_uniform(rng, 0.3, 2.0) if chance(rng, 0.6) else log_uniform(rng, 0.004, 0.3)
        at = script.approach()
        script.touch(at, script.press(script.newton()), rise)
        script.wait_until(at + rise)
        script.rest(0.4, 6.0)
        if chance(rng, 0.4):
            change = log_uniform(rng, 0.05, 1.2)
            share = rng.uniform(0.2, 0.5) if chance(rng, 0.5) else rng.uniform(1.6, 3.0)
            script.touch(script.now_s, share * script.contact.level, change, "contact changed")
            script.wait_until(script.now_s + change)
            script.rest(0.5, 4.0)
        script.leave(
            log_uniform(rng, 0.2, 2.0) if chance(rng, 0.6) else log_uniform(rng, 0.01, 0.2)
        )
    script.end()


def wipe(script: Script) -> None:
    """Down, lines or circles to and fro while the force swings, and off."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 4)):
        script.strokes(1, 2, 0.35)
        rise = log_uniform(rng, 0.3, 2.0) if chance(rng, 0.6) else log_uniform(rng, 0.01, 0.3)
        at = script.approach()
        script.touch(at, script.press(script.newton()), rise)
        if chance(rng, 0.5):
            script.wait_until(at + rise * rng.uniform(0.2, 1.0))
        for _ in range(rng.integers(1, 3)):
            drift = script.hand.stroke_m * rng.normal(0.0, 0.5)
            flatness = float(rng.choice([0.0, 0.0, rng.uniform(0.5, 1.0), 1.0]))
            script.rounds(log_uniform(rng, 2.0, 12.0), flatness, drift)
        fall = log_uniform(rng, 0.2, 1.5) if chance(rng, 0.6) else log_uniform(rng, 0.01, 0.2)
        script.leave(fall)
    script.end()


def slide(script: Script) -> None:
    """Down, along until an edge stops the tool, along that edge, and off."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 4)):
        script.strokes(1, 2, 0.35)
        at = script.approach()
        rise = log_uniform(rng, 0.004, 0.6)
        script.touch(at, script.press(script.newton(0.4, 1.0)), rise)
        script.wait_until(at + rise)
        if chance(rng, 0.6):
            script.rest(0.3)
        _along_until_an_edge(script)
        if chance(rng, 0.6):
            way = beside(rng, script.facing) * script.hand.stroke_m * log_uniform(rng, 0.3, 1.2)
            begun = script.now_s
            script.stroke(way, script.turn(0.3))
            script.swing(begun, rng.uniform(0.02, 0.2))
            if chance(rng, 0.5):
                script.rest(0.3)
        script.leave(log_uniform(rng, 0.02, 0.6))
    script.end()


def peel(script: Script) -> None:
    """Many short strokes in contact, the tool taken off between them, as with a peeler."""
    rng = script.rng
    script.begin()
    facing = script.facing
    for _ in range(rng.integers(3, 9)):
        script.strokes(1, 1, 0.2)
        rise = log_uniform(rng, 0.1, 1.0)
        at = script.approach(0.2, _near(script, facing))
        script.touch(at, script.press(script.newton()), rise)
        if chance(rng, 0.5):
            script.wait_until(at + rise * rng.uniform(0.2, 1.0))
        begun = script.now_s
        way = beside(rng, script.facing) * script.hand.stroke_m * log_uniform(rng, 0.3, 1.0)
        seconds = 0.5 * rise + script.hand.tempo * rng.uniform(0.8, 2.5)
        script.stroke(way, script.turn(0.5), seconds, hesitation=0.5)
        script.swing(begun, rng.uniform(0.05, 0.35))
        script.leave(log_uniform(rng, 0.1, 1.0), log_uniform(rng, 0.2, 0.8))
    script.end()


def _along_until_an_edge(script: Script) -> None:
    rng, pressed = script.rng, script.contact.level
    surface = script.facing
    begun = script.now_s
    along = beside(rng, surface)
    at = script.approach(log_uniform(rng, 0.6, 2.0), along)
    script.swing(begun, rng.uniform(0.02, 0.15))
    meeting = pressed + script.press(script.newton(0.4, 1.2))
    script.touch(at, meeting, log_uniform(rng, 0.004, 0.4), "contact changed")
    script.facing = surface
    script.wait_until(script.contact.settled_s)
    if chance(rng, 0.7):
        script.rest(0.3)


def _near(script: Script, facing: np.ndarray) -> np.ndarray:
    turned = facing + 0.2 * script.rng.normal(size=3)
    return turned / np.linalg.norm(turned)
