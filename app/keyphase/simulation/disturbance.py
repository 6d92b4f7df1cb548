"""How a workcell may differ from its nominal state."""

import math
from dataclasses import dataclass, fields

from keyphase.errors import SimulationError


@dataclass(frozen=True)
class Disturbance:
    """What is different from the nominal workcell; the default is the nominal one.

    part_height_m   the table with everything on it is higher by this much [m]
    part_offset_m   the part to be met lies aside by (x, y), base frame [m]
    friction        Coulomb coefficient between parts and table
    sensor_noise    factor on the noise of the wrist sensor
    tilt_rad        the held part sits tilted in the gripper, about the tool's y axis [rad]
    part_turn_rad   the part to be met is turned about the vertical [rad]
    mass            factor on the masses of the free parts
    sensor_bias_N   force the wrist sensor reads too much, in a direction of its seed's choosing [N]
    sensor_drift    factor on how fast the sensor's bias wanders

    Raises SimulationError for values the workcells are not built for.
    """

    part_height_m: float = 0.0
    part_offset_m: tuple[float, float] = (0.0, 0.0)
    friction: float = 0.3
    sensor_noise: float = 1.0
    tilt_rad: float = 0.0
    part_turn_rad: float = 0.0
    mass: float = 1.0
    sensor_bias_N: float = 0.0
    sensor_drift: float = 1.0

    def __post_init__(self) -> None:
        offset = max((abs(value) for value in self.part_offset_m), default=math.inf)
        if len(self.part_offset_m) != 2:
            raise SimulationError(
                f"part_offset_m must be two numbers, x and y, but is {self.part_offset_m}."
            )
        _within("part_height_m", self.part_height_m, -0.03, 0.03)
        _within("the larger part_offset_m", offset, 0.0, 0.02)
        _within("friction", self.friction, 0.01, 1.5)
        _within("sensor_noise", self.sensor_noise, 0.0, 100.0)
        _within("tilt_rad", self.tilt_rad, -0.05, 0.05)
        _within("part_turn_rad", self.part_turn_rad, -0.35, 0.35)
        _within("mass", self.mass, 0.1, 20.0)
        _within("sensor_bias_N", self.sensor_bias_N, 0.0, 10.0)
        _within("sensor_drift", self.sensor_drift, 0.0, 100.0)

    def as_json(self) -> dict[str, object]:
        """Plain values, for the metadata of a recording; of the later ones only what is unusual."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        usual = {name: getattr(NOMINAL, name) for name in _LATER}
        said = {name: value for name, value in values.items() if usual.get(name, ...) != value}
        return {**said, "part_offset_m": list(self.part_offset_m)}


_LATER = ("part_turn_rad", "mass", "sensor_bias_N", "sensor_drift")
"""What recordings could not differ in at first: those that do not keep their bytes."""


def _within(name: str, value: float, low: float, high: float) -> None:
    if not (math.isfinite(value) and low <= value <= high):
        raise SimulationError(
            f"{name} of a disturbance must lie from {low:g} to {high:g}, but is {value:g}; "
            "give a smaller disturbance."
        )


NOMINAL = Disturbance()
"""Nothing is disturbed."""
