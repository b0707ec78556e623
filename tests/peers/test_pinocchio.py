"""Compare the Panda with Pinocchio's model of the maker's robot description (example-robot-data).

The maker counts three joints with the other sign: q_maker = (q1, -q2, q3, -q4, q5, q6, -q7).
Pinocchio's frame `panda_link8` is the bare flange. Its z axis points out of the flange, while the
homework's z_7 points back into the arm, so the frames differ by half a turn about x.
"""

import os
import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest

from helpers.kinematics import forward_kinematics
from helpers.robots import PANDA

if os.environ.get("CI") and sys.platform == "linux":
    import pinocchio
else:
    pinocchio = pytest.importorskip("pinocchio", reason="Pinocchio is not installed here")

SIGNS = np.array([1, -1, 1, -1, 1, 1, -1])
HALF_TURN = np.diag([1.0, -1.0, -1.0, 1.0])
PEN = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.1], [0, 0, 0, 1.0]])


@pytest.fixture(scope="module")
def panda():
    site = Path(sysconfig.get_paths()["purelib"])
    urdf = site / "cmeel.prefix/share/example-robot-data/robots/panda_description/urdf/panda.urdf"
    model = pinocchio.buildModelFromUrdf(str(urdf))
    fingers = [model.getJointId(f"panda_finger_joint{k}") for k in (1, 2)]
    return pinocchio.buildReducedModel(model, fingers, pinocchio.neutral(model))


@pytest.fixture(scope="module")
def configurations():
    return np.random.default_rng(8).uniform(*PANDA.limits, size=(1000, 7))


def flange_pose(model, data, q_maker):
    """Return the 4x4 pose of the flange by Pinocchio."""
    pinocchio.forwardKinematics(model, data, q_maker)
    return pinocchio.updateFramePlacement(model, data, model.getFrameId("panda_link8")).homogeneous


def test_forward_kinematics_matches_pinocchio(panda, configurations):
    data = panda.createData()
    theirs = (
        np.array([flange_pose(panda, data, q) for q in SIGNS * configurations]) @ PEN @ HALF_TURN
    )
    np.testing.assert_allclose(forward_kinematics(PANDA, configurations), theirs, atol=1e-12)


def test_limits_match_robot_description(panda):
    lower, upper = PANDA.limits
    np.testing.assert_allclose(
        np.sort([SIGNS * lower, SIGNS * upper], axis=0)[0], panda.lowerPositionLimit
    )
    np.testing.assert_allclose(
        np.sort([SIGNS * lower, SIGNS * upper], axis=0)[1], panda.upperPositionLimit
    )
    np.testing.assert_allclose(PANDA.effort_limits, panda.effortLimit)
    np.testing.assert_allclose(PANDA.speed_limits, panda.velocityLimit)
