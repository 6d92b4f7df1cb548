"""Tables of somebody else's making, read by a recipe.

Columns become channels in SI units; then come, in this order, repeated rows, the wrench's offset,
sign and frame, held channels, and uneven rows. Each step says in the notices what it did.
"""

from dataclasses import replace

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError, RecipeError
from keyphase.files.reading import WholeFile
from keyphase.logged import Event, events_in_words
from keyphase.notices import Caution
from keyphase.readers.build import build
from keyphase.readers.held import find_hold
from keyphase.readers.recipes.bad_rows import without_bad_rows
from keyphase.readers.recipes.beside import table_beside
from keyphase.readers.recipes.by_joints import by_joints
from keyphase.readers.recipes.channels import (
    Channels,
    Noted,
    channels_of,
    row_times,
    where,
    without_named,
)
from keyphase.readers.recipes.recipe import RateTime, Recipe
from keyphase.readers.recipes.several import recipe_of_part, rows_of_part
from keyphase.readers.resampling import SMOOTH, interpolate_hold, resample
from keyphase.readers.table import Columned, open_table
from keyphase.readers.timing import irregularity, refuse_not_increasing
from keyphase.readers.wrench import in_base_frame, offset_of

_FINER, _MIN_ROOM = 10, 10_000
"""Resampling makes at most so many times the rows that were recorded, or so many rows."""

_MAX_REPEATED = 0.5
"""Where more rows are repeated than not, it is the clock that is wrong, not the rows."""

_LOADS = {"force_N": "N", "torque_Nm": "N m"}


def read_by_recipe(
    file: WholeFile, recipe: Recipe, limit_bytes: int, part: str | None = None
) -> Demonstration:
    """The demonstration in a table, or the one called `part` where it holds several.

    Raises RecipeError where recipe and table do not fit, DemonstrationError, with line and column,
    where the table holds what cannot be.
    """
    recipe = recipe_of_part(recipe, part, file.name)
    table = open_table(file.name, file.data, recipe.table, limit_bytes)
    if recipe.split is not None:
        table = rows_of_part(table, recipe, part)
    return demonstration_of(table, file, recipe, limit_bytes, table.notices)


def demonstration_of(
    table: Columned,
    file: WholeFile,
    recipe: Recipe,
    limit_bytes: int,
    told: tuple[str, ...] = (),
) -> Demonstration:
    """The demonstration in the columns that a recipe chooses; errors as in `read_by_recipe`.

    `told` are the notices of whoever opened the table; they come first.
    """
    beside = table_beside(file.source.path, recipe, limit_bytes)
    channels, notices = channels_of(table, recipe, beside and beside.table)
    notices = told + notices
    if beside is not None:
        notices += (f"Force and torque are those of {beside.table.file}.",)
    events = _events(table, recipe)
    channels, more = by_joints(channels, recipe)
    notices += more
    channels, more = without_bad_rows(channels, recipe.rows, table.line)
    notices += more
    channels, more = _distinct(channels, recipe, table)
    _refuse_single_row(channels, file.name)
    notices += more
    for step in (_without_offset, _acting_on_tool, _in_base, _interpolated):
        channels, more = step(channels, recipe)
        notices += more
    channels, more = _even(channels, recipe, limit_bytes, file.name)
    notices += more
    if "gripper" in channels:
        channels["gripper"] = channels["gripper"][:, 0]
    known_by = recipe.sha256 if beside is None else beside.with_recipe(recipe.sha256)
    source = replace(file.source, recipe=recipe.name, recipe_sha256=known_by)
    read = replace(file, source=source)
    own, named = without_named(channels)
    told = (f"Read with the recipe {recipe.name}.", *notices)
    estimated = recipe.joint_torques is not None
    return build(read, own, named=named, events=events, wrench_estimated=estimated, notices=told)


def _events(table: Columned, recipe: Recipe) -> tuple[Event, ...]:
    """What a column of words says, row by row."""
    if recipe.events is None:
        return ()
    words, time_s = table.text(recipe.events.find(table)[0]), row_times(table, recipe)
    if len(words) != len(time_s):
        raise RecipeError(
            f"{recipe.name}: [events]: expected a word for each of {len(time_s)} rows, but there "
            f"are {len(words)}; choose a column that has the clock of [time]."
        )
    return events_in_words(time_s, words)


def _distinct(channels: Channels, recipe: Recipe, table: Columned) -> Noted:
    """Rows that are each later than the one before."""
    if isinstance(recipe.time, RateTime):
        return channels, ()
    repeats = np.concatenate([[False], np.diff(channels["time_s"]) == 0])
    if recipe.rows.repeated == "refuse" or not repeats.any():
        refuse_not_increasing(channels["time_s"], where(table, recipe.time.column))
        return channels, ()
    if repeats.mean() > _MAX_REPEATED:
        raise DemonstrationError(
            f"{table.file}: {int(repeats.sum())} of {len(repeats)} rows have the time of the row "
            f"before: {table.label(recipe.time.column.find(table)[0])} is too coarse to tell them "
            "apart; name another, such as [time] seconds and nanoseconds."
        )
    rows = np.flatnonzero(~repeats)
    kept = {channel: values[rows] for channel, values in channels.items()}
    refuse_not_increasing(kept["time_s"], where(table, recipe.time.column, rows))
    first = table.line(int(np.argmax(repeats)))
    notice = f"Dropped {repeats.sum()} rows with the time of the row before, first line {first}."
    return kept, (Caution(notice),)


def _refuse_single_row(channels: Channels, file: str) -> None:
    if len(channels["time_s"]) < 2:
        raise DemonstrationError(
            f"{file}: expected at least two rows at different times, but there is one; "
            "record or export the file again."
        )


def _without_offset(channels: Channels, recipe: Recipe) -> Noted:
    changed, notices = dict(channels), ()
    for channel, load in (("force_N", recipe.force), ("torque_Nm", recipe.torque)):
        offset = offset_of(load, channels[channel], channels["time_s"]) if load else None
        if load and offset is not None:
            changed[channel] = channels[channel] - offset
            numbers = ", ".join(f"{value:.4g}" for value in offset)
            since = load.offset_from_first_s
            source = f", the mean of the first {since:g} s" if since else ""
            notices += (f"Took the offset ({numbers}) {_LOADS[channel]}{source} out of {channel}.",)
    return changed, notices


def _acting_on_tool(channels: Channels, recipe: Recipe) -> Noted:
    """What the environment exerts on the tool, where the table has the opposite."""
    if recipe.wrench is None or recipe.wrench.sign == 1:
        return channels, ()
    turned = {channel: -channels[channel] for channel in _loads(channels)}
    return channels | turned, (f"Turned the sign of {' and '.join(turned)}.",)


def _in_base(channels: Channels, recipe: Recipe) -> Noted:
    if recipe.wrench is None or recipe.wrench.frame == "base":
        return channels, ()
    orientation = channels["orientation_wxyz"]
    turned = {
        channel: in_base_frame(channels[channel], orientation) for channel in _loads(channels)
    }
    notice = f"Turned {' and '.join(turned)} from the tool's frame into the base frame."
    return channels | turned, (notice,)


def _interpolated(channels: Channels, recipe: Recipe) -> Noted:
    if recipe.rows.held == "leave":
        return channels, ()
    time, changed, notices = channels["time_s"], dict(channels), ()
    for channel, values in channels.items():
        hold = find_hold(time, values) if channel in SMOOTH else None
        if hold:
            changed[channel] = interpolate_hold(channel, time, values, hold)
            told = (
                f"Interpolated {channel} between the {len(hold.fresh_rows)} of {len(time)} rows at "
                f"which it changed (about {hold.rate_hz:.3g} Hz)."
            )
            notices += (Caution(told),)
    return changed, notices


def _even(channels: Channels, recipe: Recipe, limit_bytes: int, file: str) -> Noted:
    time, rate = channels["time_s"], recipe.rows.rate_hz
    if recipe.rows.irregular == "refuse" and (phrase := irregularity(time)):
        raise DemonstrationError(
            f"{file}: expected evenly spaced rows, but the {phrase}; "
            f"let the recipe {recipe.name} leave or resample them."
        )
    if rate is None:
        return channels, ()
    columns = sum(values[:1].size for values in channels.values())
    rows = (time[-1] - time[0]) * rate
    if rows * columns * time.itemsize > limit_bytes or rows > max(_MIN_ROOM, _FINER * len(time)):
        raise RecipeError(
            f"{recipe.name}: [rows]: {rate:g} Hz over {time[-1] - time[0]:.6g} s makes more "
            "samples than the limit allows; choose a lower rate_hz."
        )
    resampled = resample(channels, rate)
    notice = f"Resampled {len(time)} rows to {len(resampled['time_s'])} at {rate:g} Hz."
    return resampled, (Caution(notice),)


def _loads(channels: Channels) -> list[str]:
    return [channel for channel in _LOADS if channel in channels]
