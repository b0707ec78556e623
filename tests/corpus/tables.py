"""Mistaken tables."""

import math

import numpy as np

NAMES = ("a", "alpha", "d", "theta")


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
    i, j = sorted(int(x) for x in rng.choice(len(rows), 2, replace=False))
    order = list(range(len(rows)))
    order[i], order[j] = j, i
    yield f"table.rows exchanged:{i + 1}:{j + 1}", [rows[k] for k in order]
    for short in without_pen(m):
        yield "table.pen", short


def without_pen(m):
    """The table without its pen of 0.1 m, of the arms that have one."""
    if m.name in ("PANDA", "UR10E_HOMEWORK", "PANDA.lock(3)"):
        yield changed(m.rows, len(m.rows) - 1, d=-0.107 if m.name[0] == "P" else 0.0922)


def in_rows(m):
    """Mistakes of one entry or row, of each row."""
    for i, (kind, a, alpha, d, _) in enumerate(m.rows):
        if abs(math.sin(alpha)) > 0.1:
            yield f"table.twist:{i + 1}", changed(m.rows, i, alpha=-alpha)
            yield f"table.no twist:{i + 1}", changed(m.rows, i, alpha=0)
        for name, x in (("a", a), ("d", d)):
            if x and not (name == "d" and kind == "P"):
                yield f"table.sign:{name}:{i + 1}", changed(m.rows, i, **{name: -x})
                yield f"table.missing:{name}:{i + 1}", changed(m.rows, i, **{name: 0})
                off = round(x * 1.13, 4)
                yield f"table.number:{name}:{i + 1}", changed(m.rows, i, **{name: off})
        if kind == "R" and a != d:
            yield f"table.a and d:{i + 1}", changed(m.rows, i, a=d, d=a)


def mistakes(m, rng):
    """Each mistake by its cause's name; the rows that it makes."""
    return dict([*whole(m, rng), *in_rows(m)])


def numbers(rows):
    return np.array([row[1:] for row in rows], float)


def alike(mine, rows):
    """Whether two answers hold the same numbers."""
    return np.shape(mine) == np.shape(rows) and np.allclose(mine, rows, atol=3e-5)
