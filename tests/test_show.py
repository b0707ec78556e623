"""Test how pages show matrices and frames."""

import numpy as np
import pytest
import sympy as sp

from answers import typeset
from helpers import show
from helpers.arm import ArmError


def test_matrices_are_shown_with_their_names():
    q = sp.Symbol("q_1")
    shown = show.matrices({"A_1": sp.Matrix([[sp.cos(q), 0]]), "T": np.array([[0.12344, -1e-17]])})
    first, second = shown._repr_markdown_().splitlines()
    assert first.startswith(r"${A_1 = \left[\begin{matrix}c_{1} & 0\end{matrix}\right]")
    assert r"0.1234 & 0\end{matrix}" in second
    assert all(line.endswith(r"\quad}$") for line in (first, second))
    lengths = sp.Add(*sp.symbols("a_1001:1017"))
    long = show.matrices({"J": sp.Matrix([lengths, q])})._repr_markdown_()
    entry, rest = long.split(r"\begin{array}{l}")[1].split(r"\end{array}\\")
    assert (rest[:5], entry.count("a_"), entry.count(r"\\")) == ("q_{1}", 16, 1)  # two lines


def test_long_bracket_is_broken_into_lines():
    symbols = sp.symbols("a_1001:1017")
    entry = symbols[0] * sp.Add(*symbols[1:])
    made = typeset.convert_to_mathml(
        show.matrices({"J": sp.Matrix([entry])})._repr_markdown_().strip("$")
    )
    assert made.count("<mtr>") == 3  # one row of the matrix, in two lines
    assert "linebreak" not in made


def test_frames_are_listed_by_columns():
    T = np.eye(4)
    T[:3, :] = [[0, 0, -1, 0.5], [0, 1, 0, 0], [1, 0, 0, 0.81954]]
    text = show.frames([np.eye(4), T])._repr_markdown_()
    last = text.splitlines()[-1].replace("\u202f", " ")  # no column has a line break
    assert last == "| 1 | 0, 0, 1 | 0, 1, 0 | −1, 0, 0 | 0.5, 0, 0.8195 |"


def test_invalid_matrices_and_frames_are_rejected():
    for given in ("A", {"A": 1}, {"A": "x"}):
        with pytest.raises(ArmError):
            show.matrices(given)
    with pytest.raises(ArmError, match="frames"):
        show.frames(np.eye(3))
