"""What a robot measures at one tick, as an executor takes it in."""

from dataclasses import dataclass

from keyphase.demonstration import Array
from keyphase.skills.coupling import Measured


@dataclass(frozen=True, eq=False)
class Sensed(Measured):
    """Measured pose (3,), (4,) w x y z, velocity (6,) [m/s, rad/s] and force (3,) [N], base frame.

    The force is what the environment exerts on the tool. `gripper` is its opening, in the unit it
    was demonstrated in; None where nobody measures it.
    """

    force_N: Array
    gripper: float | None = None
