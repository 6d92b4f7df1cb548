"""A wipe whose first touch is so light that a careful eye sees it and a cautious line does not."""

from keyphase.making.draws import log_uniform
from keyphase.making.script import Script


def light_touch(script: Script) -> None:
    """Down until a light touch, hold, press on, wipe lines while the force swings, off."""
    rng = script.rng
    script.path.rest(rng.uniform(0.8, 1.5))
    script.stroke()
    script.path.rest(rng.uniform(0.6, 1.2))
    at = script.approach(0.4)
    firm = script.newton(0.8, 1.2)
    pressed = script.press(firm)
    script.touch(at, pressed * rng.uniform(0.03, 0.08), log_uniform(rng, 0.05, 0.3), ringing=0.0)
    script.path.rest(rng.uniform(1.2, 2.0))
    script.touch(script.now_s, pressed, rng.uniform(0.3, 0.8), "contact changed")
    script.wait_until(script.contact.settled_s)
    script.rounds(rng.uniform(5.0, 8.0), 0.0, 0.3 * script.hand.stroke_m)
    script.path.rest(0.4)
    script.leave(rng.uniform(0.1, 0.4))
    script.path.rest(rng.uniform(0.8, 1.2))
