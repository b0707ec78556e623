"""Compare torques with Pinocchio's Panda, given the same masses and no hand."""

import numpy as np
import pytest

from helpers.dynamics import inverse_dynamics
from helpers.kinematics import link_frames
from helpers.robots import PANDA
from helpers.statics import gravity_torque, static_torque
from tests.peers.test_pinocchio import SIGNS, panda, pinocchio  # noqa: F401
from tests.test_robots import GAZ_CENTRES, GAZ_MASSES


@pytest.fixture(scope="module")
def panda_with_masses(panda):  # noqa: F811
    model = panda.copy()
    for joint, (mass, centre) in enumerate(zip(GAZ_MASSES, GAZ_CENTRES, strict=True), 1):
        model.inertias[joint] = pinocchio.Inertia(mass, np.array(centre), np.zeros((3, 3)))
    return model


def test_gravity_torque_matches_pinocchio(panda_with_masses):
    data = panda_with_masses.createData()
    for q in np.random.default_rng(3).uniform(*PANDA.limits, size=(200, 7)):
        theirs = pinocchio.computeGeneralizedGravity(panda_with_masses, data, SIGNS * q) * SIGNS
        np.testing.assert_allclose(gravity_torque(PANDA, q), theirs, atol=1e-9)


def test_static_torque_matches_rnea(panda_with_masses):
    """Pinocchio's RNEA takes the force in the frame of joint 7. The test carries it there."""
    data, force = panda_with_masses.createData(), np.array([-5.0, 1.0, -2.0])
    frame = panda_with_masses.getFrameId("panda_link8")
    for q in np.random.default_rng(4).uniform(*PANDA.limits, size=(50, 7)):
        pinocchio.framesForwardKinematics(panda_with_masses, data, SIGNS * q)
        pen = data.oMf[frame].act(np.array([0, 0, 0.1]))
        at_origin = pinocchio.Force(force, np.cross(pen, force))
        forces = pinocchio.StdVec_Force()
        forces.extend([pinocchio.Force.Zero() for _ in range(panda_with_masses.njoints)])
        forces[7] = data.oMi[7].actInv(at_origin)
        theirs = (
            pinocchio.rnea(panda_with_masses, data, SIGNS * q, np.zeros(7), np.zeros(7), forces)
            * SIGNS
        )
        np.testing.assert_allclose(static_torque(PANDA, q, [*force, 0, 0, 0]), theirs, atol=1e-9)


LINK_7 = np.array(
    [[0.012516, -0.000428, -0.001196], [-0.000428, 0.010027, -0.000741],
     [-0.001196, -0.000741, 0.004815]]
)  # fmt: skip  # by the paper, since joint 7 of the robot description includes the hand


def test_inverse_dynamics_matches_pinocchio(panda_with_masses, panda):  # noqa: F811
    """Inertia tensors come from the paper, and are zero in the second comparison.

    Pinocchio keeps them in the paper's frames, ours are in the frames of the DH table.
    """
    papers = np.array([*(panda.inertias[k].inertia for k in range(1, 7)), LINK_7])
    model = panda_with_masses.copy()
    for joint, tensor in enumerate(papers, 1):
        model.inertias[joint].inertia = tensor
    data, rest = model.createData(), np.array(PANDA.home)
    pinocchio.forwardKinematics(model, data, SIGNS * rest)
    theirs = np.array([data.oMi[joint].rotation for joint in range(1, 8)])
    R = np.swapaxes(link_frames(PANDA, rest)[1:, :3, :3], 1, 2) @ theirs
    inertias, rng = R @ papers @ np.swapaxes(R, 1, 2), np.random.default_rng(5)
    for q in rng.uniform(*PANDA.limits, size=(50, 7)):
        v, a = rng.normal(size=(2, 7))
        theirs = pinocchio.rnea(model, data, SIGNS * q, SIGNS * v, SIGNS * a) * SIGNS
        ours = inverse_dynamics(PANDA, q, v, a, inertias=inertias)
        np.testing.assert_allclose(ours, theirs, atol=1e-9)
        theirs = pinocchio.rnea(
            panda_with_masses, panda_with_masses.createData(), *(SIGNS * x for x in (q, v, a))
        )
        np.testing.assert_allclose(inverse_dynamics(PANDA, q, v, a), theirs * SIGNS, atol=1e-9)
