"""Which arm follows a recording, and whether the robot may be moved."""

from dataclasses import dataclass


@dataclass(frozen=True)
class RobotChoice:
    """What a page chose of the robot; `arms` are the tools it could be."""

    arms: tuple[str, ...]
    arm: str
    moving: bool = False
