"""An answer as a block that can be pasted as it is: into Python with SymPy or NumPy, into MATLAB.
SymPy's printers write the formulas.
"""

import math
import re
import textwrap
from typing import NamedTuple

import sympy as sp
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.octave import OctaveCodePrinter
from sympy.printing.str import StrPrinter

from answers.content import Item, Sheet

_WIDTH = 96  # characters of a line
_IMPORTED = ("Matrix", "cos", "pi", "sin", "sqrt", "symbols")


class _Names:
    """Letters as a program can have them: ``c_2m3p4`` for ``c_{2-3+4}``."""

    def _print_Symbol(self, symbol):
        return symbol.name.translate({ord("{"): None, ord("}"): None, ord("-"): "m", ord("+"): "p"})


class _SymPy(_Names, StrPrinter): ...


class _NumPy(_Names, NumPyPrinter): ...


class _Octave(_Names, OctaveCodePrinter): ...


class _Language(NamedTuple):
    """How a program writes formulas, and a matrix of them."""

    printer: type
    start: str  # of a matrix
    row: str
    between: str  # two rows
    end: str
    statement: str = ""  # what ends one
    continued: str = ""  # what ends a line that goes on

    def written(self, formula: sp.Expr) -> str:
        text = self.printer({"full_prec": False}).doprint(formula)
        return text.replace("numpy.", "np.")

    def assigned(self, item: Item) -> str:
        """The statement that gives an answer its name."""
        if item.is_number:
            value = self.written(item.value[0])
            return self._filled(f"{item.name} = ({value}){self.statement}", "")
        rows = [", ".join(map(self.written, item.value.row(i))) for i in range(item.value.rows)]
        row = self.row if item.value.cols > 1 else "{}"
        body = [self._filled(row.format(text) + self.between, "    ") for text in rows]
        return "\n".join([f"{item.name} = {self.start}", *body, self.end + self.statement])

    def _filled(self, text: str, indent: str) -> str:
        lines = textwrap.wrap(
            text,
            _WIDTH - len(self.continued),
            initial_indent=indent,
            subsequent_indent=f"{indent}    ",
            break_long_words=False,
            break_on_hyphens=False,
        )
        return f"{self.continued}\n".join(lines)

    def given(self, sheet: Sheet, item: Item) -> list[str]:
        """The lines that give every letter its number, and every cosine and sine its short name."""
        free = {symbol.name for symbol in item.value.xreplace(item.letters).free_symbols}
        home = zip(sheet.arm.variables, sheet.arm.home, strict=True)
        numbers = {name: angle(value) for name, value in home}
        numbers |= {name: sp.Float(value) for name, value in sheet.values.items()}
        return [f"{n} = {self.written(v)}{self.statement}" for n, v in numbers.items() if n in free]

    def shortened(self, item: Item) -> list[str]:
        """The lines that give cosines and sines their short names."""
        pairs = item.letters.items()
        return [f"{self.written(n)} = {self.written(f)}{self.statement}" for n, f in pairs]


_SYMPY = _Language(_SymPy, "Matrix([", "[{}]", ",", "])")
_NUMPY = _Language(_NumPy, "np.array([", "[{}]", ",", "])")
_MATLAB = _Language(_Octave, "[", "{}", ";", "]", ";", " ...")


def as_sympy(sheet: Sheet, item: Item) -> str:
    """A block for Python with SymPy, everything a symbol."""
    names = [line.split(" = ")[0] for line in _SYMPY.given(sheet, item)]
    groups = [names[k : k + 8] for k in range(0, len(names), 8)]
    lines = [f'{", ".join(group)} = symbols("{" ".join(group)}")' for group in groups]
    body = "\n".join([*lines, *_SYMPY.shortened(item), _SYMPY.assigned(item)])
    used = [name for name in _IMPORTED if re.search(rf"\b{name}\b", body)]
    return "\n".join([f"from sympy import {', '.join(used)}", "", body])


def as_numpy(sheet: Sheet, item: Item) -> str:
    """A block for Python with NumPy, at the home pose; other joint values can be put in."""
    lines = ["import numpy as np", "", *_NUMPY.given(sheet, item), *_NUMPY.shortened(item)]
    shown = item.name if item.is_number else f"{item.name}.round(4)"
    return "\n".join([*lines, _NUMPY.assigned(item), f"print({shown})"])


def as_matlab(sheet: Sheet, item: Item) -> str:
    """A block for MATLAB or Octave, at the home pose; other joint values can be put in."""
    lines = [*_MATLAB.given(sheet, item), *_MATLAB.shortened(item)]
    return "\n".join([*lines, _MATLAB.assigned(item)])


def angle(value: float) -> sp.Expr:
    """A joint value, exact where it is a simple part of pi."""
    part = sp.Rational(round(value / math.pi * 12), 12)
    near = abs(float(part) * math.pi - value) < 1e-12
    return part * sp.pi if near else sp.Float(f"{value:.12g}")
