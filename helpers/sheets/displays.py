"""An answer in TeX, as a page shows it and a LaTeX document takes it: a matrix as a matrix, with
names for its long entries, which are written out below. No line is wider than a page.
"""

import sympy as sp

from helpers.formulas import lines, seen, tex
from helpers.sheets.content import Array, Item, Sheet

_WIDTH = 56  # letters and signs of a line
_HEIGHT = 16  # lines of a display
_SHORT = 3  # of an entry's name


def name(item: Item) -> str:
    """An answer's name as books write it."""
    letter, _, index = item.name.partition("_")
    named = {"J": "J", "det": r"\det J", "P": "P", "G": "g(q)"}
    if letter in named:
        return named[letter]
    return f"{{}}^{{0}}T_{{{index[1:]}}}" if letter == "T" else f"{letter}_{{{index}}}"


def symbols(sheet: Sheet, item: Item) -> list[str]:
    """An answer in symbols, a display each."""
    value, names = item.value, _entry_names(sheet, item)
    if not item.is_number and _width(value) <= _WIDTH:
        return [f"{name(item)} = {sp.latex(value)}"]
    if value.cols == 1:
        return _aligned([*zip(names, value, strict=True)])
    cut, long = _cut(value, names)
    by_columns = sorted(long, key=lambda k: k % value.cols)
    return [
        f"{name(item)} = {sp.latex(cut)}",
        *_aligned([(names[k], value[k]) for k in by_columns]),
    ]


def _aligned(formulas: list[tuple[str, sp.Expr]]) -> list[str]:
    """Named formulas below each other, some lines a display."""
    displays: list[list[str]] = []
    for label, formula in formulas:
        first, *rest = lines(formula, _WIDTH)
        named = [f"{label} &= {first}", *(f"&\\quad {line}" for line in rest)]
        if displays and len(displays[-1]) + len(named) <= _HEIGHT:
            displays[-1] += named
        else:
            displays.append(named)
    joined = (" \\\\\n".join(display) for display in displays)
    return [f"\\begin{{aligned}}\n{display}\n\\end{{aligned}}" for display in joined]


def _cut(value: sp.ImmutableMatrix, names: list[str]) -> tuple[sp.Matrix, list[int]]:
    """A matrix with names for as many of its longest entries as have no room, and which these
    are."""
    lengths = [seen(tex(entry)) for entry in value]
    for longest in sorted({_SHORT, *(n for n in lengths if n > _SHORT)}, reverse=True):
        long = [k for k, length in enumerate(lengths) if length > longest]
        entries = [sp.Symbol(names[k]) if k in long else x for k, x in enumerate(value)]
        cut = sp.Matrix(*value.shape, entries)
        if _width(cut) <= _WIDTH:
            break
    return cut, long


def numbers(item: Item, home: Array) -> str:
    """An answer's numbers, rounded: a number to six decimals, others to four."""
    if item.is_number:
        return f"{name(item)} = {sp.latex(_rounded(home[0, 0], 6))}"
    value = sp.Matrix([[_rounded(x, 4) for x in row] for row in home])
    shown = sp.latex(value, mat_str="array")
    return f"{name(item)} = {shown.replace('c' * value.cols, 'r' * value.cols, 1)}"


def as_latex(sheet: Sheet, item: Item) -> str:
    """Displays for a document that uses amsmath; what c_{23} and the like mean stands above them as
    comments."""
    legend = [f"% ${sp.latex(letter)} = {tex(f)}$" for letter, f in item.letters.items()]
    return "\n".join([*legend, *(f"\\[\n{display}\n\\]" for display in symbols(sheet, item))])


def _rounded(value: float, digits: int) -> sp.Expr:
    rounded = round(float(value), digits)
    return sp.Integer(rounded) if rounded.is_integer() else sp.Float(str(rounded))


def _entry_names(sheet: Sheet, item: Item) -> list[str]:
    """The name of each entry: by row and column, by component, by joint, or the number's own."""
    rows, columns = item.value.shape
    letter = item.name[0]
    if item.is_number:
        return [name(item)]
    if letter == "G":
        return [f"g_{{{joint}}}" for joint in sheet.arm.joints]
    if columns == 1:
        return [f"({name(item)})_{{{axis}}}" for axis in "xyz"]
    letter = letter if letter == "J" else letter.lower()
    return [f"{letter}_{{{i + 1}{k + 1}}}" for i in range(rows) for k in range(columns)]


def _width(matrix: sp.Matrix) -> int:
    columns = (matrix.col(k) for k in range(matrix.cols))
    return sum(max(seen(tex(entry)) for entry in column) + 2 for column in columns)
