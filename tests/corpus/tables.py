"""Right tables in other frames and mistaken ones, each typed by rows with their heads."""

import math

from tests.corpus.arms import KNOWN, some_machine

H = math.pi / 2
NAMES = ("a", "alpha", "d", "theta")


def flip_x(rows, i):
    """x of frame i + 1 turned round."""
    (k, a, al, d, th), (k2, a2, al2, d2, th2) = rows[i], rows[i + 1]
    return [
        *rows[:i],
        (k, -a, -al, d, th + math.pi),
        (k2, a2, al2, d2, th2 + math.pi),
        *rows[i + 2 :],
    ]


def flip_z(rows, i):
    """z of frame i + 1 turned round: the joint on it counts backwards."""
    (k, a, al, d, th), (k2, a2, al2, d2, th2) = rows[i], rows[i + 1]
    return [
        *rows[:i],
        (k, a, al + math.pi, d, th),
        (k2, a2, al2 + math.pi, -d2, -th2),
        *rows[i + 2 :],
    ]


def shift_zero(rows, i, by):
    kind, a, al, d, th = rows[i]
    if kind != "R":
        return rows
    return [*rows[:i], (kind, a, al, d, th + by), *rows[i + 1 :]]


def rechosen(rows, rng):
    """The same arm with other choices of frames; z_0 and the tool's frame stay."""
    for _ in range(int(rng.integers(1, 4))):
        i = int(rng.integers(len(rows) - 1))
        way = rng.integers(3)
        rows = (
            flip_x(rows, i)
            if way == 0
            else flip_z(rows, i)
            if way == 1
            else shift_zero(rows, i, 0.3)
        )
    return rows


def changed(rows, i, **entries):
    row = dict(zip(("kind", *NAMES), rows[i], strict=True))
    return [*rows[:i], tuple({**row, **entries}.values()), *rows[i + 1 :]]


def swapped(rows, one, other):
    found = []
    for row in rows:
        held = dict(zip(("kind", *NAMES), row, strict=True))
        held[one], held[other] = held[other], held[one]
        found.append(tuple(held.values()))
    return found


def to_craig(rows):
    """Craig's rows hold the a and alpha of the row before; a last fixed row keeps the rest."""
    before = [(None, 0, 0, None, None), *rows]
    found = [(r[0], b[1], b[2], r[3], r[4]) for r, b in zip(rows, before, strict=False)]
    last = rows[-1]
    return [*found, ("F", last[1], last[2], 0, 0)] if last[1] or last[2] else found


def whole(m, rng):
    """Mistakes of the whole table."""
    rows = m.rows
    yield "table.alpha and theta", swapped(rows, "alpha", "theta")
    yield "table.a and d", swapped(rows, "a", "d")
    yield "table.craig", to_craig(rows)
    yield "table.millimetres", [(k, 1000 * a, al, 1000 * d, th) for k, a, al, d, th in rows]
    yield (
        "table.degrees",
        [(k, a, math.degrees(al), d, math.degrees(th)) for k, a, al, d, th in rows],
    )
    yield "table.rows reversed", rows[::-1]
    i, j = sorted(int(x) for x in rng.choice(len(rows), 2, replace=False))
    order = list(range(len(rows)))
    order[i], order[j] = j, i
    yield f"table.rows exchanged:{i + 1}:{j + 1}", [rows[k] for k in order]
    yield "table.twists", [(k, a, -al, d, th) for k, a, al, d, th in rows]
    if m.name in ("PANDA", "UR10E_HOMEWORK", "PANDA.lock(3)"):
        yield "table.pen", changed(rows, len(rows) - 1, d=-0.107 if m.name[0] == "P" else 0.0922)


def single(m, rng):
    """Mistakes of one entry."""
    i = int(rng.integers(len(m.rows)))
    kind, a, alpha, d, _ = m.rows[i]
    if abs(math.sin(alpha)) > 0.1:
        yield f"table.twist:{i + 1}", changed(m.rows, i, alpha=-alpha)
        yield f"table.no twist:{i + 1}", changed(m.rows, i, alpha=0)
    for name, x in (("a", a), ("d", d)):
        if x and not (name == "d" and kind == "P"):
            yield f"table.sign:{name}:{i + 1}", changed(m.rows, i, **{name: -x})
            yield f"table.missing:{name}:{i + 1}", changed(m.rows, i, **{name: 0})
            off = round(x + float(rng.choice([-1, 1])) * float(rng.uniform(0.004, 0.03)), 4)
            yield f"table.number:{name}:{i + 1}", changed(m.rows, i, **{name: off})


WORDS = {0: "0", 1: "pi/2", -1: "-pi/2", 2: "pi", -2: "-pi"}


def _angle(x, d, exact, degrees):
    if degrees:
        return f"{x:.4f}".rstrip("0").rstrip(".")
    turns = round(x / H)
    if abs(x - turns * H) < 1e-9 and (exact or turns == 0):
        return WORDS.get(turns, f"{turns}*pi/2")
    return f"{x:.{max(d, 3)}f}" if abs(x - turns * H) > 1e-9 else f"{x:.{d}f}"


def _length(x):
    return f"{round(x, 6):.6f}".rstrip("0").rstrip(".") or "0"


def typed(rows, rng, d, degrees=False, heads=False):
    """A table with heads as text; the variable stands in theta or d."""
    exact = rng.random() < 0.6
    cells = []
    for i, (kind, a, al, dd, th) in enumerate(rows, 1):
        theta, offset = _angle(th, d, exact, degrees), _length(dd)
        if kind == "R":
            theta = f"q{i}" + (
                "" if th == 0 else f" + {theta}" if theta[0] != "-" else f" - {theta[1:]}"
            )
        if kind == "P":
            offset = f"q{i}" + (
                "" if dd == 0 else f" + {offset}" if offset[0] != "-" else f" - {offset[1:]}"
            )
        cells.append(
            dict(
                zip(NAMES, (_length(a), _angle(al, d, exact, degrees), offset, theta), strict=True)
            )
        )
    order = [list(NAMES), ["theta", "d", "a", "alpha"], ["alpha", "a", "theta", "d"]][
        int(rng.integers(3))
    ]
    lines = [[row[n] for n in order] for row in cells]
    forms = ["markdown", "latex", "csv", "columns", "bare", "bare csv", "list", "matlab"]
    share = 0.25 if heads else 0.17
    form = str(rng.choice(forms, p=[share] * 4 + [0.25 - share] * 4))
    if form == "bare":
        return "\n".join("   ".join(x.replace(" ", "") for x in row) for row in lines), form
    if form == "bare csv":
        return "\n".join(",".join(row) for row in lines), form
    if form == "list":
        quoted = [[x if _is_float(x) else f"'{x}'" for x in row] for row in lines]
        return "[" + ",\n ".join("[" + ", ".join(row) + "]" for row in quoted) + "]", form
    if form == "matlab":
        return "[" + ";\n".join(" ".join(x.replace(" ", "") for x in r) for r in lines) + "]", form
    if form == "markdown":
        head = "| " + " | ".join(order) + " |\n|" + "--|" * 4 + "\n"
        return head + "\n".join("| " + " | ".join(row) + " |" for row in lines), form
    if form == "latex":
        body = [order, *lines]
        return r"\begin{array}{cccc} " + r" \\ ".join(
            " & ".join(row) for row in body
        ) + r" \end{array}", form
    if form == "csv":
        return "\n".join(",".join(row) for row in [order, *lines]), form
    return "\n".join("\t".join(row) for row in [order, *lines]), form


def _is_float(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _in_craig(name):
    """The name of an entry's mistake where a and alpha stand one row further down."""
    *key, row = name.split(":")
    return name if ":d:" in name else ":".join([*key, str(int(row) + 1)])


def cases(rng, count):
    made = 0
    while made < count:
        m = some_machine(rng) if rng.random() < 0.8 else KNOWN["PANDA"]
        d = int(rng.choice([2, 3, 4, 6]))
        kind = str(
            rng.choice(
                ["right", "rechosen", "single", "whole", "pair"], p=[0.15, 0.2, 0.3, 0.2, 0.15]
            )
        )
        cause, rows, alone = None, m.rows, None
        if kind == "rechosen":
            rows = rechosen(m.rows, rng)
        if kind in ("single", "whole"):
            options = list(single(m, rng) if kind == "single" else whole(m, rng))
            if not options:
                continue
            cause, rows = options[int(rng.integers(len(options)))]
        if kind == "pair":
            ones, units = list(single(m, rng)), list(whole(m, rng))[:5]
            if not ones:
                continue
            (one, alone), k = ones[int(rng.integers(len(ones)))], int(rng.integers(5))
            cause = f"{units[k][0]} + {_in_craig(one) if k == 2 else one}"
            rows = list(whole(m.with_rows(alone), rng))[k][1]
        if cause and rows == m.rows:
            continue
        degrees = bool(cause and "table.degrees" in cause)
        # Without heads exchanged columns are another order of them, and right.
        exchanged = bool(cause) and (" and d" in cause or "alpha and theta" in cause)
        text, form = typed(rows, rng, d, degrees, heads=exchanged)
        yield dict(
            topic="table",
            machine=m,
            typed=text,
            form=form,
            digits=d,
            kind=kind,
            cause=cause,
            rows=rows,
            alone=alone,
        )
        made += 1
