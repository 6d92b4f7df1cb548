"""What page and server say to each other, read off the structs: names, fields, and their words."""

import inspect
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, get_args

from msgspec import NODEFAULT, UNSET, Struct, structs
from msgspec import inspect as shapes

from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.parsing import Edit
from keyphase.web.protocol.messages import Message
from keyphase.web.protocol.request_kinds import PageRequest
from keyphase.web.protocol.requests import Request
from keyphase.web.protocol.signals_frame import SignalsHeader

_FIELD_LINE = re.compile(r"^(\w+(?:, \w+)*)  +(\S.*)$")


@dataclass(frozen=True)
class Field:
    """One field as it travels; `optional` where it may be left out."""

    name: str
    type: shapes.Type
    optional: bool


@dataclass(frozen=True)
class Described:
    """A struct or dataclass that travels, and what its docstring says."""

    kind: type

    @cached_property
    def name(self) -> str:
        """What it is called among all: requests and edits say what they are."""
        for base, ending in ((PageRequest, "Request"), (BaseEdit, "Edit")):
            if issubclass(self.kind, base):
                return self.kind.__name__.removesuffix(ending) + ending
        return self.kind.__name__

    @cached_property
    def tag(self) -> tuple[str, str] | None:
        """The field that tells what kind of message it is, and its value."""
        shape = self._shape
        if isinstance(shape, shapes.StructType) and shape.tag_field is not None:
            return shape.tag_field, str(shape.tag)
        return None

    @cached_property
    def fields(self) -> tuple[Field, ...]:
        """Its fields in order."""
        comes_in = issubclass(self.kind, PageRequest | BaseEdit)
        spares = issubclass(self.kind, Struct) and self.kind.__struct_config__.omit_defaults
        unset = _unset(self.kind)
        return tuple(
            Field(
                one.encode_name,
                one.type,
                optional=one.encode_name in unset or ((comes_in or spares) and _has_default(one)),
            )
            for one in self._shape.fields
        )

    @cached_property
    def summary(self) -> str:
        """What it is for."""
        said = " ".join(line for line in self._lines[0] if line)
        return re.sub(r"\s*Raises \w+Error.*", "", said)

    @cached_property
    def words(self) -> dict[str, str]:
        """What is said of its fields; several that are explained together share a key."""
        words: dict[str, str] = {}
        name = ""
        for line in self._lines[1]:
            if found := _FIELD_LINE.match(line):
                name = found[1]
                words[name] = found[2]
            elif line.strip():
                words[name] += " " + line.strip()
        return words

    @cached_property
    def _shape(self) -> Any:
        return shapes.type_info(self.kind)

    @cached_property
    def _lines(self) -> tuple[list[str], list[str]]:
        """The docstring: its sentences, and its tables of fields, each a paragraph or its end."""
        sentences: list[str] = []
        tables: list[str] = []
        for paragraph in inspect.cleandoc(self.kind.__doc__ or "").split("\n\n"):
            lines = paragraph.split("\n")
            first = next((k for k, one in enumerate(lines) if _FIELD_LINE.match(one)), len(lines))
            sentences += lines[:first]
            tables += lines[first:]
        return sentences, tables


def messages() -> tuple[Described, ...]:
    """All that the server says, in the order of the union."""
    return (*map(Described, get_args(Message)), Described(SignalsHeader))


def requests() -> tuple[Described, ...]:
    """All that a page says."""
    return tuple(map(Described, get_args(Request)))


def edits() -> tuple[Described, ...]:
    """All kinds of edits."""
    return tuple(map(Described, get_args(Edit)))


def parts_of(one: Described) -> Iterator[Described]:
    """What a struct is made of, itself first; edits are told apart."""
    yield one
    for field in one.fields:
        for kind in _kinds_in(field.type):
            if not issubclass(kind, BaseEdit):
                yield from parts_of(Described(kind))


def _kinds_in(shape: shapes.Type) -> Iterator[type]:
    match shape:
        case shapes.StructType(cls=kind) | shapes.DataclassType(cls=kind):
            yield kind
        case shapes.UnionType(types=inside) | shapes.TupleType(item_types=inside):
            for one in inside:
                yield from _kinds_in(one)
        case (
            shapes.VarTupleType(item_type=inside)
            | shapes.ListType(item_type=inside)
            | shapes.DictType(value_type=inside)
        ):
            yield from _kinds_in(inside)
        case _:
            pass


def _unset(kind: type) -> frozenset[str]:
    """Fields that a message leaves out where there is nothing to say."""
    if not issubclass(kind, Struct):
        return frozenset()
    return frozenset(one.encode_name for one in structs.fields(kind) if one.default is UNSET)


def _has_default(field: shapes.Field) -> bool:
    return field.default is not NODEFAULT or field.default_factory is not NODEFAULT
