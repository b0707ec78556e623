"""Show matrices and frames in a notebook as on the book's pages."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from helpers.formulas import abbreviate, break_lines, print_latex
from helpers.inputs import finite_array, require_type

__all__ = ["MarkdownOutput", "frames", "matrices"]

_LINE_WIDTH = 72  # characters that a reader sees


class MarkdownOutput:
    """Markdown text that a notebook typesets.

    Args:
        text: The text.
    """

    def __init__(self, text: str) -> None:
        self.text = text

    def _repr_markdown_(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return "<Markdown>"


def matrices(named: Mapping[str, object]) -> MarkdownOutput:
    """Show matrices beside each other, as many as a line holds, with their names.

    Args:
        named: For each name, in LaTeX, a matrix of SymPy or numbers of shape (m, n). Formulas are
            written as `symbolic.latex` does, long entries in several lines. Numbers are
            rounded to four decimals.

    Example:
        >>> print(matrices({"A_1": np.eye(2)}).text)
        ${A_1 = \\left[\\begin{matrix}1 & 0\\\\0 & 1\\end{matrix}\\right]\\quad}$
    """
    require_type(named, Mapping, "named")
    formulas = []
    for name, value in named.items():
        if isinstance(value, sp.MatrixBase):
            entries = [list(map(_entry_latex, row)) for row in abbreviate(value).tolist()]
        else:
            expected = "numbers (m, n), or a matrix of SymPy"
            array = finite_array(value, "a matrix", expected, (None, None))
            entries = [list(map(_number_text, row)) for row in array]
        rows = r"\\".join(map(" & ".join, entries))
        matrix = rf"\left[\begin{{matrix}}{rows}\end{{matrix}}\right]"
        formulas.append(rf"${{{name} = {matrix}\quad}}$")
    return MarkdownOutput("\n".join(formulas))


def frames(T: ArrayLike) -> MarkdownOutput:
    """Show frames as a table of their axes and origins, rounded to four decimals.

    Args:
        T: Frames, shape (k, 4, 4); the first is numbered 0.
    """
    T = finite_array(T, "T", "frames (k, 4, 4)", (None, 4, 4))
    header = "| $i$ | $x_i$ | $y_i$ | $z_i$ | $o_i$ (m) |\n|:-:|:-:|:-:|:-:|:-:|\n"
    rows = [[",\u202f".join(map(_number_text, column)) for column in frame[:3].T] for frame in T]
    table = [f"| {i} | {' | '.join(row)} |" for i, row in enumerate(rows)]
    return MarkdownOutput(header + "\n".join(table).replace("-", "−"))


def _entry_latex(entry: sp.Expr) -> str:
    """Write an entry of a matrix in LaTeX, and a long entry in several lines."""
    first, *rest = break_lines(entry, _LINE_WIDTH)
    if not rest:
        return print_latex(entry)
    # Each line is a group, because Temml reads a bracket after a line break as its argument.
    below = "".join(rf" \\ {{\quad {line}}}" for line in rest)
    return rf"\begin{{array}}{{l}}{{{first}}}{below}\end{{array}}"


def _number_text(value: float) -> str:
    return f"{np.round(value, 4) + 0.0:g}"
