"""Verdicts read as a teacher would: brief, kind, in the student's numbers and units, with the next
step, and without the solution.
"""

import numpy as np
import pytest

from helpers import checks
from helpers.arm import Arm
from helpers.inverse import elbow
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E
from helpers.statics import static_torque
from tests.corpus.arms import KNOWN

BENT = [0.4, -0.3, 0.5, 0.9, -0.6, 0.8, 0.2]
LOCKED = PANDA.lock(3)
Q = np.delete(BENT, 2)
J = KNOWN["PANDA.lock(3)"].jacobian(Q)
FOUND = elbow(ELBOW, (0.3, 0.2, 0.7))
WRONG_SIGN = """-s1*(0.4*c2+0.3*c23), c1*(0.4*s2+0.3*s23), -0.3*c1*s23
c1*(0.4*c2+0.3*c23), -s1*(0.4*s2+0.3*s23), -0.3*s1*s23
0, 0.4*c2+0.3*c23, 0.3*c23
0, s1, s1\n0, -c1, -c1\n1, 0, 0"""
# As the maker's documentation has it, in Craig's convention, up to the flange.
FRANKA = """a d alpha theta
0 0.333 0 θ1
0 0 -π/2 θ2
0 0.316 π/2 θ3
0.0825 0 π/2 θ4
-0.0825 0.384 -π/2 θ5
0 0 π/2 θ6
0.088 0 π/2 θ7
0 0.107 0 0"""
PEN_APART = """(0, 90, 333, 0), (0, -90, 0, 0), (82.5, -90, 316, 0), (-82.5, 90, 0, 0),
(0, 90, 384, 0), (88, -90, 0, 0), (0, 0, -107, 0), (0, 0, -100, 0)"""
PANDA_ROWS = """theta d a alpha
q1 0.333 0 pi/2
q2 0 0 -pi/2
{} 0.316 0.0825 -pi/2
q4 0 {} pi/2
q5 0.384 0 pi/2
q6 0 0.088 -pi/2
q7 -0.207 0 0"""
SLIDE = "q1 0 0 -90\nq2 0.154 0 90\n0 -d3 0 0\nq4 0 0 -90\nq5 0 0 90\nq6 0.263 0 0"


def table(text, arm):
    return lambda: checks.compare_tables(text, arm)


def J_of(mine, arm=LOCKED, q=Q, **how):
    return lambda: checks.compare_jacobian(mine, arm, q, **how)


def torques(mine):
    return lambda: checks.compare_torques(mine, PANDA, BENT, [-5, 0, 0, 0, 0, 0])


TAU = static_torque(PANDA, BENT, [-5, 0, 0, 0, 0, 0])
UR = [0.1, -1.2, 0.8, -0.5, 0.3, 0.2]
THERE = forward_kinematics(UR10E, UR).round(4)
WITHOUT_PEN = forward_kinematics(UR10E.with_values(l_pen=0), UR).round(4)
LIST = [
    (table(PEN_APART, PANDA), "same arm as Panda.", "Taken as not moving: row 8"),
    (table(FRANKA, PANDA), "the pen is forgotten", "and besides, the rows are in the modified"),
    (table(PANDA_ROWS.format("q3", "0.0825"), PANDA), "row 4 has the wrong sign (you have 0.0825)"),
    (table(PANDA_ROWS.format("0", "-0.0825"), PANDA), "6 in yours and 7 in the", "locked"),
    (table("theta d(in) a(in) alpha\nq1 19.685 0 90\nq2 0 15.748 0\nq3 0 11.811 0", ELBOW), "same"),
    (table(SLIDE, STANFORD), "counted backwards in row 3,"),
    (J_of(WRONG_SIGN, ELBOW, None), "column 2 (joint 2): turn the sign of vx."),
    (J_of(np.zeros((6, 6))), "every entry is 0"),
    (J_of(np.cos(np.arange(36.0)).reshape(6, 6)), "in any column", "Begin with column 1: which"),
    (J_of(J, q=np.degrees(Q)), 'say angles="deg"'),
    (J_of(jacobian(ELBOW, [0.5, 0.7, -0.4]).T, ELBOW, [0.5, 0.7, -0.4]), "it is transposed"),
    (torques(TAU + np.eye(7)[3]), "Joint 4: off by 1 N m."),
    (torques([1, 2, 3, 4, 5, 6]), "its shape is 6; give 7, one torque for each of 7 joints."),
    (lambda: checks.compare_branches(FOUND.q[:2], FOUND), "face the same way", "Turn joint 1"),
    (lambda: checks.compare_branches([FOUND.q[0]] * 2, FOUND), "Answers 1 and 2 are the same"),
    (lambda: checks.compare_pose(np.degrees(UR), UR10E, THERE), "misses the target by 1820 mm"),
    (lambda: checks.compare_pose(UR, UR10E, WITHOUT_PEN), "by 100 mm: the pen is forgotten"),
]


@pytest.mark.parametrize("case", LIST)
def test_a_verdict_says_this(case):
    asked, *words = case
    said = str(asked())
    assert all(some in said for some in words), said


def test_what_is_wrong_everywhere_is_said_once():
    report = J_of(np.cos(np.arange(36.0)).reshape(6, 6))()
    assert report.grade == "wrong"
    assert len(report.lines) == 6
    shape = checks.compare_jacobian(np.ones((6, 5)), LOCKED, Q)
    assert not shape.lines
    assert shape.causes == ("J.shape",)


def test_what_is_missing_is_listed_only_beside_what_is_found():
    lean = FOUND.q[0] + [0, 0.2, 0]
    assert "Missing" not in str(checks.compare_branches([lean], FOUND))
    assert "Missing" in str(checks.compare_branches([FOUND.q[0]], FOUND))


def test_a_table_without_heads_may_have_more_slides_than_turns():
    slides = Arm.from_table("alpha a theta d\npi/2 0.4 q1 0\n-pi/2 0.3 0 q2\n0 0.2 0 q3")
    report = checks.compare_tables("1.5708,0.4,q1,0\n-1.5708,0.3,0,q2\n0,0.2,0,q3", slides)
    assert report.agrees, str(report)


ADVICE = [
    (lambda: checks.compare_jacobian(np.vstack([J[3:], J[:3]]), UR10E, Q, angular_first=True), ""),
    (J_of(np.vstack([J[3:], J[:3]]), q=np.degrees(Q)), '"deg", say angular_first=True'),
    (table(FRANKA, PANDA.with_values(l_pen=0)), 'say convention="craig"'),
    (table("q1 0.5 0 90\nq2+30 0 0.4 0\nq3 0 0.3 0", ELBOW), 'is report.figures["arm"]'),
]


@pytest.mark.parametrize("case", ADVICE)
def test_advice_names_the_argument_that_sets_it(case):
    asked, words = case
    advice = asked().advice
    assert words in ", ".join(one.partition("mean, ")[2] or one for one in advice)
    assert all(one in asked().lines for one in advice)
    assert words or not advice
