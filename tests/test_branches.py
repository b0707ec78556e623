"""The branch checker: what it says of right, wrong and missing joint angles of targets solved by
hand.

The elbow arm's links, 0.4 and 0.3 m, are the legs of a right angle over (0.5, 0, 0.5), its shoulder
at (0, 0, 0.5): the first leans by LOW = atan2(3, 4), the second by a right angle more. Angles and
misses follow from that triangle.
"""

from dataclasses import replace

import numpy as np
import pytest

from helpers.arm import ArmError
from helpers.checks import BranchReport, compare_branches
from helpers.inverse import elbow, stanford, ur
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, STANFORD, UR10E

LOW, RIGHT, PI = np.arctan2(3, 4), np.pi / 2, np.pi
FOUND = elbow(ELBOW, (0.5, 0.0, 0.5))
ANSWERS = np.array(
    [(0, LOW, -RIGHT), (0, -LOW, RIGHT), (PI, PI - LOW, RIGHT), (PI, PI + LOW, -RIGHT)]
)
NAMES = ("front, elbow up", "front, elbow down", "back, elbow up", "back, elbow down")


def first(answer, found=FOUND):
    return compare_branches([answer], found).findings[0]


# Right ones


def test_all_four_are_right():
    report = compare_branches(ANSWERS, FOUND)
    assert report.agrees
    assert report == BranchReport("Elbow arm", NAMES, ())
    head = "Your joint angles for Elbow arm are right and complete."
    names = "".join(f"\n- found: {name}" for name in NAMES)
    assert str(report) == repr(report) == head + names
    assert report._repr_markdown_() == f"✔ **{head}**\n{names}"


def test_order_whole_turns_and_rounding_do_not_matter():
    turned = (ANSWERS + 2 * np.pi * np.array([(1, 0, -1), (0, 2, 0), (-1, 0, 0), (0, 0, 3)]))[::-1]
    assert compare_branches(turned, FOUND).agrees
    assert compare_branches(np.round(ANSWERS, 4), FOUND).agrees
    report = compare_branches(ANSWERS + 2e-4, FOUND)
    assert not report.agrees
    assert report.found == ()


def test_a_lone_answer_leaves_three_missing():
    report = compare_branches(ANSWERS[1], FOUND)
    assert report.found == NAMES[1:2]
    assert report.findings == ("missing: front, elbow up; back, elbow up; back, elbow down",)
    assert str(report) == (
        "Your joint angles for Elbow arm are not right and complete.\n- found: front, elbow down\n"
        "- missing: front, elbow up; back, elbow up; back, elbow down"
    )
    assert report._repr_markdown_().startswith("✘ **Your joint angles")


def test_no_answer_leaves_all_missing_and_twice_the_same_is_one():
    assert compare_branches([], FOUND).findings == (f"missing: {'; '.join(NAMES)}",)
    assert compare_branches([ANSWERS[0], ANSWERS[0]], FOUND).found == NAMES[:1]
    assert compare_branches([ANSWERS[3], ANSWERS[0]], FOUND).found == (NAMES[0], NAMES[3])


# Slips


@pytest.mark.parametrize(
    ("answer", "says"),
    [
        # The forearm, at right angles below the other leg's mirror image, ends 0.36 m short and
        # 0.48 m low.
        ((0, -LOW, -RIGHT), "600 mm: q_2 has the wrong sign, or it would be 'front, elbow up'"),
        # From (0.32, 0.24) on by 0.3 along (0.8, 0.6): 0.06 m beyond, 0.42 m high.
        ((0, LOW, 0), "424 mm: q_3 is in no branch"),
        ((0, 0, 0), "200 mm: q_2, q_3 are in no branch"),
        # (0.24, 0.32) and 0.3 along (0.8, -0.6) end in (0.48, 0.14).
        (
            (0, RIGHT - LOW, -RIGHT),
            "141 mm: q_2 is measured from the other axis (pi/2 less it), or it would be 'front,"
            " elbow up'",
        ),
        # (-0.32, 0.24) and 0.3 along (0.6, 0.8) end in (-0.14, 0.48).
        (
            (0, PI - LOW, -RIGHT),
            "800 mm: each joint is right in some branch, but they belong to different ones",
        ),
    ],
)
def test_a_wrong_answer_is_told_how_far_off_and_why(answer, says):
    assert first(answer) == f"answer 1 misses the target by {says}"


def test_degrees():
    said = first(np.degrees(ANSWERS[0]))
    assert said.endswith(" mm: it is in degrees, or it would be 'front, elbow up'")
    q = np.array((0.3, 0.8, 0.5, 0.4, 0.5, 0.6))
    found = stanford(STANFORD, forward_kinematics(STANFORD, q))
    degrees = np.where(np.arange(6) == 2, q, np.degrees(q))
    assert "it is in degrees, or it would be 'front, rod out, q_5 > 0'" in first(degrees, found)


def test_atan_for_atan2():
    """Behind the arm, atan(0 / -0.5) = 0 points to the front: a metre off."""
    behind = elbow(ELBOW, (-0.5, 0.0, 0.5))
    assert first((0, LOW, -RIGHT), behind) == (
        "answer 1 misses the target by 1e+03 mm: q_1 is half a turn off, as by atan for atan2,"
        " or it would be 'front, elbow up'"
    )


def test_signs():
    """Turned by the 3, 4, 5 triangle's angle up and left, the target is (0.24, 0.32) beside, 0.3 m
    above the shoulder."""
    beside = elbow(ELBOW, (0.24, 0.32, 0.8))
    left, up = np.arctan2(4, 3), 2 * LOW
    assert compare_branches([(left, up, -RIGHT), (left, 0, RIGHT)], beside).found == NAMES[:2]
    one = "misses the target by 640 mm: q_1 has the wrong sign, or it would be 'front, elbow up'"
    assert first((-left, up, -RIGHT), beside) == f"answer 1 {one}"
    # Mirrored in both planes: 0.64 m sideways and 0.6 m down.
    every = "misses the target by 877 mm: every joint has the wrong sign"
    assert (
        first((-left, -up, RIGHT), beside) == f"answer 1 {every}, or it would be 'front, elbow up'"
    )
    # The forearm at right angles up instead of down, by 0.3 m twice.
    third = "misses the target by 600 mm: q_3 has the wrong sign"
    assert first((left, up, RIGHT), beside) == f"answer 1 {third}, or it would be 'front, elbow up'"


@pytest.mark.parametrize("slid", [0.5 - PI, 0.5 + 2 * PI, RIGHT - 0.5])
def test_a_slide_has_neither_turns_nor_another_axis(slid):
    q = np.array((0.3, 0.8, 0.5, 0.4, 0.5, 0.6))
    found = stanford(STANFORD, forward_kinematics(STANFORD, q))
    assert first(np.where(np.arange(6) == 2, slid, q), found) == (
        f"answer 1 misses the target by {1e3 * abs(slid - 0.5):.3g} mm and 0°: q_3 is in no branch"
    )


def test_a_pose_is_missed_by_an_angle_too():
    """Joint 6's axis holds the tip, so its sign turns the tool by 2 x 0.6 rad = 68.8 degrees and
    moves nothing."""
    q = np.array((0.3, 0.8, 0.5, 0.4, 0.5, 0.6))
    found = stanford(STANFORD, forward_kinematics(STANFORD, q))
    assert first(q * (1, 1, 1, 1, 1, -1), found) == (
        "answer 1 misses the target by 0 mm and 68.8°: q_6 has the wrong sign,"
        " or it would be 'front, rod out, q_5 > 0'"
    )


def test_answers_are_numbered_and_right_ones_between_count():
    report = compare_branches([ANSWERS[0], (0, 0, 0), ANSWERS[2], (0, LOW, 0)], FOUND)
    assert report.found == (NAMES[0], NAMES[2])
    assert [finding.split(" misses")[0] for finding in report.findings[:2]] == [
        "answer 2",
        "answer 4",
    ]
    assert report.findings[2] == "missing: front, elbow down; back, elbow down"


def test_out_of_reach_nothing_is_right():
    nowhere = elbow(ELBOW, (2.0, 0.0, 0.5))
    assert compare_branches([], nowhere).agrees
    assert compare_branches([ANSWERS[0]], nowhere).findings == (
        "answer 1 cannot be right: no joint angles reach this target",
    )


def test_an_answer_that_our_list_lacks_is_admitted():
    short = replace(FOUND, valid=np.array([True, False, False, True]))
    assert compare_branches(ANSWERS[[0, 1, 3]], short).findings == (
        "answer 2 reaches the target by joint angles that are no branch of ours: please tell us",
    )


# Free joints


def test_above_the_shoulder_any_value_of_joint_1_will_do():
    """0.4 m above the shoulder the triangle's sides are 0.4, 0.3 and 0.4; joint 1 may point
    anywhere."""
    lean, bend = np.arccos(0.23 / 0.32), np.arccos(-0.09 / 0.24)
    above = elbow(ELBOW, (0.0, 0.0, 0.9), start=(0.7, 0, 0))
    over, under = (-2.0, RIGHT + lean, -bend), (1.3, RIGHT - lean, bend)
    assert compare_branches([over, under], above).agrees
    # One of them is the front's elbow up and, the arm turned about, the back's elbow down.
    assert compare_branches([over], above).found == (NAMES[0], NAMES[3])
    assert compare_branches([under], above).found == (NAMES[1], NAMES[2])
    # Other joints stay bound: 0.02 rad at joint 3 are 6 mm.
    assert first((-2.0, RIGHT + lean, 0.02 - bend), above) == (
        "answer 1 misses the target by 6 mm: q_1, q_3 are in no branch"
    )


def test_a_straight_wrist_may_share_its_turn_as_it_likes():
    """q_5 = 0: only q_4 + q_6 matters, and one answer stands for both wrists."""
    q = np.array((0.3, 0.8, 0.5, 0.4, 0.0, 0.6))
    found = stanford(STANFORD, forward_kinematics(STANFORD, q), start=(0, 0, 0, 1.1, 0, 0))
    for shift in (0.0, 0.5, -2.0):
        report = compare_branches([q + shift * np.array((0, 0, 0, 1, 0, -1))], found)
        assert report.found == ("front, rod out, q_5 > 0", "front, rod out, q_5 < 0")
        assert report.findings[0].startswith("missing: front, rod through")
    assert "misses the target by 0 mm and 28.6°" in first(q + 0.5 * np.eye(6)[3], found)


def test_a_ur_with_parallel_axes_may_turn_joint_6():
    """q_5 = 0: the same elbow at another q_6 is the same branch, and the other elbow is not."""
    q = np.array((0.3, -1.2, 1.4, 0.2, 0.0, 0.5))
    T = forward_kinematics(UR10E, q)
    found = ur(UR10E, T, start=(0, 0, 0, 0, 0, 1.0))
    report = compare_branches([q], found)
    assert report.found == ("back, q_5 > 0, elbow +", "back, q_5 < 0, elbow +")


# Bad input


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (
            lambda: compare_branches(ANSWERS, elbow(ELBOW, [(0.5, 0, 0.5)] * 3)),
            "^Elbow arm: found holds 3 targets; expected the branches of one$",
        ),
        (
            lambda: compare_branches(ANSWERS[None], FOUND),
            r"^Elbow arm: your answers have shape \(1, 4, 3\); expected \(answers, 3\)$",
        ),
        (lambda: compare_branches([(0, 0)], FOUND), r"Elbow arm: q has shape \(1, 2\)"),
        (lambda: compare_branches([(0, np.nan, 0)], FOUND), "Elbow arm: q "),
        (lambda: compare_branches("up", FOUND), "Elbow arm: q "),
    ],
)
def test_bad_input_is_named(call, message):
    with pytest.raises(ArmError, match=message):
        call()
