"""Demonstrations made in MuJoCo, their truth read from the simulator's contacts: docs/making.md."""

from keyphase.simulation.making.simulated import SIMULATED, make_simulated

__all__ = ["SIMULATED", "make_simulated"]
