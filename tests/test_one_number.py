"""Test that one wrong number in right work is located, and that no cause is named.

The right numbers come from the corpus's own kinematics, and from Newton's method on them.
"""

import numpy as np
import pytest

from helpers import checks, motion, robots
from tests.corpus.arms import KNOWN

RNG = np.random.default_rng(7)
# For each arm its independent model, the start and the plane of a circle of radius 0.1 m.
CIRCLES = {
    "UR10E_HOMEWORK": (robots.UR10E_HOMEWORK, "UR10E_HOMEWORK", np.zeros(6), "xz"),
    "UR10E": (robots.UR10E, "UR10E", [-0.6, -1.5, 1.2, -0.1, 0.7, 1.2], "xz"),
    "STANFORD": (robots.STANFORD, "STANFORD", [-1.6, 1.1, 0.5, -0.9, 1.6, -0.1], "xz"),
    "ELBOW": (robots.ELBOW, "ELBOW", [0.3, 0.6, -1.1], "yz"),
    "PANDA": (robots.PANDA.lock(3), "PANDA.lock(3)", [1.1, 0.4, -0.9, 0.3, 2.1, -0.6], "yz"),
}


def solve_point(machine, q, point, tool):
    """Return the joint values at a point by Newton's method, with the tool's axes if not None."""
    q = np.array(q, float)
    for _ in range(50):
        T, J = machine.tip(q), machine.jacobian(q)
        error = point - T[:3, 3]
        if tool is not None:
            turn = sum(np.cross(T[:3, k], tool[:, k]) for k in range(3)) / 2
            error = np.r_[error, turn]
        step = np.linalg.pinv(J[: len(error)], rcond=1e-6) @ error
        q = q + np.clip(step, -0.2, 0.2)
    assert abs(error).max() < 1e-9
    return q


def trace_circle(name, steps):
    """Return the arm, the circle below the start's tip, and the exact joint values on it."""
    arm, key, start, plane = CIRCLES[name]
    machine, axes = KNOWN[key], ["xyz".index(letter) for letter in plane]
    T = machine.tip(start)
    centre = T[:3, 3].copy()
    centre[axes[1]] -= 0.1
    path = motion.circle(tuple(centre), 0.1, plane, 5.0, steps, phase=np.pi / 2)
    tool = T[:3, :3] if machine.dof >= 6 else None
    rows = [np.array(start, float)]
    for k in range(1, steps + 1):
        angle = np.pi / 2 + 2 * np.pi * k / steps
        point = centre.copy()
        point[axes] += 0.1 * np.array([np.cos(angle), np.sin(angle)])
        rows.append(solve_point(machine, rows[-1], point, tool))
    return arm, path, np.array(rows)


def write_rows(rows, decimals):
    return "\n".join("  ".join(f"{x:.{decimals}f}" for x in row) for row in rows)


@pytest.mark.parametrize("name", CIRCLES)
def test_one_wrong_number_of_trace_is_located(name):
    arm, path, q = trace_circle(name, 8)
    assert checks.compare_trace(write_rows(q, 4), arm, path).agrees
    numbers = [k for k, row in enumerate(arm.rows, 1) if row.joint.kind != "fixed"]
    for joint, decimals in enumerate((3, 4, 5, 6, 4, 3)[: arm.dof]):
        row = int(RNG.integers(9))
        wrong = q.copy()
        wrong[row, joint] += RNG.choice((-1, 1)) * RNG.uniform(0.1, 1.2)
        report = checks.compare_trace(write_rows(wrong, decimals), arm, path)
        assert not report.causes, str(report)
        assert f"only step {row} is wrong: joint {numbers[joint]} is off" in report.headline
        pieces = [piece for piece in report.marked_text.pieces if piece.kind == "wrong"]
        assert [piece.text for piece in pieces] == [f"{wrong[row, joint]:.{decimals}f}"]


def test_wrong_step_among_three_is_not_located():
    """With only three steps, the two others could be on the path by chance."""
    arm, path, q = trace_circle("ELBOW", 2)
    q[1, 1] += 0.4
    report = checks.compare_trace(write_rows(q, 4), arm, path)
    assert not report.agrees
    assert "only step" not in report.headline.lower(), str(report)


def test_wrong_number_of_unrounded_trace_is_located():
    """Numbers without typed decimals are exact, so the corrected row must fit to round-off."""
    arm, path, q = trace_circle("UR10E_HOMEWORK", 8)
    for joint in range(6):
        wrong = q.copy()
        wrong[4, joint] += 0.3
        report = checks.compare_trace(wrong, arm, path)
        assert f"only step 4 is wrong: joint {joint + 1} is off" in report.headline


@pytest.mark.parametrize("name", CIRCLES)
def test_one_wrong_number_of_pose_is_located(name):
    arm, key, start, _ = CIRCLES[name]
    machine = KNOWN[key]
    q = np.array(start, float) + 0.3
    T = machine.tip(q)
    for joint in range(arm.dof):
        wrong = q.copy()
        wrong[joint] += RNG.choice((-1, 1)) * RNG.uniform(0.1, 0.7)
        typed = " ".join(f"{x:.5f}" for x in wrong)
        report = checks.compare_pose(typed, arm, T if arm.dof >= 6 else T[:3, 3])
        number = [k for k, row in enumerate(arm.rows, 1) if row.joint.kind != "fixed"][joint]
        assert not report.causes, str(report)
        assert f"only q_{number} is wrong" in report.headline


# A student's solution of the circle around (0.4, 0, 0.6), in which q_3 of step 2 lost its sign.
ELBOW_ROWS = """0.000000,1.179288,-1.780667
0.174969,1.121558,-1.805692
0.244979,0.980753,1.866765
0.174969,0.833305,-1.929000
0.000000,0.768794,-1.955193
-0.174969,0.833305,-1.929000
-0.244979,0.980753,-1.866765
-0.174969,1.121558,-1.805692
0.000000,1.179288,-1.780667"""


def test_step_explained_by_two_joints_names_neither():
    """With the typed q_3, another q_2 would also bring the tip to the circle."""
    path = motion.circle((0.4, 0, 0.6), 0.1, "zy", 5.0, 8)
    report = checks.compare_trace(ELBOW_ROWS, robots.ELBOW, path)
    assert not report.causes, str(report)
    assert "only step 2 is wrong: its tip misses the target by" in report.headline
