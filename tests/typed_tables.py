"""Make random tables and formulas in the forms in which people type them, with their values.

Each cell is compared, with joints of any kind and any unit; the tables of tests/clothed are
compared by their verdict.
"""

import math
import re
from fractions import Fraction

from tests import pastes

NAMES = ("a", "alpha", "d", "theta")
HEADS = {
    "a": ["a", "a_i", "$a_i$", "a_{i}", "r", "Link length", "A", "*a*", "a_n", "r_i"],
    "alpha": ["alpha", "α", r"$\alpha_i$", "twist", "Link Twist", "α_i", "al", "alpha_k", "αi"],
    "d": ["d", "d_i", "$d_{i}$", "offset", "link offset", "D", "d_j", "**d**"],
    "theta": ["theta", "θ_i", "th", "q", r"$\theta_i$", "θ", "Joint angle", "q_i^*", "thetai"],
}
NAMES_OF = {"a": ["a", "A", "r"], "alpha": ["alpha", "Alpha", "al"], "d": ["d", "D"],
            "theta": ["theta", "Theta", "th"]}  # fmt: skip
CRAIG = {"a": ["a_{i-1}", "$a_{i-1}$", "a(i-1)", "a_i-1", "a i-1"],
         "alpha": ["alpha_{i-1}", r"$\alpha_{i-1}$", "α(i-1)", "α_{i - 1}", "αi-1"]}  # fmt: skip
COUNTED = ["i", "Link", "joint", "#", "n", "Joint i", "k", "Frame", "no.", "row"]
NUMBERED = ["{}", "{}.", "Link {}", "joint {}", "J{}", "L{}", "i={}", "Joint_{}"]
UNITS = {"m": 1, "cm": 100, "mm": 1000}
ORDERS = ["theta d a alpha", "a alpha d theta", "alpha a d theta", "d theta a alpha"]
VARIABLES = ["q{}", "q_{}", "theta{}", "θ_{}", "th{}", r"\theta_{{{}}}", "q_{{{}}}", "t{}",
             "θ{}(t)", r"\phi_{}", "-q{}", "−θ_{}", "q{}^*", "θ_{}*", "q{}°"]  # fmt: skip
ALONE = ["*", "-", "?", "q", "θ", "var", "—", "variable", "θ*"]


def angle(k: int, unit: str, rng) -> str:
    """k times 15 degrees."""
    if unit == "deg":
        return f"{15 * k}"
    if unit == "sign":
        return str(rng.choice(["{}°", "{} deg", r"${}^\circ$", "{}º", r"{}^{{\circ}}"])).format(
            15 * k
        )
    if unit == "rad" or not k:
        return f"{k * math.pi / 12:.6g}"
    part = Fraction(k, 12)
    sign, top, low = "-" * (k < 0), abs(part.numerator), part.denominator
    pi = str(rng.choice(["pi", "π", "np.pi", r"\pi ", "math.pi"]))
    times = pi if top == 1 else f"{top}*{pi}"
    return sign + (times if low == 1 else f"{times}/{low}")


def arm(rng) -> list[tuple]:
    """Rows in m and multiples of 15 degrees; the first one moves."""
    made = []
    for i in range(int(rng.integers(2, 6))):
        kind = str(rng.choice(list("RRRRRPPF"))) if i else str(rng.choice(["R", "R", "P"]))
        a, d = (round(float(x), 3) * (rng.random() < 0.6) for x in rng.uniform(0.02, 1.9, 2))
        alpha, theta = (
            int(rng.choice([0, 6, -6, 12, *rng.integers(-24, 25, 2)])) for _ in range(2)
        )
        made.append((kind, a, alpha, d, theta if kind != "R" or rng.random() < 0.3 else 0))
    return made


def made(rng) -> tuple[str, dict, list, bool]:
    """A table: as typed, what is said of it, the rows that went in, and whether its columns can be
    told from one another."""
    rows = arm(rng)
    length, turn = str(rng.choice(list(UNITS))), str(rng.choice(["rad", "deg", "pi", "sign"]))
    sizes = [abs(x) * UNITS[length] for r in rows for x in (r[1], r[3])]
    largest = max(abs(15 * k) for r in rows for k in (r[2], r[4]))
    guessed = {"m": max(sizes) < 10, "mm": max(sizes) >= 10}.get(length, False)
    plain_angles = turn in ("pi", "sign") or (largest > 360 if turn == "rad" else largest > 6)
    layout = str(rng.choice(list(LAYOUTS)))
    headed, craig = layout in HEADED, rng.random() < 0.15
    heads = {n: str(rng.choice((NAMES_OF if layout in NAMED else HEADS)[n])) for n in NAMES}
    options = {"convention": "craig"} if craig and not headed else {}
    if craig and headed:
        heads |= {name: str(rng.choice(CRAIG[name])) for name in CRAIG}
    said = headed and (not guessed or rng.random() < 0.3), headed and rng.random() < 0.3
    if said[0]:
        shape = "({})" if length in ("m", "in") else str(rng.choice(["({})", "[{}]", "in {}"]))
        heads |= {name: f"{heads[name]} {shape.format(length)}" for name in ("a", "d")}
    elif not guessed:
        options["lengths"] = length
    if said[1] and turn in ("deg", "rad"):
        shape = str(rng.choice([" ({})", " [{}]", " in {}", "({})"]))
        unit = str(
            rng.choice(["deg", "degrees", "°", "Deg"] if turn == "deg" else ["rad", "radians"])
        )
        heads |= {name: heads[name] + shape.format(unit) for name in ("alpha", "theta")}
    elif not plain_angles or (turn == "rad" and largest > 360):
        options["angles"] = {"rad": "rad", "deg": "deg"}[turn]
    typed_rows = modified(rows) if craig else rows
    cells = [cell_of(i, row, length, turn, rng) for i, row in enumerate(typed_rows, 1)]
    sure = layout != "bracketed"
    order = [*rng.permutation(NAMES)] if sure else str(rng.choice(ORDERS)).split()
    if not sure and rng.random() < 0.6:
        options["columns"] = str(rng.choice([" ", ", ", "|"])).join(order)
    lines = [[c[n] for n in order] for c in cells]
    text = LAYOUTS[layout]([heads[n] for n in order], lines, rng)
    wanted = [(k, a, al * math.pi / 12, d, th * math.pi / 12) for k, a, al, d, th in rows]
    return text, options, wanted, sure or "columns" in options


def modified(rows: list[tuple]) -> list[tuple]:
    """The rows in Craig's convention; a last one is the tool's."""
    before = [("", 0.0, 0, 0, 0), *rows]
    after = [*rows, ("F", 0, 0, 0.0, 0)]
    return [(k, b[1], b[2], d, th) for b, (k, _, _, d, th) in zip(before, after, strict=True)]


def cell_of(i: int, row: tuple, length: str, turn: str, rng) -> dict[str, str]:
    kind, a, alpha, d, theta = row
    cells = {n: f"{x * UNITS[length]:.6g}" for n, x in (("a", a), ("d", d))}
    cells |= {n: angle(k, turn, rng) for n, k in (("alpha", alpha), ("theta", theta))}
    if mover := {"R": "theta", "P": "d"}.get(kind):
        still, zero = cells[mover], not row[3 if kind == "P" else 4]
        name = str(rng.choice(VARIABLES[: 14 + (kind == "R") if zero else 10])).format(i)
        first, mark = (name, still) if rng.random() < 0.7 else (still, name)
        joined = f"{first} + {mark}".replace("+ -", "- ")
        cells[mover] = (str(rng.choice(ALONE)) if rng.random() < 0.1 else name) if zero else joined
    return cells


def tight(lines):
    return [[x.replace(" ", "") if x[-1:] != "*" else x for x in line] for line in lines]


def spaced(lines, rng):
    """Cells whose blanks stand beside a sign or a unit, or nowhere."""
    return lines if rng.random() < 0.5 else tight(lines)


def counted(heads, lines, rng):
    """With a column that numbers the rows, under a head of its own, or either alone."""
    if rng.random() < 0.5:
        return heads, lines
    label, head = str(rng.choice(NUMBERED)), str(rng.choice(COUNTED))
    numbered = any(line[0] in ("0", "1", "*") for line in lines[:1]) or rng.random() < 0.8
    if numbered:
        lines = [[label.format(i), *line] for i, line in enumerate(lines, 1)]
    return [head, *heads], lines


def markdown(heads, lines, rng):
    heads, lines = counted(heads, lines, rng)
    rule = str(rng.choice(["---", ":-:", "--:", "-"]))
    sign = str(rng.choice([" | ", "|"]))
    rows = [heads, [rule] * len(heads), *lines]
    start, end = ("| ", " |") if rng.random() < 0.8 else ("", "")
    return "\n".join(start + sign.join(row) + end for row in rows)


def sheet(heads, lines, rng):
    heads, lines = counted(heads, tight(lines), rng)
    sign = str(rng.choice(["\t", ";", ",", "\t "]))
    if sign == "\t" and rng.random() < 0.3:
        lines = [[x if x != "0" else "" for x in line[:-1]] + line[-1:] for line in lines]
    rows = [sign.join(row) for row in (heads, *lines)]
    if sign != "," and rng.random() < 0.5:
        rows[1:] = [re.sub(r"(\d)\.(\d)", r"\1,\2", row.replace("(t)", "")) for row in rows[1:]]
    return str(rng.choice(["\n", "\r\n"])).join(rows)


def printed(heads, lines, rng):
    """As pandas prints a data frame, and as people line columns up."""
    heads = [re.sub(r" ?in (.*)", r"(\1)", h).replace(" (", "(").replace(" [", "[") for h in heads]
    heads = [re.sub(r" (?=[-1])", "", re.sub(r"\^?\*", "", h)).replace(" ", "_") for h in heads]
    lines = [
        [re.sub(r"\^\*|^[-*]$", "" if "^" in x else "q", x) for x in row] for row in tight(lines)
    ]
    first = int(rng.random() < 0.5)
    if rng.random() < 0.6:
        heads, lines = ["", *heads], [[str(i), *x] for i, x in enumerate(lines, first)]
    widths = [max(map(len, column)) + 2 for column in zip(heads, *lines, strict=True)]
    rows = [
        "".join(f"{x:>{w}}" for x, w in zip(row, widths, strict=True)) for row in (heads, *lines)
    ]
    return "\n".join(rows)


def tabular(heads, lines, rng):
    heads, lines = counted(heads, lines, rng)
    rows = [" & ".join(f"${x.strip('$')}$" for x in line) for line in lines]
    rule = str(rng.choice([r"\hline ", "", r"\midrule "]))
    inner = (r" \\ " + rule).join([" & ".join(heads).replace("#", "i"), *rows])
    kind = str(rng.choice(["tabular", "array"]))
    return rf"\begin{{{kind}}}{{|{'c|' * len(heads)}}} {rule}{inner} \\ {rule}\end{{{kind}}}"


def drawn(heads, lines, rng):
    rows = ["│ " + " │ ".join(row) + " │" for row in (heads, *tight(lines))]
    return "\n".join(["a robot", "┌───┐", rows[0], "├─┼─┤", *rows[1:], "└───┘", "tool", "│ 1 │"])


def bracketed(heads, lines, rng):
    form = [
        (", ", "], [", "[[", "]]"),
        (", ", "), (", "[(", ")]"),
        (" ", "; ", "DH = [", "];"),
        (" ", "\n", "[", "]"),
        (", ", "],\n       [", "array([[", "]])"),
        (" & ", r" \\ ", r"\begin{pmatrix}", r"\end{pmatrix}"),
        (",", "\n", "", ""),
    ][int(rng.integers(7))]
    lines = [["θ*" if x in "*-—" else x for x in line] for line in lines]
    if rng.random() < 0.3:
        lines = [[str(rng.choice(["{}", "L{}"])).format(i), *x] for i, x in enumerate(lines, 1)]
    return pastes.lines(*form)(spaced(lines, rng))


def of_lists(names, lines, rng):
    start, end = [("[", "]"), ("np.array([", "])"), ("{", "}")][int(rng.integers(3))]
    lines = [[x if start != "{" else re.sub("[{}]", "", x) for x in line] for line in lines]
    columns = zip(names, zip(*lines, strict=True), strict=True)
    return "\n".join(f"{name} = {start}{', '.join(column)}{end}" for name, column in columns)


def of_records(names, lines, rng):
    start, sign, end = [("{'", "': ", "}"), ("dict(", "=", ")"), ('{"', '": ', "}")][
        int(rng.integers(3))
    ]
    between = ", " + start[1:] * (start[0] == "{")
    rows = [between.join(f"{n}{sign}{x}" for n, x in zip(names, row, strict=True)) for row in lines]
    return "[" + ",\n ".join(start + row + end for row in rows) + "]"


HEADED = {"markdown": markdown, "sheet": sheet, "printed": printed, "tabular": tabular,
          "drawn": drawn}  # fmt: skip
NAMED = {"lists": of_lists, "records": of_records}
LAYOUTS = {**HEADED, **NAMED, "bracketed": bracketed}


# Formulas with their values


def formula_of(rng, depth: int = 3) -> tuple[str, float]:
    """A formula in x = 0.7 and q_1 = 0.4, and its value."""
    if not depth or rng.random() < 0.2:
        x = round(float(rng.uniform(0.1, 9)), int(rng.integers(4)))
        leaves = [(f"{x:g}", x), ("x", 0.7), ("q_1", 0.4), (r"q_{1}", 0.4), ("π", math.pi)]
        leaves += [(f"{x:.3e}", float(f"{x:.3e}")), ("√(2)", 2**0.5), ("np.pi", math.pi)]
        return leaves[int(rng.integers(len(leaves)))]
    (s, u), (t, v) = formula_of(rng, depth - 1), formula_of(rng, depth - 1)
    forms = [
        (f"({s}) + ({t}) - x + 3x", u + v + 1.4),
        (f"({s}) - ({t})", u - v),
        (f"({s})({t})", u * v),
        (f"2({t})", 2 * v),
        (f"({s}) · ({t})", u * v),
        (f"({s}).*({t}).^1", u * v),
        (rf"\frac{{{u:.4f}}}{{2.5}} \cdot ({t})", float(f"{u:.4f}") / 2.5 * v),
        (rf"{v:.4f}\cdot2\quad({s})", float(f"{v:.4f}") * 2 * u),
        (f"({s})**2", u**2),
        (f"({s})^2", u**2),
        (f"-({s})²", -(u**2)),
        (f"2^-sin({t})", 2 ** -math.sin(v)),
        (f"sin({s})", math.sin(u)),
        (rf"\cos\left({s}\right)", math.cos(u)),
        (f"sin -({s}) cos x", -math.sin(u) * math.cos(0.7)),
        (f"√({u * u:.4f}) ({t})", math.sqrt(float(f"{u * u:.4f}")) * v),
        (f"({s})/8 - ({t})/3/2", u / 8 - v / 6),
        (f"np.deg2rad({s}) - +({t})", math.radians(u) - v),
    ]  # fmt: skip
    return forms[int(rng.integers(len(forms)))]
