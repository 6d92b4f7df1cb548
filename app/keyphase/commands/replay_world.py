"""The options of `keyphase replay` that say how the world differs from the nominal one."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from keyphase.errors import ParameterError

if TYPE_CHECKING:
    from keyphase.simulation.disturbance import Disturbance
    from keyphase.simulation.replay.ranges import Range
    from keyphase.simulation.replay.trials import Worlds


@dataclass(frozen=True)
class WorldOptions:
    """A value for one replay, a value or a range a..b for trials; lengths in mm, angles in deg."""

    part_height: str = "0"
    """How much higher table and parts are, such as 10mm."""
    part_offset: str = "0"
    """How far aside the part lies, such as 5mm: to the left in a replay, in x and y in trials."""
    part_turn: str = "0"
    """How far the part is turned about the vertical, such as 5deg."""
    tilt: str = "0"
    """How far the held part is tilted in the gripper, such as 2deg."""
    friction: str = "0.3"
    """Friction between parts and table, such as 0.2..0.6."""
    mass: str = "1"
    """Factor on the masses of the free parts, such as 0.5..2."""
    sensor_noise: str = "1"
    """Factor on the noise of the wrist sensor."""
    sensor_bias: str = "0"
    """What the wrist sensor reads too much, in newtons."""
    sensor_drift: str = "1"
    """Factor on how fast the bias of the wrist sensor wanders."""

    def worlds(self) -> "Worlds":
        """What varies between the worlds of trials; a single length or angle a means -a..a."""
        from keyphase.simulation.replay.trials import Worlds

        return Worlds(
            part_height_m=self._range("part_height", symmetric=True),
            part_offset_m=self._range("part_offset", symmetric=True),
            part_turn_rad=self._range("part_turn", symmetric=True),
            tilt_rad=self._range("tilt", symmetric=True),
            friction=self._range("friction"),
            mass=self._range("mass"),
            sensor_noise=self._range("sensor_noise"),
            sensor_bias_N=self._range("sensor_bias"),
            sensor_drift=self._range("sensor_drift"),
        )

    def disturbance(self) -> "Disturbance":
        """The world of one replay. Raises ParameterError for a range."""
        from keyphase.simulation.disturbance import Disturbance

        return Disturbance(
            part_height_m=self._single("part_height"),
            part_offset_m=(0.0, self._single("part_offset")),
            part_turn_rad=self._single("part_turn"),
            tilt_rad=self._single("tilt"),
            friction=self._single("friction"),
            mass=self._single("mass"),
            sensor_noise=self._single("sensor_noise"),
            sensor_bias_N=self._single("sensor_bias"),
            sensor_drift=self._single("sensor_drift"),
        )

    def _range(self, name: str, *, symmetric: bool = False) -> "Range":
        from keyphase.simulation.replay.ranges import range_of

        return range_of(getattr(self, name), f"--{name.replace('_', '-')}", symmetric=symmetric)

    def _single(self, name: str) -> float:
        spread = self._range(name)
        if spread.single is None:
            raise ParameterError(
                f"One replay takes one value, but {spread.low:g}..{spread.high:g} is a range; "
                "add --trials."
            )
        return spread.single
