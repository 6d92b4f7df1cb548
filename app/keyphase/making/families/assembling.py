"""Putting things together: inserting with a jam and a snap, screwing, handing over, two hands."""

from keyphase.making.contact import wrench
from keyphase.making.draws import Array, beside, chance, direction, log_uniform
from keyphase.making.script import APART_S, Script


def insert(script: Script) -> None:
    """Down to the rim, search, in, sometimes a jam that is freed, seated with a snap, and off."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 3)):
        script.strokes(1, 2, 0.5)
        script.touch(script.approach(), script.press(script.newton(0.3, 0.8)), _click(script))
        script.rest(0.3, 2.0)
        if chance(rng, 0.6):
            script.rounds(rng.uniform(1.0, 4.0), rng.uniform(0.6, 1.0), 0.0)
            script.rest(0.3, 1.0)
        in_hole = script.contact.level * rng.uniform(0.1, 0.4)
        script.touch(script.now_s + 0.1, in_hole, _click(script), "contact changed")
        _go_in(script, 0.5)
        if chance(rng, 0.5):
            _jam(script, in_hole)
        _go_in(script, 0.3)
        _grow(script, 0.6)
        seated = script.press(script.newton(0.8, 1.6))
        script.touch(script.now_s, seated, _click(script), "contact changed", ringing=0.6)
        script.rest(0.4, 3.0)
        script.leave(log_uniform(rng, 0.02, 0.5))
    script.end()


def snap(script: Script) -> None:
    """Contact, impacts and snaps in quick order, the force growing in between; they ring."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 3)):
        script.strokes(1, 2, 0.4)
        at = script.approach(0.3)
        rise = log_uniform(rng, 0.004, 0.06) if chance(rng, 0.6) else log_uniform(rng, 0.06, 0.5)
        script.touch(at, script.press(script.newton(0.1, 0.6)), rise, ringing=0.5)
        for _ in range(rng.integers(0, 5)):
            _wait_or_creep(script, script.contact.settled_s + APART_S)
            if chance(rng, 0.6):
                _grow(script, log_uniform(rng, 0.3, 2.0))
            else:
                _wait_or_creep(script, script.now_s + log_uniform(rng, 0.3, 2.5))
            step = _step(script)
            script.touch(
                script.now_s, script.contact.level + step, _click(script), "contact changed", 0.5
            )
        _wait_or_creep(script, script.contact.settled_s + APART_S)
        script.rest(0.3, 2.0)
        script.leave(log_uniform(rng, 0.01, 0.6))
    script.end()


def screw(script: Script) -> None:
    """On the screw, turn after turn with new grips, until it is tight, and off."""
    rng = script.rng
    script.begin()
    script.strokes(1, 2, 0.5)
    axis = direction(rng)
    script.touch(script.approach(0.25, axis), script.press(script.newton(0.4, 1.0)), _click(script))
    script.rest(0.4, 2.0)
    pitch = rng.uniform(0.0005, 0.003)
    for _ in range(rng.integers(2, 6)):
        angle = rng.uniform(0.8, 2.8)
        begun = script.now_s
        script.stroke(pitch * axis, angle * axis, script.hand.tempo * rng.uniform(0.8, 2.0))
        script.swing(begun, rng.uniform(0.02, 0.2))
        script.rest(0.4, 1.5)
        script.stroke(
            0.3 * pitch * beside(rng, axis),
            -angle * axis,
            script.hand.tempo * rng.uniform(0.6, 1.5),
        )
        script.rest(0.4, 1.5)
    script.stroke(
        pitch * axis, rng.uniform(0.5, 1.5) * axis, script.hand.tempo * rng.uniform(0.8, 2.0)
    )
    tight = script.contact.level.copy()
    tight[:3] *= rng.uniform(1.3, 2.0)
    tight[3:] += axis * script.hand.newton * rng.uniform(0.04, 0.15)
    script.touch(script.now_s, tight, log_uniform(rng, 0.01, 0.3), "contact changed")
    script.wait_until(script.contact.settled_s)
    script.rest(0.4, 2.0)
    script.leave(log_uniform(rng, 0.02, 0.6))
    script.end()


def hand_over(script: Script) -> None:
    """Bring a part to another hand that pulls and takes it, or take one, and go back."""
    rng = script.rng
    script.begin()
    for _ in range(rng.integers(1, 4)):
        script.strokes(1, 2, 0.4)
        script.rest(0.4, 3.0)
        pull = wrench(rng, script.newton())
        script.touch(script.now_s, pull, log_uniform(rng, 0.05, 0.8), "contact made")
        script.wait_until(script.contact.settled_s)
        script.rest(0.4, 3.0)
        load = wrench(rng, script.newton(0.2, 0.5))
        gives = chance(rng, 0.5)
        at = max(script.now_s, script.contact.changes[-1].time_s + APART_S)
        fall = log_uniform(rng, 0.02, 0.4)
        if gives:
            script.touch(at, load * 0.0, fall, "contact lost")
        else:
            script.touch(at, load, fall, "contact changed")
        script.wait_until(script.contact.settled_s + 0.2)
        script.stroke()
        if not gives:
            script.rest(0.4, 2.0)
            script.leave(log_uniform(rng, 0.05, 0.8))
    script.end()


def two_handed(script: Script) -> None:
    """A few quick seconds: lift a part, bring it to the other, slide, fold, let go."""
    rng = script.rng
    script.path.rest(log_uniform(rng, 0.25, 1.0))
    script.stroke(seconds=log_uniform(rng, 0.4, 1.2))
    at = script.approach(0.5)
    script.touch(at, script.press(script.newton(0.3, 1.0)), log_uniform(rng, 0.02, 0.2))
    _wait_or_creep(script, script.contact.settled_s + log_uniform(rng, 0.1, 0.6))
    for _ in range(rng.integers(0, 3)):
        script.stroke(script.way(0.3, beside(rng, script.facing)), None, log_uniform(rng, 0.2, 0.8))
        target = script.contact.level * rng.uniform(0.1, 0.4) + wrench(rng, script.newton(0.5, 1.5))
        script.touch(script.now_s, target, log_uniform(rng, 0.01, 0.15), "contact changed", 0.5)
        _wait_or_creep(script, script.contact.settled_s + log_uniform(rng, 0.05, 0.5))
    if chance(rng, 0.8):
        script.leave(log_uniform(rng, 0.02, 0.3))
    script.path.rest(log_uniform(rng, 0.25, 0.8))


def _jam(script: Script, freed: Array) -> None:
    """The force grows while nothing moves, until it lets go."""
    rng = script.rng
    jammed = script.press(script.newton(0.6, 1.5))
    script.touch(script.now_s, jammed, log_uniform(rng, 0.05, 0.8), "contact changed")
    script.wait_until(script.contact.settled_s)
    script.rest(0.3, 2.0)
    script.touch(script.now_s, freed, _click(script), "contact changed")
    script.wait_until(script.contact.settled_s + 0.1)


def _go_in(script: Script, share: float) -> None:
    way = script.way(share * log_uniform(script.rng, 0.1, 0.4), script.facing)
    begun = script.now_s
    script.stroke(way, script.turn(0.05))
    script.swing(begun, script.rng.uniform(0.02, 0.2))


def _grow(script: Script, seconds: float) -> None:
    """The force grows along itself: no event, the hand presses on."""
    level = script.contact.level
    size = float(sum(level[:3] ** 2)) ** 0.5
    more = script.newton(0.2, 0.8)
    grown = level * (1.0 + more / max(size, 0.1)) + 0.3 * wrench(script.rng, more)
    begun = max(script.now_s, script.contact.changes[-1].time_s + APART_S)
    script.touch(begun, grown, seconds, None)
    _wait_or_creep(script, begun + seconds)


def _step(script: Script) -> Array:
    if chance(script.rng, 0.5):
        return wrench(script.rng, script.newton(0.3, 1.2))
    return -script.contact.level * script.rng.uniform(0.35, 0.8)


def _wait_or_creep(script: Script, until_s: float) -> None:
    """Stand still until then, or move on a little, as a hand does that presses."""
    while script.now_s < until_s:
        if chance(script.rng, 0.4):
            way = script.way(log_uniform(script.rng, 0.02, 0.1), script.facing)
            script.stroke(way, script.turn(0.1), log_uniform(script.rng, 0.25, 0.8))
        script.path.rest(log_uniform(script.rng, 0.1, 0.8))


def _click(script: Script) -> float:
    return log_uniform(script.rng, 0.004, 0.1)
