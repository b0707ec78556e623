"""Draw questions of the six topics at random, with their right numbers."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cache, partial
from random import Random
from typing import Any

import numpy as np

from helpers import checks, inverse, kinematics, motion, robots, statics
from helpers.arm import Arm

TOPICS = ("table", "jacobian", "torques", "trace", "branches", "pose")
#: Arms with masses, for questions about torques.
HEAVY_ARMS = tuple(arm for arm in robots.ARMS if arm.bodies)
DISPLACED_ELBOW = robots.ELBOW.with_values(d=0.1)


@dataclass(frozen=True)
class Question:
    """A question and its right answer.

    Attributes:
        topic: one of TOPICS.
        arm: the arm as the judge gets it.
        right: right numbers of shape (rows, columns); SI units.
        kinds: for each column "angle", "length", "torque" or "number".
        joints: joint number of each column, where columns are joints.
        q: joint values of the question, where it has any.
        wrench: force and moment on the tool.
        target: pose (4, 4) or point (3,) to be reached.
        extra: object that only the judge needs (path or solutions).
    """

    topic: str
    arm: Arm
    right: np.ndarray
    kinds: tuple[str, ...]
    joints: tuple[int, ...] = ()
    q: np.ndarray | None = None
    wrench: tuple[float, ...] = (0.0,) * 6
    target: np.ndarray | None = None
    extra: Any = field(default=None, compare=False)


def draw_question(rng: Random, topic: str) -> Question:
    """Draw a question of a topic with its right numbers."""
    return _DRAW[topic](rng)


def ask_judge(question: Question, text: str, angles: str) -> Any:
    """Return the report on a pasted text, or raise ArmError if the judge refuses it.

    Args:
        question: what is asked.
        text: the pasted answer.
        angles: "rad" or "deg", the setting beside the field.
    """
    arm, q = question.arm, question.q
    if question.topic == "table":
        return checks.compare_tables(text, arm)
    if question.topic == "jacobian":
        return checks.compare_jacobian(text, arm, q)
    if question.topic == "torques":
        return checks.compare_torques(text, arm, q, question.wrench)
    if question.topic == "trace":
        return checks.compare_trace(text, arm, question.extra, angles=angles)
    if question.topic == "branches":
        return checks.compare_branches(text, question.extra, angles=angles)
    return checks.compare_pose(text, arm, question.target, angles=angles)


def joint_kinds(arm: Arm) -> tuple[str, ...]:
    """Return "angle" or "length" for each moving joint."""
    moving = [row for row in arm.rows if row.joint.kind != "fixed"]
    return tuple("length" if row.joint.kind == "prismatic" else "angle" for row in moving)


def _draw_table(rng: Random) -> Question:
    arm = rng.choice(robots.ARMS)
    rows = [
        [arm.number(entry) for entry in (row.a, row.alpha, row.d, row.theta)] for row in arm.rows
    ]
    return Question("table", arm, np.array(rows), ("length", "angle", "length", "angle"))


def _pose_of_joints(arm: Arm, rng: Random) -> np.ndarray:
    """Draw joint values that people type: home, round angles, or two decimals."""
    kinds = joint_kinds(arm)
    style = rng.choices(("home", "round", "decimals"), (25, 30, 45))[0]
    if style == "home":
        return np.array(arm.home, float)
    if style == "round":
        turns = [rng.choice((-6, -4, -3, -2, 2, 3, 4, 6)) * np.pi / 12 for _ in kinds]
        return np.array([0.4 if k == "length" else x for k, x in zip(kinds, turns, strict=True)])
    return np.array(
        [
            round(rng.uniform(0.2, 0.9), 2)
            if kind == "length"
            else round(rng.uniform(-2.4, 2.4), 2)
            for kind in kinds
        ]
    )


def _draw_jacobian(rng: Random) -> Question:
    arm = rng.choice(robots.ARMS)
    if arm.dof == 7 and rng.random() < 0.5:
        arm = arm.lock(3)
    q = _pose_of_joints(arm, rng)
    J = kinematics.jacobian(arm, q)
    joints = _joint_numbers(arm)
    return Question("jacobian", arm, J, ("number",) * arm.dof, joints, q)


def _joint_numbers(arm: Arm) -> tuple[int, ...]:
    return tuple(i for i, row in enumerate(arm.rows, 1) if row.joint.kind != "fixed")


def _draw_torques(rng: Random) -> Question:
    arm = rng.choice(HEAVY_ARMS)
    wrench = rng.choice(((-5, 0, 0, 0, 0, 0), (0, -5, 0, 0, 0, 0), (0.0,) * 6))
    if rng.random() < 0.8:
        q = _pose_of_joints(arm, rng)
        tau = statics.static_torque(arm, q, wrench)[None]
    else:
        count = rng.choice((2, 3, 4, 5))
        q = np.array([[round(rng.uniform(-2, 2), 2) for _ in range(arm.dof)] for _ in range(count)])
        tau = statics.static_torque(arm, q, wrench)
    return Question("torques", arm, tau, ("torque",) * arm.dof, _joint_numbers(arm), q, wrench)


# Start configurations whose whole circle is well inside the workspace.
_STARTS = {
    "Panda": ((1.1, 0.4, 1.6, -0.9, 2.1, -0.6), "zy"),
    "Panda (homework)": ((1.1, 0.4, 1.6, -0.9, 2.1, -0.6), "zy"),
    "UR10e (homework)": ((-1.6, 1.1, -0.8, -0.9, 1.6, -0.1), "xz"),
    "UR10e": ((-0.6, -1.5, 1.2, -0.1, 0.7, 1.2), "xz"),
    "Stanford arm": ((-1.6, 1.1, 0.5, -0.9, 1.6, -0.1), "xz"),
    "Elbow arm": ((0.3, 0.6, -1.1), "yz"),
}


@cache
def _traced(name: str, radius: float, steps: int) -> tuple[Arm, motion.Path, np.ndarray]:
    """Return arm, path and exact joint values of a circle."""
    start, plane = _STARTS[name]
    arm = next(arm for arm in robots.ARMS if arm.name == name)
    arm = arm.lock(3) if name.startswith("Panda") else arm
    path = motion.circle_below(arm, start, radius, plane, 5, steps)
    if arm.dof == 3:
        return arm, path, inverse.follow(partial(inverse.elbow, arm), path.positions, start)
    return arm, path, motion.trace(arm, start, path, method="exact").q


def _draw_trace(rng: Random) -> Question:
    name = rng.choice([arm.name for arm in robots.ARMS])
    steps = rng.choice((10, 20, 20, 40))
    arm, path, q = _traced(name, rng.choice((0.1, 0.05)), steps)
    return Question("trace", arm, q, joint_kinds(arm), _joint_numbers(arm), extra=path)


def _solver_of(arm: Arm) -> Callable:
    if arm.name.startswith("UR"):
        return inverse.ur
    return inverse.stanford if arm.name.startswith("Stanford") else inverse.elbow


def _draw_branches(rng: Random) -> Question:
    pool = (robots.ELBOW, DISPLACED_ELBOW, robots.STANFORD, robots.UR10E, robots.UR10E_HOMEWORK)
    while True:
        arm = rng.choice(pool)
        q = _pose_of_joints(arm, rng)
        T = kinematics.forward_kinematics(arm, q)
        target = np.round(T[:3, 3], 3) if arm.dof == 3 else T
        solutions = _solver_of(arm)(arm, target)
        rows = solutions.q[solutions.valid]
        if (
            len(rows) < 2
            or solutions.free[solutions.valid].any()
            or not (solutions.times < 2).all()
        ):
            continue
        order = rng.sample(range(len(rows)), len(rows))
        kinds, joints = joint_kinds(arm), _joint_numbers(arm)
        return Question("branches", arm, rows[order], kinds, joints, target=target, extra=solutions)


def _draw_pose(rng: Random) -> Question:
    arm = rng.choice(robots.ARMS)
    if arm.dof == 7 and rng.random() < 0.4:
        arm = arm.lock(3)
    kinds = joint_kinds(arm)
    q = _pose_of_joints(arm, rng)
    if rng.random() < 0.5:  # half of the time, not round, as from a numeric solver
        q = np.array(
            [
                rng.uniform(0.2, 0.9) if kind == "length" else rng.uniform(-2.4, 2.4)
                for kind in kinds
            ]
        )
    T = kinematics.forward_kinematics(arm, q)
    target = T if arm.dof >= 6 else T[:3, 3]
    return Question("pose", arm, q[None], kinds, _joint_numbers(arm), target=target)


_DRAW = dict(
    table=_draw_table,
    jacobian=_draw_jacobian,
    torques=_draw_torques,
    trace=_draw_trace,
    branches=_draw_branches,
    pose=_draw_pose,
)
