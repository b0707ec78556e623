"""Compare solution branches of random arms with EAIK, for the structures that EAIK solves.

EAIK's flag `is_LS` is not used: solutions of EAIK that miss the pose are left out. The arms have no
antiparallel neighbours, with which EAIK lacks branches.
"""

import numpy as np
import pytest

from helpers.inverse import solutions
from helpers.kinematics import forward_kinematics
from tests.laws import joint_difference
from tests.test_any_arm import STRUCTURES, random_arm, random_q

KNOWN_TO_EAIK = (
    "wrist, axes 2 and 3 parallel",
    "wrist, axes 1 and 2 parallel",
    "wrist, axes 1 and 2 meet",
    "wrist, axes 2 and 3 meet",
    "first three meet, 5 and 6 parallel",
    "first three meet, 4 and 5 parallel",
    "1 to 3 parallel, 5 and 6 meet",
    "2 to 4 parallel, 5 and 6 meet",
    "3 to 5 parallel, 1 and 2 meet",
    "4 to 6 parallel, 1 and 2 meet",
)


def arm_without_antiparallel_axes(rng, name):
    """Return a random arm of a structure whose parallel axes point the same way."""
    while True:
        arm = random_arm(rng, *STRUCTURES[name])
        if not any(np.isclose(arm.number(row.alpha), np.pi) for row in arm.rows):
            return arm


@pytest.fixture
def dh():
    return pytest.importorskip("eaik.IK_DH", reason="EAIK is not installed here")


def eaik_branches(dh, arm, targets):
    """Return EAIK's solutions that reach their pose, one array (k, 6) for each target."""
    table = [
        [arm.number(getattr(row, c)) for row in arm.rows] for c in ("alpha", "a", "d", "theta")
    ]
    alpha, a, d, theta = np.array(table)
    branches = []
    answers = dh.DhRobot(alpha, a, d).IK_batched(targets, 1)
    for target, answer in zip(targets, answers, strict=True):
        q = np.reshape(answer.Q, (-1, 6)) - theta
        error = np.abs(forward_kinematics(arm, q) - target).max(axis=(1, 2))
        branches.append(q[error < 1e-6])
    return branches


@pytest.mark.parametrize("name", KNOWN_TO_EAIK)
def test_branches_of_random_arms_match_eaik(dh, name):
    rng = np.random.default_rng(3)
    for _ in range(5):
        arm = arm_without_antiparallel_axes(rng, name)
        targets = forward_kinematics(arm, random_q(arm, 20, rng))
        ours = solutions(arm, targets)
        for k, theirs in enumerate(eaik_branches(dh, arm, targets)):
            known = ours.q[k][ours.valid[k]]
            gap = joint_difference(arm, known[:, None], theirs[None])
            assert (gap.min(axis=0, initial=np.inf) < 1e-3).all(), (name, arm, k)
            assert (gap.min(axis=1, initial=np.inf) < 1e-3).all(), (name, arm, k)
