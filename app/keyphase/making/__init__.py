"""Demonstrations made by formula, without end and with exact truth: see docs/making.md."""

from keyphase.making.families import FAMILIES
from keyphase.making.folder import BY_FORMULA, make_folder
from keyphase.making.made import Event, Made
from keyphase.making.making import make

__all__ = ["BY_FORMULA", "FAMILIES", "Event", "Made", "make", "make_folder"]
