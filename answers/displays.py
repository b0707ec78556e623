"""An answer in TeX, as a page shows it and a LaTeX document takes it: a matrix as a matrix, with
names for its long entries, which are written out below, or among the origins and axes. No line is
wider than a page.
"""

import sympy as sp

from answers.content import Array, Item, Sheet
from helpers.formulas import lines, seen, tex

_WIDTH = 56  # letters and signs of a line
_HEIGHT = 16  # lines of a display


def name(item: Item) -> str:
    """An answer's name as books write it."""
    letter, _, index = item.name.partition("_")
    named = {"J": "J", "det": r"\det J", "P": "P", "G": "g(q)"}
    if letter in named:
        return named[letter]
    return f"{{}}^{{0}}T_{{{index[1:]}}}" if letter == "T" else f"{letter}_{{{index}}}"


def symbols(sheet: Sheet, item: Item, complete: bool = False) -> list[str]:
    """An answer in symbols, a display each; long parts of origins and axes, which the page has
    elsewhere, are written out if it is to be complete."""
    value, names = item.value, _entry_names(sheet, item)
    if not item.is_number and _width(value) <= _WIDTH:
        return [f"{name(item)} = {sp.latex(value)}"]
    if value.cols == 1:
        first = next((axis for axis in sheet.axes if axis.value == value), item)
        if first is not item and not complete:
            return [f"{name(item)} = {name(first)}"]
        return _aligned([*zip(names, value, strict=True)])
    elsewhere = {} if complete else _parts(sheet, item)
    cut, long = _cut(value, [elsewhere.get(k, own) for k, own in enumerate(names)])
    by_columns = sorted({*long} - elsewhere.keys(), key=lambda k: (k % value.cols, k))
    return [
        f"{name(item)} = {sp.latex(cut)}",
        *_aligned([(names[k], value[k]) for k in by_columns]),
    ]


def _parts(sheet: Sheet, item: Item) -> dict[int, str]:
    """The names of what a frame has of its axis and origin, and J of the axes, by their places."""
    columns, first = item.value.cols, {}  # the place of a vector's first entry
    if item.name[0] == "T":
        i = int(item.name[2:])
        first = {2: sheet.axes[i], 3: sheet.origins[i]}
    elif item.name == "J":
        joints = enumerate(zip(sheet.arm.joints, sheet.arm.turning, strict=True))
        first = {k + 3 * columns * turns: sheet.axes[i - 1] for k, (i, turns) in joints}
    return {
        place + row * columns: entry
        for place, vector in first.items()
        for row, entry in enumerate(_entry_names(sheet, vector))
    }


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
    """A matrix with names for as many of its longest entries as have no room, and their places."""
    lengths = [seen(tex(entry)) for entry in value]
    for longest in sorted({0, *lengths}, reverse=True):
        long = [k for k, length in enumerate(lengths) if length > max(longest, seen(names[k]))]
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
    return "\n".join([*legend, *(f"\\[\n{display}\n\\]" for display in symbols(sheet, item, True))])


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
