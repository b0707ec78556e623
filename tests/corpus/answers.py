"""Right and mistaken joint angles: the elbow arm's branches by the book's triangle, and poses of
any arm.
"""

import math

import numpy as np

from tests.corpus.arms import pose, some_machine

H = math.pi / 2


def elbow(a2, a3, d1, d, point):
    """All four branches of the elbow arm, by hand; None where out of reach."""
    x, y, z = point
    reach = x * x + y * y - d * d
    s = z - d1
    D = (reach + s * s - a2 * a2 - a3 * a3) / (2 * a2 * a3)
    if abs(D) > 0.97 or reach < 0.01:
        return None
    found = []
    for side in (1, -1):
        r = side * math.sqrt(reach)
        q1 = math.atan2(y, x) - math.atan2(d, r)
        for sign in (-1, 1):
            q3 = math.atan2(sign * math.sqrt(1 - D * D), D)
            q2 = math.atan2(s, r) - math.atan2(a3 * math.sin(q3), a2 + a3 * math.cos(q3))
            found.append([q1, q2, q3])
    return found


def lean(q, a2, a3):
    return math.atan2(a3 * math.sin(q[2]), a2 + a3 * math.cos(q[2]))


def slips(q, a2, a3, rng):
    """One answer spoiled by one slip."""
    q1, q2, q3 = q
    yield "ik.sign:q_2", [q1, -q2, q3]
    yield "ik.plus for minus", [q1, q2 + 2 * lean(q, a2, a3), q3]
    yield "ik.half turn:q_1", [q1 + math.pi, q2, q3]
    yield "ik.half turn:q_2", [q1, q2 + math.pi, q3]
    yield "ik.other axis:q_1", [H - q1, q2, q3]
    yield "ik.supplement:q_3", [q1, q2, math.pi - q3]
    yield "ik.all signs", [-q1, -q2, -q3]
    yield "ik.offset:q_2", [q1, q2 - H, q3]


def shown(answers, d, rng, degrees):
    rows = [[math.degrees(x) if degrees else x for x in q] for q in answers]
    words = [[f"{x:.{d}f}" for x in q] for q in rows]
    form = str(rng.choice(["array", "list", "matlab", "csv", "named"]))
    if form == "array":
        return [[float(x) for x in q] for q in words], form
    if form == "matlab":
        return "[" + "; ".join(" ".join(q) for q in words) + "]", form
    if form == "csv":
        return "\n".join(", ".join(q) for q in words), form
    if form == "named":
        return [[[f"theta{i}", float(x)] for i, x in enumerate(q, 1)] for q in words], form
    return "[" + ", ".join("[" + ", ".join(q) + "]" for q in words) + "]", form


def gap(p, q):
    return max(abs(math.remainder(x - y, 2 * math.pi)) for x, y in zip(p, q, strict=True))


def branches(rng, count):
    made = 0
    while made < count:
        a2, a3, d1 = (round(float(x), 2) for x in rng.uniform(0.25, 0.6, 3))
        d = round(float(rng.uniform(0.05, 0.15)), 2) if rng.random() < 0.5 else 0.0
        point = [round(float(x), 2) for x in rng.uniform(-0.7, 0.9, 3)]
        right = elbow(a2, a3, d1, d, point)
        if right is None:
            continue
        digits = int(rng.choice([3, 4, 5]))
        kind = str(rng.choice(["right", "part", "single", "degrees"], p=[0.3, 0.15, 0.45, 0.1]))
        cause, answers = None, [right[k] for k in rng.permutation(4)]
        if kind == "part":
            answers = answers[: int(rng.integers(1, 4))]
        if kind == "degrees":
            cause, digits = "ik.degrees", max(1, digits - 2)
        if kind == "single":
            options = list(slips(answers[0], a2, a3, rng))
            cause, wrong = options[int(rng.integers(len(options)))]
            if any(gap(wrong, q) < 0.05 for q in right):
                continue
            answers = [wrong, *answers[1 : int(rng.integers(1, 5))]]
        text, form = shown(answers, digits, rng, kind == "degrees")
        values = dict(a_2=a2, a_3=a3, d_1=d1, d=d)
        yield dict(
            topic="branches",
            arm="ELBOW",
            values=values,
            target=point,
            typed=text,
            form=form,
            digits=digits,
            kind=kind,
            cause=cause,
        )
        made += 1


def poses(rng, count):
    made = 0
    while made < count:
        m = some_machine(rng)
        q = np.array(pose(m, rng, 5))
        if m.dof < 4:
            continue
        digits = int(rng.choice([3, 4, 5]))
        T = np.round(m.tip(q), digits)
        turns = np.array([k == "R" for k in m.kinds])
        options = [
            ("ik.degrees", np.where(turns, np.degrees(q), q)),
            ("ik.all signs", -q),
        ]
        for k in np.flatnonzero(turns)[:2]:
            one = np.arange(m.dof) == k
            options += [
                (f"ik.sign:q_{m.joints[k] + 1}", np.where(one, -q, q)),
                (f"ik.half turn:q_{m.joints[k] + 1}", np.where(one, q + math.pi, q)),
            ]
        kind = str(rng.choice(["right", "single"], p=[0.4, 0.6]))
        cause, given = (None, q) if kind == "right" else options[int(rng.integers(len(options)))]
        here = m.tip(given)
        if kind == "single" and np.abs(here - m.tip(q)).max() < 0.02:
            continue
        typed = [float(f"{x:.{digits}f}") for x in given]
        yield dict(
            topic="pose",
            machine=m,
            T=[[float(x) for x in row] for row in T],
            typed=typed,
            form="array",
            digits=digits,
            kind=kind,
            cause=cause,
        )
        made += 1
