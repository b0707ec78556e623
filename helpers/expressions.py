"""Table entries: numbers, or short formulas such as ``"-pi/2"`` or ``"d_6 + l_pen"``.

An entry is data, so it is kept as text and only read here: as a float once its symbols have values,
as LaTeX for a table. The symbolic view hands the same text to SymPy.
"""

import ast
import math
import operator
import re
from collections.abc import Mapping

from helpers.inputs import ArmError, must_be

Entry = str | float

_BINARY = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
_UNARY = {ast.UAdd: operator.pos, ast.USub: operator.neg}

_LONGEST = 200  # characters, so that no formula is nested deeper than Python can follow


def entry(value: object, what: str) -> Entry:
    """`value` as a checked table entry; a number, a string, or anything whose ``str`` is a
    formula."""
    if isinstance(value, bool) or value is None:
        raise ArmError(
            f"{what} is {value!r}; expected a number or a formula such as 'pi/2' or 'a_3'"
        )
    if isinstance(value, int | float):
        if not abs(value) < math.inf:
            raise ArmError(f"{what} is {value!r}; expected a finite number or a formula")
        return value if isinstance(value, int) else float(value)
    text = str(value).strip()
    names(text, what)
    return text


def names(text: Entry, what: str = "the entry") -> frozenset[str]:
    """The symbols of an entry, `pi` not counted."""
    text = text if isinstance(text, str) else entry(text, what)
    if not isinstance(text, str):
        return frozenset()
    return frozenset(n.id for n in ast.walk(_parse(text, what)) if isinstance(n, ast.Name)) - {"pi"}


def evaluate(text: Entry, values: Mapping[str, float]) -> float:
    """The number an entry stands for, with its symbols taken from `values`.

    Raises ArmError where a symbol has no value, or the formula divides by zero or is too large.
    """
    must_be(values, Mapping, "values")
    text = text if isinstance(text, str) else entry(text, "the entry")
    known = {**values, "pi": math.pi}
    try:
        found = float(
            _evaluate(_parse(text, "the entry"), known) if isinstance(text, str) else text
        )
    except ArithmeticError:
        found = math.nan
    if not math.isfinite(found):
        raise ArmError(f"{text} divides by zero or is too large; expected a finite value")
    return found


def latex(text: Entry) -> str:
    """An entry for a maths table: ``"-(d_7 + l_pen)"`` becomes ``-(d_{7} + l_{pen})``."""
    text = entry(text, "the entry")
    if not isinstance(text, str):
        return f"{text:g}"
    text = re.sub(r"\bpi\b", r"\\pi", text)
    text = re.sub(r"_(\w+)", r"_{\1}", text)
    return text.replace("*", r"\,")


def _parse(text: str, what: str) -> ast.expr:
    if len(text) > _LONGEST:
        raise ArmError(f"{what} has {len(text)} characters; expected at most {_LONGEST}")
    wrong = (
        f"{what} is {text!r}; expected numbers, symbols, pi and + - * / ( ), such as '-pi/2'"
        " or 'd_6 + l_pen'"
    )
    try:
        tree = ast.parse(text, mode="eval").body
    except SyntaxError:
        raise ArmError(wrong) from None
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant):
            fine = type(node.value) in (int, float) and math.isfinite(node.value)
        else:
            fine = isinstance(node, _ALLOWED)
        if not fine:
            raise ArmError(wrong)
    return tree


_ALLOWED = (ast.Name, ast.Load, ast.BinOp, ast.UnaryOp, *_BINARY, *_UNARY)


def _evaluate(node: ast.expr, values: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value):
            return value
        case ast.Name(name) if name in values:
            return values[name]
        case ast.Name(name):
            raise ArmError(f"no value for {name}; there are {', '.join(values)}")
        case ast.UnaryOp(op, operand):
            return _UNARY[type(op)](_evaluate(operand, values))
        case ast.BinOp(left, op, right):
            return _BINARY[type(op)](_evaluate(left, values), _evaluate(right, values))
