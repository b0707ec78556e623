"""Write lists and tables of numbers in the layouts of people and tools.

Weights follow where students copy from: Python and MATLAB windows first, then Markdown and LaTeX of
their write-ups, then lines typed by hand, then spreadsheets; other tools are rare.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

import numpy as np
import sympy


@dataclass(frozen=True)
class Grid:
    """Cells of an answer as typed, with their names.

    Attributes:
        cells: texts, row by row.
        values: numbers in the unit typed, for tools that print on their own.
        columns, rows: names.
        corner: name of the column of row names.
        name: variable or symbol of the whole.
        unit: unit that a heading may show, or "".
        neighbours: further columns of a table, by header.
    """

    cells: list[list[str]]
    values: np.ndarray
    columns: list[str]
    rows: list[str]
    corner: str
    name: str
    unit: str
    neighbours: dict[str, list[str]] = field(default_factory=dict)


@dataclass(frozen=True)
class Layout:
    """A layout of one class.

    Attributes:
        family: "code", "print", "latex", "markdown", "html" or "text"; says what a cell may hold.
        weight: how common it is among its shape.
        write: the function that lays a grid out.
        commas: whether a decimal comma stays readable.
        labelled: whether it shows names of rows or columns.
    """

    family: str
    weight: float
    write: Callable[[Grid, Random], str]
    commas: bool = False
    labelled: bool = True


# Lists with a number for each joint, so the grid has a single row.


def _pairs(grid: Grid) -> list[tuple[str, str]]:
    return list(zip(grid.columns, grid.cells[0], strict=True))


def _lines(grid: Grid, rng: Random) -> str:
    mark = rng.choice((" = ", " = ", ": ", "=", " : ", ":", "\t", " -> ", "  "))
    return "\n".join(name + mark + cell for name, cell in _pairs(grid))


def _numbering_lines(grid: Grid, rng: Random) -> str:
    style = rng.choice(("({}) ", "{}. ", "{}) ", "[{}] ", "{}: ", "#{} ", "{}.) "))
    return "\n".join(style.format(i) + cell for i, cell in enumerate(grid.cells[0], 1))


def _one_a_line(grid: Grid, rng: Random) -> str:
    return "\n".join(grid.cells[0])


def _bullets(grid: Grid, rng: Random) -> str:
    bullet, mark = rng.choice(("- ", "* ", "• ", "– ", "  - ")), rng.choice((": ", " = "))
    return "\n".join(f"{bullet}{name}{mark}{cell}" for name, cell in _pairs(grid))


def _inline(grid: Grid, rng: Random) -> str:
    mark, gap = rng.choice((" = ", "=", ": ")), rng.choice((", ", "; ", "   "))
    gap = "; " if any("," in cell for cell in grid.cells[0]) else gap
    return gap.join(name + mark + cell for name, cell in _pairs(grid))


def _prose(grid: Grid, rng: Random) -> str:
    mark = rng.choice((" = ", " is ", " equals ", " ≈ "))
    parts = [name + mark + cell for name, cell in _pairs(grid)]
    opening = rng.choice(("We obtain ", "So the result is: ", "Therefore ", "I got ", "Finally, "))
    return f"{opening}{', '.join(parts[:-1])} and {parts[-1]}."


def _plain_sentence(grid: Grid, rng: Random) -> str:
    cells = grid.cells[0]
    opening = rng.choice(("The values for joints 1 to {n} are ", "In order (joint 1 to {n}): "))
    unit = f" {grid.unit}" if grid.unit else ""
    return opening.format(n=len(cells)) + f"{', '.join(cells[:-1])} and {cells[-1]}{unit}."


def _python_list(grid: Grid, rng: Random) -> str:
    text = f"[{', '.join(grid.cells[0])}]"
    return rng.choice((text, f"{grid.name} = {text}", f"({text[1:-1]})", f"np.array({text})"))


def _array_repr(grid: Grid, rng: Random) -> str:
    text = ", ".join(grid.cells[0])
    return rng.choice(
        (f"array([{text}])", f"{grid.name} = np.array([{text}])", f"tensor([{text}])")
    )


def _column_list(grid: Grid, rng: Random) -> str:
    return f"[{', '.join(f'[{cell}]' for cell in grid.cells[0])}]"


def _numpy_print(grid: Grid, rng: Random) -> str:
    values = grid.values[0] if len(grid.values) == 1 else grid.values
    options = dict(precision=rng.choice((8, 4, 3, 6)), suppress_small=rng.random() < 0.6)
    if len(grid.values) == 1 and rng.random() < 0.2:
        values = values[:, None]
    separator = rng.choice((" ", " ", ", "))
    text = np.array2string(values, separator=separator, threshold=10**6, **options)
    return rng.choice((text, text, f"{grid.name} = {text}", f"{grid.name}: {text}"))


def _matlab_print(grid: Grid, rng: Random) -> str:
    """Write numbers as MATLAB's `format short` or `format long`, with 80 characters a line."""
    digits = rng.choice((4, 4, 4, 15))
    values = grid.values.T if len(grid.values) == 1 and rng.random() < 0.6 else grid.values
    name = rng.choice((grid.name, "ans"))
    largest = abs(values).max()
    factor = 10.0 ** np.floor(np.log10(largest)) if largest >= 1000 else 1.0
    width = digits + 6
    texts = [
        [f"{x / factor:{width}.{digits}f}" if x else f"{0:{width}d}" for x in row] for row in values
    ]
    head = f"{name} =\n\n" + (f"   {factor:.1e} *\n\n" if factor != 1 else "")
    per_line = max(1, 80 // width)
    count = len(values[0])
    if count <= per_line:
        return head + "\n".join("".join(row) for row in texts) + "\n"
    parts = []
    for first in range(0, count, per_line):
        last = min(first + per_line, count)
        title = f"Columns {first + 1} through {last}" if last > first + 1 else f"Column {last}"
        body = "\n".join("".join(row[first:last]) for row in texts)
        parts.append(f"  {title}\n\n{body}\n")
    return head + "\n".join(parts)


def _matlab_literal(grid: Grid, rng: Random) -> str:
    gap = rng.choice((" ", ", ", "  "))
    break_ = rng.choice(("; ", ";\n     ", "; ...\n     ")) if len(grid.cells) > 1 else ""
    if len(grid.cells) == 1 and rng.random() < 0.4:
        return f"{grid.name} = [{'; '.join(grid.cells[0])}]{rng.choice(('', ';'))}"
    body = break_.join(gap.join(row) for row in grid.cells)
    return f"{grid.name} = [{body}]{rng.choice((';', ''))}"


def _json_list(grid: Grid, rng: Random) -> str:
    body = ", ".join(f'"{name}": {cell}' for name, cell in _pairs(grid))
    return rng.choice(("{{{0}}}", '{{"' + grid.name + '": {{{0}}}}}')).format(body)


def _python_dict(grid: Grid, rng: Random) -> str:
    body = ", ".join(f"'{name}': {cell}" for name, cell in _pairs(grid))
    return rng.choice(("{{{0}}}", grid.name + " = {{{0}}}", "dict_items: {{{0}}}")).format(body)


def _tuples(grid: Grid, rng: Random) -> str:
    return "[" + ", ".join(f"('{name}', {cell})" for name, cell in _pairs(grid)) + "]"


def _assignments(grid: Grid, rng: Random) -> str:
    gap = rng.choice((";\n", "\n", "; "))
    return gap.join(f"{name} = {cell}" for name, cell in _pairs(grid))


def _yaml(grid: Grid, rng: Random) -> str:
    if rng.random() < 0.5:
        return f"{grid.name}:\n" + "\n".join(f"- {cell}" for cell in grid.cells[0])
    return "\n".join(f"{name.replace(' ', '_')}: {cell}" for name, cell in _pairs(grid))


def _ros(grid: Grid, rng: Random) -> str:
    """Write a sensor_msgs/JointState message as `rostopic echo` prints it."""
    names = [f"joint_{i}" for i in range(1, len(grid.cells[0]) + 1)]
    field = "effort" if grid.name in ("tau", "torques") else "position"
    values = f"[{', '.join(grid.cells[0])}]"
    lines = [
        "header: ",
        "  seq: 812",
        "  stamp: ",
        "    secs: 1699",
        "    nsecs: 471235",
        '  frame_id: ""',
    ]
    lines += [f"name: {rng.choice((str(names), '[' + ', '.join(names) + ']'))}"]
    lines += [f"{x}: {values if x == field else '[]'}" for x in ("position", "velocity", "effort")]
    return "\n".join([*lines, "---"])


def _latex_column(grid: Grid, rng: Random) -> str:
    kind = rng.choice(("bmatrix", "pmatrix", "bmatrix"))
    symbol = {"tau": r"\tau", "q": "q", "theta": r"\theta"}.get(grid.name, grid.name)
    if rng.random() < 0.5:
        body, after = r" \\ ".join(grid.cells[0]), ""
    else:
        body, after = " & ".join(grid.cells[0]), rng.choice(("^T", r"^{\top}", ""))
    text = rf"{symbol} = \begin{{{kind}}} {body} \end{{{kind}}}{after}"
    text += rf"\ \mathrm{{{grid.unit}}}" if grid.unit and rng.random() < 0.5 else ""
    return rng.choice(
        ("$${}$$", "\\[\n{}\n\\]", "{}", "\\begin{{equation}}\n{}\n\\end{{equation}}")
    ).format(text)


def _latex_align(grid: Grid, rng: Random) -> str:
    body = " \\\\\n".join(f"{name} &= {cell}" for name, cell in _pairs(grid))
    return f"\\begin{{align*}}\n{body}\n\\end{{align*}}"


def _latex_inline(grid: Grid, rng: Random) -> str:
    return ", ".join(f"${name} = {cell}$" for name, cell in _pairs(grid))


def _two_columns(grid: Grid) -> Grid:
    """Turn a list into a table of joint and value."""
    head = f"{grid.name} [{grid.unit}]" if grid.unit else grid.name
    cells = [[cell] for cell in grid.cells[0]]
    columns, more = [head], grid.neighbours
    return Grid(
        cells, grid.values.T, columns, grid.columns, grid.corner, grid.name, grid.unit, more
    )


def _as_table(write: Callable[[Grid, Random], str]) -> Callable[[Grid, Random], str]:
    """Write a list as a table with one row, or one column, for each joint."""

    def write_list(grid: Grid, rng: Random) -> str:
        upright = bool(grid.neighbours) or rng.random() < 0.7
        return write(_two_columns(grid) if upright else grid, rng)

    return write_list


def _series(grid: Grid, rng: Random) -> str:
    width = max(map(len, grid.columns))
    cells = grid.cells[0]
    size = max(map(len, cells))
    body = "\n".join(f"{n:<{width}}    {c:>{size}}" for n, c in _pairs(grid))
    return f"{body}\nName: {grid.name}, dtype: float64"


def _julia_vector(grid: Grid, rng: Random) -> str:
    body = "\n".join(f" {cell}" for cell in grid.cells[0])
    return f"{len(grid.cells[0])}-element Vector{{Float64}}:\n{body}"


def _rules(grid: Grid, rng: Random) -> str:
    return "{" + ", ".join(f"{n.replace('_', '')} -> {c}" for n, c in _pairs(grid)) + "}"


def _braces(grid: Grid, rng: Random) -> str:
    if len(grid.cells) == 1:
        return rng.choice(("{{{0}}}", "double " + grid.name + "[] = {{{0}}};")).format(
            ", ".join(grid.cells[0])
        )
    return "{" + rng.choice((", ", ",\n ")).join(f"{{{', '.join(r)}}}" for r in grid.cells) + "}"


# Tables of numbers.


def _full(grid: Grid) -> list[list[str]]:
    """Return header and rows with row names at the start and extra columns at the end."""
    return [[name, *row] for name, row in zip([grid.corner, *grid.rows], _body(grid), strict=True)]


def _body(grid: Grid) -> list[list[str]]:
    """Return header and rows with extra columns at the end."""
    more = list(grid.neighbours.values())
    rows = [[*row, *(column[i] for column in more)] for i, row in enumerate(grid.cells)]
    return [[*grid.columns, *grid.neighbours], *rows]


def _padded(rows: list[list[str]], right: bool = True) -> list[list[str]]:
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    align = str.rjust if right else str.ljust
    return [[align(cell, w) for cell, w in zip(row, widths, strict=True)] for row in rows]


def _markdown(grid: Grid, rng: Random) -> str:
    rows = [[cell.replace("|", "\\|") for cell in row] for row in _full(grid)]
    rows = _padded(rows, False) if rng.random() < 0.6 else rows
    rule = rng.choice((":--", "---", "--:", ":-:"))
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join([lines[0], "|" + "|".join([rule] * len(rows[0])) + "|", *lines[1:]])


def _org(grid: Grid, rng: Random) -> str:
    rows = _padded(_full(grid))
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    rule = "|" + "+".join("-" * (len(cell) + 2) for cell in rows[0]) + "|"
    return "\n".join([lines[0], rule, *lines[1:]])


def _prettytable(grid: Grid, rng: Random) -> str:
    rows = _padded(_full(grid))
    rule = "+" + "+".join("-" * (len(cell) + 2) for cell in rows[0]) + "+"
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join([rule, lines[0], rule, *lines[1:], rule])


def _tabulate(grid: Grid, rng: Random) -> str:
    rows = _padded(_full(grid))
    if rng.random() < 0.5:
        rule = "  ".join("-" * len(cell) for cell in rows[0])
        lines = ["  ".join(row) for row in rows]
        return "\n".join([lines[0], rule, *lines[1:]])
    bars = ["═" * (len(cell) + 2) for cell in rows[0]]
    lines = ["│ " + " │ ".join(row) + " │" for row in rows]
    thin = "├" + "┼".join("─" * len(bar) for bar in bars) + "┤"
    body = f"\n{thin}\n".join(lines[1:])
    top, middle, end = (
        "╒" + "╤".join(bars) + "╕",
        "╞" + "╪".join(bars) + "╡",
        "╘" + "╧".join(bars) + "╛",
    )
    return "\n".join([top, lines[0], middle, body, end])


def _csv(grid: Grid, rng: Random) -> str:
    comma = any("," in cell for row in grid.cells for cell in row)
    mark = ";" if comma else rng.choice((",", ",", ", ", ";"))
    rows = _full(grid) if rng.random() < 0.7 else _body(grid)
    rows = rows if grid.neighbours or rng.random() < 0.75 else rows[1:]
    quote = '"' if rng.random() < 0.15 else ""
    return "\n".join(mark.join(quote + cell + quote for cell in row) for row in rows)


def _sheet(grid: Grid, rng: Random) -> str:
    rows = _full(grid) if rng.random() < 0.7 else _body(grid)
    whole = bool(grid.neighbours) or rng.random() < 0.85
    return "\n".join("\t".join(row) for row in (rows if whole else rows[1:]))


def _word_table(grid: Grid, rng: Random) -> str:
    """Write a pasted Word table: each cell on a line of its own."""
    return "\n".join(cell for row in _full(grid) for cell in row)


def _html(grid: Grid, rng: Random) -> str:
    head, *rows = _full(grid)
    top = "".join(f"<th>{cell}</th>" for cell in head)
    cell_tag = rng.choice(("<td>{}</td>", '<td style="text-align:right">{}</td>'))
    body = "\n".join("<tr>" + "".join(cell_tag.format(c) for c in row) + "</tr>" for row in rows)
    return f"<table>\n<tr>{top}</tr>\n{body}\n</table>"


def _tabular(grid: Grid, rng: Random) -> str:
    rows = [
        [cell if "\\" not in cell and "_" not in cell else f"${cell}$" for cell in r]
        for r in _full(grid)
    ]
    top, middle, end = rng.choice(((r"\hline",) * 3, (r"\toprule", r"\midrule", r"\bottomrule")))
    lines = [" & ".join(row) + r" \\" for row in rows]
    columns = rng.choice(
        ("c" * len(rows[0]), "|" + "c|" * len(rows[0]), "l" + "r" * (len(rows[0]) - 1))
    )
    body = "\n".join([top, lines[0], middle, *lines[1:], end])
    return f"\\begin{{tabular}}{{{columns}}}\n{body}\n\\end{{tabular}}"


def _latex_matrix(grid: Grid, rng: Random) -> str:
    body = " \\\\\n".join(" & ".join(row) for row in grid.cells)
    kind = rng.choice(("bmatrix", "pmatrix", "array"))
    if kind == "array":
        text = (
            f"\\left[\\begin{{array}}{{{'c' * len(grid.columns)}}}\n{body}\n\\end{{array}}\\right]"
        )
    else:
        text = f"\\begin{{{kind}}}\n{body}\n\\end{{{kind}}}"
    return rng.choice(("{0}", "$${1} = {0}$$", "\\[ {1} = {0} \\]")).format(text, grid.name)


def _pandas(grid: Grid, rng: Random) -> str:
    """Write a data frame as pandas prints it, wrapped at 80 characters."""
    rows = _padded([["", *_body(grid)[0]], *_full(grid)[1:]])
    lines = ["  ".join(row) for row in rows]
    if len(lines[0]) <= 80 or rng.random() < 0.4:
        return "\n".join(lines)
    count = max(1, sum(len("  ".join(rows[0][: i + 1])) <= 78 for i in range(len(rows[0]))))
    first = ["  ".join(row[:count]) for row in rows]
    second = ["  ".join([row[0], *row[count:]]) for row in rows]
    first = [first[0] + "  \\", *(line + "   " for line in first[1:])]
    return "\n".join([*first, "", *second])


def _sympy_pretty(grid: Grid, rng: Random) -> str:
    digits = rng.choice((4, 6, 8))
    values = grid.values.T if len(grid.values) == 1 else grid.values
    matrix = sympy.Matrix(
        [[sympy.Float(round(x, digits)) if x else 0 for x in row] for row in values]
    )
    return sympy.pretty(matrix, wrap_line=False, use_unicode=True)


def _sympy_matrix(grid: Grid, rng: Random) -> str:
    rows = [[cell] for cell in grid.cells[0]] if len(grid.cells) == 1 else grid.cells
    gap = ", " if rng.random() < 0.6 else ",\n        "
    return f"Matrix([{gap.join('[' + ', '.join(row) + ']' for row in rows)}])"


def _julia_matrix(grid: Grid, rng: Random) -> str:
    rows = _padded(grid.cells)
    shape = f"{len(rows)}×{len(rows[0])} Matrix{{Float64}}:"
    return "\n".join([shape, *(" " + "  ".join(row) for row in rows)])


def _r_print(grid: Grid, rng: Random) -> str:
    head = ["", *(f"[,{i}]" for i in range(1, len(grid.columns) + 1))]
    rows = _padded([head, *([f"[{i},]", *row] for i, row in enumerate(grid.cells, 1))])
    return "\n".join(" ".join(row) for row in rows)


def _nested_list(grid: Grid, rng: Random) -> str:
    gap = rng.choice((", ", ",\n ", ",\n  "))
    text = f"[{gap.join('[' + ', '.join(row) + ']' for row in grid.cells)}]"
    opening = rng.choice(("{}", grid.name + " = {}", "np.array({})", "array({})"))
    return opening.format(text)


def _json_rows(grid: Grid, rng: Random) -> str:
    items = [
        "{" + ", ".join(f'"{c}": {x}' for c, x in zip(grid.columns, row, strict=True)) + "}"
        for row in grid.cells
    ]
    return "[" + ",\n ".join(items) + "]"


def _dict_rows(grid: Grid, rng: Random) -> str:
    items = (
        f"{json.dumps(n, ensure_ascii=False)}: [{', '.join(r)}]"
        for n, r in zip(grid.rows, grid.cells, strict=True)
    )
    return "{" + ",\n ".join(items) + "}"


def _spaced(grid: Grid, rng: Random) -> str:
    rows = _full(grid) if rng.random() < 0.4 else grid.cells
    rows = [[cell.replace(" ", "") for cell in row] for row in rows]
    return "\n".join("  ".join(row) for row in (_padded(rows) if rng.random() < 0.7 else rows))


def _labelled_rows(grid: Grid, rng: Random) -> str:
    mark, gap = rng.choice((" = ", ": ", "=")), rng.choice((", ", "; "))
    gap = "; " if any("," in cell for row in grid.cells for cell in row) else gap
    return "\n".join(
        f"{name}: " + gap.join(c + mark + x for c, x in zip(grid.columns, row, strict=True))
        for name, row in zip(grid.rows, grid.cells, strict=True)
    )


def _bracket_rows(grid: Grid, rng: Random) -> str:
    opening, close = rng.choice(("()", "[]", "{}"))
    gap = "; " if any("," in cell for row in grid.cells for cell in row) else ", "
    mark = rng.choice((": ", " = ", " "))
    return "\n".join(
        f"{name}{mark}{opening}{gap.join(row)}{close}"
        for name, row in zip(grid.rows, grid.cells, strict=True)
    )


def _sections(grid: Grid, rng: Random) -> str:
    mark = rng.choice((" = ", ": "))
    parts = [
        f"{name}:\n" + "\n".join(c + mark + x for c, x in zip(grid.columns, row, strict=True))
        for name, row in zip(grid.rows, grid.cells, strict=True)
    ]
    return "\n\n".join(parts)


LIST_LAYOUTS = {
    "lines": Layout("text", 14, _lines, commas=True),
    "numbered lines": Layout("text", 5, _numbering_lines, commas=True, labelled=False),
    "one a line": Layout("text", 4, _one_a_line, commas=True, labelled=False),
    "bullets": Layout("markdown", 6, _bullets, commas=True),
    "inline": Layout("text", 7, _inline, commas=True),
    "prose": Layout("text", 5, _prose, commas=False),
    "plain sentence": Layout("text", 2, _plain_sentence, labelled=False),
    "Python list": Layout("code", 10, _python_list, labelled=False),
    "array(...)": Layout("code", 5, _array_repr, labelled=False),
    "column list": Layout("code", 2, _column_list, labelled=False),
    "NumPy print": Layout("print", 10, _numpy_print, labelled=False),
    "MATLAB print": Layout("print", 8, _matlab_print, labelled=False),
    "MATLAB literal": Layout("code", 5, _matlab_literal, labelled=False),
    "JSON": Layout("code", 2, _json_list),
    "Python dict": Layout("code", 4, _python_dict),
    "pairs": Layout("code", 1, _tuples),
    "assignments": Layout("code", 4, _assignments),
    "YAML": Layout("code", 1.5, _yaml),
    "ROS message": Layout("code", 2, _ros, labelled=False),
    "LaTeX vector": Layout("latex", 6, _latex_column, labelled=False),
    "LaTeX align": Layout("latex", 3, _latex_align),
    "LaTeX inline": Layout("latex", 2, _latex_inline),
    "Markdown table": Layout("markdown", 8, _as_table(_markdown), commas=True),
    "CSV": Layout("text", 3, _as_table(_csv), commas=True),
    "spreadsheet": Layout("text", 5, _as_table(_sheet), commas=True),
    "Word table": Layout("text", 2, _as_table(_word_table), commas=True),
    "HTML table": Layout("html", 2, _as_table(_html), commas=True),
    "LaTeX tabular": Layout("latex", 3, _as_table(_tabular)),
    "prettytable": Layout("print", 1, _as_table(_prettytable)),
    "tabulate": Layout("print", 1, _as_table(_tabulate)),
    "org table": Layout("text", 1, _as_table(_org)),
    "pandas series": Layout("print", 2, _series),
    "SymPy pretty": Layout("print", 2, _sympy_pretty, labelled=False),
    "SymPy Matrix": Layout("code", 3, _sympy_matrix, labelled=False),
    "Julia": Layout("print", 1, _julia_vector, labelled=False),
    "Mathematica rules": Layout("code", 1, _rules),
    "braces": Layout("code", 1.5, _braces, labelled=False),
}
TABLE_LAYOUTS = {
    "nested list": Layout("code", 12, _nested_list, labelled=False),
    "NumPy print": Layout("print", 14, _numpy_print, labelled=False),
    "MATLAB print": Layout("print", 9, _matlab_print, labelled=False),
    "MATLAB literal": Layout("code", 6, _matlab_literal, labelled=False),
    "LaTeX matrix": Layout("latex", 7, _latex_matrix, labelled=False),
    "LaTeX tabular": Layout("latex", 5, _tabular),
    "Markdown table": Layout("markdown", 11, _markdown, commas=True),
    "CSV": Layout("text", 6, _csv, commas=True),
    "spreadsheet": Layout("text", 7, _sheet, commas=True),
    "Word table": Layout("text", 2, _word_table, commas=True),
    "HTML table": Layout("html", 2, _html, commas=True),
    "pandas frame": Layout("print", 5, _pandas),
    "SymPy pretty": Layout("print", 3, _sympy_pretty, labelled=False),
    "SymPy Matrix": Layout("code", 3, _sympy_matrix, labelled=False),
    "prettytable": Layout("print", 1.5, _prettytable),
    "tabulate": Layout("print", 2, _tabulate),
    "org table": Layout("text", 1, _org),
    "Julia": Layout("print", 1.5, _julia_matrix, labelled=False),
    "R print": Layout("print", 1, _r_print, labelled=False),
    "JSON": Layout("code", 1.5, _json_rows),
    "dict of rows": Layout("code", 1.5, _dict_rows),
    "braces": Layout("code", 1.5, _braces, labelled=False),
    "spaced columns": Layout("text", 5, _spaced, commas=True),
}
#: Further layouts of several joint vectors, line by line.
ROW_LAYOUTS = {
    "labelled rows": Layout("text", 7, _labelled_rows, commas=True),
    "bracketed rows": Layout("text", 7, _bracket_rows),
    "sections": Layout("text", 4, _sections, commas=True),
}
#: Layouts for DH tables, whose cells contain symbols.
SYMBOL_LAYOUTS = (
    "nested list", "MATLAB literal", "LaTeX tabular", "LaTeX matrix", "Markdown table", "CSV",
    "spreadsheet", "Word table", "HTML table", "pandas frame", "prettytable", "tabulate",
    "org table", "spaced columns",
)  # fmt: skip
