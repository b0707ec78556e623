"""Write formulas as textbooks do.

c_23 stands for cos(q_2 + q_3), common factors are taken out of sums, and terms and factors are
written in the arm's order, from the base to the tip. `abbreviate` returns an expression of SymPy
like any other; the order is that of the printer, `latex`.

While factors are looked for, a sum is a dictionary from monomials to numbers, and a monomial is a
sorted tuple of (sort key, power, atom): lengths come before cosines and sines, and both are sorted
by their joints.
"""

import re
from functools import cache, lru_cache

import sympy as sp
from sympy.printing.latex import LatexPrinter

from helpers.inputs import ArmError, shorten, whole_number

SortKey = tuple[int, int, str, str]  # an atom's kind, joint, index and name
Factor = tuple[SortKey, int, sp.Expr]
Monomial = tuple[Factor, ...]
Polynomial = dict[Monomial, sp.Expr]

_SHORT_NAME = re.compile(r"([cs])_\{?(\d[\d+-]*)\}?")
_LENGTH, _ANGLE, _MIXED = range(3)
_LAST_JOINT = 10**6  # larger than any joint number, for atoms that are sorted last


def abbreviate(expression):
    """Write an expression, or each entry of a matrix, with short names and common factors.

    c_23 is cos(q_2 + q_3), s_1 is sin(q_1). Common factors such as d_6 + l_pen or c_1 are taken
    out. The result is an expression of SymPy like any other; `latex` prints it in the arm's order.

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


def latex(expression) -> str:
    """Write an expression, or a matrix, in LaTeX as textbooks do.

    It is abbreviated, and its terms and factors stand in the arm's order.

    Args:
        expression: An expression of SymPy, or a matrix of them.

    Raises:
        ArmError: `expression` is neither.

    Example:
        >>> q_2, d_1, a_2 = sp.symbols("q_2 d_1 a_2")
        >>> latex(a_2 * sp.sin(q_2) + d_1)
        'd_{1} + a_{2} s_{2}'
    """
    return print_latex(abbreviate(expression))


def latex_lines(expression: sp.Expr, width: int) -> list[str]:
    """Write an expression in LaTeX as textbooks do, in lines of about `width` characters.

    Example:
        >>> latex_lines(sp.sympify("d_1 + a_2*sin(q_2) + a_3*sin(q_2 + q_3)"), 8)
        ['d_{1} + a_{2} s_{2}', '+ a_{3} s_{23}']
    """
    return break_lines(abbreviate(expression), whole_number(width, "width"))


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


class _TextbookPrinter(LatexPrinter):
    """SymPy's printer of LaTeX, with terms and factors in the arm's order."""

    def __init__(self) -> None:
        super().__init__({"order": "none"})  # print a product in the order of its arguments

    def _as_ordered_terms(self, expr, order=None):
        return _sort_terms(expr)

    def _print_Mul(self, expr):
        number, factors = _split_number(expr)
        above, below = sp.fraction(sp.Mul(*factors), exact=True)
        top, bottom = (number.p, number.q) if number.is_Rational else (number, 1)
        text = self._print_product(abs(top), above)
        if bottom != 1 or below != 1:
            text = rf"\frac{{{text}}}{{{self._print_product(bottom, below)}}}"
        return f"- {text}" if number < 0 else text

    def _print_product(self, number, product):
        """Print a positive number and a product without denominators."""
        factors = sorted(sp.Mul.make_args(product), key=_get_sort_key)
        factors = [sp.sympify(number)] * (number != 1) + factors * (product != 1)
        if len(factors) < 2:
            return self._print(factors[0] if factors else sp.S.One)
        return super()._print_Mul(sp.Mul._from_args(factors))


def print_latex(formula) -> str:
    """Write a formula or a matrix in LaTeX in the arm's order, without abbreviating it."""
    return _TextbookPrinter().doprint(formula)


@lru_cache(maxsize=4096)
def formula_latex(formula: sp.Expr) -> str:
    """Write a formula in LaTeX with plain parentheses, inside which lines can be broken."""
    text = print_latex(formula).replace(r"\left(", "(").replace(r"\right)", ")")
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


# Order


@cache
def _make_sort_key(atom: sp.Expr) -> SortKey:
    """Return the sort key of an atom.

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


@lru_cache(maxsize=4096)
def _get_sort_key(part: sp.Expr) -> tuple:
    """Return the sort key of a term or factor: its kind, then the keys of its atoms.

    A number has the empty key.
    """
    base, power = part.as_base_exp()
    if isinstance(part, sp.Add):
        keys = [_get_sort_key(term) for term in _sort_terms(part)]
    elif isinstance(part, sp.Mul):
        keys = sorted(_get_sort_key(factor) for factor in _split_number(part)[1])
    elif isinstance(base, sp.Add) and power.is_Integer and power > 0:
        return _get_sort_key(base)
    elif part.is_Number:
        return ()
    else:
        key, number, _ = _make_factor(part)
        return key[0], (key, number)
    keys = [key for key in keys if key]
    kinds = {kind for kind, *_ in keys}
    return kinds.pop() if len(kinds) == 1 else _MIXED, *(k for _, *rest in keys for k in rest)


def _sort_terms(formula: sp.Expr) -> list[sp.Expr]:
    return sorted(sp.Add.make_args(formula), key=lambda term: _get_sort_key(term)[1:])


def _split_number(product: sp.Expr) -> tuple[sp.Expr, list[sp.Expr]]:
    """Return a product's number, and its other factors."""
    number, *factors = sp.Mul.make_args(product)
    return (number, factors) if number.is_Number else (sp.S.One, [number, *factors])


# Sums as dictionaries


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


def _shorten_expression(expression: sp.Expr) -> sp.Expr:
    """Return an expression in its short form.

    A product stays a product.
    """
    if isinstance(expression, sp.Add):
        return sp.Add(*_list_sum_terms(_make_polynomial(expression)))
    number, factors = _split_number(expression)
    shared = []
    for factor in factors:
        base, power = factor.as_base_exp()
        if isinstance(base, sp.Add) and power.is_Integer and power > 0:
            base_number, parts = _factor_out(_make_polynomial(base))
            number *= base_number**power
            shared += [part**power for part in parts]
        else:
            shared.append(factor)
    return _multiply(number, shared)


def _multiply(number: sp.Expr, factors: list[sp.Expr]) -> sp.Expr:
    """Multiply, without distributing a number over a sum."""
    product = sp.Mul(*factors)
    is_sum = isinstance(product, sp.Add) and number != 1
    return sp.Mul(number, product, evaluate=not is_sum)


def _factor_out(poly: Polynomial) -> tuple[sp.Expr, list[sp.Expr]]:
    """Return a sum as a number and its factors, of which no factor begins with a minus sign."""
    number = _get_leading_number(poly)
    powers = [{factor[::2]: factor[1] for factor in monomial} for monomial in poly]
    common = {key: min(p.get(key, 0) for p in powers) for key in powers[0]}
    others = {
        tuple((p, more, a) for p, n, a in monomial if (more := n - common.get((p, a), 0))): value
        / number
        for monomial, value in poly.items()
    }
    factors = [atom**n for (_, atom), n in common.items() if n]
    if len(others) == 1:
        return number, factors
    for pairs in (_factor_pairs(others, *cut) for cut in _list_cuts(others)):
        if len(pairs) == 1 and min(map(len, pairs[0])) > 1:
            (sign, first), (other, second) = map(_factor_out, pairs[0])
            return number * sign * other, [*factors, *first, *second]
    total = sp.Add(*_group_terms(_freeze_polynomial(others)))
    if _sort_terms(total)[0].could_extract_minus_sign():
        negated = {m: -n for m, n in others.items()}
        number, total = -number, sp.Add(*_group_terms(_freeze_polynomial(negated)))
    return number, [*factors, total]


def _list_sum_terms(poly: Polynomial) -> tuple[sp.Expr, ...]:
    """Return a sum as a single product if its terms have a common factor, otherwise as terms."""
    number, factors = _factor_out(poly)
    if len(poly) > 1 and len(factors) == 1 and abs(number) == 1:
        return _group_terms(_freeze_polynomial(poly))
    return (_multiply(number, factors),)


def _get_leading_number(poly: Polynomial) -> sp.Expr:
    """Return the sign of the first term, times the numeric factor that all terms share."""
    sizes = {abs(number) for number in poly.values()}
    sign = sp.sign(poly[min(poly, key=_list_keys_and_powers)])
    return sign * sizes.pop() if len(sizes) == 1 else sign


def _list_keys_and_powers(monomial: Monomial) -> tuple:
    return tuple(map(_get_key_and_power, monomial))


def _freeze_polynomial(poly: Polynomial) -> frozenset:
    return frozenset(poly.items())


@lru_cache(maxsize=4096)
def _group_terms(items: frozenset) -> tuple[sp.Expr, ...]:
    """Return the terms of a sum, grouped so that the fewest symbols are left.

    Args:
        items: The items of a `Polynomial`, frozen so that results can be cached.
    """
    poly = dict(items)
    groupings = [tuple(sp.Mul(n, *(atom**power for _, power, atom in m)) for m, n in poly.items())]
    for cut, swapped in _list_cuts(poly):
        pairs = _factor_pairs(poly, cut, swapped)
        if 1 < len(pairs) < len(poly):
            groupings.append(tuple(term for pair in pairs for term in _multiply_sums(*pair)))
    return min(groupings, key=lambda terms: sum(map(_count_symbols, terms)))


@lru_cache(maxsize=4096)
def _count_symbols(part: sp.Expr) -> int:
    """Count the symbols in a written formula; a square counts as two."""
    base, power = part.as_base_exp()
    if isinstance(base, sp.Add | sp.Mul):
        return sum(map(_count_symbols, base.args))
    if part.is_Number:
        return 0
    return int(power) if power.is_Integer and power > 0 else 1


def _list_cuts(poly: Polynomial) -> list[tuple[tuple[int, ...], bool]]:
    """Return the keys at which monomials are split, and whether to group by the second part.

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


def _multiply_sums(first: Polynomial, second: Polynomial) -> tuple[sp.Expr, ...]:
    """Return the product of two sums."""
    if [*first] == [()]:
        return _list_sum_terms({monomial: n * first[()] for monomial, n in second.items()})
    (number, factors), (other_number, other_factors) = _factor_out(first), _factor_out(second)
    return (_multiply(number * other_number, factors + other_factors),)
