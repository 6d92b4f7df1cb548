"""A plan as a URScript program: straight lines, and contact moves with a branch for failure."""

from collections.abc import Sequence

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills.exports.robot_moves import RobotMove, UntilContact, robot_moves
from keyphase.skills.skill import Skill

ACCELERATION_M_S2 = 0.5
BLEND_M = 0.002

_HEAD = """\
def force_along(d):
  local w = get_tcp_force()
  return w[0] * d[0] + w[1] * d[1] + w[2] * d[2]
end

def ahead(d, way):
  local at = get_actual_tcp_pose()
  return p[at[0] + way * d[0], at[1] + way * d[1], at[2] + way * d[2], at[3], at[4], at[5]]
end

def fail(label, d, way):
  textmsg("failed: ", label)
  movel(ahead(d, 0.0 - way), a=0.5, v=0.05)
  halt
end

def until_contact(label, d, speed, f, threshold, search, back):
  local start = get_actual_tcp_pose()
  local level = force_along(f)
  local gone = 0.0
  while force_along(f) - level < threshold:
    if gone > search:
      stopl(2.0)
      fail(label, d, back)
    end
    speedl([speed * d[0], speed * d[1], speed * d[2], 0.0, 0.0, 0.0], 0.5, 0.008)
    local at = get_actual_tcp_pose()
    gone = norm([at[0] - start[0], at[1] - start[1], at[2] - start[2]])
  end
  stopl(2.0)
end
"""


def urscript(skills: Sequence[Skill], demonstration: str, name: str = "keyphase_plan") -> str:
    """The program; poses in the robot's base frame, of the tool point that was demonstrated.

    The force is what the environment exerts on the tool, as `get_tcp_force` gives it.
    """
    lines = [
        f"# Plan of {_plain(demonstration)}, written by keyphase. Set the tool point first.",
        f"def {name}():",
        *("  " + line if line else "" for line in _HEAD.splitlines()),
        "",
        "  zero_ftsensor()",
    ]
    for number, move in enumerate(robot_moves(skills), start=1):
        lines += [
            f"  # {number} {_plain(move.label)}",
            *("  " + line for line in _lines(move, number)),
        ]
    return "\n".join([*lines, "end", f"{name}()", ""])


def _lines(move: RobotMove, number: int) -> list[str]:
    last = len(move.position_m) - 1
    lines = [
        f"movel({_pose(at, wxyz)}, a={ACCELERATION_M_S2}, v={move.speed_m_s:.4f}, "
        f"r={0.0 if row == last else BLEND_M})"
        for row, (at, wxyz) in enumerate(zip(move.position_m, move.orientation_wxyz, strict=True))
    ]
    if move.gripper:
        lines.append(
            f"# Call your gripper here: it goes on{move.gripper.replace(' and', ' once', 1)}."
        )
    return lines if move.contact is None else [*lines, _contact(move.contact, number)]


def _contact(until: UntilContact, number: int) -> str:
    return (
        f'until_contact("skill {number}", {_vector(until.travel)}, {until.speed_m_s:.4f}, '
        f"{_vector(until.force)}, {until.threshold_N:.4f}, {until.search_m:.4f}, "
        f"{until.retract_m:.4f})"
    )


def _pose(position_m: Array, wxyz: Array) -> str:
    rotation = quaternions.shortest_rotation_vector(wxyz)
    return "p" + _vector(np.concatenate((position_m, rotation)))


def _vector(values: Array) -> str:
    return "[" + ", ".join(f"{value + 0.0:.6f}" for value in values.tolist()) + "]"


def _plain(text: str) -> str:
    """For a comment: in one line, of characters that any controller reads."""
    return "".join(c if c.isascii() and c.isprintable() else " " for c in text)
