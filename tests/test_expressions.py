"""Test table entries: valid formulas are read right, and all other text is rejected."""

import re
from fractions import Fraction
from functools import partial

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from helpers.expressions import ArmError, check_entry, entry_latex, evaluate_entry, symbol_names
from tests import reading
from tests.cases import ENTRIES
from tests.node import needs_node

VALUES = {"a_3": 0.0825, "l_pen": 0.1, "b": -2.0}

_NUMBERS = st.integers(0, 9).map(lambda n: (str(n), float(n)))
_LEAVES = st.one_of(
    _NUMBERS,
    st.sampled_from([*VALUES.items(), ("pi", np.pi)]),
    st.just(("0.25", 0.25)),
    st.just(("1e-3", 1e-3)),
)
_SIGNS = {"+": np.add, "-": np.subtract, "*": np.multiply}


def _join_formulas(parts):
    sign, (left, x), (right, y) = parts
    return f"({left}) {sign} ({right})", float(_SIGNS[sign](x, y))


# Random formulas with their values; each step adds an operator to the text and computes the value.
formulas = st.recursive(
    _LEAVES,
    lambda smaller: st.one_of(
        st.tuples(st.sampled_from(sorted(_SIGNS)), smaller, smaller).map(_join_formulas),
        smaller.map(lambda part: (f"-({part[0]})", -part[1])),
        st.tuples(smaller, st.integers(1, 7)).map(
            lambda parts: (f"({parts[0][0]}) / {parts[1]}", parts[0][1] / parts[1])
        ),
    ),
    max_leaves=8,
)


@given(formulas)
def test_formula_evaluates_to_its_value(formula):
    text, value = formula
    assert evaluate_entry(check_entry(text, "a"), VALUES) == pytest.approx(
        value, rel=1e-12, abs=1e-12
    )


# helpers/expressions.py reads plain formulas itself; the page reads all of them by
# judge/reading/formula.js. Most of these texts are formulas; in the others a bracket is not closed,
# or an operand or operator is missing.
_OPERANDS = st.sampled_from(
    ["0", "2", "12", "0.25", ".5", "5.", "1e-3", "pi", *VALUES, "", "1.2.3"]
)
_PARTS = st.tuples(
    st.sampled_from(["", "", "-", "+", "(", "-(", " +(", "((", "--"]),
    st.one_of(_OPERANDS, _OPERANDS.filter(len)),
    st.sampled_from(["", "", ")", ") ", "))"]),
    st.sampled_from([*"+-*/", " - ", " / ", "", " "]),
)


def _join_parts(parts):
    """Return a text whose last operator is left out and whose brackets are mostly closed."""
    text = "".join("".join(part) for part in parts).rstrip("+-*/ ")
    return text + ")" * (text.count("(") - text.count(")"))


# The judge also reads powers and products without a sign, which are refused in a table's entry.
_ONLY_ON_PAGE = re.compile(r"\*\*|[\w.)]\s*\(|\)\s*[\w.]|[\w.]\s+[\w.]|\d[A-Za-z]|\w\.\d*[A-Za-z]")


def _evaluate_or_none(evaluate_text, text):
    try:
        return evaluate_text(text)
    except ArmError:
        return None


@needs_node
@given(st.lists(_PARTS, min_size=1, max_size=5).map(_join_parts))
def test_python_and_page_read_formulas_alike(text):
    here = _evaluate_or_none(lambda x: evaluate_entry(check_entry(x, "the entry"), VALUES), text)
    page = _evaluate_or_none(lambda x: reading.read_formula(x, **VALUES)["value"], text)
    if here is not None or not _ONLY_ON_PAGE.search(text):
        assert here == (None if page is None else pytest.approx(page, rel=1e-12, abs=1e-12)), text


def test_operators_follow_arithmetic_precedence():
    assert evaluate_entry("2 - 3 - 4", {}) == -5
    assert evaluate_entry("12 / 3 / 2", {}) == 2
    assert evaluate_entry("1 + 2 * 3", {}) == 7
    assert evaluate_entry("-(d_7 + l_pen) / 2", {"d_7": 0.1, "l_pen": 0.3}) == pytest.approx(-0.2)
    assert evaluate_entry("2*pi - +1", {}) == pytest.approx(2 * np.pi - 1)


def test_names_returns_symbols_but_not_pi():
    assert symbol_names("a_3 + pi*b - 2") == {"a_3", "b"}
    assert symbol_names("pi / 2") == symbol_names(0.5) == frozenset()


def test_entry_accepts_numbers_of_other_packages():
    assert check_entry(-sp.pi / 2, "alpha") == "-pi/2"
    assert check_entry(np.float64(0.25), "a") == 0.25
    assert type(check_entry(np.float64(0.25), "a")) is float
    assert evaluate_entry(check_entry(np.float32(0.5), "a"), {}) == 0.5
    assert evaluate_entry(check_entry(Fraction(1, 4), "a"), {}) == 0.25
    assert check_entry(2, "a") == 2
    assert type(check_entry(2, "a")) is int


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("-(d_7 + l_pen)", "-(d_{7} + l_{pen})"),
        ("2*pi/3", "2\\,\\pi/3"),
        ("pipe_2", "pipe_{2}"),
        (0.25, "0.25"),
        (-0.0, "-0"),
    ],
)
def test_latex_of_entry(text, expected):
    assert entry_latex(text) == expected


NOT_FORMULAS = (
    "", "a +", "(a", "a b", "a**2", "a // 2", "a % 2", "a, b", "[a]", "'a'", "a = 1",
    "a < b", "a if b else c",
    "lambda: 1", "f(1)", "a.b", "a[0]", "True", "None", "1e999", "__import__('os')",
    "().__class__", "a; b", "a\nb",
    "a\0", "not a", "a and b", "(a := 1)", "f'{a}'", "ä_1",
)  # fmt: skip


# Numbers as ids, because pytest cannot select a test whose name contains an escaped line break or
# NUL.
@pytest.mark.parametrize("text", NOT_FORMULAS, ids=range(len(NOT_FORMULAS)))
def test_invalid_formula_is_rejected(text):
    with pytest.raises(ArmError, match="expected numbers, symbols, pi and"):
        check_entry(text, "alpha")


def test_overlong_formula_is_rejected():
    assert evaluate_entry("-" * 198 + "1", {}) == 1
    with pytest.raises(ArmError, match="a has 100001 characters; expected at most 200"):
        check_entry("-" * 100_000 + "1", "a")


@pytest.mark.parametrize("value", [None, True, np.nan, np.inf, 10**400])
def test_non_finite_number_is_rejected(value):
    for ask in (partial(check_entry, value, "d"), partial(entry_latex, value)):
        with pytest.raises(ArmError, match=r"expected a (finite )?number or a formula"):
            ask()
    with pytest.raises(ArmError, match="1/0 divides by zero or is too large; expected a finite"):
        evaluate_entry("1/0", {})


def test_missing_value_is_named():
    with pytest.raises(ArmError, match="no value for b; there are a_3, pi"):
        evaluate_entry("a_3 + b", {"a_3": 1})


IN_SI = [case for case in ENTRIES if case["unit"] in ("rad", "m")]


@pytest.mark.parametrize("case", IN_SI, ids=lambda case: case["text"][:12])
def test_entry_agrees_with_explorer_or_is_refused(case):
    """The explorer reads the same texts, and also units, functions and decimal commas."""
    here = _evaluate_or_none(lambda x: evaluate_entry(check_entry(x, "a"), {}), case["text"])
    if here is not None:
        assert case["value"] == pytest.approx(here, rel=1e-14)


def test_entry_with_hyphen_or_pi_of_print_is_plain():
    assert check_entry("−π/2", "alpha") == "-pi/2"
