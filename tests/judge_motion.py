"""Questions on joint angles and on runs for tests/judge_words.py: right ones, the corpus's mistakes
and those of the catalogues.
"""

import math
from collections import defaultdict
from collections.abc import Callable, Iterator
from functools import cache, partial
from itertools import chain as chained
from itertools import islice

import numpy as np
import sympy as sp

from helpers import checks, inverse, symbolic
from helpers.arm import Arm, prismatic, revolute
from helpers.checks import inverse_causes
from helpers.checks.chains import Chain, chain, columns
from helpers.checks.jacobian_causes import wrong_recipes, wrong_tables
from helpers.checks.lengths import wrong_lengths
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion import circle, circle_below, rest_to_rest
from helpers.motion.steps import tip_error
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from tests.corpus import answers, traces

H = math.pi / 2
_WRIST = Arm(
    "Wrist arm",
    [
        revolute(alpha=H, d=0.4),
        revolute(a=0.4, theta=0.3),
        revolute(a=0.02, alpha=H, d=0.05),
        revolute(alpha=-H, d=0.35),
        revolute(alpha=H),
        revolute(d=0.1),
    ],
)
_ROD = Arm("Rod arm", [revolute(alpha=-H, d=0.3), revolute(alpha=H, d=0.1), prismatic(d=0.2)])
_OFFSET = ELBOW.with_values(d=0.12)
_PLANAR = Arm("Planar arm", [revolute(a=0.4), revolute(a=0.3)])
_LIMITED = dict(limits=(-0.2, 0.8), speed=0.2)
_GANTRY = Arm(
    "Gantry",
    [
        prismatic(alpha=H, **_LIMITED),
        prismatic(alpha=H, theta=H, **_LIMITED),
        prismatic(),
    ],
)
FORMS = (
    (ELBOW, inverse.elbow),
    (_OFFSET, inverse.elbow),
    (_ROD, inverse.rod),
    (STANFORD, inverse.stanford),
    (_WRIST, inverse.spherical_wrist),
    (UR10E, inverse.ur),
    (UR10E_HOMEWORK, inverse.ur),
)
_SOLVERS = dict(FORMS)
_ARMS = (PANDA, PANDA_HOMEWORK, PANDA.lock(3), _PLANAR, _GANTRY, *(arm for arm, _ in FORMS))
_FORMULAS = (ELBOW, _PLANAR)
Asked = Iterator[tuple[Arm, dict]]


def _question(topic: str, typed, options: dict, **more) -> dict:
    return {"topic": topic, "typed": typed, "options": options, **more}


def stored_branches(rng, count: int) -> Asked:
    """The corpus's elbow arms."""
    for case in answers.branches(rng, count):
        arm = ELBOW.with_values(**case["values"])
        yield arm, _question("branches", case["typed"], {}, target=case["target"])


def stored_poses(rng, count: int, arm_of) -> Asked:
    """The corpus's poses."""
    for case in answers.poses(rng, count):
        yield arm_of(case["machine"]), _question("pose", case["typed"], {}, target=case["T"])


def stored_traces(rng, count: int, arm_of) -> Asked:
    """The corpus's runs."""
    for case in traces.cases(rng, count):
        options = {"angles": case["angles"]} if case["angles"] else {}
        arm = arm_of(case["machine"])
        yield arm, _question("trace", case["typed"], options, path=case["path"])


# Branches and poses of all arms


def branch_questions(rng, count: int) -> Asked:
    """Some of the branches of some arm, and what slips make of them; free joints and targets out of
    reach too.
    """
    for _ in range(count):
        arm, solver = FORMS[int(rng.integers(len(FORMS)))]
        q = _somewhere(rng, arm)
        T = forward_kinematics(arm, q)
        if rng.random() < 0.03:
            T[:3, 3] *= 4
        target = T if arm.dof == 6 else np.round(T[:3, 3], int(rng.choice([3, 16])))
        found = solver(arm, target, rng.uniform(-1, 1, arm.dof))  # where a joint is free
        rows = found.q[found.valid] if found.valid.any() else q[None]
        k = int(rng.integers(arm.dof))
        if rng.random() < 0.15:
            rows = rows[np.sign(rows[:, k]) == np.sign(rows[0, k])]
        if rng.random() < 0.7:
            rows = rows[rng.permutation(len(rows))][: int(rng.integers(1, 9))]
        spoiled = rng.random(len(rows)) < rng.choice([0, 0.3, 1])
        mine = [_slipped(rng, arm, *x, rows) for x in zip(rows, spoiled, strict=True)]
        mine += mine[: int(rng.random() < 0.05)]
        options = _options(rng)
        typed = _typed(rng, arm, np.array(mine), options)
        yield arm, _question("branches", typed, options, target=np.asarray(target).tolist())


def pose_questions(rng, count: int) -> Asked:
    """One joint vector of some arm and a pose, or a point, in numbers or formulas, and what slips
    make of either.
    """
    for _ in range(count):
        arm = _ARMS[int(rng.integers(len(_ARMS)))]
        q = _somewhere(rng, arm)
        others = [other for _, other in wrong_lengths(arm)]
        other = others[int(rng.integers(len(others)))] if others and rng.random() < 0.2 else arm
        T = _wrong_pose(rng, forward_kinematics(other, q))
        target = np.round(T if rng.random() < 0.7 else T[:3, 3], int(rng.choice([2, 3, 4, 6, 16])))
        options = _options(rng)
        slips = rng.random() < 0.5
        mine = [_slipped(rng, arm, q, slips, [q])] * (1 + (rng.random() < 0.02))
        typed = _typed(rng, arm, np.array(mine), options)
        given = _in_formulas(rng, arm) if arm in _FORMULAS and rng.random() < 0.5 else None
        target = given or _as_text(rng, target.tolist())
        yield arm, _question("pose", typed, options, target=target)


def _somewhere(rng, arm: Arm) -> np.ndarray:
    q = rng.uniform(-1.5, 1.5, arm.dof)
    what = rng.random()
    if what < 0.25:
        q[rng.random(arm.dof) < 0.4] = float(rng.choice([0.0, H, -H]))
    elif what < 0.3:
        q = np.zeros(arm.dof)
    elif what < 0.4:
        q *= float(rng.choice([0.003, 3.0]))
    elif what < 0.5:
        q = np.radians(np.rint(np.degrees(q)))
    return np.where(arm.turning, q, 0.2 + 0.2 * np.abs(q))


def _slipped(rng, arm: Arm, q: np.ndarray, slips: bool, branches) -> np.ndarray:
    what = rng.random()
    if not slips:
        return q + 2 * np.pi * rng.integers(-1, 2, arm.dof) * arm.turning * (what < 0.1)
    if what < 0.2:
        other = branches[int(rng.integers(len(branches)))]
        return np.where(rng.random(arm.dof) < 0.4, other, q)
    if what < 0.3:
        return q + np.where(rng.random(arm.dof) < 0.3, rng.uniform(-0.5, 0.5, arm.dof), 0)
    if what < 0.32 and arm.dof > 1:  # two joints exchanged
        k = int(rng.integers(1, arm.dof))
        return np.concatenate([q[: k - 1], q[[k, k - 1]], q[k + 1 :]])
    if what < 0.35:
        return np.concatenate([[rng.choice([H, -H])], q[1:]])
    if what < 0.45:  # in a joint of which the page does not think
        change = inverse_causes._JOINT[int(rng.integers(6))][1]
        return np.where(np.arange(arm.dof) == rng.integers(arm.dof), change(q), q)
    kinds = defaultdict(list)
    made = chained(inverse_causes.single(arm, q), inverse_causes.whole(arm, q))
    for slip in inverse_causes.double(arm, q) if what < 0.6 and arm.turning.any() else made:
        kinds[slip[0].keys].append(slip)
    kind = kinds[list(kinds)[int(rng.integers(len(kinds)))]]
    cause, mended = kind[int(rng.integers(len(kind)))]
    if inverse_causes.scales(cause):
        return np.where(mended, q * q / np.where(mended, mended, 1), q)
    return 2 * q - mended if cause.name == "ik.plus for minus" else mended


@cache
def _formulas(arm: Arm) -> sp.Matrix:
    return symbolic.forward_kinematics(arm)


def _in_formulas(rng, arm: Arm) -> str:
    """The tip's pose or place in symbols, with another sign or another joint in some."""
    T = _formulas(arm)[:3, :] if rng.random() < 0.3 else _formulas(arm)[:3, 3]
    text = str(T.T.tolist() if T.shape[1] == 1 else T.tolist())
    for old, new in ((" + ", " - "), ("q_2", "q_1"), ("sin(q_1)", "cos(q_1)")):
        at = text.find(old, int(rng.integers(len(text)))) if rng.random() < 0.25 else -1
        text = text if at < 0 else text[:at] + new + text[at + len(old) :]
    return text


def _wrong_pose(rng, T: np.ndarray) -> np.ndarray:
    T, what = T.copy(), rng.random()
    if what < 0.05:
        T[:3, 3] *= 1000
    elif what < 0.1:
        T[:3, 3] *= 100
    elif what < 0.15:
        T[:3, :3] = T[:3, :3].T
    elif what < 0.2:
        T[:3, :2] *= -1
    elif what < 0.35:
        for _ in range(int(rng.integers(1, 5))):
            T[int(rng.integers(3)), int(rng.integers(4))] *= -1
    elif what < 0.45:
        T[:3, 3] += rng.uniform(-1, 1, 3) * float(rng.choice([1e-6, 1e-4, 1e-3, 1e-2]))
    return T


def _options(rng) -> dict:
    options = {}
    if rng.random() < 0.1:
        options["angles"] = "deg"
    if rng.random() < 0.12:
        options["tolerance"] = float(rng.choice([0.0, 1e-3, 0.02, 0.2]))
    return options


def _typed(rng, arm: Arm, mine: np.ndarray, options: dict):
    """Joint vectors in some form, with so many decimals."""
    if options.get("angles") == "deg" or rng.random() < 0.1:
        mine = np.where(arm.turning, np.degrees(mine), mine)
    d = int(rng.choice([0, 1, 2, 3, 4, 5, 8, 16]))
    if rng.random() < 0.2:
        mine = mine + rng.uniform(-1, 1, mine.shape) * 10.0**-d * float(rng.choice([1, 3, 5]))
    words = [[f"{x:.{d}f}" if d < 16 else repr(float(x)) for x in row] for row in mine]
    if rng.random() < 0.1:
        words = [list(column) for column in zip(*words, strict=True)]
    if rng.random() < 0.06:
        return _misshapen(rng, [[float(x) for x in row] for row in words])
    form = str(rng.choice(["array", "named", "text", "dict", "rows", "matlab", "latex", "tabs"]))
    if form == "array":
        return [[float(x) for x in row] for row in words]
    if form == "named":
        return [[[f"Theta{i}", float(x)] for i, x in enumerate(row, 1)] for row in words]
    pairs = [[(f"theta_{i}", x) for i, x in enumerate(row, 1)] for row in words]
    forms = {
        "text": lambda: "[" + ", ".join(str(row).replace("'", "") for row in words) + "]",
        "dict": lambda: (
            "["
            + ",\n".join("{" + ", ".join(f"'{n}': {x}" for n, x in row) + "}" for row in pairs)
            + "]"
        ),
        "rows": lambda: "\n".join(", ".join(f"{n} = {x}" for n, x in row) for row in pairs),
        "matlab": lambda: "[" + "; ".join(" ".join(row) for row in words) + "]",
        "latex": lambda: (
            r"\begin{pmatrix}" + r" \\ ".join(" & ".join(row) for row in words) + r"\end{pmatrix}"
        ),
        "tabs": lambda: "\n".join("\t".join(row) for row in words),
    }
    return forms[form]()


def _misshapen(rng, rows: list[list[float]]):
    """Held in another way, or too little, too much, or nothing."""
    return [
        [row[:-1] for row in rows],
        [[*row, 0.5] for row in rows],
        [[row] for row in rows],
        [[row, row] for row in rows],
        [[[x] for x in row] for row in rows],
        [[x] for x in rows[0]],
        rows[0],
        str(rows[0][0]),
        [],
    ][int(rng.integers(9))]


def _as_text(rng, T):
    what = rng.random()
    if what < 0.05:
        return [T[:2], [T], T * 2, [[x] for x in T]][int(rng.integers(4))]
    if what < 0.6:
        return T
    if np.ndim(T) == 1:
        return ", ".join(map(repr, T))
    rows = T[:3] if what < 0.7 else T
    return "[" + ",\n ".join(str(row) for row in rows) + "]"


# Runs


def trace_questions(rng, count: int) -> Asked:
    """Runs of Euler's method on circles, right and by mistakes of the catalogue, in any form."""
    arms = (PANDA.lock(3), PANDA_HOMEWORK.lock(3), UR10E, ELBOW, STANFORD, _PLANAR)
    for _ in range(count):
        arm = _GANTRY if rng.random() < 0.6 else arms[int(rng.integers(len(arms)))]
        steps = int(rng.choice([3, 12, 20, 20, 40, 60, 100, 160])) if rng.random() < 0.98 else 1
        path = dict(
            radius=float(rng.choice([0.03, 0.1])),
            plane=str(rng.choice(["zy", "yz", "xz", "zx"])),
            period=5.0,
            steps=steps,
        )
        start = np.array([0.3, 0.4, 0.9, 0.2, 0.8, 0.1])[: arm.dof] + rng.integers(2) / 10
        start = np.where(arm.turning, start, 0.4)
        asked = {"start": [float(x) for x in start], **path}
        if rng.random() < 0.1:
            asked = {**_circle_data(arm, asked), "phase": float(rng.uniform(0, 6))}
        if rng.random() < 0.1:
            asked["rest"] = True
        q = _run(rng, arm, path_of(arm, asked), start)
        if arm is _GANTRY and rng.random() < 0.8:
            away = _shaped(rng, path_of(arm, asked)) - forward_kinematics(arm, start)[:3, 3]
            q = start + away @ np.linalg.inv(jacobian(arm, start)[:3]).T
        if rng.random() < 0.1:
            jump = float(rng.choice([rng.uniform(0.1, 2), 2 * np.pi, -4 * np.pi]))
            q[int(rng.integers(len(q))) :, int(rng.integers(arm.dof))] += jump
        options = {}
        if rng.random() < 0.1:
            options["angles"] = "deg"
        if rng.random() < 0.15:
            options["tolerance"] = float(rng.choice([1e-3, 2e-3, 0.02, 0.2]))
        yield arm, _question("trace", _typed_run(rng, arm, q, options), options, path=asked)


def path_of(arm: Arm, asked: dict):
    """The path that a question names."""
    how = {key: value for key, value in asked.items() if key != "rest"}
    path = circle(**how) if "centre" in how else circle_below(arm, **how)
    return rest_to_rest(path) if asked.get("rest") else path


def _circle_data(arm: Arm, asked: dict) -> dict:
    top = forward_kinematics(arm, asked["start"])[:3, 3]
    rest = {key: value for key, value in asked.items() if key != "start"}
    return {"centre": [float(x) for x in top - [0, 0, 0.1]], **rest}


def _shaped(rng, path) -> np.ndarray:
    """Where a tip is that draws the path in some wrong way, nearly or exactly so."""
    p, t = path.positions, path.times
    middle, first, last = p.mean(axis=0), p[0], len(p) - 1
    share = float(rng.choice([0.5, 0.25, 1.01, 1.05, 1.5, 2, 3, -1, rng.uniform(0.01, 2)]))
    k = int(rng.integers(len(p)))
    drawn = [
        p,
        p[::-1],
        2 * first - p,
        p + rng.uniform(-1, 1, 3) * float(rng.choice([3e-3, 0.02, 0.3, 2])),
        p - middle * rng.integers(0, 2, 3),
        path.position(t[0] + share * (t - t[0])),
        middle + share * (p - middle),
        first + share * (p - first),
        middle + (p - middle)[:, rng.permutation(3)],
        p[(np.arange(len(p)) + k) % max(1, last)],
    ][int(rng.integers(10))]
    stray = rng.normal(size=p.shape) * float(rng.choice([0, 0, 1e-5, 3e-4, 2e-3]))
    drift = float(rng.choice([0, 0, 1e-3, 1e-2]))
    return drawn + stray + drift * np.outer(t / t[-1], rng.integers(-1, 2, 3))


def _run(rng, arm: Arm, path, start: np.ndarray) -> np.ndarray:
    steer, change, what = partial(jacobian, arm), lambda q: q, rng.random()
    q, rows, late, rate = start.copy(), [start], 0, 1.0
    if what < 0.3:
        rules, share = _spoiled(arm), float(rng.choice([1, 1, 0.2, 0.02]))
        wrong = rules[int(rng.integers(len(rules)))]
        steer = lambda q: (1 - share) * jacobian(arm, q) + share * wrong(q)  # noqa: E731
    elif what < 0.38:
        tables = _tables(arm)
        return _by_inverse(tables[int(rng.integers(len(tables)))], path, start)
    elif what < 0.46:
        late = 1
    elif what < 0.55:
        rate = float(rng.choice([-1.0, 0.5, 0.25, 1.2, 2.0, 0.8, 1e3, 1e-3]))
    elif what < 0.75:
        changes = [
            lambda q: q[::-1],
            np.degrees,
            lambda q: q + 0.01,
            lambda q: q + np.outer(np.linspace(0, 6, len(q)), np.eye(arm.dof)[-1]),
            lambda q: q + np.where(np.arange(len(q)) > len(q) // 2, 2.0, 0.0)[:, None],
            lambda q: np.vstack([q, q[-1:]]),
            lambda q: q[:-1],
            lambda q: q[: len(q) // 2],
            lambda q: q * [-1, *[1] * (arm.dof - 1)],
            lambda q: np.vstack([q[7:-1], q[:8]]),
            lambda q: np.vstack([0 * q[:1], q[1:]]),  # many arms have no inverse at 0
        ]
        change = changes[int(rng.integers(len(changes)))]
    v, dt, exact = path.velocities, np.diff(path.times), rng.random() < 0.5

    def rates(at: np.ndarray, k: int) -> np.ndarray:
        J, wanted = steer(at), np.zeros(6)
        wanted[:3] = rate * v[min(k + late, len(v) - 1)]
        part = slice(0, 6 if arm.dof >= 6 else 3)
        return np.linalg.pinv(J[part], rcond=1e-3) @ wanted[part]

    for k, step in enumerate(dt):
        q_dot = rates(q, k)
        if exact:
            q_dot = (q_dot + rates(q + step * q_dot, k + 1)) / 2
        q = q + step * q_dot
        rows.append(q)
    return change(np.array(rows))


def _by_inverse(table: Chain, path, start: np.ndarray) -> np.ndarray:
    """The joints by which an arm of another table follows a path."""
    q, rows, part = start, [], slice(0, 6 if len(start) >= 6 else 3)
    turn = table.with_(q=q).frames[-1, :3, :3]
    for k, position in enumerate(path.positions):
        for _ in range(2 if k else 9):
            at = table.with_(q=q)
            off = tip_error(at.frames[-1], position, turn)[part]
            q = q + np.clip(np.linalg.pinv(columns(at)[part], rcond=1e-3) @ off, -0.3, 0.3)
        rows.append(q)
    return np.array(rows)


@cache
def _tables(arm: Arm) -> list[Chain]:
    """An arm by every wrong table; tables are read once."""
    return [table for _, table in wrong_tables(arm, chain(arm, np.zeros(arm.dof)))]


@cache
def _spoiled(arm: Arm) -> list[Callable[[np.ndarray], np.ndarray]]:
    """The Jacobians of an arm by every wrong recipe and table."""
    right = chain(arm, np.zeros(arm.dof))

    def by_recipe(k: int, q: np.ndarray) -> np.ndarray:
        return next(islice(wrong_recipes(right.with_(q=q)), k, None))[1]

    def by_table(table: Chain, q: np.ndarray) -> np.ndarray:
        return columns(table.with_(q=q))

    recipes = range(len(list(wrong_recipes(right))))
    tables = (partial(by_table, table) for table in _tables(arm))
    return [*(partial(by_recipe, k) for k in recipes), *tables]


def _typed_run(rng, arm: Arm, q: np.ndarray, options: dict):
    if rng.random() < (0.8 if options.get("angles") == "deg" else 0.15):
        q = np.where(arm.turning, np.degrees(q), q)
    d = int(rng.choice([3, 4, 5, 6, 8, 16]))
    words = [[f"{x:.{d}f}" if d < 16 else repr(float(x)) for x in row] for row in q]
    if rng.random() < 0.15:
        words = [[f"{0.05 * k:.2f}", *row] for k, row in enumerate(words)]
    elif rng.random() < 0.1:
        words = [[str(rng.choice(["0", "1"])), *row] for row in words]
    if rng.random() < 0.1:
        words = [list(column) for column in zip(*words, strict=True)]
    elif rng.random() < 0.1:
        more = [*words, words[-1]]
        others = [words * 2, words[:1], [row[1:] for row in words], more, [*more, more[-1]]]
        words = others[int(rng.integers(5))]
    form = str(rng.choice(["array", "csv", "headed", "numpy", "matlab", "blanks"]))
    if form == "array":
        return [[float(x) for x in row] for row in words]
    names = ",".join(f"q{i}" for i in range(1, len(words[0]) + 1))
    forms = {
        "csv": lambda: "\n".join(",".join(row) for row in words),
        "headed": lambda: names + "\n" + "\n".join(",".join(row) for row in words),
        "numpy": lambda: "[" + ",\n ".join("[" + ", ".join(row) + "]" for row in words) + "]",
        "matlab": lambda: "q = [" + ";\n".join(" ".join(row) for row in words) + "];",
        "blanks": lambda: "\n".join("   ".join(row) for row in words),
    }
    return forms[form]()


# What Python says


def branches(typed, arm: Arm, question: dict):
    """The checker's report on branches."""
    found = _found(id(arm), arm, repr(question["target"]), tuple(map(_held, question["target"])))
    return checks.compare_branches(typed, found, **question["options"])


def _held(row):
    return tuple(row) if isinstance(row, list) else row


@cache
def _found(_, arm: Arm, __, target):
    solver = _SOLVERS.get(arm, inverse.elbow)  # the corpus's are elbow arms with other lengths
    return solver(arm, np.array(target))


def pose(typed, arm: Arm, question: dict):
    """The checker's report on a pose."""
    return checks.compare_pose(typed, arm, question["target"], **question["options"])


def trace(typed, arm: Arm, question: dict):
    """The checker's report on a run."""
    path = path_of(arm, question["path"])
    return checks.compare_trace(typed, arm, path, **question["options"])


SAYS = {"branches": branches, "pose": pose, "trace": trace}
