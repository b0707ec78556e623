"""Test that compare_tables accepts every valid choice of frames, and nothing else."""

import re
import warnings
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.arm import Arm, Body, Joint, fixed, prismatic, revolute
from helpers.checks import compare_tables
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, link_frames
from helpers.robots import ARMS, ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import gravity_torque
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
    """Reverse the axis of a row, whose joint then counts backwards."""
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
    """Unless it is one of the free choices, each given here by hand with its reason."""
    for i in range(len(arm.rows)):
        for name in ("a", "alpha", "d"):
            mine = add_to_entry(arm, i, name, size)
            free = (
                (name == "alpha" and i == len(arm.rows) - 1)  # the last frame's tilt
                or (
                    name == "d" and (arm.rows[i].joint.kind == "prismatic" or i == 0)
                )  # a zero; the base
                or (name == "d" and _slides_along(arm, i))  # the slide's zero takes it up
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
        # Reversed slides, moved sliding axes, and slides before the first axis that turns.
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
    for options, told in (
        (
            {"columns": "a alpha d theta", "lengths": "m"},
            "so 'a alpha d theta', 'm' would change nothing",
        ),
        ({"angles": "deg", "convention": "craig"}, "so 'deg', 'craig' would change nothing"),
    ):
        with pytest.raises(ArmError, match=told):
            compare_tables(mine, PANDA, **options)
    still = Arm("still", [fixed(1.0)])
    for mine, reference in ((PANDA, still), (still, PANDA)):
        with pytest.raises(ArmError, match="expected arms with one joint or more"):
            compare_tables(mine, reference)


# Messages, each typed by hand


GENERIC = "0.1 pi/3 0.4 q1; 0.3 -pi/4 0.25 q2; 0.2 pi/2 0.05 q3+0.3; 0.15 0.6 0.35 q4"
ELBOWED = "0 pi/2 0.4 q1; 0.3 0 0 q2; 0.2 pi/2 0.05 q3; 0 0 0.25 q4"
SLIDING = "0 pi/2 0.2 q1; 0 1 0.1 q2; 0.2 0.5 d3+0.2 0.4; 0.1 0 0.3 q4"
LEANING = "0.1 0.4 0.3 0; 0.3 pi/2 0.2 q1; 0.2 0 0.1 q2"
ROOTED = "0.1 0 0 0; 0.3 0 0.2 q2; 0.2 pi/2 0 q3; 0.25 0 0.1 q4"


def compare_rows(typed, reference, **options):
    with warnings.catch_warnings():  # some references begin with a fixed row
        warnings.simplefilter("ignore")
        arm = Arm.from_table(reference.replace(";", "\n"), columns="a alpha d theta", name="Ref")
    options = {"columns": "a alpha d theta", "lengths": "m", "angles": "rad", **options}
    return compare_tables(typed.replace(";", "\n"), arm, **options)


ROUNDED = """0 -pi/2 0.128 q1\n0.613 pi 0 q2-pi/2\n0.572 pi 0 q3
0 pi/2 0.164 q4+pi/2\n0 -pi/2 0.116 q5\n0 0 0.192 q6"""


@pytest.mark.parametrize(
    ("right", "wrong", "causes"),
    [
        ("-pi/2 0.128", "0 0.128", ("table.no twist:1",)),
        ("0.116", "0", ("table.missing:d:5",)),
        ("0 -pi/2 0.128", "0.05 -pi/2 0.128", ()),  # a in row 1 should be 0
        ("0.572 pi 0", "0.572 pi 0.3", ()),
    ],
)
def test_one_mistake_is_named_among_rounded_lengths(right, wrong, causes):
    mine = ROUNDED.replace(right, wrong)
    for typed in (mine, re.sub(r"0\.(\d+)", lambda m: m[1].ljust(3, "0"), mine)):  # m, mm
        report = compare_tables(typed, UR10E_HOMEWORK, columns="a alpha d theta")
        assert (report.grade, report.causes) == ("wrong", causes), str(report)
        assert len(report.findings) == 1
    whole = re.sub(r"0\.", "", ROUNDED)
    assert compare_tables(whole, UR10E_HOMEWORK, columns="a alpha d theta").grade == "rounded"


@pytest.mark.parametrize(
    ("typed", "lengths", "grade"),
    [
        ("301", "mm", "rounded"),
        ("$301$", "mm", "rounded"),
        ("300.+1.", "mm", "rounded"),
        ("302", "mm", "wrong"),
        # Whole numbers among formulas and full floats are exact; those of centimetres are coarse.
        ("3010/10", "mm", "wrong"),
        ("301.0000000000001", "mm", "wrong"),
        ("30.1", "cm", "rounded"),
        ("30", "cm", "wrong"),
    ],
)
def test_whole_millimetres_are_read_as_rounded(typed, lengths, grade):
    assert compare_rows(f"{typed} 0 0 q1", "0.3006 0 0 q1", lengths=lengths).grade == grade


@pytest.mark.parametrize(
    ("arm", "mine", "where"),
    [
        (PANDA, """0 -pi/2 0.333 q1\n0 -pi/2 0 q2\n0.0825 pi/2 0 q3\n-0.0825 pi/2 0 q4
0 -pi/2 0.384 q5+pi\n0.088 -pi/2 0 q6+pi\n0 0 -0.207 q7""", "row 3, d"),
        (UR10E, """0 -pi/2 0.181 q1+pi\n-0.613 pi 0 q2+pi\n-0.572 0 -0.174 q3\n0 pi/2 0 q4+pi
0 pi/2 0.12 q5+pi\n0.05 pi -0.217 q6+pi""", "row 6, a"),
        (UR10E_HOMEWORK, ROUNDED.replace("0.164", "-0.2"), "row 4, d"),
        (STANFORD, """0 pi/2 0 q1+pi\n0 pi/2 0.154 q2+pi\n0 0 d3 0\n0 0 0 q4
0 -pi/2 0 q5\n0 0 0.263 q6""", "row 4, alpha"),
        (STANFORD, """0 pi/2 0.02 q1+pi\n0 -pi/2 0.154 q2+pi\n0.05 0 d3 pi\n0 pi/2 0 q4
0 -pi/2 0 q5+pi\n0 0 0.263 q6+pi""", "row 2, a"),
    ],
)  # fmt: skip
def test_one_mistake_in_other_frames_is_located(arm, mine, where):
    report = compare_tables(mine, arm, columns="a alpha d theta")
    assert (report.grade, report.causes) == ("wrong", ()), str(report)
    assert [f.where for f in report.findings] == [where]


@pytest.mark.parametrize(
    ("twist", "theta", "wanted", "angles"),
    [
        ("0.5", "0.9", "0.4", "51.5662° in yours and 22.9183° in the reference: 28.6479° off"),
        ("-0.5", "-0.9", "-0.4", "-51.5662° in yours and -22.9183° in the reference: 28.6479° off"),
        ("0.5", "pi", "pi-0.1", "180° in yours and 174.27° in the reference: 5.7296° off"),
        # Only the sum of two slides along a line counts.
        ("0", "0.2; 0 0.5 d4 0.7", "0.1; 0 0.5 d4 0.3",
         "51.5662° in yours and 22.9183° in the reference: 28.6479° off"),
    ],
)  # fmt: skip
def test_angle_about_a_sliding_axis_is_reported_as_theta(twist, theta, wanted, angles):
    row = "0.3 pi/2 0.2 q1; 0 1 0 q2; 0 {} d3 {}; 0 0 0.3 q4"
    report = compare_rows(row.format(twist, theta) + "; 0 0 0 0", row.format(twist, wanted))
    told = next(f for f in report.findings if "slide" in f.words)
    assert told.where == "row 3, theta"
    between = "about the slide between the common normals before and after it is "
    assert told.words == f"Row 3, theta: the angle {between}{angles}."


@pytest.mark.parametrize(
    ("entry", "instead", "words"),
    [
        (" -pi/4", " pi/4", "the twist alpha in row 2 has the wrong sign (you have pi/4)"),
        (" -pi/4", " 0", "the twist alpha in row 2 is missing (you have 0)"),
        (" -pi/4", " -1", "alpha in row 2 is 12.3° off (you have -1)"),
        ("0.3 ", "-0.3 ", "a in row 2 has the wrong sign (you have -0.3)"),
        ("0.25", "0", "d in row 2 is missing (you have 0)"),
        ("0.3 ", "-0.31 ", "a in row 2 is 610 mm off (you have -0.31)"),
        ("0.3 ", "0.3125 ", "a in row 2 is 12.5 mm too long (you have 0.3125)"),
        ("0.25", "2/10", "d in row 2 is 50 mm too short (you have 2/10)"),
    ],
)
def test_wrong_entry_is_quoted(entry, instead, words):
    report = compare_rows(GENERIC.replace(entry, instead, 1), GENERIC)
    assert report.headline == f"Your table does not describe the same arm as Ref: {words}."


@pytest.mark.parametrize(
    ("typed", "reference", "options", "lines"),
    [
        # An additional fixed row, so that rows do not correspond and axes are compared.
        ("0 pi/2 0.4 q1; 0.35 0 0 q2; 0.2 1 0.05 q3; 0.1 0 0.3 q4; 0 0 0 0", ELBOWED, {}, [
            "Row 2, a: the distance from axis 2 to axis 3 is 0.35 m in yours and 0.3 m in the "
            "reference: 50 mm too long.",
            "Row 3, alpha: the twist from axis 3 to axis 4 is 57.2958° in yours and 90° in the "
            "reference: 32.7042° off.",
            "Row 4, a: the distance from axis 4 to the tip is 0.1 m in yours and 0 m in the "
            "reference: 100 mm too long.",
            "Row 4, d: the offset along axis 4 is 0.3 m in yours and 0.25 m in the reference: "
            "50 mm too long."]),
        (GENERIC.replace("-pi/4", "-1") + "; 0 0 0 0", GENERIC, {}, [
            "Row 2, alpha: the twist from axis 2 to axis 3 is 57.2958° in yours and 45° in the "
            "reference: 12.2958° off."]),
        ("0 pi/2 0.4 q1; 0.3 0 -0.06 q2; 0.2 pi/2 0.05 q3; 0 0 0.25 q4; 0 0 0 0", ELBOWED, {}, [
            "Row 3, d: the offset along the parallel axes 2 to 3, added up, is -0.01 m in yours "
            "and 0.05 m in the reference: it has the opposite direction, so a sign is wrong here "
            "or in a row beside it."]),
        ("0 pi/2 0.4 q1; 0.3 0 0 q2; 0.2 pi/2 d3+0.05 0; 0 0 0.25 q4", ELBOWED, {}, [
            "Row 3, joint: the joint is prismatic in yours and revolute in the reference."]),
        ("0.1 0.4 0 0; 0 pi/2 0.4 q1; 0.3 0 0 q2; 0.2 pi/2 0.05 q3; 0 0 0.25 q4", ELBOWED, {}, [
            "Row 1, alpha: the angle from z_0 to axis 2 is 22.9183° in yours and 0° in the "
            "reference: 22.9183° off.",
            "Row 1, a: the distance from z_0 to axis 2 is 0.1 m in yours and 0 m in the "
            "reference: 100 mm too long."]),
        # Craig's a and alpha stand a row lower; the first are a row of their own when read.
        ("0.1 0 0.1 q1; 0.4 0 0.1 q2; 0.3 pi/2 0.3 q3; 0.15 0 0 0; 0 0 0 0", ROOTED,
         {"convention": "craig"}, [
            "Row 2, a: the distance from axis 1 to axis 2 is 0.4 m in yours and 0.3 m in the "
            "reference: 100 mm too long.",
            "Row 3, a: the distance from axis 2 to axis 3 is 0.3 m in yours and 0.2 m in the "
            "reference: 100 mm too long.",
            "Row 4, a: the distance from axis 3 to the tip is 0.15 m in yours and 0.25 m in the "
            "reference: 100 mm too short.",
            "Row 3, d: the offset along axis 3 is 0.3 m in yours and 0.1 m in the reference: "
            "200 mm too long."]),
        # Axes 2 and 4 have the right distance and twist, in the opposite direction.
        ("0 pi/2 0.2 q1; 0 1 0.1 q2; -0.2 0.5 d3 0; 0.125 0 0.3 q4; 0 0 0 0",
         SLIDING.replace("0.4;", "0;"), {}, [
            "Row 2, a: the shortest line from axis 2 to axis 4 has a different direction than in "
            "the reference: check the signs here and in the rows beside it.",
            "Row 4, a: the distance from axis 4 to the tip is 0.125 m in yours and 0.1 m in the "
            "reference: 25 mm too long."]),
    ],
)  # fmt: skip
def test_differences_between_axes_are_described(typed, reference, options, lines):
    report = compare_rows(typed, reference, **options)
    assert report.headline == "Your table does not describe the same arm as Ref."
    assert [f.words for f in report.findings] == lines
    places = [line.partition(":")[0].lower() for line in lines if line.startswith("Row")]
    assert [f.where for f in report.findings] == (places or ["row 3, joints"])


BASE = (
    "Your table has the joint axes of Ref, but the base frame of your table is {} along axis 1 "
    "than the reference's "
)
JOINTS = "The reference counts these joints differently: {}\n"


@pytest.mark.parametrize(
    ("typed", "reference", "options", "messages"),
    [
        ("0 pi/2 0.4 q1; 0.3 0 0.05 q2+0.3; 0.2 pi/2 0 q3-pi/2; 0 0 0.25 q4", ELBOWED, {},
         [JOINTS.format("its q_2 is your q_2 + 17.19°; its q_3 is your q_3 - 90°")]),
        ("0 -pi/2 0.4 q1+pi; 0.3 0 -0.05 q2; 0.2 -pi/2 0 q3; 0 0 0.25 q4", ELBOWED, {},
         [JOINTS.format("its q_1 is your q_1 + 180°; its q_2 is -(your q_2); its q_3 is "
                        "-(your q_3)"),
          "joint values are (180°, 0°, 0°, 0°)\n"]),
        # A zero is seen from the tool where the tip lies on the axis, and farther out than the next
        # axis where that is the same or only slides.
        ("0 pi/2 0.4 q1; 0.3 0 0 q2; 0.2 pi/2 0.05 q3; 0 0.5 0.25 q4+0.3",
         ELBOWED.replace("0 0 0.25", "0 0.5 0.25"), {},
         [JOINTS.format("its q_4 is your q_4 + 17.19°"), "theta in row 4 should be 0"]),
        ("0 pi/2 0.4 q1; 0 pi/2 d2+0.1 pi/2; 0.2 0 0.1 q3",
         "0 pi/2 0.4 q1; 0 pi/2 d2 pi/2; 0.2 0 0.1 q3", {},
         [JOINTS.format("its q_2 is your q_2 + 100 mm"), "joint values are (0°, -100 mm, 0°)"]),
        ("0.1 0 0.2 q1; 0.3 0 0 q2+0.3; 0.2 pi/2 0.1 q3; 0.25 0 0 0", ROOTED,
         {"convention": "craig"}, [JOINTS.format("its q_3 is your q_2 + 17.19°")]),
        # The last link may be measured backwards: then the last frame is turned.
        ("0 pi/2 0.5 q1; 0.4 0 0 q2; -0.3 0 0 q3", "0 pi/2 0.5 q1; 0.4 0 0 q2; 0.3 0 0 q3", {},
         [JOINTS.format("its q_3 is your q_3 + 180°"),
          "your last frame is turned by 180° about its z axis"]),
        # The last frame's z axis may be reversed.
        ("0 1.5708 0.4 q1; 0.3 0.00005 0 q2; 0.2 1.57 0.05 q3; 0 -3.1416 0.25 q4+4.7124", ELBOWED,
         {},
         [JOINTS.format("its q_4 is your q_4 - 90°"),
          "the z axis of your last frame points the other way along the last joint axis",
          "alpha in row 1, 1.5708, is taken as pi/2; alpha in row 2, 0.00005, is taken as 0; "
          "alpha in row 3, 1.57, is taken as pi/2; alpha in row 4, -3.1416, is taken as -pi; "
          "theta in row 4, q4+4.7124, is taken as 3 pi/2; write them so"]),
        ("0 0 0.4 q1; 0 1.57 0 q2; 0.3 0 0 q3; 0.2 -4.71 0.05 q4+3.14; 0 0 0 0",
         "0 pi/2 0.4 q1; 0.3 0 0 q2; 0.2 pi/2 0 q3; 0 0 0.05 q4",
         {"convention": "craig"},
         [JOINTS.format("its q_4 is your q_4 + 180°"),
          "alpha in row 2, 1.57, is taken as pi/2; alpha in row 4, -4.71, is taken as -3 pi/2; "
          "theta in row 4, q4+3.14, is taken as pi; write them so"]),
        # Equal angles of a column are named together.
        ("0 1.5708 0.4 q1; 0.3 0 0 q2; 0.2 1.5708 0.05 q3; 0 0 0.25 q4+0.3", ELBOWED, {},
         ["alpha in rows 1 and 3, 1.5708, is taken as pi/2; write them so"]),
        # Rounded angles beside whole lengths.
        ("20 1.1 -20 -q1+1.871; 30 0.7 -20 3.542; -20 0 50 q3",
         "-0.2 -1.1 -0.2 q1-pi/2; 0.3 0.7 -0.2 0.4; -0.2 0 0.5 q3", {"lengths": "cm"},
         ["its q_1 is your q_1 + 17.18°", "the last digit of a length differs"]),
    ],
)  # fmt: skip
def test_table_with_other_joint_zeros_is_right_by_map(typed, reference, options, messages):
    report = compare_rows(typed, reference, **options)
    assert (report.grade, report.causes) == ("right by map", ()), str(report)
    assert [words for words in messages if words not in f"{report}\n"] == [], str(report)


@pytest.mark.parametrize(
    ("typed", "reference", "options", "grade", "message"),
    [
        # A zero that differs by 0.001 degrees counts as the same.
        (GENERIC.replace("q3+0.3", "q3+0.30001"), GENERIC, {}, "right", "the same arm as Ref."),
        ("0 pi/2 0.4 q1; 0.301 0 0 q2; 0.2 pi/2 0.050 q3; 0 0 0.250 q4",
         ELBOWED.replace("0.3 ", "0.3006 "), {}, "rounded", "but for the last digit"),
        ("0 pi/2 0.1 q1; 0.3 0 0.05 q2+0.3; 0.2 pi/2 0 q3-pi/2; 0 0 0.25 q4", ELBOWED, {}, "wrong",
         BASE.format("300 mm higher") + "(see d in row 1)"),
        ("0 pi/2 0.1 q1; 0.3 0 0.05 q2; 0.2 pi/2 0 q3; 0 0 0.25 q4", ELBOWED, {}, "wrong",
         BASE.format("300 mm higher") + "(see d in row 1): d in row 1 is 300 mm too short"),
        ("0.1 0 0.7 q1; 0.3 0 0 q2; 0.2 pi/2 0.1 q3; 0.25 0 0 0", ROOTED, {"convention": "craig"},
         "wrong", BASE.format("500 mm lower") + "(see d in row 2)"),
        (LEANING.replace("0.2 q1", "0.5 q1"), LEANING, {}, "wrong",
         BASE.format("300 mm lower") + "(see d in row 2)"),
        ("0 pi/2 0.5 q1; 0 pi/2 d2+0.1 pi/2; 0.2 0 0.1 q3",
         "0 pi/2 0.4 q1; 0 pi/2 d2 pi/2; 0.2 0 0.1 q3", {}, "wrong",
         BASE.format("100 mm lower") + "(see d in row 1)"),
        # The height counts along axis 1 also where the parallel axis 2 points the other way.
        ("0.3 pi 0.6 q1; 0.2 pi/2 0.1 q2; 0.2 0.5 0.1 q3; 0.1 0 0.3 q4",
         "0.3 pi 0.4 q1; 0.2 pi/2 0.1 q2; 0.2 0.5 0.1 q3; 0.1 0 0.3 q4", {}, "wrong",
         BASE.format("200 mm lower") + "(see d in row 2)"),
        (GENERIC.replace("0.1 pi/3 0.4", "0.1 4pi/3 -0.4"), GENERIC, {}, "wrong",
         "but your z_0 points the other way along axis 1, so the arm hangs from its base"),
        (ELBOWED.replace("0 0 0.25", "0 0.5 0.25"), ELBOWED, {}, "wrong",
         "the last frame's z axis is 28.65° in yours and 0° in the reference (alpha in "
         "row 4): alpha in row 4 should be 0 (you have 0.5)"),
        # A fixed first row turns the base about z_0, which no joint does.
        (LEANING.replace("0.3 0;", "0.3 0.5;"), LEANING, {}, "wrong",
         "but no choice of zeros and directions of its joints makes its tip move"),
    ],
)  # fmt: skip
def test_base_and_tip_of_the_question_are_no_choice(typed, reference, options, grade, message):
    report = compare_rows(typed, reference, **options)
    assert is_same_machine(report), str(report)
    assert report.grade == grade, str(report)
    assert message in report.headline


def test_fixed_pose_excludes_joint_maps():
    typed = "q1 0.5 0 90; q2+90 0 0.4 0; q3 0 0.3 0".replace(";", "\n")
    assert compare_tables(typed, ELBOW).grade == "right by map"
    report = compare_tables(typed, ELBOW, start_configuration=[0, 0, 0])
    assert (report.grade, report.causes) == ("wrong", ())
    words = "is at q = (0, 0, 0), and the tip of your table is 0.99 m away from there, "
    assert words in report.headline
    turned = typed.replace("q2+90", "q2").replace("90", "-90")  # joints 2 and 3 count backwards
    assert compare_tables(turned, ELBOW, start_configuration=[0, 0, 0]).grade == "wrong"
    assert compare_tables(ELBOW, ELBOW, start_configuration=[0, 0, 0]).grade == "right"
    with pytest.raises(ArmError, match="start_configuration"):
        compare_tables(typed, ELBOW, start_configuration=[0, 0])


@pytest.mark.parametrize("arm", [UR10E, PANDA, STANFORD, PANDA.lock(3), SCARA], ids=str)
def test_first_rows_of_a_table_are_right_so_far(arm):
    """Also with other zeros and directions of the joints; not with a wrong length."""
    for count in range(2, len(arm.rows)):
        first = Arm("first", arm.rows[:count], values=arm.values)
        for mine in (first, flip_z(flip_x(shift_zero(first, 0, 0.3), 0), 0)):
            report = compare_tables(mine, arm)
            assert (report.grade, report.causes) == ("so far", ()), (count, str(report))
            assert report.figures == {"right": first.dof, "of": arm.dof}
        longer = replace_rows(first, 1, replace(first.rows[1], a=0.87, joint=Joint()))
        assert compare_tables(longer, arm).grade == "wrong", count


# Their joints


HEAVY_SCARA = SCARA.with_bodies([Body(k + 1.0, (0.1, 0.2, 0.3 * k)) for k in range(4)])
BEYOND = Arm(  # the height of its base shows beyond a slide only
    "beyond",
    [revolute(0, "pi/2", 0.4), prismatic(0, "pi/2", 0, "pi/2"), revolute(0.2, 0, 0.1)],
    bodies=[Body(k + 1.0, (0.1, 0.2, 0.3 * k)) for k in range(3)],
)
WITH_BODIES = tuple(arm for arm in (PANDA, UR10E, UR10E_HOMEWORK, PANDA.lock(3)) if arm.bodies)


@pytest.mark.parametrize("reference", [*WITH_BODIES, BASED, STANFORD, HEAVY_SCARA, BEYOND], ids=str)
@pytest.mark.parametrize("seed", range(8))
def test_arm_in_students_joints_behaves_like_reference(reference, seed):
    """Frames, torques and limits agree at the joints that the map gives."""
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
        wanted = signs * gravity_torque(reference, signs * q + shifts, down)
        np.testing.assert_allclose(gravity_torque(own, q, down), wanted, atol=1e-9)
