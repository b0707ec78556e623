"""Right and mistaken joint angles: the elbow arm's branches by the book's triangle, and poses of
any arm.
"""

import math

import numpy as np

from tests.corpus.arms import KNOWN, pose, some_machine

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
    return written([[f"{x:.{d}f}" for x in q] for q in rows], rng)


def written(words, rng):
    """Joint vectors as people hold them."""
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


WRISTED = {"STANFORD": 8, "UR10E": 8, "UR10E_HOMEWORK": 8}


def solved(m, T, start):
    """Joints that take the tip to T, by Newton's method from a start; None where it fails."""
    q = np.array(start, float)
    for _ in range(25):
        here = m.tip(q)
        E = T[:3, :3] @ here[:3, :3].T
        w = 0.5 * np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])
        off = np.array([*(T[:3, 3] - here[:3, 3]), *w])
        if np.abs(off).max() < 1e-12:
            break
        q = q + np.clip(np.linalg.lstsq(m.jacobian(q), off, rcond=None)[0], -0.5, 0.5)
    ok = np.abs(off).max() < 1e-10 and np.abs(here - T).max() < 1e-9
    return q if ok else None


def all_of(m, T, expected, rng):
    """Every set of joints that reaches T, by many starts; None unless as many are found as there
    should be.
    """
    found = []
    for _ in range(40 * expected):
        start = np.where(
            m.turns, rng.uniform(-math.pi, math.pi, m.dof), rng.uniform(-0.8, 0.8, m.dof)
        )
        q = solved(m, T, start)
        if q is None:
            continue
        q = np.where(m.turns, np.remainder(q + math.pi, 2 * math.pi) - math.pi, q)
        if all(gap(q, other) > 1e-6 for other in found):
            found.append(q)
        if len(found) == expected:
            return found
    return None


def in_one_joint(q, m, right, rng):
    """One answer of six joints spoiled by one slip."""
    k = int(rng.integers(m.dof))
    joint = f"q_{m.joints[k] + 1}"
    one = np.arange(m.dof) == k
    yield "ik.sign:" + joint, np.where(one, -q, q)
    yield "ik.all signs", -q
    yield "ik.reversed order", q[::-1]
    if m.turns[k]:
        yield "ik.half turn:" + joint, np.where(one, q + math.pi, q)
        yield "ik.offset:" + joint, np.where(one, q - H, q)
        yield "ik.other axis:" + joint, np.where(one, H - q, q)
    other = right[int(rng.integers(len(right)))]
    yield "ik.mixed", np.array([*q[:3], *other[3:]])
    if not m.turns.all():
        yield "ik.slide in millimetres", np.where(m.turns, q, 1000 * q)


def of_six(rng):
    """A target of an arm of six joints with all that reaches it."""
    name = str(rng.choice(list(WRISTED)))
    m = KNOWN[name]
    q = np.array(pose(m, rng))
    if name == "STANFORD":
        q[2] = abs(q[2]) + 0.1
    T = m.tip(q)
    found = all_of(m, T, WRISTED[name], rng)
    return (name, m, T, found) if found else None


def long_branches(rng, count):
    made = 0
    while made < count:
        task = of_six(rng)
        if task is None:
            continue
        name, m, T, right = task
        digits = int(rng.choice([3, 4, 5, 6]))
        kind = str(rng.choice(["right", "part", "single", "degrees"], p=[0.3, 0.15, 0.45, 0.1]))
        cause, answers = None, [right[k] for k in rng.permutation(len(right))]
        if kind == "part":
            answers = answers[: int(rng.integers(1, len(right)))]
        if kind == "degrees":
            cause = "ik.degrees"
        if kind == "single":
            options = list(in_one_joint(answers[0], m, right, rng))
            cause, wrong = options[int(rng.integers(len(options)))]
            if any(gap(wrong, q) < 0.05 for q in right):
                continue
            answers = [wrong, *answers[1 : int(rng.integers(1, len(right) + 1))]]
        declared = kind != "degrees" and rng.random() < 0.15
        degrees = kind == "degrees" or declared
        text, form = written([m.as_typed(q, digits, degrees) for q in answers], rng)
        yield dict(
            topic="branches",
            arm=name,
            target=[[float(x) for x in row] for row in T],
            typed=text,
            form=form,
            digits=digits,
            kind=kind,
            cause=cause,
            angles="deg" if declared else None,
        )
        made += 1


def every_branch(rng, count):
    """The elbow arm's and those of arms with six joints."""
    six = count // 2
    yield from branches(rng, count - six)
    yield from long_branches(rng, six)


def pose_case(m, T, q, digits, kind, cause, degrees=False):
    """A case of joints for a pose."""
    return dict(
        topic="pose",
        machine=m,
        T=[[float(x) for x in row] for row in T],
        typed=[float(x) for x in m.as_typed(q, digits, degrees)],
        form="array",
        digits=digits,
        kind=kind,
        cause=cause,
    )


def locked(rng, count):
    """Poses of the Panda, with a joint locked too, and of arms with a wrist, for `compare_pose`."""
    made = 0
    while made < count:
        m = KNOWN[
            str(rng.choice(["PANDA", "UR10E", "UR10E_HOMEWORK", "STANFORD", "PANDA.lock(3)"]))
        ]
        q = np.array(pose(m, rng, 5))
        digits = int(rng.choice([3, 4, 5, 6]))
        T = np.round(m.tip(q), digits)
        kind = str(rng.choice(["right", "single"], p=[0.4, 0.6]))
        options = [x for x in in_one_joint(q, m, [q], rng) if x[0] != "ik.mixed"]
        cause, given = (None, q) if kind == "right" else options[int(rng.integers(len(options)))]
        if kind == "single" and np.abs(m.tip(given) - m.tip(q)).max() < 0.02:
            continue
        declared = rng.random() < 0.2
        found = pose_case(m, T, given, digits, kind, cause, declared)
        yield dict(**found, angles="deg" if declared else None)
        made += 1


def every_pose(rng, count):
    half = count // 2
    yield from poses(rng, count - half)
    yield from locked(rng, half)


def poses(rng, count):
    made = 0
    while made < count:
        m = some_machine(rng)
        q = np.array(pose(m, rng, 5))
        if m.dof < 4:
            continue
        digits = int(rng.choice([3, 4, 5]))
        T = np.round(m.tip(q), digits)
        options = [
            ("ik.degrees", np.where(m.turns, np.degrees(q), q)),
            ("ik.all signs", -q),
        ]
        for k in np.flatnonzero(m.turns)[:2]:
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
        yield pose_case(m, T, given, digits, kind, cause)
        made += 1
