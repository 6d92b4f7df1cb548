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
    """A, B and C of one beginning, as `RIst_A`."""
    found: dict[str, dict[str, int]] = {}
    for i in free:
        ending = re.fullmatch(r"(|.*[\W_])([ABCabc])", bare(names[i]))
        if ending and not COMMANDED.search(ending[1].rstrip("_")):
            found.setdefault(ending[1], {}).setdefault(ending[2].lower(), i)
    whole = next((one for one in found.values() if len(one) == 3), {})
    return [whole[letter] for letter in "abc"] if whole else []


def unnamed_rows(names: Sequence[str], values: Array) -> list[Guess]:
    """Twelve columns without names and nothing else: poses as KITTI writes them."""
    columns = tuple(range(len(names)))
    if len(names) != 12 or not all(UNNAMED.fullmatch(name) for name in names):
        return []
    return list(three_rows(columns, measured_rows(values, columns)))


def translation(names: Sequence[str], values: Array, found: list[Guess]) -> list[Guess]:
    """`tx ty tz` beside no force and no other place are no torque but where the tool was."""
    roles = {guess.role: guess for guess in found}
    torque = roles.get("torque")
    if torque is None or {"force", "position", "pose"} & roles.keys():
        return found
    if not all(
        re.fullmatch(r"(.*[\W_])?t[\W_]?[xyz]", bare(names[c]), re.I) for c in torque.columns
    ):
        return found
    reach = reach_of(values, torque.columns)
    units = {"mm": 1, "cm": 1, "m": 1}
    unit, why = likely_unit(names[torque.columns[0]], units, "mm" if reach > 10 else "m")
    told = ("t as in translation: there is no force beside it and no other place",)
    place = Guess(
        "position", torque.columns, unit, "", (f"reaches {reach:.4g}: {unit} ({why})", *told)
    )
    return [guess for guess in found if guess is not torque] + [place]
