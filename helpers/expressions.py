"""Read the entries of tables, which are numbers or formulas such as ``"-pi/2"``.

An entry is kept as a formula and read only here: as a float once its symbols have values, or as
LaTeX for a table. `helpers.symbolic` hands the same formula to SymPy. Entries of a typed table,
with units or decimal commas, are read by `helpers.checks.read_table`.
"""

import ast
import math
import operator
import re
import sys
from collections.abc import Callable, Mapping
from functools import cache, lru_cache

from helpers.inputs import ArmError, require_type, shorten

Entry = str | float

_BINARY: dict[type, Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
_UNARY: dict[type, Callable[[float], float]] = {ast.UAdd: operator.pos, ast.USub: operator.neg}

_EXACT_BELOW = 1e15  # each integer below it is exact as a float
_MAX_LENGTH = 200  # characters; longer formulas could exceed Python's recursion limit
# An entry that consists of these characters can be parsed unchanged.
_PLAIN_CHARACTERS = re.compile(r"[A-Za-z0-9_+\-*/(). ]+")
# Python would parse these texts as numbers or names, but entries must not contain them.
_NOT_PLAIN = re.compile(r"\b\d+_|\b0[xob]|\b(?:deg|rad)\b", re.IGNORECASE)
# Names of Greek letters in LaTeX.
_GREEK = (
    "alpha|beta|gamma|delta|epsilon|zeta|eta|theta|iota|kappa|lambda|mu|nu|xi|pi|rho|sigma|tau"
    "|upsilon|phi|chi|psi|omega"
)


def check_entry(value: object, name: str) -> Entry:
    """Convert `value` to a table entry.

    Args:
        value: A number, a text, or any object whose ``str`` is a formula.
        name: Name of the entry in messages.

    Raises:
        ArmError: `value` is no finite number and no formula.
    """
    if isinstance(value, complex):
        raise ArmError(f"{name} is {str(value)!r}; expected numbers, symbols, pi and + - * / ( )")
    if isinstance(value, bool) or value is None:
        raise ArmError(
            f"{name} is {value!r}; expected a number or a formula such as 'pi/2' or 'a_3'"
        )
    if isinstance(value, int | float):
        if not abs(value) <= sys.float_info.max:
            raise ArmError(f"{name} is {shorten(value)}; expected a finite number or a formula")
        return value if isinstance(value, int) else float(value)
    text = str(value).strip()
    symbol_names(text, name)
    return plain_formula(text, name)


@cache
def plain_formula(written: str, name: str = "the entry") -> str:
    """Return an entry as a plain formula, with ``-`` and ``pi`` in place of ``−`` and ``π``.

    Args:
        written: The entry as it was typed or printed.
        name: Name of the entry in messages.

    Raises:
        ArmError: The text is no formula of numbers, symbols, pi, + - * / and parentheses.
    """
    require_type(written, str, "what is written")
    if len(written) > _MAX_LENGTH:
        raise ArmError(f"{name} has {len(written)} characters; expected at most {_MAX_LENGTH}")
    text = written.strip().replace("\N{MINUS SIGN}", "-").replace("π", "pi")
    if _parse_plain_formula(text) is None:
        raise ArmError(
            f"{name} is {written!r}; expected numbers, symbols, pi and + - * / ( ), such as"
            " '-pi/2' or 'd_6 + l_pen', in m and rad without their units"
        )
    return text


def symbol_names(text: Entry, name: str = "the entry") -> frozenset[str]:
    """Return the names of an entry's symbols, without `pi`."""
    text = text if isinstance(text, str) else check_entry(text, name)
    return _find_formula_names(text, name) if isinstance(text, str) else frozenset()


@cache
def _find_formula_names(text: str, name: str) -> frozenset[str]:
    nodes = ast.walk(_parse_entry(text, name))
    return frozenset(node.id for node in nodes if isinstance(node, ast.Name)) - {"pi"}


def evaluate_entry(text: Entry, values: Mapping[str, float]) -> float:
    """Compute the number that an entry has for these values of its symbols.

    Args:
        text: The entry.
        values: The numbers of its symbols.

    Raises:
        ArmError: A symbol has no value, or the formula divides by zero or is too large.
    """
    require_type(values, Mapping, "values")
    if type(text) in (int, float) and abs(text) < _EXACT_BELOW:  # type: ignore[arg-type]
        return float(text)
    text = text if isinstance(text, str) else check_entry(text, "the entry")
    try:
        number = float(
            _evaluate_node(_parse_entry(text, "the entry"), values)
            if isinstance(text, str)
            else text
        )
    except ArithmeticError:
        number = math.nan
    if not math.isfinite(number):
        raise ArmError(f"{text} divides by zero or is too large; expected a finite value")
    return number


def entry_latex(text: Entry) -> str:
    """Write an entry in LaTeX.

    ``"-(d_7 + l_pen)"`` becomes ``-(d_{7} + l_{pen})``.
    """
    text = check_entry(text, "the entry")
    if not isinstance(text, str):
        return f"{text:g}"
    text = re.sub(rf"\b({_GREEK})(?![A-Za-z0-9])", r"\\\1", text)
    text = re.sub(r"_(\w+)", r"_{\1}", text)
    return text.replace("*", r"\,")


def _parse_entry(text: str, name: str) -> ast.expr:
    tree = _parse_plain_formula(plain_formula(text, name))
    assert tree is not None, "plain_formula returns formulas only"
    return tree


@lru_cache(maxsize=1024)
def _parse_plain_formula(text: str) -> ast.expr | None:
    """Parse a plain formula, or return None if the text is no plain formula."""
    if not _PLAIN_CHARACTERS.fullmatch(text) or _NOT_PLAIN.search(text):
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


def _evaluate_node(node: ast.expr, values: Mapping[str, float]) -> float:
    match node:
        case ast.Name("pi"):
            return math.pi
        case ast.Name(name):
            if name not in values:
                raise ArmError(f"no value for {name}; there are {', '.join([*values, 'pi'])}")
            return values[name]
        case ast.UnaryOp(op, operand):
            return _UNARY[type(op)](_evaluate_node(operand, values))
        case ast.BinOp(left, op, right):
            return _BINARY[type(op)](_evaluate_node(left, values), _evaluate_node(right, values))
    return node.value  # type: ignore[attr-defined]  # _parse_plain_formula lets no other node through
