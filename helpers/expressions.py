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
from fractions import Fraction
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

# Signs that are printed, and the ones that a formula is written in.
_SIGNS = (
    ("[−–—‐‑﹣－]", "-"),
    ("[·×⋅∙]", "*"),
    ("÷", "/"),
    ("π", " pi "),
    ("[º˚]", "°"),
    (r"(?i:\bdegrees?\b|(?<=\d)degrees?\b)", "deg"),
    (r"(?i:\bradians?\b)", "rad"),
    (r"(?i:\bmet(?:re|er)s?\b)", "m"),
)
_ANGLES = {"°": "*pi/180", "deg": "*pi/180", "rad": ""}
_LENGTHS = {"mm": "/1000", "cm": "/100", "m": ""}

_PLAIN = 1e15  # a number below is its own float, as nearly every entry is
_LONGEST = 200  # characters, so that no formula is nested deeper than Python can follow


def entry(value: object, what: str) -> Entry:
    """`value` as a checked table entry; a number, a string, or anything whose ``str`` is a
    formula."""
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
    for a and d. The explorer's fields read the same: tests/entries.json holds both to it.
    """
    must_be(written, str, "what is written")
    text = written.strip()
    for signs, sign in _SIGNS:
        text = re.sub(signs, sign, text)
    if "." not in text:
        text = re.sub(r"^([^,]*\d),(\d[^,]*)$", r"\1.\2", text)
    text = re.sub(
        r"(?<![\w.])(\d+\.?\d*|\.\d+)\s*(?=\(|pi\b)|(?<=\bpi)\s*(?=\()", r"\1*", text
    ).strip()
    units = (
        _ANGLES
        if what in ("alpha", "theta")
        else _LENGTHS
        if what in ("a", "d")
        else _ANGLES | _LENGTHS
    )
    unit = re.compile(rf"(?P<number>[\d.)])\s*(?P<unit>{'|'.join(units)})(?![\w°])")
    if not unit.search(text):
        return text
    terms = _terms(text)
    bare = [
        term for term in terms if not unit.search(term) and not re.fullmatch(r"[-+\s0.]*", term)
    ]
    spelled = [
        term for term in bare if not re.search(r"[^\W\d]", term)
    ]  # a symbol and π have their own
    own = {match["unit"] for match in unit.finditer(text)}
    if spelled and not own <= {"rad", "m"}:
        mixed = "which mixes numbers with and without a unit; expected the unit of each"
        raise ArmError(f"{what} is {written!r}, {mixed}")
    if any("pi" in term and unit.search(term) and own & {"°", "deg"} for term in terms):
        raise ArmError(f"{what} is {written!r}; expected π or degrees, not both")
    return "".join(_converted(term, unit, units) for term in terms)


def _terms(text: str) -> list[str]:
    """The terms of a sum, each with its sign; what stands in brackets belongs to one term."""
    terms, depth = [""], 0
    for sign in text:
        depth += (sign == "(") - (sign == ")")
        if sign in "+-" and not depth and terms[-1].strip() and terms[-1].rstrip()[-1] not in "*/e":
            terms.append("")
        terms[-1] += sign
    return terms


def _converted(term: str, unit: re.Pattern[str], units: Mapping[str, str]) -> str:
    degrees = re.fullmatch(r"(?P<sign>[-+\s]*)(?P<whole>\d+)\s*(°|deg)", term)
    if degrees and int(degrees["whole"]) % 15 == 0 and int(degrees["whole"]):
        turn = Fraction(int(degrees["whole"]), 180)  # a quarter turn stays one, not 1.5708
        top = "pi" if turn.numerator == 1 else f"{turn.numerator}*pi"
        return degrees["sign"] + (top if turn.denominator == 1 else f"{top}/{turn.denominator}")
    return unit.sub(lambda match: match["number"] + units[match["unit"]], term)


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


@lru_cache(maxsize=1024)
def _parse(text: str, what: str) -> ast.expr:
    text = plain(text, what) if len(text) <= _LONGEST else text
    if len(text) > _LONGEST:
        raise ArmError(f"{what} has {len(text)} characters; expected at most {_LONGEST}")
    if re.search(r"\b\d+_|\b0[xob]", text, re.IGNORECASE):
        raise ArmError(f"{what} is {text!r}; expected numbers in plain digits")
    wrong = (
        f"{what} is {text!r}; expected numbers, symbols, pi and + - * / ( ), such as '-pi/2'"
        " or 'd_6 + l_pen'"
    )
    try:
        tree = ast.parse(text, mode="eval").body
    except SyntaxError:
        raise ArmError(wrong) from None
    for node in ast.walk(tree):
        if not (_is_number(node) or isinstance(node, _ALLOWED)):
            raise ArmError(wrong)
    return tree


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
