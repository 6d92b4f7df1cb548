"""What a person has answered, as the text of a recipe."""

from collections.abc import Sequence

from keyphase.errors import RecipeError
from keyphase.readers.proposing.answers import ROTATION_VECTOR, Answers, Part
from keyphase.readers.proposing.written import toml

_THREES: tuple[tuple[str, tuple[Part, ...], str], ...] = (
    ("position", ("x", "y", "z"), "length"),
    ("force", ("fx", "fy", "fz"), "force"),
    ("torque", ("tx", "ty", "tz"), "torque"),
    ("gripper", ("gripper",), "gripper"),
)


def recipe_text(answers: Answers, names: tuple[str, ...]) -> str:
    """The recipe (TOML) that answers make, columns by name where names tell them apart.

    Raises RecipeError for what is still open, or said twice.
    """
    if answers.text:
        return answers.text
    if missing := answers.open():
        raise RecipeError(" ".join(missing))
    if answers.preset:
        sections = [[f"preset = {toml(answers.preset)}"], *_asked(answers)]
    else:
        sections = [_table(answers, names), _time(answers, names)]
        sections += _tools(answers, names)
        sections += _asked(answers)
        sections += [_rows(answers)]
    return "\n\n".join("\n".join(lines) for lines in sections if lines) + "\n"


def _rows(answers: Answers) -> list[str]:
    lines = ['empty = "leave_out"'] if answers.leave_out_empty else []
    lines += ['repeated = "drop"'] if answers.drop_repeated else []
    return ["[rows]", *lines] if lines else []


def _asked(answers: Answers) -> list[list[str]]:
    """The sections of a recipe that hold for all its tools, or that a preset leaves open."""
    asked = answers.asked()
    wrench = [f"frame = {toml(answers.frame)}"] if "frame" in asked else []
    wrench += [f"sign = {answers.sign}"] if "sign" in asked else []
    robot = [f"urdf = {toml(answers.urdf)}", f"tool_frame = {toml(answers.tool_frame)}"]
    rate = bool(answers.preset) and "rate_hz" in asked
    return [
        ["[time]", f"rate_hz = {answers.rate_hz}"] if rate else [],
        ["[wrench]", *wrench] if wrench else [],
        ["[robot]", *robot] if "robot" in asked else [],
        ["[joint_torques]", f"sign = {answers.torque_sign}"] if "torque_sign" in asked else [],
    ]


def _table(answers: Answers, names: tuple[str, ...]) -> list[str]:
    values = (
        ("encoding", answers.encoding, "utf-8"),
        ("separator", answers.separator, ","),
        ("decimal", answers.decimal, "."),
        ("skip_lines", answers.skip_lines, 0),
        ("header", answers.header, True),
        ("lines_after_header", answers.lines_after_header, 0),
        ("time_starts_again", answers.restarts, False),
    )
    lines = [f"{key} = {toml(value)}" for key, value, usual in values if value != usual]
    split = _run(answers, names, "demonstration")
    lines += [f"demonstration = {toml(split[0])}"] if split else []
    return ["[table]", *lines] if lines else []


def _time(answers: Answers, names: tuple[str, ...]) -> list[str]:
    if "seconds" in answers.parts:
        seconds, nanoseconds = _columns(answers, names, ("seconds", "nanoseconds"))
        lines = [f"seconds = {toml(seconds)}", f"nanoseconds = {toml(nanoseconds)}"]
    elif "time" in answers.parts:
        lines = [f"column = {toml(_columns(answers, names, ('time',))[0])}"]
        if answers.time_format:
            lines.append(f"format = {toml(answers.time_format)}")
        else:
            lines += [f"unit = {toml(answers.units['time'])}", "from_zero = true"]
    else:
        lines = [f"rate_hz = {answers.rate_hz}"]
    return ["[time]", *lines]


def _tools(answers: Answers, names: tuple[str, ...]) -> list[list[str]]:
    """The sections of the tool, or of each of two."""
    sides = tuple(dict.fromkeys(side for side in answers.sides if side))
    if not sides:
        return _tool(answers, names, None, "")
    sections = []
    for side in sides:
        sections.append(["[[demonstration]]", f"name = {toml(side)}"])
        sections += _tool(answers, names, side, "demonstration.")
    return sections


def _tool(
    answers: Answers, names: tuple[str, ...], side: str | None, inside: str
) -> list[list[str]]:
    sections = []
    for section, parts, quantity in _THREES:
        columns = _columns(answers, names, parts, side)
        if columns:
            lines = [f"columns = {toml(columns)}", f"unit = {toml(answers.units[quantity])}"]
            if section in ("force", "torque") and answers.from_first_s:
                lines.append(f"offset_from_first_s = {answers.from_first_s}")
            sections.append((section, lines))
    pose = _run(answers, names, "pose", side)
    if pose:
        lines = [f"columns = {toml(pose)}", f"layout = {toml(answers.layout)}"]
        sections.append(("pose", [*lines, f"unit = {toml(answers.units['length'])}"]))
    sections.append(("orientation", _orientation(answers, names, side)))
    joints = _run(answers, names, "joint", side)
    if joints:
        lines = [f"columns = {toml(joints)}", f"unit = {toml(answers.units['joints'])}"]
        sections.append(("joints", lines))
    return [
        [f"[{inside}{section}]", *lines, *_clock(answers, section, side)]
        for section, lines in sections
        if lines
    ]


def _clock(answers: Answers, section: str, side: str | None) -> list[str]:
    clock = answers.clocks.get(f"{side}.{section}" if side else section)
    return [f"time = {toml(clock)}"] if clock else []


def _orientation(answers: Answers, names: tuple[str, ...], side: str | None) -> list[str]:
    if columns := _columns(answers, names, ("qw", "qx", "qy", "qz"), side):
        return _turned("quaternion", columns, 'order = "wxyz"', "normalise = true")
    if columns := _run(answers, names, "quaternion", side):
        return _turned("quaternion", columns, f"order = {toml(answers.order)}", "normalise = true")
    if columns := _run(answers, names, "rot6d", side):
        return _turned("rot6d", columns)
    if columns := _run(answers, names, "rotation", side):
        return _turned("matrix", columns, f"layout = {toml(answers.layout)}")
    angles = _columns(answers, names, ("roll", "pitch", "yaw"), side)
    if not angles:
        return []
    unit = f"unit = {toml(answers.units['angle'])}"
    if answers.sequence == ROTATION_VECTOR:
        return _turned(ROTATION_VECTOR, angles, unit)
    return _turned("euler", angles, f"sequence = {toml(answers.sequence)}", unit)


def _turned(kind: str, columns: Sequence[str | int], *more: str) -> list[str]:
    return [f"kind = {toml(kind)}", f"columns = {toml(columns)}", *more]


def _columns(
    answers: Answers, names: tuple[str, ...], parts: tuple[Part, ...], side: str | None = None
) -> list[str | int]:
    """The columns of some parts in their order; none where none is named.

    Raises RecipeError where some are missing or one is named twice.
    """
    found = {part: _of_part(answers, part, side) for part in parts}
    if not any(found.values()):
        return []
    for part, columns in found.items():
        if len(columns) != 1:
            many = "no column" if not columns else f"{len(columns)} columns"
            together = ", ".join(parts)
            raise RecipeError(
                f"One column must be {part}, but {many} are said to be; {together} go together."
            )
    return [_name(answers, names, found[part][0]) for part in parts]


def _run(
    answers: Answers, names: tuple[str, ...], part: Part, side: str | None = None
) -> list[str | int]:
    """All columns of one part, in the order of the file."""
    return [_name(answers, names, i) for i in _of_part(answers, part, side)]


def _of_part(answers: Answers, part: Part, side: str | None) -> list[int]:
    sides = answers.sides
    return [
        i
        for i, one in enumerate(answers.parts)
        if one == part and (side is None or i >= len(sides) or sides[i] in ("", side))
    ]


def _name(answers: Answers, names: tuple[str, ...], column: int) -> str | int:
    name = names[column]
    return name if answers.header and name and names.count(name) == 1 else column
