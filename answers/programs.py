"""Write an answer as a program for SymPy, NumPy or MATLAB, with SymPy's printers."""

import math
import re
import textwrap
from typing import NamedTuple

import sympy as sp
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.octave import OctaveCodePrinter
from sympy.printing.str import StrPrinter

from answers.content import Answer, AnswerSheet

_WIDTH = 96  # characters of a line
_IMPORTED = ("Matrix", "cos", "pi", "sin", "symbols")


class _Names:
    """Print symbols as valid names, such as ``c_2m3p4`` for ``c_{2-3+4}``."""

    def _print_Symbol(self, symbol):
        return symbol.name.translate({ord("{"): None, ord("}"): None, ord("-"): "m", ord("+"): "p"})


class _SymPy(_Names, StrPrinter): ...


class _NumPy(_Names, NumPyPrinter): ...


class _Octave(_Names, OctaveCodePrinter): ...


class _Language(NamedTuple):
    """Syntax of a language for formulas and matrices."""

    printer: type
    matrix_start: str
    row: str
    row_end: str
    matrix_end: str
    statement_end: str = ""
    continuation: str = ""  # end of a line that continues in the next line

    def format_formula(self, formula: sp.Expr) -> str:
        text = self.printer({"full_prec": False}).doprint(formula)
        return text.replace("numpy.", "np.")

    def format_assignment(self, answer: Answer) -> str:
        """Return the statement that assigns an answer to its name."""
        if answer.is_number:
            value = self.format_formula(answer.value[0])
            return self._wrap_line(f"{answer.name} = ({value}){self.statement_end}", "")
        rows = [
            ", ".join(map(self.format_formula, answer.value.row(i)))
            for i in range(answer.value.rows)
        ]
        row = self.row if answer.value.cols > 1 else "{}"
        body = [self._wrap_line(row.format(text) + self.row_end, "    ") for text in rows]
        return "\n".join(
            [f"{answer.name} = {self.matrix_start}", *body, self.matrix_end + self.statement_end]
        )

    def _wrap_line(self, text: str, indent: str) -> str:
        lines = textwrap.wrap(
            text,
            _WIDTH - len(self.continuation),
            initial_indent=indent,
            subsequent_indent=f"{indent}    ",
            break_long_words=False,
            break_on_hyphens=False,
        )
        return f"{self.continuation}\n".join(lines)

    def format_values(self, sheet: AnswerSheet, answer: Answer) -> list[str]:
        """Return the lines that assign a number to every symbol of an answer."""
        formulas = (answer.value, *answer.definitions.values())
        free = {symbol.name for formula in formulas for symbol in formula.free_symbols}
        home = zip(sheet.arm.variables, sheet.arm.home, strict=True)
        numbers = {name: make_exact_angle(value) for name, value in home}
        numbers |= {name: sp.Float(value) for name, value in sheet.symbol_values.items()}
        return [
            f"{n} = {self.format_formula(v)}{self.statement_end}"
            for n, v in numbers.items()
            if n in free
        ]

    def format_definitions(self, answer: Answer) -> list[str]:
        """Return the lines that assign cosines and sines to their short names."""
        pairs = answer.definitions.items()
        return [
            f"{self.format_formula(n)} = {self.format_formula(f)}{self.statement_end}"
            for n, f in pairs
        ]


_SYMPY = _Language(_SymPy, "Matrix([", "[{}]", ",", "])")
_NUMPY = _Language(_NumPy, "np.array([", "[{}]", ",", "])")
_MATLAB = _Language(_Octave, "[", "{}", ";", "]", ";", " ...")


def write_sympy(sheet: AnswerSheet, answer: Answer) -> str:
    """Write an answer for SymPy, with every quantity a symbol."""
    names = [line.split(" = ")[0] for line in _SYMPY.format_values(sheet, answer)]
    groups = [names[k : k + 8] for k in range(0, len(names), 8)]
    lines = [f'{", ".join(group)} = symbols("{" ".join(group)}")' for group in groups]
    body = "\n".join([*lines, *_SYMPY.format_definitions(answer), _SYMPY.format_assignment(answer)])
    used = [name for name in _IMPORTED if re.search(rf"\b{name}\b", body)]
    return "\n".join([f"from sympy import {', '.join(used)}", "", body])


def write_numpy(sheet: AnswerSheet, answer: Answer) -> str:
    """Write an answer for NumPy with the joint values of the home configuration."""
    lines = [
        "import numpy as np",
        "",
        *_NUMPY.format_values(sheet, answer),
        *_NUMPY.format_definitions(answer),
    ]
    shown = answer.name if answer.is_number else f"{answer.name}.round(4)"
    return "\n".join([*lines, _NUMPY.format_assignment(answer), f"print({shown})"])


def write_matlab(sheet: AnswerSheet, answer: Answer) -> str:
    """Write an answer for MATLAB or Octave with the joint values of the home configuration."""
    lines = [*_MATLAB.format_values(sheet, answer), *_MATLAB.format_definitions(answer)]
    return "\n".join([*lines, _MATLAB.format_assignment(answer)])


def make_exact_angle(value: float) -> sp.Expr:
    """Return a joint value, exact if it is a multiple of pi / 12."""
    part = sp.Rational(round(value / math.pi * 12), 12)
    near = abs(float(part) * math.pi - value) < 1e-12
    return part * sp.pi if near else sp.Float(f"{value:.12g}")
