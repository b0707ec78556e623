"""Gravity and contact torques against Pinocchio: the same masses put into its own Panda, hand
removed."""

import numpy as np
import pytest

from helpers.dynamics import inverse_dynamics
from helpers.kinematics import link_frames
from helpers.robots import PANDA
from helpers.statics import gravity_torque, static_torque
from tests.peers.test_pinocchio import SIGNS, panda, pinocchio  # noqa: F401
from tests.test_robots import GAZ_CENTRES, GAZ_MASSES


@pytest.fixture(scope="module")
def weighed(panda):  # noqa: F811
    model = panda.copy()
    for joint, (mass, centre) in enumerate(zip(GAZ_MASSES, GAZ_CENTRES, strict=True), 1):
        model.inertias[joint] = pinocchio.Inertia(mass, np.array(centre), np.zeros((3, 3)))
    return model


def test_gravity_torque_matches_pinocchio(weighed):
    data = weighed.createData()
    for q in np.random.default_rng(3).uniform(*PANDA.limits, size=(200, 7)):
        theirs = pinocchio.computeGeneralizedGravity(weighed, data, SIGNS * q) * SIGNS
        np.testing.assert_allclose(gravity_torque(PANDA, q), theirs, atol=1e-9)


def test_static_torque_matches_rnea(weighed):
    """Pinocchio's RNEA at rest takes the force on the last joint, in that joint's frame: it is
    carried there from the pen."""
    data, force = weighed.createData(), np.array([-5.0, 1.0, -2.0])
    frame = weighed.getFrameId("panda_link8")
    for q in np.random.default_rng(4).uniform(*PANDA.limits, size=(50, 7)):
        pinocchio.framesForwardKinematics(weighed, data, SIGNS * q)
        pen = data.oMf[frame].act(np.array([0, 0, 0.1]))
        at_origin = pinocchio.Force(force, np.cross(pen, force))
        forces = pinocchio.StdVec_Force()
        forces.extend([pinocchio.Force.Zero() for _ in range(weighed.njoints)])
        forces[7] = data.oMi[7].actInv(at_origin)
        theirs = pinocchio.rnea(weighed, data, SIGNS * q, np.zeros(7), np.zeros(7), forces) * SIGNS
        np.testing.assert_allclose(static_torque(PANDA, q, [*force, 0, 0, 0]), theirs, atol=1e-9)


LINK_7 = np.array(
    [[0.012516, -0.000428, -0.001196], [-0.000428, 0.010027, -0.000741],
     [-0.001196, -0.000741, 0.004815]]
)  # fmt: skip  # the paper's; the description's joint 7 carries the hand as well


def test_inverse_dynamics_matches_pinocchio(weighed, panda):  # noqa: F811
    """With the paper's inertia tensors, which Pinocchio reads from the maker's description and
    keeps in the paper's frames; ours are in the table's. And of masses that are points."""
    papers = np.array([*(panda.inertias[k].inertia for k in range(1, 7)), LINK_7])
    model = weighed.copy()
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
        theirs = pinocchio.rnea(weighed, weighed.createData(), *(SIGNS * x for x in (q, v, a)))
        np.testing.assert_allclose(inverse_dynamics(PANDA, q, v, a), theirs * SIGNS, atol=1e-9)
