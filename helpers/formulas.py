"""Write formulas as textbooks do.

c_23 stands for cos(q_2 + q_3), common factors are taken out of sums, and terms and factors stand in
the arm's order, from the base to the tip.

In this file a sum is a dictionary from monomials to numbers, and a monomial is a sorted tuple of
(sort key, power, atom): lengths come before cosines and sines, and both are sorted by their joints.
"""

import re
from collections.abc import Iterable
from functools import cache, lru_cache
from typing import NamedTuple

import sympy as sp

from helpers.deprecated import deprecated_names
from helpers.inputs import ArmError, shorten

SortKey = tuple[int, int, str, str]  # an atom's kind, joint, index and name
Factor = tuple[SortKey, int, sp.Expr]
Monomial = tuple[Factor, ...]
Polynomial = dict[Monomial, sp.Expr]

_SHORT_NAME = re.compile(r"([cs])_\{?(\d[\d+-]*)\}?")
_LENGTH, _ANGLE, _MIXED = range(3)
_LAST_JOINT = 10**6  # larger than any joint number, so that such atoms are sorted last


class Terms(sp.Add):
    """A sum that is printed in the order of its arguments."""

    func = property(lambda _: sp.Add)

    def as_ordered_terms(self, order=None, data=False):
        """Return the terms in their order."""
        return list(self.args)


class Factors(sp.Mul):
    """A product that is printed in the order of its arguments."""

    func = property(lambda _: sp.Mul)

    def _latex(self, printer):
        """Write a fraction without sorting its numerator, as SymPy's printer would."""
        number, rest = self.as_coeff_Mul()
        if not number.is_Rational or number.q == 1:
            return printer._print_Mul(self)
        sign = "- " if number < 0 else ""
        above = [sp.Integer(abs(number.p))] if abs(number.p) != 1 else []
        above = Factors._from_args([*above, *sp.Mul.make_args(rest)])
        return rf"{sign}\frac{{{printer._print(above)}}}{{{number.q}}}"

    def as_ordered_factors(self, order=None):
        """Return the factors in their order."""
        return list(self.args)


def abbreviate(expression):
    """Write an expression, or each entry of a matrix, as textbooks do.

    c_23 is cos(q_2 + q_3), s_1 is sin(q_1). Common factors such as d_6 + l_pen or c_1 are taken
    out, and terms and factors are printed in the arm's order. The result is for reading: SymPy
    computes with it as with any other expression.

    Args:
        expression: An expression of SymPy, or a matrix of them.

    Returns:
        An expression, or a matrix, of the same value.

    Raises:
        ArmError: `expression` is neither.

    Example:
        >>> q_1, q_2, q_3, a_2, a_3 = sp.symbols("q_1 q_2 q_3 a_2 a_3")
        >>> abbreviate((a_2 * sp.cos(q_2) + a_3 * sp.cos(q_2 + q_3)) * sp.cos(q_1))
        c_1*(a_2*c_2 + a_3*c_23)
    """
    require_expression(expression)
    abbreviated = expression.xreplace(short_names(expression))
    if isinstance(abbreviated, sp.MatrixBase):
        return abbreviated.applyfunc(_shorten_expression)
    return _shorten_expression(abbreviated)


def require_expression(expression: object) -> None:
    """Raise ArmError unless the argument is an expression of SymPy or a matrix of them."""
    if not isinstance(expression, sp.Basic | sp.MatrixBase):
        raise ArmError(
            f"expression is {shorten(expression)}; expected one of SymPy, or a matrix of them"
        )


def short_names(expression) -> dict[sp.Expr, sp.Symbol]:
    """Return a symbol such as c_23 for each cosine and sine of an expression or matrix."""
    indices = {f: _make_short_index(f.args[0]) for f in expression.atoms(sp.cos, sp.sin)}
    return {f: sp.Symbol(f"{f.func.__name__[0]}_{i}") for f, i in indices.items() if i}


def _make_short_index(angle: sp.Expr) -> str:
    """Return the index of a short name, such as ``23`` for q_2 + q_3.

    Where signs differ the index is in braces, such as ``{2-3+4}``. It is "" if the angle is no sum
    of joints 1 to 9, because c_12 could be joint 12 or joints 1 and 2.
    """
    terms = [term.as_coeff_Mul() for term in sp.Add.make_args(angle)]
    if not all(c in (1, -1) and re.fullmatch(r"q_\d", str(s)) for c, s in terms):
        return ""
    joints = sorted((str(s)[2:], "-" if c < 0 else "+") for c, s in terms)
    index = "".join(f"{sign}{joint}" for joint, sign in joints)
    return index.replace("+", "") if "-" not in index else f"{{{index.removeprefix('+')}}}"


# LaTeX


@lru_cache(maxsize=4096)
def formula_latex(formula: sp.Expr) -> str:
    """Write a formula in LaTeX, with plain parentheses, within which a line may be broken."""
    text = sp.latex(formula).replace(r"\left(", "(").replace(r"\right)", ")")
    return text.replace(" )", ")")


def visible_length(text: str) -> int:
    """Estimate how many characters of a LaTeX text a reader sees."""
    return len(re.sub(r"\\[a-z]+|[\s{}_^~]", "", text))


def break_lines(formula: sp.Expr, width: int) -> list[str]:
    """Write a formula in LaTeX, broken between terms into lines of `width` visible characters.

    Lines are not broken within braces or within parentheses of up to 60 characters.
    """
    text = formula_latex(formula)
    unbroken = re.sub(r"\([^()]{,60}\)", lambda bracket: bracket[0].replace(" ", "~"), text)
    lines = [""]
    for piece in re.split(r" (?=[+-] )", unbroken):
        in_braces = lines[-1].count("{") != lines[-1].count("}")
        if in_braces or visible_length(lines[-1] + piece) <= width:
            lines[-1] = f"{lines[-1]} {piece}".strip()
        else:
            lines.append(piece)
    return [line.replace("~", " ") for line in lines]


# Monomials


@cache
def _make_sort_key(atom: sp.Expr) -> SortKey:
    """Return the key by which atoms are sorted.

    Lengths and masses come first, sorted by the number in their index. Among them, names without
    an index lead and names such as l_pen close. Cosines and sines follow, sorted by their joints,
    and rates come last.
    """
    name = str(atom)
    if match := _SHORT_NAME.fullmatch(name):
        return _ANGLE, int(match[2][0]), match[2], match[1]
    if atom.has(sp.cos, sp.sin) or "dot" in name:
        return _ANGLE, _LAST_JOINT, "", name
    _, index, rest = name.partition("_")
    number = re.search(r"\d+", rest)
    return _LENGTH, int(number[0]) if number else _LAST_JOINT * bool(index), "", name


def _make_polynomial(expression: sp.Expr) -> Polynomial:
    """Return an expression as a dictionary from monomials to numbers."""
    if any(factor.has(sp.Add) for term in expression.args for factor in term.args):
        expression = sp.expand_mul(expression)
    polynomial: Polynomial = {}
    for term in sp.Add.make_args(expression):
        number, rest = term.as_coeff_Mul()
        factors = [_make_factor(f) for f in sp.Mul.make_args(rest) if f != 1]
        monomial = tuple(sorted(factors, key=_get_key_and_power))
        polynomial[monomial] = polynomial.get(monomial, sp.S.Zero) + number
    return {monomial: number for monomial, number in polynomial.items() if number}


def _make_factor(factor: sp.Expr) -> Factor:
    base, power = factor.as_base_exp()
    if power.is_Integer and power > 0:
        return _make_sort_key(base), int(power), base
    return _make_sort_key(factor), 1, factor


def _get_key_and_power(factor: Factor) -> tuple[SortKey, int]:
    return factor[:2]


# Common factors


class _Part(NamedTuple):
    """A part of a formula as it will be printed.

    Attributes:
        key: Key by which parts are sorted.
        symbols: Number of symbols in the part.
        has_minus: Whether a minus stands first.
        formula: The expression.
    """

    key: tuple
    symbols: int
    has_minus: bool
    formula: sp.Expr


def _shorten_expression(expression: sp.Expr) -> sp.Expr:
    """Return an expression in its short form.

    A product stays a product.
    """
    if isinstance(expression, sp.Add):
        return _make_sum_part(_make_sum_terms(_make_polynomial(expression))).formula
    number, rest = expression.as_coeff_Mul()
    parts = []
    for factor in sp.Mul.make_args(rest):
        base, power = factor.as_base_exp()
        if isinstance(base, sp.Add) and power.is_Integer and power > 0:
            sign, shared = _factor_out(_make_polynomial(base))
            number *= sign**power
            parts += [_make_power_part(part, power) for part in shared]
        elif factor != 1:
            parts.append(_make_atom_part(_make_factor(factor)))
    return _make_product_part(number, parts).formula


def _make_atom_part(factor: Factor) -> _Part:
    key, power, atom = factor
    return _Part((key[0], (key, power)), power, False, sp.Pow(atom, power))


def _make_power_part(part: _Part, power: sp.Integer) -> _Part:
    return part._replace(formula=sp.Pow(part.formula, power, evaluate=False)) if power > 1 else part


def _make_product_part(number: sp.Expr, parts: list[_Part]) -> _Part:
    """Multiply parts in the order of a textbook.

    The number comes first, then lengths, cosines and sines, and sums of both.
    """
    parts = sorted(parts, key=lambda part: part.key)
    factors = [part.formula for part in parts]
    if number != 1 or not parts:
        factors.insert(0, number)
    key = _join_keys(parts) if parts else ()
    symbols = sum(part.symbols for part in parts)
    return _Part(key, symbols, number < 0, Factors._from_args(factors))


def _join_keys(parts: Iterable[_Part]) -> tuple:
    """Join the sort keys of several parts.

    The key begins with the parts' common kind, or with _MIXED.
    """
    keys = [part.key for part in parts if part.key]
    kinds = {kind for kind, *_ in keys}
    return kinds.pop() if len(kinds) == 1 else _MIXED, *(k for _, *rest in keys for k in rest)


def _factor_out(poly: Polynomial) -> tuple[sp.Expr, list[_Part]]:
    """Return a sum as a number and its factors, none of which begins with a minus."""
    number = _get_leading_number(poly)
    powers = [{factor[::2]: factor[1] for factor in monomial} for monomial in poly]
    common = {key: min(p.get(key, 0) for p in powers) for key in powers[0]}
    rest = {
        tuple((p, more, a) for p, n, a in monomial if (more := n - common.get((p, a), 0))): value
        / number
        for monomial, value in poly.items()
    }
    parts = [_make_atom_part((key, n, atom)) for (key, atom), n in common.items() if n]
    if len(rest) == 1:
        return number, parts
    for pairs in (_factor_pairs(rest, *cut) for cut in _list_cuts(rest)):
        if len(pairs) == 1 and min(map(len, pairs[0])) > 1:
            (sign, first), (other, second) = map(_factor_out, pairs[0])
            return number * sign * other, [*parts, *first, *second]
    part = _make_sum_part(_group_terms(_freeze_polynomial(rest)))
    if part.has_minus:
        negated = {m: -n for m, n in rest.items()}
        number, part = -number, _make_sum_part(_group_terms(_freeze_polynomial(negated)))
    return number, [*parts, part]


def _make_sum_terms(poly: Polynomial) -> tuple[_Part, ...]:
    """Return a sum as a product if its terms have a common factor, else as its terms."""
    number, parts = _factor_out(poly)
    if len(poly) > 1 and len(parts) == 1 and abs(number) == 1:
        return _group_terms(_freeze_polynomial(poly))
    return (_make_product_part(number, parts),)


def _get_leading_number(poly: Polynomial) -> sp.Expr:
    """Return the sign of the first term, times the number before it if all terms share it."""
    sizes = {abs(number) for number in poly.values()}
    sign = sp.sign(poly[min(poly, key=_list_keys_and_powers)])
    return sign * sizes.pop() if len(sizes) == 1 else sign


def _list_keys_and_powers(monomial: Monomial) -> tuple:
    return tuple(map(_get_key_and_power, monomial))


def _freeze_polynomial(poly: Polynomial) -> frozenset:
    return frozenset(poly.items())


@lru_cache(maxsize=4096)
def _group_terms(items: frozenset) -> tuple[_Part, ...]:
    """Return the terms of a sum, grouped so that the fewest symbols are left.

    Args:
        items: The items of a `Polynomial`, frozen so that results can be cached.
    """
    poly = dict(items)
    groupings = [
        tuple(
            _make_product_part(n, [*map(_make_atom_part, monomial)]) for monomial, n in poly.items()
        )
    ]
    for cut, swapped in _list_cuts(poly):
        pairs = _factor_pairs(poly, cut, swapped)
        if 1 < len(pairs) < len(poly):
            groupings.append(tuple(term for pair in pairs for term in _multiply_sums(*pair)))
    return min(groupings, key=lambda terms: sum(term.symbols for term in terms))


def _list_cuts(poly: Polynomial) -> list[tuple[tuple[int, ...], bool]]:
    """Return the keys at which monomials are cut in two, and whether to group by the second half.

    If there are lengths and angles, the cut parts them. Else it parts the first joints from the
    later joints.
    """
    keys = {key for monomial in poly for key, *_ in monomial}
    kinds = {key[0] for key in keys}
    if len(kinds) == 2:
        return [((_ANGLE,), False), ((_ANGLE,), True)]
    joints = sorted({key[:2] for key in keys})
    return [(joint, False) for joint in joints[1:]]


def _factor_pairs(
    poly: Polynomial, cut: tuple[int, ...], swapped: bool
) -> list[tuple[Polynomial, Polynomial]]:
    """Write a sum as products of two sums.

    Each monomial is cut into two halves. Monomials are grouped by equal first halves, and then by
    equal sums of second halves.
    """
    second_sums: dict[Monomial, Polynomial] = {}
    for monomial, number in poly.items():
        first = tuple(factor for factor in monomial if (factor[0] < cut) != swapped)
        second = tuple(factor for factor in monomial if (factor[0] < cut) == swapped)
        second_sums.setdefault(first, {})[second] = number
    first_sums: dict[frozenset, Polynomial] = {}
    for first, second_sum in second_sums.items():
        number = _get_leading_number(second_sum)
        shared = _freeze_polynomial({half: n / number for half, n in second_sum.items()})
        first_sums.setdefault(shared, {})[first] = number
    return [(first_sum, dict(shared)) for shared, first_sum in first_sums.items()]


def _multiply_sums(first: Polynomial, second: Polynomial) -> tuple[_Part, ...]:
    """Return the product of two sums."""
    if [*first] == [()]:
        return _make_sum_terms({monomial: n * first[()] for monomial, n in second.items()})
    (number, parts), (other_number, other_parts) = _factor_out(first), _factor_out(second)
    return (_make_product_part(number * other_number, parts + other_parts),)


def _make_sum_part(terms: Iterable[_Part]) -> _Part:
    terms = sorted(terms, key=lambda part: part.key[1:])
    formula = Terms._from_args([part.formula for part in terms])
    symbols = sum(part.symbols for part in terms)
    return _Part(_join_keys(terms), symbols, terms[0].has_minus, formula)


__getattr__ = deprecated_names(__name__, short="abbreviate")
