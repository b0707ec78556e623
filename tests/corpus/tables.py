"""Make DH tables with the mistakes that students make."""

import math

import numpy as np

NAMES = ("a", "alpha", "d", "theta")


def changed(rows, i, **entries):
    """Return the rows with some entries of row i replaced."""
    row = dict(zip(("kind", *NAMES), rows[i], strict=True))
    return [*rows[:i], tuple({**row, **entries}.values()), *rows[i + 1 :]]


def swapped(rows, first, second):
    """Return the rows with two columns exchanged."""
    swapped_rows = []
    for row in rows:
        entries = dict(zip(("kind", *NAMES), row, strict=True))
        entries[first], entries[second] = entries[second], entries[first]
        swapped_rows.append(tuple(entries.values()))
    return swapped_rows


def to_craig(rows):
    """Return the table in Craig's convention.

    Its rows hold a and alpha of the row before. A fixed row at the end keeps the last a and alpha.
    """
    before = [(None, 0, 0, None, None), *rows]
    craig_rows = [(r[0], b[1], b[2], r[3], r[4]) for r, b in zip(rows, before, strict=False)]
    last = rows[-1]
    return [*craig_rows, ("F", last[1], last[2], 0, 0)] if last[1] or last[2] else craig_rows


def whole(m, rng):
    """Yield mistakes that concern the whole table."""
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
    """Yield the table without its pen of 0.1 m, if the arm has one."""
    if m.name in ("PANDA", "UR10E_HOMEWORK", "PANDA.lock(3)"):
        yield changed(m.rows, len(m.rows) - 1, d=-0.107 if m.name[0] == "P" else 0.0922)


def in_rows(m):
    """Yield mistakes of one entry or one row, for each row."""
    for i, (kind, a, alpha, d, _) in enumerate(m.rows):
        if abs(math.sin(alpha)) > 0.1:
            yield f"table.twist:{i + 1}", changed(m.rows, i, alpha=-alpha)
            yield f"table.no twist:{i + 1}", changed(m.rows, i, alpha=0)
        for name, x in (("a", a), ("d", d)):
            if x and not (name == "d" and kind == "P"):
                yield f"table.sign:{name}:{i + 1}", changed(m.rows, i, **{name: -x})
                yield f"table.missing:{name}:{i + 1}", changed(m.rows, i, **{name: 0})
        if kind == "R" and a != d:
            yield f"table.a and d:{i + 1}", changed(m.rows, i, a=d, d=a)


def mistakes(m, rng):
    """Return the rows that each mistake makes, by the key of its cause."""
    return dict([*whole(m, rng), *in_rows(m)])


def numbers(rows):
    """Return the entries of rows as a matrix, without the kinds of joint."""
    return np.array([row[1:] for row in rows], float)


def alike(mine, rows):
    """Return whether two answers have the same shape and numbers."""
    return np.shape(mine) == np.shape(rows) and np.allclose(mine, rows, atol=3e-5)
