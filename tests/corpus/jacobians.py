"""Compute right and mistaken Jacobians.

Each mistake is made where a student makes it: in the recipe, in the table or in writing.
"""

import math

import numpy as np

from tests.corpus import tables
from tests.corpus.machine import cross


def recipe(
    m,
    q,
    axis=0,
    origin=0,
    lever="tip",
    point=-1,
    rows=False,
    count=False,
    degrees=False,
):
    """Return the 6 x dof Jacobian by the cross-product recipe.

    The defaults give the right Jacobian. Each option makes one mistake of the recipe.
    """
    if degrees:
        q = [math.radians(x) if k == "R" else x for x, k in zip(q, m.kinds, strict=True)]
    T = m.frames(q)
    columns = []
    for c, (i, kind) in enumerate(zip(m.joints, m.kinds, strict=True)):
        za, oa = (c, c) if count else (i + axis, i + origin)
        z = T[za][2, :3] if rows else T[za][:3, 2]
        o = np.zeros(3) if rows else T[oa][:3, 3]
        p = np.zeros(3) if rows else T[point][:3, 3]
        r = {"tip": p - o, "o_n": p, "back": o - p}[lever]
        columns.append([*cross(z, r), *z] if kind == "R" else [*z, 0, 0, 0])
    return np.array(columns, dtype=float).T


def halves(v, w):
    """Return the linear rows of one Jacobian above the angular rows of another."""
    return np.vstack([v[:3], w[3:]])


def before(m, q, rng):
    """Yield each mistake of the recipe with its Jacobian."""
    right = recipe(m, q)
    late = recipe(m, q, axis=1, origin=1)
    yield "J.z_i angular", halves(right, late)
    yield "J.one frame late", late
    yield "J.z_i", recipe(m, q, axis=1)
    yield "J.origin late", recipe(m, q, origin=1)
    yield "J.lever tip", recipe(m, q, lever="o_n")
    yield "J.rows of T", recipe(m, q, rows=True)
    yield "J.degrees", recipe(m, q, degrees=True)
    yield "J.cross", recipe(m, q, lever="back")
    yield f"J.point:{len(m.rows) - 1}", recipe(m, q, point=len(m.rows) - 1)
    z_0 = recipe(m, q)
    z_0[3:] = np.outer([0, 0, 1], m.turns)
    yield "J.z_0 angular", z_0


def of_tables(m, q, rng):
    """Yield Jacobians of wrong tables: one wrong row, no offsets, or no pen."""
    k = int(rng.integers(len(m.rows))) + 1
    for cause, rows in tables.in_rows(m):
        if cause.endswith(f":{k}") and cause.split(":")[0] != "table.a and d":
            yield cause, m.with_rows(rows).jacobian(q)
    if sum(1 for row in m.rows if row[0] == "R" and row[4]) > 1:
        yield (
            "table.offsets",
            m.with_rows([(*r[:4], 0 if r[0] == "R" else r[4]) for r in m.rows]).jacobian(q),
        )
    for rows in tables.without_pen(m):
        yield "table.pen", m.with_rows(rows).jacobian(q)


def after(m, q, rng):
    """Yield mistakes of writing, each as a function of the right Jacobian."""
    T = m.frames(q)

    def scaled(v, w):
        return lambda J: np.vstack([v * J[:3], w * J[3:]])

    yield "J.halves", lambda J: np.vstack([J[3:], J[:3]])
    yield "J.all signs", lambda J: -J
    yield "J.millimetres", scaled(1000, 1)
    yield "J.angular zero", scaled(1, 0)
    if m.dof == 6:
        yield "J.transposed", lambda J: J.T
    yield "J.reversed order", lambda J: J[:, ::-1]
    k = len(m.rows)
    R = T[k][:3, :3]
    yield f"J.frame:{k}", lambda J: np.vstack([R.T @ J[:3], R.T @ J[3:]])
    i, j = sorted(rng.choice(m.dof, 2, replace=False))
    order = list(range(m.dof))
    order[i], order[j] = j, i
    yield f"J.columns exchanged:{m.joints[i] + 1}:{m.joints[j] + 1}", lambda J: J[:, order]


def signs(m):
    """Return (row, column signs) for each joint, with this joint reversed."""
    return [(row, np.where(np.arange(m.dof) == k, -1, 1)) for k, row in enumerate(m.joints)]


def in_frame(m, q, J, k):
    """Return the Jacobian with both halves in the axes of frame k."""
    R = m.frames(q)[k][:3, :3].T
    return np.vstack([R @ J[:3], R @ J[3:]])
