"""Formulas written out in a page's HTML, LaTeX, Python and MATLAB, by one walk over the SymPy
expression.

A formula becomes pieces that are never broken, a term of a sum each, so that every writer can break
lines between them.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from html import escape

import sympy as sp

from helpers.inputs import ArmError

_LETTERS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ",
    "eta": "η", "theta": "θ", "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν",
    "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "upsilon": "υ", "phi": "φ",
    "chi": "χ", "psi": "ψ", "omega": "ω",
}  # fmt: skip
_MINUS = "−"


@dataclass(frozen=True)
class Language:
    """How one language writes what a formula is made of."""

    symbol: Callable[[str], str]
    fraction: str  # of p and q
    power: Callable[[str, int], str]
    call: Callable[[str, str], str]  # cos, sin or sqrt of something
    pi: str
    times: str
    minus: str = "-"


def pieces(expression: sp.Expr, language: Language) -> list[str]:
    """A formula in pieces between which a line may be broken: the terms of its sums, each with its
    sign.
    """
    if not isinstance(expression, sp.Add):
        return _product(expression, language)
    found: list[str] = []
    for term in expression.as_ordered_terms():
        negative = term.as_coeff_Mul()[0] < 0
        first, *rest = _product(-term if negative else term, language)
        sign = f"{language.minus} " if negative else "+ "
        if not found:
            sign = language.minus if negative else ""
        found += [sign + first, *rest]
    return found


def written(expression: sp.Expr, language: Language) -> str:
    """A formula on one line."""
    return " ".join(pieces(expression, language))


def _product(expression: sp.Expr, language: Language) -> list[str]:
    """A product, its single factors first, then its sums in parentheses."""
    number, rest = expression.as_coeff_Mul()
    if rest is sp.pi:
        return [_part_of_pi(number, language)]
    factors = sorted(sp.Mul.make_args(rest), key=_place)
    single = [_factor(f, language) for f in factors if not _is_sum(f) and f != 1]
    if abs(number) != 1 or not (single or any(map(_is_sum, factors))):
        single.insert(0, _number(abs(number), language))
    found = [language.times.join(single)] if single else []
    for factor in filter(_is_sum, factors):
        base, power = factor.as_base_exp()
        inner = pieces(base, language)
        inner[0], inner[-1] = f"({inner[0]}", f"{inner[-1]})"
        if power != 1:
            inner[-1] = language.power(inner[-1], int(power))
        found = [*found[:-1], found[-1] + language.times + inner[0], *inner[1:]] if found else inner
    if number < 0:
        found[0] = language.minus + found[0]
    return found


def _part_of_pi(number: sp.Rational, language: Language) -> str:
    """pi/2, -3*pi/4 and the like."""
    times = f"{abs(number.p)}{language.times}" if abs(number.p) != 1 else ""
    over = f"/{number.q}" if number.q != 1 else ""
    return f"{language.minus if number < 0 else ''}{times}{language.pi}{over}"


def _is_sum(factor: sp.Expr) -> bool:
    return isinstance(factor.as_base_exp()[0], sp.Add)


@cache
def _place(factor: sp.Expr) -> tuple:
    """Lengths and masses before cosines and sines, and those by the number of their joint."""
    name = str(factor.as_base_exp()[0])
    turning = re.fullmatch(r"([cs])_\{?([\d+-]+)\}?", name)
    if turning:
        return (1, turning[2], turning[1])
    return (1, "~", name) if name.startswith(("cos", "sin")) else (0, name)


def _factor(factor: sp.Expr, language: Language) -> str:
    base, power = factor.as_base_exp()
    if power == sp.Rational(1, 2):
        return language.call("sqrt", written(base, language))
    if not (power.is_Integer and power > 0):
        raise ArmError(f"the formula {factor} is no product of powers; expected sums and products")
    text = _atom(base, language)
    return text if power == 1 else language.power(text, int(power))


def _atom(atom: sp.Expr, language: Language) -> str:
    if isinstance(atom, sp.Symbol):
        return language.symbol(atom.name)
    if isinstance(atom, sp.cos | sp.sin):
        return language.call(atom.func.__name__, written(atom.args[0], language))
    if atom is sp.pi:
        return language.pi
    if atom.is_Rational:
        return _number(atom, language)
    raise ArmError(
        f"the formula {atom} is no cosine, sine, letter or number; expected one of these"
    )


# Names


def code_name(name: str) -> str:
    """A letter's name in a program: ``c_{2-3+4}`` becomes ``c_2m3p4``."""
    return name.replace("{", "").replace("}", "").replace("-", "m").replace("+", "p")


def html_name(name: str) -> str:
    """A letter with its index: ``d_3`` becomes an italic d with a 3 below it."""
    base, _, index = name.partition("_")
    index = index.strip("{}").replace("-", _MINUS).replace("_", "")
    below = f"<sub>{escape(index)}</sub>" if index else ""
    return f"<i>{escape(_LETTERS.get(base, base))}</i>{below}"


def latex_name(name: str) -> str:
    """A letter with its index: ``alpha_2`` becomes ``\\alpha_{2}``."""
    base, _, index = name.partition("_")
    index = index.strip("{}").replace("_", "")
    base = f"\\{base}" if base in _LETTERS else base
    base = base if len(base) == 1 or base.startswith("\\") else f"\\mathit{{{base}}}"
    if not index:
        return base
    return (
        f"{base}_{{{index}}}"
        if re.fullmatch(r"[\d+-]+", index)
        else f"{base}_{{\\mathrm{{{index}}}}}"
    )


# Numbers


def decimal(number: sp.Rational) -> str | None:
    """A rational as a decimal fraction, where it is one of not too many digits."""
    scaled = Fraction(int(number.p), int(number.q)) * 10**16
    if scaled.denominator != 1:
        return None
    whole, rest = divmod(abs(scaled.numerator), 10**16)
    digits = f"{rest:016d}".rstrip("0")
    return f"{'-' if number < 0 else ''}{whole}" + (f".{digits}" if digits else "")


def _number(number: sp.Rational, language: Language) -> str:
    return decimal(number) or language.fraction.format(p=number.p, q=number.q)


HTML = Language(
    symbol=html_name,
    fraction="{p}/{q}",
    power=lambda text, n: f"{text}<sup>{n}</sup>",
    call=lambda name, inner: f"{'√' if name == 'sqrt' else name}({inner})",
    pi="π",
    times="\u2009",
    minus=_MINUS,
)
LATEX = Language(
    symbol=latex_name,
    fraction=r"\tfrac{{{p}}}{{{q}}}",
    power=lambda text, n: f"{text}^{{{n}}}",
    call=lambda name, inner: rf"\sqrt{{{inner}}}" if name == "sqrt" else rf"\{name}({inner})",
    pi=r"\pi",
    times=" ",
)
SYMPY = Language(
    symbol=code_name,
    fraction="sp.Rational({p}, {q})",
    power=lambda text, n: f"{text}**{n}",
    call=lambda name, inner: f"sp.{name}({inner})",
    pi="sp.pi",
    times="*",
)
NUMPY = Language(
    symbol=code_name,
    fraction="{p}/{q}",
    power=lambda text, n: f"{text}**{n}",
    call=lambda name, inner: f"np.{name}({inner})",
    pi="np.pi",
    times="*",
)
MATLAB = Language(
    symbol=code_name,
    fraction="{p}/{q}",
    power=lambda text, n: f"{text}^{n}",
    call=lambda name, inner: f"{name}({inner})",
    pi="pi",
    times="*",
)
