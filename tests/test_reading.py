"""Formulas, grids and tables as people type and hold them, against what they were made from."""

import numpy as np
import pytest

from helpers.inputs import ArmError
from helpers.reading import formula, grid, table

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
