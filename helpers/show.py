"""Matrices and frames as a page shows them: to look at, and to lay beside one's own."""

from collections.abc import Mapping

import numpy as np
import sympy as sp
from numpy.typing import ArrayLike

from helpers.formulas import lines, short
from helpers.inputs import must_be, numbers

__all__ = ["Shown", "frames", "matrices"]

_ROOM = 72  # letters and signs of a line


class Shown:
    """Markdown that a notebook typesets."""

    def __init__(self, text: str) -> None:
        self.text = text

    def _repr_markdown_(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return "<Markdown>"


def matrices(named: Mapping[str, object]) -> Shown:
    """Matrices beside each other, as many as a line holds, under their names in LaTeX.

    Those of SymPy are written short, as `symbolic.short` does, a long entry in several lines;
    numbers, shape (m, n), are rounded to four decimals.
    """
    must_be(named, Mapping, "named")
    formulas = [rf"${{{name} = {_latex(value)}\quad}}$" for name, value in named.items()]
    return Shown("\n".join(formulas))


def frames(T: ArrayLike) -> Shown:
    """Frames, shape (k, 4, 4), as a table of their axes and origins, rounded to four decimals; the
    first is frame 0."""
    T = numbers(T, "T", "frames (k, 4, 4)", (None, 4, 4))
    head = "| $i$ | $x_i$ | $y_i$ | $z_i$ | $o_i$ (m) |\n|:-:|:-:|:-:|:-:|:-:|\n"
    rows = [[",\u202f".join(map(_number, column)) for column in frame[:3].T] for frame in T]
    table = [f"| {i} | {' | '.join(row)} |" for i, row in enumerate(rows)]
    return Shown(head + "\n".join(table).replace("-", "−"))


def _latex(value: object) -> str:
    if isinstance(value, sp.MatrixBase):
        entries = [list(map(_entry, row)) for row in short(value).tolist()]
    else:
        array = numbers(value, "a matrix", "numbers (m, n), or a matrix of SymPy", (None, None))
        entries = [list(map(_number, row)) for row in array]
    rows = r"\\".join(map(" & ".join, entries))
    return rf"\left[\begin{{matrix}}{rows}\end{{matrix}}\right]"


def _entry(entry: sp.Expr) -> str:
    first, *rest = lines(entry, _ROOM)
    if not rest:
        return sp.latex(entry)
    # A line is a group: Temml would take a bracket, and the line's end in it, for one thing.
    below = "".join(rf" \\ {{\quad {line}}}" for line in rest)
    return rf"\begin{{array}}{{l}}{{{first}}}{below}\end{{array}}"


def _number(value: float) -> str:
    return f"{np.round(value, 4) + 0.0:g}"
