"""Time inverse kinematics: all branches of the UR10e, one numeric solution of the Panda."""

import eaik.IK_DH
import numpy as np
import ur_analytic_ik
from kinematics import BARE, ets

from helpers.inverse import solve, ur
from helpers.kinematics import forward_kinematics
from helpers.robots import PANDA, UR10E

POSES = 1000
UR = UR10E.with_values(l_pen=0)


def branch_signature(branches) -> np.ndarray:
    """Return numbers that do not depend on the order of each pose's branches, shape (n, 13).

    They are the count of branches, and the sums of each angle's cosines and sines.
    """
    sums = [np.exp(1j * np.reshape(q, (-1, 6))).sum(axis=0) for q in branches]
    return np.column_stack([[len(q) for q in branches], np.real(sums), np.imag(sums)])


def helpers_signature(solutions) -> np.ndarray:
    return branch_signature(
        [q[valid] for q, valid in zip(solutions.q, solutions.valid, strict=True)]
    )


def eaik_signature(solutions) -> np.ndarray:
    """Return the signature of EAIK's exact solutions, without its least-squares approximations."""
    return branch_signature([pose.Q[~np.array(pose.is_LS)] for pose in solutions])


def closed_forms(Case):
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
            helpers_signature(solutions)
            if hasattr(solutions, "valid")
            else eaik_signature(solutions)
            if hasattr(solutions[0], "is_LS")
            else branch_signature(solutions)
        ),
    )


def numeric(Case):
    rng = np.random.default_rng(0)
    q = rng.uniform(*PANDA.limits, (POSES, 7))
    T, start = (
        forward_kinematics(BARE, q),
        np.clip(q + rng.uniform(-0.2, 0.2, q.shape), *PANDA.limits),
    )
    chain = ets()

    def roboticstoolbox():
        """Solve with the fastest settings; retry failures with the default 100 random starts.

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


def cases(Case):
    yield closed_forms(Case)
    yield numeric(Case)
