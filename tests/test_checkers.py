"""Test the checks on work in the forms in which students submit it.

The right numbers and those of each slip of the errata come from the corpus's own kinematics, or
from the plane triangle of links 2 and 3.
"""

import math

import numpy as np
import pytest
import sympy as sp

from helpers import checks
from helpers.arm import Arm, ArmError
from helpers.inverse import elbow
from helpers.motion import circle
from helpers.robots import ELBOW, PANDA, UR10E_HOMEWORK
from tests.cases import questions_about
from tests.corpus.arms import KNOWN
from tests.corpus.jacobians import recipe
from tests.corpus.traces import Task

H = math.pi / 2
Q = [0.5, -0.4, 0.7]
BENT = [0.4, -0.3, 0.5, 0.9, -0.6, 0.8, 0.2]
J3 = KNOWN["ELBOW"].jacobian(Q)
q1, q2, q3 = sp.symbols("q_1 q_2 q_3")


def test_jacobian_tolerance_is_applied():
    off = J3 + 1e-3
    assert checks.compare_jacobian(off, ELBOW, Q, tolerance=1.1e-3).agrees
    assert checks.compare_jacobian(off, ELBOW, Q, tolerance=0.9e-3).grade == "wrong"


# Types of input


c, s = sp.cos, sp.sin
t1, t2, t3 = sp.symbols("theta1:4", real=True)
PLANAR = Arm.from_table("theta d a alpha\nq1 0 0.4 0\nq2 0 0.3 0")
T = sp.Symbol("t")
x1, x2 = (sp.Function(n)(T) for n in ("theta1", "theta2"))


def planar(a, b):
    """Return the Jacobian, by hand, of two links of 0.4 and 0.3 m in a plane."""
    low, high = 0.4 * s(a), 0.3 * s(a + b)
    right, far = 0.4 * c(a), 0.3 * c(a + b)
    return sp.Matrix([[-low - high, -high], [right + far, far], [0, 0], [0, 0], [0, 0], [1, 1]])


NUMBERS = np.array(planar(0.5, 0.7), dtype=float).round(5)


@pytest.mark.parametrize(
    "mine",
    [
        planar(*sp.symbols("q_1 q_2")),
        planar(*sp.symbols("q1 q2")),
        planar(*sp.symbols("th1 th2")),
        planar(t1, t2),
        planar(*sp.symbols("θ₁ θ₂")),
        planar(x1, x2),
        np.array(planar(t1, t2)),
        sp.lambdify(sp.symbols("a b"), planar(*sp.symbols("a b"))),
        lambda q: planar(*q).tolist(),
        [tuple(map(float, row)) for row in NUMBERS],
        planar(0.5, 0.7).evalf(5),
        "[[-0.4*s1 - 0.3*s12, -0.3*s12], [0.4 c_1 + 0.3 c_{12}, 0.3 cos(q1+q2)],"
        " [0,0],[0,0],[0,0],[1,1]]",
        r"\begin{pmatrix} -0.4 s_1 - 0.3 s_{12} & -0.3 s_{12} \\ 0.4\cos\theta_1 +"
        r" 0.3\cos(\theta_1+\theta_2) &"
        r" 0.3 c_{12} \\ 0 & 0 \\ 0 & 0 \\ 0 & 0 \\ 1 & 1 \end{pmatrix}",
    ],
)
def test_jacobian_is_read_from_any_type(mine):
    report = checks.compare_jacobian(mine, PLANAR, [0.5, 0.7])
    assert report.agrees, str(report)


def test_length_without_a_value_is_refused():
    with pytest.raises(ArmError, match="no value for L1"):
        Arm.from_table("theta d a alpha\nq1 L1 0 0\nq2 0 0 0")


# Slips of the errata on arms or input types that the page does not have. The other slips are in
# cases.json.


def slip_12(q):
    lean = math.atan2(0.3 * math.sin(q[2]), 0.4 + 0.3 * math.cos(q[2]))
    return (q[0], q[1] + 2 * lean, q[2])


ASIDE = elbow(ELBOW.with_values(d=0.1), (0.4, 0.2, 0.7))
HOME = np.array(PANDA.home)
SIX = KNOWN["UR10E_HOMEWORK"]
SLIPS = {
    "6": (lambda: checks.compare_torques(42.0, PANDA, HOME), "tau.energy"),
    "12": (lambda: checks.compare_branches([slip_12(ASIDE.q[0])], ASIDE), "ik.plus for minus"),
    "15": (lambda: checks.compare_branches([(H, *ASIDE.q[0, 1:])], ASIDE), "ik.quarter turn"),
}
# Slips in trajectories, which tests below cover.
TRACE_SLIPS = {"5", "10", "11", "19", "20", "21"}


def test_every_slip_of_the_errata_has_a_case():
    tested = (
        {case["about"].split()[1] for case in questions_about("slip ")} | {*SLIPS} | TRACE_SLIPS
    )
    assert tested == {str(n) for n in range(1, 28)}


def test_q_without_locked_joint_is_rejected():
    """Slip 25: the message lists the joints that q must have."""
    with pytest.raises(ArmError, match=r"6 values.*q_1, q_2, q_3, q_4"):
        checks.compare_jacobian(np.zeros((6, 6)), PANDA, np.delete(BENT, 2))


@pytest.mark.parametrize("slip", SLIPS)
def test_slip_of_the_errata_is_named_as_cause(slip):
    report, name = SLIPS[slip][0](), SLIPS[slip][1]
    assert (report.grade, name in report.causes) == ("wrong", True), str(report)


# Traces


def homework_circle(steps):
    """Return the homework's circle as a task of the corpus and as a path of the helpers."""
    task = Task(KNOWN["PANDA.lock(3)"], np.delete(HOME, 2), "zy", 0.1, 5, steps)
    return task, circle(task.path()["centre"], 0.1, "zy", 5, steps)


TASK, PATH = homework_circle(400)
GOOD = TASK.run()
ARM = PANDA.lock(3)


def jacobian_of_slip_19(q):
    """Return the Jacobian with z_i in place of z_(i-1) in its angular rows."""
    J = TASK.machine.jacobian(q)
    return np.vstack([J[:3], recipe(TASK.machine, q, axis=1, origin=1)[3:]])


def linear_jacobian(q):
    return TASK.machine.jacobian(q)[:3]


def check_trace(q, **options):
    return checks.compare_trace(q, ARM, PATH, **options)


def test_trace_is_read_from_any_layout():
    assert check_trace(GOOD).agrees
    times = np.c_[PATH.times, GOOD].round(6)
    for mine in (GOOD[:-1], GOOD.T, times, "\n".join(",".join(map(str, row)) for row in times)):
        assert check_trace(mine).agrees
    assert check_trace(np.degrees(GOOD), angles="deg").agrees


@pytest.mark.parametrize(
    ("q", "cause"),
    [
        (np.degrees(GOOD), "trace.degrees"),
        (GOOD[::-1], "trace.backwards"),
        (GOOD + np.outer(np.linspace(0, 2 * math.pi, 401), np.eye(6)[5]), "trace.spins"),
        (np.where(np.arange(401)[:, None] >= 200, GOOD + 0.5, GOOD), "trace.jump"),
        (np.vstack([GOOD, GOOD[1]]), "trace.one more"),  # slip 20
        (lambda: TASK.run(late=1), "trace.next velocity"),  # slip 21
        (lambda: TASK.run(J=jacobian_of_slip_19), "J.z_i angular"),  # slip 19
        (lambda: TASK.run(rate=1e3), "trace.millimetres"),  # slip 5
        (lambda: TASK.run(rate=-1), "trace.other side"),
        (lambda: TASK.run(radius=0.05), "trace.scaled"),
        (lambda: TASK.run(radius=0.09), None),  # no known mistake gives 0.09: no cause is named
        (lambda: TASK.run(dt=5 / 800), "trace.fraction"),
        (lambda: TASK.run(radius=0.05, dt=5 / 800), "trace.fraction + trace.scaled"),
        (
            lambda: TASK.run(rule=lambda q, v: np.linalg.pinv(linear_jacobian(q)) @ v),
            "trace.position only",
        ),
        (lambda: TASK.run(J=lambda q: recipe(TASK.machine, TASK.start)), "trace.jacobian held"),
        (lambda: TASK.run(rate=1e-3).round(8), "J.millimetres"),  # a Jacobian in mm
        (GOOD[0:1] + 0 * GOOD, None),
        (GOOD[:0], "trace.shape"),
    ],
)
def test_trace_mistake_is_named(q, cause):
    report = check_trace(q() if callable(q) else q)  # a run is computed here, not at import
    assert report.grade == "wrong"
    assert report.causes[:1] == ((cause,) if cause else ()), str(report)


# Slip 11: joint angles by inverse kinematics, with the centre added in some coordinates only.
# Slip 10: the inverse of J at q = 0, where the homework's UR10e has rank 3 up to round-off.

CIRCLE = circle((0.3, 0.2, 0.6), 0.1, "zx", 5, 200)
ABOVE_UR = circle(SIX.tip([0] * 6)[:3, 3] - [0, 0, 0.1], 0.1, "zy", 5, 200)


def trace_of_elbow(missing):
    """Return joint angles on a circle whose centre lacks `missing` of each of its coordinates."""
    q, rows = None, []
    for point in CIRCLE.positions - np.multiply(missing, (0.3, 0.2, 0.6)):
        found = np.array(elbow(ELBOW, point).q)
        turns = found - (found[0] if q is None else q)
        turns -= 2 * math.pi * np.round(turns / (2 * math.pi))
        q = (found[0] if q is None else q) + turns[np.abs(turns).sum(axis=1).argmin()]
        rows.append(q)
    return np.array(rows)


def trace_by_plain_inverse():
    task = Task(SIX, np.zeros(6), "zy", 0.1, 5, 200)
    return task.run(rule=lambda q, v: np.linalg.inv(SIX.jacobian(q)) @ [*v, 0, 0, 0])


def test_whole_turns_are_unwound_and_jumps_named():
    """The jumps are whole turns as from atan2, a change of branch, and a jump off the path."""
    q = trace_of_elbow((0, 0, 0))
    wound = q + 2 * math.pi * (np.arange(201)[:, None] >= 77) * [1, 0, -1]
    report = checks.compare_trace(wound, ELBOW, CIRCLE)
    assert report.agrees
    assert "from step 76 to 77 joint 1 jumps by a whole turn (such steps: 1)" in report.notes[0]
    lean = np.arctan2(0.3 * np.sin(q[:, 2]), 0.4 + 0.3 * np.cos(q[:, 2]))
    flipped = np.stack([q[:, 0], q[:, 1] + 2 * lean, -q[:, 2]], axis=1)
    for other, words in ((flipped, "changes its branch"), (1.5 * q, "check J")):
        mine = np.where(np.arange(201)[:, None] < 77, q, other)
        report = checks.compare_trace(mine, ELBOW, CIRCLE)
        assert report.causes == ("trace.jump",), str(report)
        assert words in str(report)
    few = homework_circle(24)[1]  # the typed values leave the path and are 24 times as long
    wild = np.cos(np.outer(np.arange(25), [1, 2, 3, 5, 7, 11]) + 1)
    report = checks.compare_trace(wild, ARM, few)
    assert report.causes == ("trace.jump", "trace.leans"), str(report)


def test_large_steps_report_open_circle_without_jumps():
    """Joint 5 turns by 0.3 rad per step. With dt = T/21 the circle stays open."""
    task, path = homework_circle(20)
    right, open_ = (task.run(method="rk4", dt=5 / n).round(4) for n in (20, 21))
    assert checks.compare_trace(right, ARM, path).agrees
    assert checks.compare_trace(open_, ARM, path).causes == ("trace.open",)


@pytest.mark.parametrize(
    ("J", "cause"),
    [(None, "trace.short"), (jacobian_of_slip_19, "trace.short + J.z_i angular")],
)
def test_points_of_closed_circle_as_steps_are_named(J, cause):
    """The angles linspace(90, 450, 40) grow by 2 pi/39 in each of 40 steps."""
    task, path = homework_circle(40)
    mine = task.run(J=J, dt=5 / 39, rate=39 / 40).round(5)
    assert cause in checks.compare_trace(mine, ARM, path).causes


def test_runge_kutta_hides_no_mistake():
    task, path = homework_circle(40)
    by_rk4 = task.run(J=jacobian_of_slip_19, method="rk4").round(5)
    assert checks.compare_trace(by_rk4, ARM, path).causes[0] == "J.z_i angular"


def test_wild_trace_names_no_mistake_of_velocity():
    """With velocities in mm/s, 40 steps and three decimals are too few to name the cause."""
    task, path = homework_circle(40)
    typed = [",".join(f"{x:.3f}" for x in row) for row in task.run(rate=1e3)]
    report = checks.compare_trace("\n".join(typed), ARM, path)
    assert report.causes == ("trace.jump", "trace.leans"), str(report)


def test_rounded_entry_does_not_loosen_other_entries():
    q = trace_of_elbow((0, 0, 0))
    typed = [[f"{x:.4f}" for x in row] for row in q]
    typed[5][0] = f"{q[5, 0]:.1f}"
    assert checks.compare_trace("\n".join(map(",".join, typed)), ELBOW, CIRCLE).agrees
    typed[100][2] = f"{q[100, 2] + 0.03:.4f}"
    report = checks.compare_trace("\n".join(map(",".join, typed)), ELBOW, CIRCLE)
    assert "only step 100 is wrong: joint 3 is off" in report.headline


@pytest.mark.parametrize(
    ("missing", "cause"),
    [
        ((1, 0, 0), "trace.centre:x"),
        ((0, 1, 0), "trace.centre:y"),
        ((0, 0.7, 0), "trace.displaced"),
    ],
)
def test_missing_circle_centre_is_named(missing, cause):
    report = checks.compare_trace(trace_of_elbow(missing), ELBOW, CIRCLE)
    assert report.causes == (cause,), str(report)
    assert checks.compare_trace(trace_of_elbow((0, 0, 0)), ELBOW, CIRCLE).agrees


def test_singular_jacobian_is_named():
    report = checks.compare_trace(trace_by_plain_inverse(), UR10E_HOMEWORK, ABOVE_UR)
    assert report.causes == ("trace.no inverse:0",), str(report)
    assert "rank 3 of 6" in report.headline
    assert not report.notes
    stretched = np.vstack([np.zeros(3), trace_of_elbow((0, 0, 0))[1:]])
    report = checks.compare_trace(stretched, ELBOW, CIRCLE)
    assert report.causes == ("trace.no inverse:0",), str(report)
    assert "rank 2 of 3" in report.headline


def test_trace_of_other_lengths_is_named():
    other = KNOWN["PANDA.lock(3)"].with_rows(
        [
            (k, math.copysign(0.088, a) if a else 0, *rest)
            for k, a, *rest in KNOWN["PANDA.lock(3)"].rows
        ]
    )
    report = check_trace(TASK.run(machine=other))
    assert report.causes == ("table.length:a_3:a_6",), str(report)
