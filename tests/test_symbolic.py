"""Test the symbolic functions against the numeric functions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers import kinematics, symbolic
from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.robots import ELBOW
from tests.laws import ALL_ARMS, arm_id, joint_vectors, random_arms, slow_frames

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)


def evaluate(arm, expression, q):
    values = dict(zip(symbolic.joint_symbols(arm), map(float, q), strict=True))
    return np.array(symbolic.with_numbers(arm, expression).xreplace(values).evalf(), dtype=float)


@every_arm
def test_both_jacobians_are_identical_expressions(arm):
    """Not sampled: the polynomials' form is unique, so equal functions are identical
    expressions."""
    assert symbolic.jacobian(arm) == symbolic.jacobian_by_differentiation(arm)


@settings(max_examples=25)
@given(arm=random_arms.filter(lambda arm: arm.dof), seed=st.integers(0, 99))
def test_random_arms_match_numeric_view(arm, seed):
    q = joint_vectors(arm, (), seed)
    T = evaluate(arm, symbolic.forward_kinematics(arm), q)
    np.testing.assert_allclose(T, slow_frames(arm, q)[-1], atol=1e-9)
    J = symbolic.jacobian(arm)
    np.testing.assert_allclose(evaluate(arm, J, q), kinematics.jacobian(arm, q), atol=1e-9)


@settings(max_examples=15)
@given(arm=random_arms, seed=st.integers(0, 99))
def test_link_transforms_multiply_to_tip_pose(arm, seed):
    q = joint_vectors(arm, (), seed)
    links = [evaluate(arm, A, q) for A in symbolic.link_transforms(arm)]
    product = np.linalg.multi_dot([np.eye(4), *links, np.eye(4)])
    np.testing.assert_allclose(product, slow_frames(arm, q)[-1], atol=1e-9)


_PARALLEL_ROWS = st.builds(
    lambda make, a, alpha, theta: make(a, alpha, 0.2, theta),
    st.sampled_from([revolute, revolute, prismatic, fixed]),
    st.sampled_from([0, 0.3]),
    st.sampled_from([0, "pi"]),
    st.sampled_from([0, "pi/2", "-pi/2", 0.4]),
)


@settings(max_examples=30)
@given(rows=st.lists(_PARALLEL_ROWS, min_size=2, max_size=5))
def test_parallel_axes_match_numeric_view(rows):
    arm = Arm("run", [*rows, revolute(0.1, "pi/2"), revolute(0.1)])
    q = joint_vectors(arm, ())
    T = evaluate(arm, symbolic.forward_kinematics(arm), q)
    np.testing.assert_allclose(T, slow_frames(arm, q)[-1], atol=1e-12)
    assert symbolic.jacobian(arm) == symbolic.jacobian_by_differentiation(arm)


def test_symbol_of_value_zero_is_left_out():
    d = sp.Symbol("d")
    assert d not in symbolic.forward_kinematics(ELBOW).free_symbols
    assert d in symbolic.forward_kinematics(ELBOW.with_values(d=0.1)).free_symbols


def test_polynomial_length_is_accepted():
    arm = Arm("powers", [revolute(a="u*u - 3*u*v*v*v/2 + 0.25")], {"u": 1.7, "v": 0.6})
    u, v = sp.symbols("u v")
    assert symbolic.jacobian(arm).subs({"q_1": 0})[1] == u**2 - 3 * u * v**3 / 2 + sp.Rational(1, 4)


def test_non_polynomial_length_is_rejected():
    with pytest.raises(ArmError, match="no polynomial"):
        symbolic.forward_kinematics(Arm("x", [revolute(a="1 / b")], {"b": 2}))
    with pytest.raises(ArmError, match="no polynomial"):
        symbolic.forward_kinematics(Arm("x", [revolute(a="pi * b")], {"b": 2}))
