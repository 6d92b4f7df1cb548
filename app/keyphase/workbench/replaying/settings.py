"""What a person chose for the next replay: the world it runs in, and how it ends and runs."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from keyphase.errors import ParameterError
from keyphase.simulation.choosing import world_in_words, world_names
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.wrist_sensor import SensorModel

EndBy = Literal["contact", "configuration"]
"""Whether skills that met a contact end at it again, or at the pose like all others."""

SPEEDS = (0.1, 4.0)

RANGES: Mapping[str, tuple[float, float]] = {
    "part_height_m": (-0.02, 0.02),
    "part_aside_m": (-0.01, 0.01),
    "friction": (0.05, 1.0),
    "sensor_noise": (0.0, 5.0),
    "speed": SPEEDS,
    "seed": (0, 1_000_000),
}
"""What can be chosen; the workcells themselves bear somewhat more."""

Action = Literal[
    "run", "again", "pause", "next", "hold", "release", "stop", "leave", "keep", "speed"
]
"""What a page may ask of a replay."""


@dataclass(frozen=True)
class ReplaySettings:
    """The settings.

    part_height_m  the table with all on it is higher by this much [m]
    part_aside_m   the part to be met lies aside by this much, along y [m]
    friction       Coulomb coefficient between parts and table
    sensor_noise   factor on the noise of the wrist sensor
    speed          replay time per real time
    seed           of the wrist sensor's noise

    Raises ParameterError for an unknown workcell or end, or a number out of its range.
    """

    workcell: str = "setup1"
    part_height_m: float = 0.0
    part_aside_m: float = 0.0
    friction: float = NOMINAL.friction
    sensor_noise: float = NOMINAL.sensor_noise
    end_by: EndBy = "contact"
    speed: float = 1.0
    seed: int = 0

    def __post_init__(self) -> None:
        _among("workcell", self.workcell, world_names())
        _among("end_by", self.end_by, get_args(EndBy))
        for name, (low, high) in RANGES.items():
            value = getattr(self, name)
            if not low <= value <= high:
                raise ParameterError(
                    f"{name} of a replay must lie from {low:g} to {high:g}, but is {value:g}."
                )

    @property
    def disturbance(self) -> Disturbance:
        """How the workcell differs from its nominal state."""
        return Disturbance(
            part_height_m=self.part_height_m,
            part_offset_m=(0.0, self.part_aside_m),
            friction=self.friction,
            sensor_noise=self.sensor_noise,
        )

    def in_words(self) -> str:
        """The world, for people: "in setup1, parts 6 mm higher"."""
        said = [f"in {world_in_words(self.workcell)}"]
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
        noise_N = self.sensor_noise * SensorModel().noise[0]
        return f"Seed {self.seed} · friction {self.friction:.2f} · sensor noise {noise_N:.2g} N"


def _among(name: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise ParameterError(f"{name} must be one of {', '.join(known)}, but is {value!r}.")
