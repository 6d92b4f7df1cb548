"""Anything after anything: strokes, rests, rounds, contacts and releases in random order."""

from keyphase.making.contact import CLICK_S, wrench
from keyphase.making.draws import chance, log_uniform
from keyphase.making.script import Script


def mixed(script: Script) -> None:
    """A random program: what comes next depends on nothing but whether something is touched."""
    rng = script.rng
    if chance(rng, 0.6):
        script.rest()
    resting = 0.65 if chance(rng, 0.7) else 0.25
    touching = False
    for _ in range(rng.integers(4, 14)):
        if touching:
            touching = _in_contact(script)
        elif chance(rng, 0.5):
            at = script.approach(log_uniform(rng, 0.25, 1.5))
            click = chance(rng, 0.55)
            rise = log_uniform(rng, 0.004, CLICK_S) if click else log_uniform(rng, 0.1, 1.0)
            script.touch(at, script.press(script.newton(0.3, 1.5)), rise, ringing=0.4)
            script.wait_until(at + 0.5 * rise)
            touching = True
        elif chance(rng, 0.15):
            script.rounds(rng.uniform(2.0, 5.0), rng.uniform(0.6, 1.0), 0.0)
        else:
            script.stroke()
        if chance(rng, resting):
            script.rest()
    if chance(rng, 0.6):
        script.rest(0.3)


def _in_contact(script: Script) -> bool:
    rng = script.rng
    if chance(rng, 0.35):
        script.leave(
            log_uniform(rng, 0.01, 0.08) if chance(rng, 0.4) else log_uniform(rng, 0.1, 0.9)
        )
        return False
    begun = script.now_s
    script.stroke(script.way(log_uniform(rng, 0.1, 0.6)))
    if chance(rng, 0.5):
        step = wrench(rng, script.newton(0.4, 1.0))
        level = script.contact.level + step if chance(rng, 0.6) else step
        at = begun + rng.uniform(0.3, 0.9) * (script.now_s - begun)
        at = max(at, script.contact.settled_s + 0.3)
        script.touch(at, level, log_uniform(rng, 0.004, 0.12), "contact changed", 0.5)
        script.wait_until(at + 0.2)
    return True
