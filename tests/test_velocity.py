"""Test Jacobians in other frames, manipulability, lost directions and determinants."""

import numpy as np
import pytest
import sympy as sp

from helpers import symbolic
from helpers.arm import Arm, ArmError, revolute
from helpers.kinematics import (
    jacobian,
    link_frames,
    lost_directions,
    manipulability,
)
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from tests.laws import ALL_ARMS, arm_id, joint_vectors

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
SOLVED = [
    ELBOW,
    ELBOW.with_values(d=0.1),
    STANFORD,
    UR10E_HOMEWORK,
    UR10E,
    PANDA.lock(3),
    PANDA_HOMEWORK.lock(3),
    Arm(
        "Shares", [revolute(a="3*a", alpha="pi/2"), revolute(a="a"), revolute(a="2*a")], {"a": 0.3}
    ),
]


@every_arm
def test_jacobian_of_another_frame_has_rotated_rows(arm):
    q = joint_vectors(arm, (3,))
    for k in (0, len(arm.rows)):
        R, J = link_frames(arm, q)[:, k, :3, :3], jacobian(arm, q, frame=k)
        np.testing.assert_allclose(R @ J[:, :3], jacobian(arm, q)[:, :3], atol=1e-14)
        np.testing.assert_allclose(R @ J[:, 3:], jacobian(arm, q)[:, 3:], atol=1e-14)
    np.testing.assert_allclose(jacobian(arm, q, "base"), jacobian(arm, q), atol=1e-15)


@every_arm
def test_manipulability_is_root_of_determinant(arm):
    q = joint_vectors(arm, (4,))
    J = jacobian(arm, q)
    wide = arm.dof >= 6
    square = J @ np.swapaxes(J, -1, -2) if wide else np.swapaxes(J, -1, -2) @ J
    np.testing.assert_allclose(
        manipulability(arm, q), np.sqrt(np.linalg.det(square)), rtol=1e-6, atol=1e-9
    )
    linear = J[:, :3]
    np.testing.assert_allclose(
        manipulability(arm, q, "linear"),
        np.sqrt(np.abs(np.linalg.det(linear @ np.swapaxes(linear, -1, -2)))),
        rtol=1e-6,
        atol=1e-9,
    )


@pytest.mark.parametrize("arm", SOLVED, ids=arm_id)
def test_symbolic_determinant_matches_numpy(arm):
    formula = symbolic.with_numbers(arm, symbolic.determinant(arm))
    value = sp.lambdify([symbolic.joint_symbols(arm)], formula)
    for q in joint_vectors(arm, (5,), 9):
        assert value(q) == pytest.approx(np.linalg.det(jacobian(arm, q)[: arm.dof]), abs=1e-13)


def test_lost_directions_of_ur10e_at_home():
    """At home the UR10e cannot move along y or z, nor turn about x."""
    J = jacobian(UR10E_HOMEWORK, np.zeros(6))
    lost = lost_directions(UR10E_HOMEWORK, np.zeros(6))
    np.testing.assert_array_equal(lost, lost_directions(J))
    linear = lost_directions(UR10E_HOMEWORK, np.zeros(6), "linear")
    np.testing.assert_allclose(np.abs(linear.sum(axis=0)) > 0.5, [False, True, True])
    np.testing.assert_allclose(lost @ lost.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(lost @ J, 0, atol=1e-12)
    np.testing.assert_allclose(lost[:, [0, 4, 5]], 0, atol=1e-12)


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e6])
def test_cutoff_is_relative_to_the_largest_singular_value(scale):
    lost = lost_directions(scale * np.diag([1.0, 0.3, 0.05]), cutoff=0.1)
    np.testing.assert_allclose(np.abs(lost), [[0, 0, 1]], atol=1e-12)


@pytest.mark.parametrize("frame", [7, -1, "wrist", True, None])
def test_unknown_frame_is_rejected(frame):
    with pytest.raises(
        ArmError, match=f'UR10e: frame is {frame!r}; expected "base", "tool", or 0 to 6'
    ):
        jacobian(UR10E, np.zeros(6), frame)
