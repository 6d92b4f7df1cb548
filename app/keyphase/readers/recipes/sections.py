"""The sections of a recipe, each taken from its keys and checked."""

import re
from datetime import datetime
from pathlib import Path
from typing import Literal

from keyphase.errors import RecipeError
from keyphase.logged import MAX_CHANNELS, MAX_NAME_LENGTH, is_channel_name
from keyphase.readers.orientation import MatrixLayout, QuaternionOrder
from keyphase.readers.recipes.columns import Columns
from keyphase.readers.recipes.keys import Keys
from keyphase.readers.recipes.recipe import (
    ISO,
    Euler,
    JointTorques,
    Load,
    Matrix,
    NumberTime,
    Orientation,
    Pose,
    Quaternion,
    RateTime,
    RobotForm,
    RotationVector,
    Rows,
    Scaled,
    SixNumbers,
    Split,
    StampTime,
    TwoPartTime,
    WrenchFile,
    WrenchForm,
)
from keyphase.readers.recipes.units import Quantity
from keyphase.readers.table import TableForm

SEPARATORS: dict[str, str | None] = {
    **{character: character for character in ",;|:\t"},
    "tab": "\t",
    "whitespace": None,
}
ENCODINGS = {"utf-8": "utf-8-sig"} | {
    name: name for name in ("utf-16", "latin-1", "cp1252", "shift_jis", "gb18030")
}
"""As a recipe names them, and as Python does."""
_ORDERS: dict[str, QuaternionOrder] = {"wxyz": "wxyz", "xyzw": "xyzw"}
_LAYOUTS: dict[str, MatrixLayout] = {"row_major": "row_major", "column_major": "column_major"}
_EULER_SEQUENCE = re.compile("[xyz]{3}|[XYZ]{3}")
_FRAMES: dict[str, Literal["base", "tool"]] = {"base": "base", "tool": "tool"}


def split_of(keys: Keys | None) -> Split | None:
    """How several demonstrations in one table are told apart, or None where there is one."""
    if keys is None:
        return None
    column = keys.column("demonstration")
    restarts = keys.flag("time_starts_again", False)
    if column is not None and restarts:
        raise RecipeError(
            f"{keys.where}: expected demonstration or time_starts_again; keep one of them."
        )
    return Split(column) if column is not None or restarts else None


def table_of(keys: Keys | None) -> TableForm:
    """How the text is laid out."""
    if keys is None:
        return TableForm()
    form = TableForm(
        separator=keys.choice("separator", SEPARATORS, ","),
        skip_lines=keys.count("skip_lines", 0),
        header=keys.flag("header", True),
        encoding=keys.choice("encoding", ENCODINGS, "utf-8"),
        decimal=keys.choice("decimal", {".": ".", ",": ","}, "."),
        lines_after_header=keys.count("lines_after_header", 0),
    )
    if form.lines_after_header and not form.header:
        raise RecipeError(
            f"{keys.where}: lines_after_header are lines below the column names; where there are "
            "none, say skip_lines."
        )
    keys.finish()
    return form


def wrench_file_of(keys: Keys | None) -> WrenchFile | None:
    """The file of the wrench, its layout and its clock."""
    if keys is None:
        return None
    path, column = keys.text("path"), keys.column()
    if column is None:
        raise RecipeError(f"{keys.where}: the key 'column', that of its time, is missing; add it.")
    time = NumberTime(column, keys.unit("time"), keys.flag("from_zero", False))
    return WrenchFile(path, table_of(keys) or TableForm(), time)


def time_of(keys: Keys) -> RateTime | NumberTime | TwoPartTime | StampTime:
    """When each row was recorded."""
    if keys.has("seconds") or keys.has("nanoseconds"):
        return _two_part_time(keys)
    column, rate = keys.column(), keys.positive("rate_hz")
    if (column is None) == (rate is None):
        raise RecipeError(f"{keys.where}: expected either column or rate_hz; keep one of them.")
    if column is None or rate is not None:
        time = RateTime(rate or 1.0)
    elif keys.has("format"):
        time = StampTime(column, _time_format(keys))
    else:
        time = NumberTime(column, keys.unit("time"), keys.flag("from_zero", False))
    keys.finish()
    return time


def _two_part_time(keys: Keys) -> TwoPartTime:
    seconds, nanoseconds = keys.column("seconds"), keys.column("nanoseconds")
    if seconds is None or nanoseconds is None:
        raise RecipeError(f"{keys.where}: seconds and nanoseconds go together; add the other one.")
    keys.finish()
    return TwoPartTime(seconds, nanoseconds)


def _time_format(keys: Keys) -> str:
    text = keys.text("format")
    try:
        if text != ISO:
            datetime.strptime(datetime(2000, 1, 1).strftime(text), text)
    except (ValueError, re.error) as error:
        raise RecipeError(
            f"{keys.where}: format must be {ISO!r} or a format of strptime such as "
            f"'%Y-%m-%d %H:%M:%S.%f', but is {text[:60]!r} ({error})."
        ) from error
    return text


def rows_of(keys: Keys | None) -> Rows:
    """What to do about rows that are not as they should be."""
    if keys is None:
        return Rows()
    rows = Rows(
        repeated=keys.choice("repeated", {"refuse": "refuse", "drop": "drop"}, "refuse"),
        irregular=keys.choice(
            "irregular", {"leave": "leave", "refuse": "refuse", "resample": "resample"}, "leave"
        ),
        rate_hz=keys.positive("rate_hz"),
        held=keys.choice("held", {"leave": "leave", "interpolate": "interpolate"}, "leave"),
        outliers=keys.choice("outliers", {"leave": "leave", "drop": "drop"}, "leave"),
        missing=keys.number("missing"),
        empty=keys.choice("empty", {"refuse": "refuse", "leave_out": "leave_out"}, "refuse"),
    )
    if (rows.irregular == "resample") != (rows.rate_hz is not None):
        raise RecipeError(
            f"{keys.where}: rate_hz says what irregular = 'resample' resamples to; "
            "give both or neither."
        )
    keys.finish()
    return rows


def scaled_of(
    keys: Keys | None, counts: tuple[int, ...] | range, quantity: Quantity
) -> Scaled | None:
    """Columns of one quantity."""
    if keys is None:
        return None
    scaled = Scaled(keys.columns(counts), keys.unit(quantity))
    keys.finish()
    return scaled


def pose_of(keys: Keys | None) -> Pose | None:
    """A 4x4 matrix, or its first three rows."""
    if keys is None:
        return None
    pose = Pose(keys.columns((12, 16)), keys.unit("length"), keys.choice("layout", _LAYOUTS))
    keys.finish()
    return pose


def orientation_of(keys: Keys | None) -> Orientation | None:
    """The tool's orientation, by its kind."""
    if keys is None:
        return None
    kinds = {
        "quaternion": _quaternion,
        "euler": _euler,
        "rotation_vector": _rotation_vector,
        "matrix": _matrix,
        "rot6d": _six_numbers,
    }
    orientation = keys.choice("kind", kinds)(keys)
    keys.finish()
    return orientation


def _quaternion(keys: Keys) -> Orientation:
    order = keys.choice("order", _ORDERS)
    return Quaternion(keys.columns((4,)), order, keys.flag("normalise", False))


def _euler(keys: Keys) -> Orientation:
    sequence = keys.text("sequence")
    if not _EULER_SEQUENCE.fullmatch(sequence) or sequence[1] in (sequence[0], sequence[2]):
        raise RecipeError(
            f"{keys.where}: sequence must be three axes, xyz about the fixed ones (roll, pitch, "
            f"yaw) or XYZ about the turned ones, but is {sequence[:20]!r}."
        )
    return Euler(keys.columns((3,)), keys.unit("angle"), sequence)


def _rotation_vector(keys: Keys) -> Orientation:
    return RotationVector(keys.columns((3,)), keys.unit("angle"))


def _six_numbers(keys: Keys) -> Orientation:
    return SixNumbers(keys.columns((6,)))


def _matrix(keys: Keys) -> Orientation:
    return Matrix(keys.columns((9, 16)), keys.choice("layout", _LAYOUTS))


def load_of(keys: Keys | None, quantity: Quantity) -> Load | None:
    """Force or torque."""
    if keys is None:
        return None
    load = Load(
        columns=keys.columns((3,)),
        size=keys.unit(quantity),
        offset=keys.vector("offset"),
        offset_from_first_s=keys.positive("offset_from_first_s"),
    )
    if load.offset and load.offset_from_first_s:
        raise RecipeError(
            f"{keys.where}: expected offset or offset_from_first_s, not both; keep one of them."
        )
    keys.finish()
    return load


def named_of(keys: Keys | None) -> dict[str, tuple[Columns, Columns | None]]:
    """Further channels by name, each with the clock it follows where it has its own."""
    if keys is None:
        return {}
    found = {name: keys.column_and_clock(name) for name in keys.names()}
    wrong = next((name for name in found if not is_channel_name(name)), None)
    if wrong is not None or len(found) > MAX_CHANNELS:
        raise RecipeError(
            f"{keys.where}: expected at most {MAX_CHANNELS} names of at most {MAX_NAME_LENGTH} "
            f"printable characters without a slash, but {str(wrong)[:80]!r} stands there."
        )
    return found


def events_of(keys: Keys | None) -> Columns | None:
    """The column of words."""
    if keys is None:
        return None
    column = keys.column()
    if column is None:
        raise RecipeError(f"{keys.where}: the key 'column' is missing; add it.")
    keys.finish()
    return column


def robot_of(keys: Keys | None, folder: Path) -> RobotForm | None:
    """The robot description, its path relative to the recipe's folder."""
    if keys is None:
        return None
    robot = RobotForm(folder / keys.text("urdf"), keys.text("tool_frame"))
    keys.finish()
    return robot


def joint_torques_of(keys: Keys | None, counts: range) -> JointTorques | None:
    """External joint torques."""
    if keys is None:
        return None
    torques = JointTorques(keys.columns(counts), keys.unit("torque"), keys.sign())
    keys.finish()
    return torques


def wrench_of(keys: Keys | None) -> WrenchForm | None:
    """Frame and sign of the wrench."""
    if keys is None:
        return None
    wrench = WrenchForm(keys.choice("frame", _FRAMES), keys.sign())
    keys.finish()
    return wrench
