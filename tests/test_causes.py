"""Each cause that a checker can name and that the stored corpus and the errata do not hold, once.

What the mistake makes of right work comes from the corpus's own kinematics, or from an arm of two
slides, whose joints are the path itself.
"""

import math

import numpy as np
import pytest

from helpers import checks, inverse, motion
from helpers.arm import Arm, prismatic, revolute
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from tests.corpus.arms import KNOWN
from tests.corpus.torques import PANDA as LINKS
from tests.corpus.torques import weight

H = math.pi / 2
BENT = np.array([0.3127, -0.7214, 0.9053, 0.4128, 0.8061, 0.2093])
SEVEN = np.array([0.4, -0.3, 0.5, -0.9, -0.6, 0.8, 0.2])
UR, HOMEWORK = KNOWN["UR10E"], KNOWN["UR10E_HOMEWORK"]
SLID = np.array([0.3, -0.4, 0.6, 0.5, 1.1, -0.2])

J = UR.jacobian(BENT)
SLEDGE = Arm("sledge", [prismatic(alpha=H, theta=H), prismatic()])
CIRCLE = motion.circle((0.3, 0.0, 0.3), 0.1, "xz", 5.0, 40)


def jacobian(M, arm=UR10E, **options):
    return checks.compare_jacobian(np.round(M, 5), arm, BENT, **options)


def of_rows(machine, k, **changed):
    """The machine's Jacobian with one entry of row k changed."""
    names = ("kind", "a", "alpha", "d", "theta")
    rows = [dict(zip(names, row, strict=True)) for row in machine.rows]
    rows[k - 1] |= changed
    return machine.with_rows([tuple(row.values()) for row in rows]).jacobian(BENT)


def table(change, machine=UR, arm=UR10E):
    """The machine's rows (a, alpha, d, theta), changed, as text."""
    rows = change(np.array([row[1:] for row in machine.rows]))
    entries = ["\t".join(f"{x:.6g}" for x in row) for row in rows]
    text = "\n".join(["a\talpha\td\ttheta", *entries])
    return checks.compare_tables(text, arm, lengths="m", angles="rad")


def columns(*order):
    return lambda rows: rows[:, order]


def put(i, k, value):
    def change(rows):
        rows[i - 1, k] = value
        return rows

    return change


def craig(rows):
    return np.column_stack([np.vstack([rows[1:, :2], [0, 0]]), rows[:, 2:]])


def pose(change=np.array, more=(0,) * 6, q=BENT):
    """The UR10e's joints q, rounded, with something added, for the pose of BENT, changed."""
    return checks.compare_pose(q.round(4) + more, UR10E, change(UR.tip(BENT)))


def scaled(by):
    def change(T):
        T[:3, 3] *= by
        return T

    return change


def transposed(T):
    T[:3, :3] = T[:3, :3].T.copy()
    return T


def run(slides):
    return checks.compare_trace(slides, SLEDGE, CIRCLE)


CAUSES = {
    "J.linear zero": lambda: jacobian(J * [[0], [0], [0], [1], [1], [1]]),
    "ik.slide in millimetres, of q": lambda: checks.compare_jacobian(
        KNOWN["STANFORD"].jacobian(SLID).round(4), STANFORD, SLID * [1, 1, 1000, 1, 1, 1]
    ),
    "table.offset": lambda: jacobian(of_rows(HOMEWORK, 2, theta=0), UR10E_HOMEWORK),
    "table.centimetres": lambda: table(lambda rows: rows * [100, 1, 100, 1]),
    "table.twists in degrees": lambda: table(
        lambda rows: rows * [1, 180 / math.pi, 1, 1], HOMEWORK, UR10E_HOMEWORK
    ),
    "table.d and theta": lambda: table(columns(0, 1, 3, 2), HOMEWORK, UR10E_HOMEWORK),
    "table.a and alpha": lambda: table(columns(1, 0, 2, 3)),
    "table.into craig": lambda: table(craig),
    "table.number and sign": lambda: table(put(3, 0, -0.1), KNOWN["PANDA"], PANDA),
    "table.angle": lambda: table(put(1, 1, 1.0)),
    "pose.millimetres": lambda: pose(scaled(1000)),
    "ik.exchanged": lambda: pose(q=BENT[[0, 1, 2, 5, 4, 3]]),
    "pose.transposed": lambda: pose(transposed),
    "trace.axes exchanged": lambda: run(CIRCLE.positions[:, [0, 2]]),
    "trace.phase": lambda: run(
        np.roll(CIRCLE.positions[:-1, [2, 0]], 7, axis=0)[[*range(40), 0]]
        + 0.006 * np.outer((-1.0) ** np.arange(41), [1, 0])
    ),
}


SAID = {
    "table.offset": "the offset of theta in row 2 is forgotten.",
    "table.number and sign": "a in row 3 is wrong, and goes the other way (you have -0.1).",
    "table.angle": f"alpha in row 1 is {90 - math.degrees(1):.1f}° off (you have 1).",
    "trace.axes exchanged": "the x and z coordinates are exchanged.",
}


def put_in(*places):
    def change(T):
        for place in places:
            T[place] += 0.1
        return T

    return change


@pytest.mark.parametrize(
    ("change", "more", "causes"),
    [
        (np.array, [0, 0.3, 0, 0.2, 0, 0], ()),
        (np.array, [0, 0.3, 0, 0, 0, 0], ()),  # a number that fits is no cause
        (put_in((0, 3), (2, 3)), [0] * 6, ("pose.entry",)),
        (put_in((0, 1), (2, 2)), [0] * 6, ("pose.entry",)),
    ],
)
def test_few_wrong_entries_of_a_target_are_located(change, more, causes):
    assert pose(change, more).causes == causes


@pytest.mark.parametrize("name", CAUSES)
def test_the_cause_is_named(name):
    report = CAUSES[name]()
    keys = {key.split(":")[0] for keys in report.causes for key in keys.split(" + ")}
    assert name.split(",")[0] in keys, str(report)
    assert SAID.get(name, "") in report.headline
    assert report.grade == "wrong"


def test_slides_are_in_no_degrees():
    """Euler's method strays from the circle as far with as without a factor that no slide has."""
    theta = 2 * np.pi * np.arange(40) / 40
    steps = 0.1 * 2 * np.pi / 40 * np.stack([np.cos(theta), -np.sin(theta)], axis=1)
    slides = np.cumsum([[0.3, 0.4], *steps], axis=0)
    assert "trace.degrees" not in run(slides).causes


@pytest.mark.parametrize(
    "turn", [np.diag([1, 1, -1]), np.diag([-1, 1, 1]), -np.eye(3), np.eye(3)[::-1]]
)
def test_a_left_handed_target_is_reached_by_no_joints(turn):
    """At 0 the elbow arm's tip has its y axis up and its x axis ahead, 0.7 m from the shoulder."""
    T = np.array([[1, 0, 0, 0.7], [0, 0, -1, 0], [0, 1, 0, 0.5], [0, 0, 0, 1]])
    assert checks.compare_pose([0, 0, 0], ELBOW, T).grade == "right"
    T[:3, :3] = T[:3, :3] @ turn
    assert checks.compare_pose([0, 0, 0], ELBOW, T).grade == "wrong"


def test_what_was_measured_of_joint_angles_and_runs():
    found = inverse.elbow(ELBOW, (0.3, 0.2, 0.7))
    typed = [*found.q[1:3], [9.0, 9.0, 9.0]]
    wanted = {"found": tuple(found.branches[1:3]), "right": 2, "of": 4, "wrong": 1}
    assert checks.compare_branches(typed, found).figures == wanted
    degrees = checks.compare_branches(np.degrees(found.q).round(1), found)
    assert (degrees.causes, degrees.figures["right"], degrees.figures["of"]) == (
        ("ik.degrees",),
        0,
        4,
    )
    T = np.array([[1, 0, 0, 0.7], [0, 0, -1, 0], [0, 1, 0, 0.5], [0, 0, 0, 1]])
    off = np.outer([0.03, 0.04, 0, 0], [0, 0, 0, 1])
    far = checks.compare_pose([0, 0, 0], ELBOW, T + off)
    assert far.figures == {"position_error": pytest.approx(0.05), "orientation_error": 0.0}
    turned = checks.compare_pose([0.25, 0, 0], ELBOW, T).figures["orientation_error"]
    assert turned == pytest.approx(0.25)
    ahead = run(CIRCLE.positions[:, [2, 0]] + [0.03, 0.04])
    assert ahead.figures["position_error"] == pytest.approx(0.05)
    assert ahead.figures["run"].position_error == pytest.approx(0.05)
    assert (ahead.topic, ahead.figures["tool_turn"]) == ("trace", 0.0)
    assert run(CIRCLE.positions[:7]).findings[0].mine == (7, 3)


@pytest.mark.parametrize("typed", [{"theta1": 0.0, "theta2": 0.0, "theta3": 0.0}, ("0", "0", "0")])
def test_joint_angles_may_be_held_by_name_or_as_text(typed):
    assert checks.compare_pose(typed, ELBOW, [0.7, 0, 0.5]).grade == "right"


def test_two_texts_are_two_joints():
    two = Arm("Two joints", [revolute(a=0.4), revolute(a=0.3)])
    assert checks.compare_pose(["0", "0"], two, [0.7, 0, 0]).grade == "right"
    assert checks.compare_pose([["q1", 0], ["q2", 0]], two, [0.7, 0, 0]).grade == "right"


def test_a_square_of_answers_is_by_columns_where_that_alone_is_right():
    found = inverse.elbow(ELBOW, (0.3, 0.2, 0.7))
    three = found.q[:3].round(4)
    by_rows, by_columns = (checks.compare_branches(x, found) for x in (three, three.T))
    assert by_rows.figures == by_columns.figures
    assert (by_rows.taken, by_columns.taken) == ((), ("an answer per column",))
    three[0, 0] += 0.3
    assert checks.compare_branches(three.T, found).taken == ()


@pytest.mark.parametrize("taken", [[0, 1], [0, 1, 2, 3], [0, 1, 2, 3, 4]])
def test_what_is_missing_beyond_the_range_of_a_slide_is_no_sign_forgotten(taken):
    found = inverse.stanford(STANFORD, KNOWN["STANFORD"].tip(SLID))
    mine = found.q[found.q[:, 2].argsort()[::-1]][taken]
    report = checks.compare_branches(mine, found)
    notes = ("what is missing lies beyond the range of q_3, where the arm cannot go",)
    assert report.notes == (notes if len(taken) > 3 else ())
    assert "ik.one sign" not in report.causes


def test_an_answer_where_there_is_no_branch():
    report = checks.compare_branches([[0.1, 0.2, 0.3]], inverse.elbow(ELBOW, (5.0, 0.0, 0.5)))
    (finding,) = report.findings
    assert (finding.what, finding.where) == ("answer", "answer 1")
    assert finding.words == "Answer 1 cannot be right: no joint angles reach this target."
    assert report.headline == "No joint angles of Elbow arm reach this target."


TORQUES = weight(KNOWN["PANDA"], LINKS, SEVEN)
ASKED = {
    ("Jacobian", "UR10e"): lambda n: checks.compare_jacobian(J.round(n), UR10E, BENT),
    ("torques", "Panda"): lambda n: checks.compare_torques(TORQUES.round(n), PANDA, SEVEN),
    ("pose", "UR10e"): lambda n: checks.compare_pose(BENT.round(n), UR10E, UR.tip(BENT)),
}


@pytest.mark.parametrize("about", ASKED)
@pytest.mark.parametrize(("digits", "grade"), [(6, "right"), (1, "so far")])
def test_what_and_whose_is_told_with_every_grade(about, digits, grade):
    report = ASKED[about](digits)
    assert (report.topic, report.arm, report.grade) == (*about, grade)
    assert about[1] in report.headline


@pytest.mark.parametrize(("half", "other"), [("linear", "angular"), ("angular", "linear")])
def test_half_a_jacobian_is_right_so_far(half, other):
    report = checks.compare_jacobian(J[:3] if half == "linear" else J[3:], UR10E, BENT)
    assert report.grade == "so far"
    assert report.headline == (
        f"The {half} rows of the Jacobian of UR10e are right at this pose; the {other} ones are"
        " missing."
    )
    (finding,) = report.findings
    assert (finding.what, finding.where) == ("missing", f"{other} rows")
    assert str(report).splitlines()[1:] == [
        f"- Add the three {other} rows.",
        f"- Taken as the three {half} rows",
    ]
