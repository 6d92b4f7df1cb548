"""What the names of columns say: which quantity, which axis, which unit."""

import re
from collections.abc import Mapping, Sequence

AXIS = re.compile(r"(|.*?[^a-z]|.*?[a-z])([xyz])(|[\W_].*(?<![\W_][xyz])|\d*)")
TIME = re.compile(
    r"time|zeit|temps|tiempo|時刻|時間|时间|stamp|(^|[\W_])t($|[\W_])|sec|(^|[\W_])tm($|[\W_])",
    re.I,
)
POSITION = re.compile(
    r"pos|位置|座標|坐标|tcp|tool|ee|pose|^[xyz]$|^[xyz][\W_]|^p?[xyz]$|translation|punkt|xyz", re.I
)
NO_POSITION = re.compile(
    r"vel|speed|acc|cmd|soll|target|desired|action|goal|force|torque|wrench|quat|orient|ori[\W_]"
    r"|roll|pitch|yaw|kraft|moment|effort|couple|力|トルク|モーメント|扭矩|joint|gripper|finger|rot|covariance"
    r"|(^|[\W_])[ftmq]\d?[\W_]?[xyz]($|[\W_])|(?-i:[a-z][FTM][xyz])"
    r"|(^|[\W_])r[xyz]($|[\W_])|[\W_](deg|rad)\W*$"
    r"|^[ftm][\W_](act|actual|meas|measured|filt|filtered|raw|ext|sens|sensor|des|ref)[\W_]",
    re.I,
)
FORCE = re.compile(
    r"force|(?-i:[a-z]F[xyz])|kraft|effort|力(?!矩)|(^|[\W_])f_?ext|(^|[\W_])f[\W_]?[xyz]|^f\d?[xyz]|(^|[./])f$"
    r"|^f[\W_](act|actual|meas|measured|filt|filtered|raw|ext|sens|sensor|des|ref)[\W_]",
    re.I,
)
TORQUE = re.compile(
    r"torque|(?-i:[a-z][TM][xyz])|moment|couple|力矩|トルク|モーメント|扭矩|(^|[\W_])[tm][\W_]?[xyz]($|[\W_])|(^|[./])(tau|m)$"
    r"|^[tm][\W_](act|actual|meas|measured|filt|filtered|raw|ext|sens|sensor|des|ref)[\W_]",
    re.I,
)
WRENCH = re.compile(r"wrench|force|力|(^|[\W_])ft($|[\W_])|f_?ext|kraft", re.I)
QUATERNION = re.compile(r"quat|orient|(^|[\W_])q[\W_]?[wxyz0-3]|(^|[\W_])u[0-3]$", re.I)
EULER = re.compile(r"roll|pitch|yaw|euler|rpy|(^|[\W_])r[xyz]|rot", re.I)
TURN = re.compile(r"rot|axis.?angle|euler|rpy|orient", re.I)
GRIPPER = re.compile(r"grip|greifer|width|opening|finger|backe", re.I)
JOINT = re.compile(
    r"joint|achse|axis_?\d|(^|[\W_])[qj]_?\d|qpos"
    r"|(shoulder|elbow|wrist|waist|forearm)_(pan|lift|flex|roll|rotate|angle|yaw|pitch)"
    r"|(shoulder|elbow|wrist|waist|forearm)(_\w+)?\.pos$",
    re.I,
)
NO_JOINT = re.compile(
    r"header|stamp|seq|vel|qd|effort|torque|current|cmd|soll|target|action|tau", re.I
)
COMMANDED = re.compile(
    r"cmd|command|soll|target|desired|action|goal|vel|speed|twist|acc|jerk|covariance|_[dc]$"
    r"|demo_start|start_pose|目标|目標|期望|指令"
    r"|(^|[\W_])(des|ref|reference|setpoint|wanted|planned|sollwert|err|error|delta)(?=$|[\W_\d])",
    re.I,
)
"""What is no measurement of where the tool was or what acted on it."""

TOOL = re.compile(r"eef|(^|[\W_])ee|tcp|tool|flange|end.?effector|cartesian", re.I)
OTHER_THINGS = re.compile(r"object|(^|[\W_])obj[\W_]|cube|goal|camera|base_pose|marker", re.I)
"""What is not the tool."""

GRIPPER_PLACE = re.compile(r"gripper|greifer", re.I)
"""Three columns of x, y and z called so are where the gripper is, not how far it is open."""

RAW = re.compile(r"raw|bias|uncomp|offset", re.I)
COUNTER = re.compile(r"^$|sample|frame|index|idx|count|seq|^#$|^nr?$|row|zeile|^i$|^id$", re.I)
DEMONSTRATION = re.compile(
    r"(^|[\W_])(episode|demo|demonstration|trial|run|take|repetition|rep|traj|trajectory|versuch)"
    r"([\W_]?(id|idx|index|nr|no|num|number))?$",
    re.I,
)


TOOLS: tuple[tuple[tuple[str, re.Pattern[str]], tuple[str, re.Pattern[str]]], ...] = (
    (("left", re.compile("left", re.I)), ("right", re.compile("right", re.I))),
    (
        ("left", re.compile(r"(^|[\W_])(l|links|lft|gauche)(?=[\W_])|左", re.I)),
        ("right", re.compile(r"(^|[\W_])(r|rechts|rgt|droite?)(?=[\W_])|右", re.I)),
    ),
    (
        ("first", re.compile(r"(^|[\W_])(robot|rob|arm|tool|tcp|ee|eef)[\W_]?1(?!\d)", re.I)),
        ("second", re.compile(r"(^|[\W_])(robot|rob|arm|tool|tcp|ee|eef)[\W_]?2(?!\d)", re.I)),
    ),
    (
        ("first", re.compile(r"(^|[\W_])(robot|rob|arm)[\W_]?0(?!\d)", re.I)),
        ("second", re.compile(r"(^|[\W_])(robot|rob|arm)[\W_]?1(?!\d)", re.I)),
    ),
)
"""How the columns of two tools are told apart: what each tool is called here, and by what."""


def bare(name: str) -> str:
    """A name without the unit in brackets."""
    return re.sub(r"\s*[(\[{][^)\]}]*[A-Za-zµ°-][^)\]}]*[)\]}]\s*$", "", name).strip()


def unit_in(name: str, units: Mapping[str, float]) -> str:
    """A unit written in a name, as in `px [mm]`, `t_ms` or `Fx(N)`; "" where there is none."""
    name = name.replace("\u00b5", "u").replace("\u03bc", "u")
    found = re.findall(r"[(\[{]\s*([A-Za-z·*]+)\s*[)\]}]", name) or re.findall(
        r"[_\s]([A-Za-z]+)$", name
    )
    plain = {unit.lower(): unit for unit in units}
    aliases = {"radian": "rad", "degree": "deg", "degrees": "deg", "m": "m"}
    aliases |= {"seconds": "s", "sec": "s", "milliseconds": "ms", "nanoseconds": "ns"}
    for one in found:
        word = one.replace("·", "").replace("*", "").lower()
        word = aliases.get(word, word)
        if word in plain:
            return plain[word]
    return ""


def likely_unit(name: str, units: Mapping[str, float], otherwise: str) -> tuple[str, str]:
    """The unit in a name, else the likely one, and why; "" where a name has one that is unknown."""
    told = unit_in(name, units)
    if told:
        return told, "named so"
    return ("", "an unknown unit") if bare(name) != name.strip() else (otherwise, "by its size")


_ROW_AND_COLUMN = re.compile(r"(.*?)[\s_.]?[\[(]?(\d)[\])]?[\s_,.]?[\[(]?(\d)[\])]?")
_GRIDS = ((3, 3), (3, 4), (4, 4))

_NUMBERED = re.compile(r"(.*?)[\s_.]?[\[(]?(\d{1,2})[\])]?")


def vectors(names: Sequence[str], free: Sequence[int]) -> list[tuple[str, tuple[int, ...]]]:
    """Columns whose names differ in a number only, counted from 0 or 1 without a gap: what they
    are called without it, and their columns in that order."""
    found: dict[str, dict[int, int]] = {}
    for column in free:
        match = _NUMBERED.fullmatch(names[column])
        if match:
            found.setdefault(match[1], {}).setdefault(int(match[2]), column)
    grown = []
    for stem, members in found.items():
        numbers = sorted(members)
        begins = numbers[0] in (0, 1) and numbers == list(
            range(numbers[0], numbers[0] + len(numbers))
        )
        if begins and len(numbers) > 2 and stem != "column":
            grown.append((stem, tuple(members[n] for n in numbers)))
    return grown + _grids(names, free)


def _grids(names: Sequence[str], free: Sequence[int]) -> list[tuple[str, tuple[int, ...]]]:
    """Elements of a matrix that are named by row and column, from 0 or 1: `T00` to `T33`."""
    found: dict[str, dict[tuple[int, int], int]] = {}
    for column in free:
        match = _ROW_AND_COLUMN.fullmatch(names[column])
        if match:
            found.setdefault(match[1], {})[int(match[2]), int(match[3])] = column
    whole = {
        tuple((row + begin, at + begin) for row in range(rows) for at in range(columns))
        for rows, columns in _GRIDS
        for begin in (0, 1)
    }
    return [
        (stem, tuple(members[place] for place in sorted(members)))
        for stem, members in found.items()
        if tuple(sorted(members)) in whole
    ]


def elements_of_vectors(names: Sequence[str]) -> frozenset[int]:
    """Columns that are one of several numbered ones, such as `pose[3]`."""
    groups = vectors(names, range(len(names)))
    return frozenset(column for _, columns in groups for column in columns)


def parts_of_matrices(names: Sequence[str]) -> frozenset[int]:
    """Columns that are one of so many numbered ones that no four of them are a quaternion."""
    groups = vectors(names, range(len(names)))
    return frozenset(c for _, columns in groups if len(columns) in _MATRICES for c in columns)


_MATRICES = (6, 9, 12, 16)
