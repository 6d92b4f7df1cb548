"""Nothing is touched: reaching about, long paths with stops, carrying a tool whose weight shows."""

import numpy as np

from keyphase.making.draws import chance, direction, log_uniform
from keyphase.making.script import Script


def reach(script: Script) -> None:
    """From place to place, resting here and there, now and then round in circles."""
    rng = script.rng
    if chance(rng, 0.6):
        script.rest()
    resting = rng.uniform(0.2, 0.9)
    for _ in range(rng.integers(3, 13)):
        script.stroke()
        if chance(rng, resting):
            script.rest()
        if chance(rng, 0.08):
            script.rounds(rng.uniform(2.0, 5.0), rng.uniform(0.6, 1.0), 0.0)
            script.rest(0.5)
    if chance(rng, 0.6):
        script.rest()


def long_path(script: Script) -> None:
    """Up to 0.6 m and more, turning by more than 100 degrees, with dead stops of 0.5 to 2 s."""
    rng = script.rng
    if chance(rng, 0.7):
        script.rest()
    for _ in range(rng.integers(8, 26)):
        share = log_uniform(rng, 1.0, 3.0) if chance(rng, 0.3) else log_uniform(rng, 0.1, 1.0)
        largest = rng.uniform(1.0, 2.4) if chance(rng, 0.3) else rng.uniform(0.0, 0.6)
        script.stroke(script.way(share), direction(rng) * largest * min(1.0, share))
        if chance(rng, 0.5):
            script.path.rest(log_uniform(rng, 0.5, 2.0))
    if chance(rng, 0.7):
        script.rest()


def carry(script: Script) -> None:
    """About with a tool: whatever the wrench shows, it is no contact."""
    rng = script.rng
    script.rest(0.5)
    for _ in range(rng.integers(3, 11)):
        turn = direction(rng) * rng.uniform(0.0, np.pi / 2) if chance(rng, 0.4) else script.turn()
        script.stroke(turn=turn)
        if chance(rng, 0.5):
            script.rest()
    script.rest(0.3)
