"""compare_tables accepts every valid choice of frames, and nothing else."""

from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.checks import compare_tables
from helpers.conventions import modified_from_standard
from helpers.kinematics import forward_kinematics
from helpers.robots import ARMS, ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from tests.laws import instructors_arm
from tests.machines import random_pair, same_machine

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


def _plus(entry, number):
    return f"{entry} + {number}"


def flip_z(arm, i):
    """Axis i + 1 points the other way: its joint counts backwards."""
    row, following = arm.rows[i], arm.rows[i + 1]
    rows = list(arm.rows)
    rows[i] = replace(row, alpha=_plus(row.alpha, "pi"))
    rows[i + 1] = replace(
        following,
        alpha=_plus(following.alpha, "pi"),
        d=f"-({following.d})",
        theta=f"-({following.theta})",
    )
    return replace(arm, rows=rows, bodies=()), i + 1


def flip_x(arm, i):
    row, following = arm.rows[i], arm.rows[i + 1]
    rows = list(arm.rows)
    rows[i] = replace(row, theta=_plus(row.theta, "pi"), a=f"-({row.a})", alpha=f"-({row.alpha})")
    rows[i + 1] = replace(following, theta=_plus(following.theta, "pi"))
    return replace(arm, rows=rows, bodies=())


def shift_zero(arm, i, by):
    row = arm.rows[i]
    moved = "d" if row.joint.kind == "prismatic" else "theta"
    rows = [
        *arm.rows[:i],
        replace(row, **{moved: _plus(getattr(row, moved), by)}),
        *arm.rows[i + 1 :],
    ]
    return replace(arm, rows=rows, bodies=())


def slide_normal(arm, i, by):
    """Axes i + 1 and i + 2 are parallel: their common normal is moved along them."""
    row, following = arm.rows[i], arm.rows[i + 1]
    assert arm.numeric[i].sin_alpha == 0
    back = -by * arm.numeric[i].cos_alpha
    rows = list(arm.rows)
    rows[i], rows[i + 1] = (
        replace(row, d=_plus(row.d, by)),
        replace(following, d=_plus(following.d, back)),
    )
    return replace(arm, rows=rows, bodies=())


@pytest.mark.parametrize("arm", REFERENCES, ids=lambda arm: arm.name)
def test_the_choices_in_these_tests_are_choices(arm):
    """Each change of frames leaves the tip where it was: so says forward kinematics, which shares
    nothing with the checker."""
    q = np.random.default_rng(0).uniform(-1, 1, arm.dof)
    tip = forward_kinematics(arm, q)[:3, 3]
    for i in range(len(arm.rows) - 1):
        changed, reversed_joint = flip_z(arm, i)
        backwards = np.where(np.arange(arm.dof) == reversed_joint, -q, q)
        np.testing.assert_allclose(forward_kinematics(changed, backwards)[:3, 3], tip, atol=1e-12)
        np.testing.assert_allclose(forward_kinematics(flip_x(arm, i), q)[:3, 3], tip, atol=1e-12)
        if arm.numeric[i].sin_alpha == 0:
            np.testing.assert_allclose(
                forward_kinematics(slide_normal(arm, i, 0.3), q)[:3, 3], tip, atol=1e-12
            )


@pytest.mark.parametrize("arm", REFERENCES, ids=lambda arm: arm.name)
@settings(max_examples=30, deadline=None)
@given(data=st.data())
def test_every_valid_choice_is_accepted(arm, data):
    mine = arm
    for _ in range(data.draw(st.integers(1, 6))):
        i = data.draw(st.integers(0, len(arm.rows) - 2))
        kind = data.draw(st.sampled_from(["z", "x", "zero", "slide"]))
        if kind == "z":
            mine, _ = flip_z(mine, i)
        elif kind == "x":
            mine = flip_x(mine, i)
        elif kind == "zero":
            mine = shift_zero(mine, i, data.draw(st.sampled_from([0.3, -1.2, 2.5])))
        elif arm.numeric[i].sin_alpha == 0:
            mine = slide_normal(mine, i, data.draw(st.sampled_from([0.11, -0.2])))
    report = compare_tables(mine, arm)
    assert report.agrees, str(report)


@pytest.mark.parametrize("arm", REFERENCES, ids=lambda arm: arm.name)
@pytest.mark.parametrize("size", [0.004, 0.3])
def test_every_wrong_length_and_twist_is_found(arm, size):
    """Unless it is one of the free choices, each given here by hand with its reason."""
    for i in range(len(arm.rows)):
        for name in ("a", "alpha", "d"):
            row = replace(arm.rows[i], **{name: _plus(getattr(arm.rows[i], name), size)})
            mine = replace(arm, rows=[*arm.rows[:i], row, *arm.rows[i + 1 :]], bodies=())
            free = (
                (name == "alpha" and i == len(arm.rows) - 1)  # the last frame's tilt
                or (
                    name == "d" and (arm.rows[i].joint.kind == "prismatic" or i == 0)
                )  # a zero; the base
                or (name == "d" and _slides_along(arm, i))  # the slide's zero takes it up
            )
            assert compare_tables(mine, arm).agrees == free, (arm.name, i + 1, name)


def _slides_along(arm, i):
    """Whether a joint slides along an axis that parallel axes alone link to row i's."""
    parallel = [row.sin_alpha == 0 for row in arm.numeric]
    first = next((k + 1 for k in reversed(range(i)) if not parallel[k]), 0)
    last = next((k for k in range(i, len(parallel)) if not parallel[k]), len(parallel) - 1)
    return any(row.joint.kind == "prismatic" for row in arm.rows[first : last + 1])


def test_the_two_makers_tables_of_the_ur10e():
    same_lengths = UR10E.with_values(**dict(UR10E_HOMEWORK.values))
    assert compare_tables(UR10E_HOMEWORK, same_lengths).agrees
    report = compare_tables(UR10E_HOMEWORK, UR10E)
    sizes = {
        (f.row, f.quantity): round(1000 * abs(f.mine - f.reference), 6) for f in report.findings
    }
    assert sizes == {(3, "a"): 0.05, (4, "d"): 10.25, (5, "d"): 4.15, (6, "d"): 24.35}
    along = [f.text for f in report.findings if f.quantity == "d"]
    assert along[0] == (
        "the offset along the parallel axes 2 to 4, added up, is 0.1639 m in yours and 0.17415 m"
        " in the reference:"
        " 10.25 mm too short."
    )
    assert along[2].startswith("the offset along axis 6 is 0.1922 m in yours and 0.21655 m in the")
    assert "24.35 mm too short" in str(report)


def test_the_homeworks_panda():
    report = compare_tables(PANDA_HOMEWORK, PANDA)
    assert [(f.row, f.quantity) for f in report.findings] == [(3, "a"), (4, "a")]
    assert "5.5 mm too long" in report.findings[0].text


def test_a_wrong_twist_is_named():
    rows = list(UR10E.rows)
    rows[4] = replace(rows[4], alpha="pi/3")
    (finding,) = compare_tables(replace(UR10E, rows=rows, bodies=()), UR10E).findings
    assert (finding.row, finding.quantity) == (5, "alpha")
    assert "60° in yours and 90° in the reference: 30° off" in str(finding)


def test_the_sign_of_an_offset_matters_where_axes_are_skew():
    """Mirrored arms have equal distances and twists, but no choice of frames turns one into the
    other."""
    rows = [*SKEW.rows[:2], replace(SKEW.rows[2], d=-0.2), SKEW.rows[3]]
    report = compare_tables(Arm("mirrored", rows), SKEW)
    assert not report.agrees
    assert "-0.2 m in yours and 0.2 m in the reference: it goes the other way, so a sign" in str(
        report
    )


def test_kind_and_number_of_joints():
    rows = [*STANFORD.rows[:2], revolute(), *STANFORD.rows[3:]]
    (finding,) = compare_tables(replace(STANFORD, rows=rows), STANFORD).findings
    assert (
        str(finding)
        == "Row 3, joint: the joint is revolute in yours and prismatic in the reference."
    )
    (finding,) = compare_tables(ELBOW, STANFORD).findings
    assert str(finding) == "Row 3, number of joints: yours has 3, the reference 6."


def test_another_base_is_a_note_not_an_error():
    short = ELBOW.with_values(d_1=0.2)
    report = compare_tables(short, ELBOW)
    assert report.agrees
    (note,) = report.notes
    assert note.startswith("your base frame stands 300 mm higher on axis 1 (d in row 1)")
    assert "300 mm lower on axis 1" in compare_tables(ELBOW, short).notes[0]
    assert compare_tables(ELBOW, ELBOW).notes == ()


def test_fixed_rows_belong_to_their_link():
    split = [*ELBOW.rows[:1], revolute(a="a_2 / 2", d="-d"), fixed(a="a_2 / 2"), *ELBOW.rows[2:]]
    assert compare_tables(replace(ELBOW, rows=split), ELBOW).agrees


@pytest.mark.parametrize(
    ("mend", "words"),
    [
        (
            lambda rows: [replace(r, alpha=r.theta, theta=r.alpha) for r in rows],
            "alpha and theta columns are exchanged",
        ),
        (lambda rows: [replace(r, alpha=f"({r.alpha}) * 180 / pi") for r in rows], "in degrees"),
        (
            lambda rows: [replace(r, a=f"({r.a}) * 1000", d=f"({r.d}) * 1000") for r in rows],
            "in millimetres",
        ),
        (modified_from_standard, "modified (Craig) convention"),
    ],
)
def test_the_usual_causes_are_named(mend, words):
    report = compare_tables(replace(PANDA, name="mine", rows=mend(PANDA.rows), bodies=()), PANDA)
    assert not report.agrees
    assert any(words in note for note in report.notes), report


def test_the_report_reads_well():
    report = compare_tables(replace(PANDA_HOMEWORK, name="mine"), PANDA)
    assert str(report).startswith(
        "mine is another arm than Panda.\n- Row 3, a: the distance from axis 3 to axis 4 is"
    )
    assert report._repr_markdown_().startswith(
        "✘ **mine is another arm than Panda.**\n\n- Row 3, a:"
    )
    assert (
        compare_tables(PANDA, PANDA)
        ._repr_markdown_()
        .startswith("✔ **Panda describes the same arm")
    )


def test_what_is_no_arm_is_refused():
    with pytest.raises(ArmError, match="expected an Arm"):
        compare_tables([[0, 0, 0, 0]], PANDA)
    with pytest.raises(ArmError, match="one joint or more"):
        compare_tables(Arm("bracket", [fixed(a=1)]), PANDA)


@pytest.mark.parametrize("seed", range(60))
def test_the_verdict_is_that_of_the_motion(seed):
    """Half of these 60 pairs are the same machine and half are not (see the next test)."""
    mine, reference = random_pair(seed)
    report = compare_tables(mine, reference)
    assert report.agrees == same_machine(mine, reference), (
        f"{reference._repr_markdown_()}\n{report}"
    )


def test_the_pairs_above_are_of_both_sorts():
    same = sum(compare_tables(*random_pair(seed)).agrees for seed in range(60))
    assert 15 <= same <= 45


@pytest.mark.parametrize(
    ("mine", "reference"),
    [
        # Reversed slides, moved sliding axes, and slides before the first axis that turns.
        (
            [
                revolute(0.5, -1.1, 0.3),
                prismatic(-0.3, "pi/2", -0.2, "pi/2"),
                revolute(0, -1.1, 0.5),
            ],
            [
                revolute(0.5, -1.1, 0.3),
                prismatic(0.3, "pi/2", -0.2, "pi/2"),
                revolute(0, -1.1, 0.5),
            ],
        ),
        (
            [prismatic(0.3, "-pi/2", 0.3), revolute(0.3, "pi", 0.4), revolute(-0.2, -1.1, 0.1)],
            [prismatic(0.3, "-pi/2", 0.3), revolute(0.3, "pi", 0.5), revolute(-0.2, -1.1, 0.2)],
        ),
        (
            [
                revolute(0.3, "-pi/2"),
                prismatic(-0.2, "-pi/2", 0.8, "pi/2"),
                prismatic(0.3, -1.1, -0.3),
            ],
            [
                revolute(0.3, "-pi/2"),
                prismatic(-0.2, "-pi/2", 0.5, "pi/2"),
                prismatic(0.3, -1.1, 0.3),
            ],
        ),
        (
            [prismatic(0.7, "pi/2"), prismatic(0, "-pi/2", 1), prismatic()],
            [prismatic(0, "pi/2"), prismatic(0, "pi/2"), prismatic(0.1)],
        ),
    ],
)
def test_slides_leave_lengths_free(mine, reference):
    mine, reference = Arm("mine", mine), Arm("reference", reference)
    assert same_machine(mine, reference)
    assert compare_tables(mine, reference).agrees


def test_what_a_slide_cannot_make_up_for_is_found():
    square = [revolute(0, "pi/2"), prismatic(0, "pi/2"), revolute(0, "pi/2", 0.3), revolute(0.2)]
    turned = [square[0], prismatic(0, "pi/2", 0, 0.5), *square[2:]]
    (finding,) = compare_tables(Arm("turned", turned), Arm("square", square)).findings
    assert (finding.row, finding.quantity) == (2, "theta")
    assert "28.6479° off" in str(finding)
    assert not same_machine(Arm("turned", turned), Arm("square", square))


def test_angles_written_with_four_decimals_are_meant_as_right_angles():
    """Taken literally, axes 2 and 3 of this table would meet 60 km away, and no offset along them
    could be compared."""
    rounded = {"pi": 3.1416, "pi/2": 1.5708, "-pi/2": -1.5708}
    rows = [
        replace(r, alpha=rounded.get(r.alpha, r.alpha), theta=rounded.get(r.theta, r.theta))
        for r in UR10E_HOMEWORK.rows
    ]
    mine = replace(UR10E_HOMEWORK, rows=rows)
    report = compare_tables(mine, UR10E_HOMEWORK)
    assert report.agrees
    assert "alpha in row 2, 3.1416, is taken as pi; write it so" in str(report)
    assert [note.split(", is taken as")[0] for note in report.notes] == [
        "alpha in row 1, -1.5708", "alpha in row 2, 3.1416", "theta in row 2,"
                                                             " -1.5708", "alpha in row 3, 3.1416",
        "alpha in row 4, 1.5708", "theta in row 4, 1.5708", "alpha in row 5, -1.5708",
    ]  # fmt: skip
    (finding,) = compare_tables(mine.with_values(d_4=0.1739), UR10E_HOMEWORK).findings
    assert (finding.row, finding.quantity) == (4, "d")
    assert "10 mm too long" in finding.text


@pytest.mark.parametrize(("angle", "near"), [(1.57073, True), (1.57087, True), (1.5706, False)])
def test_a_right_angle_is_meant_within_a_ten_thousandth(angle, near):
    """pi/2 is 1.570796: these are 0.00007, 0.00007 and 0.0002 off."""
    rows = [replace(UR10E.rows[0], alpha=angle), *UR10E.rows[1:]]
    report = compare_tables(replace(UR10E, rows=rows), UR10E)
    assert report.agrees == near
    assert any("is taken as pi/2; write it so" in note for note in report.notes) == near


def test_a_tilted_tool_frame_is_a_note():
    rows = [*UR10E.rows[:5], replace(UR10E.rows[5], alpha="pi/2")]
    report = compare_tables(replace(UR10E, rows=rows, bodies=()), UR10E)
    assert report.agrees
    assert "at 90° to the last joint axis in yours and at 0° in the reference" in report.notes[0]


def test_other_zeros_are_a_note():
    """A shoulder offset of the other sign is the same arm, turned half round: but not at the same
    q."""
    mirrored = replace(
        UR10E, rows=[*UR10E.rows[:3], replace(UR10E.rows[3], d="-d_4"), *UR10E.rows[4:]]
    )
    for mine in (mirrored, shift_zero(UR10E, 2, 0.5), flip_z(UR10E, 2)[0]):
        report = compare_tables(mine, UR10E)
        assert report.agrees
        assert report.notes == (
            "the same q is another pose: some of your joints count from another zero, or the other"
            " way.",
        )
    assert compare_tables(slide_normal(UR10E, 1, 0.2), UR10E).notes == ()


def test_the_height_of_the_base_is_told_beside_what_is_wrong():
    (note,) = compare_tables(UR10E_HOMEWORK, UR10E).notes
    assert note.startswith("your base frame stands 52.7 mm higher on axis 1 (d in row 1)")


def test_rows_are_counted_in_the_table_that_is_asked_about():
    reference = PANDA.lock(3)
    rows = [fixed(), *reference.rows]
    rows[4] = replace(rows[4], a=-0.09)
    (finding,) = compare_tables(Arm("mine", rows, dict(PANDA.values)), reference).findings
    assert (finding.row, finding.quantity) == (5, "a")
    assert "from axis 5 to axis 6" in str(finding)


def test_a_report_is_a_value():
    report = compare_tables(PANDA_HOMEWORK, PANDA)
    assert report == compare_tables(PANDA_HOMEWORK, PANDA)
    assert hash(report) == hash(compare_tables(PANDA_HOMEWORK, PANDA))
    with pytest.raises(FrozenInstanceError):
        report.findings = ()
