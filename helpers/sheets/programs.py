"""An answer as a block that can be pasted as it is: into a LaTeX document, into Python with SymPy
or NumPy, into MATLAB.
"""

import math
from collections.abc import Iterable

import sympy as sp

from helpers.sheets.content import Item, Sheet
from helpers.sheets.formulas import (
    LATEX,
    MATLAB,
    NUMPY,
    SYMPY,
    Language,
    code_name,
    latex_name,
    pieces,
    written,
)

_WIDTH = 96  # characters of a line in a program
_SHOWN = 50  # characters that a line of a typeset formula shows on a page 12 cm wide
_ROW = 56  # characters of a row, of each column's widest entry, with which a matrix stays one


def as_latex(sheet: Sheet, item: Item) -> str:
    """A display for a document that uses amsmath; what c_{23} and the like mean stands above it as
    comments.
    """
    value, (_, _, short) = sheet.shortened(item), sheet.used(item)
    legend = [f"% ${latex_name(n.name)} = {written(f, LATEX)}$" for n, f in short]
    entries = [[pieces(e, LATEX) for e in value.row(i)] for i in range(value.rows)]
    columns = zip(*entries, strict=True)
    width = sum(max(_seen(" ".join(entry)) for entry in column) + 2 for column in columns)
    if not item.is_number and width <= _ROW and value.cols <= 10:
        return "\n".join([*legend, rf"\[ {latex_title(item)} =", *_bmatrix(entries), r"\]"])
    lines = [line for row in _labelled(item, entries) for line in _broken(*row)]
    body = " \\\\\n".join(lines)
    return "\n".join([*legend, "{\\allowdisplaybreaks", "\\begin{align*}", body, "\\end{align*}}"])


def latex_title(item: Item) -> str:
    """An answer's name as books write it."""
    letter, _, index = item.name.partition("_")
    plain = {"J": "J", "det": r"\det J", "P": "P", "G": "g(q)"}
    if letter in plain:
        return plain[letter]
    return f"{{}}^{{0}}T_{{{index[1:]}}}" if letter == "T" else f"{letter}_{{{index}}}"


def _bmatrix(entries: list[list[list[str]]]) -> list[str]:
    rows = [" & ".join(" ".join(e) for e in row) for row in entries]
    return ["\\begin{bmatrix}", " \\\\\n".join(rows), "\\end{bmatrix}"]


def _labelled(item: Item, entries: list[list[list[str]]]) -> Iterable[tuple[str, list[str]]]:
    """Each entry with its name: by row and column, by component, or the number's own."""
    title = latex_title(item)
    name = title if item.name == "J" else "g" if item.name == "G" else f"({title})"
    for i, row in enumerate(entries, 1):
        for k, entry in enumerate(row, 1):
            if item.is_number:
                yield title, entry
            elif item.is_matrix:
                yield f"{name}_{{{i}{k}}}", entry
            else:
                yield f"{name}_{{{component(item, i)}}}", entry


def component(item: Item, i: int) -> str:
    """The name of a vector's i-th entry: x, y, z of a point or direction, else its number."""
    return str(i) if item.name == "G" else "xyz"[i - 1]


def _broken(label: str, entry: list[str]) -> list[str]:
    """A labelled formula for align*, broken between terms into lines of a page's width."""
    lines, line = [], ""
    for piece in entry:
        if line and _seen(f"{line} {piece}") > _SHOWN:
            lines.append(line)
            line = piece
        else:
            line = f"{line} {piece}" if line else piece
    first, *rest = [*lines, line]
    return [f"{label} &= {first}", *(f"&\\quad {more}" for more in rest)]


def _seen(text: str) -> int:
    """About how many characters of LaTeX are seen on the page."""
    for unseen in ("_", "{", "}", "\\mathrm", "\\", " ", "^"):
        text = text.replace(unseen, "")
    return len(text)


def as_sympy(sheet: Sheet, item: Item) -> str:
    """A block for Python with SymPy, everything a symbol."""
    joints, letters, short = sheet.used(item)
    names = [code_name(name) for name in (*joints, *letters)]
    lines = ["import sympy as sp", ""]
    if names:
        lines += _symbols(names)
    lines += [f"{code_name(n.name)} = {written(f, SYMPY)}" for n, f in short]
    body = _python_body(sheet, item, SYMPY, "sp.Matrix")
    return "\n".join([*lines, *body])


def as_numpy(sheet: Sheet, item: Item) -> str:
    """A block for Python with NumPy, at the home pose; other joint values can be put in."""
    body = _python_body(sheet, item, NUMPY, "np.array")
    shown = f"print({item.name})" if item.is_number else f"print({item.name}.round(4))"
    return "\n".join(["import numpy as np", "", *_given(sheet, item, NUMPY), *body, shown])


def as_matlab(sheet: Sheet, item: Item) -> str:
    """A block for MATLAB or Octave, at the home pose; other joint values can be put in."""
    value, lines = sheet.shortened(item), _given(sheet, item, MATLAB, ";")
    if item.is_number:
        parts = [f"{item.name} =", *pieces(value[0, 0], MATLAB)]
        return "\n".join([*lines, *_filled(parts, "", " ...")])
    rows = []
    for i in range(value.rows):
        entries = [_grouped(pieces(entry, MATLAB)) for entry in value.row(i)]
        rows += _filled(_separated(entries, ",", ";"), "    ", " ...")
    return "\n".join([*lines, f"{item.name} = [", *rows, "]"])


def _given(sheet: Sheet, item: Item, language: Language, end: str = "") -> list[str]:
    """The lines that give every letter its number, and every cosine and sine its short name."""
    joints, letters, short = sheet.used(item)
    home = dict(zip(sheet.arm.variables, sheet.arm.home, strict=True))
    numbers = {name: angle(home[name], language) for name in joints}
    numbers |= {name: f"{sheet.values[name]:.12g}" for name in letters}
    functions = {n.name: written(f, language) for n, f in short}
    return [f"{code_name(n)} = {text}{end}" for n, text in (numbers | functions).items()]


def angle(value: float, language: Language) -> str:
    """A joint value, written with pi where it is a simple part of it."""
    part = sp.Rational(round(value / math.pi * 12), 12)
    if value and abs(float(part) * math.pi - value) < 1e-12:
        return written(part * sp.pi, language)
    return f"{value:.12g}"


def _python_body(sheet: Sheet, item: Item, language: Language, array: str) -> list[str]:
    value = sheet.shortened(item)
    if item.is_number:
        return [f"{item.name} = (", *_filled(pieces(value[0, 0], language), "    "), ")"]
    rows = []
    for i in range(value.rows):
        texts = _separated([pieces(entry, language) for entry in value.row(i)], ",", ",")
        if item.is_matrix:
            texts[0], texts[-1] = f"[{texts[0]}", f"{texts[-1][:-1]}],"
        rows += _filled(texts, "    ")
    return [f"{item.name} = {array}([", *rows, "])"]


def _symbols(names: list[str]) -> list[str]:
    """The lines that make the symbols, some a line."""
    groups = [names[k : k + 8] for k in range(0, len(names), 8)]
    return [f'{", ".join(group)} = sp.symbols("{" ".join(group)}")' for group in groups]


def _grouped(entry: list[str]) -> list[str]:
    """An entry of a MATLAB matrix, where a space may begin another: sums stand in parentheses."""
    if len(entry) == 1:
        return entry
    return [f"({entry[0]}", *entry[1:-1], f"{entry[-1]})"]


def _separated(entries: list[list[str]], between: str, end: str) -> list[str]:
    """The pieces of a row's entries, a sign after each entry and another at the row's end."""
    marked = [[*entry[:-1], entry[-1] + between] for entry in entries]
    marked[-1][-1] = entries[-1][-1] + end
    return [piece for entry in marked for piece in entry]


def _filled(parts: Iterable[str], indent: str, continued: str = "") -> list[str]:
    """Pieces filled into lines; `continued` ends each line that another one follows."""
    lines, line = [], ""
    for part in parts:
        longer = f"{line} {part}" if line else indent + part
        if line and len(longer) + len(continued) > _WIDTH:
            lines.append(line + continued)
            longer = indent + ("    " if continued else "") + part
        line = longer
    return [*lines, line]
