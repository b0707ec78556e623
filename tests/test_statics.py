"""Test gravity and contact torques by the laws of statics."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.arm import Arm, Body
from helpers.kinematics import link_frames
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E
from helpers.statics import (
    centres_in,
    gravity_torque,
    potential_energy,
    static_torque,
    with_payload,
)
from tests.laws import SHAPES, central_differences, joint_vectors, random_arms, slow_energy


def add_bodies(arm: Arm, seed: int = 1) -> Arm:
    rng = np.random.default_rng(seed)
    bodies = [
        Body(float(m), tuple(map(float, c)))
        for m, c in zip(
            rng.uniform(0.2, 3, len(arm.rows)),
            rng.uniform(-0.3, 0.3, (len(arm.rows), 3)),
            strict=True,
        )
    ]
    return replace(arm, bodies=bodies)


ARMS = [PANDA, PANDA.lock(3), UR10E, add_bodies(STANFORD), add_bodies(ELBOW)]
every_arm = pytest.mark.parametrize("arm", ARMS, ids=lambda arm: f"{arm.name}, {arm.dof} joints")


@every_arm
@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_output_shapes_follow_the_batch(arm, shape):
    q = joint_vectors(arm, shape)
    assert gravity_torque(arm, q).shape == (*shape, arm.dof)
    assert potential_energy(arm, q).shape == shape
    assert static_torque(arm, q, np.zeros(6)).shape == (*shape, arm.dof)
    assert static_torque(arm, q, np.zeros((*shape, 6))).shape == (*shape, arm.dof)


@every_arm
@pytest.mark.parametrize("gravity", [(0, 0, -9.81), (1.0, -2.0, 3.0)])
def test_gravity_torque_is_gradient_of_energy(arm, gravity):
    q = joint_vectors(arm, (), 2)
    assert potential_energy(arm, q, gravity) == pytest.approx(
        slow_energy(arm, q, gravity), abs=1e-12
    )
    slope = central_differences(lambda q: slow_energy(arm, q, gravity), q, h=1e-5)
    np.testing.assert_allclose(gravity_torque(arm, q, gravity), slope, atol=1e-7)


@settings(max_examples=40)
@given(arm=random_arms.filter(lambda arm: arm.dof), seed=st.integers(0, 99))
def test_gravity_torque_of_random_arms(arm, seed):
    arm, gravity = add_bodies(arm, seed), (0.3, -0.2, -9.0)
    q = joint_vectors(arm, (), seed)
    slope = central_differences(lambda q: slow_energy(arm, q, gravity), q, h=1e-5)
    np.testing.assert_allclose(gravity_torque(arm, q, gravity), slope, atol=1e-6)


@every_arm
@pytest.mark.parametrize("gravity", [(0, 0, -9.81), (1.0, -2.0, 3.0)])
def test_static_torque_obeys_virtual_work(arm, gravity):
    """In a small motion, the work of the motors and of the wrench equals the change of energy."""
    q, F, h = joint_vectors(arm, (), 3), np.array([3.0, -2, 5, 0.4, 0.1, -0.7]), 1e-6
    step = h * np.random.default_rng(0).normal(size=arm.dof)
    before, after = link_frames(arm, q - step)[-1], link_frames(arm, q + step)[-1]
    turn = (after[:3, :3] @ before[:3, :3].T - before[:3, :3] @ after[:3, :3].T) / 2
    moved = np.concatenate([after[:3, 3] - before[:3, 3], [turn[2, 1], turn[0, 2], turn[1, 0]]])
    change = slow_energy(arm, q + step, gravity) - slow_energy(arm, q - step, gravity)
    work = static_torque(arm, q, F, gravity) @ (2 * step) + F @ moved
    assert work == pytest.approx(change, abs=1e-12)


@every_arm
def test_payload_adds_its_weight(arm):
    q, com = joint_vectors(arm, (), 6), (0.02, -0.03, 0.05)
    bare = replace(arm, bodies=[*([Body(0, (0, 0, 0))] * (len(arm.rows) - 1)), Body(2.5, com)])
    np.testing.assert_allclose(
        gravity_torque(with_payload(arm, 2.5, com), q),
        gravity_torque(arm, q) + gravity_torque(bare, q),
        atol=1e-12,
    )


def test_zero_payload_returns_same_arm():
    assert with_payload(PANDA, 0, (1, 2, 3)) is PANDA
    massless = replace(PANDA, bodies=[Body(0, (0, 0, 0))] * 7)
    assert with_payload(massless, 0) is massless


def test_centres_in_keeps_points_in_place():
    """The two arms have no frame in common."""
    points = np.random.default_rng(2).uniform(-0.3, 0.3, (6, 3))
    ours, theirs = (link_frames(arm, np.linspace(0.3, 1.4, 6))[1:] for arm in (UR10E, STANFORD))
    moved = centres_in(ours, theirs, points)
    for A, p, B, q in zip(ours, moved, theirs, points, strict=True):
        np.testing.assert_allclose(A @ [*p, 1], B @ [*q, 1], atol=1e-14)
