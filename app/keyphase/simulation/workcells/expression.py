"""Success in words that a file may hold: comparisons of what is true in a scene, nothing else.

    touch > 1 and distance(peg, hole) < 0.002 and tilt(peg) < 5

Read with Python's grammar and worked out here, node by node; nothing of it is ever executed.
"""

import ast
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from keyphase.errors import SimulationError

MAX_LENGTH = 500
"""An expression that is longer is no sentence a person wrote."""

MAX_NODES = 200

FUNCTIONS: Mapping[str, int] = {
    "distance": 2,
    "aside": 2,
    "above": 2,
    "angle": 2,
    "height": 1,
    "tilt": 1,
    "moved": 1,
}
"""What can be asked of parts, and of how many: metres and degrees.

distance, aside, above  between the origins of two: in all, sideways, and how far up the first lies
angle                   between the axes of two
height, tilt, moved     of one: above the base, of its z axis against the vertical, since the start
"""

Ask = Callable[[str, tuple[str, ...]], float]
"""Works a function of parts out; for the name of a contact, without parts, its normal force [N]."""

_COMPARE = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_CALCULATE = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}


@dataclass(frozen=True)
class Condition:
    """An expression that was found to be one; `holds` works it out."""

    text: str
    tree: ast.expr

    def holds(self, ask: Ask) -> bool:
        """Whether it is true now; where a division by zero is in it, it is not."""
        try:
            return bool(_value(self.tree, ask))
        except ZeroDivisionError:
            return False


def condition(text: str, parts: frozenset[str], contacts: frozenset[str]) -> Condition:
    """The condition that `text` says of parts and contacts of these names.

    Raises SimulationError for anything but comparisons, `and`, `or`, `not`, sums and products of
    numbers, contacts, and functions of parts.
    """
    if len(text) > MAX_LENGTH:
        raise _refused(text[:40] + "…", f"is longer than {MAX_LENGTH} characters")
    try:
        tree = ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise _refused(text, f"cannot be read ({error})") from error
    if sum(1 for _ in ast.walk(tree)) > MAX_NODES:
        raise _refused(text, f"has more than {MAX_NODES} parts")
    _refuse_other(text, tree, parts, contacts)
    if not isinstance(tree, ast.Compare | ast.BoolOp) and not _is_not(tree):
        raise _refused(text, "compares nothing, so that it is neither true nor false")
    return Condition(text, tree)


def _refuse_other(
    text: str, node: ast.expr, parts: frozenset[str], contacts: frozenset[str]
) -> None:
    """Raise SimulationError for what an expression may not hold."""
    match node:
        case ast.Constant(value=bool() | str() | bytes() | complex() | None):
            raise _refused(text, f"has {node.value!r}, which is no number")
        case ast.Constant(value=int() | float()):
            return
        case ast.Name(id=name):
            if name not in contacts:
                known = ", ".join(sorted(contacts)) or "none"
                raise _refused(text, f"names '{name}', which is no contact (there are: {known})")
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            _refuse_call(text, name, arguments, parts)
        case ast.BoolOp(values=inside):
            for one in inside:
                _refuse_other(text, one, parts, contacts)
        case ast.UnaryOp(op=ast.Not() | ast.USub(), operand=inside):
            _refuse_other(text, inside, parts, contacts)
        case ast.Compare(left=left, ops=ops, comparators=others) if all(
            type(op) in _COMPARE for op in ops
        ):
            for one in (left, *others):
                _refuse_other(text, one, parts, contacts)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _CALCULATE:
            _refuse_other(text, left, parts, contacts)
            _refuse_other(text, right, parts, contacts)
        case _:
            raise _refused(text, f"has '{ast.unparse(node)[:40]}', which it may not")


def _refuse_call(text: str, name: str, arguments: list[ast.expr], parts: frozenset[str]) -> None:
    if name not in FUNCTIONS:
        raise _refused(text, f"asks '{name}' (there are: {', '.join(FUNCTIONS)})")
    names = [one.id for one in arguments if isinstance(one, ast.Name)]
    if len(names) != len(arguments) or len(names) != FUNCTIONS[name]:
        raise _refused(text, f"must give {name} the names of {FUNCTIONS[name]} parts")
    for one in names:
        if one not in parts:
            known = ", ".join(sorted(parts))
            raise _refused(text, f"names '{one}', which is no part (there are: {known})")


def _value(node: ast.expr, ask: Ask) -> float | bool:
    """The value of a node that was found to be one of those below."""
    match node:
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.Name(id=name):
            return ask(name, ())
        case ast.Call(func=ast.Name(id=name), args=arguments):
            return ask(name, tuple(one.id for one in arguments if isinstance(one, ast.Name)))
        case ast.BoolOp(op=op, values=inside):
            each = (bool(_value(one, ask)) for one in inside)
            return all(each) if isinstance(op, ast.And) else any(each)
        case ast.UnaryOp(op=ast.Not(), operand=inside):
            return not _value(inside, ask)
        case ast.UnaryOp(operand=inside):
            return -_value(inside, ask)
        case ast.BinOp(left=left, op=op, right=right):
            return _CALCULATE[type(op)](_value(left, ask), _value(right, ask))
        case ast.Compare(left=left, ops=ops, comparators=others):
            values = [_value(one, ask) for one in (left, *others)]
            pairs = zip(ops, values, values[1:], strict=False)
            return all(_COMPARE[type(op)](first, second) for op, first, second in pairs)
    raise AssertionError(node)


def _is_not(node: ast.expr) -> bool:
    return isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not)


def _refused(text: str, why: str) -> SimulationError:
    return SimulationError(
        f"A condition of success must be a comparison such as 'touch > 1 and moved(part) < 0.01', "
        f"but '{text}' {why}."
    )
