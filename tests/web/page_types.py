"""The page's types, made of the structs: one file of declarations for each module of structs."""

import json
import re
import textwrap
from collections.abc import Iterable

from msgspec import inspect as shapes
from protocol_structs import Described, edits, messages, parts_of, requests

from keyphase.labeling.edits.base import BaseEdit

FIRST = "// Made by `make protocol` from the structs in app/keyphase: change those.\n"
WIDTH = 100


def page_types() -> dict[str, str]:
    """The text of each file of declarations, by its name."""
    files = _files()
    home = {one.name: file for file, inside in files.items() for one in inside}
    texts = {file: _declarations(file, inside, home) for file, inside in files.items()}
    texts["messages.d.ts"] = _union("Message", messages(), home)
    texts["requests.d.ts"] = _union("Request", requests(), home)
    texts["edits.d.ts"] += _either("Edit", [one.name for one in edits()])
    return texts


def _files() -> dict[str, list[Described]]:
    """Everything that travels, by the file it is declared in, each once."""
    files: dict[str, list[Described]] = {}
    seen: set[str] = set()
    for whole in (*messages(), *requests(), *edits()):
        for one in parts_of(whole):
            if one.name in seen:
                continue
            seen.add(one.name)
            files.setdefault(_file_of(one, whole), []).append(one)
    return files


def _file_of(one: Described, whole: Described) -> str:
    """Parts that are values of the domain are declared where the message is that has them."""
    if issubclass(whole.kind, BaseEdit):
        return "edits.d.ts"
    kind = one.kind if ".web.protocol." in one.kind.__module__ else whole.kind
    return f"{kind.__module__.rsplit('.', 1)[-1]}.d.ts"


def _declarations(file: str, inside: Iterable[Described], home: dict[str, str]) -> str:
    parts = list(map(_declaration, inside))
    elsewhere = {name for name, where in (home | {"Edit": "edits.d.ts"}).items() if where != file}
    used = {
        name
        for one in inside
        for field in one.fields
        for name in re.findall(r"\w+", type_of(field.type))
        if name in elsewhere
    }
    imports = _imports(sorted(used), home | {"Edit": "edits.d.ts"})
    return FIRST + "\n" + (imports + "\n" if imports else "") + "\n".join(parts)


def _declaration(one: Described) -> str:
    lines = [f"export interface {one.name} {{"]
    if one.tag:
        lines.append(f"  {one.tag[0]}: {json.dumps(one.tag[1])};")
    lines += [f"  {f.name}{'?' * f.optional}: {type_of(f.type)};" for f in one.fields]
    return _comment(one) + "\n".join([*lines, "}"]) + "\n"


def _comment(one: Described) -> str:
    said = [*textwrap.wrap(one.summary, WIDTH - 3)]
    for name, words in one.words.items():
        said += textwrap.wrap(
            f"{name}: {words}", WIDTH - 3, initial_indent="- ", subsequent_indent="  "
        )
    if len(said) == 1 and len(said[0]) <= WIDTH - 7:
        return f"/** {said[0]} */\n"
    return "\n".join(["/**", *(f" * {line}" for line in said), " */"]) + "\n"


def type_of(shape: shapes.Type) -> str:
    """The type as the page writes it."""
    match shape:
        case shapes.BoolType():
            return "boolean"
        case shapes.IntType() | shapes.FloatType():
            return "number"
        case shapes.StrType():
            return "string"
        case shapes.NoneType():
            return "null"
        case shapes.LiteralType(values=values):
            return " | ".join(map(json.dumps, values))
        case shapes.UnionType(types=inside):
            return _union_of(inside)
        case shapes.TupleType(item_types=inside):
            return f"[{', '.join(map(type_of, inside))}]"
        case shapes.VarTupleType(item_type=inside) | shapes.ListType(item_type=inside):
            inner = type_of(inside)
            return f"({inner})[]" if "|" in inner else f"{inner}[]"
        case shapes.DictType(value_type=inside):
            return f"{{ [name: string]: {type_of(inside)} }}"
        case shapes.StructType(cls=kind) | shapes.DataclassType(cls=kind):
            return Described(kind).name
        case shapes.AnyType():
            return "any"
        case _:
            raise TypeError(f"The page has no type for {shape}.")


def _union_of(inside: Iterable[shapes.Type]) -> str:
    kinds = [one.cls for one in inside if isinstance(one, shapes.StructType)]
    if len(kinds) == len(edits()) and all(issubclass(kind, BaseEdit) for kind in kinds):
        return "Edit"
    return " | ".join(dict.fromkeys(map(type_of, inside)))


def _union(name: str, members: Iterable[Described], home: dict[str, str]) -> str:
    names = [one.name for one in members]
    return FIRST + "\n" + _imports(names, home) + _either(name, names)


def _either(name: str, names: Iterable[str]) -> str:
    return f"\nexport type {name} =\n" + "\n".join(f"  | {one}" for one in names) + ";\n"


def _imports(names: Iterable[str], home: dict[str, str]) -> str:
    by_file: dict[str, list[str]] = {}
    for one in names:
        by_file.setdefault(home[one].removesuffix(".d.ts"), []).append(one)
    return "".join(_import(file, sorted(inside)) for file, inside in sorted(by_file.items()))


def _import(file: str, names: list[str]) -> str:
    line = f'import type {{ {", ".join(names)} }} from "./{file}";\n'
    if len(line) <= WIDTH:
        return line
    inside = "".join(f"  {one},\n" for one in names)
    return f'import type {{\n{inside}}} from "./{file}";\n'
