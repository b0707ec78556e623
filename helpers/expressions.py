"""Table entries: numbers, or short formulas such as ``"-pi/2"`` or ``"d_6 + l_pen"``.

An entry is data, so it is kept as text and only read here: as a float once its symbols have values,
as LaTeX for a table. The symbolic view hands the same text to SymPy.
"""

import ast
import math
import operator
import re
import sys
from collections.abc import Callable, Mapping
from functools import cache, lru_cache

from helpers.inputs import ArmError, must_be, shown

Entry = str | float

_BINARY: dict[type, Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
_UNARY: dict[type, Callable[[float], float]] = {ast.UAdd: operator.pos, ast.USub: operator.neg}

_PLAIN = 1e15  # a number below is its own float, as nearly every entry is
_LONGEST = 200  # characters, so that no formula is nested deeper than Python can follow
# An entry that holds no more than these is in plain signs already.
_SIGNS = re.compile(r"[A-Za-z0-9_+\-*/(). ]+")
_SPELLED = re.compile(r"\b\d+_|\b0[xob]|\b(?:deg|rad)\b", re.IGNORECASE)
_KINDS = {"alpha": ["angle"], "theta": ["angle"], "a": ["length"], "d": ["length"]}


def entry(value: object, what: str) -> Entry:
    """`value` as a checked table entry; a number, a string, or anything whose ``str`` is a
    formula."""
    if isinstance(value, complex):
        raise ArmError(f"{what} is {str(value)!r}; expected numbers, symbols, pi and + - * / ( )")
    if isinstance(value, bool) or value is None:
        raise ArmError(
            f"{what} is {value!r}; expected a number or a formula such as 'pi/2' or 'a_3'"
        )
    if isinstance(value, int | float):
        if not abs(value) <= sys.float_info.max:
            raise ArmError(f"{what} is {shown(value)}; expected a finite number or a formula")
        return value if isinstance(value, int) else float(value)
    text = str(value).strip()
    names(text, what)
    return plain(text, what)


@cache
def plain(written: str, what: str = "the entry") -> str:
    """An entry as it is printed or typed, in plain signs: ``"−π/2"``, ``"0,333"``, ``"333 mm"``.

    `what` says which units may follow a number: those of an angle for alpha and theta, of a length
    for a and d. What is not in plain signs is read by the judge, as the page's fields are.
    """
    must_be(written, str, "what is written")
    if len(written) > _LONGEST:
        raise ArmError(f"{what} has {len(written)} characters; expected at most {_LONGEST}")
    text = written.strip()
    if _tree(text) is not None:
        return text
    from helpers.checks.engine import asked  # no entry of the catalogue needs it

    found = asked("entry", text=text, kinds=_KINDS.get(what, ["angle", "length"]))
    if found.get("fault"):
        raise ArmError(f"{what} is {written!r}, which {found['fault']}")
    if _tree(found.get("text", "")) is None:
        raise ArmError(
            f"{what} is {written!r}; expected numbers, symbols, pi and + - * / ( ), such as"
            " '-pi/2' or 'd_6 + l_pen'"
        )
    return found["text"]


def names(text: Entry, what: str = "the entry") -> frozenset[str]:
    """The symbols of an entry, `pi` not counted."""
    text = text if isinstance(text, str) else entry(text, what)
    return _names(text, what) if isinstance(text, str) else frozenset()


@cache
def _names(text: str, what: str) -> frozenset[str]:
    return frozenset(n.id for n in ast.walk(_parse(text, what)) if isinstance(n, ast.Name)) - {"pi"}


def evaluate(text: Entry, values: Mapping[str, float]) -> float:
    """The number an entry stands for, with its symbols taken from `values`.

    Raises ArmError where a symbol has no value, or the formula divides by zero or is too large.
    """
    must_be(values, Mapping, "values")
    if type(text) in (int, float) and abs(text) < _PLAIN:  # type: ignore[arg-type]
        return float(text)
    text = text if isinstance(text, str) else entry(text, "the entry")
    try:
        found = float(
            _evaluate(_parse(text, "the entry"), values) if isinstance(text, str) else text
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
    tree = _tree(plain(text, what))
    assert tree is not None, "what is plain is a formula"
    return tree


@lru_cache(maxsize=1024)
def _tree(text: str) -> ast.expr | None:
    """The formula that a text in plain signs is; None for any other."""
    if not _SIGNS.fullmatch(text) or _SPELLED.search(text):
        return None
    try:
        tree = ast.parse(text, mode="eval").body
    except SyntaxError:
        return None
    allowed = (_is_number(node) or isinstance(node, _ALLOWED) for node in ast.walk(tree))
    return tree if all(allowed) else None


def _is_number(node: ast.AST) -> bool:
    value = node.value if isinstance(node, ast.Constant) else None
    return isinstance(value, int | float) and type(value) is not bool and math.isfinite(value)


_ALLOWED = (ast.Name, ast.Load, ast.BinOp, ast.UnaryOp, *_BINARY, *_UNARY)


def _evaluate(node: ast.expr, values: Mapping[str, float]) -> float:
    match node:
        case ast.Name("pi"):
            return math.pi
        case ast.Name(name):
            if name not in values:
                raise ArmError(f"no value for {name}; there are {', '.join([*values, 'pi'])}")
            return values[name]
        case ast.UnaryOp(op, operand):
            return _UNARY[type(op)](_evaluate(operand, values))
        case ast.BinOp(left, op, right):
            return _BINARY[type(op)](_evaluate(left, values), _evaluate(right, values))
    return node.value  # type: ignore[attr-defined]  # a Constant: the parser lets nothing else in
