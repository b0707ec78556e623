"""Formulas as textbooks write them: c_23 for cos(q_2 + q_3), what terms share taken out, and both
terms and factors in the arm's order, from the base to the tip.

A sum is a dictionary from monomials to numbers here, and a monomial a tuple of (place, power,
atom), sorted: lengths before cosines and sines, and each by their joints.
"""

import re
from collections.abc import Iterable
from functools import cache, lru_cache
from typing import NamedTuple

import sympy as sp

from helpers.inputs import ArmError, shown

Place = tuple[int, int, str, str]  # what sorts an atom: its kind, joint, index and letter
Factor = tuple[Place, int, sp.Expr]
Monomial = tuple[Factor, ...]
Polynomial = dict[Monomial, sp.Expr]

_TURN = re.compile(r"([cs])_\{?(\d[\d+-]*)\}?")
_LENGTH, _ANGLE, _MIXED = range(3)
_LAST = 10**6


class Terms(sp.Add):
    """A sum that is printed in the order given."""

    func = property(lambda _: sp.Add)

    def as_ordered_terms(self, order=None, data=False):
        """The terms as they were given."""
        return list(self.args)


class Factors(sp.Mul):
    """A product that is printed in the order given."""

    func = property(lambda _: sp.Mul)

    def _latex(self, printer):
        """SymPy's own way to write a fraction sorts what stands above the line."""
        number, rest = self.as_coeff_Mul()
        if not number.is_Rational or number.q == 1:
            return printer._print_Mul(self)
        sign = "- " if number < 0 else ""
        above = [sp.Integer(abs(number.p))] if abs(number.p) != 1 else []
        above = Factors._from_args([*above, *sp.Mul.make_args(rest)])
        return rf"{sign}\frac{{{printer._print(above)}}}{{{number.q}}}"

    def as_ordered_factors(self, order=None):
        """The factors as they were given."""
        return list(self.args)


def short(expression):
    """`expression` as textbooks write it, a matrix entry by entry; its value stays the same.

    c_23 is cos(q_2 + q_3), s_1 is sin(q_1). What terms share is taken out, as d_6 + l_pen or c_1.
    Terms and factors stand in the arm's order, in which SymPy prints them. It is made to be read:
    what is computed with it is plain SymPy again. Raises ArmError for what is neither an expression
    of SymPy nor a matrix of them.
    """
    must_be_expression(expression)
    named = expression.xreplace(short_names(expression))
    return named.applyfunc(_written) if isinstance(named, sp.MatrixBase) else _written(named)


def must_be_expression(given: object) -> None:
    """Raise ArmError for what is neither an expression of SymPy nor a matrix of them."""
    if not isinstance(given, sp.Basic | sp.MatrixBase):
        raise ArmError(f"expression is {shown(given)}; expected one of SymPy, or a matrix of them")


def short_names(expression) -> dict[sp.Expr, sp.Symbol]:
    """The letters of `short` for the cosines and sines of an expression or matrix."""
    found = {f: _index(f.args[0]) for f in expression.atoms(sp.cos, sp.sin)}
    return {f: sp.Symbol(f"{f.func.__name__[0]}_{i}") for f, i in found.items() if i}


def _index(angle: sp.Expr) -> str:
    """The index of a short name: ``23`` for q_2 + q_3, ``{2-3+4}`` where signs differ, nothing if
    it is no sum, or beyond joint 9, where 12 would be two joints or one."""
    terms = [term.as_coeff_Mul() for term in sp.Add.make_args(angle)]
    if not all(c in (1, -1) and re.fullmatch(r"q_\d", str(s)) for c, s in terms):
        return ""
    joints = sorted((str(s)[2:], "-" if c < 0 else "+") for c, s in terms)
    index = "".join(f"{sign}{joint}" for joint, sign in joints)
    return index.replace("+", "") if "-" not in index else f"{{{index.removeprefix('+')}}}"


# Into TeX


@lru_cache(maxsize=4096)
def tex(formula: sp.Expr) -> str:
    """A formula in which a line may be broken within parentheses."""
    text = sp.latex(formula).replace(r"\left(", "(").replace(r"\right)", ")")
    return text.replace(" )", ")")


def seen(text: str) -> int:
    """About how many letters and signs of TeX are seen."""
    return len(re.sub(r"\\[a-z]+|[\s{}_^~]", "", text))


def lines(formula: sp.Expr, width: int) -> list[str]:
    """A formula in TeX, broken between terms into lines of so many letters and signs, not within
    short brackets."""
    whole = re.sub(r"\([^()]{,60}\)", lambda short: short[0].replace(" ", "~"), tex(formula))
    found = [""]
    for piece in re.split(r" (?=[+-] )", whole):
        inside = found[-1].count("{") != found[-1].count("}")
        if inside or seen(found[-1] + piece) <= width:
            found[-1] = f"{found[-1]} {piece}".strip()
        else:
            found.append(piece)
    return [line.replace("~", " ") for line in found]


# Into monomials


@cache
def _place(atom: sp.Expr) -> Place:
    """Lengths and masses by the number in their index, those without an index first and l_pen last;
    then cosines and sines by their joints, and rates."""
    name = str(atom)
    if turn := _TURN.fullmatch(name):
        return _ANGLE, int(turn[2][0]), turn[2], turn[1]
    if atom.has(sp.cos, sp.sin) or "dot" in name:
        return _ANGLE, _LAST, "", name
    _, index, rest = name.partition("_")
    number = re.search(r"\d+", rest)
    return _LENGTH, int(number[0]) if number else _LAST * bool(index), "", name


def _polynomial(expression: sp.Expr) -> Polynomial:
    if any(factor.has(sp.Add) for term in expression.args for factor in term.args):
        expression = sp.expand_mul(expression)
    found: Polynomial = {}
    for term in sp.Add.make_args(expression):
        number, rest = term.as_coeff_Mul()
        factors = [_factor(f) for f in sp.Mul.make_args(rest) if f != 1]
        monomial = tuple(sorted(factors, key=_by_place))
        found[monomial] = found.get(monomial, sp.S.Zero) + number
    return {monomial: number for monomial, number in found.items() if number}


def _factor(factor: sp.Expr) -> Factor:
    base, power = factor.as_base_exp()
    if power.is_Integer and power > 0:
        return _place(base), int(power), base
    return _place(factor), 1, factor


def _by_place(factor: Factor) -> tuple[Place, int]:
    return factor[:2]


# What is shared, taken out


class _Part(NamedTuple):
    """A part of a formula as it will be printed: what sorts it, how many letters it has, whether a
    minus stands first."""

    place: tuple
    letters: int
    minus: bool
    formula: sp.Expr


def _written(expression: sp.Expr) -> sp.Expr:
    """An expression in its short form; what is a product already stays one."""
    if isinstance(expression, sp.Add):
        return _sum(_terms(_polynomial(expression))).formula
    number, rest = expression.as_coeff_Mul()
    parts = []
    for factor in sp.Mul.make_args(rest):
        base, power = factor.as_base_exp()
        if isinstance(base, sp.Add) and power.is_Integer and power > 0:
            sign, taken = _taken_out(_polynomial(base))
            number *= sign**power
            parts += [_power(part, power) for part in taken]
        elif factor != 1:
            parts.append(_atom(_factor(factor)))
    return _product(number, parts).formula


def _atom(factor: Factor) -> _Part:
    place, power, atom = factor
    return _Part((place[0], (place, power)), power, False, sp.Pow(atom, power))


def _power(part: _Part, power: sp.Integer) -> _Part:
    return part._replace(formula=sp.Pow(part.formula, power, evaluate=False)) if power > 1 else part


def _product(number: sp.Expr, parts: list[_Part]) -> _Part:
    """Lengths, then what turns, then sums of both."""
    parts = sorted(parts, key=lambda part: part.place)
    written = [part.formula for part in parts]
    if number != 1 or not parts:
        written.insert(0, number)
    place = _first_place(parts) if parts else ()
    letters = sum(part.letters for part in parts)
    return _Part(place, letters, number < 0, Factors._from_args(written))


def _first_place(parts: Iterable[_Part]) -> tuple:
    """The kind of all parts, and the place of the first."""
    places = [part.place for part in parts if part.place]
    kinds = {kind for kind, *_ in places}
    return kinds.pop() if len(kinds) == 1 else _MIXED, *(p for _, *rest in places for p in rest)


def _taken_out(poly: Polynomial) -> tuple[sp.Expr, list[_Part]]:
    """A sum as a number and its factors, of which none has a minus first."""
    number = _unit(poly)
    powers = [{factor[::2]: factor[1] for factor in monomial} for monomial in poly]
    common = {key: min(p.get(key, 0) for p in powers) for key in powers[0]}
    rest = {
        tuple((p, more, a) for p, n, a in monomial if (more := n - common.get((p, a), 0))): value
        / number
        for monomial, value in poly.items()
    }
    parts = [_atom((place, n, atom)) for (place, atom), n in common.items() if n]
    if len(rest) == 1:
        return number, parts
    for pairs in (_gathered(rest, *cut) for cut in _cuts(rest)):
        if len(pairs) == 1 and min(map(len, pairs[0])) > 1:
            (sign, first), (other, second) = map(_taken_out, pairs[0])
            return number * sign * other, [*parts, *first, *second]
    part = _sum(_best(_frozen(rest)))
    if part.minus:
        number, part = -number, _sum(_best(_frozen({m: -n for m, n in rest.items()})))
    return number, [*parts, part]


def _terms(poly: Polynomial) -> tuple[_Part, ...]:
    """A sum as a product, where its terms share something, or else as its terms."""
    number, parts = _taken_out(poly)
    if len(poly) > 1 and len(parts) == 1 and abs(number) == 1:
        return _best(_frozen(poly))
    return (_product(number, parts),)


def _unit(poly: Polynomial) -> sp.Expr:
    """The sign of its first term, with the number before it where all have the same."""
    sizes = {abs(number) for number in poly.values()}
    sign = sp.sign(poly[min(poly, key=_by_places)])
    return sign * sizes.pop() if len(sizes) == 1 else sign


def _by_places(monomial: Monomial) -> tuple:
    return tuple(map(_by_place, monomial))


def _frozen(poly: Polynomial) -> frozenset:
    return frozenset(poly.items())


@lru_cache(maxsize=4096)
def _best(sum_: frozenset) -> tuple[_Part, ...]:
    """The terms of a sum, gathered in the way that leaves the fewest letters."""
    poly = dict(sum_)
    ways = [tuple(_product(n, [*map(_atom, monomial)]) for monomial, n in poly.items())]
    for cut, swapped in _cuts(poly):
        pairs = _gathered(poly, cut, swapped)
        if 1 < len(pairs) < len(poly):
            ways.append(tuple(term for pair in pairs for term in _multiplied(*pair)))
    return min(ways, key=lambda terms: sum(term.letters for term in terms))


def _cuts(poly: Polynomial) -> list[tuple[tuple[int, ...], bool]]:
    """The places at which monomials are cut in two, and whether to gather by the second half: by
    lengths or angles where there are both, else by the joints before one."""
    places = {place for monomial in poly for place, *_ in monomial}
    kinds = {place[0] for place in places}
    if len(kinds) == 2:
        return [((_ANGLE,), False), ((_ANGLE,), True)]
    joints = sorted({place[:2] for place in places})
    return [(joint, False) for joint in joints[1:]]


def _gathered(
    poly: Polynomial, cut: tuple[int, ...], swapped: bool
) -> list[tuple[Polynomial, Polynomial]]:
    """A sum as products of two: what has the same head put together, and then what has the same
    tail."""
    tails: dict[Monomial, Polynomial] = {}
    for monomial, number in poly.items():
        head = tuple(factor for factor in monomial if (factor[0] < cut) != swapped)
        tail = tuple(factor for factor in monomial if (factor[0] < cut) == swapped)
        tails.setdefault(head, {})[tail] = number
    heads: dict[frozenset, Polynomial] = {}
    for head, poly_of in tails.items():
        number = _unit(poly_of)
        same = _frozen({tail: n / number for tail, n in poly_of.items()})
        heads.setdefault(same, {})[head] = number
    return [(head_poly, dict(same)) for same, head_poly in heads.items()]


def _multiplied(head: Polynomial, tail: Polynomial) -> tuple[_Part, ...]:
    """The product of two sums."""
    if [*head] == [()]:
        return _terms({monomial: n * head[()] for monomial, n in tail.items()})
    (number, before), (times, after) = _taken_out(head), _taken_out(tail)
    return (_product(number * times, before + after),)


def _sum(terms: Iterable[_Part]) -> _Part:
    terms = sorted(terms, key=lambda part: part.place[1:])
    formula = Terms._from_args([part.formula for part in terms])
    letters = sum(part.letters for part in terms)
    return _Part(_first_place(terms), letters, terms[0].minus, formula)
