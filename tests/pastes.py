"""What students paste: matrices as NumPy, MATLAB, LaTeX, CSV files and spreadsheets write them, and
as people write them by hand. Each template says itself what it means: the matrix that went in."""

from collections.abc import Callable, Iterator

Rows = list[list[str]]
Template = Callable[[Rows], str]

# The elbow arm's Jacobian, a pose, a rotation in whole numbers, a row, a column of large and small.
MATRICES: tuple[Rows, ...] = (
    [
        ["-0.2841", "-0.3039", "-0.0778"],
        ["0.5200", "-0.1660", "-0.0425"],
        ["0.0000", "0.5925", "0.2866"],
        ["0.0000", "0.4794", "0.4794"],
        ["0.0000", "-0.8776", "-0.8776"],
        ["1.0000", "0.0000", "0.0000"],
    ],
    [
        ["0.5300", "-0.8480", "0.0000", "0.3125"],
        ["0.8480", "0.5300", "0.0000", "-1.2500"],
        ["0.0000", "0.0000", "1.0000", "0.7071"],
        ["0.0000", "0.0000", "0.0000", "1.0000"],
    ],
    [["0", "-1", "0"], ["1", "0", "0"], ["0", "0", "1"]],
    [["0.12", "-1.57", "2.50"], ["-0.75", "0.33", "12.01"]],
    [["120.5", "-3.25"], ["-0.001", "48.0"], ["7.25", "-1000.0"]],
)


def lines(cell: str, row: str, start: str = "", end: str = "", before: str = "", after: str = ""):
    """A template: cells and rows parted by these, all in `start` and `end`, a row in `before` and
    `after`."""

    def write(rows: Rows) -> str:
        return start + row.join(before + cell.join(line) + after for line in rows) + end

    return write


def over(template: Template, *changes: tuple[str, str]) -> Template:
    """A template with signs replaced after it."""

    def write(rows: Rows) -> str:
        text = template(rows)
        for old, new in changes:
            text = text.replace(old, new)
        return text

    return write


def each(cell: Callable[[str], str], template: Template) -> Template:
    """A template of cells written otherwise."""
    return lambda rows: template([[cell(x) for x in line] for line in rows])


def wide(rows: Rows, width: int = 10) -> str:
    return "\n".join("".join(f"{x:>{width}}" for x in line) for line in rows)


def power(x: str) -> str:
    return f"{float(x):.8e}"


def headed(row: str, cell: str, name: str = "q{}") -> Callable[[Template], Template]:
    """The heads of the columns over a template."""
    return lambda template: (
        lambda rows: (
            cell.join(name.format(k + 1) for k in range(len(rows[0]))) + row + template(rows)
        )
    )


def columns(heads: str, first: int = 2) -> Template:
    """MATLAB's print of a matrix in blocks of columns."""

    def write(rows: Rows) -> str:
        n = len(rows[0])
        a = heads.format(1, first) if first > 1 else heads.format(1, 1)
        rest = f" Column {n}" if n == first + 1 else f" Columns {first + 1} through {n}"
        parts = [([line[:first] for line in rows], a)]
        if n > first:
            parts.append(([line[first:] for line in rows], rest))
        return "\n\n".join(f"{head}\n\n{wide(part)}" for part, head in parts)

    return write


def dotted(x: str) -> str:
    """As NumPy prints a whole number: `1.`."""
    return f"{x}." if "." not in x else x.rstrip("0")


COMMA = (".", ",")
NESTED = lines(", ", "], [", "[[", "]]")
MATRIX = lines(" & ", r" \\ ")
TABS = lines("\t", "\n")
PLAIN = lines(" ", "\n")

NUMPY: dict[str, Template] = {
    "nested": NESTED,
    "print, dots": each(dotted, lines(" ", "]\n [", "[[", "]]")),
    "print, powers": each(power, lines(" ", "]\n [", "[[", "]]")),
    "print, wide": lambda g: "[" + "\n ".join(f"[{wide([line], 8)}]" for line in g) + "]",
    "repr, dtype": lines(", ", "],\n       [", "array([[", "]], dtype=float32)"),
    "named, trailing comma": lines(", ", "],\n    [", "J = np.array([\n    [", "],\n])"),
    "matrix": lines(", ", "], [", "np.matrix([[", "]])"),
    "tensor": lines(", ", "],\n        [", "tensor([[", "]])"),
    "tuples": lines(", ", "), (", "((", "))"),
    "rows of lists": lines(", ", "],\n[", "[", "]"),
    "float64": each(lambda x: f"np.float64({x})", NESTED),
    "prompt, print": lines(" ", "]\n [", ">>> print(J)\n[[", "]]"),
    "prompt": lines(", ", "],\n       [", ">>> J\narray([[", "]])"),
    "Out, below": lines(", ", "],\n       [", "Out[12]: \narray([[", "]])"),
    "label, colon": lines("  ", "]\n [", "J: [[", "]]"),
    "comment above": lines(", ", "],\n [", "# the Jacobian\n[[", "]]"),
    "comments": lines(", ", "],  # a row\n [", "[[", "]]"),
    "round": lines(", ", "],\n [", "np.round(np.array([[", "]]), 4)"),
    "fence": lines(", ", "],\n [", "```python\nJ = np.array([[", "]])\n```"),
    "minus": over(NESTED, ("-", "−")),
    "no-break": over(lines("  ", "]\n [", "[[", "]]"), (" ", "\u00a0")),
    "round brackets": lines("  ", "\n  ", "J = ( ", " )"),
    "each row in round ones": lines(" ", ")\n(", "(", ")"),
    "list in round ones": lines(", ", "],\n [", "([[", "]])"),
    "full stop": lines(", ", "], [", "J = np.array([[", "]])."),
    "curled quotes": each(lambda x: f"“{x}”", NESTED),
    "curled once": each(lambda x: f"‘{x}’", NESTED),
    "remarks": lines(" ", "  # a row\n", "", " # the last"),
    "degrees": each(lambda x: f"{x}*180/pi", lines(", ", "], [", "np.deg2rad([[", "]])")),
    "radians": each(lambda x: f"{x} rad", lines(" ", "]\n [", "[[", "]]")),
}  # fmt: skip
MATLAB: dict[str, Template] = {
    "typed": lines(" ", "; ", "[", "]"),
    "commas": lines(", ", "; ", "J = [", "];"),
    "lines": lines("   ", "\n", "J = [\n", "\n];"),
    "dots": lines(" ", "; ...\n     ", "J = [", "];"),
    "dots in rows": lines(", ", "; ...\n  ", "J = [ ...\n  ", " ];"),
    "comments": lines(" ", "; % a row\n     ", "J = [", "];"),
    "print": lambda rows: "J =\n\n" + wide(rows),
    "long": each(lambda x: f"{float(x):.15f}", lambda rows: "J =\n\n" + wide(rows, 22)),
    "scale": each(
        lambda x: f"{float(x) / 1000:.7f}", lambda g: "J =\n\n   1.0e+03 *\n\n" + wide(g, 12)
    ),
    "columns": columns("J =\n\n  Columns {} through {}"),
    "columns, Octave": columns("J =\n\n Columns {} and {}:"),
    "column by itself": columns("J =\n\n  Column {}", 1),
    "vpa": lines(", ", "]\n[", "[", "]"),
    "sym, named": lines(", ", "]\n[", "J =\n\n[", "]\n"),
    "brackets alone": lines("\t", ";\n\t", "[\t", "\t]"),
    "sym(": lines(", ", "; ", "sym([", "])"),
    "windows": lines(" ", ";\r\n", "J = [", "];"),
    "comma": lines(" ", "; ", "J = [", "],"),
    "remarks": lines(" ", " % a row\n     ", "J = [", " % the last\n];"),
}  # fmt: skip


def inside(kind: str, before: str = "", after: str = "", rows: Template = MATRIX) -> Template:
    """Rows in an environment of LaTeX."""
    bare = kind.partition("}")[0]
    return lambda given: f"{before}\\begin{{{kind}}} {rows(given)} \\end{{{bare}}}{after}"


def in_array(spec: str, before: str = "", after: str = "", rows: Template = MATRIX) -> Template:
    """Rows in an array with a letter for each column."""

    def write(given: Rows) -> str:
        letters = spec * len(given[0]) if len(spec) == 1 else spec
        return f"{before}\\begin{{array}}{{{letters}}} {rows(given)} \\end{{array}}{after}"

    return write


def in_tabular(above: str, below: str) -> Template:
    """Rows in a table with rules."""

    def write(given: Rows) -> str:
        start = f"\\begin{{tabular}}{{{'r' * len(given[0])}}} {above} "
        return start + MATRIX(given) + rf" \\ {below} \end{{tabular}}"

    return write


LATEX: dict[str, Template] = {
    "bmatrix": inside("bmatrix"),
    "vmatrix": inside("vmatrix"),
    "smallmatrix": inside("smallmatrix"),
    "bmatrix*": lambda g: "\\begin{bmatrix*}[r] " + MATRIX(g) + " \\end{bmatrix*}",
    "left": inside("matrix", r"\left[ ", r" \right]"),
    "array": in_array("c", r"\left[ ", r" \right]"),
    "of q": inside("bmatrix", "J(q) = "),
    "derivative": inside("bmatrix", r"\frac{\partial x}{\partial q} = "),
    "two names": inside("bmatrix", r"J = \frac{\partial p}{\partial q} = "),
    "index": inside("bmatrix", "J_v = "),
    "upper index": inside("bmatrix", "{}^0J_6 = "),
    "dollars": inside("pmatrix", "$$", "$$"),
    "display": inside("pmatrix", r"\[ J = ", r" \]"),
    "equation": inside("bmatrix", "\\begin{equation} J = ", " \\end{equation}"),
    "label": inside("bmatrix", "\\begin{equation}\\label{eq:J}\nJ = ", "\n\\end{equation}"),
    "align": inside("bmatrix", "\\begin{align} J &= ", " \\end{align}"),
    "full stop": inside("bmatrix", "J = ", "."),
    "last row ended": inside("bmatrix", rows=lines(" & ", r" \\ ", "", r" \\")),
    "tight": inside("bmatrix", rows=lines("&", r"\\")),
    "spaced": inside("bmatrix", rows=lines(" & ", r" \\[4pt] ")),
    "cr": inside("matrix", rows=lines(" & ", r" \cr ")),
    "hline": in_tabular(r"\hline", r"\hline"),
    "booktabs": in_tabular(r"\toprule", r"\bottomrule"),
    "bare": MATRIX,
    "bare, named": lines(" & ", r" \\ ", "J = "),
    "bare, of q": lines(" & ", r" \\ ", "J_v(q)= "),
    "phantom": each(lambda x: x if x[0] == "-" else rf"\phantom{{-}}{x}", inside("bmatrix")),
    "hphantom": each(lambda x: x if x[0] == "-" else rf"\hphantom{{-}}{x}", inside("bmatrix")),
    "num": each(lambda x: rf"\num{{{x}}}", inside("bmatrix")),
    "braced minus": over(inside("bmatrix"), ("-", "{-}")),
    "braced comma": over(inside("bmatrix"), (".", "{,}")),
    "dollars in cells": each(lambda x: f"${x}$", inside("tabular}{rrrr")),
    "times ten": each(lambda x: rf"{float(x) * 10:.5f} \times 10^{{-1}}", inside("bmatrix")),
    "dot ten": each(lambda x: rf"{float(x) * 100:.5f} \cdot 10^{{-2}}", inside("bmatrix")),
    "thin": over(inside("bmatrix"), (" & ", r"\, & \,")),
    "quad": over(inside("bmatrix"), (" & ", r" & \quad ")),
    "comment": inside("bmatrix", rows=lines(" & ", " \\\\ % a row\n", "\n")),
    "scriptsize": inside("bmatrix", r"{\scriptsize ", "}"),
    "displaystyle": inside("bmatrix", r"\displaystyle J = "),
    "round brackets": inside("bmatrix", "J = (\n", "\n)."),
    "square brackets": in_array("c", "[", "]"),
    "big brackets": inside("matrix", r"\bigl( ", r" \bigr)"),
    "bigger brackets": inside("matrix", r"\Bigg[", r"\Bigg]"),
    "about": inside("bmatrix", r"J \approx "),
    "tag": inside("bmatrix", "J = ", r" \quad \tag{3}"),
    "cline": inside("tabular}{cccc", rows=lines(" & ", r" \\ \cline{1-2} ")),
    "textbf": each(lambda x: rf"\textbf{{{x}}}", inside("bmatrix")),
    "decimal commas": over(inside("bmatrix"), COMMA),
}  # fmt: skip
CSV: dict[str, Template] = {
    "plain": lines(",", "\n"),
    "blanks": lines(", ", "\n"),
    "semicolons": lines(";", "\n"),
    "decimal commas": over(lines(";", "\n"), COMMA),
    "decimal commas, end": over(lines(";", ";\n", "", ";"), COMMA),
    "windows": lines(",", "\r\n", "", "\r\n"),
    "old Mac": lines(",", "\r"),
    "comma at the end": lines(",", ",\n", "", ","),
    "mark": lines(",", "\n", "\ufeff"),
    "heads": headed("\n", ",")(lines(",", "\n")),
    "heads, semicolons": headed("\n", ";")(over(lines(";", "\n"), COMMA)),
    "heads in quotes": headed("\n", ",", '"q{}"')(lines(",", "\n")),
    "comment": lines(",", "\n", "# rad and m\n"),
    "quotes": each(lambda x: f'"{x}"', lines(",", "\n")),
    "powers": each(power, lines(",", "\n")),
    "blank lines": lines(",", "\n\n"),
    "plus": each(lambda x: x if x[0] == "-" else f"+{x}", lines(",", "\n")),
    "blanks alone": PLAIN,
    "bars": lines("|", "\n"),
    "bars, outside": lines(" | ", "\n", "", "", "| ", " |"),
    "minus": over(lines(",", "\n"), ("-", "−")),
    "en dash": over(lines(",", "\n"), ("-", "–")),
    "fence": lines(",", "\n", "```\n", "\n```"),
    "no zero": over(each(lambda x: x.replace("-0.", "-.").lstrip("0") or "0", lines(",", "\n"))),
}  # fmt: skip
EXCEL: dict[str, Template] = {
    "decimal commas": over(TABS, COMMA),
    "heads": headed("\n", "\t")(TABS),
    "heads, theta": headed("\n", "\t", "θ{}")(over(TABS, COMMA)),
    "tab at the end": lines("\t", "\t\n", "", "\t"),
    "blanks around": lines(" \t ", "\n"),
    "powers": each(lambda x: power(x).upper(), TABS),
    "no-break": over(lines("\t\u00a0", "\n")),
    "plus": each(lambda x: x if x[0] == "-" else f"+{x}", TABS),
    "narrow no-break": lines("\t\u202f", "\n"),
    "formulas": each(lambda x: f"={x}", TABS),
    "Markdown": lines(" | ", " |\n| ", "| ", " |"),
    "array formula": lines(",", ";", "={", "}"),
    "Sheets array": lines(", ", "; ", "{", "}"),
    "comma and blank": over(lines("   ", "\n"), COMMA),
    "thousands": each(lambda x: f"{float(x):,.4f}", TABS),
    "thousands, commas": over(
        each(lambda x: f"{float(x):,.4f}", TABS), (",", " "), COMMA, (" ", ".")
    ),
    "bars": lines(" ", " |\n| ", "| ", " |"),
    "bars around": lines(" ", "\n", "|", "|"),
    "tall brackets": lines(" ", "⎞\n⎝", "⎛", "⎠"),
}  # fmt: skip
FORMATS = {"NumPy": NUMPY, "MATLAB": MATLAB, "LaTeX": LATEX, "CSV": CSV, "Excel": EXCEL}


def pastes(format_: str) -> Iterator[tuple[str, str, list[list[float]]]]:
    """Each paste of a format: its name, the text, and the numbers that went in."""
    for name, template in FORMATS[format_].items():
        for i, rows in enumerate(MATRICES):
            yield f"{name}, {i}", template(rows), [[float(x) for x in line] for line in rows]
