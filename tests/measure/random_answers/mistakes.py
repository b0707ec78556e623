"""Make mistakes for twins: the right numbers with a single mistake.

Each mistake moves an asked number by 0.02 or more, which is more than the digits typed leave open.
"""

from dataclasses import replace
from random import Random

import numpy as np

from helpers import kinematics, statics
from helpers.arm import Arm
from tests.measure.random_answers.questions import Question, joint_kinds

_LEAST = 0.02


def draw_mistake(question: Question, rng: Random) -> tuple[str, Question]:
    """Return the name of a mistake and the question with the resulting wrong numbers."""
    if question.topic == "table":
        return _mistaken_table(question, rng)
    makers = [_moved, _moved, _sign, _exchanged, _degrees, _procedure, _procedure]
    while True:
        name, values = rng.choice(makers)(question, rng)
        if values is not None and _is_wrong(question, values):
            return name, replace(question, right=values)


def _moved(question: Question, rng: Random):
    values = question.right.copy()
    place = tuple(rng.randrange(n) for n in values.shape)
    values[place] += rng.choice((-1, 1)) * max(0.05, abs(values[place]) * rng.uniform(0.05, 0.5))
    return "number moved", values


def _sign(question: Question, rng: Random):
    values = question.right.copy()
    if question.topic == "trace":
        column = rng.randrange(values.shape[1])
        values[:, column] *= -1
        return "sign of a joint", values
    places = np.argwhere(abs(values) > _LEAST)
    if not len(places):
        return "sign", None
    place = tuple(places[rng.randrange(len(places))])
    values[place] *= -1
    return "sign", values


def _exchanged(question: Question, rng: Random):
    values = question.right.copy()
    if values.shape[1] < 2:
        return "exchanged", None
    i, j = rng.sample(range(values.shape[1]), 2)
    rows = slice(None) if question.topic == "trace" else rng.randrange(len(values))
    values[rows, i], values[rows, j] = question.right[rows, j], question.right[rows, i]
    return "exchanged", values


def _degrees(question: Question, rng: Random):
    """Compute with degrees used as radians.

    Joint values converted once too often are left out: where no unit is typed, they are right.
    """
    if question.topic not in ("jacobian", "torques"):
        return "degrees", None
    angles = np.array([kind == "angle" for kind in joint_kinds(question.arm)])
    # Remove whole turns, which change nothing, because large angles would give a warning.
    turned = np.remainder(np.rad2deg(question.q) + np.pi, 2 * np.pi) - np.pi
    q = np.where(angles, turned, question.q)
    if question.topic == "jacobian":
        return "degrees", kinematics.jacobian(question.arm, q)
    tau = statics.static_torque(question.arm, q, question.wrench)
    return "degrees", np.atleast_2d(tau)


def _procedure(question: Question, rng: Random):
    """Make a mistake of procedure, as students make them."""
    if question.topic == "jacobian":
        return _wrong_jacobian(question, rng)
    if question.topic == "torques":
        return _wrong_torques(question, rng)
    return "procedure", None


def _wrong_jacobian(question: Question, rng: Random):
    arm, q = question.arm, question.q
    T = kinematics.link_frames(arm, q)
    name = rng.choice(("axis z_i", "origin o_i", "cross product turned round", "row of the table"))
    if name == "row of the table":
        return name, kinematics.jacobian(_with_wrong_row(arm, rng), q)
    columns = []
    for joint, kind in zip(question.joints, joint_kinds(arm), strict=True):
        z = T[joint if name == "axis z_i" else joint - 1][:3, 2]
        origin = T[joint if name == "origin o_i" else joint - 1][:3, 3]
        lever = T[-1][:3, 3] - origin
        v = np.cross(lever, z) if name.startswith("cross") else np.cross(z, lever)
        columns.append(np.r_[v, z] if kind == "angle" else np.r_[z, 0, 0, 0])
    return name, np.array(columns).T


def _with_wrong_row(arm: Arm, rng: Random) -> Arm:
    """Exchange a and d of one row."""
    rows = list(arm.rows)
    pool = [
        i
        for i in range(1, len(rows) - 1)
        if rows[i].joint.kind != "prismatic"
        and abs(abs(arm.number(rows[i].a)) - abs(arm.number(rows[i].d))) > _LEAST
    ]
    if not pool:
        return arm
    i = rng.choice(pool)
    rows[i] = replace(rows[i], a=rows[i].d, d=rows[i].a)
    return replace(arm, rows=tuple(rows))


def _wrong_torques(question: Question, rng: Random):
    arm, q, F = question.arm, question.q, np.array(question.wrench, float)
    name = rng.choice(
        ("force turned round", "gravity turned round", "no pen", "masses one row off")
    )
    gravity = statics.GRAVITY
    if name == "force turned round":
        F = -F
    elif name == "gravity turned round":
        gravity = (0, 0, 9.81)
    elif name == "no pen":
        arm = arm.with_values(l_pen=0)
    else:
        masses = [body.mass for body in arm.bodies]
        shifted = masses[1:] + masses[:1]
        bodies = (replace(b, mass=m) for b, m in zip(arm.bodies, shifted, strict=True))
        arm = replace(arm, bodies=tuple(bodies))
    return name, np.atleast_2d(statics.static_torque(arm, q, F, gravity))


def _mistaken_table(question: Question, rng: Random) -> tuple[str, Question]:
    """Change a length (not d_1), change a twist, or exchange a and d."""
    arm = question.arm
    name = rng.choice(("length moved", "length moved", "twist", "a and d exchanged"))
    if name == "a and d exchanged":
        wrong = _with_wrong_row(arm, rng)
        if wrong == arm:
            name = "length moved"
    if name == "twist":
        rows = list(arm.rows)
        pool = [i for i, row in enumerate(rows[:-1]) if abs(np.sin(arm.number(row.alpha))) > 0.5]
        i = rng.choice(pool)
        rows[i] = replace(rows[i], alpha="0")
        wrong = replace(arm, rows=tuple(rows))
    elif name == "length moved":
        symbol = rng.choice([x for x in arm.values if x != "d_1"])
        moved = round(arm.values[symbol] * rng.choice((0.8, 1.15, 1.3)) + 0.03, 4)
        wrong = arm.with_values(**{symbol: moved})
    return name, replace(question, arm=wrong)


def _is_wrong(question: Question, values: np.ndarray) -> bool:
    """Check that the mistaken numbers are not another right answer."""
    if not np.isfinite(values).all() or abs(values - question.right).max() < _LEAST:
        return False
    if question.topic in ("jacobian", "torques"):
        return True
    arm = question.arm
    there = kinematics.forward_kinematics(arm, values)
    if question.topic == "branches":
        return any(_misses(pose, question.target) for pose in there)
    if question.topic == "pose":
        return _misses(there[0], question.target)
    wanted = kinematics.forward_kinematics(arm, question.right)
    return bool(abs(there - wanted)[:, :3, 3].max() > _LEAST)


def _misses(pose: np.ndarray, target: np.ndarray) -> bool:
    if target.ndim == 1:
        return bool(abs(pose[:3, 3] - target).max() > _LEAST / 2)
    return bool(abs(pose - target).max() > _LEAST / 2)
