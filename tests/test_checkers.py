"""The checkers on work as students hand it in: every form, every digit, every slip of the errata by
name.

What is right and what each slip makes of it comes from the corpus's own kinematics or from the
triangle named below.
"""

import math
from functools import partial

import numpy as np
import pytest
import sympy as sp

from helpers import checks
from helpers.arm import Arm, ArmError
from helpers.inverse import elbow
from helpers.kinematics import forward_kinematics
from helpers.motion import circle, circle_below, trace
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from tests import table_pastes
from tests.corpus.arms import KNOWN
from tests.corpus.jacobians import recipe
from tests.corpus.traces import Task
from tests.test_robots import GAZ_CENTRES

H = math.pi / 2
Q = [0.5, -0.4, 0.7]
BENT = [0.4, -0.3, 0.5, 0.9, -0.6, 0.8, 0.2]
J3 = KNOWN["ELBOW"].jacobian(Q)
q1, q2, q3 = sp.symbols("q_1 q_2 q_3")


def test_cut_digits_are_told_and_a_tolerance_is_obeyed():
    cut = np.trunc(J3 * 1e4) / 1e4
    report = checks.compare_jacobian(cut, ELBOW, Q)
    assert report.agrees
    assert "your digits are cut" in str(report)
    off = J3 + 1e-3
    assert checks.compare_jacobian(off, ELBOW, Q, tolerance=1.1e-3).agrees
    assert checks.compare_jacobian(off, ELBOW, Q, tolerance=0.9e-3).grade == "wrong"


# The door


c, s = sp.cos, sp.sin
t1, t2, t3 = sp.symbols("theta1:4", real=True)
PLANAR = Arm.from_table("q1 0 0.4 0\nq2 0 0.3 0")
T = sp.Symbol("t")
x1, x2 = (sp.Function(n)(T) for n in ("theta1", "theta2"))


def planar(a, b):
    """The Jacobian of two links of 0.4 and 0.3 m in a plane, by hand."""
    low, high = 0.4 * s(a), 0.3 * s(a + b)
    right, far = 0.4 * c(a), 0.3 * c(a + b)
    return sp.Matrix([[-low - high, -high], [right + far, far], [0, 0], [0, 0], [0, 0], [1, 1]])


NUMBERS = np.array(planar(0.5, 0.7), dtype=float).round(5)


@pytest.mark.parametrize(
    "mine",
    [
        planar(*sp.symbols("q_1 q_2")),
        planar(*sp.symbols("q1 q2")),
        planar(*sp.symbols("th0 th1")),
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
def test_a_jacobian_is_taken_as_it_is_held(mine):
    report = checks.compare_jacobian(mine, PLANAR, [0.5, 0.7])
    assert report.agrees, str(report)


def test_locked_joints_may_be_numbered_on():
    by_row = PLANAR.lock(1)
    counted = checks.compare_jacobian("[-0.3*sin(q1); 0.3*cos(q1); 0; 0; 0; 1]", by_row, [0.7])
    assert counted.agrees
    assert "joints 2" in str(counted)


ROWS = [
    (0, 90, 333),
    (0, -90, 0),
    (82.5, -90, 316),
    (-82.5, 90, 0),
    (0, 90, 384),
    (88, -90, 0),
    (0, 0, -207),
]


@pytest.mark.parametrize("name", table_pastes.RIGHT)
def test_a_pasted_table_is_read_as_it_was_meant(name):
    assert checks.compare_tables(table_pastes.RIGHT[name], ELBOW).agrees


@pytest.mark.parametrize("text", table_pastes.REFUSED)
def test_what_is_no_table_is_refused_in_words(text):
    with pytest.raises(ArmError, match=table_pastes.REFUSED[text]):
        checks.compare_tables(text, ELBOW)


@pytest.mark.parametrize(
    ("typed", "instead", "place", "cause"),
    [
        (
            "0.4 0 0 q3",
            "0.2 0 0 q3",
            "a in row 3 is 200 mm too short (you have 0.2)",
            "table.number:a:3",
        ),
        (
            "0.4 0 0 q3",
            "0.4 0.3 0 q3",
            "alpha in row 3 should be nothing (you have 0.3)",
            "table.too much:alpha:3",
        ),
    ],
)
def test_a_modified_table_is_quoted_as_it_was_typed(typed, instead, place, cause):
    """a and alpha stand in the row after the one that they have in the standard convention."""
    text = table_pastes.RIGHT["craig"].replace(typed, instead)
    report = checks.compare_tables(text, ELBOW)
    assert place in report.headline
    assert report.causes == (cause,)


def test_a_forgotten_pen_is_named_in_other_frames_too():
    rows = [*([a, math.radians(t), d] for a, t, d in ROWS[:5]), [88, math.pi / 2, 0]]
    rows = [*rows, [0, 0, -107]]
    mine = [[a / 1000, t, d / 1000, f"q{i}"] for i, (a, t, d) in enumerate(rows, 1)]
    assert checks.compare_tables(mine, PANDA, columns="a alpha d theta").causes == ("table.pen",)


def test_a_table_says_how_it_was_taken():
    arm = Arm.from_table("0 -90 128 q1\n612.7 180 0 q2-90", columns="a alpha d theta")
    assert arm.source == "lengths in millimetres; angles in degrees"
    assert arm.rows[1].theta == "-pi/2"
    slide = Arm.from_table("q1 0 0 -pi/2\nth2 0 0 90\n0 -(d3+q3) 0 0", values={"d3": 0.2})
    assert [r.joint.kind for r in slide.rows] == ["revolute", "revolute", "prismatic"]
    assert slide.rows[2].d == -0.2
    assert "backwards in row 3" in slide.source
    kuka = Arm.from_table(
        "{alpha0: 0, a0: 0, d1: 0.75, q1: q1, alpha1: -pi/2, a1: 0.35, d2: 0, q2: q2-pi/2}"
    )
    assert (kuka.rows[0].a, kuka.rows[0].alpha) == (0.35, "-pi/2")
    with pytest.raises(ArmError, match="no value for L1"):
        Arm.from_table("q1 L1 0 0\nq2 0 0 0")


# The slips of the errata that are mistakes of method. The elbow arm's links of 0.4 and 0.3 m are
# the legs of a right angle
# over (0.5, 0, 0.5), its shoulder at (0, 0, 0.5): the first leans by LOW = atan2(3, 4), the second
# by a right angle more.

LOW = math.atan2(3, 4)
OVER = elbow(ELBOW, (0.5, 0, 0.5))
FOUR = [(0, LOW, -H), (0, -LOW, H), (math.pi, math.pi - LOW, H), (math.pi, math.pi + LOW, -H)]
OFFSET = ELBOW.with_values(d=0.1)
ASIDE = elbow(OFFSET, (0.4, 0.2, 0.7))
HOME = np.array(PANDA.home)
PUSH = [-5.0, 0, 0, 0, 0, 0]
SIX = KNOWN["UR10E_HOMEWORK"]
SKEW = [0.3, -0.8, 0.9, 0.4, -0.5, 0.6]


def heights(arm, q, centres):
    """P of masses at centres of their frames, with g = 9.81."""
    frames = KNOWN["PANDA"].frames(q)
    masses = [float(b.mass) for b in arm.bodies]
    return sum(
        9.81 * m * (F @ [*c, 1])[2] for m, F, c in zip(masses, frames[1:], centres, strict=True)
    )


def gradient(f, q, step=1e-6):
    return np.array([(f(q + step * e) - f(q - step * e)) / (2 * step) for e in np.eye(len(q))])


CENTRES = [[PANDA.number(x) for x in b.com] for b in PANDA.bodies]
WEIGHT = gradient(lambda q: heights(PANDA, q, CENTRES), HOME)
PAPERS_WEIGHT = gradient(lambda q: heights(PANDA, q, GAZ_CENTRES), HOME)  # in Craig's frames
FORCE = KNOWN["PANDA"].jacobian(HOME).T @ PUSH
HALF_TURN = np.array(SIX.tip([0] * 6)) @ np.diag([-1, -1, 1, 1])


def table(mine, arm):
    return partial(checks.compare_tables, mine, arm)


def torques(mine):
    return partial(checks.compare_torques, np.round(mine, 4), PANDA, HOME, PUSH)


def jacobian(mine, arm, q):
    return partial(checks.compare_jacobian, np.round(mine, 4), arm, q)


def branches(*mine, found=OVER):
    return partial(checks.compare_branches, mine, found)


def slip_12(q):
    lean = math.atan2(0.3 * math.sin(q[2]), 0.4 + 0.3 * math.cos(q[2]))
    return (q[0], q[1] + 2 * lean, q[2])


# Slip 1: the Panda's table with the heads of alpha and theta exchanged, as in the report.
HEADS = """Link  a  alpha  theta  d
1  0      θ_1^*  pi/2   0.333
2  0      θ_2^*  -pi/2  0
3  0.0825 θ_3^*  -pi/2  0.316
4 -0.0825 θ_4^*  pi/2   0
5  0      θ_5^*  pi/2   0.384
6  0.088  θ_6^*  -pi/2  0
7  0      θ_7^*  0      -0.207"""
# Slip 9: the maker's lengths of the UR10, in the directions of the UR10e's table and without a pen.
UR10 = """theta  d         a        alpha
q1     0.1273    0        pi/2
q2     0         -0.612   0
q3     0         -0.5723  0
q4     0.163941  0        pi/2
q5     0.1157    0        -pi/2
q6     0.0922    0        0"""
# Slip 26: the pen's row in metres under a table in millimetres.
PAGES = """theta  d     a      alpha
q1     333   0      pi/2
q2     0     0      -pi/2
q3     316   82.5   -pi/2
q4     0     -82.5  pi/2
q5     384   0      pi/2
q6     0     88     -pi/2
q7    -0.207 0      0"""
# Slip 27: the point o_3 of the homework's UR10e by hand, its first entry with 1 and 3 exchanged.
THREE = Arm("three joints", UR10E_HOMEWORK.rows[:3], UR10E_HOMEWORK.values)
O_3 = "[0.6127*s2*c1 + 0.5716*{}, 0.6127*s1*s2 + 0.5716*s1*(s2*c3 - c2*s3), {}]"
O_3 = O_3.format("{}", "0.128 + 0.6127*c2 + 0.5716*(c2*c3 + s2*s3)")


BY_HAND = """[[c1*c2, -s1*c2, c1*s2, q3*c1*s2-d2*s1],
[s1*c2, c1, s1*s2, q3*s1*s2+d2*c1], [-s2, 0, c2, q3*c2], [0,0,0,1]]"""
LEVEL, BENT_OVER = (
    elbow(ELBOW, point)
    for point in ((0.4, 0.2, 0.7), forward_kinematics(ELBOW, [0.1, 0.2, 0.8])[:3, 3])
)
WHOLE = KNOWN["PANDA"].jacobian(np.multiply(BENT, [1, 1, 0, 1, 1, 1, 1]))
SLIPS = {
    "1": (table(HEADS, PANDA), "table.alpha and theta"),
    "2": (table(PANDA_HOMEWORK, PANDA), "table.length:a_3:a_6"),
    "3": (
        jacobian(np.delete(WHOLE, 2, axis=0)[:5], PANDA.lock(3), np.delete(BENT, 2)),
        "J.row for column",
    ),
    "4": (jacobian(recipe(SIX, SKEW, rows=True), UR10E_HOMEWORK, SKEW), "J.rows of T"),
    "6": (
        partial(checks.compare_torques, heights(PANDA, HOME, CENTRES), PANDA, HOME),
        "tau.energy",
    ),
    "7": (torques(PAPERS_WEIGHT - FORCE), "tau.paper centres"),
    "7, the force reversed": (
        torques(PAPERS_WEIGHT + FORCE),
        "tau.paper centres + tau.force sign",
    ),
    "8": (torques(WEIGHT * 9.8 / 9.81 - FORCE), "tau.gravity:9.8"),
    "9": (table(UR10E_HOMEWORK, UR10E), "table.robot:UR10"),
    "9, the maker's numbers": (table(UR10, UR10E), "table.robot:UR10 + table.pen"),
    "9, the other way": (table(UR10E, UR10E_HOMEWORK), "table.robot:UR10e"),
    "12": (branches(slip_12(ASIDE.q[0]), found=ASIDE), "ik.plus for minus"),
    "13": (
        branches((H - math.atan2(0.2, 0.4), *LEVEL.q[0, 1:]), found=LEVEL),
        "ik.other axis:q_1",
    ),
    "15": (branches((H, *ASIDE.q[0, 1:]), found=ASIDE), "ik.quarter turn"),
    "16": (branches((0.1, 0.2, math.pi - 0.8), found=BENT_OVER), "ik.supplement:q_3"),
    "17": (
        partial(
            checks.compare_pose, [0.3, 0.5, 0.2], Arm("three", STANFORD.rows[:3], {"d_2": 0.154}),
            BY_HAND,
        ),
        "pose.entry",
    ),
    "18": (partial(checks.compare_pose, [0] * 6, UR10E_HOMEWORK, HALF_TURN), "pose.half turn"),
    "22": (branches(*FOUR[1:3]), "ik.one sign"),
    "23": (branches((0, H + LOW, -H), found=elbow(ELBOW, (0, 0, 0.0))), "ik.half turn:q_2"),
    "24": (torques(-WEIGHT - FORCE), "tau.weight sign"),
    "25": (
        jacobian(np.delete(KNOWN["PANDA"].jacobian(BENT), 2, axis=1), PANDA, BENT),
        "J.column missing:3",
    ),
    "26": (table(PAGES, PANDA), "table.mixed units"),
    "27": (
        partial(checks.compare_pose, Q, THREE, O_3.format("c1*s2*c3 - s1*c2*c3")),
        "pose.coordinate",
    ),
    "theta_1 + pi, the rest unchanged": (branches((math.pi, LOW, -H)), "ik.shoulder"),
    "force reversed": (torques(WEIGHT + FORCE), "tau.force sign"),
}  # fmt: skip


# Told elsewhere in this file: 5, 10, 11, 19, 20, 21 by runs, 14 below as a free joint, of which
# the report says that it is free. Some are no mistakes of method as the reports write them; fed
# is what would become of a method: 5, velocities in mm/s beside a Jacobian in metres (mm/s in a
# report in mm are consistent); 11, a run that draws the circle about the origin; 25, the matrix
# without a joint's column; 26, the table that it makes, in two units.
ELSEWHERE = {"5", "10", "11", "14", "19", "20", "21"}


def test_every_slip_of_the_errata_is_decided():
    told = {slip.split(",")[0] for slip in SLIPS if slip[0].isdigit()} | ELSEWHERE
    assert told == {str(n) for n in range(1, 28)}


@pytest.mark.parametrize("q", [BENT, np.delete(BENT, 2)])
def test_six_entries_of_q_beside_seven_are_refused_in_words(q):
    """Slip 25: which joints there should be is said."""
    arm = PANDA.lock(3) if len(q) == 7 else PANDA
    names = "q_1, q_2, q_4, q_5" if len(q) == 7 else "q_1, q_2, q_3, q_4"
    with pytest.raises(ArmError, match=f"{len(q)} values.*{names}"):
        checks.compare_jacobian(np.zeros((6, len(q))), arm, q)


@pytest.mark.parametrize("slip", SLIPS)
def test_the_slips_are_named(slip):
    report, name = SLIPS[slip][0](), SLIPS[slip][1]
    assert name in report.causes, str(report)
    assert report.grade == ("so far" if slip == "22" else "wrong")


def test_a_free_joint_is_told_and_right():
    """Slip 14: theta_1 = pi/2 straight above the shoulder is one of infinitely many."""
    found = elbow(ELBOW, (0, 0, 0.7))
    report = checks.compare_branches(np.add(found.q[found.valid], [H, 0, 0]), found)
    assert report.agrees
    assert "q_1 is free here" in str(report)


# Traces


def homeworks(steps):
    """The homework's circle, as a task of the corpus and as the checkers have it."""
    task = Task(KNOWN["PANDA.lock(3)"], np.delete(HOME, 2), "zy", 0.1, 5, steps)
    return task, circle(task.path()["centre"], 0.1, "zy", 5, steps)


def test_steps_too_few_for_euler_are_told():
    task, path = homeworks(24)
    report = checks.compare_trace(task.run(), ARM, path)
    assert report.causes == ("trace.coarse",)
    assert "but 24 steps of Euler's method are too few for this path" in report.headline


def test_steps_too_few_are_told_in_degrees_as_degrees():
    """Near a singular pose, where Euler's method strays by more than two of the path's steps."""
    start = [0.3, 0.4, 0.9, 0.2, 0.8, 0.1]
    path = circle_below(UR10E, start, 0.1, "zx", 5, 20)
    q = trace(UR10E, start, path).q
    assert checks.compare_trace(q, UR10E, path).causes == ("trace.coarse",)
    assert checks.compare_trace(np.degrees(q), UR10E, path).causes == ("trace.degrees",)


TASK, PATH = homeworks(400)
GOOD = TASK.run()
ARM = PANDA.lock(3)


def turned(q):
    """Slip 19: z_i and o_i in the angular half alone."""
    J = TASK.machine.jacobian(q)
    return np.vstack([J[:3], recipe(TASK.machine, q, axis=1, origin=1)[3:]])


def traced(q, **how):
    return checks.compare_trace(q, ARM, PATH, **how)


def test_a_run_is_taken_as_it_is_held():
    assert traced(GOOD).agrees
    times = np.c_[PATH.times, GOOD].round(6)
    for mine in (GOOD[:-1], GOOD.T, times, "\n".join(",".join(map(str, row)) for row in times)):
        assert traced(mine).agrees
    assert traced(np.degrees(GOOD), angles="deg").agrees


@pytest.mark.parametrize(
    ("q", "cause"),
    [
        (np.degrees(GOOD), "trace.degrees"),
        (GOOD[::-1], "trace.backwards"),
        (GOOD + np.outer(np.linspace(0, 2 * math.pi, 401), np.eye(6)[5]), "trace.spins"),
        (np.where(np.arange(401)[:, None] == 200, GOOD + 0.5, GOOD), "trace.jump"),
        (np.vstack([GOOD, GOOD[1]]), "trace.one more"),  # slip 20
        (TASK.run(late=1), "trace.next velocity"),  # slip 21
        (TASK.run(J=turned), "J.z_i angular"),  # slip 19
        (TASK.run(rate=1e3), "trace.millimetres"),  # slip 5
        (TASK.run(rate=1e-3).round(8), "J.millimetres"),  # a Jacobian in mm
        (GOOD[0:1] + 0 * GOOD, None),
        (GOOD[:0], "trace.shape"),
    ],
)
def test_a_wrong_run_is_named(q, cause):
    report = traced(q)
    assert report.grade == "wrong"
    assert cause is None or report.causes[:1] == (cause,), str(report)


# Slip 11: joints from inverse kinematics, the centre added in some coordinates only; slip 10: the
# plain inverse at q = 0, where the homework's UR10e has rank 3, as floating point gives it.

CIRCLE = circle((0.3, 0.2, 0.6), 0.1, "zx", 5, 200)
ABOVE_UR = circle(SIX.tip([0] * 6)[:3, 3] - [0, 0, 0.1], 0.1, "zy", 5, 200)


def elbow_run(missing):
    q, rows = None, []
    for point in CIRCLE.positions - np.multiply(missing, (0.3, 0.2, 0.6)):
        found = np.array(elbow(ELBOW, point).q)
        turns = found - (found[0] if q is None else q)
        turns -= 2 * math.pi * np.round(turns / (2 * math.pi))
        q = (found[0] if q is None else q) + turns[np.abs(turns).sum(axis=1).argmin()]
        rows.append(q)
    return np.array(rows)


def plain_inverse():
    task = Task(SIX, np.zeros(6), "zy", 0.1, 5, 200)
    return task.run(rule=lambda q, v: np.linalg.inv(SIX.jacobian(q)) @ [*v, 0, 0, 0])


def test_whole_turns_are_counted_on_and_other_jumps_are_told_by_where_the_tip_is():
    """As atan2 leaves them; on the path to another branch; and off it."""
    q = elbow_run((0, 0, 0))
    wound = q + 2 * math.pi * (np.arange(201)[:, None] >= 77) * [1, 0, -1]
    report = checks.compare_trace(wound, ELBOW, CIRCLE)
    assert report.agrees
    assert "from step 76 to 77 joint 1 jumps by a whole turn (such steps: 1)" in report.notes[0]
    lean = np.arctan2(0.3 * np.sin(q[:, 2]), 0.4 + 0.3 * np.cos(q[:, 2]))
    flipped = np.stack([q[:, 0], q[:, 1] + 2 * lean, -q[:, 2]], axis=1)
    for other, words in ((flipped, "another branch"), (1.5 * q, "look at J")):
        mine = np.where(np.arange(201)[:, None] < 77, q, other)
        report = checks.compare_trace(mine, ELBOW, CIRCLE)
        assert report.causes == ("trace.jump",), str(report)
        assert words in str(report)
    few = homeworks(24)[1]  # astray, and so 24 times as long as the path
    wild = np.cos(np.outer(np.arange(25), [1, 2, 3, 5, 7, 11]) + 1)
    report = checks.compare_trace(wild, ARM, few)
    assert report.causes == ("trace.jump", "trace.leans"), str(report)


@pytest.mark.parametrize(
    ("missing", "cause"),
    [
        ((1, 0, 0), "trace.centre:x"),
        ((0, 1, 0), "trace.centre:y"),
        ((0, 0.7, 0), "trace.displaced"),
    ],
)
def test_a_circle_about_the_origin_is_named(missing, cause):
    report = checks.compare_trace(elbow_run(missing), ELBOW, CIRCLE)
    assert report.causes == (cause,), str(report)
    assert checks.compare_trace(elbow_run((0, 0, 0)), ELBOW, CIRCLE).agrees


def test_an_inverse_that_does_not_exist_is_named():
    report = checks.compare_trace(plain_inverse(), UR10E_HOMEWORK, ABOVE_UR)
    assert report.causes == ("trace.no inverse:0",), str(report)
    assert "rank 3 of 6" in report.headline
    assert not report.notes
    stretched = np.vstack([np.zeros(3), elbow_run((0, 0, 0))[1:]])
    report = checks.compare_trace(stretched, ELBOW, CIRCLE)
    assert report.causes == ("trace.no inverse:0",), str(report)
    assert "rank 2 of 3" in report.headline


def test_another_arms_run_is_told_by_what_it_leaves():
    other = KNOWN["PANDA.lock(3)"].with_rows(
        [
            (k, math.copysign(0.088, a) if a else 0, *rest)
            for k, a, *rest in KNOWN["PANDA.lock(3)"].rows
        ]
    )
    report = traced(TASK.run(machine=other))
    assert report.causes == ("table.length:a_3:a_6",), str(report)
