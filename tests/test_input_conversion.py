"""Test how checks convert what students pass: values, shapes, units, function calls, messages.

The expected values and units are written by hand.
"""

import math

import numpy as np
import pytest
import sympy as sp

from helpers.arm import Arm, ArmError, prismatic, revolute
from helpers.checks import (
    compare,
    compare_jacobian,
    compare_pose,
    compare_torques,
    functions,
)
from helpers.checks.arms import judge_data
from helpers.checks.compare import read_numbers
from helpers.checks.engine import ask_judge
from helpers.checks.plain_data import to_plain_data
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import ELBOW, PANDA, STANFORD
from tests.corpus.jacobians import in_frame
from tests.corpus.machine import Machine
from tests.mixed import MIXED, make_arm

H = math.pi / 2
Q3 = np.array([0.5, 0.7, -0.4])
x, y, t = sp.symbols("x y t")


# Numbers


class Frame:
    """Imitate a data frame of pandas."""

    def __init__(self, rows):
        self.rows = np.array(rows)

    def to_numpy(self):
        return self.rows

    def __str__(self):
        return "Frame"


class ListOnly:
    """Imitate an array of another package, whose only method is tolist."""

    def tolist(self):
        return [1.5, 2.0]

    def __str__(self):
        return "ListOnly"


@pytest.mark.parametrize(
    ("mine", "values", "units"),
    [
        ([1, 2], [1, 2], [1, 1]),
        (np.array([1, 2], dtype=np.int8), [1, 2], [1, 1]),
        (7, 7, 1),
        ([[1.5, 2], [3, 4.25]], [[1.5, 2], [3, 4.25]], [[0.1, 1], [1, 0.01]]),
        (((1.5, 2), [3, 4]), [[1.5, 2], [3, 4]], [[0.1, 1], [1, 1]]),
        (Frame([[1.5, 2]]), [[1.5, 2]], [[0.1, 1]]),
        (ListOnly(), [1.5, 2], [0.1, 1]),
        ({"a": [1.5], "b": [2]}, [[1.5], [2]], [[0.1], [1]]),
        (np.ma.array([1.5, 2.0]), [1.5, 2], [0.1, 1]),
        (["1.50", 2], [1.5, 2], [0.01, 1]),
        (["1.5", "pi"], [1.5, math.pi], [0.1, 0]),
        ([np.float64(1.5), "2"], [1.5, 2], [0.1, 1]),
        ([sp.Float(1.5), sp.Rational(1, 4)], [1.5, 0.25], [0.1, 0]),
        ([sp.Float(1.5), sp.sin(sp.pi / 6)], [1.5, 0.5], [0.1, 0]),
        (sp.Matrix([[1.5, 2]]), [[1.5, 2]], [[0.1, 1]]),
        ([sp.Matrix([1.5]), [[2]]], [[[1.5]], [[2]]], [[[0.1]], [[1]]]),
    ],
    ids=str,
)
def test_numbers_are_read_from_any_container(mine, values, units):
    typed = read_numbers(mine, "yours")
    assert np.array_equal(typed.values, values) or typed.values == pytest.approx(np.array(values))
    assert typed.values.shape == typed.units.shape == np.shape(values)
    assert typed.values.dtype == float
    assert typed.units == pytest.approx(np.array(units))


@pytest.mark.parametrize(
    ("mine", "words"),
    [
        ([1, math.nan], "yours: one of the numbers is NaN or infinite; expected heights"),
        ([[1, 2], [3]], "yours has rows of unequal length; expected rows of one length"),
        ([[1, 2], [3, [4, 5]]], "yours has rows of unequal length; expected rows of one length"),
        ([1, None], "yours is None; expected heights"),
        (np.ma.array([1.5, 2.0], mask=[False, True]), "yours is None; expected heights"),
        ([1, 2j], "yours is 2j; expected heights"),
        ([1, {2}], "yours is {2}; expected heights"),
        ([1, sp.sqrt(-1)], "yours is I; expected heights"),
        ([1, sp.log(0)], "yours is zoo; expected heights"),
        ([1, 10**400], "yours: one of the numbers is NaN or infinite; expected heights"),
        ([x + y, 1], "x, y has no value here; write numbers"),
        ("1 1e999", "too large; expected a finite value"),
    ],
    ids=str,
)
def test_invalid_numbers_are_rejected(mine, words):
    with pytest.raises(ArmError) as refused:
        read_numbers(mine, "yours", expected="heights")
    assert words in str(refused.value)


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["1.25", "3"], [0.01, 1]),
        (["120", "7"], [1, 1]),
        (["12e1", "3e1"], [10, 10]),
        (["0", "0.0"], [0, 0]),  # zeros alone show no digits
        (["0", "1"], [1, 1]),
        (["0", "-1.", "2.50"], [0.01, 0.01, 0.01]),  # programs print an exact 0 and 1 so
        (["0.00", "2.5"], [0.01, 0.1]),
        (["0", "6.1e-17", "2.5"], [0.1, 1e-18, 0.1]),  # round-off of a zero shows no decimals
        (["123.4", "0.01234", "0"], [0.1, 1e-5, 1e-5]),
        (["36.3", "1.96", "-18.7"], [0.1, 0.01, 0.1]),
        (["pi", "0.5"], [0, 0.1]),
        (["pi", "0"], [0, 0]),
        (["1.234567890123", "0.5"], [0, 0]),  # thirteen digits: never rounded
        (["1.23456789012", "0.5"], [1e-11, 0.1]),
        ([], []),
    ],
)
def test_unit_of_number_is_its_last_place(texts, expected):
    assert read_numbers(texts, "yours").units == pytest.approx(np.array(expected), rel=1e-12, abs=0)


q1, q2 = (sp.Function(name)(t) for name in ("q1", "q2"))
SYMBOLIC = Arm("elbow", ELBOW.rows, {**ELBOW.values, "x": 0.5, "y": 2.0})


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        (x + 2 * y - 1, 4.0 + 0.5 - 1),
        (x**2 / y, 0.125),
        (2**x, math.sqrt(2)),
        (sp.sin(x) + sp.cos(y), math.sin(0.5) + math.cos(2)),
        (sp.tan(x) * sp.exp(-y), math.tan(0.5) * math.exp(-2)),
        (sp.acos(x) + sp.pi, math.acos(0.5) + math.pi),
        (sp.sin(q1) + sp.atan(q2), math.sin(0.5) + math.atan(0.7)),
        (sp.Rational(1, 3), 1 / 3),
    ],
)
def test_sympy_expression_is_evaluated(expression, value):
    check_value(expression, value)


def test_sum_of_900_terms_is_evaluated():
    terms = (sp.Symbol("a_2") * sp.sin(k * q2) for k in range(1, 900))
    check_value(sp.Add(*terms), sum(0.4 * math.sin(k * 0.7) for k in range(1, 900)))


def check_value(expression, value):
    """Check a value within 1e-9, as an entry of the target of joints that reach it."""
    here = forward_kinematics(SYMBOLIC, Q3)[:3, 3]
    for off, grade in ((0, "right"), (1e-6, "wrong")):
        target = [expression - value + here[0] + off, *here[1:]]
        assert compare_pose(Q3, SYMBOLIC, target, tolerance=1e-9).grade == grade


@pytest.mark.parametrize(
    "expression", [sp.sqrt(-1) * x, sp.Max(x, y), sp.atan2(x, y), sp.Derivative(q1, t), sp.zoo * x]
)
def test_invalid_expression_is_rejected(expression):
    with pytest.raises(ArmError, match=r"^yours is .*; expected numbers"):
        read_numbers([expression], "yours")


# Joints

SLED = Arm("sled", [revolute(a=0.3), prismatic(alpha=H), revolute(a=0.1)])


def convert_joints(q, angles="rad"):
    return ask_judge("joints", q=to_plain_data(q), arm=judge_data(SLED), angles=angles)


@pytest.mark.parametrize(
    ("q", "angles", "values", "units"),
    [
        (
            [90, 0.25, 45.25],
            "deg",
            [H, 0.25, math.radians(45.25)],
            [H / 90, 0.01, 0.01 * H / 90],
        ),
        ([1.25, 0.25, 0.5], "rad", [1.25, 0.25, 0.5], [0.01, 0.01, 0.1]),
        ("1.25, 0.25, 0.5", "rad", [1.25, 0.25, 0.5], [0.01, 0.01, 0.1]),
        ("1.25\n0.25\n0.5", "rad", [1.25, 0.25, 0.5], [0.01, 0.01, 0.1]),
        ("q1=1.25, θ_2: 0.25, \\theta_{3} = 0.5", "rad", [1.25, 0.25, 0.5], [0.01, 0.01, 0.1]),
        ([[1.25], [0.25], [0.5]], "rad", [1.25, 0.25, 0.5], [0.01, 0.01, 0.1]),
    ],
)
def test_joint_vector_is_read_with_units(q, angles, values, units):
    typed = convert_joints(q, angles)
    assert typed["values"] == pytest.approx(values)
    assert typed["units"] == pytest.approx(units)


@pytest.mark.parametrize(("q", "count"), [([1, 2], 2), (np.ones((2, 3)), "2x3")])
@pytest.mark.parametrize("angles", ["rad", "deg"])
def test_wrong_number_of_joint_values_is_rejected(q, count, angles):
    with pytest.raises(ArmError) as refused:
        convert_joints(q, angles)
    assert f"q has {count} values" in str(refused.value)
    with pytest.raises(ArmError, match="sled: q is None; expected one value for each of q_1"):
        convert_joints([None])
    with pytest.raises(ArmError, match="q has 1 value; expected one value"):
        convert_joints(1, angles)


# Functions


def call_function(function, q=Q3):
    return functions.call_student_function(function, np.array(q), "yours")


def list_shapes(*given):
    return [np.shape(one) for one in given]


@pytest.mark.parametrize(
    ("function", "expected"),
    [
        (lambda q: list_shapes(q), [(3,)]),
        (lambda q, /: list_shapes(q), [(3,)]),
        (lambda q, k=1: list_shapes(q), [(3,)]),
        (lambda q, *more: list_shapes(q, *more), [(3,)]),
        (lambda *q: list_shapes(*q), [(), (), ()]),
        (lambda a, b, c: list_shapes(a, b, c), [(), (), ()]),
    ],
)
def test_function_gets_arguments_of_its_signature(function, expected):
    assert call_function(function) == expected


def test_function_gets_the_values_of_q():
    assert call_function(lambda a, b, c: (a, b, c)) == (0.5, 0.7, -0.4)
    assert call_function(lambda q: q.tolist()) == [0.5, 0.7, -0.4]
    assert call_function(max) == 0.7, "a function that has no signature"
    assert call_function(lambda v: v.tolist(), [0.5]) == [0.5]
    assert call_function(
        lambda v: math.sin(v) if v.__class__ is float else v["no"], [0.5]
    ) == math.sin(0.5)


def test_function_of_one_joint_takes_any_argument():
    x = sp.Symbol("x")
    one = Arm.from_table("q1 0 0.4 0", columns="theta d a alpha", convention="standard")
    turn = sp.Matrix([-0.4 * sp.sin(x), 0.4 * sp.cos(x), 0, 0, 0, 1])
    for asked in (x, [x], [[x]]):
        assert compare_jacobian(sp.lambdify(asked, turn), one).agrees


@pytest.mark.parametrize("function", [lambda dh, q: 0, lambda a, b: 0, lambda q, *, k: 0])
def test_function_with_wrong_signature_is_rejected(function):
    with pytest.raises(ArmError) as refused:
        call_function(function)
    message = str(refused.value)
    assert message.startswith("yours: your function failed (TypeError: ")
    assert "it was called with q of 3 values. Wrap it" in message
    assert isinstance(refused.value.__cause__, TypeError)


def test_function_error_is_passed_on_and_q_is_copied():
    def refuse_arguments(q):
        q[:] = 9
        raise ArmError("in its own words")

    q = Q3.copy()
    with pytest.raises(ArmError, match=r"^in its own words$"):
        functions.call_student_function(refuse_arguments, q, "yours")
    assert q.tolist() == Q3.tolist()


# Inputs that Python accepts and the page refuses


def test_jacobian_with_extra_dimensions_is_read():
    J = jacobian(ELBOW, Q3).round(4)
    for mine in (J[None], J[:, None], J[:, :, None], J.ravel()[None], J.ravel()[:, None]):
        report = compare_jacobian(mine, ELBOW, Q3)
        assert report.agrees, np.shape(mine)
        assert "to the digits you gave" in report.headline
    assert compare_jacobian(J.ravel()[None][None], ELBOW, Q3).agrees
    one = Arm("one", [revolute(a=0.3)])
    assert compare_jacobian(jacobian(one, [0.5]).round(4)[None], one, [0.5]).agrees
    for mine, count in ((J.ravel(), "18"), (np.array([J, J]), "2x6x3")):
        with pytest.raises(ArmError) as refused:
            compare_jacobian(mine, ELBOW, Q3)
        assert f"has {count} values; expected a matrix" in str(refused.value)


def test_mapping_is_ordered_by_its_names():
    J = MIXED.jacobian(Q3).round(6)
    rows = dict(zip(["vx", "vy", "vz", "wx", "wy", "wz"], J, strict=True))
    angular_first = {name: rows[name] for name in ["wx", "wy", "wz", "vx", "vy", "vz"]}
    assert compare_jacobian(angular_first, make_arm(MIXED), Q3).agrees
    T = forward_kinematics(ELBOW, Q3)
    q = {sp.Symbol(f"q_{k}"): Q3[k - 1] for k in (3, 1, 2)}
    assert compare_pose(q, ELBOW, T).agrees
    assert compare_pose(list(zip(["q3", "q1", "q2"], q.values(), strict=True)), ELBOW, T).agrees


def test_wrong_shape_is_reported_with_both_shapes():
    (finding,) = compare_jacobian(np.ones((5, 4)), ELBOW, Q3).findings
    assert (finding.what, finding.mine, finding.expected) == ("shape", (5, 4), (6, 3))
    (finding,) = compare_torques(np.ones((2, 6)), PANDA, np.ones((2, 7))).findings
    assert (finding.what, finding.mine, finding.expected) == ("shape", (2, 6), (2, 7))


def test_numeric_jacobian_needs_q_but_function_does_not():
    with pytest.raises(ArmError, match="give its q too"):
        compare_jacobian(jacobian(ELBOW, Q3), ELBOW)
    report = compare_jacobian(lambda q: jacobian(ELBOW, q), ELBOW)
    assert report.agrees
    assert " at q = " not in report.headline
    assert not report.notes
    at = compare_jacobian(lambda q: jacobian(ELBOW, q), ELBOW, Q3)
    assert at.agrees
    assert " at q = (" in at.headline


@pytest.mark.parametrize("arm", [PANDA, STANFORD, ELBOW, PANDA.lock(3)], ids=str)
def test_generic_configuration_is_within_limits_without_symmetry(arm):
    q = compare._generic_configuration(arm)
    low, high = (np.clip(limit, -1.5, 1.5) for limit in arm.limits)
    low, high = np.where(np.isfinite(arm.limits[0]), low, -1.5), high
    share = (q - low) / (high - low)
    assert ((share >= 0.55) & (share <= 0.95)).all(), share
    assert np.diff(np.sort(share)).min() > 1e-3
    assert (compare._generic_configuration(arm) == q).all()


@pytest.mark.parametrize("frame", [8, -1, 1.5, "x", None])
def test_unknown_frame_is_rejected(frame):
    with pytest.raises(ArmError, match=r"Panda: frame is .*; expected a whole number"):
        compare_jacobian(np.ones((6, 7)), PANDA, np.ones(7), frame=frame)
    assert compare_jacobian(np.ones((6, 7)), PANDA, np.ones(7), frame=7)


# A Jacobian whose slips lie in columns: row 2 is locked, row 3 slides


WHOLE = Machine([("R", *row[1:]) if row[0] == "F" else row for row in MIXED.rows], "whole")
LOCKED_TOO = WHOLE.jacobian([Q3[0], 0.0, *Q3[1:]])


@pytest.mark.parametrize(
    ("k", "column", "what", "words"),
    [
        (2, lambda J: J[:, 1], "column", "this is the column of joint 3."),
        (2, lambda J: LOCKED_TOO[:, 1], "column", "this is the column of joint 2."),
        (2, lambda J: J[:, 2] + [0.1, 0, 0, 0, 0.2, 0], "column", "check vx and wy."),
        (2, lambda J: J[:, 2] * [-1, 1, 1, 1, 1, 1], "column", "the sign of vx is wrong."),
    ],
)
@pytest.mark.parametrize("frame", [0, 3])
def test_second_wrong_column_is_described(k, column, what, words, frame):
    J = in_frame(MIXED, Q3, MIXED.jacobian(Q3), frame)
    mine = column(J)
    if words.endswith("joint 2."):
        mine = in_frame(MIXED, Q3, np.c_[mine], frame)[:, 0]
    J = np.c_[J[:, :k], mine, J[:, k + 1 :]]
    J[:, 0] += np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    report = compare_jacobian(J.round(5), make_arm(MIXED), Q3, frame=frame)
    first, second = report.findings
    assert first.where == "column 1"
    assert (second.what, second.where) == (what, "column 3")
    assert second.words == f"Column 3 (joint 4): {words}"
    assert report.headline.endswith("is not right in column 1 and column 3.")


def test_copied_column_is_named():
    J = MIXED.jacobian(Q3)
    J[:, 2] = J[:, 1]
    report = compare_jacobian(J.round(5), make_arm(MIXED), Q3)
    assert report.causes == ("J.column of:3:4",)
