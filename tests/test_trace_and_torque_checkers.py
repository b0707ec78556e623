"""The checkers of runs and of torques: right ones pass, and each usual mistake is called by its
name."""

import re
from dataclasses import replace

import numpy as np
import pytest

from helpers.arm import Arm, ArmError, Body, revolute
from helpers.checks import compare_torques, compare_trace
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion import circle, trace
from helpers.robots import PANDA, PANDA_HOMEWORK, UR10E
from helpers.statics import gravity_torque

ARM = PANDA_HOMEWORK.lock(3)
TOP = np.array([0.679, 0, 0.825])
PATH = circle(TOP - [0, 0, 0.1], 0.1, "zy", 5.0, 200)


@pytest.fixture(scope="module")
def run():
    """The homework's own Euler loop, written out."""
    q = np.array(ARM.home)
    rows = [q]
    for v in PATH.velocities[:-1]:
        q = q + 5.0 / 200 * np.linalg.solve(jacobian(ARM, q), np.r_[v, 0, 0, 0])
        rows.append(q)
    return np.array(rows)


def test_the_homeworks_run_draws_the_path_but_not_on_the_real_arm(run):
    found = compare_trace(run, ARM, PATH)
    assert found.agrees
    assert found.run.position_error < 1e-3
    assert "joint 5 by 3.4, joint 7 by 3.4" in str(found)
    assert not found.run.executable


def test_a_run_without_its_last_row_counts(run):
    assert compare_trace(run[:-1], ARM, PATH).agrees
    assert not compare_trace(run[:-2], ARM, PATH).agrees


@pytest.mark.parametrize(
    ("path", "words"),
    [
        (
            circle(TOP - [0, 0, 0.12], 0.1, "zy", 5.0, 200),
            r"displaced by \(-?0\.\d+, -?0\.\d+, (20|19\.9)\) mm",
        ),
        (circle(TOP - [0, 0, 0.1], 0.08, "zy", 5.0, 200), "1.25 times as large"),
        (circle(TOP - [0, 0, 0.1], 0.1, "zy", 5.0, 200, phase=1.2), "from another point"),
        (circle(TOP - [0, 0, 0.1], 0.1, "xy", 5.0, 200), "mm from where it should be"),
    ],
)
def test_another_path_is_told_from_the_wanted_one(run, path, words):
    found = compare_trace(run, ARM, path)
    assert not found.agrees
    assert len(found.findings) == 1
    assert re.search(words, found.findings[0])


def test_the_wrong_way_round_and_degrees_are_named(run):
    assert "other way round" in compare_trace(run[::-1], ARM, PATH).findings[0]
    degrees = compare_trace(np.degrees(run), ARM, PATH)
    assert degrees.findings == ("The joints are in degrees: write radians.",)
    assert "transposed" in compare_trace(run.T, ARM, PATH).findings[0]
    assert "expected (201, 6)" in compare_trace(run[:100], ARM, PATH).findings[0]


def test_the_leaning_pen_points_to_the_angular_rows():
    """Slip 19: the pen's place is right, its direction 12 degrees off."""

    def mistaken(arm, q):
        T = np.eye(4)
        axes, J = [], jacobian(arm, q)
        for i in (1, 2, 4, 5, 6, 7):
            part = Arm("part", PANDA_HOMEWORK.rows[:i], PANDA_HOMEWORK.values)
            T = forward_kinematics(part, np.insert(q, 2, 0)[:i])
            axes.append(T[:3, 2])
        return np.vstack([J[:3], np.transpose(axes)])

    path = circle(TOP - [0, 0, 0.1], 0.1, "zy", 5.0, 1000)
    found = compare_trace(trace(ARM, ARM.home, path, jacobian=mistaken).q, ARM, path)
    assert len(found.findings) == 1
    assert "leans by up to 12.3 degrees" in found.findings[0]
    assert "angular rows" in found.findings[0]


def test_a_run_beyond_the_speed_limits_is_noted(run):
    fast = circle(TOP - [0, 0, 0.1], 0.1, "zy", 0.05, 200)
    assert "beyond the real arm's speed: joint 1" in str(compare_trace(run, ARM, fast))


@pytest.mark.parametrize("mine", [np.full((201, 6), np.nan), "up", [[1, 2], [3]]])
def test_a_run_must_be_numbers(mine):
    with pytest.raises(ArmError, match="your joints"):
        compare_trace(mine, ARM, PATH)


# Torques. The right ones come from the homework's page and from a pendulum worked by hand.

PUSH = [-5, 0, 0, 0, 0, 0]
G = np.array([0, 24.24681, 0, -17.555154, 0.696491, 0.675249, -0.03068])
TAU = np.array([0, 21.81431, 0, -16.702654, 0.696491, 0.235249, -0.03068])
BY_FORCE = TAU - G
POSE = np.array([0.3, -0.7, 0.4, 1.3, -0.5, 1.9, 0.2])


def test_the_homeworks_torques_are_right():
    assert compare_torques(TAU, PANDA, PANDA.home, PUSH).agrees
    assert compare_torques(G, PANDA, PANDA.home).agrees
    assert compare_torques([TAU, TAU], PANDA, [PANDA.home] * 2, PUSH).agrees


@pytest.mark.parametrize(
    ("mine", "words"),
    [
        (G - BY_FORCE, "force has the wrong sign"),
        (G, "force is missing"),
        (BY_FORCE, "weight is missing"),
        (-TAU, "Every sign is reversed"),
        (-G + BY_FORCE, "weight has the wrong sign"),
        (G * 9.8 / 9.81 + BY_FORCE, "gravity is 9.8 m"),
        (G * 10 / 9.81 + BY_FORCE, "gravity is 10 m"),
        (TAU[:6], "Its shape is (6,); expected (7,)"),
        (np.float64(12.3), "potential energy"),
        (TAU * [1, -1, 1, 1, 1, 1, 1], "Joint 2: its sign is reversed"),
        (TAU + 0.5 * np.eye(7)[3], "Joint 4: it is off by up to 0.5 N m"),
    ],
)
def test_each_usual_mistake_is_named(mine, words):
    found = compare_torques(mine, PANDA, PANDA.home, PUSH)
    assert not found.agrees
    assert len(found.findings) == 1
    assert words in str(found)


def test_mistakes_of_model_are_named():
    torque = gravity_torque(PANDA, POSE)

    def with_bodies(change):
        return gravity_torque(replace(PANDA, bodies=change(PANDA.bodies)), POSE)

    cases = {
        "mass of link 3 is missing": lambda b: (*b[:2], Body(0, (0, 0, 0)), *b[3:]),
        "frames' origins": lambda b: [Body(x.mass, (0, 0, 0)) for x in b],
    }
    for words, change in cases.items():
        assert words in str(compare_torques(with_bodies(change), PANDA, POSE)), words
    assert compare_torques(torque, PANDA, POSE).agrees
    found = compare_torques(gravity_torque(PANDA, np.radians(POSE)), PANDA, POSE)
    assert "degrees" in str(found)


def test_a_force_in_the_tools_axes_is_named():
    R = forward_kinematics(PANDA, POSE)[:3, :3]
    J, g = jacobian(PANDA, POSE), gravity_torque(PANDA, POSE)
    force = np.array([-5.0, 1, 0])
    assert "tool's axes" in str(
        compare_torques(g - J[:3].T @ (R @ force), PANDA, POSE, [*force, 0, 0, 0])
    )
    assert "exchanged" in str(compare_torques(g - J[3:].T @ force, PANDA, POSE, [*force, 0, 0, 0]))


def test_a_whole_run_is_transposed_or_right():
    q = np.linspace(UR10E.home, np.array(UR10E.home) + 0.4, 9)
    tau = gravity_torque(UR10E, q)
    assert compare_torques(tau, UR10E, q).agrees
    assert "transposed" in str(compare_torques(tau.T, UR10E, q))


def test_a_pendulum_by_hand():
    """1.5 m of massless rod, 2 kg at its end, 0.3 rad above the horizontal: 2 * 9.81 * 1.5 * cos
    0.3."""
    pendulum = Arm(
        "Pendulum",
        (revolute(a=1.5),),
        bodies=(Body(2.0, (0, 0, 0)),),
    )
    by_hand = 2 * 9.81 * 1.5 * np.cos(0.3)
    found = compare_torques([by_hand], pendulum, [0.3], gravity=[0, -9.81, 0])
    assert found.agrees
    assert found.worst < 1e-12
    assert "Joint 1: it is off" in str(
        compare_torques([by_hand + 1], pendulum, [0.3], gravity=[0, -9.81, 0])
    )


@pytest.mark.parametrize("mine", ["heavy", [np.nan] * 7])
def test_torques_must_be_numbers(mine):
    with pytest.raises(ArmError, match="your torques"):
        compare_torques(mine, PANDA, PANDA.home)


def test_reports_are_marked_in_the_book(run):
    fine, wrong = compare_trace(run, ARM, PATH), compare_trace(run + 0.1, ARM, PATH)
    assert fine._repr_markdown_().startswith("✔ **Panda (homework) draws the path.**\n\n- Note: ")
    assert wrong._repr_markdown_().startswith("✘ **Panda (homework) does not draw the path.**")
    right = gravity_torque(PANDA, PANDA.home)
    assert compare_torques(right, PANDA, PANDA.home)._repr_markdown_().startswith("✔ **The torques")
    listed = compare_torques(-right, PANDA, PANDA.home)._repr_markdown_()
    assert listed.startswith("✘ **The torques of Panda are not right.**\n\n- ")


def test_a_report_of_a_wrong_shape_names_the_arm():
    q = np.zeros(6)
    assert compare_torques(np.zeros(5), UR10E, q).arm == "UR10e"
