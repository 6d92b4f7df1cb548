"""Recipes as files: TOML, every word of which is known and checked."""

import re
import tomllib
from datetime import datetime
from pathlib import Path
from typing import Literal

from keyphase.errors import RecipeError
from keyphase.readers.orientation import MatrixLayout, QuaternionOrder
from keyphase.readers.recipes.keys import Keys
from keyphase.readers.recipes.recipe import (
    ISO,
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
    Rows,
    Scaled,
    StampTime,
    WrenchForm,
)
from keyphase.readers.recipes.units import Quantity
from keyphase.readers.table import TableForm

_LONGEST_RECIPE = 1_000_000
_MOST_JOINTS = 100
_SEPARATORS: dict[str, str | None] = {
    **{character: character for character in ",;|:\t"},
    "tab": "\t",
    "whitespace": None,
}
_ENCODINGS = {"utf-8": "utf-8-sig"} | {
    name: name for name in ("utf-16", "latin-1", "cp1252", "shift_jis", "gb18030")
}
_ORDERS: dict[str, QuaternionOrder] = {"wxyz": "wxyz", "xyzw": "xyzw"}
_LAYOUTS: dict[str, MatrixLayout] = {"row_major": "row_major", "column_major": "column_major"}
_EULER_SEQUENCE = re.compile("[xyz]{3}|[XYZ]{3}")
_FRAMES: dict[str, Literal["base", "tool"]] = {"base": "base", "tool": "tool"}


def load_recipe(path: Path | str) -> Recipe:
    """Read and check a recipe file.

    Raises RecipeError for what is no TOML, for words that are not known (with the nearest one that
    is), for missing ones and for values that cannot be.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            data = file.read(_LONGEST_RECIPE + 1)
    except OSError as error:
        raise RecipeError(
            f"{path}: the recipe cannot be read ({error.strerror}); check the path."
        ) from error
    if len(data) > _LONGEST_RECIPE:
        raise RecipeError(
            f"{path}: the file is longer than a recipe can be; check that it is a recipe."
        )
    try:
        return parse_recipe(data.decode(), str(path))
    except UnicodeDecodeError as error:
        raise RecipeError(f"{path}: a recipe must be UTF-8 text; save it as such.") from error


def parse_recipe(text: str, name: str) -> Recipe:
    """The recipe written in `text`; raises RecipeError as `load_recipe` does."""
    try:
        values = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise RecipeError(f"{name}: the recipe must be TOML, but is not ({error}).") from error
    keys = Keys(values, name)
    recipe = Recipe(
        name=name,
        table=_table(keys.section("table")),
        time=_time(keys.needed_section("time")),
        rows=_rows(keys.section("rows")),
        pose=_pose(keys.section("pose")),
        position=_scaled(keys.section("position"), (3,), "length"),
        orientation=_orientation(keys.section("orientation")),
        force=_load(keys.section("force"), "force"),
        torque=_load(keys.section("torque"), "torque"),
        wrench=_wrench(keys.section("wrench")),
        joints=_scaled(keys.section("joints"), range(1, _MOST_JOINTS + 1), "angle"),
    )
    keys.finish()
    _refuse_contradictions(recipe)
    return recipe


def _refuse_contradictions(recipe: Recipe) -> None:
    if (recipe.pose is None) == (recipe.position is None):
        raise RecipeError(f"{recipe.name}: expected either [position] or [pose]; keep one of them.")
    if recipe.pose and recipe.orientation:
        raise RecipeError(
            f"{recipe.name}: [pose] holds the orientation already; leave [orientation] out."
        )
    loaded = recipe.force is not None or recipe.torque is not None
    if loaded != (recipe.wrench is not None):
        raise RecipeError(
            f"{recipe.name}: [wrench] with frame and sign must stand where [force] or [torque] do, "
            "and only there; add or remove it."
        )
    if recipe.wrench and recipe.wrench.frame == "tool" and not (recipe.pose or recipe.orientation):
        raise RecipeError(
            f"{recipe.name}: a wrench in the tool frame needs the orientation to be turned into "
            "the base frame; add [orientation]."
        )
    if recipe.table.decimal == recipe.table.separator:
        raise RecipeError(
            f"{recipe.name}: the comma cannot be both separator and decimal; change one of them."
        )


def _table(keys: Keys | None) -> TableForm:
    if keys is None:
        return TableForm()
    form = TableForm(
        separator=keys.choice("separator", _SEPARATORS, ","),
        skip_lines=keys.count("skip_lines", 0),
        header=keys.flag("header", True),
        encoding=keys.choice("encoding", _ENCODINGS, "utf-8"),
        decimal=keys.choice("decimal", {".": ".", ",": ","}, "."),
    )
    keys.finish()
    return form


def _time(keys: Keys) -> RateTime | NumberTime | StampTime:
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


def _rows(keys: Keys | None) -> Rows:
    if keys is None:
        return Rows()
    rows = Rows(
        repeated=keys.choice("repeated", {"refuse": "refuse", "drop": "drop"}, "refuse"),
        irregular=keys.choice(
            "irregular", {"leave": "leave", "refuse": "refuse", "resample": "resample"}, "leave"
        ),
        rate_hz=keys.positive("rate_hz"),
        held=keys.choice("held", {"leave": "leave", "interpolate": "interpolate"}, "leave"),
    )
    if (rows.irregular == "resample") != (rows.rate_hz is not None):
        raise RecipeError(
            f"{keys.where}: rate_hz says what irregular = 'resample' resamples to; "
            "give both or neither."
        )
    keys.finish()
    return rows


def _scaled(
    keys: Keys | None, counts: tuple[int, ...] | range, quantity: Quantity
) -> Scaled | None:
    if keys is None:
        return None
    scaled = Scaled(keys.columns(counts), keys.unit(quantity))
    keys.finish()
    return scaled


def _pose(keys: Keys | None) -> Pose | None:
    if keys is None:
        return None
    pose = Pose(keys.columns((16,)), keys.unit("length"), keys.choice("layout", _LAYOUTS))
    keys.finish()
    return pose


def _orientation(keys: Keys | None) -> Orientation | None:
    if keys is None:
        return None
    kinds = {
        "quaternion": _quaternion,
        "euler": _euler,
        "rotation_vector": _rotation_vector,
        "matrix": _matrix,
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


def _matrix(keys: Keys) -> Orientation:
    return Matrix(keys.columns((9, 16)), keys.choice("layout", _LAYOUTS))


def _load(keys: Keys | None, quantity: Quantity) -> Load | None:
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


def _wrench(keys: Keys | None) -> WrenchForm | None:
    if keys is None:
        return None
    wrench = WrenchForm(keys.choice("frame", _FRAMES), keys.sign())
    keys.finish()
    return wrench
