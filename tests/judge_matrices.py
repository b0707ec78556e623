"""Jacobians and torques as no corpus has them: slips in a column, in a half or in the shape, on
slips in the whole; joints in degrees or as text; digits cut, or a tolerance given.
"""

from collections.abc import Callable, Iterator

import numpy as np

from helpers.arm import Arm, Body
from helpers.checks.jacobian_causes import pairs, singles
from helpers.checks.torques_causes import Load, catalogue, paper_centres, reversed_joints
from helpers.statics import GRAVITY
from tests.corpus.arms import random_machine, some_machine
from tests.corpus.jacobians import in_frame
from tests.corpus.machine import Machine
from tests.corpus.torques import bodies
from tests.corpus.typing_ import typed

_TOLERANCES = (0.0, 1e-4, 3e-3, 0.02, 0.5)


def pick(rng, found):
    """One of a list or of an array's rows."""
    return found[int(rng.integers(len(found)))]


def chance(rng, shares: dict):
    """A key, as likely as its share."""
    shares_ = np.array([*shares.values()], dtype=float)
    return list(shares)[int(rng.choice(len(shares), p=shares_ / shares_.sum()))]


# Joints


def joints(rng, arm: Arm, poses: int = 1) -> tuple[np.ndarray, object, dict]:
    """Values (poses, dof), how they are typed, and the option that says so. At some poses joints
    are at 0, where mistakes hide.
    """
    turns = arm.turning
    q = np.where(turns, rng.uniform(-1.4, 1.4, (poses, arm.dof)), rng.uniform(0.1, 0.6, arm.dof))
    if rng.random() < 0.1:
        q = np.where(turns & (rng.random(arm.dof) < 0.6), 0.0, q)
    q = np.round(q, int(pick(rng, [1, 2, 3, 3, 4, 6, 15])))
    if rng.random() < 0.2:
        degrees = np.round(np.where(turns, np.degrees(q), q), int(rng.integers(1, 4)))
        q, shown, options = degrees * np.where(turns, np.pi / 180, 1), degrees, {"angles": "deg"}
    else:
        shown, options = q, {}
    if poses > 1:
        return q, (shown.T if rng.random() < 0.2 else shown).tolist(), options
    if rng.random() < 0.3:
        return q, ", ".join(map(repr, shown[0].tolist())), options
    return q, (shown if rng.random() < 0.05 else shown[0]).tolist(), options


# Digits


def written(rng, M: np.ndarray) -> object:
    """Numbers with some digits: rounded, cut, rounded on the way, significant ones, or all."""
    d = int(pick(rng, [1, 2, 3, 3, 4, 4, 5, 6]))
    how = chance(rng, {"rounded": 12, "cut": 2, "by hand": 2, "figures": 2, "full": 1, "sloppy": 1})
    if how == "figures":
        M = np.array([float(f"{x:.{d}g}") for x in M.ravel()]).reshape(M.shape)
        return M.tolist()
    if how == "cut":
        M = np.trunc(M * 10.0**d) / 10.0**d
    if how == "by hand":
        M = M + rng.uniform(-3, 3, M.shape) * 10.0**-d
    if how == "sloppy":
        M = M + rng.uniform(-1, 1, M.shape) * 2e-3 * np.abs(M).max()
    return typed(M, 15 if how in ("full", "sloppy") else d, rng)[0]


# Jacobians


def jacobian_slips(rng, count: int, arm_of: Callable) -> Iterator[tuple[Arm, dict]]:
    """Right and mistaken Jacobians of any arm."""
    for _ in range(count):
        m = (
            some_machine(rng)
            if rng.random() < 0.85
            else random_machine(rng, int(rng.integers(1, 4)))
        )
        arm = arm_of(m)
        q, shown, options = joints(rng, arm)
        if rng.random() < 0.2:
            options["frame"] = int(rng.integers(1, len(arm.rows) + 1))
        if rng.random() < 0.08:
            options["tolerance"] = pick(rng, _TOLERANCES)
        J = _jacobian(rng, m, arm, q[0], options.get("frame", 0))
        if rng.random() < 0.12:
            J = _reshaped(rng, m, J, q[0])
        if rng.random() < 0.1:
            options["angular_first"] = True
            J = np.roll(J, 3, axis=0) if len(J) == 6 else J
        if rng.random() < 0.12 and len(J) == 6:
            J = J[:3] if rng.random() < 0.5 else J[3:]
        asked = {"topic": "jacobian", "typed": written(rng, J), "q": shown, "options": options}
        yield arm, asked


def _jacobian(rng, m: Machine, arm: Arm, q, frame: int) -> np.ndarray:
    known = singles(arm, q, frame)
    what = chance(
        rng,
        {
            "right": 2,
            "single": 3,
            "pair": 3,
            "reversed": 2,
            "halves": 3,
            "columns": 5,
            "besides": 2,
        },
    )
    if what == "right":
        return known.right
    if what == "single":
        return pick(rng, known.made)
    if what == "pair":
        return pick(rng, pairs(arm, q, frame).made)
    if what == "reversed":
        signs = np.where(rng.random(m.dof) < 0.4, -1.0, 1.0)
        return in_frame(m, signs * q, m.jacobian(signs * q) * signs, frame)
    if what == "halves":
        one, two = (pick(rng, [known.right, *known.made]) for _ in range(2))
        return np.vstack([one[:3], two[3:]])
    J = np.array(known.right if what == "columns" else pick(rng, known.made))
    for k in rng.choice(m.dof, int(rng.integers(1, min(m.dof, 3) + 1)), replace=False):
        J[:, k] = _column(rng, J[:, k], known.made[..., k], _unlocked(m, q, frame))
    return J


def _column(rng, column, made, others) -> np.ndarray:
    """A column with a slip: turned round, halves exchanged, another joint's, of a known mistake,
    with other signs, with other numbers.
    """
    some = rng.random(6) < 0.4
    return {
        "sign": -column,
        "halves": np.roll(column, 3),
        "other joint": pick(rng, others.T),
        "mistake": pick(rng, made),
        "signs": np.where(some, -column, column),
        "numbers": np.where(some, column + rng.uniform(0.05, 0.4, 6), column),
        "noise": rng.uniform(-1, 1, 6),
    }[
        pick(
            rng,
            ["sign", "halves", "other joint", "mistake", "mistake", "signs", "numbers", "noise"],
        )
    ]


def _unlocked(m: Machine, q, frame: int) -> np.ndarray:
    """The columns of all rows, those that are locked turning."""
    loose = m.with_rows([("R" if row[0] == "F" else row[0], *row[1:]) for row in m.rows])
    whole = np.zeros(loose.dof)
    whole[m.joints] = q
    return in_frame(loose, whole, loose.jacobian(whole), frame)


def _reshaped(rng, m: Machine, J, q) -> np.ndarray:
    loose = _unlocked(m, q, 0)
    return {
        "transposed": J.T,
        "without a column": np.delete(J, int(rng.integers(m.dof)), axis=1) if m.dof > 1 else J,
        "locked too": loose,
        "a row for a column": loose[:5],
        "without a row": J[: int(rng.integers(1, 6))],
        "one line": J.reshape(1, -1),
        "one column": J.reshape(-1, 1),
        "nothing": 0 * J,
    }[
        pick(
            rng,
            ["transposed", "without a column", "without a column", "locked too",
             "a row for a column", "without a row", "one line", "one column", "nothing"],
        )
    ]  # fmt: skip


# Torques


def torque_slips(rng, count: int, arm_of: Callable, heavy) -> Iterator[tuple[Arm, dict]]:
    """Right and mistaken torques of any arm with masses, some of them 0."""
    for _ in range(count):
        arm = pick(rng, heavy) if rng.random() < 0.5 else _any_heavy(rng, arm_of)
        poses = 1 if rng.random() < 0.7 else int(rng.choice([2, 3, arm.dof, 5, 30, 60]))
        q, shown, options = joints(rng, arm, poses)
        wrench = np.zeros(6)
        if rng.random() < 0.6:
            each = poses if poses > 1 and rng.random() < 0.3 else 1
            wrench = np.round(rng.uniform(-20, 20, (each, 6)) * (rng.random(6) < 0.6), 1)
            wrench = wrench if each > 1 else wrench[0]
            options["wrench"] = wrench.tolist()
        if rng.random() < 0.3:
            given = ([0.0, 0.0, 9.81], [0.0, -9.81, 0.0], [0.0, 0.0, 0.0], [1.0, 2.0, -9.5])
            options["gravity"] = pick(rng, [*given, [0.0, 0.0, -9.8], [0.0, 0.0, -10.0]])
        if rng.random() < 0.08:
            options["tolerance"] = pick(rng, _TOLERANCES)
        gravity = np.array(options.get("gravity", GRAVITY))
        tau = _torques(rng, Load(arm, q, np.broadcast_to(wrench, (poses, 6)), gravity))
        if rng.random() < 0.15:
            tau = _reshaped_torques(rng, tau)
        asked = {"topic": "torques", "typed": written(rng, tau), "q": shown, "options": options}
        yield arm, asked


def _any_heavy(rng, arm_of: Callable) -> Arm:
    m = some_machine(rng)
    held = [Body(0.0 if rng.random() < 0.1 else mass, tuple(c)) for mass, *c in bodies(m, rng)]
    if len(held) != len(m.rows):
        return _any_heavy(rng, arm_of)
    return arm_of(m).with_bodies(held)


def _torques(rng, load: Load) -> np.ndarray:
    right = load.torques()
    what = chance(
        rng,
        {"right": 3, "single": 4, "pair": 3, "reversed": 2, "paper": 1, "signs": 2, "joints": 2,
         "besides": 2, "a pose": 2},
    )  # fmt: skip
    some = rng.random(right.shape[1]) < 0.4
    off = rng.uniform(0.05, 5, right.shape)
    if what in ("single", "besides"):
        tau = pick(rng, catalogue(load, 1)[1])
        return tau if what == "single" else np.where(some & (rng.random() < 0.5), tau + off, tau)
    if what == "pair":
        return pick(rng, catalogue(load, 2)[1])
    if what == "reversed":
        return pick(rng, reversed_joints(load, right)[1])
    if what == "paper":
        return pick(rng, paper_centres(load)[1])
    if what == "signs":
        return np.where(some, -right, right)
    if what == "joints":
        return np.where(some, right + off, right)
    if what == "a pose":
        k = int(rng.integers(len(right)))
        right[k] += pick(rng, [0.01, 0.1, 1.0]) * off[k] * some
    return right


def _reshaped_torques(rng, tau: np.ndarray) -> np.ndarray:
    return {
        "turned": tau.T,
        "zeros": np.c_[np.zeros(len(tau)), tau],
        "turned zeros": np.c_[np.zeros(len(tau)), tau].T,
        "one each": tau[:, 0],
        "fewer": tau[:, 1:] if tau.shape[1] > 1 else tau,
        "a pose less": tau[1:] if len(tau) > 1 else tau[:, :1],
    }[pick(rng, ["turned", "turned", "zeros", "turned zeros", "one each", "fewer", "a pose less"])]
