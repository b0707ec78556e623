"""Compare the UR10e's solution branches with ssik, which uses subproblems of screw axes.

ssik's arm comes from the robot description: its base is turned by half a turn and its tool frame
differs. The test computes the tool frame from one pose and checks it at others. The joint angles
are the maker's, as in our table.
"""

import os
import sys

import numpy as np
import pytest

from helpers.inverse import ur
from helpers.kinematics import forward_kinematics
from helpers.robots import UR10E

if os.environ.get("CI") and sys.platform == "linux":
    from ssik.prebuilt.universal_robots import ur10e_ik
else:
    ur10e_ik = pytest.importorskip(
        "ssik.prebuilt.universal_robots.ur10e_ik", reason="ssik is not installed here"
    )

BARE = UR10E.with_values(l_pen=0)
BASE = np.diag([-1.0, -1.0, 1.0, 1.0])


def test_ur10e_branches_match_ssik():
    q = np.random.default_rng(11).uniform(-np.pi, np.pi, (4000, 6))
    T = forward_kinematics(BARE, q)
    tool = np.linalg.inv(BASE @ T[0]) @ ur10e_ik.fk(q[0])
    theirs = np.array([ur10e_ik.fk(x) for x in q[:200]])
    np.testing.assert_allclose(BASE @ T[:200] @ tool, theirs, atol=1e-6)
    ours = ur(BARE, T)
    for k, pose in enumerate(BASE @ T @ tool):
        solutions = ur10e_ik.solve(pose, enumerate_windings=False, respect_limits=False)
        expected = np.array([solution.q for solution in solutions])
        actual = ours.q[k][ours.valid[k]]
        assert len(actual) == len(expected), f"pose {k} has another number of branches"
        gap = np.abs(np.angle(np.exp(1j * (actual[:, None] - expected)))).max(axis=-1)
        assert gap.min(axis=1).max() < 1e-3
        assert gap.min(axis=0).max() < 1e-3
