"""Test causes and figures of reports that neither the corpus nor the errata cover.

The mistaken numbers come from the corpus's own kinematics, or from an arm of two slides, whose
joint values are the coordinates of its tip.
"""

import math

import numpy as np
import pytest

from helpers import checks, inverse, motion
from helpers.arm import Arm, prismatic, revolute
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from tests.corpus.arms import KNOWN
from tests.corpus.torques import PANDA as LINKS
from tests.corpus.torques import weight
from tests.corpus.traces import Task, point, turn_off

H = math.pi / 2
BENT = np.array([0.3127, -0.7214, 0.9053, 0.4128, 0.8061, 0.2093])
SEVEN = np.array([0.4, -0.3, 0.5, -0.9, -0.6, 0.8, 0.2])
UR, HOMEWORK = KNOWN["UR10E"], KNOWN["UR10E_HOMEWORK"]
SLID = np.array([0.3, -0.4, 0.6, 0.5, 1.1, -0.2])

J = UR.jacobian(BENT)
SLEDGE = Arm("sledge", [prismatic(alpha=H, theta=H), prismatic()])
CIRCLE = motion.circle((0.3, 0.0, 0.3), 0.1, "xz", 5.0, 40)


def check_slides(slides):
    """Return the report on a trajectory of the arm of two slides."""
    return checks.compare_trace(slides, SLEDGE, CIRCLE)


@pytest.mark.parametrize(
    ("slides", "cause", "said"),
    [
        (
            CIRCLE.positions[:, [0, 2]],
            "trace.axes exchanged",
            "the x and z coordinates are exchanged.",
        ),
    ],
)
def test_exchanged_axes_of_path_are_named(slides, cause, said):
    report = check_slides(slides)
    assert cause in {key.split(":")[0] for keys in report.causes for key in keys.split(" + ")}
    assert said in report.headline
    assert report.grade == "wrong"


def test_sliding_joints_are_never_called_degrees():
    """Euler's method leaves the circle by as much with a factor of degrees as without it."""
    theta = 2 * np.pi * np.arange(40) / 40
    steps = 0.1 * 2 * np.pi / 40 * np.stack([np.cos(theta), -np.sin(theta)], axis=1)
    slides = np.cumsum([[0.3, 0.4], *steps], axis=0)
    assert "trace.degrees" not in check_slides(slides).causes


def test_branch_report_counts_right_and_wrong_answers():
    found = inverse.elbow(ELBOW, (0.3, 0.2, 0.7))
    typed = [*found.q[1:3], [9.0, 9.0, 9.0]]
    expected = {"found": tuple(found.branches[1:3]), "right": 2, "of": 4, "wrong": 1}
    assert checks.compare_branches(typed, found).figures == expected


def test_pose_report_gives_position_and_orientation_error():
    T = np.array([[1, 0, 0, 0.7], [0, 0, -1, 0], [0, 1, 0, 0.5], [0, 0, 0, 1]])
    off = np.outer([0.03, 0.04, 0, 0], [0, 0, 0, 1])
    far = checks.compare_pose([0, 0, 0], ELBOW, T + off)
    assert far.figures == {"position_error": pytest.approx(0.05), "orientation_error": 0.0}
    turned = checks.compare_pose([0.25, 0, 0], ELBOW, T).figures["orientation_error"]
    assert turned == pytest.approx(0.25)


def test_trace_report_gives_the_position_error():
    ahead = check_slides(CIRCLE.positions[:, [2, 0]] + [0.03, 0.04])
    assert ahead.figures["position_error"] == pytest.approx(0.05)
    assert ahead.figures["run"].position_error == pytest.approx(0.05)
    assert (ahead.topic, ahead.figures["tool_turn"]) == ("trace", 0.0)


@pytest.mark.parametrize(
    ("first", "start"), [(10, "10 mm off"), (20, "20 mm off"), (30, "already off")]
)
def test_trace_is_already_off_only_from_half_of_its_largest_error(first, start):
    """The error grows from `first` to 50 mm."""
    growing = np.linspace(first, 50, len(CIRCLE.positions)) / 1000
    away = check_slides(CIRCLE.positions[:, [2, 0]] + np.outer(growing, [1, 0]))
    assert f"at the start it is {start}." in str(away)


def test_trace_report_gives_the_wrong_shape():
    assert check_slides(CIRCLE.positions[:7]).findings[0].mine == (7, 3)


@pytest.mark.parametrize("typed", [{"theta1": 0.0, "theta2": 0.0, "theta3": 0.0}, ("0", "0", "0")])
def test_joint_angles_by_name_or_text_are_read(typed):
    assert checks.compare_pose(typed, ELBOW, [0.7, 0, 0.5]).grade == "right"


def test_list_of_strings_is_one_value_per_joint():
    two = Arm("Two joints", [revolute(a=0.4), revolute(a=0.3)])
    assert checks.compare_pose(["0", "0"], two, [0.7, 0, 0]).grade == "right"
    assert checks.compare_pose([["q1", 0], ["q2", 0]], two, [0.7, 0, 0]).grade == "right"


def test_square_answer_is_read_by_columns_if_needed():
    found = inverse.elbow(ELBOW, (0.3, 0.2, 0.7))
    three = found.q[:3].round(4)
    by_rows, by_columns = (checks.compare_branches(x, found) for x in (three, three.T))
    assert by_rows.figures == by_columns.figures
    assert (by_rows.taken, by_columns.taken) == ((), ("one answer in each column",))
    three[0, 0] += 0.3
    assert checks.compare_branches(three.T, found).taken == ()


TORQUES = weight(KNOWN["PANDA"], LINKS, SEVEN)
ASKED = {
    ("Jacobian", "UR10e"): lambda n: checks.compare_jacobian(J.round(n), UR10E, BENT),
    ("torques", "Panda"): lambda n: checks.compare_torques(TORQUES.round(n), PANDA, SEVEN),
    ("pose", "UR10e"): lambda n: checks.compare_pose(BENT.round(n), UR10E, UR.tip(BENT)),
}


@pytest.mark.parametrize("about", ASKED)
@pytest.mark.parametrize(("digits", "grade"), [(6, "right"), (1, "so far")])
def test_report_names_topic_arm_and_grade(about, digits, grade):
    report = ASKED[about](digits)
    assert (report.topic, report.arm, report.grade) == (*about, grade)
    assert about[1] in report.headline


def test_right_tip_with_wrong_orientation_misses_the_target():
    q = np.array([0.3, -0.7, 0.9, 0.4, 0.8, 0.2])
    found = inverse.ur(UR10E_HOMEWORK, forward_kinematics(UR10E_HOMEWORK, q))
    q[5] += 0.5
    report = checks.compare_branches([q], found)
    assert "misses the target by 0 mm and 28.6°" in str(report)


# Trajectories with a mistake in the table or in the joint values

UR_TASK = Task(UR, [0.3, -1.2, 1.4, -0.7, -1.2, 0.4], "xz", 0.1, 5.0, 20)
STANFORD_TASK = Task(KNOWN["STANFORD"], [0.3, 0.8, 0.5, 0.4, 0.9, 0.2], "xz", 0.08, 5.0, 20)


def causes_of_trace(task, rows, arm):
    """Return the grade and causes of a trajectory on the task's circle."""
    verdict = checks.compare_trace(rows.round(5), arm, motion.circle(**task.path()))
    return verdict.grade, verdict.causes


def test_forgotten_pen_in_trajectory_is_named():
    """The trajectory moves the flange, in place of the pen's tip, along the circle."""
    rows = [list(row) for row in UR.rows]
    rows[-1][3] -= 0.1
    penless = UR.with_rows(rows)
    first, trajectory, q = UR_TASK.first, [], UR_TASK.start
    for t in 0.25 * np.arange(21):
        target = first[:3, 3] + point("xz", t, 0.1, 5.0)
        for _ in range(40):
            T = penless.tip(q)
            error = [*(target - T[:3, 3]), *turn_off(T[:3, :3], first[:3, :3])]
            q = q + np.linalg.solve(penless.jacobian(q), error)
        trajectory.append(q)
    expected = ("wrong", ("table.pen",))
    assert causes_of_trace(UR_TASK, np.array(trajectory), UR10E) == expected


@pytest.mark.parametrize(
    ("task", "arm", "joint", "factor", "cause"),
    [
        (UR_TASK, UR10E, 4, 180 / math.pi, "ik.joint degrees:q_5"),
        (UR_TASK, UR10E, 5, -1, "ik.sign:q_6"),
        (STANFORD_TASK, STANFORD, 2, 1000, "ik.joint millimetres:q_3"),
        # The same position results from the right q_5 and q_4 changed by half a turn.
        (STANFORD_TASK, STANFORD, 4, -1, "ik.sign:q_5"),
    ],
)
def test_one_mistaken_joint_of_trajectory_is_named(task, arm, joint, factor, cause):
    rows = task.run(method="rk4")
    rows[:, joint] *= factor
    assert causes_of_trace(task, rows, arm) == ("wrong", (cause,))


def test_exchanged_joints_of_trajectory_are_named():
    rows = UR_TASK.run(method="rk4")[:, [0, 2, 1, 3, 4, 5]]
    assert causes_of_trace(UR_TASK, rows, UR10E) == ("wrong", ("ik.exchanged:q_2:q_3",))


def test_wrong_trajectory_from_round_start_is_not_drift():
    """The start is typed with one decimal, and half a unit of it moves the tip by 0.1 m."""
    task = Task(KNOWN["PANDA"], [0.1, -0.3, 0.2, 1.2, 0.1, 2.0, 0.1], "yz", 0.1, 5.0, 100)
    rows = task.run(method="rk4")
    rows[:, 4] *= -1
    assert causes_of_trace(task, rows, PANDA)[0] == "wrong"


def format_slides(rows, decimals):
    """Return one line per configuration, each with its own number of decimals."""
    return "\n".join(f"{z:.{n}f} {x:.{n}f}" for (z, x), n in zip(rows, decimals, strict=True))


def test_configuration_in_two_decimals_is_right_to_its_digits():
    """Row 3 has two decimals and misses the circle by 4.7 mm; the other rows have five decimals."""
    decimals = [2 if k == 3 else 5 for k in range(len(CIRCLE.positions))]
    text = format_slides(CIRCLE.positions[:, [2, 0]], decimals)
    assert text.splitlines()[3] == "0.35 0.39"
    assert check_slides(text).grade == "right"


def test_round_start_does_not_excuse_later_configurations():
    """Rounding of the start explains 50 mm; the following rows, with more digits, miss by 20 mm."""
    path = motion.circle((0.3123, 0.0, 0.3046), 0.1, "xz", 5.0, 40)
    rows = path.positions[:, [2, 0]] + [0.02, 0.0]
    text = format_slides(rows, [1, *[5] * (len(rows) - 1)])
    assert text.startswith("0.3 0.4\n")
    assert checks.compare_trace(text, SLEDGE, path).grade == "wrong"
