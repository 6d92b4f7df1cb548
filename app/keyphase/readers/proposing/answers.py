"""How a person says that a recording is read: a role for each column, and what goes with it."""

from dataclasses import dataclass, field, replace
from typing import Literal, get_args

from keyphase.readers.proposing.guess import Guess
from keyphase.readers.proposing.proposal import Proposal
from keyphase.readers.proposing.times import RESTARTS
from keyphase.readers.recipes.presets import left_open
from keyphase.readers.table import TableForm

Part = Literal[
    "ignore", "time", "seconds", "nanoseconds", "demonstration", "x", "y", "z", "qw", "qx", "qy",
    "qz", "quaternion", "roll", "pitch", "yaw", "rot6d", "rotation", "pose", "fx", "fy", "fz", "tx",
    "ty", "tz", "gripper", "joint",
]  # fmt: skip
"""What one column can be. `quaternion`, `rot6d`, `rotation` (a matrix of nine), `pose` (one of
sixteen) and `joint` are several columns, in the order of the file."""

PARTS: tuple[Part, ...] = get_args(Part)
ROTATION_VECTOR = "rotation_vector"

_PARTS_OF_ROLE: dict[str, tuple[Part, ...]] = {
    "time": ("time",),
    "position": ("x", "y", "z"),
    "euler": ("roll", "pitch", "yaw"),
    "turn": ("roll", "pitch", "yaw"),
    "force": ("fx", "fy", "fz"),
    "torque": ("tx", "ty", "tz"),
    "gripper": ("gripper",),
}
_WHOLE: dict[str, Part] = {
    "joints": "joint",
    "rot6d": "rot6d",
    "matrix": "rotation",
    "pose": "pose",
}
_QUANTITIES: dict[str, str] = {"position": "length", "pose": "length", "euler": "angle"}
_QUANTITIES |= {"turn": "angle"}
_QUATERNION: dict[str, Part] = {"w": "qw", "x": "qx", "y": "qy", "z": "qz"}
_ASKED_IN_WORDS = {
    "rate_hz": "Say how many rows there are a second.",
    "frame": "Say in whose axes the wrench is written.",
    "sign": "Say which way the force points when the tool presses.",
    "robot": "Say which robot moved: its description (URDF) and the link that is the tool.",
    "torque_sign": "Say whether the joint torques act on the robot.",
}


@dataclass(frozen=True)
class Answers:
    """Everything a recipe says of one recording; what is "", 0 or None is still open.

    parts                 what each column is
    units                 of `time`, `length`, `angle`, `force`, `torque`, `joints`, `gripper`
    order, layout         of a quaternion in four columns, of a matrix
    sequence              of roll, pitch and yaw, as in a recipe, or `ROTATION_VECTOR`
    frame, sign           of the wrench, as in a recipe
    rate_hz               of a recording without time
    from_first_s          so long nothing touches the tool at the beginning: the mean is taken out
    time_format           of a time in words, as in a recipe
    clocks                the column with the time of a section, where that is not the time itself
    sides                 to which of two tools each column belongs, "" to both; none where one is
    lines_after_header, restarts, leave_out_empty, drop_repeated  as in a recipe
    urdf, tool_frame      of the robot, where joints say where the tool is
    torque_sign           of joint torques, where a preset reads them
    preset                what reads the recording but for what that leaves open
    text                  the recipe itself, where a person has written it; nothing else counts then
    """

    encoding: str
    separator: str
    decimal: str
    skip_lines: int
    header: bool
    parts: tuple[Part, ...]
    units: dict[str, str]
    order: Literal["", "wxyz", "xyzw"] = ""
    layout: Literal["", "row_major", "column_major"] = ""
    sequence: str = ""
    frame: Literal["", "base", "tool"] = ""
    sign: Literal[0, 1, -1] = 0
    rate_hz: float | None = None
    from_first_s: float | None = None
    time_format: str = ""
    clocks: dict[str, str] = field(default_factory=dict)
    sides: tuple[str, ...] = ()
    lines_after_header: int = 0
    restarts: bool = False
    leave_out_empty: bool = False
    drop_repeated: bool = False
    urdf: str = ""
    tool_frame: str = ""
    torque_sign: Literal[0, 1, -1] = 0
    preset: str = ""
    text: str = ""

    def asked(self) -> tuple[str, ...]:
        """What a person is asked beside columns and units: some of `rate_hz`, `order`, `layout`,
        `sequence`, `frame`, `sign`, `robot`, `torque_sign`.
        """
        if self.preset:
            return _asked_by(self.preset)
        has = set(self.parts)
        is_asked = {
            "rate_hz": not has & {"time", "seconds"},
            "order": "quaternion" in has,
            "layout": bool(has & {"rotation", "pose"}),
            "sequence": "roll" in has,
            "frame": bool(has & {"fx", "tx"}),
            "sign": bool(has & {"fx", "tx"}),
            "robot": "joint" in has and not has & {"x", "y", "z", "pose"},
        }
        return tuple(question for question, is_so in is_asked.items() if is_so)

    def open(self) -> tuple[str, ...]:
        """What must be said before the recording can be read, as sentences."""
        return () if self.text else (*self._open_columns(), *self._open_questions())

    def _open_columns(self) -> list[str]:
        has, asked = set(self.parts), self.asked()
        if self.preset:
            return []
        said = []
        if "rate_hz" in asked and self.rate_hz is None:
            said.append("Say which column is the time, or how many rows there are a second.")
        if not ({"x", "y", "z"} <= has or has & {"pose", "joint"}):
            said.append("Say which three columns are x, y and z of the tool.")
        needed = {
            "time": "time" in has and not self.time_format,
            "length": bool(has & {"x", "pose"}),
            "angle": "roll" in has,
            "force": "fx" in has,
            "torque": "tx" in has,
            "joints": "joint" in has,
            "gripper": "gripper" in has,
        }
        return said + [
            f"Say the unit of the {quantity}."
            for quantity, is_needed in needed.items()
            if is_needed and not self.units.get(quantity)
        ]

    def _open_questions(self) -> list[str]:
        is_open = {
            "rate_hz": bool(self.preset) and self.rate_hz is None,
            "order": not self.order,
            "layout": not self.layout,
            "sequence": not self.sequence,
            "frame": not self.frame,
            "sign": not self.sign,
            "robot": not (self.urdf and self.tool_frame),
            "torque_sign": not self.torque_sign,
        }
        words = {
            "order": "Say whether the quaternion begins or ends with w.",
            "layout": "Say whether the matrix is written row by row or column by column.",
            "sequence": "Say about which axes the angles turn.",
            **_ASKED_IN_WORDS,
        }
        return [words[question] for question in self.asked() if is_open[question]]


def answers_to(proposal: Proposal) -> Answers:
    """A proposal as answers; what only a person knows is left open."""
    count = len(proposal.names)
    parts: list[Part] = ["ignore"] * count
    sides = [""] * count
    for side, guesses in {"": proposal.guesses, **proposal.sides}.items():
        for guess in guesses:
            for column, part in zip(guess.columns, _parts_of(guess), strict=True):
                parts[column] = part
                sides[column] = "" if guess.role == "time" else side
    if proposal.split is not None:
        parts[proposal.split.columns[0]] = "demonstration"
    guesses = (*proposal.guesses, *(g for side in proposal.sides.values() for g in side))
    details = {guess.role: guess.detail for guess in guesses}
    stamp = details.get("time", "")
    layout = proposal.layout
    form = TableForm() if layout is None else layout.form
    return Answers(
        encoding="utf-8" if layout is None else layout.encoding,
        separator="," if layout is None else layout.separator,
        decimal=form.decimal,
        skip_lines=form.skip_lines,
        header=form.header,
        lines_after_header=form.lines_after_header,
        parts=tuple(parts),
        units={_QUANTITIES.get(g.role, g.role): g.unit for g in guesses if g.unit},
        layout=_layout(details.get("pose", "")),
        sequence=details.get("euler", ""),
        time_format="" if stamp in (RESTARTS, _TWO_PARTS) else stamp,
        clocks=dict(proposal.clocks),
        sides=tuple(sides) if proposal.sides else (),
        restarts=stamp == RESTARTS and proposal.split is None,
        leave_out_empty=bool(proposal.gaps),
        drop_repeated=proposal.repeats > 0,
        preset=proposal.preset[0] if proposal.preset else "",
    )


def with_parts(answers: Answers, count: int) -> Answers:
    """Answers for a table of `count` columns: those that are new are passed over."""
    more: tuple[Part, ...] = ("ignore",) * max(0, count - len(answers.parts))
    return replace(answers, parts=(*answers.parts, *more)[:count])


_TWO_PARTS = "seconds and nanoseconds"


def _layout(detail: str) -> Literal["", "row_major", "column_major"]:
    match detail:
        case "row_major" | "column_major":
            return detail
    return ""


def _asked_by(preset: str) -> tuple[str, ...]:
    """What a preset leaves open, as questions."""
    asked: list[str] = []
    for section, lines in left_open(preset).items():
        keys = {line.removeprefix("#").split("=")[0].strip() for line in lines}
        asked += {
            "time": ["rate_hz"],
            "wrench": [key for key in ("frame", "sign") if key in keys],
            "robot": ["robot"],
            "joint_torques": ["torque_sign"],
        }[section]
    return tuple(asked)


def _parts_of(guess: Guess) -> tuple[Part, ...]:
    if guess.is_one_of_several:
        return ("ignore",) * len(guess.columns)
    if guess.role == "quaternion":
        if guess.detail:
            return tuple(_QUATERNION[letter] for letter in guess.detail)
        return ("quaternion",) * len(guess.columns)
    if guess.detail == _TWO_PARTS:
        return ("seconds", "nanoseconds")
    if guess.role in _WHOLE:
        return (_WHOLE[guess.role],) * len(guess.columns)
    ignored: tuple[Part, ...] = ("ignore",) * len(guess.columns)
    return (*_PARTS_OF_ROLE.get(guess.role, ()), *ignored)[: len(guess.columns)]
