"""A plan as an ABB RAPID module: straight lines, and contact moves with a branch for failure.

The force is read by `FCGetForce` of the Force Control option; the contact is searched in steps.
"""

from collections.abc import Sequence

from keyphase.demonstration import Array
from keyphase.skills.exports.robot_moves import RobotMove, UntilContact, robot_moves
from keyphase.skills.skill import Skill

STEP_MM = 0.5
"""A contact is looked for in steps of this length."""

_MAX_COMMENT_LENGTH = 70
_UNUSED = "[9E9,9E9,9E9,9E9,9E9,9E9]"

_TAIL = f"""\
  FUNC num ForceAlong(num fx, num fy, num fz)
    VAR fcforcevector felt;
    felt := FCGetForce(\\Tool:=plan_tool);
    RETURN felt.xforce * fx + felt.yforce * fy + felt.zforce * fz;
  ENDFUNC

  PROC Fail(string label, num dx, num dy, num dz, num back)
    TPWrite "failed: " + label;
    MoveL Offs(CRobT(\\Tool:=plan_tool), -back * dx, -back * dy, -back * dz), v50, fine, plan_tool;
    Stop;
  ENDPROC

  PROC UntilContact(string label, num dx, num dy, num dz, num speed,
      num fx, num fy, num fz, num threshold, num search, num back)
    VAR speeddata slow;
    VAR num level;
    VAR num gone;
    slow := [speed, 50, 100, 100];
    level := ForceAlong(fx, fy, fz);
    gone := 0;
    WHILE ForceAlong(fx, fy, fz) - level < threshold DO
      IF gone > search THEN
        Fail label, dx, dy, dz, back;
      ENDIF
      MoveL Offs(CRobT(\\Tool:=plan_tool), {STEP_MM} * dx, {STEP_MM} * dy, {STEP_MM} * dz),
        slow, fine, plan_tool;
      gone := gone + {STEP_MM};
    ENDWHILE
  ENDPROC
"""


def rapid(skills: Sequence[Skill], demonstration: str, module: str = "KeyphasePlan") -> str:
    """The module; targets in millimetres in the robot's base frame, of the tool `plan_tool`.

    `plan_tool` is the tool point that was demonstrated; set it before the module is run.
    """
    moves = robot_moves(skills)
    lines = [
        f"MODULE {module}",
        f"  ! Plan of {_plain(demonstration)}, written by keyphase.",
        "  PERS tooldata plan_tool := [TRUE,[[0,0,0],[1,0,0,0]],[0.5,[0,0,50],[1,0,0,0],0,0,0]];",
    ]
    for number, move in enumerate(moves, start=1):
        rows = zip(move.position_m, move.orientation_wxyz, strict=True)
        for row, (at, wxyz) in enumerate(rows, start=1):
            lines.append(f"  CONST robtarget s{number}_{row} := {_target(at, wxyz)};")
    lines += ["", "  PROC main()", "    FCCalib plan_load;"]
    lines.insert(3, "  PERS loaddata plan_load := [0.5,[0,0,50],[1,0,0,0],0,0,0];")
    for number, move in enumerate(moves, start=1):
        lines += [f"    ! {number} {_plain(move.label)}", *_lines(move, number)]
    return "\n".join([*lines, "  ENDPROC", "", *_TAIL.splitlines(), "ENDMODULE", ""])


def _lines(move: RobotMove, number: int) -> list[str]:
    speed = f"[{1e3 * move.speed_m_s:.1f}, 50, 100, 100]"
    count = len(move.position_m)
    lines = [
        f"    MoveL s{number}_{row}, {speed}, {'fine' if row == count else 'z1'}, plan_tool;"
        for row in range(1, count + 1)
    ]
    if move.gripper:
        lines.append(
            f"    ! Call your gripper here: it goes on{move.gripper.replace(' and', ' once', 1)}."
        )
    return lines if move.contact is None else [*lines, _contact(move.contact, number)]


def _contact(until: UntilContact, number: int) -> str:
    values = [
        *until.travel.tolist(),
        1e3 * until.speed_m_s,
        *until.force.tolist(),
        until.threshold_N,
        1e3 * until.search_m,
        1e3 * until.retract_m,
    ]
    numbers = ", ".join(f"{value + 0.0:.4f}" for value in values)
    return f'    UntilContact "skill {number}", {numbers};'


def _target(position_m: Array, wxyz: Array) -> str:
    at = ",".join(f"{1e3 * value + 0.0:.3f}" for value in position_m.tolist())
    turn = ",".join(f"{value + 0.0:.7f}" for value in wxyz.tolist())
    return f"[[{at}],[{turn}],[0,0,0,0],{_UNUSED}]"


def _plain(text: str) -> str:
    """For a comment: short, in one line, of characters that any controller reads."""
    plain = "".join(c if c.isascii() and c.isprintable() else " " for c in text)
    return plain[:_MAX_COMMENT_LENGTH]
