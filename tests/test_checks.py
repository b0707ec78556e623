"""Test `check`: it prints a line if the values agree and raises if they differ."""

import numpy as np
import pytest
import sympy as sp

from helpers.checks import check


def test_check_prints_one_line_if_equal(capsys):
    check("the tip (m)", [1.0, 2.0], [1.0, 2.0 + 1e-13], tolerance=1e-12)
    check("rank", np.linalg.matrix_rank(np.eye(3)), 3)
    check("formula", sp.Matrix([sp.Symbol("x")]), sp.Matrix([sp.Symbol("x")]))
    check("lists of unequal lengths", [[1], [1, 2]], [[1], [1, 2]])
    check("no solutions", np.zeros((0, 3)), np.zeros((0, 3)))
    check("words", ["front", "back"], np.array(["front", "back"]), tolerance=1)
    check("within", [True, 2, np.float32(0.5)], [0.75, 2, 0.5], tolerance=0.25)
    lines = [
        "✔ the tip (m) (within 1e-12)",
        "✔ rank",
        "✔ formula",
        "✔ lists of unequal lengths",
        "✔ no solutions",
        "✔ words",
        "✔ within (within 0.25)",
    ]
    assert capsys.readouterr().out.splitlines() == lines


@pytest.mark.parametrize(
    ("actual", "expected", "tolerance", "words"),
    [
        (1.0, 1.1, 0.05, "the thing: off by 0.1, allowed 0.05"),
        ([1, 2], [1, 3], 0, "off by 1, allowed 0"),
        ([1, 2], [1, 2, 3], 1, r"shape \(2,\), expected \(3,\)"),
        (np.nan, np.nan, 1, "off by nan"),
        (1.0, np.nan, 1, "off by nan"),
        (np.inf, 1.0, 1, "off by inf"),
        (True, False, 0, "got True, expected False"),
        (np.uint8(1), np.uint8(2), 0, "off by 1, allowed 0"),
        (False, True, 0, "got False, expected True"),
        (np.array([True, False]), [True, True], 0, "expected .True, True."),
        (np.array([True, False], object), [True, True], 0, "expected .True, True."),
        (1j, 2j, 5, "got 1j, expected 2j"),
        (1, "1", 5, "got 1, expected 1"),
        ("1", 1, 5, "got 1, expected 1"),
        (1 / 3, 0, 0.25, "^the thing: off by 0.333, allowed 0.25$"),
        ("left", "right", 0, "got left, expected right"),
        (np.array(["front", "back"]), ["front", "front"], 0, "expected"),
        (np.array(["front", "back"]), ["front"], 0, "expected"),
        (sp.Matrix([1, 2]), sp.Matrix([2, 1]), 0, "got Matrix"),
    ],
)
def test_check_raises_if_different(actual, expected, tolerance, words):
    with pytest.raises(AssertionError, match=words):
        check("the thing", actual, expected, tolerance)


def test_book_only_check_prints_but_does_not_raise(capsys):
    check("the tip (m)", 0.679, 0.6735, tolerance=0.001, book_only=True)
    check("the tip (m)", 0.679, 0.679, tolerance=0.001, book_only=True)
    check("the arm", "mine", "the book's", book_only=True)
    check("the ways", [1, 2], [1, 2, 3], book_only=True)
    assert capsys.readouterr().out.splitlines() == [
        "○ the tip (m): off by 0.0055, allowed 0.001; it holds for the book's own numbers only",
        "✔ the tip (m) (within 0.001)",
        "○ the arm: got mine, expected the book's; it holds for the book's own numbers only",
        "○ the ways: shape (2,), expected (3,); it holds for the book's own numbers only",
    ]
