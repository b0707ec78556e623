"""The checkers' kinematics of many tables at once against those of one arm."""

import numpy as np
import pytest

from helpers.arm import Arm, Body, fixed, prismatic, revolute
from helpers.checks.chains import chain, columns, vector_products, weights
from helpers.kinematics import forward_kinematics, jacobian, link_frames
from helpers.robots import PANDA, STANFORD
from helpers.statics import gravity_torque

MIXED = Arm(
    "mixed",
    [
        fixed(0.1, 0.4, 0.2, 0.3),
        revolute(0.3, "pi/2", 0.1, "pi/2"),
        prismatic(0.2, "-pi", 0.3, 0.5),
        fixed(0.2, -0.7, 0.4, 1.1),
        revolute(-0.1, 1.2, 0.25, "-pi/2"),
        fixed(0.05, 0.6, 0.1, 0.2),
    ],
    bodies=[Body(k + 1.0, (0.1 * k, -0.2, 0.05 * k)) for k in range(6)],
)
ARMS = pytest.mark.parametrize("arm", [MIXED, PANDA, STANFORD], ids=str)
RNG = np.random.default_rng(4)


@ARMS
def test_it_agrees_with_the_arm_at_one_pose_and_at_many(arm):
    poses = RNG.uniform(-3, 3, (5, arm.dof))
    for q in (poses, poses[0]):
        one = chain(arm, q)
        np.testing.assert_allclose(one.frames, link_frames(arm, q), atol=1e-14)
        np.testing.assert_allclose(columns(one), jacobian(arm, q), atol=1e-14)
        elsewhere = columns(one, frames=chain(arm, 2 * q).frames)
        np.testing.assert_allclose(elsewhere, jacobian(arm, 2 * q), atol=1e-14)


@ARMS
def test_many_tables_at_one_pose_are_as_many_arms(arm):
    q = RNG.uniform(-3, 3, arm.dof)
    one = chain(arm, q)
    changes = {name: RNG.uniform(-1, 1, (4, len(arm.rows))) for name in ("a", "alpha", "theta")}
    for name, many in changes.items():
        found = one.with_(**{name: many}).frames
        for numbers, frames in zip(many, found, strict=True):
            rows = arm
            for i, x in enumerate(numbers, 1):
                rows = rows.with_row(i, **{name: x})
            np.testing.assert_allclose(frames, link_frames(rows, q), atol=1e-14)
    tips = one.with_(q=np.stack([q, 2 * q])).frames[:, -1]
    np.testing.assert_allclose(tips, forward_kinematics(arm, np.stack([q, 2 * q])), atol=1e-14)


def test_right_angles_are_exact():
    arm = Arm("right", [revolute(1, "pi/2", 0, "pi"), revolute(0, "-pi/2", 2, "-3*pi/2")])
    frames = chain(arm, np.zeros(2)).frames
    assert set(frames.ravel()) <= {-2.0, -1.0, 0.0, 1.0, 2.0}


def test_each_step_of_the_recipe_done_otherwise_by_hand():
    """Two links of 1 m in a plane, the first up along y and the second along x; then a slide."""
    arm = Arm("L", [revolute(1), revolute(1), prismatic(0.5)])
    one = chain(arm, np.array([np.pi / 2, -np.pi / 2, 0]))
    told = lambda **how: np.round(columns(one, **how), 12).T[:, [0, 1, 2, 5]].tolist()  # noqa: E731
    slide = [0, 0, 1, 0]
    assert told() == [[-1, 1.5, 0, 1], [0, 1.5, 0, 1], slide]
    assert told(lever="tip")[1] == [-1, 1.5, 0, 1]
    assert told(lever="o")[:2] == [[0, 0, 0, 1], [-1, 0, 0, 1]]
    assert told(lever="link")[:2] == [[-1, 0, 0, 1], [0, 1, 0, 1]]
    assert told(point=1)[:2] == [[-1, 0, 0, 1], [0, 0, 0, 1]]
    assert told(origin=np.array([1, 2, 3]))[:2] == [[0, 1.5, 0, 1], [0, 0.5, 0, 1]]
    assert told(slides=False)[2] == [0, 0.5, 0, 1]
    tilted = chain(Arm("tilted", [revolute(1, "pi/2"), revolute(1)]), np.zeros(2))
    assert np.round(columns(tilted, axis=np.array([1, 1])), 12).T[0].tolist() == [0, 0, 2, 0, -1, 0]


@ARMS
def test_weights_are_those_of_statics(arm):
    rows = len(arm.rows)
    bodies = [
        Body(m, tuple(c))
        for m, c in zip(RNG.uniform(0, 5, rows), RNG.uniform(-1, 1, (rows, 3)), strict=True)
    ]
    gravity, q = np.array([1.0, -2.0, -9.0]), RNG.uniform(-3, 3, (3, arm.dof))
    masses, centres = np.array([b.mass for b in bodies]), np.array([b.com for b in bodies])
    for at in (q, q[0]):
        wanted = gravity_torque(arm.with_bodies(bodies), at, gravity)
        found = weights(chain(arm, at), masses, centres, gravity)
        np.testing.assert_allclose(found, wanted, atol=1e-12)


def test_vector_products_are_numpys():
    u, v = RNG.uniform(-1, 1, (2, 4, 5, 3))
    np.testing.assert_allclose(vector_products(u, v), np.cross(u, v), atol=1e-15)
