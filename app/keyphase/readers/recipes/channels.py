"""The columns a recipe chooses, as channels in SI units and keyphase's conventions."""

from collections.abc import Callable
from typing import assert_never

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.notices import Caution
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.orientation import (
    from_euler,
    from_matrices,
    from_quaternions,
    from_rotation_vectors,
    from_six_numbers,
    normalised,
    refuse_not_homogeneous,
    square_matrices,
    with_last_row,
)
from keyphase.readers.recipes.beside import clock_beside
from keyphase.readers.recipes.clocks import on_one_clock, refuse_clocks_apart
from keyphase.readers.recipes.columns import Columns
from keyphase.readers.recipes.measured import MeasuredRows
from keyphase.readers.recipes.recipe import (
    Euler,
    Load,
    Matrix,
    NumberTime,
    Orientation,
    Pose,
    Quaternion,
    RateTime,
    Recipe,
    RotationVector,
    Scaled,
    SixNumbers,
    StampTime,
    TwoPartTime,
)
from keyphase.readers.recipes.stamps import seconds_from_first
from keyphase.readers.table import Columned
from keyphase.readers.timing import refuse_not_increasing

Channels = dict[str, Array]
"""Channels by their names in Demonstration, time included."""

JOINT_TORQUES = "joint_torques_Nm"
"""A channel on the way only: of it the wrench is worked out."""

SECTIONS = {
    "pose": ("position_m", "orientation_wxyz"),
    "position": ("position_m",),
    "orientation": ("orientation_wxyz",),
    "force": ("force_N",),
    "torque": ("torque_Nm",),
    "joints": ("joints_rad",),
    "joint_torques": (JOINT_TORQUES,),
    "gripper": ("gripper",),
}
"""Sections of a recipe and the channels they make."""

_NAMED = "channel "
_LOADS = ("force_N", "torque_Nm")


def named_key(name: str) -> str:
    """Where a further channel stands among Channels and clocks."""
    return _NAMED + name


def without_named(channels: Channels) -> tuple[Channels, Channels]:
    """The channels a demonstration has fields for, and the further ones (N,) by name."""
    own = {key: values for key, values in channels.items() if not key.startswith(_NAMED)}
    named = {key[len(_NAMED) :]: channels[key][:, 0] for key in channels if key not in own}
    return own, named


Noted = tuple[Channels, tuple[str, ...]]
"""Channels, and what was done to them that a person should know."""

_THREE_ROWS = 12
_NORM_TOLD = 1e-5
"""What rounding to six digits does to a norm is not worth a notice."""


def channels_of(table: Columned, recipe: Recipe, beside: Columned | None = None) -> Noted:
    """All channels of `table` that `recipe` describes, row by row as they are recorded.

    Force and torque are those of `beside`, where a recipe names a file of their own.

    Raises RecipeError and DemonstrationError as `read_by_recipe` does.
    """
    rows = MeasuredRows(table, recipe)
    time, notices = _time(rows.table, recipe)
    channels = {"time_s": time}
    if recipe.pose:
        channels |= _pose(rows.of(recipe.pose.columns), recipe.pose)
    if recipe.position:
        channels["position_m"] = _scaled(rows.of(recipe.position.columns), recipe.position)
    if recipe.orientation:
        own = rows.of(recipe.orientation.columns)
        channels["orientation_wxyz"], more = _orientation(own, recipe.orientation)
        notices += more
    for name, form in _loads_and_joints(recipe).items():
        own = rows.of(form.columns) if beside is None or name not in _LOADS else beside
        channels[name] = _scaled(own, form)
    if recipe.gripper:
        channels["gripper"] = _opening(rows.of(recipe.gripper.columns), recipe.gripper)
    for name, column in recipe.named.items():
        own = rows.of(column)
        channels[named_key(name)] = own.numbers(column.find(own))
    return _on_one_clock(rows, recipe, channels, notices + rows.notices(), beside)


def _on_one_clock(
    rows: MeasuredRows,
    recipe: Recipe,
    channels: Channels,
    notices: tuple[str, ...],
    beside: Columned | None,
) -> Noted:
    """Nothing to do where no channel has a clock of its own."""
    time = channels.pop("time_s")
    _refuse_clocks_apart(rows.table, recipe)

    def clock_of(section: str, columns: Columns) -> Array:
        if beside is not None and recipe.wrench_file and section in ("force", "torque"):
            return clock_beside(beside, recipe.wrench_file, rows.table, recipe)
        if section in recipe.clocks:
            return _clock(rows.of(columns), recipe, recipe.clocks[section])
        return rows.times(columns, time)

    clocks = {
        channel: clock_of(section, columns) + recipe.clock_offsets_s.get(section, 0.0)
        for section, columns in _columns_of(recipe).items()
        for channel in SECTIONS.get(section, (section,))
    }
    lengths = {len(values) for values in channels.values()} | {len(time)}
    own = recipe.clocks or recipe.clock_offsets_s or beside is not None
    if not own and len(lengths) == 1:
        return {"time_s": time, **channels}, notices
    brought, more = on_one_clock(channels, clocks, recipe.name)
    moved = tuple(
        f"Moved the clock of {section} by {offset:+g} s."
        for section, offset in recipe.clock_offsets_s.items()
    )
    return brought, notices + moved + more


def _refuse_clocks_apart(table: Columned, recipe: Recipe) -> None:
    if isinstance(table, ArrayTable) and table.zeros:
        main = [recipe.time.column] if isinstance(recipe.time, NumberTime) else []
        found = [clock.find(table)[0] for clock in (*main, *recipe.clocks.values())]
        refuse_clocks_apart(table.zeros, [table.names[at] for at in found], recipe.name)


def _columns_of(recipe: Recipe) -> dict[str, Columns]:
    """What each section, or further channel, is read from."""
    forms = {section: getattr(recipe, section) for section in SECTIONS}
    found = {section: form.columns for section, form in forms.items() if form is not None}
    return found | {named_key(name): column for name, column in recipe.named.items()}


def _clock(table: Columned, recipe: Recipe, column: Columns) -> Array:
    """Seconds (N,) of a clock, in the unit of [time] and from the same zero."""
    form = recipe.time
    size = form.size if isinstance(form, NumberTime) else 1.0
    seconds = size * table.numbers(column.find(table))[:, 0]
    refuse_not_increasing(seconds, where(table, column))
    if isinstance(form, NumberTime) and form.from_zero:
        seconds = seconds - size * table.numbers(form.column.find(table))[0, 0]
    return seconds


def _opening(table: Columned, form: Scaled) -> Array:
    """Opening (N, 1): one column, or two fingers' places whose difference it is."""
    values = form.size * table.numbers(form.columns.find(table))
    return values if values.shape[1] == 1 else np.abs(values[:, :1] - values[:, 1:])


def _loads_and_joints(recipe: Recipe) -> dict[str, Scaled]:
    forms: dict[str, Load | Scaled | None] = {
        JOINT_TORQUES: recipe.joint_torques,
        "force_N": recipe.force,
        "torque_Nm": recipe.torque,
        "joints_rad": recipe.joints,
    }
    return {name: form for name, form in forms.items() if form is not None}


def where(
    table: Columned, columns: Columns, rows: NDArray[np.intp] | None = None
) -> Callable[[int], str]:
    """Names a row by its line and the columns looked at; `rows` are those of the table left."""
    found = columns.find(table)
    labels = table.label(found[0])
    if len(found) > 1:
        labels += f" to {table.label(found[-1])}"

    def name(row: int) -> str:
        in_table = row if rows is None else int(rows[row])
        return f"{table.file}: line {table.line(in_table)}, {labels}"

    return name


def _time(table: Columned, recipe: Recipe) -> tuple[Array, tuple[str, ...]]:
    form = recipe.time
    if isinstance(form, RateTime):
        step = 1.0 / form.rate_hz
        notice = f"The table has no time: its rows are taken to be {step:.6g} s apart."
        return np.arange(len(table)) / form.rate_hz, (notice,)
    if isinstance(form, TwoPartTime):
        return _two_part_time(table, form)
    if isinstance(form, StampTime):
        stamps = table.text(form.column.find(table)[0])
        seconds = seconds_from_first(stamps, form.format, where(table, form.column))
        return seconds, (f"Time is counted from the first row, stamped {stamps[0]}.",)
    seconds = form.size * table.numbers(form.column.find(table))[:, 0]
    if form.from_zero and seconds[0] != 0:
        notice = f"Time is counted from the first row, which is at {seconds[0]:.9g} s in the table."
        return seconds - seconds[0], (notice,)
    return seconds, ()


def row_times(table: Columned, recipe: Recipe) -> Array:
    """When each row of the table was recorded (N,) [s], in the demonstration's clock."""
    return _time(table, recipe)[0]


def _two_part_time(table: Columned, form: TwoPartTime) -> tuple[Array, tuple[str, ...]]:
    """Counted from the first row, so that nanoseconds are kept."""
    seconds = table.numbers(form.seconds.find(table))[:, 0]
    nanoseconds = table.numbers(form.nanoseconds.find(table))[:, 0]
    since = (seconds - seconds[0]) + (nanoseconds - nanoseconds[0]) * 1e-9
    stamp = f"{seconds[0]:.0f}.{nanoseconds[0]:09.0f}"
    return since, (f"Time is counted from the first row, stamped {stamp} s.",)


def _scaled(table: Columned, form: Scaled) -> Array:
    return form.size * table.numbers(form.columns.find(table))


def _pose(table: Columned, form: Pose) -> Channels:
    flat = table.numbers(form.columns.find(table))
    if flat.shape[1] == _THREE_ROWS:
        flat = with_last_row(flat, form.layout)
    matrices = square_matrices(flat, form.layout)
    row_name = where(table, form.columns)
    refuse_not_homogeneous(matrices, row_name)
    return {
        "position_m": form.size * matrices[:, :3, 3],
        "orientation_wxyz": from_matrices(matrices[:, :3, :3], row_name),
    }


def _orientation(table: Columned, form: Orientation) -> tuple[Array, tuple[str, ...]]:
    values = table.numbers(form.columns.find(table))
    row_name = where(table, form.columns)
    match form:
        case Quaternion():
            return _quaternion(values, form, row_name)
        case Euler():
            return from_euler(form.size * values, form.sequence), ()
        case SixNumbers():
            return from_six_numbers(values, row_name), ()
        case RotationVector():
            return from_rotation_vectors(form.size * values), ()
        case Matrix():
            matrices = square_matrices(values, form.layout)
            if matrices.shape[1] == 4:
                refuse_not_homogeneous(matrices, row_name)
            return from_matrices(matrices[:, :3, :3], row_name), ()
        case _:
            assert_never(form)


def _quaternion(
    values: Array, form: Quaternion, row_name: Callable[[int], str]
) -> tuple[Array, tuple[str, ...]]:
    if not form.normalise:
        return from_quaternions(values, form.order, row_name), ()
    furthest = np.max(np.abs(np.linalg.norm(values, axis=1) - 1.0))
    told = f"Quaternions were normalised; the furthest had a norm {furthest:.3g} from one."
    notices = (Caution(told),) if furthest > _NORM_TOLD else ()
    return from_quaternions(normalised(values, row_name), form.order, row_name), notices
