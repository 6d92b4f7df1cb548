"""What a person chose for the next replay: the world it runs in, and how it ends and runs."""

from dataclasses import dataclass
from typing import Literal, get_args

from keyphase.errors import ParameterError
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.wrist_sensor import SensorModel

WORKCELLS = ("setup1", "setup2")

EndBy = Literal["contact", "configuration"]
"""Whether skills that met a contact end at it again, or at the pose like all others."""

SPEEDS = (0.1, 4.0)

Action = Literal[
    "run", "again", "pause", "next", "hold", "release", "stop", "leave", "keep", "speed"
]
"""What a page may ask of a replay."""


@dataclass(frozen=True)
class ReplaySettings:
    """The settings; heights and offsets beyond what workcells are built for are refused there.

    part_height_m  the table with all on it is higher by this much [m]
    part_aside_m   the part to be met lies aside by this much, along y [m]
    speed          replay time per real time
    seed           of the wrist sensor's noise

    Raises ParameterError for an unknown workcell or end, or a speed out of range.
    """

    workcell: str = WORKCELLS[0]
    part_height_m: float = 0.0
    part_aside_m: float = 0.0
    end_by: EndBy = "contact"
    speed: float = 1.0
    seed: int = 0

    def __post_init__(self) -> None:
        _among("workcell", self.workcell, WORKCELLS)
        _among("end_by", self.end_by, get_args(EndBy))
        low, high = SPEEDS
        if not low <= self.speed <= high:
            raise ParameterError(
                f"The speed of a replay must lie from {low:g} to {high:g}, but is {self.speed:g}."
            )

    @property
    def disturbance(self) -> Disturbance:
        """How the workcell differs from its nominal state."""
        return Disturbance(part_height_m=self.part_height_m, part_offset_m=(0.0, self.part_aside_m))

    def in_words(self) -> str:
        """The world, for people: "setup1, parts 6 mm higher"."""
        said = [self.workcell]
        if self.part_height_m:
            way = "higher" if self.part_height_m > 0 else "lower"
            said.append(f"parts {1e3 * abs(self.part_height_m):.3g} mm {way}")
        if self.part_aside_m:
            said.append(f"part {1e3 * abs(self.part_aside_m):.3g} mm aside")
        if self.end_by != "contact":
            said.append("without contact ends")
        return ", ".join(said)

    def world(self) -> str:
        """What else the world is made of: "Seed 0 · friction 0.30 · sensor noise 0.1 N"."""
        noise_N = SensorModel().noise[0]
        return f"Seed {self.seed} · friction {NOMINAL.friction:.2f} · sensor noise {noise_N:.2g} N"


def _among(name: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise ParameterError(f"{name} must be one of {', '.join(known)}, but is {value!r}.")
