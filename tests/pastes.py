"""Write matrices as programs and people do, for tests that read them back.

NumPy, MATLAB, LaTeX, CSV files and spreadsheets have their ways to lay rows out, to spell a number
and to set a matrix in text, and any of them goes with any other. tests/cases.json has no room for
these combinations, and tests/clothed draws only answers to the questions of the form.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

Rows = list[list[str]]
Cell = Callable[[str], str]

# The elbow arm's Jacobian, a pose, a rotation of integers, a row, and a column of mixed sizes.
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


@dataclass(frozen=True)
class Program:
    """Layouts: what parts cells and rows, what stands around all and around each row. Spellings of
    a number. Surroundings: what stands before and after the matrix."""

    layouts: list[tuple[str, ...]]
    spellings: list[Cell]
    around: list[tuple[str, str]]

    def pastes(self, rng) -> Iterator[tuple[str, list[list[float]]]]:
        """Each layout with each spelling in any surroundings, and each of the surroundings."""
        some = [(a, b, None) for a in self.layouts for b in self.spellings]
        for layout, spell, around in some + [(None, None, x) for x in self.around]:
            layout, spell = layout or rng.choice(self.layouts), spell or rng.choice(self.spellings)
            before, after = around or rng.choice(self.around)
            rows = rng.choice(MATRICES)
            text = lines(*layout)([[spell(x) for x in row] for row in rows])
            yield before + text + after, [[float(x) for x in row] for row in rows]


def lines(cell: str, row: str, start: str = "", end: str = "", before: str = "", after: str = ""):
    """Rows as text: cells and rows parted by these, all in `start` and `end`, a row in `before` and
    `after`."""
    return lambda rows: start + row.join(before + cell.join(r) + after for r in rows) + end


def dotted(x: str) -> str:
    """As NumPy prints a whole number: `1.`."""
    return f"{x}." if "." not in x else x.rstrip("0")


def power(x: str) -> str:
    return f"{float(x):.8e}"


def plus(x: str) -> str:
    return x if x[0] == "-" else f"+{x}"


def with_minus(sign: str) -> Cell:
    return lambda x: x.replace("-", sign)


def within(start: str, end: str = "") -> Cell:
    return lambda x: f"{start}{x}{end}"


def scaled(by: float, end: str) -> Cell:
    return lambda x: f"{float(x) / by:.7f}{end}"


NUMPY = Program(
    [
        (", ", "], [", "[[", "]]"),
        (" ", "]\n [", "[[", "]]"),
        (", ", "],\n       [", "[[", "]]"),
        (", ", "],\n    [", "[\n    [", "],\n]"),
        (", ", "],  # a row\n [", "[[", "]]"),
        ("\u00a0\u00a0", "]\n [", "[[", "]]"),
    ],
    [
        str, dotted, power, with_minus("−"), "{:>9}".format, within("", " rad"),
        within("np.float64(", ")"),
    ],
    [
        ("", ""), ("array(", ", dtype=float32)"), ("J = np.array(", ")."), ("np.matrix(", ")"),
        ("tensor(", ")"), (">>> print(J)\n", ""), (">>> J\narray(", ")"),
        ("Out[12]: \narray(", ")"), ("J: ", ""), ("# the Jacobian\n", ""),
        ("np.round(np.array(", "), 4)"), ("```python\nJ = np.array(", ")\n```"),
    ],
)  # fmt: skip
MATLAB = Program(
    [
        (" ", "; ", "[", "]"),
        (", ", ";\n ", "[", "]"),
        ("   ", "\n", "[\n", "\n]"),
        (", ", "; ...\n  ", "[ ...\n  ", " ]"),
        (" ", "; % a row\n     ", "[", "]"),
        (" ", " % a row\n     ", "[", " % the last\n]"),
        ("\t", ";\r\n\t", "[\t", "\t]"),
        (", ", "]\n[", "[", "]"),
    ],
    [str, lambda x: f"{float(x):.15f}", power],
    [("", ""), ("J = ", ";"), ("J =\n\n", "\n"), ("sym(", ")"), ("J = ", ",")],
)
PRINTED = Program(
    [("", "\n"), ("  ", "\n   ", "   ")],
    ["{:>10}".format, "{:>12}".format],
    [("J =\n\n", ""), ("ans =\n\n", "\n\n")],
)
IN_LATEX = [
    (r"\begin{bmatrix} ", r" \end{bmatrix}"), (r"\begin{vmatrix} ", r" \end{vmatrix}"),
    (r"\begin{smallmatrix} ", r" \end{smallmatrix}"),
    (r"\begin{bmatrix*}[r] ", r" \end{bmatrix*}"),
    (r"\left[ \begin{matrix} ", r" \end{matrix} \right]"),
    (r"\left[ \begin{array}{cccc} ", r" \end{array} \right]"),
    (r"\bigl( \begin{matrix} ", r" \end{matrix} \bigr)"),
    (r"\begin{tabular}{rrrr} \hline ", r" \\ \hline \end{tabular}"),
    (r"\begin{tabular}{rrrr} \toprule ", r" \\ \bottomrule \end{tabular}"),
]  # fmt: skip
SAID_IN_LATEX = [
    ("", ""), ("J(q) = ", "."), (r"J = \frac{\partial p}{\partial q} = ", ""), ("J_v = ", ""),
    ("{}^0J_6 = ", ""), ("$$", "$$"), (r"\[ J = ", r" \]"), (r"J \approx ", ""),
    ("\\begin{equation}\\label{eq:J}\nJ = ", "\n\\end{equation}"),
    (r"\begin{align} J &= ", r" \end{align}"), (r"{\scriptsize ", "}"),
    (r"\displaystyle J = ", ""), ("J = (\n", "\n)."), ("J = ", r" \quad \tag{3}"),
]  # fmt: skip
LATEX = Program(
    [
        (" & ", r" \\ "),
        ("&", r"\\"),
        (r"\, & \,", r" \\[4pt] "),
        (" & ", " \\\\ % a row\n"),
        (" & ", r" \\ \cline{1-2} "),
    ],
    [
        str, within("$", "$"), within(r"\textbf{", "}"), lambda x: x.replace(".", "{,}"),
        scaled(0.1, r" \times 10^{-1}"), scaled(0.01, r" \cdot 10^{-2}"),
    ],
    [(b + start, end + a) for start, end in IN_LATEX for b, a in SAID_IN_LATEX],
)  # fmt: skip
CSV = Program(
    [
        (",", "\n"),
        (", ", "\r\n"),
        (";", ";\n", "", ";"),
        (",", "\r"),
        (",", "\n\n"),
        ("|", "\n"),
        (" | ", "\n", "", "", "| ", " |"),
        ("\t", "\t\n", "", "\t"),
        (" \t ", "\n"),
        ("\t\u202f", "\n"),
        ("  ", "\n"),
        (", ", "; ", "={", "}"),
        ("  ", "⎞\n⎝", "⎛", "⎠"),
    ],
    [str, power, plus, with_minus("−"), with_minus("–"), lambda x: re.sub(r"\b0\.", ".", x)],
    [("", ""), ("\ufeff", "\n"), ("# rad and m\n", ""), ("```\n", "\n```")],
)
# What goes with little else.
COMMAS = Program(
    [(";", "\n"), (";", ";\n", "", ";"), ("\t", "\n"), ("   ", "\n")],
    [lambda x: x.replace(".", ","), lambda x: plus(x).replace(".", ",")],
    [("", ""), ("\ufeff", "\r\n")],
)
BY_HAND = Program(
    [
        (" ", "\n"),
        (" & ", r" \\ ", "J_v(q)= ", r" \\"),
        (", ", "), (", "((", "))"),
        (", ", "],\n [", "([[", "]])"),
        (" ", " |\n| ", "| ", " |"),
        (" ", "\n", "|", "|"),
        (" ", "  # a row\n", "", " # the last"),
    ],
    [str, with_minus("−")],
    [("", "")],
)
QUOTED = Program(
    [(", ", "], [", "[[", "]]"), (",", "\n")],
    [within("“", "”"), within("‘", "’"), within('"', '"')],
    [("", "")],
)
PROGRAMS = {
    "NumPy": NUMPY, "MATLAB": MATLAB, "printed": PRINTED, "LaTeX": LATEX, "CSV": CSV,
    "decimal commas": COMMAS, "by hand": BY_HAND, "quoted": QUOTED,
}  # fmt: skip
