"""A recipe: how to read a table of somebody else's making.

Nothing has a default that could be wrong in silence: units, orders, layouts, frame and sign are
said. `docs/recipes.md` describes every word of the file a recipe is written in.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from keyphase.readers.orientation import MatrixLayout, QuaternionOrder
from keyphase.readers.recipes.columns import Columns
from keyphase.readers.table import TableForm

ISO = "iso"
"""The time format that stands for ISO 8601."""

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class RateTime:
    """No time in the table: rows follow each other at a rate."""

    rate_hz: float


@dataclass(frozen=True)
class NumberTime:
    """A column of numbers, `size` seconds each."""

    column: Columns
    size: float
    from_zero: bool


@dataclass(frozen=True)
class TwoPartTime:
    """Whole seconds in one column and nanoseconds in another, as message headers have them."""

    seconds: Columns
    nanoseconds: Columns

    @property
    def column(self) -> Columns:
        """The column that messages point at."""
        return self.seconds


@dataclass(frozen=True)
class StampTime:
    """A column of dates and times: ISO, or in a format of strptime. Counted from the first row."""

    column: Columns
    format: str


@dataclass(frozen=True)
class Scaled:
    """Columns of numbers and the size of their unit in SI."""

    columns: Columns
    size: float


@dataclass(frozen=True)
class Pose(Scaled):
    """Position and orientation as a 4x4 matrix; the size is that of its lengths."""

    layout: MatrixLayout


@dataclass(frozen=True)
class Quaternion:
    """Orientation as a quaternion, normalised only on request."""

    columns: Columns
    order: QuaternionOrder
    normalise: bool


@dataclass(frozen=True)
class Euler(Scaled):
    """Orientation as three angles; the sequence is SciPy's: lower case fixed axes, upper turned."""

    sequence: str


@dataclass(frozen=True)
class RotationVector(Scaled):
    """Orientation as axis times angle."""


@dataclass(frozen=True)
class Matrix:
    """Orientation as a 3x3 or 4x4 matrix."""

    columns: Columns
    layout: MatrixLayout


@dataclass(frozen=True)
class SixNumbers:
    """Orientation as the first two columns of the rotation matrix, one after the other (rot6d)."""

    columns: Columns


Orientation = Quaternion | Euler | RotationVector | Matrix | SixNumbers


@dataclass(frozen=True)
class Load(Scaled):
    """Force or torque, and the constant offset in it: given in its unit, or a mean to take."""

    offset: Vector | None
    offset_from_first_s: float | None


@dataclass(frozen=True)
class RobotForm:
    """The robot whose joints were logged: its description and the link that is the tool."""

    urdf: Path
    tool_frame: str


@dataclass(frozen=True)
class JointTorques(Scaled):
    """External joint torques, of which the wrench is worked out; sign -1: what the tool exerts."""

    sign: Literal[1, -1]


@dataclass(frozen=True)
class WrenchForm:
    """The frame of force and torque; sign -1 where they are what the tool exerts."""

    frame: Literal["base", "tool"]
    sign: Literal[1, -1]


@dataclass(frozen=True)
class WrenchFile:
    """A file of its own in which force and torque stand; `path` from the recording's folder."""

    path: str
    table: TableForm
    time: NumberTime


@dataclass(frozen=True)
class Split:
    """Rows of several demonstrations: told apart by a column, or, without, where time restarts."""

    column: Columns | None


@dataclass(frozen=True)
class Rows:
    """What to do about rows with the time of the row before, uneven steps and held channels.

    outliers  rows to which the tool jumps faster than any arm, and back
    missing   rows whose whole place holds this number, as it stands in the table
    empty     cells without a number: each channel goes without the rows in which it has one
    """

    repeated: Literal["refuse", "drop"] = "refuse"
    irregular: Literal["leave", "refuse", "resample"] = "leave"
    rate_hz: float | None = None
    held: Literal["leave", "interpolate"] = "leave"
    outliers: Literal["leave", "drop"] = "leave"
    missing: float | None = None
    empty: Literal["refuse", "leave_out"] = "refuse"


@dataclass(frozen=True)
class Recipe:
    """How to read one kind of table; `name` is what messages call it."""

    name: str
    table: TableForm
    time: RateTime | NumberTime | TwoPartTime | StampTime
    rows: Rows
    pose: Pose | None
    position: Scaled | None
    orientation: Orientation | None
    force: Load | None
    torque: Load | None
    wrench: WrenchForm | None
    joints: Scaled | None
    gripper: Scaled | None = None
    robot: RobotForm | None = None
    joint_torques: JointTorques | None = None
    clocks: Mapping[str, Columns] = field(default_factory=dict)
    """Clocks of their own, by the section they stand in, in the unit of [time]."""
    clock_offsets_s: Mapping[str, float] = field(default_factory=dict)
    """What is added to the times of a section, by its name."""
    named: Mapping[str, Columns] = field(default_factory=dict)
    """Further channels, taken as they are, by name."""
    events: Columns | None = None
    """A column of words: each change to another is an event."""
    wrench_file: WrenchFile | None = None
    split: Split | None = None
    """Where several demonstrations stand in one table, one below the other."""
    parts: Mapping[str, "Recipe"] = field(default_factory=dict)
    """Where several stand in one table side by side: how to read each, by its name."""
    sha256: str = ""
    """Of the recipe's text (hex)."""
