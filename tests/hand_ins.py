"""Hand-ins as students type them, right ones and ones with a planted mistake, and what the checkers
make of them: `python -m tests.hand_ins --seed 1 --count 5000 --part unread`.

The numbers come from the few lines of kinematics below, the truth of a cause from undoing or
planting it here; nothing of `judge/` is read. The seeds of the two parts never meet: what the
checkers are mended by is "worked", what only counts them is "unread".
"""

import argparse
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from helpers import checks, inverse, robots
from helpers.arm import Arm, Body, prismatic, revolute
from helpers.inputs import ArmError
from tests.dressing import around, column, jacobian_text, joints_text, number, table_text

PARTS = {"worked": 0, "unread": 1}
G = 9.81
P = np.pi / 2

# An arm is its rows here: (kind, a, alpha, d, theta), typed from the homework's page.
R, S = "revolute", "prismatic"
ROWS = {
    "Panda": [(R, 0, P, 0.333, 0), (R, 0, -P, 0, 0), (R, 0.0825, -P, 0.316, 0),
              (R, -0.0825, P, 0, 0), (R, 0, P, 0.384, 0), (R, 0.088, -P, 0, 0),
              (R, 0, 0, -0.207, 0)],
    "UR10e": [(R, 0, P, 0.1807, 0), (R, -0.6127, 0, 0, 0), (R, -0.57155, 0, 0, 0),
              (R, 0, P, 0.17415, 0), (R, 0, -P, 0.11985, 0), (R, 0, 0, 0.21655, 0)],
    "UR10e (homework)": [(R, 0, -P, 0.128, 0), (R, 0.6127, 2 * P, 0, -P), (R, 0.5716, 2 * P, 0, 0),
                         (R, 0, P, 0.1639, P), (R, 0, -P, 0.1157, 0), (R, 0, 0, 0.1922, 0)],
    "Stanford arm": [(R, 0, -P, 0, 0), (R, 0, P, 0.154, 0), (S, 0, 0, 0, 0), (R, 0, -P, 0, 0),
                     (R, 0, P, 0, 0), (R, 0, 0, 0.263, 0)],
    "Elbow arm": [(R, 0, P, 0.5, 0), (R, 0.4, 0, 0, 0), (R, 0.3, 0, 0, 0)],
}  # fmt: skip
ROWS["Panda (homework)"] = [
    (k, np.sign(a) * 0.088 if abs(a) == 0.0825 else a, *rest) for k, a, *rest in ROWS["Panda"]
]
UR10 = dict(d_1=0.128, a_2=0.6127, a_3=0.5716, d_4=0.1639, d_5=0.1157, d_6=0.0922)


@dataclass(frozen=True)
class HandIn:
    """What is typed, what is asked of it, and the causes that would be true (None: it is right)."""

    topic: str
    text: str
    ask: Callable[[str], checks.Report]
    causes: frozenset[str] | None
    dressed: str
    digits: int
    rng: int = 0


@dataclass(frozen=True)
class Machine:
    """An arm in both tellings."""

    arm: Arm
    rows: list
    bodies: list | None

    @property
    def dof(self) -> int:
        return len(self.rows)

    def __hash__(self) -> int:
        return hash(self.arm.name)


def frames(rows: list, q: np.ndarray) -> list[np.ndarray]:
    """The frames 0 to n, each the one before times Rz Tz Tx Rx."""
    found = [np.eye(4)]
    for (kind, a, alpha, d, theta), x in zip(rows, q, strict=True):
        turn, slide = (theta + x, d) if kind == R else (theta, d + x)
        c, s, ca, sa = np.cos(turn), np.sin(turn), np.cos(alpha), np.sin(alpha)
        A = [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, slide]]
        found.append(found[-1] @ np.array([*A, [0, 0, 0, 1]]))
    return found


def jacobian(rows: list, q: np.ndarray, *, z: int = 0, o: int = 0, point=None, sign=1.0):
    """z x (p - o) over z; `z`, `o` count frames on from joint i's own, as a slip would."""
    T = frames(rows, q)
    tip = T[-1][:3, 3] if point is None else point
    columns = []
    for i, (kind, *_) in enumerate(rows):
        axis, origin = T[i + z][:3, 2], T[i + o][:3, 3]
        lever = sign * np.cross(axis, tip - origin)
        columns.append([*axis, 0, 0, 0] if kind == S else [*lever, *axis])
    return np.array(columns).T


def torques(machine: Machine, q, F, *, gravity=G, masses=1.0, centres=1.0, used=None):
    """g(q) - J^T F by each body's own Jacobian; the options are what slips change."""
    T, weight = frames(machine.rows, q), np.zeros(machine.dof)
    masses = np.ones(machine.dof) * masses
    for i, (m, com) in enumerate(machine.bodies[:used]):
        p = (T[i + 1] @ [*(np.array(com) * centres), 1])[:3]
        J = jacobian(machine.rows[: i + 1], q[: i + 1], point=p)
        weight[: i + 1] += m * masses[i] * gravity * J[2]
    return weight - jacobian(machine.rows, q).T @ F


# Arms


def machines(rng) -> Machine:
    """One of the catalogue's arms, or one of somebody's own."""
    if rng.random() < 0.7:
        name = rng.choice(list(ROWS))
        arm = robots.named(name)
        bodies = arm.bodies and [
            (float(arm.number(b.mass)), [float(arm.number(x)) for x in b.com]) for b in arm.bodies
        ]
        return Machine(arm, ROWS[name], bodies)
    rows = [_row(rng) for _ in range(rng.integers(3, 8))]
    bodies = [
        (float(m), list(map(float, c)))
        for m, c in zip(
            rng.uniform(0.5, 8, len(rows)).round(2),
            rng.uniform(-0.1, 0.1, (len(rows), 3)).round(3),
            strict=True,
        )
    ]
    made = [(revolute if k == R else prismatic)(a, t, d, o) for k, a, t, d, o in rows]
    arm = Arm("My arm", tuple(made), bodies=tuple(Body(m, tuple(c)) for m, c in bodies))
    return Machine(arm, rows, bodies)


def _row(rng) -> tuple:
    kind = S if rng.random() < 0.12 else R
    a, d = rng.uniform(0.05, 0.7, 2).round(3) * (rng.random(2) < 0.6)
    return kind, float(a), float(rng.choice([0, P, -P])), float(d) if kind == R else 0.0, 0.0


def a_pose(rng, machine: Machine) -> np.ndarray:
    q = rng.uniform(-1.4, 1.4, machine.dof).round(2)
    return np.array(
        [x if k == R else 0.2 + abs(x) / 3 for x, (k, *_) in zip(q, machine.rows, strict=True)]
    )


# The mistakes, each a table from the cause's key to what it makes of the right numbers


def jacobian_mistakes(m: Machine, q) -> dict[str, np.ndarray]:
    J = jacobian(m.rows, q)
    rows = np.r_[np.ones(3), np.zeros(3)][:, None]
    linear, angular = J * rows, J * (1 - rows)
    degrees = np.array(
        [np.radians(x) if k == R else x for x, (k, *_) in zip(q, m.rows, strict=True)]
    )
    found = {
        "J.all signs": -J,
        "J.angular sign": linear - angular,
        "J.cross": jacobian(m.rows, q, sign=-1),
        "J.degrees": jacobian(m.rows, degrees),
        "J.millimetres": 1000 * linear + angular,
        "J.centimetres": 100 * linear + angular,
        "J.halves": np.vstack([J[3:], J[:3]]),
        "J.z_i": jacobian(m.rows, q, z=1),
        "J.z_i angular": np.vstack([J[:3], jacobian(m.rows, q, z=1)[3:]]),
        "J.origin late": jacobian(m.rows, q, o=1),
        "J.one frame late": jacobian(m.rows, q, z=1, o=1),
        "J.reversed order": J[:, ::-1],
    }
    for i in range(m.dof):
        found[f"J.column sign:{i + 1}"] = J * np.where(np.arange(m.dof) == i, -1, 1)
    if {"a_2", "d_6"} <= set(m.arm.values) and len(m.rows) == 6 and "UR" in m.arm.name:
        swapped = ROWS["UR10e" if "home" in m.arm.name else "UR10e (homework)"]
        own = [(k, np.copysign(abs(s[1]), a), t, np.copysign(abs(s[3]), d), o)
               for (k, a, t, d, o), s in zip(m.rows, swapped, strict=True)]  # fmt: skip
        found["J.robot"] = jacobian(own, q)
    return found


def torque_mistakes(m: Machine, q, F) -> dict[str, np.ndarray]:
    right, g = torques(m, q, F), torques(m, q, 0 * F)
    push = g - right
    found = {
        "tau.all signs": -right,
        "tau.weight sign": -g - push,
        "tau.weight missing": -push,
        "tau.newton millimetres": 1000 * right,
        "tau.gravity:1": torques(m, q, F, gravity=1),
        "tau.centres at origins": torques(m, q, F, centres=0),
        "tau.reversed order": right[::-1],
        "tau.degrees": torques(m, np.array([np.radians(x) if k == R else x for x, (k, *_) in
                                            zip(q, m.rows, strict=True)]), F),
        "tau.last link": torques(m, q, F, used=m.dof - 1),
    }  # fmt: skip
    if np.any(F):
        found |= {"tau.force missing": g, "tau.force sign": g + push}
        found["tau.force and moment"] = g - jacobian(m.rows, q).T @ np.r_[F[3:], F[:3]]
    if np.any(F[3:]):
        found["tau.moment missing"] = g - jacobian(m.rows, q).T @ np.r_[F[:3], 0, 0, 0]
    for i in range(m.dof):
        lost = torques(m, q, F, masses=np.where(np.arange(m.dof) == i, 0, 1))
        found[f"tau.mass missing:{i + 1}"] = lost
    return found


def table_mistakes(m: Machine) -> dict[str, list]:
    """Rows with one thing done wrong, and the key of what would say so."""
    found = {}
    for i, (k, a, t, d, o) in enumerate(m.rows):

        def put(*row, at=i):
            return [*m.rows[:at], row, *m.rows[at + 1 :]]

        if (a or d) and a != d and k == R:
            found[f"table.a and d:{i + 1}"] = put(k, d, t, a, o)
        if a:
            found[f"table.number:a:{i + 1}"] = put(k, round(a * 1.13, 4), t, d, o)
            found[f"table.sign:a:{i + 1}"] = put(k, -a, t, d, o)
        if d:
            found[f"table.number:d:{i + 1}"] = put(k, a, t, round(d * 1.13, 4), o)
            found[f"table.sign:d:{i + 1}"] = put(k, a, t, -d, o)
        if t:
            found[f"table.twist:{i + 1}"] = put(k, a, 0 if abs(t) < 2 else P, d, o)
            found[f"table.sign:alpha:{i + 1}"] = put(k, a, -t, d, o)
    found["table.a and d"] = [(k, d, t, a, o) for k, a, t, d, o in m.rows]
    if all(k == R for k, *_ in m.rows):
        found["table.alpha and theta"] = [(k, a, o, d, t) for k, a, t, d, o in m.rows]
    if m.arm.values.get("l_pen"):
        *first, (k, a, t, d, o) = m.rows
        found["table.pen"] = [*first, (k, a, t, d - np.sign(d) * 0.1, o)]
    if any(o for *_, o in m.rows):
        found["table.offsets"] = [(k, a, t, d, 0) for k, a, t, d, _ in m.rows]
    return found


def joint_mistakes(m: Machine, q) -> dict[str, np.ndarray]:
    turns = np.array([k == R for k, *_ in m.rows])
    found = {
        "ik.degrees": np.where(turns, np.degrees(q), q),
        "ik.all signs": -q,
        "ik.reversed order": q[::-1],
    }
    for i in np.flatnonzero(turns):
        one = np.arange(m.dof) == i
        found[f"ik.sign:q_{i + 1}"] = np.where(one, -q, q)
        found[f"ik.half turn:q_{i + 1}"] = np.where(one, q + np.pi, q)
        found[f"ik.offset:q_{i + 1}"] = np.where(one, q - np.pi / 2, q)
        found[f"ik.supplement:q_{i + 1}"] = np.where(one, np.pi - q, q)
    for i in np.flatnonzero(~turns):
        found["ik.slide in millimetres"] = np.where(np.arange(m.dof) == i, 1000 * q, q)
    return found


def true_causes(planted: str, mistakes: dict, digits: int, scale: float) -> frozenset[str]:
    """The planted mistake and all that give the same numbers to a few units of the last place."""
    made, unit = mistakes[planted], 3 * 10.0**-digits * scale
    return frozenset(
        key for key, x in mistakes.items()
        if np.shape(x) == np.shape(made) and np.max(np.abs(np.subtract(x, made))) <= unit
    )  # fmt: skip


def planted(rng, mistakes: dict, right, digits: int) -> str | None:
    """A mistake that shows in the digits typed."""
    seen = [k for k, x in mistakes.items() if np.max(np.abs(x - right)) > 12 * 10.0**-digits]
    return str(rng.choice(seen)) if seen else None


# One hand-in of each topic; `wrong` asks for a mistake


def of_jacobian(rng, wrong: bool) -> HandIn | None:
    m, digits = machines(rng), int(rng.integers(3, 6))
    q = a_pose(rng, m)
    made, causes = jacobian(m.rows, q), None
    if wrong:
        mistakes = jacobian_mistakes(m, q)
        key = planted(rng, mistakes, made, digits)
        if key is None:
            return None
        made, causes = mistakes[key], true_causes(key, mistakes, digits, 1)
    text, how = jacobian_text(rng, made, digits)
    ask = partial(_swapped(checks.compare_jacobian), arm=m.arm, q=q)
    return HandIn("jacobian", text, ask, causes, how, digits)


def _swapped(compare: Callable) -> Callable:
    return lambda text, **options: compare(text, **options)


def of_torques(rng, wrong: bool) -> HandIn | None:
    m, digits = machines(rng), int(rng.integers(3, 6))
    if not m.bodies:
        return None
    q = a_pose(rng, m)
    F = np.round(rng.uniform(-8, 8, 6) * [1, 1, 1, *[rng.random() < 0.4] * 3], 1)
    F = F if rng.random() < 0.8 else 0 * F
    made, causes = torques(m, q, F), None
    if wrong:
        mistakes = torque_mistakes(m, q, F)
        key = planted(rng, mistakes, made, digits)
        if key is None:
            return None
        made, causes = mistakes[key], true_causes(key, mistakes, digits, 1)
    text, how = column(rng, made, digits, "tau", "N m")
    ask = partial(_swapped(checks.compare_torques), arm=m.arm, q=q, wrench=F)
    return HandIn("torques", text, ask, causes, how, digits)


def of_table(rng, wrong: bool) -> HandIn | None:
    m, digits = machines(rng), 5
    made, causes = m.rows, None
    if wrong:
        mistakes = table_mistakes(m)
        key = str(rng.choice(list(mistakes)))
        made = mistakes[key]
        tips = [_tip_frames(rows, rng.integers(9)) for rows in (made, m.rows)]
        if _same_motion(made, m.rows) or np.allclose(*tips, atol=1e-3):
            return None
        causes = frozenset(k for k, x in mistakes.items() if np.allclose(_data(x), _data(made)))
    text, how = table_text(rng, made)
    return HandIn("table", text, partial(_swapped(checks.compare_tables), reference=m.arm),
                  causes, how, digits)  # fmt: skip


def _data(rows: list) -> np.ndarray:
    return np.array([row[1:] for row in rows], float)


def _tip_frames(rows: list, seed: int) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return np.array([frames(rows, rng.uniform(0.1, 1.3, len(rows)))[-1] for _ in range(3)])


def _same_motion(mine: list, right: list) -> bool:
    """Whether the arms are one but for zeros and senses: equal angles and distances of neighbouring
    axes, equal offsets between common normals (up to sign)."""
    return np.allclose(_invariants(mine), _invariants(right), atol=1e-6)


def _invariants(rows: list) -> np.ndarray:
    """Distances of each axis from the next two and of the tip from the last two, the joint between
    going round, sorted: zeros and senses do not matter. A mirrored arm has the same ones."""
    values = [rows[0][3] if rows[0][2] else 0.0]
    for i in range(len(rows)):
        for j in (i + 1, i + 2):
            seen = []
            for x in np.linspace(0, 2 * np.pi, 24, endpoint=False):
                q = np.where(np.arange(len(rows)) == i + 1, x, 0)
                T = frames(rows, q)
                seen.append(_apart(T[i], T[min(j, len(rows))], line=j < len(rows)))
            values += sorted(np.round(seen, 9))
    return np.array(values)


def _apart(A: np.ndarray, B: np.ndarray, line: bool) -> float:
    """The distance of two z axes (as lines), or of B's origin from A's."""
    n, between = np.cross(A[:3, 2], B[:3, 2]), B[:3, 3] - A[:3, 3]
    if not line or np.linalg.norm(n) < 1e-9:
        return float(np.linalg.norm(np.cross(between, A[:3, 2])))
    return float(abs(between @ n) / np.linalg.norm(n))


def of_branches(rng, wrong: bool) -> HandIn | None:
    name = str(rng.choice(["Elbow arm", "UR10e", "UR10e (homework)", "Stanford arm"]))
    m = Machine(robots.named(name), ROWS[name], None)
    solve = {"E": inverse.elbow, "U": inverse.ur, "S": inverse.stanford}[name[0]]
    T = frames(m.rows, a_pose(rng, m))[-1]
    found = solve(m.arm, T[:3, 3] if name[0] == "E" else T)
    answers = found.q[found.valid]
    if any(np.abs(_missed(m, q, T)).max() > 1e-6 for q in answers):
        raise AssertionError("the closed form is no source")
    digits, causes = int(rng.integers(3, 6)), None
    answers = answers[rng.permutation(len(answers))][: rng.integers(1, len(answers) + 1)]
    if wrong:
        at = int(rng.integers(len(answers)))
        mistakes = joint_mistakes(m, answers[at])
        key = str(rng.choice(list(mistakes)))
        if np.abs(_missed(m, mistakes[key], T)).max() < 0.02:
            return None
        causes = _undone(m, mistakes[key], T, digits)
        answers = np.array([mistakes[key] if i == at else q for i, q in enumerate(answers)])
    text, options, how = joints_text(rng, answers, [k == R for k, *_ in m.rows], digits)
    ask = partial(_swapped(checks.compare_branches), found=found, **options)
    return HandIn("branches", text, ask, causes, how, digits)


def of_pose(rng, wrong: bool) -> HandIn | None:
    m, digits = machines(rng), int(rng.integers(3, 6))
    q = a_pose(rng, m)
    T = frames(m.rows, q)[-1]
    causes, made = None, q
    if wrong:
        mistakes = joint_mistakes(m, q)
        key = str(rng.choice(list(mistakes)))
        made = mistakes[key]
        if np.abs(_missed(m, made, T)).max() < 0.02:
            return None
        causes = _undone(m, made, T, digits)
    text, options, how = joints_text(rng, made[None], [k == R for k, *_ in m.rows], digits)
    ask = partial(_swapped(lambda q, **rest: checks.compare_pose(q, **rest)), arm=m.arm, T=T,
                  **options)  # fmt: skip
    return HandIn("pose", text, ask, causes, how, digits)


def _missed(m: Machine, q, T) -> np.ndarray:
    off = frames(m.rows, q)[-1] - T
    return off[:3, 3] if m.dof < 6 else off


def _undone(m: Machine, made, T, digits: int) -> frozenset[str]:
    """The slips that, undone, take the tip to its target."""
    undo = {}
    for key in joint_mistakes(m, made):
        kind, _, at = key.partition(":")
        turns = np.array([k == R for k, *_ in m.rows])
        one = np.arange(m.dof) == int(at[2:]) - 1 if at else ~turns
        undo[key] = {
            "ik.degrees": np.where(turns, np.radians(made), made), "ik.all signs": -made,
            "ik.reversed order": made[::-1], "ik.sign": np.where(one, -made, made),
            "ik.half turn": np.where(one, made + np.pi, made),
            "ik.offset": np.where(one, made + np.pi / 2, made),
            "ik.supplement": np.where(one, np.pi - made, made),
            "ik.slide in millimetres": np.where(one, made / 1000, made),
        }[kind]  # fmt: skip
    return frozenset(
        k for k, q in undo.items() if np.abs(_missed(m, q, T)).max() < 20 * 10.0**-digits
    )


def of_run(rng, wrong: bool) -> HandIn | None:
    """A circle of the tip of an elbow arm, by exact joints found with Newton's method here."""
    from helpers.motion import circle_below

    m, steps = Machine(robots.ELBOW, ROWS["Elbow arm"], None), 60
    path = circle_below(m.arm, [0.2, 0.6, -1.2], 0.05, "zy", 5, steps)
    q, rows = np.array([0.2, 0.6, -1.2]), []
    for t in path.times:
        for _ in range(30):
            q = q + np.linalg.solve(
                jacobian(m.rows, q)[:3], path.position(np.array(t)) - frames(m.rows, q)[-1][:3, 3]
            )
        rows.append(q)
    made, causes = np.array(rows), None
    if wrong:
        key = str(rng.choice(["trace.degrees", "trace.backwards"]))
        made = np.degrees(made) if key == "trace.degrees" else made[::-1]
        causes = frozenset([key])
    digits = int(rng.integers(3, 6))
    sep = str(rng.choice([",", "\t", "  ", ", "]))
    text = "\n".join(sep.join(number(x, digits) for x in row) for row in made)
    ask = partial(_swapped(checks.compare_trace), arm=m.arm, path=path)
    return HandIn("run", around(rng, text)[0], ask, causes, "csv", digits)


TOPICS = [of_table] * 6 + [of_jacobian] * 6 + [of_torques] * 4 + [of_branches] * 3 + [of_pose] * 3
TOPICS += [of_run]


def hand_ins(part: str, seed: int, count: int) -> Iterator[HandIn]:
    """`count` of them, the same for the same seed."""
    made = n = 0
    while made < count:
        rng = np.random.default_rng([PARTS[part], seed, n])
        n += 1
        topic = TOPICS[rng.integers(len(TOPICS))]
        if (found := topic(rng, bool(rng.random() < 0.5))) is not None:
            made += 1
            yield found


# What the checkers make of one


def verdict(h: HandIn) -> tuple[str, object]:
    """One word for what happened, and the report or the refusal."""
    try:
        report = h.ask(h.text)
    except ArmError as problem:
        return "refused", problem
    if h.causes is None:
        word = {"wrong": "called wrong", "rounded": "called cut"}.get(report.grade, "right")
        return word, report
    if report.grade in ("right", "rounded") and not report.mark:
        return "passed", report
    if report.mark or any(_names(cause, true) for cause in report.causes for true in h.causes):
        return "named", report
    told = [f for f in report.findings if f.what == "cause"]
    stated = [f for f in told if "erhaps" not in f.words]
    return ("false cause" if stated else "not named"), report


# The judge's keys of what is planted here under another, and what it says of it that is true too.
ALSO = {
    "table.twist": ("table.no twist", "table.angle:alpha"),
    "table.sign:alpha": ("table.twist", "table.number and sign"),
    "table.a and d": ("table.a and d in row", "table.too much:a", "table.too much:d"),
    "ik": ("pose.joint",),
    "J.robot": ("table.robot", "arm.other"),
    "tau.last link": ("tau.mass missing",),
}


def _names(cause: str, true: str) -> bool:
    """Whether a report's cause is the true one, perhaps with more."""
    if cause.split(" + ")[0] == true:
        return True
    others = next((keys for start, keys in ALSO.items() if true.startswith(start)), ())
    return cause.startswith(others)


def main(arguments: list[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--part", choices=PARTS, default="unread")
    parser.add_argument("--show", default="", help="print hand-ins of this verdict")
    said = parser.parse_args(arguments)
    counted: Counter = Counter()
    for h in hand_ins(said.part, said.seed, said.count):
        word, report = verdict(h)
        counted[h.topic, "right" if h.causes is None else "wrong", word] += 1
        if word == said.show:
            print("-" * 80, h.topic, h.dressed, sorted(h.causes or ()), h.text, "=>", report,
                  sep="\n")  # fmt: skip
    for key, n in sorted(counted.items()):
        print(f"{n:6}  {', '.join(key)}")


if __name__ == "__main__":
    main()
