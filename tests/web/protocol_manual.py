"""The tables of docs/protocol.md, made of the structs; the rest of it is written by hand."""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from page_types import type_of
from protocol_structs import Described, edits, messages, parts_of, requests

FILE = Path(__file__).parents[2] / "docs/protocol.md"


def manual() -> str:
    """The whole text, with its tables made anew.

    A part lies between `<!-- made: NAME -->` and `<!-- end -->`.
    """
    made = {
        "messages": _both(messages()),
        "requests": _both(requests()),
        "edits": _both(edits()),
    }
    return re.sub(
        r"(<!-- made: (\w+) -->\n).*?(<!-- end -->)",
        lambda found: f"{found[1]}\n{made[found[2]]}\n{found[3]}",
        FILE.read_text(encoding="utf-8"),
        flags=re.DOTALL,
    )


def _both(wholes: Iterable[Described]) -> str:
    """Each whole with the parts that no whole before it has shown."""
    shown: set[str] = set()
    return "\n".join(
        part
        for whole in wholes
        for one in parts_of(whole)
        if not (one.name in shown or shown.add(one.name))
        for part in _part(one)
    )


def _part(one: Described) -> Iterator[str]:
    heading = f"`{one.tag[1]}`" if one.tag else one.name
    yield f"{'###' if one.tag else '####'} {heading}\n\n{one.summary}\n"
    if one.fields:
        yield "| field | type | |\n|---|---|---|"
        said = {name: words for names, words in one.words.items() for name in names.split(", ")}
        for field in one.fields:
            name = f"`{field.name}`" + (" (optional)" if field.optional else "")
            kind = type_of(field.type).replace("|", "\\|")
            yield f"| {name} | `{kind}` | {said.get(field.name, '').replace('|', chr(92) + '|')} |"
        yield ""
