"""compare_jacobian names the mistake, and accepts what is right in any valid form."""

import numpy as np
import pytest
import sympy as sp

from helpers import symbolic
from helpers.arm import ArmError
from helpers.checks import compare_jacobian
from helpers.kinematics import forward_kinematics, jacobian, link_frames
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from tests.laws import ALL_ARMS, ids

LOCKED = PANDA.lock(3)
RAD = np.pi / 180


def parts(arm, q):
    """Axes z_0 .. z_n, origins o_0 .. o_n and the tip, to build wrong Jacobians from."""
    T = link_frames(arm, q)
    return T[:, :3, 2], T[:, :3, 3], T[-1, :3, 3]


def built(column):
    """A student's Jacobian of an arm whose joints all turn, by a rule for column i = 1 .. n."""

    def J(q, arm=UR10E):
        z, o, tip = parts(arm, q)
        return np.stack(
            [np.concatenate(column(i, z, o, tip)) for i in range(1, arm.dof + 1)], axis=1
        )

    return J


def rotated(k):
    def J(q):
        R = link_frames(UR10E, q)[k, :3, :3]
        right = jacobian(UR10E, q)
        return np.vstack([R.T @ right[:3], R.T @ right[3:]])

    return J


def slid_as_turned(q):
    z, o, tip = parts(STANFORD, q)
    return np.stack([np.concatenate([np.cross(z[i], tip - o[i]), z[i]]) for i in range(6)], axis=1)


def rows_of_t(q):
    T = link_frames(UR10E, q)
    return np.stack(
        [np.concatenate([np.cross(T[i, 2, :3], [0, 0, 0]), T[i, 2, :3]]) for i in range(6)], axis=1
    )


WRONG = [
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i - 1], p - o[i - 1]), z[i])),
     "use z_i where z_{i-1} belongs"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i], p - o[i]), z[i])),
     "one frame too far: joint i has z_{i-1} and o_{i-1}"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i], p - o[i - 1]), z[i])),
     "axes are one frame too far"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i - 1], p), z[i - 1])), "lever arm is o_n alone"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i - 1], o[i - 1]), z[i - 1])),
     "lever arm is o_{i-1} alone"),
    (UR10E, built(lambda i, z, o, p: (np.cross(p - o[i - 1], z[i - 1]), z[i - 1])),
     "wrong way round"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i - 1], o[4] - o[i - 1]), z[i - 1])),
     "a point at o_4, not of the tip"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i - 1], p - o[i - 1]), 0 * p)),
     "angular rows are zero"),
    (UR10E, lambda q: np.roll(jacobian(UR10E, q), 3, axis=0),
     "Linear and angular rows are exchanged"),
    (UR10E, lambda q: -jacobian(UR10E, q), "Every sign is reversed"),
    (UR10E, lambda q: jacobian(UR10E, q) * np.repeat([1000, 1], 3)[:, None], "in millimetres"),
    (UR10E, lambda q: jacobian(UR10E, np.radians(q)), "q is taken in degrees"),
    (UR10E, lambda q: np.radians(jacobian(UR10E, q)), "per degree"),
    (UR10E, rotated(3), "axes of frame 3, not of the base"),
    (UR10E, rotated(6), "axes of frame 6, not of the base"),
    (UR10E, rows_of_t, "read from the rows of T"),
    (UR10E, built(lambda i, z, o, p: (np.cross(z[i - 1], p - o[i]), z[i - 1])),
     "lever arm starts at o_i:"),
    (UR10E, lambda q: jacobian(UR10E, np.degrees(q)), "q is taken in degrees"),
    (STANFORD, lambda q: jacobian(STANFORD, q * [RAD, RAD, 1, RAD, RAD, RAD]),
     "q is taken in degrees"),
    (UR10E, lambda q: jacobian(UR10E, q).T, "transposed"),
    (LOCKED, lambda q: jacobian(LOCKED, q).T, "transposed"),
    (LOCKED, lambda q: np.delete(jacobian(PANDA, np.insert(q, 2, 0)), 3, axis=1),
     "Column 3 (joint 4): this is the column of joint 3, which is locked."),
    (ELBOW, lambda q: jacobian(ELBOW, q).T, "transposed"),
    (STANFORD, slid_as_turned, "slides is treated as one that turns"),
    (LOCKED, lambda q: np.delete(jacobian(PANDA, np.insert(q, 2, 0)), 2, axis=0),
     "A row is missing where a column should be"),
    (LOCKED, lambda q: jacobian(PANDA, np.insert(q, 2, 0)),
     "still has a column for a joint that is locked"),
    (ELBOW, lambda q: jacobian(ELBOW, q)[:3], "three rows"),
    (ELBOW, lambda q: np.zeros((4, 4)), "expected (6, 3)"),
]  # fmt: skip


@pytest.mark.parametrize(("arm", "wrong", "words"), WRONG)
def test_the_mistake_is_named(arm, wrong, words):
    (finding,) = compare_jacobian(wrong, arm).findings
    assert words in finding


Z_I = built(lambda i, z, o, p: (np.cross(z[i - 1], p - o[i - 1]), z[i]))


def in_axes_of(frame, J):
    def turned(q):
        R = link_frames(UR10E, q)[frame, :3, :3]
        return np.vstack([R.T @ J(q)[:3], R.T @ J(q)[3:]])

    return turned


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (Z_I, "use z_i where z_{i-1} belongs"),
        (lambda q: -jacobian(UR10E, q), "Every sign is reversed"),
        (built(lambda i, z, o, p: (np.cross(z[i - 1], p), z[i - 1])), "lever arm is o_n alone"),
    ],
)
@pytest.mark.parametrize("frame", [3, 6])
def test_the_mistake_is_named_in_a_declared_frame_too(wrong, words, frame):
    (finding,) = compare_jacobian(in_axes_of(frame, wrong), UR10E, frame=frame).findings
    assert words in finding


def test_a_frame_declared_but_not_used_is_named():
    (finding,) = compare_jacobian(lambda q: jacobian(UR10E, q), UR10E, frame=6).findings
    assert "in the axes of the base, not of frame 6; if you mean that, say frame=0" in finding
    (finding,) = compare_jacobian(
        lambda q: in_axes_of(6, lambda q: jacobian(UR10E, q))(q).T, UR10E, frame=6
    ).findings
    assert "transposed" in finding


def test_two_mistakes_are_named_where_each_has_a_half():
    wrong = built(lambda i, z, o, p: (np.cross(p - o[i - 1], z[i - 1]), z[i]))
    linear, angular = compare_jacobian(wrong, UR10E).findings
    assert linear.startswith("In the linear rows: the cross product is taken the wrong way round")
    assert angular.startswith("The angular rows use z_i where z_{i-1} belongs")


def test_a_locked_column_kept_among_the_others_is_named():
    def wrong(q):
        return np.delete(jacobian(PANDA, np.insert(q, 2, 0)), 1, axis=1)

    (finding,) = compare_jacobian(wrong, LOCKED).findings
    assert finding == "Column 2 (joint 2): this is the column of joint 3, which is locked."


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda c: -c, "Column 4 (joint 4): its sign is reversed"),
        (
            lambda c: np.roll(c, 3),
            "Column 4 (joint 4): its linear and angular halves are exchanged",
        ),
        (lambda c: np.add(c, [0, 0.01, 0, 0, 0, 0]), "its linear part is wrong, in vy."),
        (lambda c: np.add(c, [0, 0, 0, 0, 0.2, 0.1]), "its angular part is wrong, in wy, wz."),
        (
            lambda c: c * [1000, 1000, 1000, 1, 1, 1],
            "Column 4 (joint 4): the linear rows are in millimetres",
        ),
    ],
)
def test_a_wrong_column_is_named(spoil, words):
    def J(q):
        right = jacobian(UR10E, q)
        right[:, 3] = spoil(right[:, 3])
        return right

    (finding,) = compare_jacobian(J, UR10E).findings
    assert words in finding


def test_exchanged_columns_are_named_by_joint():
    report = compare_jacobian(lambda q: jacobian(LOCKED, q)[:, [0, 1, 3, 2, 4, 5]], LOCKED)
    assert [f.split(":")[1] for f in report.findings] == [
        " this is the column of joint 5.",
        " this is the column of joint 4.",
    ]


@pytest.mark.parametrize("arm", ALL_ARMS, ids=ids)
def test_what_is_right_is_accepted_in_every_form(arm):
    q = np.array(arm.home) * 0.9 + 0.05
    J = jacobian(arm, q)
    assert compare_jacobian(J, arm, q).agrees
    assert compare_jacobian(lambda q: jacobian(arm, q), arm).agrees
    assert compare_jacobian(symbolic.jacobian(arm), arm).agrees
    assert compare_jacobian(
        lambda q: np.roll(jacobian(arm, q), 3, axis=0), arm, angular_first=True
    ).agrees
    R = forward_kinematics(arm, q)[:3, :3]
    in_tool = np.vstack([R.T @ J[:3], R.T @ J[3:]])
    assert compare_jacobian(in_tool, arm, q, frame=len(arm.rows)).agrees


@pytest.mark.parametrize("arm", ALL_ARMS, ids=ids)
def test_functions_of_single_joints_and_short_symbols_are_accepted(arm):
    J = symbolic.jacobian(arm)
    numbers = symbolic.with_numbers(arm, J)
    assert compare_jacobian(sp.lambdify(symbolic.joint_symbols(arm), numbers), arm).agrees
    assert compare_jacobian(symbolic.short(J), arm).agrees
    assert not compare_jacobian(symbolic.short(-J), arm).agrees


def test_an_array_is_right_at_its_pose_only():
    at_home = compare_jacobian(jacobian(UR10E, UR10E.home), UR10E, UR10E.home)
    assert str(at_home) == "The Jacobian of UR10e is right at this pose."


def test_no_number_is_given_away():
    for arm, wrong, _ in WRONG:
        text = str(compare_jacobian(wrong, arm))
        right = jacobian(arm, np.full(arm.dof, 0.5))
        assert not any(f"{abs(x):.3f}" in text for x in right.ravel() if abs(x) > 1e-3)


def test_the_report_reads_well():
    right = compare_jacobian(symbolic.jacobian(ELBOW), ELBOW)
    assert str(right) == "The Jacobian of Elbow arm is right."
    assert right._repr_markdown_() == "✔ **The Jacobian of Elbow arm is right.**\n"
    wrong = compare_jacobian(-symbolic.jacobian(ELBOW), ELBOW)
    assert wrong._repr_markdown_().startswith(
        "✘ **The Jacobian of Elbow arm is not right.**\n\n- Every sign"
    )


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (
            lambda: compare_jacobian(np.eye(6), UR10E_HOMEWORK),
            "say which: compare_jacobian(mine, arm, q)",
        ),
        (
            lambda: compare_jacobian(lambda q: "J", ELBOW),
            "your Jacobian is 'J'; expected a matrix of numbers",
        ),
        (
            lambda: compare_jacobian(lambda q: np.full((6, 3), np.nan), ELBOW),
            "expected a matrix of finite numbers",
        ),
        (
            lambda: compare_jacobian(sp.Matrix([sp.Symbol("t")]), ELBOW),
            "no value for t; known are q_1, q_2, q_3, d_1",
        ),
        (lambda: compare_jacobian(np.eye(6), UR10E, np.zeros((2, 6))), "expected one pose, (6,)"),
        (lambda: compare_jacobian(np.eye(6), UR10E, np.zeros(5)), "UR10e: q has shape (5,)"),
        (lambda: compare_jacobian(lambda q: np.eye(6), UR10E, frame=9), "frame 9 does not exist"),
        (
            lambda: compare_jacobian(sp.Matrix([sp.Symbol("c_4")]), ELBOW),
            "no value for c_4; known are q_1, q_2, q_3, d_1",
        ),
    ],
)
def test_bad_input_is_told_in_words(make, words):
    with pytest.raises(ArmError) as told:
        make()
    assert words in str(told.value)
