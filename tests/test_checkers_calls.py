"""Functions as students write them, called as they ask; and answers so near zero that their units
cannot be told.
"""

import numpy as np
import sympy as sp

from helpers import checks, inverse
from helpers.arm import Arm
from helpers.kinematics import forward_kinematics
from helpers.robots import UR10E_HOMEWORK
from tests.corpus.arms import KNOWN


def test_one_joint_by_itself():
    x = sp.Symbol("x")
    one = Arm.from_table("q1 0 0.4 0")
    turn = sp.Matrix([-0.4 * sp.sin(x), 0.4 * sp.cos(x), 0, 0, 0, 1])
    for asked in (x, [x], [[x]]):
        assert checks.compare_jacobian(sp.lambdify(asked, turn), one).agrees


# Near zero


HOME = forward_kinematics(UR10E_HOMEWORK, np.zeros(6))


def test_a_joint_off_at_home_is_no_matter_of_degrees():
    found = inverse.ur(UR10E_HOMEWORK, HOME)
    report = checks.compare_branches([[0, 0, 0, 0, 0, 0.25]], found)
    assert report.causes == ()
    assert "misses the target by 0 mm and 14.3°: q_6 agrees with no branch" in str(report)
    assert "the 8 branches are only 1 here" in str(report)
    assert checks.compare_branches([[0.0] * 6], found).grade == "right"
    pose = checks.compare_pose([0, 0, 0, 0, 0, 0.1], UR10E_HOMEWORK, HOME)
    assert "ik.degrees" not in pose.causes


def test_a_near_miss_at_home_says_by_how_much():
    """Joint 6 turned by 0.1 and the others as well as can be: 0.615 mm and 0.11 mrad remain."""
    best = inverse.solve(UR10E_HOMEWORK.lock(6, 0.1), HOME, np.zeros(5), limits=False)
    found = inverse.ur(UR10E_HOMEWORK, HOME)
    for digits in (16, 5, 4):
        q = np.round([*best.q, 0.1], digits)
        words = str(checks.compare_branches([q], found))
        assert "misses the target by 0.6" in words
        assert "not in the list" not in words


def test_an_angle_near_zero_has_no_wrong_sign():
    found = inverse.ur(UR10E_HOMEWORK, HOME)
    assert not checks.compare_branches([[0, 0, 0, 0, 0, -0.04]], found).causes


def test_whole_degrees_that_are_exact_are_right():
    T = KNOWN["UR10E_HOMEWORK"].tip(np.radians([30, -40, 90, 20, 45, 60]))
    found = inverse.ur(UR10E_HOMEWORK, T)
    exact = [q for q in np.degrees(found.q[found.valid]) if abs(q - np.round(q)).max() < 1e-6]
    report = checks.compare_branches(np.round(exact), found, angles="deg")
    assert exact
    assert "two more" not in report.headline
