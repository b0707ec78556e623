"""Right tables in other frames, and mistaken ones."""

import math

import numpy as np

H = math.pi / 2
NAMES = ("a", "alpha", "d", "theta")


def wrapped(x):
    """An angle as people write it."""
    return math.pi - (math.pi - x) % (2 * math.pi)


def flip_x(rows, i):
    """x of frame i + 1 turned round."""
    (k, a, al, d, th), (k2, a2, al2, d2, th2) = rows[i], rows[i + 1]
    return [
        *rows[:i],
        (k, -a, -al, d, wrapped(th + math.pi)),
        (k2, a2, al2, d2, wrapped(th2 + math.pi)),
        *rows[i + 2 :],
    ]


def flip_z(rows, i):
    """z of frame i + 1 turned round: the joint on it counts backwards."""
    (k, a, al, d, th), (k2, a2, al2, d2, th2) = rows[i], rows[i + 1]
    return [
        *rows[:i],
        (k, a, wrapped(al + math.pi), d, th),
        (k2, a2, wrapped(al2 + math.pi), -d2, -th2),
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


def alike(mine, rows):
    """Whether two tables hold the same numbers."""
    if len(mine) != len(rows):
        return False
    return np.allclose([row[1:] for row in mine], [row[1:] for row in rows])


def same_motion(m, rows):
    """Whether other rows are the same arm, but for zeros and senses, or take the tip to the same
    places; a mirrored arm counts as the same one."""
    mine = m.with_rows(rows)
    if mine.kinds != m.kinds:
        return False
    rng = np.random.default_rng(1)
    q = rng.uniform(0.1, 1.3, (3, m.dof))
    if np.allclose([mine.tip(x) for x in q], [m.tip(x) for x in q], atol=1e-3):
        return True
    return np.allclose(_invariants(mine), _invariants(m), atol=1e-6)


def _invariants(m):
    """Distances of each axis from the next two and of the tip from the last two, the joint between
    going round, sorted: zeros and senses do not matter."""
    i0, sin = m.joints[0], math.sin(m.rows[m.joints[0]][2])
    values = [m.rows[i0][3] if sin else 0.0]
    for i in range(m.dof):
        for j in (i + 1, i + 2):
            seen = []
            for x in np.linspace(0, 2 * np.pi, 24, endpoint=False):
                T = m.frames(np.where(np.arange(m.dof) == i + 1, x, 0))
                B = T[m.joints[j]] if j < m.dof else T[-1]
                seen.append(_between(T[m.joints[i]], B, line=j < m.dof))
            values += sorted(np.round(seen, 9))
    return np.array(values)


def _between(A, B, line):
    """The distance of two z axes (as lines), or of B's origin from A's."""
    n, between = np.cross(A[:3, 2], B[:3, 2]), B[:3, 3] - A[:3, 3]
    if not line or np.linalg.norm(n) < 1e-9:
        return float(np.linalg.norm(np.cross(between, A[:3, 2])))
    return float(abs(between @ n) / np.linalg.norm(n))
