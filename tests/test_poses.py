"""Test that poses printed with few decimals become rigid transforms."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from helpers import inverse, poses
from helpers.arm import ArmError
from helpers.kinematics import forward_kinematics
from helpers.poses import rigid_poses
from tests.test_inverse import PUMA as TILTED_PUMA

PUMA = TILTED_PUMA.with_row(6, a=0, d=0, alpha=0, theta=0)  # without its tool
Q = np.array([0.3, 0.6, 0.5, 0.2, 0.7, -0.4])
POSE = forward_kinematics(PUMA, Q)


@pytest.mark.parametrize("decimals", [3, 4, 5])
def test_pose_with_few_decimals_gives_the_nearest_rotation(decimals):
    rounded = POSE.round(decimals)
    with pytest.warns(UserWarning, match=f"a pose has only {decimals} decimals"):
        T = rigid_poses(rounded, "a pose", "a pose")
    # SciPy orthogonalizes a matrix that is nearly a rotation on its own.
    expected = Rotation.from_matrix(rounded[:3, :3]).as_matrix()
    np.testing.assert_allclose(T[:3, :3], expected, atol=10.0 ** (-2 * decimals))
    np.testing.assert_array_equal(T[:, 3], rounded[:, 3])
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-14)


def test_rounded_poses_of_a_batch_are_mended_alone():
    poses = np.stack([POSE, POSE.round(4), np.eye(4)])
    with pytest.warns(UserWarning, match="only 4 decimals"):
        T = rigid_poses(poses, "a pose", "poses", many=True)
    np.testing.assert_array_equal(T[[0, 2]], poses[[0, 2]])
    np.testing.assert_allclose(T[1], POSE, atol=1e-4)


@pytest.mark.parametrize(
    ("pose", "message"),
    [
        (POSE.round(2), "U, _, V = np.linalg.svd"),
        (POSE + 1e-4 * np.eye(4, k=1), "U, _, V = np.linalg.svd"),
        (np.eye(4) + 0.01 * np.eye(4, k=1) * [0, 1, 0, 0], "by 0.01; .*U, _, V"),
        (POSE.round(4) * 1.01, "U, _, V = np.linalg.svd"),
        (np.diag([1.0, 1, -1, 1]), r"no rigid transform, by 2; .* over \(0, 0, 0, 1\)$"),
        (np.vstack([POSE[:3], [0, 0, 0, 1.001]]).round(4), r"over \(0, 0, 0, 1\)"),
    ],
    ids=["two decimals", "sheared", "unit axes", "scaled", "mirrored", "last row"],
)
def test_pose_that_rounding_does_not_explain_is_refused(pose, message):
    with pytest.raises(ArmError, match=message):
        rigid_poses(pose, "a pose", "a pose")


def test_solutions_take_a_pose_as_printed():
    with pytest.warns(UserWarning, match="nearest rotation") as warned:
        solutions = inverse.solutions(PUMA, POSE.round(4))
    assert warned[0].filename == __file__  # the warning points at the reader's own line
    assert len(solutions.by_name) == 8
    np.testing.assert_allclose(forward_kinematics(PUMA, solutions.q), [POSE] * 8, atol=2e-4)
    with pytest.warns(UserWarning, match="nearest rotation"):
        assert inverse.solve(PUMA, POSE.round(4), start=Q).reached


@pytest.mark.parametrize("call", [inverse.solutions, inverse.solve])
def test_target_in_millimetres_gives_a_warning(call):
    pose = POSE.copy()
    pose[:3, 3] *= 1000
    with pytest.warns(UserWarning, match="write metres"):
        call(PUMA, pose)


def test_bound_of_rotation_errors_equals_that_of_the_judge():
    judge = Path(__file__).parents[1] / "judge" / "geometry" / "inverse.js"
    code = judge.read_text(encoding="utf-8")
    bounds = re.findall(r"^const LARGEST_ROTATION_ERROR = (\S+);", code, re.MULTILINE)
    assert [float(bound) for bound in bounds] == [poses._LARGEST_ROTATION_ERROR]
