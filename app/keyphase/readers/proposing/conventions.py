"""What columns are by the conventions of those who write them: KUKA, TUM, KITTI."""

import re
from collections.abc import Sequence

from keyphase.demonstration import Array
from keyphase.readers.proposing.guess import Guess, measured_rows, reach_of
from keyphase.readers.proposing.naming import COMMANDED, bare, likely_unit
from keyphase.readers.proposing.vectors import three_rows

UNNAMED = re.compile(r"column \d+|.*\[\d+\]")
"""How columns without a name of their own are called."""


def kuka_angles(names: Sequence[str], free: list[int]) -> list[int]:
    """A, B and C beside X, Y and Z of the same beginning, as `RIst_A` beside `RIst_X`."""
    placed = {bare(name).lower() for name in names}
    found: dict[str, dict[str, int]] = {}
    for i in free:
        ending = re.fullmatch(r"(|.*[\W_])([ABCabc])", bare(names[i]))
        if ending and not COMMANDED.search(ending[1].rstrip("_")):
            found.setdefault(ending[1], {}).setdefault(ending[2].lower(), i)
    beside = {stem for stem in found if all(f"{stem}{a}".lower() in placed for a in "xyz")}
    whole = next((one for stem, one in found.items() if len(one) == 3 and stem in beside), {})
    return [whole[letter] for letter in "abc"] if whole else []


def unnamed_rows(names: Sequence[str], values: Array) -> list[Guess]:
    """Twelve columns without names and nothing else: poses as KITTI writes them."""
    columns = tuple(range(len(names)))
    if len(names) != 12 or not all(UNNAMED.fullmatch(name) for name in names):
        return []
    return list(three_rows(columns, measured_rows(values, columns)))


def translation(names: Sequence[str], values: Array, found: list[Guess]) -> list[Guess]:
    """`tx ty tz` without another place are no torque but where the tool was: beside no force, or
    beside `rx ry rz` or another turn, as Vicon writes poses."""
    roles = {guess.role: guess for guess in found}
    torque = roles.get("torque")
    if torque is None or {"position", "pose", "joints"} & roles.keys():
        return found
    if "force" in roles and not {"turn", "euler", "quaternion"} & roles.keys():
        return found
    if not all(
        re.fullmatch(r"(.*[\W_])?t[\W_]?[xyz]", bare(names[c]), re.I) for c in torque.columns
    ):
        return found
    reach = reach_of(values, torque.columns)
    units = {"mm": 1, "cm": 1, "m": 1}
    unit, why = likely_unit(names[torque.columns[0]], units, "mm" if reach > 10 else "m")
    told = ("t as in translation: there is no other place",)
    place = Guess(
        "position", torque.columns, unit, "", (f"reaches {reach:.4g}: {unit} ({why})", *told)
    )
    return [guess for guess in found if guess is not torque] + [place]
