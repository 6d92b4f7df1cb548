"""Demonstrations made in MuJoCo, their truth read from the simulator's contacts: docs/making.md."""

from keyphase.simulation.making.set_ups import SET_UPS, recorded_set_up
from keyphase.simulation.making.simulated import SIMULATED, make_simulated

__all__ = ["SET_UPS", "SIMULATED", "make_simulated", "recorded_set_up"]
