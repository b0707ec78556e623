"""Right and mistaken Jacobians: each mistake is made as a student makes it, in the recipe, the
table or the writing.
"""

import math

import numpy as np

from tests.corpus.arms import pose, some_machine
from tests.corpus.machine import cross
from tests.corpus.typing_ import typed


def recipe(
    m,
    q,
    axis=0,
    origin=0,
    lever="tip",
    point=-1,
    slides=True,
    rows=False,
    count=False,
    degrees=False,
):
    if degrees:
        q = [math.radians(x) if k == "R" else x for x, k in zip(q, m.kinds, strict=True)]
    T = m.frames(q)
    columns = []
    for c, (i, kind) in enumerate(zip(m.joints, m.kinds, strict=True)):
        za, oa = (c, c) if count else (i + axis, i + origin)
        z = T[za][2, :3] if rows else T[za][:3, 2]
        o = np.zeros(3) if rows else T[oa][:3, 3]
        p = np.zeros(3) if rows else T[point][:3, 3]
        r = {"tip": p - o, "o_n": p, "o": o, "link": T[i + 1][:3, 3] - o, "back": o - p}[lever]
        turns = kind == "R" or not slides
        columns.append([*cross(z, r), *z] if turns else [*z, 0, 0, 0])
    return np.array(columns, dtype=float).T


def halves(v, w):
    return np.vstack([v[:3], w[3:]])


def before(m, q, rng):
    """Mistakes made before the matrix stands."""
    right = recipe(m, q)
    late = recipe(m, q, axis=1, origin=1)
    yield "J.z_i angular", halves(right, late)
    yield "J.one frame late", late
    yield "J.z_i", recipe(m, q, axis=1)
    yield "J.origin late", recipe(m, q, origin=1)
    yield "J.lever tip", recipe(m, q, lever="o_n")
    yield "J.lever origin", recipe(m, q, lever="o")
    yield "J.lever link", recipe(m, q, lever="link")
    yield "J.rows of T", recipe(m, q, rows=True)
    yield "J.degrees", recipe(m, q, degrees=True)
    yield "J.cross", recipe(m, q, lever="back")
    k = int(rng.integers(1, len(m.rows)))
    yield f"J.point:{k}", recipe(m, q, point=k)
    if "P" in m.kinds:
        yield "J.slide turns", recipe(m, q, slides=False)
    if m.joints != list(range(m.dof)):
        counted = recipe(m, q, count=True)
        yield "J.z counted on angular", halves(right, counted)
        yield "J.z counted on", counted


def tables(m, q, rng):
    """The right recipe on a wrong table."""

    def changed(k, **entries):
        row = dict(zip(("kind", "a", "alpha", "d", "theta"), m.rows[k], strict=True))
        return m.with_rows(
            [*m.rows[:k], tuple({**row, **entries}.values()), *m.rows[k + 1 :]]
        ).jacobian(q)

    k = int(rng.integers(len(m.rows)))
    kind, a, alpha, d, _ = m.rows[k]
    if abs(math.sin(alpha)) > 0.1:
        yield f"table.twist:{k + 1}", changed(k, alpha=-alpha)
        yield f"table.no twist:{k + 1}", changed(k, alpha=0)
    for name, x in (("a", a), ("d", d)):
        if x and kind != "P":
            yield f"table.sign:{name}:{k + 1}", changed(k, **{name: -x})
            yield f"table.missing:{name}:{k + 1}", changed(k, **{name: 0})
    if sum(1 for row in m.rows if row[0] == "R" and row[4]) > 1:
        yield (
            "table.offsets",
            m.with_rows([(*r[:4], 0 if r[0] == "R" else r[4]) for r in m.rows]).jacobian(q),
        )
    if m.name in ("PANDA", "UR10E_HOMEWORK", "PANDA.lock(3)"):
        shorter = -0.107 if m.name[0] == "P" else 0.0922
        yield "table.pen", changed(len(m.rows) - 1, d=shorter)


def after(m, q, rng):
    """Mistakes of writing: functions of a matrix."""
    T = m.frames(q)

    def scaled(v, w):
        return lambda J: np.vstack([v * J[:3], w * J[3:]])

    yield "J.halves", lambda J: np.vstack([J[3:], J[:3]])
    yield "J.all signs", lambda J: -J
    yield "J.angular sign", scaled(1, -1)
    yield "J.millimetres", scaled(1000, 1)
    yield "J.centimetres", scaled(100, 1)
    yield "J.angular zero", scaled(1, 0)
    yield "J.per degree", lambda J: np.where(m.turns, J * math.pi / 180, J)
    if m.dof == 6:
        yield "J.transposed", lambda J: J.T
    yield "J.reversed order", lambda J: J[:, ::-1]
    k = int(rng.integers(1, len(m.rows) + 1))
    R = T[k][:3, :3]
    yield f"J.frame:{k}", lambda J: np.vstack([R.T @ J[:3], R.T @ J[3:]])
    yield f"J.frame angular:{k}", lambda J: np.vstack([J[:3], R.T @ J[3:]])
    i, j = sorted(rng.choice(m.dof, 2, replace=False))
    order = list(range(m.dof))
    order[i], order[j] = j, i
    yield f"J.columns exchanged:{m.joints[i] + 1}:{m.joints[j] + 1}", lambda J: J[:, order]
    sign = np.where(np.arange(m.dof) == i, -1, 1)
    yield f"J.column sign:{m.joints[i] + 1}", lambda J: J * sign


WRITING = ("J.halves", "J.millimetres", "J.per degree", "J.all signs", "J.frame:", "J.transposed")


BY_FRAME = ("J.frame", "J.frame angular", "J.transposed")  # named by the frame themselves


def in_frame(m, q, J, k):
    """The rows in the axes of frame k."""
    R = m.frames(q)[k][:3, :3].T
    return np.vstack([R @ J[:3], R @ J[3:]])


def apart(A, B, d):
    """Whether two matrices differ by more than their roundings in some entry, and by what shows at
    all.
    """
    return np.abs(A - B).max() > max(8 * 10.0**-d, 5e-3)


def noisy(right, rng):
    """Some entries off by chance; None where none is."""
    wrong = rng.random(right.shape) < 0.25
    J = right + np.where(wrong, rng.uniform(0.05, 0.4, right.shape), 0)
    return (None, J) if wrong.any() else None


def pair(right, firsts, seconds, rng):
    """Two mistakes, the second made in writing the first's matrix down."""
    (one, A), (two, f) = (
        firsts[int(rng.integers(len(firsts)))],
        seconds[int(rng.integers(len(seconds)))],
    )
    if rng.random() < 0.3:
        writings = [x for x in seconds if x[0].startswith(WRITING)]
        (one, g), (two, f) = (writings[k] for k in rng.choice(len(writings), 2, replace=False))
        A = g(right)
    return f"{one} + {two}", f(A)


def mistaken(what, m, q, d, rng):
    """The cause and the matrix of a mistake, or of two; None where they do not show."""
    right = m.jacobian(q)
    firsts, seconds = [*before(m, q, rng), *tables(m, q, rng)], list(after(m, q, rng))
    singles = [*firsts, *((name, f(right)) for name, f in seconds)]
    if what == "single":
        cause, J = singles[int(rng.integers(len(singles)))]
    else:
        cause, J = pair(right, firsts, seconds, rng)
        if J.shape != right.shape:
            return None
        if not all(apart(J, S, d) for _, S in singles if S.shape == J.shape):
            return None
    return (cause, J) if J.shape == right.shape and apart(J, right, d) else None


def handed_in(what, m, q, d, rng):
    """The cause and the matrix of an answer of one kind; None where it came to nothing."""
    right = m.jacobian(q)
    if what == "right":
        return None, right
    if what == "hand":
        return None, right + rng.uniform(-1.5, 1.5, right.shape) * 10.0**-d
    return noisy(right, rng) if what == "noise" else mistaken(what, m, q, d, rng)


def written(what, cause, J, m, q, rng):
    """How it is said to be written, and the matrix so: in another frame, or with (omega, v)."""
    how = {}
    if rng.random() < 0.12 and what in ("right", "single"):
        k, one = int(rng.integers(1, len(m.rows) + 1)), (cause or "").split(":")[0]
        if one not in BY_FRAME:
            how, J = dict(frame=k), in_frame(m, q, J, k)
    whole = J.shape == m.jacobian(q).shape and cause not in ("J.halves", "J.transposed")
    if rng.random() < 0.1 and whole:
        how, J = {**how, "angular_first": True}, np.vstack([J[3:], J[:3]])
    return how, J


def cases(rng, count):
    """(case, right matrix) for right work, single mistakes and pairs, in turn."""
    made = 0
    while made < count:
        m = some_machine(rng)
        q = pose(m, rng)
        d = int(rng.choice([2, 3, 4, 5, 6], p=[0.1, 0.25, 0.35, 0.15, 0.15]))
        kinds = ["right", "hand", "single", "pair", "noise"]
        what = rng.choice(kinds, p=[0.25, 0.05, 0.45, 0.2, 0.05])
        found = handed_in(what, m, q, d, rng)
        if found is None:
            continue
        cause, J = found
        how, J = written(what, cause, J, m, q, rng)
        scale = 1000 if cause and "J.millimetres" in cause else 1
        text, form = typed(J, d if scale == 1 else max(0, d - 3), rng)
        told = dict(topic="jacobian", machine=m, q=q, typed=text, form=form, digits=d)
        yield dict(**told, kind=str(what), cause=cause, **how)
        made += 1
