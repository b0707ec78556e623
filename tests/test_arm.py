"""Test the arm as an immutable value: its checks, changed copies and printed form."""

import math
import pickle
from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest
import sympy as sp

from helpers.arm import Arm, ArmError, Joint, fixed, prismatic, revolute
from helpers.expressions import evaluate_entry
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, PANDA, STANFORD
from tests.laws import ALL_ARMS, arm_id, joint_vectors


def test_arm_equals_its_copy():
    copy = replace(PANDA)
    assert copy == PANDA
    assert hash(copy) == hash(PANDA)
    assert pickle.loads(pickle.dumps(PANDA)) == PANDA


def test_arm_differs_from_arm_of_other_values():
    assert PANDA.with_values(a_3=0.09) != PANDA


def test_arm_is_immutable():
    with pytest.raises(FrozenInstanceError):
        PANDA.name = "mine"


def test_values_are_a_read_only_dict():
    assert dict(ELBOW.values) == ELBOW.values
    assert repr(ELBOW.values) == "{'d_1': 0.5, 'a_2': 0.4, 'a_3': 0.3, 'd': 0.0}"
    assert list(ELBOW.values) == ["d_1", "a_2", "a_3", "d"]
    with pytest.raises(TypeError):
        ELBOW.values["a_2"] = 1.0


def test_insert_locked_and_remove_locked_are_inverse():
    locked = STANFORD.lock(3, at=0.5).lock(np.int64(1), at="pi/6")
    assert locked.locked == {1: np.pi / 6, 3: 0.5}
    q = joint_vectors(locked, (4,))
    free = locked.insert_locked(q)
    np.testing.assert_array_equal(free[:, [0, 2]], [[np.pi / 6, 0.5]] * 4)
    np.testing.assert_allclose(
        forward_kinematics(STANFORD, free), forward_kinematics(locked, q), atol=1e-15
    )
    np.testing.assert_array_equal(locked.remove_locked(free), q)


def test_with_row_changes_a_single_entry():
    bent = PANDA.with_row(4, alpha="pi/3")
    assert bent.rows[3] == replace(PANDA.rows[3], alpha="pi/3")
    assert replace(bent, rows=PANDA.rows) == PANDA


def test_with_bodies_of_an_empty_list_removes_bodies():
    assert PANDA.with_bodies(()) == replace(PANDA, bodies=())


def test_with_row_rejects_a_joint():
    with pytest.raises(ArmError, match="a row has no joint; expected a, alpha, d, theta, limits"):
        PANDA.with_row(4, joint=Joint())


def test_with_row_changes_limits_effort_and_mass():
    joint, body = PANDA.rows[3].joint, PANDA.bodies[3]
    tight = PANDA.with_row(4, limits=(1, 2), effort=9, mass=4)
    assert tight.rows[3].joint == replace(joint, lower=1, upper=2, effort=9)
    assert tight.bodies[3] == replace(body, mass=4)
    original = dict(limits=(joint.lower, joint.upper), effort=joint.effort, mass=body.mass)
    assert tight.with_row(4, **original) == PANDA


def test_with_row_rejects_invalid_limits_and_missing_mass():
    with pytest.raises(ArmError, match="joint limits are 3; expected two numbers"):
        PANDA.with_row(4, limits=3)
    with pytest.raises(ArmError, match=r"a row has no mass; expected a, .*, speed, effort$"):
        STANFORD.with_row(4, mass=1)


@pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
@pytest.mark.parametrize("at", [0.0, 0.2, "pi/8"])
def test_locked_joint_keeps_its_value(arm, at):
    value = evaluate_entry(at, {})
    for position, joint in enumerate(arm.joints):
        lower, upper = (limit[position] for limit in arm.limits)
        if not lower <= value <= upper:
            continue
        q = joint_vectors(arm, (5,))
        q[:, position] = value
        locked = forward_kinematics(arm.lock(joint, at), np.delete(q, position, axis=1))
        np.testing.assert_allclose(locked, forward_kinematics(arm, q), atol=1e-14)


def test_lock_keeps_home_of_other_joints():
    locked = STANFORD.lock(3, at=0.5)
    assert locked.home == (0, 0, 0, 0, 0)
    assert PANDA.lock(4, at="pi/2").home == (0, 0, 0, 0, np.pi, 0)
    assert (locked.variables, locked.dof) == (("q_1", "q_2", "q_4", "q_5", "q_6"), 5)
    assert locked.bodies == STANFORD.bodies
    assert STANFORD.dof == 6


def test_limits_leave_out_locked_joints():
    lower, upper = PANDA.lock(3).limits
    assert lower.shape == upper.shape == (6,)
    assert (lower[2], upper[2]) == (0.0698, 3.0718)
    np.testing.assert_array_equal(PANDA.effort_limits, [87, 87, 87, 87, 12, 12, 12])
    np.testing.assert_array_equal(PANDA.speed_limits, [2.175] * 4 + [2.61] * 3)
    np.testing.assert_array_equal(STANFORD.speed_limits, np.full(6, np.inf))


def test_markdown_table_shows_symbols():
    text = PANDA._repr_markdown_()
    assert "| 3 | $a_{3}$ | $-\\pi/2$ | $d_{3}$ | $q_{3}$ |" in text
    assert "| 7 | $0$ | $0$ | $-(d_{7} + l_{pen})$ | $q_{7}$ |" in text
    assert "$a_{3} = 0.0825$" in text
    assert "$q_{3}$" not in PANDA.lock(3)._repr_markdown_()
    assert "| 3 | $0$ | $0$ | $q_{3}$ | $0$ |" in STANFORD._repr_markdown_()
    offsets = Arm("x", [revolute(theta="-pi/2"), revolute(theta="pi/2"), prismatic(d=0.2)])
    for cell in ("$q_{1} - \\pi/2$", "$q_{2} + \\pi/2$", "$q_{3} + 0.2$"):
        assert cell in offsets._repr_markdown_()
    assert repr(STANFORD) == "<Arm Stanford arm: 6 rows, RRPRRR>"


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: revolute(limits=(-1, "1 rad")), "joint upper is '1 rad'; expected a number"),
        (lambda: prismatic(effort=float("nan")), "expected both > 0"),
        (lambda: Arm("mine", [[0, 0, 0, 0]]), "mine: rows are ([0, 0, 0, 0],); expected one Row"),
        (lambda: Arm("mine", [revolute("a")], {"a": np.nan}), "mine: a is nan; expected a finite"),
        (lambda: Arm("mine", [revolute("1 / a")], {"a": 0}), "mine: 1 / a divides by zero"),
        (lambda: Arm("mine", [revolute("1e308 * 10")]), "mine: 1e308 * 10 divides by zero or is"),
        (lambda: Arm("mine", [revolute(1e200)]), "mine: 1e+200 divides by zero or is too large"),
        (lambda: Arm("mine", [revolute("q_1")], {"q_1": 1}), "mine: q_1 is the variable of a"),
        (lambda: PANDA.lock(3, at=np.inf), "at is inf; expected a finite number"),
        (lambda: PANDA.with_row(2, mass=-1), "the mass of link 2 is -1; expected 0 kg or more"),
        (lambda: PANDA.lock(3).lock(3), "joint 3 cannot be locked; its free joints are 1, 2, 4"),
    ],
)
def test_bad_input_raises_arm_error(make, words):
    with pytest.raises(ArmError) as error:
        make()
    assert words in str(error.value)
    assert isinstance(error.value, ValueError)


@pytest.mark.parametrize(
    "make",
    [
        lambda: revolute(alpha=90),
        lambda: prismatic(theta=-90.0),
        lambda: fixed(theta=np.int64(180)),
        lambda: PANDA.with_row(1, alpha=90),
    ],
)
def test_angle_over_a_turn_warns_at_its_line(make):
    with pytest.warns(
        UserWarning, match=r"an angle is -?\d+, in radians; for degrees write np.radians\(-?\d+\)$"
    ) as warnings:
        make()
    assert [warning.filename for warning in warnings] == [__file__], "see the warning's stacklevel"


@pytest.mark.parametrize("angle", [-2 * np.pi, "5*pi", 1.5])
def test_unambiguous_angle_does_not_warn(angle):
    assert revolute(alpha=angle).alpha == fixed(alpha=angle).alpha


def test_home_adds_like_array_and_compares_like_tuple():
    nudged = PANDA.home + 0.1
    np.testing.assert_array_equal(nudged, np.array(PANDA.home) + 0.1)
    np.testing.assert_array_equal(2 * PANDA.home - nudged, 2 * np.array(PANDA.home) - nudged)
    assert PANDA.home == (0, 0, 0, np.pi / 2, 0, np.pi, 0)
    assert hash(PANDA) == hash(PANDA.with_values())


def test_degrees_in_q_warn():
    with pytest.warns(UserWarning, match=r"q has an angle of 90 rad, .* np.radians"):
        forward_kinematics(ELBOW, [[0, 0, 0], [0, 90, 30]])


def test_long_slide_does_not_warn_of_degrees():
    forward_kinematics(STANFORD, [0, 0, 500, 0, 0, 0])


Q1, Q2, Q3, A2 = sp.symbols("q_1 q_2 q_3 a_2")
ROWS = [  # the elbow arm with its upper arm turned by a right angle, and a slide
    [["q_1", 0.5, 0, "pi/2"], ["q_2 - pi/2", 0, "a_2", 0], [0, "q3 + 0.1", 0, 0]],
    ((None, 0.5, 0, math.pi / 2), ("-pi/2 + q_2", 0, "a_2", 0), (0, "0.1 + d3", 0, 0)),
    sp.Matrix([[Q1, 0.5, 0, sp.pi / 2], [Q2 - sp.pi / 2, 0, A2, 0], [0, Q3 + 0.1, 0, 0]]),
    np.array([[None, 0.5, 0, np.pi / 2], ["q2-pi/2", 0, "a_2", 0], [0, "q3+0.1", 0, 0]], object),
]  # fmt: skip


@pytest.mark.parametrize("table", ROWS, ids=["lists", "tuples", "sympy", "array"])
def test_rows_become_the_arm_that_they_describe_without_the_judge(table, monkeypatch):
    monkeypatch.setattr("helpers.checks.engine.ask_judge", None)
    expected = Arm(
        "typed",
        [revolute(d=0.5, alpha="pi/2"), revolute(a="a_2", theta="-pi/2"), prismatic(d=0.1)],
        {"a_2": 0.4},
    )
    arm = Arm.from_table(table, values={"a_2": 0.4})
    assert arm.variables == ("q_1", "q_2", "q_3")
    assert arm.values == {"a_2": 0.4}
    q = [0.3, -0.7, 0.2]
    np.testing.assert_array_equal(forward_kinematics(arm, q), forward_kinematics(expected, q))


def test_rows_are_read_in_the_order_of_columns():
    arm = Arm.from_table([[0.4, "pi/2", 0.1, "q1"]], columns=("a", "alpha", "d", "theta"))
    assert arm.rows[0].entries == (0.4, "pi/2", 0.1, 0)


def test_angles_of_rows_are_not_rounded_to_right_angles():
    assert Arm.from_table([[None, 0, 0.4, -1.57]]).rows[0].alpha == -1.57


@pytest.mark.parametrize(
    ("table", "options", "message"),
    [
        ([[0, 0.3, 0, 0]], {}, "no row has a joint; expected its variable, None or a symbol"),
        (np.zeros((3, 4)), {}, "no row has a joint"),
        ([[0.4, "pi/2", 0.1, "q1"]], {}, "row 1: alpha is 'q1'; .*say columns='a alpha d theta'"),
        ([["q1", "d_1", 0, 0]], {}, r"theta is 'q1' and d is 'd_1'; .* values=\{'d_1': 0.3\}"),
        ([["2*q1", 0, 0, 0]], {}, "theta is '2.q1'; expected the joint's variable q1 alone or"),
        ([["q1", 0, None, 0]], {}, "row 1: a is None; expected a number"),
        ([["q1", 0, "30 cm", 0]], {}, "row 1: a is '30 cm'; .* in m and rad without their units"),
        ([["q1", 0, 0]], {}, "row 1 is .*; expected rows of four entries .theta d a alpha., or a"),
        (np.eye(4)[None], {}, r"row 1: theta is '\[1.0, 0.0, 0.0, 0.0\]'; expected numbers"),
        ({"theta": ["q1"]}, {}, "the entries of row 1 are 'theta'; expected rows"),
        (None, {}, "the table's rows are None; expected rows of four entries"),
        (ROWS[0], {"angles": "deg"}, "angles is 'deg'; expected 'rad', for rows are in metres"),
        (ROWS[0], {"lengths": "mm"}, "lengths is 'mm'; expected 'm'"),
        (ROWS[0], {"convention": "craig"}, "convention is 'craig'; .*standard_from_modified"),
        (ROWS[0], {"columns": "a d theta"}, "columns are 'a d theta'; expected a, alpha, d and"),
        (ROWS[0], {"columns": 5}, "columns are 5; expected a, alpha, d and theta"),
        (ROWS[0], {"values": {"d": 1}}, "row 2: a is 'a_2'; expected a number, or a formula of"),
    ],
)  # fmt: skip
def test_rows_that_leave_a_guess_are_refused(table, options, message):
    with pytest.raises(ArmError, match=message):
        Arm.from_table(table, **options)


def test_rows_that_look_like_degrees_or_count_otherwise_warn():
    with pytest.warns(UserWarning, match="degrees|numbered") as warned:
        Arm.from_table([["q1", 0, 0, 90], ["q3", 0, 0.4, 0]])
    assert [str(w.message) for w in warned] == [
        "an angle is 90, in radians; for degrees write np.radians(90)",
        "your q3 is q_2 here, since joints are numbered by their rows",
    ]
