"""Test that compare_tables accepts every valid choice of frames, and nothing else."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers import robots
from helpers.arm import Arm, Body, Joint, fixed, prismatic, revolute
from helpers.checks import compare_tables
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, link_frames
from helpers.robots import ARMS, ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import gravity_torque
from tests.cases import COMPARED_TABLES
from tests.laws import instructors_arm
from tests.machines import SAME_MACHINES, SEEDS, random_pair, same_machine

BASED = Arm(
    "based",
    [fixed(d=0.4), revolute(0.2, 0.5, 0.1), revolute(0.3, 0, 0.2), fixed(0.1, 0.3)],
    bodies=[Body(k + 1.0, (0.1, 0.2, 0.3 * k)) for k in range(4)],
)
SCARA = Arm(
    "SCARA", [revolute(0.325, 0, 0.4), revolute(0.225, "pi"), prismatic(), revolute(d=0.05)]
)
SKEW = Arm(
    "skew",
    [
        revolute(0.3, 0.4, 0.1),
        revolute(0.2, 1.1, 0.3),
        revolute(0.1, -0.7, 0.2),
        revolute(0.4, 0, 0.25),
    ],
)
POLAR = Arm(
    "polar",
    [revolute(0, "pi/2", 0.2), revolute(0, 1.0, 0.1), prismatic(0.2, 0.5), revolute(0.1, 0, 0.3)],
)
REFERENCES = (*ARMS, instructors_arm(), ELBOW.with_values(d=0.1), SCARA, SKEW, POLAR)


def is_same_machine(report):
    return report.figures.get("same machine", False)


def maps_tip(report, mine, arm):
    """Return whether the verdict's joint map makes the tips of both tables agree."""
    q = np.random.default_rng(1).uniform(-2, 2, (5, arm.dof))
    joints = report.joint_map
    mapped = np.array(joints.signs) * q + np.array(joints.offsets) if joints else q
    tips = (forward_kinematics(mine, q), forward_kinematics(arm, mapped))
    return np.allclose(*(T[:, :3, 3] for T in tips), atol=1e-6)


def _write_sum(entry, number):
    return f"{entry} + {number}"


def replace_rows(arm, i, *rows):
    """Return the arm with these rows from row i on."""
    return replace(arm, rows=[*arm.rows[:i], *rows, *arm.rows[i + len(rows) :]], bodies=())


def reverse_axis(row):
    """Reverse the axis of a row, so that its joint angle changes its sign."""
    return replace(row, alpha=_write_sum(row.alpha, "pi"), d=f"-({row.d})", theta=f"-({row.theta})")


def flip_z(arm, i):
    row, following = arm.rows[i : i + 2]
    return replace_rows(
        arm, i, replace(row, alpha=_write_sum(row.alpha, "pi")), reverse_axis(following)
    )


def flip_x(arm, i):
    row, following = arm.rows[i : i + 2]
    turned = replace(
        row, theta=_write_sum(row.theta, "pi"), a=f"-({row.a})", alpha=f"-({row.alpha})"
    )
    return replace_rows(arm, i, turned, replace(following, theta=_write_sum(following.theta, "pi")))


def shift_zero(arm, i, by):
    moved = "d" if arm.rows[i].joint.kind == "prismatic" else "theta"
    return add_to_entry(arm, i, moved, by)


def add_to_entry(arm, i, name, by):
    row = arm.rows[i]
    return replace_rows(arm, i, replace(row, **{name: _write_sum(getattr(row, name), by)}))


def slide_normal(arm, i, by):
    """Move the common normal of the parallel axes i + 1 and i + 2 along them."""
    assert arm.numeric[i].sin_alpha == 0
    return add_to_entry(add_to_entry(arm, i, "d", by), i + 1, "d", -by * arm.numeric[i].cos_alpha)


@pytest.mark.parametrize("arm", REFERENCES, ids=lambda arm: arm.name)
@settings(max_examples=30)
@given(data=st.data())
def test_valid_choices_of_frames_are_accepted(arm, data):
    mine = arm
    for _ in range(data.draw(st.integers(1, 6))):
        i = data.draw(st.integers(0, len(arm.rows) - 2))
        kind = data.draw(st.sampled_from(["z", "x", "zero", "slide"]))
        if kind == "z":
            mine = flip_z(mine, i)
        elif kind == "x":
            mine = flip_x(mine, i)
        elif kind == "zero":
            mine = shift_zero(mine, i, data.draw(st.sampled_from([0.3, -1.2, 2.5])))
        elif arm.numeric[i].sin_alpha == 0:
            mine = slide_normal(mine, i, data.draw(st.sampled_from([0.11, -0.2])))
    report = compare_tables(mine, arm)
    assert report.agrees, str(report)
    assert maps_tip(report, mine, arm), str(report)


@pytest.mark.parametrize("arm", REFERENCES, ids=lambda arm: arm.name)
@pytest.mark.parametrize("size", [0.004, 0.3])
def test_wrong_length_or_twist_is_detected(arm, size):
    """A table may choose some entries freely; these are listed here with their reasons."""
    for i in range(len(arm.rows)):
        for name in ("a", "alpha", "d"):
            mine = add_to_entry(arm, i, name, size)
            free = (
                (name == "alpha" and i == len(arm.rows) - 1)  # tilt of the last frame
                or (
                    name == "d" and (arm.rows[i].joint.kind == "prismatic" or i == 0)
                )  # zero of the slide; base height
                or (name == "d" and _slides_along(arm, i))  # zero of the slide
            )
            report = compare_tables(mine, arm)
            assert is_same_machine(report) == free, (arm.name, i + 1, name)
            is_zero = free and (arm.rows[i].joint.kind == "prismatic" or _slides_along(arm, i))
            assert report.agrees == (is_zero and name == "d"), (arm.name, i + 1, name)


def _slides_along(arm, i):
    """Return whether a joint slides among the parallel axes around row i."""
    parallel = [row.sin_alpha == 0 for row in arm.numeric]
    first = next((k + 1 for k in reversed(range(i)) if not parallel[k]), 0)
    last = next((k for k in range(i, len(parallel)) if not parallel[k]), len(parallel) - 1)
    return any(row.joint.kind == "prismatic" for row in arm.rows[first : last + 1])


def test_verdict_matches_numeric_search():
    judged = {seed for seed in SEEDS if is_same_machine(compare_tables(*random_pair(seed)))}
    assert judged == SAME_MACHINES


@pytest.mark.parametrize("seed", SEEDS[::25])
def test_numeric_search_finds_the_stored_answer(seed):
    assert same_machine(*random_pair(seed)) == (seed in SAME_MACHINES)


@pytest.mark.parametrize(
    ("mine", "reference"),
    [
        # Reversed slides, moved sliding axes, and slides before the first revolute joint.
        ("0.5 -1.1 0.3 q1; -0.3 pi/2 q2-0.2 pi/2; 0 -1.1 0.5 q3",
         "0.5 -1.1 0.3 q1; 0.3 pi/2 q2-0.2 pi/2; 0 -1.1 0.5 q3"),
        ("0.3 -pi/2 q1+0.3 0; 0.3 pi 0.4 q2; -0.2 -1.1 0.1 q3",
         "0.3 -pi/2 q1+0.3 0; 0.3 pi 0.5 q2; -0.2 -1.1 0.2 q3"),
        ("0.3 -pi/2 0 q1; -0.2 -pi/2 q2+0.8 pi/2; 0.3 -1.1 q3-0.3 0",
         "0.3 -pi/2 0 q1; -0.2 -pi/2 q2+0.5 pi/2; 0.3 -1.1 q3+0.3 0"),
        ("0.7 pi/2 q1 0; 0 -pi/2 q2+1 0; 0 0 q3 0", "0 pi/2 q1 0; 0 pi/2 q2 0; 0.1 0 q3 0"),
    ],
)  # fmt: skip
def test_sliding_joints_leave_their_lengths_free(mine, reference):
    options = {"columns": "a alpha d theta", "lengths": "m", "angles": "rad"}
    both = [Arm.from_table(text.replace(";", "\n"), **options) for text in (mine, reference)]
    assert same_machine(*both)
    assert is_same_machine(compare_tables(*both))


def test_entries_of_arm_are_quoted():
    rows = list(PANDA.rows)
    rows[0], rows[2] = replace(rows[0], alpha="pi/3"), replace(rows[2], a="2*a_3")
    mine = Arm("mine", rows, values=PANDA.values)
    report = compare_tables(mine, PANDA)
    words = {f.where: f.words for f in report.findings}
    assert words["row 1, alpha"].endswith("(you have pi/3).")
    assert words["row 3, a"].endswith("82.5 mm too long (you have 2*a_3).")
    assert (report.topic, report.headline) == (
        "table",
        "mine does not describe the same arm as Panda.",
    )
    for options, message in (
        (
            {"columns": "a alpha d theta", "lengths": "m"},
            "so 'a alpha d theta', 'm' would change nothing",
        ),
        ({"angles": "deg", "convention": "craig"}, "so 'deg', 'craig' would change nothing"),
    ):
        with pytest.raises(ArmError, match=message):
            compare_tables(mine, PANDA, **options)
    still = Arm("still", [fixed(1.0)])
    for mine, reference in ((PANDA, still), (still, PANDA)):
        with pytest.raises(ArmError, match="expected arms with one joint or more"):
            compare_tables(mine, reference)


@pytest.mark.parametrize("case", COMPARED_TABLES, ids=lambda case: case["about"])
def test_compared_table_gets_its_verdict(case):
    options = {"columns": "a alpha d theta", "lengths": "m", "angles": "rad"} | case.get(
        "options", {}
    )
    with warnings.catch_warnings():  # some references begin with a fixed row
        warnings.simplefilter("ignore")
        reference = (
            getattr(robots, case["arm"])
            if "arm" in case
            else Arm.from_table(case["reference"], columns="a alpha d theta", name="Ref")
        )
    report = compare_tables(
        case["text"], reference, **{key: value for key, value in options.items() if value}
    )
    verdict = {
        "grade": report.grade,
        "causes": [*report.causes],
        "headline": report.headline,
        "findings": [finding.words for finding in report.findings],
        "where": [finding.where for finding in report.findings],
        "same_machine": is_same_machine(report),
    }
    assert {key: verdict[key] for key in verdict if key in case} == {
        key: case[key] for key in verdict if key in case
    }
    assert [words for words in case.get("said", ()) if words not in f"{report}\n"] == [], str(
        report
    )


def test_fixed_pose_excludes_joint_maps():
    typed = "q1 0.5 0 90; q2+90 0 0.4 0; q3 0 0.3 0".replace(";", "\n")
    assert compare_tables(typed, ELBOW).grade == "right by map"
    report = compare_tables(typed, ELBOW, start_configuration=[0, 0, 0])
    assert (report.grade, report.causes) == ("wrong", ())
    words = "is at q = (0, 0, 0), and the tip of your table is 0.99 m away from there, "
    assert words in report.headline
    turned = typed.replace("q2+90", "q2").replace("90", "-90")  # joints 2 and 3 have opposite signs
    assert compare_tables(turned, ELBOW, start_configuration=[0, 0, 0]).grade == "wrong"
    assert compare_tables(ELBOW, ELBOW, start_configuration=[0, 0, 0]).grade == "right"
    with pytest.raises(ArmError, match="start_configuration"):
        compare_tables(typed, ELBOW, start_configuration=[0, 0])


@pytest.mark.parametrize("arm", [UR10E, PANDA, STANFORD, PANDA.lock(3), SCARA], ids=str)
def test_first_rows_of_a_table_are_right_so_far(arm):
    """Other zeros and directions of the joints are allowed, a wrong length is not."""
    for count in range(2, len(arm.rows)):
        first = Arm("first", arm.rows[:count], values=arm.values)
        for mine in (first, flip_z(flip_x(shift_zero(first, 0, 0.3), 0), 0)):
            report = compare_tables(mine, arm)
            assert (report.grade, report.causes) == ("so far", ()), (count, str(report))
            assert report.figures == {"right": first.dof, "of": arm.dof}
        longer = replace_rows(first, 1, replace(first.rows[1], a=0.87, joint=Joint()))
        assert compare_tables(longer, arm).grade == "wrong", count


# Arms in the joint angles of a student's table


HEAVY_SCARA = SCARA.with_bodies([Body(k + 1.0, (0.1, 0.2, 0.3 * k)) for k in range(4)])
BEYOND = Arm(  # only a slide shows the height of its base
    "beyond",
    [revolute(0, "pi/2", 0.4), prismatic(0, "pi/2", 0, "pi/2"), revolute(0.2, 0, 0.1)],
    bodies=[Body(k + 1.0, (0.1, 0.2, 0.3 * k)) for k in range(3)],
)
WITH_BODIES = tuple(arm for arm in (PANDA, UR10E, UR10E_HOMEWORK, PANDA.lock(3)) if arm.bodies)


@pytest.mark.parametrize("reference", [*WITH_BODIES, BASED, STANFORD, HEAVY_SCARA, BEYOND], ids=str)
@pytest.mark.parametrize("seed", range(8))
def test_arm_in_students_joints_behaves_like_reference(reference, seed):
    """Frames, torques and limits must agree at the joint values given by the joint map."""
    rng = np.random.default_rng(seed)
    limited = [
        replace(row, joint=replace(row.joint, lower=-1.0 - k, upper=2.0 + k, speed=k + 1.0))
        if row.joint.kind != "fixed"
        else row
        for k, row in enumerate(reference.rows)
    ]
    home = np.round(rng.uniform(-0.5, 0.5, reference.dof), 2)
    reference = replace(reference, rows=limited, home=tuple(home), source="a sheet")
    mine = shift_zero(reference, reference.joints[0] - 1, 0.3)
    for i in rng.integers(len(mine.rows) - 1, size=4):
        moved = mine if mine.rows[i].joint.kind == "fixed" else shift_zero(mine, i, 0.4)
        mine = (flip_x(mine, i), flip_z(mine, i), moved)[rng.integers(3)]
    if seed % 2:
        last = replace(mine.rows[-1], a=0, alpha=0, d=0, theta=0.2, joint=Joint("fixed"))
        mine = replace(mine, rows=[*mine.rows, last], home=(), bodies=())
    report = compare_tables(mine, reference)
    joints = report.joint_map
    own, signs, shifts = joints.arm, np.array(joints.signs), np.array(joints.offsets)
    assert (own.name, own.source) == (f"{reference.name}, in your joints", "a sheet")
    q = rng.uniform(-3, 3, (5, own.dof))
    np.testing.assert_allclose(link_frames(own, q), link_frames(mine, q), atol=1e-12)
    there = forward_kinematics(reference, signs * q + shifts)[:, :3, 3]
    assert forward_kinematics(own, q)[:, :3, 3] == pytest.approx(there, abs=1e-9)
    low, high = own.limits
    for bound in (low, high):
        at = signs * bound + shifts
        assert np.minimum(abs(at - reference.limits[0]), abs(at - reference.limits[1])).max() < 1e-9
    assert (low < high).all()
    np.testing.assert_array_equal(own.speed_limits, reference.speed_limits)
    np.testing.assert_array_equal(own.effort_limits, reference.effort_limits)
    np.testing.assert_allclose(signs * own.home + shifts, home, atol=1e-12)
    turns = (signs * joints.start + shifts - home) / (2 * np.pi)
    np.testing.assert_allclose(turns, np.where(own.turning, turns.round(), 0), atol=1e-12)
    assert bool(own.bodies) == bool(reference.bodies)
    if own.bodies:
        down = np.array([1.0, 2.0, -9.0])
        expected = signs * gravity_torque(reference, signs * q + shifts, down)
        np.testing.assert_allclose(gravity_torque(own, q, down), expected, atol=1e-9)
