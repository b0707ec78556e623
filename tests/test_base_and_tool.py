"""Test poses of bases and tools: the arm's tip against products of matrices from SciPy."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from helpers.arm import Arm, prismatic, revolute
from helpers.inputs import ArmError
from helpers.inverse import solutions
from helpers.kinematics import forward_kinematics
from helpers.robots import PANDA, STANFORD, THREE_LINK
from helpers.statics import gravity_torque

HALF = np.pi / 2
SLIDE = Arm("slide", [prismatic(a=0.3, alpha=0.4, theta=0.2), revolute(a=0.2)])
# Poses with the same z axis, the opposite z axis, a right angle, and random angles.
POSES = [
    (0, 0, 0, 0, 0, 0),
    (0.1, -0.2, 0.3, 0, 0, 0.7),
    (0, 0, 0.4, np.pi, 0, 0),
    (-0.3, 0.2, 0.1, np.pi, 0, 0.5),
    (0, 0, 0.2, 0, HALF, 0),
    (0.1, 0.2, 0.3, -HALF, 0, HALF),
    (0.3, -0.1, 0.2, 0.4, -0.8, 2.5),
    (-0.2, 0.5, -0.4, -2.0, 1.1, -2.9),
]


def transform(pose):
    T = np.eye(4)
    T[:3, :3] = Rotation.from_euler("ZYX", pose[:2:-1]).as_matrix()
    T[:3, 3] = pose[:3]
    return T


@pytest.mark.parametrize("arm", [PANDA, STANFORD, SLIDE], ids=lambda arm: arm.name)
@pytest.mark.parametrize("pose", POSES, ids=str)
def test_base_and_tool_multiply_the_tip_pose(arm, pose):
    q = np.random.default_rng(1).uniform(-1, 1, (5, arm.dof))
    T, tip = transform(pose), forward_kinematics(arm, q)
    for given in (pose, T):
        on_base = forward_kinematics(arm.with_base(given), q)
        np.testing.assert_allclose(on_base, T @ tip, atol=1e-12)
        with_tool = forward_kinematics(arm.with_tool(given), q)
        np.testing.assert_allclose(with_tool, tip @ T, atol=1e-12)


def test_upside_down_base_reverses_gravity():
    q = [0.2, 0.4, 0.1, 1.2, 0.3, 2.0, 0.5]
    hanging = PANDA.with_base((0, 0, 2, "pi", 0, 0))
    np.testing.assert_allclose(gravity_torque(hanging, q), -gravity_torque(PANDA, q), atol=1e-9)


def test_right_angles_of_a_base_stay_exact():
    rows = THREE_LINK.with_base(transform((0, 0, 0.5, HALF, 0, 0))).rows
    assert rows[0].entries == (0, "pi/2", 0.5, 0)


def test_solutions_reach_targets_with_base_and_tool():
    arm = STANFORD.with_base(POSES[6]).with_tool(POSES[7])
    q = np.array([0.3, 0.6, 0.5, 0.2, 0.7, -0.4])
    T = forward_kinematics(arm, q)
    ways = np.array(list(solutions(arm, T).by_name.values()))
    np.testing.assert_allclose(forward_kinematics(arm, ways), [T] * len(ways), atol=1e-9)
    assert np.abs(ways - q).max(axis=1).min() < 1e-9


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        ((0, 0, 1), "expected a 4x4 pose, or"),
        (np.zeros((4, 4)), "no rigid transform"),
        (np.diag([1.0, 1, -1, 1]), "no rigid transform"),
        (transform(POSES[7]).round(2), "three decimals or more"),
        ((0, 0, "l_tool", 0, 0, 0), "l_tool"),
    ],
    ids=["three numbers", "zeros", "mirrored", "two digits", "a symbol"],
)
def test_matrix_that_is_no_rigid_transform_is_refused(pose, message):
    for mount in (PANDA.with_base, PANDA.with_tool):
        with pytest.raises(ArmError, match=message):
            mount(pose)
