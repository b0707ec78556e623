"""Test inverse dynamics against Lagrange's equation by differences, and against rest."""

import numpy as np
import pytest

from helpers.arm import ArmError
from helpers.dynamics import inverse_dynamics, mass_matrix
from helpers.kinematics import link_frames
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E
from helpers.statics import gravity_torque, potential_energy
from tests.laws import SHAPES, central_differences, joint_vectors
from tests.test_statics import add_bodies

ARMS = [PANDA, PANDA.lock(3, at=1.2), UR10E, add_bodies(STANFORD), add_bodies(ELBOW)]
every_arm = pytest.mark.parametrize("arm", ARMS, ids=lambda arm: f"{arm.name}, {arm.dof} joints")


def tensors(arm, seed=5):
    """Return inertia tensors of random point clouds, so that a rigid body can have them."""
    points = np.random.default_rng(seed).normal(scale=0.1, size=(len(arm.rows), 9, 3))
    square = np.einsum("nki,nkj->nij", points, points)
    return np.trace(square, axis1=1, axis2=2)[:, None, None] * np.eye(3) - square


@every_arm
@pytest.mark.parametrize("shape", SHAPES)
def test_torque_at_rest_equals_gravity_torque(arm, shape):
    q = joint_vectors(arm, shape)
    for gravity in ([0, 0, -9.81], [3, -2, 5]):
        tau = inverse_dynamics(arm, q, 0 * q, 0 * q, inertias=tensors(arm), gravity=gravity)
        assert tau.shape == q.shape
        np.testing.assert_allclose(tau, gravity_torque(arm, q, gravity), atol=1e-12)


def kinetic_energy(arm, inertias, q, q_dot, h=1e-6):
    """Return the kinetic energy (J) from finite differences of the link frames."""
    ahead, behind = (link_frames(arm, q + step * q_dot)[1:] for step in (h, -h))
    energy = 0.0
    for body, tensor, after, before, T in zip(
        arm.bodies, inertias, ahead, behind, link_frames(arm, q)[1:], strict=True
    ):
        rate, R = (after - before) / (2 * h), T[:3, :3]
        v = rate[:3, :3] @ [arm.number(c) for c in body.com] + rate[:3, 3]
        spin = R.T @ rate[:3, :3]
        omega = np.array([spin[2, 1], spin[0, 2], spin[1, 0]])
        energy += (arm.number(body.mass) * v @ v + omega @ tensor @ omega) / 2
    return energy


@every_arm
def test_torque_matches_lagranges_equation(arm):
    """The right side is d/dt dK/dq_dot - dK/dq + dP/dq, with K from link frames alone."""
    rng, inertias, h = np.random.default_rng(6), tensors(arm), 1e-3
    q, q_dot, q_ddot = rng.uniform(-1, 1, (3, arm.dof))

    def momentum(q, q_dot):
        return central_differences(
            lambda rates: kinetic_energy(arm, inertias, q, rates), q_dot, h=0.5
        )

    later, earlier = (
        momentum(q + s * q_dot + s * s * q_ddot / 2, q_dot + s * q_ddot) for s in (h, -h)
    )
    expected = (later - earlier) / (2 * h)
    expected -= central_differences(lambda x: kinetic_energy(arm, inertias, x, q_dot), q, h)
    expected += central_differences(lambda x: potential_energy(arm, x), q, h)
    tau = inverse_dynamics(arm, q, q_dot, q_ddot, inertias=inertias)
    np.testing.assert_allclose(tau, expected, atol=3e-5 * max(1, np.abs(expected).max()))


def test_batches_of_q_and_rates_broadcast():
    q, rates = joint_vectors(UR10E, (3, 1)), joint_vectors(UR10E, (2,), 9)
    tau = inverse_dynamics(UR10E, q, rates, rates)
    assert tau.shape == (3, 2, 6)
    one = inverse_dynamics(UR10E, q[2, 0], rates[1], rates[1])
    np.testing.assert_allclose(tau[2, 1], one, atol=1e-12)


def test_asymmetric_inertia_is_rejected():
    wrong = tensors(UR10E)
    wrong[2] += np.triu(0.1 * wrong[2], 1)
    rest = np.zeros(6)
    with pytest.raises(ArmError, match="inertias: a tensor is not symmetric; expected xy = yx"):
        inverse_dynamics(UR10E, rest, rest, rest, inertias=wrong)


def test_mass_matrix_gives_kinetic_energy():
    rng, inertias = np.random.default_rng(9), tensors(PANDA)
    q, q_dot = rng.uniform(-1, 1, (2, 7))
    M = mass_matrix(PANDA, q, inertias=inertias)
    energy = kinetic_energy(PANDA, inertias, q, q_dot)
    np.testing.assert_allclose(q_dot @ M @ q_dot / 2, energy, rtol=1e-6)
    np.testing.assert_allclose(M, M.T, atol=1e-12)
    assert mass_matrix(PANDA, np.zeros((2, 3, 7))).shape == (2, 3, 7, 7)
