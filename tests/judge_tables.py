"""Tables for the page's judge and the checkers: the corpus's, the same arms in the other forms in
which people hold a table, and texts with slips of the finger.
"""

import math
import re
from collections.abc import Iterator

from helpers.arm import Arm
from tests import table_pastes
from tests.corpus import tables

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
    cell, row, start, end = [
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
    return start + row.join(cell.join(line) for line in lines) + end


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


def _lists(cells, rng):
    start, end = ("[", "]") if rng.random() < 0.6 else ("np.array([", "])")
    lists = {name: ", ".join(row[name] for row in cells) for name in _order(rng)}
    if rng.random() < 0.3:
        return "{" + ", ".join(f"'{name}': [{x}]" for name, x in lists.items()) + "}"
    return "\n".join(f"{name} = {start}{x}{end}" for name, x in lists.items())


def _dictionaries(cells, rng):
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
