"""Formulas as people type them: NumPy, MATLAB, LaTeX, unicode. A small parser of our own, so that
no text is ever run.

A tree is ("num", x), ("name", n), ("neg", t), ("call", function, t) or ("+" | "-" | "*" | "/" |
"^", left, right).
"""

import math
import operator
import re
from collections.abc import Callable
from functools import lru_cache

from helpers.inputs import ArmError, shown

Tree = tuple
KEPT = 4096  # texts whose reading is kept, for a table's cells are asked for in every order
LONGEST = 20_000  # characters of one formula
_TEN = 10.0  # whose powers are meant, 10^0 too
DEEPEST = 60  # brackets in brackets

FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "sqrt": math.sqrt,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
    "abs": abs,
    "radians": math.radians,
    "deg2rad": math.radians,
    "degrees": math.degrees,
    "rad2deg": math.degrees,
    "sind": lambda x: math.sin(math.radians(x)),
    "cosd": lambda x: math.cos(math.radians(x)),
    "float": float,
    "Float": float,
    "Integer": float,
    "float64": float,
    "float32": float,
    "int64": float,
}
_SIGNS: dict[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "^": math.pow,
}
_CONSTANTS = {"pi": math.pi, "deg": math.pi / 180, "rad": 1.0}
_GREEK = dict(
    zip(
        "αβγδθϑφϕψωλ",
        [
            "alpha",
            "beta",
            "gamma",
            "delta",
            "theta",
            "theta",
            "phi",
            "phi",
            "psi",
            "omega",
            "lambda",
        ],
        strict=True,
    )
)
_SAME = {
    **dict.fromkeys("−–—‐‑‒﹣－", "-"),
    **dict.fromkeys("×⋅·∙∗", "*"),
    **dict.fromkeys("÷∕⁄", "/"),
    **dict.fromkeys("\u00a0\u2009\u202f\u2007\u2002\u2003\u200a\u3000", " "),
    **dict.fromkeys("\u200b\u2061\u2062\ufeff", ""),
    **dict.fromkeys("′’‘", "'"),
    **{s: f"_{i}" for i, s in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    **{letter: f" {name}" for letter, name in _GREEK.items()},
    "π": " pi ",
    "𝜋": " pi ",
    "$": " ",
    **{chr(0xFF10 + i): str(i) for i in range(10)},  # as typed among Chinese signs
    "°": " deg",
    **dict.fromkeys("º˚◦∘", " deg"),
    "√": "sqrt",
    "⅓": "(1/3)",
    "½": "(1/2)",
    "¼": "(1/4)",
    "∞": " inf ",
}
_TABLE = str.maketrans(_SAME)
_LATEX = (
    (r"\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)(?![A-Za-z])", " "),
    (r"\\[,;:! ]|~|\\hspace\{[^{}]*\}", " "),
    (
        r"\\(?:mathrm|text(?:bf|it|rm)?|math(?:it|bf|sf)|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}",
        r"\1",
    ),
    (r"\\ang\s*\{([^{}]*)\}|\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{\s*\\degree\s*\}", r"(\1\2 deg)"),
    (r"\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)(?![A-Za-z])", " deg"),
    (r"\\(?:cdot|times|ast)(?![A-Za-z])", "*"),
    (r"\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)", " "),
    (r"_\s*\{\s*(\w+)\s*\}", r"_\1"),
    (r"_\s*\{\s*([\w+-]+)\s*\}", r"_{\1}"),
    (r"(?<=[0-9])\^\s*\{?\s*o\s*\}?(?![A-Za-z0-9])", " deg"),
    (r"(\\[dt]?frac)\s*([0-9]|\\pi(?![A-Za-z]))", r"\1{\2}"),
    (r"(\\[dt]?frac\s*\{[^{}]*\})\s*([0-9]|\\pi(?![A-Za-z]))", r"\1{\2}"),
    (r"(?<=[0-9.)])\s*(deg|rad)(?:ree|ian)s?(?![A-Za-z0-9_]|\s*\()", r" \1"),
)
_INNERMOST = (
    (re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}"), r"((\1)/(\2))"),
    (re.compile(r"(\\(?:sqrt|sin|cos|tan)|\^)\s*\{([^{}]*)\}"), r"\1(\2)"),
)
_RAISED = re.compile("[⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+")
_POWERS = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")
_ROOT = re.compile(r"√ ?([0-9]+(?:\.[0-9]+)?)")
_COUNTED = re.compile(r"(?<![A-Za-z_])(q|th|theta) *(?:\[ *([0-9]{1,2}) *\]|\( *([0-9]{1,2}) *\))")
_MIXED = re.compile("(?<![A-Za-z0-9_.])([0-9]+) ?([⅓½¼])")
_BRACES = re.compile(r"\{[\w+-]*\}|\}")  # an index such as {2-3}, or what closes a bracket
_NAME = r"[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?"
_TOKEN = re.compile(
    r"\s*(?:([0-9]+(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?|\.[0-9]+(?:[eE][+-]?[0-9]+)?)"
    rf"|({_NAME})|(\*\*|[-+*/^()]))"
)
_SHORT = re.compile(r"[cs]_?(?:\d|\{[\d+-]+\})+")
_RUN = re.compile(rf"(?:{_SHORT.pattern}){{2,}}$")  # such as c_1s_23, which is a product
_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def is_number(text: str) -> bool:
    """Whether a text is one number in plain signs, as nearly every cell of a long paste is."""
    return _NUMBER.fullmatch(text) is not None


@lru_cache(KEPT)
def plain(text: str) -> str:
    """The text in plain signs: unicode and LaTeX spelled out, prefixes such as ``np.`` dropped."""
    if is_number(text):
        return text
    text = _RAISED.sub(lambda match: f"^{match[0].translate(_POWERS)}", text)
    text = _ROOT.sub(r"sqrt(\1)", _MIXED.sub(r"(\1+\2)", text)).translate(_TABLE)
    for pattern, instead in _LATEX:
        text = re.sub(pattern, instead, text)
    before = ""
    while before != text:
        before = text
        for innermost, opened in _INNERMOST:
            text = innermost.sub(opened, text)
    text = re.sub(r"\\([A-Za-z]+)", r" \1 ", text)
    text = re.sub(r"\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\.", "", text)
    text = re.sub(r"\.(?=[*/^])", "", text)  # MATLAB's signs for entry by entry
    text = re.sub(r"(?<=\w)\s*\(t\)", "", text)
    text = _COUNTED.sub(r"\1_\2\3", text)
    text = re.sub(r"(\b[a-z]+) +_(?=[\w{])", r"\1_", text)
    text = re.sub(r"(?<![_\w])\{|(?<=[^\w+-])\{", "(", text)
    text = _BRACES.sub(lambda match: ")" if match[0] == "}" else match[0], text)
    return re.sub(r"[ \t]+", " ", text).strip()


def parse(text: str, what: str = "the formula") -> Tree:
    """The tree of one formula; raises ArmError, quoting it, where it is none."""
    if len(text) > LONGEST:
        raise ArmError(f"{what} has {len(text)} characters; expected at most {LONGEST}")
    if not text.strip():
        raise ArmError(f"{what} is empty; expected a number or a formula, or 0")
    tree = _tree(plain(text))
    if tree is None:
        raise ArmError(
            f"{what} is {shown(text)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )"
        )
    if not tree:
        raise ArmError(
            f"{what} is {shown(text)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'"
        )
    return tree


@lru_cache(maxsize=1024)
def _tree(text: str) -> Tree | None:
    """The tree of a text in plain signs: empty where it is no formula, None where a sign is odd."""
    tokens = _tokens(text)
    if tokens is None:
        return None
    try:
        tree, rest = _sum(tokens, 0, 0)
    except (IndexError, SyntaxError):
        return ()
    return tree if rest == len(tokens) else ()


def _tokens(text: str) -> list[tuple[str, str]] | None:
    found: list[tuple[str, str]] = []
    at = 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if not match:
            return None
        number, name, sign = match.groups()
        if number:
            found.append(("num", number))
        elif sign:
            found.append(("sign", "^" if sign == "**" else sign))
        else:
            names = _SHORT.findall(name) if _RUN.match(name) else [name]
            found += [("name", one) for one in names]
        at = match.end()
    return found


def _sum(tokens: list, at: int, depth: int) -> tuple[Tree, int]:
    left, at = _product(tokens, at, depth)
    while at < len(tokens) and tokens[at][1] in ("+", "-"):
        right, after = _product(tokens, at + 1, depth)
        left, at = (tokens[at][1], left, right), after
    return left, at


def _product(tokens: list, at: int, depth: int) -> tuple[Tree, int]:
    left, at = _signed(tokens, at, depth)
    while at < len(tokens):
        sign = tokens[at][1]
        if sign in ("*", "/"):
            right, after = _signed(tokens, at + 1, depth)
        elif sign == "(" or tokens[at][0] != "sign":
            if tokens[at][0] == tokens[at - 1][0] == "num":  # 1 234.5 is no product
                raise SyntaxError
            sign, (right, after) = "*", _power(tokens, at, depth)
        else:
            break
        left, at = (sign, left, right), after
    return left, at


def _signed(tokens: list, at: int, depth: int) -> tuple[Tree, int]:
    if depth > DEEPEST:
        raise SyntaxError
    if tokens[at][1] == "-":
        inner, at = _signed(tokens, at + 1, depth + 1)
        return ("neg", inner), at
    if tokens[at][1] == "+":
        return _signed(tokens, at + 1, depth + 1)
    return _power(tokens, at, depth)


def _power(tokens: list, at: int, depth: int) -> tuple[Tree, int]:
    base, at = _atom(tokens, at, depth)
    if at < len(tokens) and tokens[at][1] == "^":
        exponent, at = _signed(tokens, at + 1, depth + 1)
        if base[0] == "num" and base[1] > _TEN and exponent == ("num", 0.0):  # 90^0 is no 1
            raise SyntaxError
        return ("^", base, exponent), at
    return base, at


def _atom(tokens: list, at: int, depth: int) -> tuple[Tree, int]:
    kind, word = tokens[at]
    if kind == "num":
        return ("num", float(word)), at + 1
    if kind == "name" and word in FUNCTIONS and at + 1 < len(tokens):
        if tokens[at + 1][1] == "^":  # sin^2 x
            power, at = _atom(tokens, at + 2, depth + 1)
            if power[0] != "num":  # sin^-1 is another function
                raise SyntaxError
            inner, at = _argument(tokens, at, depth + 1)
            return ("^", ("call", word, inner), power), at
        inner, at = _argument(tokens, at + 1, depth + 1)
        return ("call", word, inner), at
    if kind == "name":
        return ("name", word), at + 1
    if word != "(":
        raise SyntaxError
    inner, at = _sum(tokens, at + 1, depth + 1)
    if tokens[at][1] != ")":
        raise SyntaxError
    return inner, at + 1


def _argument(tokens: list, at: int, depth: int) -> tuple[Tree, int]:
    """What a function is taken of: a bracket, or the next factor, as in ``sin theta_1``."""
    if depth > DEEPEST:
        raise SyntaxError
    if tokens[at][1] == "-":
        inner, at = _atom(tokens, at + 1, depth)
        return ("neg", inner), at
    return _atom(tokens, at, depth)


def symbols(tree: Tree) -> set[str]:
    """The names in a tree that are no constants."""
    found, parts = set(), [tree]
    while parts:  # a sum may have more terms than Python lets functions call one another
        kind, *of = parts.pop()
        if kind == "name":
            found.update(of)
        parts += [part for part in of if isinstance(part, tuple)]
    return found - _CONSTANTS.keys()


def value(tree: Tree, known: Callable[[str], float | None]) -> float:
    """The number of a tree, names looked up by `known`; raises ArmError for an unknown one or no
    finite number.
    """
    try:
        found = float(_value(tree, known))
    except ArmError:
        raise
    except (ArithmeticError, ValueError):
        found = math.nan
    if not math.isfinite(found):
        raise ArmError("a formula divides by zero or is too large; expected a finite value")
    return found


def _value(tree: Tree, known: Callable[[str], float | None]) -> float:
    later = []  # what is left to do from left to right, for a sum may have very many terms
    while tree[0] in _SIGNS:
        later.append((_SIGNS[tree[0]], tree[2]))
        tree = tree[1]
    found = _single(tree, known)
    for sign, right in reversed(later):
        found = sign(found, _value(right, known))
    return found


def _single(tree: Tree, known: Callable[[str], float | None]) -> float:
    kind, first = tree[:2]
    if kind == "num":
        return first
    if kind == "neg":
        return -_value(first, known)
    if kind == "call":
        return FUNCTIONS[first](_value(tree[2], known))
    found = _CONSTANTS[first] if first in _CONSTANTS else known(first)
    if found is None:
        raise ArmError(f"no value for {first}")
    return found


def number(text: str) -> float | None:
    """The number a text stands for if it holds no symbols, else None."""
    if is_number(text) and math.isfinite(found := float(text)):
        return found
    try:
        return value(parse(text), lambda name: None)
    except ArmError:
        return None
