"""Time inverse kinematics in closed form and by iteration.

The closed forms give all branches of the UR10e and of random arms of each structure that EAIK
solves. The iteration gives a solution of the Panda.
"""

import eaik.IK_DH
import numpy as np
import ur_analytic_ik
from kinematics import BARE, make_toolbox_chain

from helpers.arm import Arm, revolute
from helpers.inverse import solutions, solve, ur
from helpers.kinematics import forward_kinematics
from helpers.robots import PANDA, UR10E

POSES = 1000
UR = UR10E.with_values(l_pen=0)
# Rows whose next axis is parallel, rows whose next axis meets theirs, and the row after which three
# axes meet in a point.
STRUCTURES = {
    "wrist, axes 2 and 3 parallel": ((1,), (), 3),
    "wrist, axes 1 and 2 parallel": ((0,), (), 3),
    "wrist, axes 1 and 2 meet": ((), (0,), 3),
    "wrist, axes 2 and 3 meet": ((), (1,), 3),
    "first three axes meet, 5 and 6 parallel": ((4,), (), 0),
    "first three axes meet, 4 and 5 parallel": ((3,), (), 0),
    "axes 1 to 3 parallel, 5 and 6 meet": ((0, 1), (4,), None),
    "axes 2 to 4 parallel, 5 and 6 meet": ((1, 2), (4,), None),
    "axes 3 to 5 parallel, 1 and 2 meet": ((2, 3), (0,), None),
    "axes 4 to 6 parallel, 1 and 2 meet": ((3, 4), (0,), None),
}


def sum_branches(branches) -> np.ndarray:
    """Return numbers that do not depend on the order of each pose's branches, shape (n, 13).

    They are the count of branches, and the sums of each angle's cosines and sines.
    """
    sums = [np.exp(1j * np.reshape(q, (-1, 6))).sum(axis=0) for q in branches]
    return np.column_stack([[len(q) for q in branches], np.real(sums), np.imag(sums)])


def sum_helpers_branches(solutions) -> np.ndarray:
    return sum_branches([q[valid] for q, valid in zip(solutions.q, solutions.valid, strict=True)])


def sum_eaik_branches(solutions) -> np.ndarray:
    """Return the signature of EAIK's exact solutions, without its least-squares approximations."""
    return sum_branches([pose.Q[~np.array(pose.is_LS)] for pose in solutions])


def make_closed_form_case(Case):
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (POSES, 6))
    T = forward_kinematics(UR, q)
    alpha, a, d = (
        np.array([UR.number(getattr(row, name)) for row in UR.rows]) for name in ("alpha", "a", "d")
    )
    robot = eaik.IK_DH.DhRobot(alpha, a, d)
    solve_ur10e = ur_analytic_ik.ur10e.inverse_kinematics
    return Case(
        f"UR10e: all branches of {POSES} poses",
        lambda: ur(UR, T),
        {
            "EAIK, batched, 1 thread": lambda: robot.IK_batched(T, 1),
            "EAIK, batched, 2 threads": lambda: robot.IK_batched(T, 2),
            "EAIK, one by one": lambda: [robot.IK(pose) for pose in T],
            "ur-analytic-ik, one by one": lambda: [solve_ur10e(pose) for pose in T],
        },
        tolerance=1e-4,
        comparable=lambda solutions: (
            sum_helpers_branches(solutions)
            if hasattr(solutions, "valid")
            else sum_eaik_branches(solutions)
            if hasattr(solutions[0], "is_LS")
            else sum_branches(solutions)
        ),
    )


def draw_table(rng, parallel, meeting, wrist) -> np.ndarray:
    """Return random rows (a, alpha, d, theta) of an arm with a structure, shape (6, 4)."""
    rows = rng.uniform((0.1, 0.4, -0.5, 0), (0.6, 2.7, 0.5, 0), (6, 4))
    rows[list(parallel), 1] = 0
    rows[list(meeting), 0] = 0
    if wrist is not None:
        rows[wrist : wrist + 2, 0] = rows[wrist + 1, 2] = 0
    return rows


def make_structure_case(Case, name, structure):
    """Return the case of a random arm.

    EAIK's solutions count if they reach the pose.
    """
    rng = np.random.default_rng(0)
    table = draw_table(rng, *structure)
    arm = Arm(name, [revolute(*map(float, row)) for row in table])
    T = forward_kinematics(arm, rng.uniform(-np.pi, np.pi, (POSES, 6)))
    robot = eaik.IK_DH.DhRobot(table[:, 1], table[:, 0], table[:, 2])

    def reaching(pose, q):
        return q[np.abs(forward_kinematics(arm, q) - pose).max(axis=(1, 2)) < 1e-6]

    def comparable(answer):
        if hasattr(answer, "valid"):
            return sum_helpers_branches(answer)
        pairs = zip(T, answer, strict=True)
        return sum_branches([reaching(pose, one.Q.reshape(-1, 6)) for pose, one in pairs])

    return Case(
        f"{name}: all branches of {POSES} poses",
        lambda: solutions(arm, T),
        {"EAIK, batched, 1 thread": lambda: robot.IK_batched(T, 1)},
        tolerance=1e-4,
        comparable=comparable,
    )


def make_numeric_case(Case):
    rng = np.random.default_rng(0)
    q = rng.uniform(*PANDA.limits, (POSES, 7))
    T, start = (
        forward_kinematics(BARE, q),
        np.clip(q + rng.uniform(-0.2, 0.2, q.shape), *PANDA.limits),
    )
    chain = make_toolbox_chain()

    def roboticstoolbox():
        """Solve with the fastest settings, and failures with the default 100 random starts.

        The tolerance bounds half the squared error: 5e-21 stands for 1e-10.
        """
        solutions = np.empty_like(q)
        for k, (pose, near) in enumerate(zip(T, start, strict=True)):
            fast = dict(slimit=1, joint_limits=False, method="sugihara", k=1e-4)
            answer = chain.ik_LM(pose, q0=near, tol=5e-21, **fast)
            solutions[k] = (answer if answer.success else chain.ik_LM(pose, q0=near, tol=5e-21)).q
        return solutions

    return Case(
        f"Panda: {POSES} poses to 1e-10, starts within 0.2 rad",
        lambda: solve(BARE, T, start).q,
        {"roboticstoolbox ik_LM (C++)": roboticstoolbox},
        tolerance=1e-9,
        comparable=lambda q: forward_kinematics(BARE, q),
    )


def list_cases(Case):
    yield make_closed_form_case(Case)
    yield from (make_structure_case(Case, *item) for item in STRUCTURES.items())
    yield make_numeric_case(Case)
