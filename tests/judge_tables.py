"""Tables for the page's judge and the checkers: the corpus's, the same arms in the other forms in
which people hold a table, and texts with slips of the finger.
"""

import math
import re
from collections.abc import Iterator

from helpers.arm import Arm
from helpers.checks.tables_causes import references
from tests import pastes, table_pastes
from tests.corpus import tables
from tests.corpus.arms import KNOWN, random_machine
from tests.corpus.machine import Machine

NAMES = ("a", "alpha", "d", "theta")
HEADS = {
    "a": ["a", "a_i", "r", "a (m)"],
    "alpha": ["alpha", "α", r"$\alpha_i$", "twist"],
    "d": ["d", "d_i", "offset"],
    "theta": ["theta", "θ_i", "th", "q"],
}
SIGNS = "0123456789.,;:-+*/^()[]{}|&\\ \t\n'\"=_qdaθαπ°piLink√−²₁"


def corpus_questions(rng, count: int, arm_of) -> Iterator[tuple[Arm, dict]]:
    """The corpus's tables: some without their heads, with their order or units said, or within a
    tolerance.
    """
    for case in tables.cases(rng, count):
        options = {}
        if rng.random() < 0.5:
            options |= {"lengths": "m", "angles": "rad"}
        if rng.random() < 0.05:
            options["tolerance"] = float(rng.choice([0, 1e-4, 5e-3]))
        if rng.random() < 0.05:
            options["convention"] = "craig"
        typed = case["typed"]
        if case["form"] in ("csv", "columns") and rng.random() < 0.3:
            head, typed = typed.split("\n", 1)
            if rng.random() < 0.5:
                options["columns"] = head.replace("\t", " ")
        yield arm_of(case["machine"]), {"topic": "table", "typed": typed, "options": options}


def form_questions(rng, count: int, arm_of) -> Iterator[tuple[Arm, dict]]:
    """The corpus's arms, right and mistaken, in other forms, units and conventions; in some one
    length has a letter.
    """
    for case in tables.cases(rng, count):
        rows = tables.rechosen(case["rows"], rng) if rng.random() < 0.4 else case["rows"]
        if rng.random() < 0.25:
            rows = tables.to_craig(rows)
        cells = [_cells(i, row, rng) for i, row in enumerate(_in_units(rows, rng), 1)]
        options = {"convention": "craig"} if rng.random() < 0.2 else {}
        row, column = cells[int(rng.integers(len(cells)))], str(rng.choice(["a", "d"]))
        if rng.random() < 0.15 and row[column].replace(".", "").isdigit():
            options["values"] = {"h": float(row[column])}
            row[column] = "h"
        typed = FORMS[int(rng.integers(len(FORMS)))](cells, rng)
        yield arm_of(case["machine"]), {"topic": "table", "typed": typed, "options": options}


def slip_questions(rng, count: int, arm_of) -> Iterator[tuple[Arm, dict]]:
    """Texts with a few signs left out, doubled or hit by accident."""
    pastes = list(table_pastes.RIGHT.values())
    others = list(form_questions(rng, count, arm_of))
    for arm, question in others:
        text = question["typed"] if rng.random() < 0.5 else pastes[int(rng.integers(len(pastes)))]
        for _ in range(int(rng.integers(1, 4))):
            at = int(rng.integers(len(text)))
            sign = "" if rng.random() < 0.4 else SIGNS[int(rng.integers(len(SIGNS)))]
            text = text[:at] + sign + text[at + int(rng.random() < 0.6) :]
        yield arm, {**question, "typed": text}


H = math.pi / 2
LENGTHS = (0, 0, 0.3, 0.2, 0.5, -0.2, 0.055)
TWISTS = (0, 0, H, -H, 2 * H, 0.7, -1.1)
ANGLES = (0, 0, 0, H, -H, 2 * H, 0.4)


def geometry_questions(rng, count: int, arm_of) -> Iterator[tuple[Arm, dict]]:
    """Arms full of special cases, described by other frames, with entries mistaken, and rounded:
    by everything that a comparison of axes can meet, alone and together.
    """
    for _ in range(count):
        machine, rows = _described(rng, arm_of)
        for _ in range(int(rng.choice([0, 1, 2, 3, 5], p=[0.1, 0.35, 0.3, 0.15, 0.1]))):
            rows = CHANGES[int(rng.integers(len(CHANGES)))](list(rows), rng)
        options = {}
        if rng.random() < 0.12:
            options["convention"] = "craig"
            still = rows[0][0] == "F" and len(rows) > 1
            rows = tables.to_craig(rows)[int(still and rng.random() < 0.7) :]
        length, angle = rng.choice([1, 1, 1, 1000, 100]), rng.choice([1, 1, 180 / math.pi])
        if rng.random() < 0.4:
            options["lengths"] = {1: "m", 100: "cm", 1000: "mm"}[int(length)]
            options["angles"] = "rad" if angle == 1 else "deg"
        if rng.random() < 0.08:
            options["tolerance"] = float(rng.choice([0, 1e-3, 0.06]))
        places = rng.choice([1, 2, 3, 6], 2)
        cells = [
            _cells(i, _rounded((k, length * a, angle * al, length * d, angle * th), places), rng)
            for i, (k, a, al, d, th) in enumerate(rows, 1)
        ]
        typed = FORMS[int(rng.choice([0, 1, 2, 4, 6], p=[0.2, 0.3, 0.3, 0.1, 0.1]))](cells, rng)
        yield arm_of(machine), {"topic": "table", "typed": typed, "options": options}


def _described(rng, arm_of):
    """An arm and the rows of one that may be meant by it."""
    if rng.random() < 0.15:
        machine = KNOWN[str(rng.choice(["PANDA", "UR10E", "UR10E_HOMEWORK"]))]
        others = [rows for _, rows in references(arm_of(machine))]
        return machine, others[int(rng.integers(len(others)))]
    if rng.random() < 0.4:
        machine = random_machine(rng)
        return machine, machine.rows
    one = lambda of: float(rng.choice(of))  # noqa: E731
    rows = [
        (str(rng.choice(list("RRRPF"))), one(LENGTHS), one(TWISTS), one(LENGTHS), one(ANGLES))
        for _ in range(int(rng.integers(1, 6)))
    ]
    k = int(rng.integers(len(rows)))
    rows[k] = ("R", *rows[k][1:])
    if rng.random() < 0.1:  # a base of two rows, in which axis 1 may lean
        rows = [("F", *row[1:]) for row in rows[:2]] + rows
    return Machine(rows, "random"), rows


def _rounded(row, places):
    kind, a, alpha, d, theta = row
    (a, d), (alpha, theta) = (
        (round(float(x), int(n)) for x in two)
        for two, n in zip(((a, d), (alpha, theta)), places, strict=True)
    )
    return kind, a, alpha, d, theta


def _at(rows, rng):
    return int(rng.integers(len(rows)))


def _entry(rows, rng):
    """One entry turned, left out, put in, or another number, by a little or by much."""
    i, column = _at(rows, rng), str(rng.choice(NAMES))
    x = rows[i][1 + NAMES.index(column)]
    steps = (0.1, 0.011, 0.004, 1e-3, 4e-4, 2e-4, 3e-5, H, math.pi)
    step = float(rng.choice(steps)) * int(rng.choice([-1, 1]))
    return tables.changed(rows, i, **{column: float(rng.choice([-x, -x, 0, x + step, step - x]))})


def _turned(rows, rng):
    """A slide or a fixed row at another angle, which nothing makes up for."""
    held = [i for i, row in enumerate(rows) if row[0] != "R"]
    if not held:
        return _entry(rows, rng)
    i = held[_at(held, rng)]
    theta = rows[i][4]
    return tables.changed(rows, i, theta=float(rng.choice([-theta, 0, theta + H, theta - 0.3])))


def _frames(rows, rng):
    return tables.rechosen(rows, rng) if len(rows) > 1 else rows


def _whole(rows, rng):
    if len(rows) < 2:
        return rows
    made = [other for _, other in tables.whole(Machine(rows, "random"), rng)]
    return made[int(rng.integers(len(made)))]


def _signs(rows, rng):
    """Other frames, and one sign that is wrong in them."""
    rows = _frames(_frames(_frames(rows, rng), rng), rng)
    i, column = _at(rows, rng), str(rng.choice(["alpha", "a", "d"]))
    return tables.changed(rows, i, **{column: -rows[i][1 + NAMES.index(column)]})


def _free(rows, rng):
    """A step that is a free choice in most arms: the base's height, the tool's turn, a zero."""
    step = float(rng.choice([0.3, -0.2, H, 0.04]))
    i, column = [(0, "d"), (-1, "alpha"), (-1, "theta"), (_at(rows, rng), "theta")][
        int(rng.integers(4))
    ]
    i %= len(rows)
    return tables.changed(rows, i, **{column: rows[i][1 + NAMES.index(column)] + step})


def _over(rows, rng):
    """z_0 turned over, with its height or without."""
    kind, a, alpha, d, theta = rows[0]
    return [(kind, a, alpha + math.pi, float(rng.choice([-1, 1, 0])) * d, -theta), *rows[1:]]


def _along(rows, rng):
    """A step along parallel axes, taken back on the next."""
    i, step = _at(rows, rng), float(rng.choice([0.1, -0.3]))
    if i + 1 == len(rows) or abs(math.sin(rows[i][2])) > 1e-9:
        return rows
    back = -step * math.cos(rows[i][2])
    rows = tables.changed(rows, i, d=rows[i][3] + step)
    return tables.changed(rows, i + 1, d=rows[i + 1][3] + back)


def _other_rows(rows, rng):
    """A row that does not move, one row fewer, or a joint of another kind."""
    i, way = _at(rows, rng), rng.random()
    if way < 0.4:
        row = ("F", 0.0, 0.0, 0.0, 0.0) if rng.random() < 0.5 else ("F", *rows[i][1:])
        return [*rows[:i], row, *rows[i:]]
    if way < 0.6 and len(rows) > 1:
        return [*rows[:i], *rows[i + 1 :]]
    return tables.changed(rows, i, kind=str(rng.choice(list("RPF"))))


def _measured(rows, rng):
    """Lengths and angles off by what comes of rounding or measuring."""
    off = float(rng.choice([3e-6, 3e-4, 7e-4, 2e-3]))
    return [(kind, *(x + rng.uniform(-off, off) * (x != 0) for x in row)) for kind, *row in rows]


CHANGES = (
    *(_entry, _entry, _entry, _frames, _frames),
    *(_measured, _turned, _signs, _whole, _free, _over, _along, _other_rows),
)


def _in_units(rows, rng):
    length, angle = rng.choice([1, 1, 1, 100, 1000]), rng.choice([1, 1, 180 / math.pi])
    decimals = int(rng.choice([2, 4, 6]))
    other = float(
        rng.choice([1, 1, 1, 1, 0.001, 1000])
    )  # of the sizes in one column of the lengths
    return [
        (
            k,
            *(
                round(float(x), decimals)
                for x in (length * a, angle * al, length * other * d, angle * th)
            ),
        )
        for k, a, al, d, th in rows
    ]


def _cells(i, row, rng):
    """The texts of a row by name, the variable where it belongs."""
    kind, *numbers = row
    cells = {name: f"{x:g}" for name, x in zip(NAMES, numbers, strict=True)}
    mover = {"R": "theta", "P": "d"}.get(kind)
    if mover is None:
        return cells
    variable = str(rng.choice([f"q{i}", f"q_{i}", f"theta{i}", f"θ{i}", f"-q{i}", f"q_{{{i}}}^*"]))
    still = cells[mover]
    cells[mover] = variable if still == "0" else f"{variable} + {still}".replace("+ -", "- ")
    return cells


def _plain(cells, names):
    return [[row[name] for name in names] for row in cells]


def _order(rng):
    return [str(name) for name in rng.permutation(NAMES)]


def _joined(cells, rng):
    form = [
        (", ", "], [", "[[", "]]"),
        (", ", "), (", "((", "))"),
        (" ", "; ", "DH = [", "];"),
        (",", "\n", "", ""),
        (";", "\n", "", ""),
        ("\t", "\r\n", "", ""),
        (" & ", r" \\ ", r"\begin{bmatrix} ", r" \end{bmatrix}"),
        (" | ", " |\n| ", "| ", " |"),
    ][int(rng.integers(8))]
    lines = [[x.replace(" ", "") for x in line] for line in _plain(cells, _order(rng))]
    return pastes.lines(*form)(lines)


def _headed(cells, rng):
    order = _order(rng)
    heads = [str(rng.choice(HEADS[name])) for name in order]
    lines = _plain(cells, order)
    if rng.random() < 0.1:
        k, n = order.index("alpha"), order.index("theta")
        heads[k], heads[n] = heads[n], heads[k]
    if rng.random() < 0.4:
        heads, lines = ["i", *heads], [[str(i), *line] for i, line in enumerate(lines, 1)]
    if rng.random() < 0.2:
        heads = [h.replace("_i", "") + ("_{i-1}" if h in ("a", "alpha") else "") for h in heads]
    if rng.random() < 0.2:
        heads = [h + (" (deg)" if h in ("alpha", "theta") else " (mm)") for h in heads]
    sign = str(rng.choice([",", "\t", " | ", "  "]))
    if sign.isspace() and rng.random() < 0.5:
        lines = [
            [re.sub(r"^(θ|q_?)(\d)$", r"\1\2*", x.replace(" ", "")) for x in row] for row in lines
        ]
    return "\n".join(sign.join(line) for line in [heads, *lines])


def _links(cells, rng):
    made = []
    for i, row in enumerate(cells, 1):
        still = {k: x for k, x in row.items() if "q" not in x and "θ" not in x and "th" not in x}
        named = ", ".join(f"'{k}', {x}" for k, x in still.items())
        vector = " ".join(still.get(k, "0") for k in ("theta", "d", "a", "alpha"))
        slides = "theta" in still and "d" not in still
        python = ", ".join(f"{k}={x}" for k, x in still.items())
        kind = "Prismatic" if slides else "Revolute"
        made.append(
            [
                f"L({i}) = Link({named});",
                f"L{i} = Link([{vector} {int(slides)}]);",
                f"{kind}DH({python}),",
            ][int(rng.integers(3))]
        )
    return "\n".join(made)


def _in_python(cells):
    """Variables without LaTeX's braces, which nobody types among Python's."""
    return [{k: re.sub(r"_\{(\d)\}\^\*", r"_\1", x) for k, x in row.items()} for row in cells]


def _lists(cells, rng):
    cells = _in_python(cells)
    start, end = ("[", "]") if rng.random() < 0.6 else ("np.array([", "])")
    lists = {name: ", ".join(row[name] for row in cells) for name in _order(rng)}
    if rng.random() < 0.3:
        return "{" + ", ".join(f"'{name}': [{x}]" for name, x in lists.items()) + "}"
    return "\n".join(f"{name} = {start}{x}{end}" for name, x in lists.items())


def _dictionaries(cells, rng):
    cells = _in_python(cells)
    if rng.random() < 0.5:
        rows = ["{" + ", ".join(f"'{k}': {x}" for k, x in row.items()) + "}" for row in cells]
        return "[" + ",\n ".join(rows) + "]"
    first = int(rng.random() < 0.7)
    pairs = [
        f"{k}{i}: {x}"
        for i, row in enumerate(cells, first)
        for k, x in row.items()
        if x != "0" or rng.random() < 0.5
    ]
    return "{" + ", ".join(pairs) + "}"


def _matrices(cells, rng):
    made = []
    for row in cells:
        c, s = (f"{f}({row['theta']})".replace("^*", "") for f in ("cos", "sin"))
        ca, sa = (f"{f}({row['alpha']})" for f in ("cos", "sin"))
        made.append(
            f"[[{c}, -{s}*{ca}, {s}*{sa}, {row['a']}*{c}], "
            f"[{s}, {c}*{ca}, -{c}*{sa}, {row['a']}*{s}], "
            f"[0, {sa}, {ca}, {row['d']}], [0, 0, 0, 1]]"
        )
    return "[" + ", ".join(made) + "]"


FORMS = (_joined, _headed, _headed, _links, _lists, _dictionaries, _matrices)
