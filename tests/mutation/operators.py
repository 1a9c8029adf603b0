"""What a mutant changes: one comparison, operator, number, condition, call, return or statement of a module."""

from __future__ import annotations

import ast
import copy
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
ARITHMETIC: dict[type[ast.operator], tuple[type[ast.operator], ...]] = {
    ast.Add: (ast.Sub,),
    ast.Sub: (ast.Add,),
    ast.Mult: (ast.Div,),
    ast.Div: (ast.Mult,),
    ast.FloorDiv: (ast.Mult,),
    ast.Mod: (ast.Mult,),
    ast.Pow: (ast.Mult,),
    ast.BitAnd: (ast.BitOr,),
    ast.BitOr: (ast.BitAnd,),
    ast.BitXor: (ast.BitAnd,),
    ast.LShift: (ast.RShift,),
    ast.RShift: (ast.LShift,),
}
CALLS = {
    "min": "max",
    "max": "min",
    "minimum": "maximum",
    "maximum": "minimum",
    "any": "all",
    "all": "any",
    "floor": "ceil",
    "ceil": "floor",
    "argmin": "argmax",
    "argmax": "argmin",
}
"""Functions and methods that are taken for one another."""

REMOVED = (ast.Expr, ast.AugAssign, ast.Delete, ast.Raise)
"""Statements that may be left out. So may assignments to what there is already; without a first one names lack."""


@dataclass(frozen=True)
class Mutant:
    """A change of a module: from the byte `start` to the byte `end`, on `line`, `before` becomes `after`.

    `lines` are the first and the last of its statement, without the statements in that.
    """

    path: str
    line: int
    lines: tuple[int, int]
    start: int
    end: int
    operator: str
    before: str
    after: str

    def applied(self, source: bytes) -> bytes:
        """The module's source with the change."""
        return source[: self.start] + self.after.encode() + source[self.end :]

    def __str__(self) -> str:
        before, after = (" ".join(text.split()) for text in (self.before, self.after))
        return f"{self.path}:{self.line}  {before}  ->  {after}"


def sites(path: str, source: bytes) -> list[list[Mutant]]:
    """For each place of the source where something can be changed: what it may become."""
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    found = []
    for node, lines in _reachable(ast.parse(source), (1, 1)):
        for operator, place, texts in _changes(node):
            start, end = (
                starts[place.lineno - 1] + place.col_offset,
                starts[place.end_lineno - 1] + place.end_col_offset,
            )
            before = source[start:end].decode()
            found.append([Mutant(path, place.lineno, lines, start, end, operator, before, after) for after in texts])
    return found


def _reachable(node: ast.AST, lines: tuple[int, int]) -> Iterator[tuple[Any, tuple[int, int]]]:
    """The nodes whose change may change what a program does, each with the lines of its statement.

    Docstrings, annotations, decorators, logs and assertions are none, nor the texts of messages.
    """
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST) and not _is_idle(child):
                around = _lines_of(child) if isinstance(child, ast.stmt) else lines
                yield child, around
                yield from _reachable(child, around)


def _lines_of(statement: ast.stmt) -> tuple[int, int]:
    inner = getattr(statement, "body", None)
    last = inner[0].lineno - 1 if inner else statement.end_lineno
    return statement.lineno, max(statement.lineno, last or 0)


def _is_idle(node: ast.AST) -> bool:
    match node:
        case ast.Assert() | ast.JoinedStr() | ast.Import() | ast.ImportFrom():
            return True
        case ast.Expr(value=ast.Constant()):
            return True
        case ast.Expr(value=ast.Call(func=ast.Attribute(value=ast.Name(id="log")))):
            return True
        case ast.If(test=ast.Name(id="TYPE_CHECKING")):
            return True
    return False


def _changes(node: Any) -> Iterator[tuple[str, Any, list[str]]]:
    """Each operator that applies to the node: its name, what of the source is replaced, and by what."""
    match node:
        case ast.Compare(ops=[only]):
            yield "comparison", node, [_with(node, ops=[other()]) for other in COMPARISONS[type(only)]]
        case ast.BinOp(op=op) if type(op) in ARITHMETIC and not _is_of_text_or_types(node):
            yield "arithmetic", node, [_with(node, op=other()) for other in ARITHMETIC[type(op)]]
        case ast.AugAssign(op=op) if type(op) in ARITHMETIC:
            yield "arithmetic", node, [_with(node, op=other())[1:-1] for other in ARITHMETIC[type(op)]]
        case ast.BoolOp(op=op):
            yield "boolean", node, [_with(node, op=ast.Or() if isinstance(op, ast.And) else ast.And())]
        case ast.UnaryOp(op=ast.USub() | ast.Not(), operand=operand):
            yield "unary", node, [_with(operand)]
        case ast.Constant(value=bool() | int() | float() as value):
            yield "constant", node, [repr(other) for other in _numbers(value)]
        case ast.Call(func=ast.Name(id=name)) if name in CALLS:
            yield "call", node, [_with(node, func=ast.Name(CALLS[name]))]
        case ast.Call(func=ast.Attribute(attr=name, value=value)) if name in CALLS:
            yield "call", node, [_with(node, func=ast.Attribute(value, CALLS[name]))]
        case ast.If(test=test) | ast.While(test=test) | ast.IfExp(test=test):
            yield "condition", test, [_with(ast.UnaryOp(ast.Not(), test))]
        case ast.Return(value=value) if value is not None and not _is_none(value):
            yield "return", node, ["return None"]
        case ast.Break():
            yield "loop", node, ["continue"]
        case ast.Continue():
            yield "loop", node, ["break"]
    if isinstance(node, REMOVED) or (isinstance(node, ast.Assign) and _changes_what_is(node)):
        yield "statement", node, ["pass"]


def _changes_what_is(node: ast.Assign) -> bool:
    (target, *_) = node.targets
    if isinstance(target, ast.Name):
        return any(isinstance(each, ast.Name) and each.id == target.id for each in ast.walk(node.value))
    return isinstance(target, ast.Subscript | ast.Attribute)


def _numbers(value: float) -> list[float]:
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, int):
        return [value + 1, value - 1]
    return [1.0] if value == 0.0 else [2.0 * value, 0.5 * value]


def _with(node: ast.AST, **fields: object) -> str:
    """The node's text with other fields, in brackets."""
    changed = copy.copy(node)
    for name, value in fields.items():
        setattr(changed, name, value)
    return f"({ast.unparse(changed)})"


def _is_of_text_or_types(node: ast.BinOp) -> bool:
    """True where the operator joins texts, or types as in `int | None`: another one there is noticed by any import."""
    for side in (node.left, node.right):
        match side:
            case ast.JoinedStr() | ast.Constant(value=str() | None):
                return True
            case ast.Name(id=name) if isinstance(node.op, ast.BitOr) and name[:1].isupper():
                return True
    return False


def _is_none(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and node.value is None
