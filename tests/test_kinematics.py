"""Test the numeric kinematics by laws that hold for every arm and batch shape."""

import subprocess
import sys
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from helpers.arm import Arm, revolute
from helpers.kinematics import (
    forward_kinematics,
    jacobian,
    link_frames,
    manipulability,
    quaternion,
    roll_pitch_yaw,
)
from helpers.robots import ELBOW, UR10E_HOMEWORK
from tests.laws import (
    ALL_ARMS,
    SHAPES,
    arm_id,
    complex_step_jacobian,
    joint_vectors,
    random_arms,
    slow_frames,
)

every_arm = pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
every_shape = pytest.mark.parametrize("shape", SHAPES, ids=str)


@every_arm
@every_shape
def test_output_shapes_follow_the_batch(arm, shape):
    q = joint_vectors(arm, shape)
    assert forward_kinematics(arm, q).shape == (*shape, 4, 4)
    assert link_frames(arm, q).shape == (*shape, len(arm.rows) + 1, 4, 4)
    assert jacobian(arm, q).shape == (*shape, 6, arm.dof)


@every_arm
def test_batch_equals_single_configurations(arm):
    q = joint_vectors(arm, (3, 2))
    in_tool = partial(jacobian, frame="tool")
    for function in (forward_kinematics, link_frames, jacobian, in_tool, manipulability):
        together = function(arm, q)
        for index in np.ndindex(3, 2):
            np.testing.assert_allclose(together[index], function(arm, q[index]), atol=1e-15)


@pytest.mark.parametrize("size", [8191, 8192, 8193])
def test_batch_at_chunk_boundaries_is_right(size):
    q = joint_vectors(ELBOW, (size,))
    T = forward_kinematics(ELBOW, q)
    for i in (0, size // 2, size - 2, size - 1):
        np.testing.assert_allclose(T[i], slow_frames(ELBOW, q[i])[-1], atol=1e-15)


@every_arm
def test_link_frames_match_elementary_motions(arm):
    for q in joint_vectors(arm, (4,)):
        np.testing.assert_allclose(link_frames(arm, q), slow_frames(arm, q), atol=1e-14)


@settings(max_examples=150)
@given(arm=random_arms, seed=st.integers(0, 99))
def test_link_frames_of_random_arms_match_motions(arm, seed):
    q = joint_vectors(arm, (), seed)
    np.testing.assert_allclose(link_frames(arm, q), slow_frames(arm, q), atol=1e-13)


@every_arm
def test_right_angles_keep_precision(arm):
    q = joint_vectors(arm, ()) * 0 + np.pi
    np.testing.assert_allclose(forward_kinematics(arm, q), slow_frames(arm, q)[-1], atol=1e-14)


@every_arm
def test_whole_turns_keep_the_pose(arm):
    turns = np.where([arm.rows[i - 1].joint.kind == "revolute" for i in arm.joints], 200 * np.pi, 0)
    q = joint_vectors(arm, ())
    np.testing.assert_allclose(
        forward_kinematics(arm, q + turns), forward_kinematics(arm, q), atol=1e-11
    )


@every_arm
def test_jacobian_matches_complex_step_derivative(arm):
    """The configurations include home, where axes are parallel or coincide."""
    for q in (*joint_vectors(arm, (3,), seed=3), np.array(arm.home)):
        np.testing.assert_allclose(jacobian(arm, q), complex_step_jacobian(arm, q), atol=1e-14)


@given(arm=random_arms, seed=st.integers(0, 99))
def test_jacobian_of_random_arms_matches_derivative(arm, seed):
    q = joint_vectors(arm, (), seed)
    np.testing.assert_allclose(jacobian(arm, q), complex_step_jacobian(arm, q), atol=1e-13)


def test_right_angles_leave_exact_zeros():
    """At home the UR10e's axes are parallel or perpendicular, so round-off must not occur."""
    T = link_frames(UR10E_HOMEWORK, np.zeros(6))
    np.testing.assert_array_equal(np.abs(T[:, :3, :3]), np.round(np.abs(T[:, :3, :3])))


def test_jacobian_of_wrist_about_its_tip():
    """All axes meet in the tip, so no joint moves it."""
    wrist = Arm("wrist", [revolute(alpha="-pi/2"), revolute(alpha="pi/2"), revolute()])
    q = joint_vectors(wrist, (5,))
    J = jacobian(wrist, q)
    np.testing.assert_array_equal(J[:, :3], 0)
    c, s, zero = np.cos(q[:, 0]), np.sin(q[:, 0]), np.zeros(5)
    third = [c * np.sin(q[:, 1]), s * np.sin(q[:, 1]), np.cos(q[:, 1])]
    expected = np.array([[zero, zero, zero + 1], [-s, c, zero], third]).transpose(2, 1, 0)
    np.testing.assert_allclose(J[:, 3:], expected, atol=1e-15)
    for part in ("angular", "all"):
        np.testing.assert_allclose(manipulability(wrist, q, part), np.abs(np.sin(q[:, 1])))
    np.testing.assert_array_equal(manipulability(wrist, q, "linear"), 0)


def test_import_does_not_load_sympy_or_matplotlib():
    code = (
        "import sys, helpers.kinematics, helpers.robots; print(sorted({'sympy', 'matplotlib',"
        " 'IPython'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]", "these modules were imported"


def test_roll_pitch_yaw_and_quaternion_agree_with_scipy():
    rotations = Rotation.random(200, rng=np.random.default_rng(4))
    half_turns = Rotation.from_rotvec(np.pi * np.eye(3))
    for R in (rotations, half_turns):
        angles, w_first = roll_pitch_yaw(R.as_matrix()), quaternion(R.as_matrix())
        again = Rotation.from_euler("ZYX", angles[:, ::-1])
        np.testing.assert_allclose(again.as_matrix(), R.as_matrix(), atol=1e-14)
        np.testing.assert_allclose(np.linalg.norm(w_first, axis=1), 1, atol=1e-14)
        again = Rotation.from_quat(np.roll(w_first, -1, axis=1))
        np.testing.assert_allclose(again.as_matrix(), R.as_matrix(), atol=1e-14)
        assert (w_first[:, 0] >= 0).all()


def test_roll_is_0_where_pitch_is_a_right_angle():
    R = Rotation.from_euler("ZYX", [0.3, np.pi / 2, 0.5]).as_matrix()
    np.testing.assert_allclose(roll_pitch_yaw(R), [0, np.pi / 2, -0.2], atol=1e-7)
