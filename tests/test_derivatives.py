"""Every derivative of the helpers against one that nobody wrote out: complex steps, and finite
differences.

The complex step differentiates the tests' own product of elementary motions, to the last digit.
Finite differences take the helpers' forward kinematics as it is.
"""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from helpers.kinematics import forward_kinematics, jacobian
from tests.laws import (
    ALL_ARMS,
    SHAPES,
    by_complex_steps,
    ids,
    joint_vectors,
    random_arms,
    twists,
)

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=ids)


def by_differences(arm, q, h=1e-6):
    ahead, behind = (forward_kinematics(arm, q + step * np.eye(arm.dof)) for step in (h, -h))
    return twists((ahead - behind) / (2 * h), forward_kinematics(arm, q))


@every_arm
@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_the_jacobian_is_the_derivative(arm, shape):
    q = joint_vectors(arm, shape, seed=3)
    J = jacobian(arm, q)
    for index in np.ndindex(shape):
        np.testing.assert_allclose(J[index], by_complex_steps(arm, q[index]), atol=1e-14)
        np.testing.assert_allclose(J[index], by_differences(arm, q[index]), atol=1e-8)


@every_arm
def test_at_home_too_where_axes_line_up(arm):
    home = np.array(arm.home)
    np.testing.assert_allclose(jacobian(arm, home), by_complex_steps(arm, home), atol=1e-14)


@given(arm=random_arms, seed=st.integers(0, 99))
def test_the_jacobian_of_random_arms(arm, seed):
    q = joint_vectors(arm, (), seed)
    np.testing.assert_allclose(jacobian(arm, q), by_complex_steps(arm, q), atol=1e-13)
