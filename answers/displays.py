"""Write an answer in TeX for a page or a LaTeX document.

Long entries of a matrix get names, which are written out below it or under Origins and Axes, so
that no line is wider than a page.
"""

import sympy as sp

from answers.content import Answer, AnswerSheet, Array
from helpers.formulas import break_lines, formula_latex, print_latex, visible_length

_WIDTH = 56  # characters in a line
_HEIGHT = 16  # lines in a display


def format_name(answer: Answer) -> str:
    """Return an answer's name in TeX."""
    letter, _, index = answer.name.partition("_")
    names = {"J": "J", "det": r"\det J", "P": "P", "G": "g(q)"}
    if letter in names:
        return names[letter]
    return f"{{}}^{{0}}T_{{{index[1:]}}}" if letter == "T" else f"{letter}_{{{index}}}"


def format_symbols(sheet: AnswerSheet, answer: Answer, complete: bool = False) -> list[str]:
    """Write an answer in symbols, as a list of displays.

    Args:
        sheet: the sheet of the answer.
        answer: the answer to write.
        complete: write out long parts of origins and axes, which a page shows elsewhere.
    """
    value, names = answer.value, _name_entries(sheet, answer)
    if not answer.is_number and _measure_width(value) <= _WIDTH:
        return [f"{format_name(answer)} = {print_latex(value)}"]
    if value.cols == 1:
        first = next((axis for axis in sheet.axes if axis.value == value), answer)
        if first is not answer and not complete:
            return [f"{format_name(answer)} = {format_name(first)}"]
        return _format_aligned([*zip(names, value, strict=True)])
    shared_names = {} if complete else _name_shared_entries(sheet, answer)
    cut, long = _name_long_entries(
        value, [shared_names.get(k, name) for k, name in enumerate(names)]
    )
    by_columns = sorted({*long} - shared_names.keys(), key=lambda k: (k % value.cols, k))
    return [
        f"{format_name(answer)} = {print_latex(cut)}",
        *_format_aligned([(names[k], value[k]) for k in by_columns]),
    ]


def _name_shared_entries(sheet: AnswerSheet, answer: Answer) -> dict[int, str]:
    """Return by index the names of a matrix's entries that are entries of axes and origins."""
    columns, first = answer.value.cols, {}  # matrix index of each vector's first entry
    if answer.name[0] == "T":
        i = int(answer.name[2:])
        first = {2: sheet.axes[i], 3: sheet.origins[i]}
    elif answer.name == "J":
        joints = enumerate(zip(sheet.arm.joints, sheet.arm.turning, strict=True))
        first = {k + 3 * columns * turns: sheet.axes[i - 1] for k, (i, turns) in joints}
    return {
        start + row * columns: entry
        for start, vector in first.items()
        for row, entry in enumerate(_name_entries(sheet, vector))
    }


def _format_aligned(formulas: list[tuple[str, sp.Expr]]) -> list[str]:
    """Write named formulas in a column, at most _HEIGHT lines in a display."""
    displays: list[list[str]] = []
    for label, formula in formulas:
        first, *rest = break_lines(formula, _WIDTH)
        named = [f"{label} &= {first}", *(f"&\\quad {line}" for line in rest)]
        if displays and len(displays[-1]) + len(named) <= _HEIGHT:
            displays[-1] += named
        else:
            displays.append(named)
    joined = (" \\\\\n".join(display) for display in displays)
    return [f"\\begin{{aligned}}\n{display}\n\\end{{aligned}}" for display in joined]


def _name_long_entries(value: sp.ImmutableMatrix, names: list[str]) -> tuple[sp.Matrix, list[int]]:
    """Replace the longest entries of a matrix by names until it fits.

    Returns the matrix and the indices of the replaced entries.
    """
    lengths = [visible_length(formula_latex(entry)) for entry in value]
    for longest in sorted({0, *lengths}, reverse=True):
        long = [
            k for k, length in enumerate(lengths) if length > max(longest, visible_length(names[k]))
        ]
        entries = [sp.Symbol(names[k]) if k in long else x for k, x in enumerate(value)]
        cut = sp.Matrix(*value.shape, entries)
        if _measure_width(cut) <= _WIDTH:
            break
    return cut, long


def format_numbers(answer: Answer, values: Array) -> str:
    """Write an answer's numbers, a scalar to six decimals, matrices to four."""
    if answer.is_number:
        return f"{format_name(answer)} = {sp.latex(_round_number(values[0, 0], 6))}"
    value = sp.Matrix([[_round_number(x, 4) for x in row] for row in values])
    shown = sp.latex(value, mat_str="array")
    return f"{format_name(answer)} = {shown.replace('c' * value.cols, 'r' * value.cols, 1)}"


def write_latex(sheet: AnswerSheet, answer: Answer) -> str:
    """Write displays for amsmath, below comments that define c_{23} and the like."""
    legend = [
        f"% ${sp.latex(symbol)} = {formula_latex(f)}$" for symbol, f in answer.definitions.items()
    ]
    return "\n".join(
        [*legend, *(f"\\[\n{display}\n\\]" for display in format_symbols(sheet, answer, True))]
    )


def _round_number(value: float, digits: int) -> sp.Expr:
    rounded = round(float(value), digits)
    return sp.Integer(rounded) if rounded.is_integer() else sp.Float(str(rounded))


def _name_entries(sheet: AnswerSheet, answer: Answer) -> list[str]:
    """Return the TeX name of each entry, by row and column, component or joint."""
    rows, columns = answer.value.shape
    letter = answer.name[0]
    if answer.is_number:
        return [format_name(answer)]
    if letter == "G":
        return [f"g_{{{joint}}}" for joint in sheet.arm.joints]
    if columns == 1:
        return [f"({format_name(answer)})_{{{axis}}}" for axis in "xyz"]
    letter = letter if letter == "J" else letter.lower()
    return [f"{letter}_{{{i + 1}{k + 1}}}" for i in range(rows) for k in range(columns)]


def _measure_width(matrix: sp.Matrix) -> int:
    """Return the width of a matrix in characters."""
    columns = (matrix.col(k) for k in range(matrix.cols))
    return sum(
        max(visible_length(formula_latex(entry)) for entry in column) + 2 for column in columns
    )
