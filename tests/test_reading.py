"""Formulas, grids and tables as people type and hold them, against what they were made from."""

import math

import numpy as np
import pytest

from helpers.inputs import ArmError
from helpers.reading import formula, grid, table
from tests import readings

NO_ROWS = "expected rows of four entries"
HELD = [
    ([], NO_ROWS),
    ([[]], NO_ROWS),
    ([[], []], NO_ROWS),
    ([{}], NO_ROWS),
    ([1, 2], NO_ROWS),
    (np.zeros(0), NO_ROWS),
    (np.zeros(4), NO_ROWS),
    ([[0, [1], 1, 2]], NO_ROWS),
    ([[[], [], [], []]] * 2, NO_ROWS),
    ([[[1, 0, 0, 0]] * 4, [1, 2, 3, 4]], NO_ROWS),
    ([[[1, 0, 0, 0]] * 3], NO_ROWS),
    ([[[1, 0, 0]] * 4], NO_ROWS),
    ({"a": [], "alpha": [], "d": [], "theta": []}, NO_ROWS),
    ({}, "the table is {}; expected"),
    ({"a1": 0, "size": 2}, "expected"),
    (5, "expected rows or text"),
    (None, "expected rows or text"),
    ([[0, 0, 0]], "rows have 3 entries"),
    ({"a": [1], "alpha": [0, 0], "d": [1, 2], "theta": [1, 2, 3]}, "lists have 1, 2, 3 entries"),
    ([[0, 0, 0, 0]] * 33, "33 rows; expected at most 32"),
    (np.zeros((33, 4, 4)), "33 rows; expected at most 32"),
]


@pytest.mark.parametrize(("held", "words"), HELD, ids=range(len(HELD)))
def test_what_is_held_and_no_table_is_refused_in_words(held, words):
    with pytest.raises(ArmError) as told:
        table.read(held)
    assert words in str(told.value)


@pytest.mark.parametrize("sign", "+-*/")
def test_a_formula_of_very_many_terms_has_its_value(sign):
    tree = formula.parse(sign.join(["q", *["1"] * 4000]))
    assert formula.symbols(tree) == {"q"}
    wanted = {"+": 4005, "-": -3995}.get(sign, 5)
    assert formula.value(tree, {"q": 5.0}.get) == wanted


@pytest.mark.parametrize("text", ["sin " * 61 + "x", "-" * 62 + "x", "2^" * 61 + "x", "(" * 61])
def test_a_formula_that_is_too_deep_is_refused(text):
    with pytest.raises(ArmError, match="expected one formula"):
        formula.parse(text)


def test_a_column_of_matlabs_and_heads_alone():
    assert grid.cells("[0.5;0.7;-0.4]") == [["0.5"], ["0.7"], ["-0.4"]]
    with pytest.raises(ArmError, match="the text is empty"):
        grid.cells("Columns 1 through 2")


# Tables and formulas made at random


@pytest.mark.parametrize("seed", range(10))
def test_tables_are_read_as_what_they_were_made_from(seed):
    rng = np.random.default_rng(seed)
    for _ in range(30):
        text, options, wanted, sure = readings.made(rng)
        read = table.read(text, **options)[: 1 if sure else None]
        found = [table.meant(one).rows for one in read]
        right = [
            [r.kind for r in rows] == [w[0] for w in wanted]
            and np.allclose([r[1:] for r in rows], [w[1:] for w in wanted], atol=2e-5)
            for rows in found
        ]
        assert any(right), (text, options)


@pytest.mark.parametrize("seed", range(5))
def test_formulas_have_the_values_that_they_were_made_with(seed):
    rng = np.random.default_rng(seed)
    for _ in range(60):
        text, wanted = readings.formula_of(rng)
        found = formula.value(formula.parse(text), {"x": 0.7, "q_1": 0.4}.get)
        assert found == pytest.approx(wanted, rel=1e-9, abs=1e-12), text


def test_right_angles_of_a_table_become_formulas_of_an_arm():
    quarters = "-3 * pi / 2", "-pi", "-pi/2", 0, "pi/2", "pi", "3 * pi / 2"
    for k, wanted in zip(range(-3, 4), quarters, strict=True):
        for near, told in ((0.9e-4, True), (-0.9e-4, True), (1.1e-4, False)):
            angle = k * math.pi / 2 + near
            row = table.Numbers("P", 0.1, angle, 0.2, -angle)
            [made] = table.Meant([row], (), 1.0, 1.0).as_rows()
            assert made.alpha == (wanted if told else pytest.approx(angle))
            assert made.joint.kind == "prismatic"
