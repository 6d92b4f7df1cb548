"""Workcells in MuJoCo: recording, lead-through, control and a wrist sensor."""

from keyphase.simulation.demonstrating.recording import record
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.impedance import RATE_HZ, Gains, Reference
from keyphase.simulation.simulation import Sample, Simulation
from keyphase.simulation.workcells.registry import register, workcell, workcell_names
from keyphase.simulation.workcells.workcell import Event, Workcell

__all__ = [
    "NOMINAL",
    "RATE_HZ",
    "Disturbance",
    "Event",
    "Gains",
    "Reference",
    "Sample",
    "Simulation",
    "Workcell",
    "record",
    "register",
    "workcell",
    "workcell_names",
]
