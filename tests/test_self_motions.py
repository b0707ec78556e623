"""Test self-motions against linkages solved by hand and against finite differences."""

from dataclasses import replace

import numpy as np
import pytest

from helpers.arm import Arm, ArmError, revolute
from helpers.kinematics import jacobian
from helpers.motion import self_motion, self_motion_directions
from helpers.motion.self_motions import _compute_acceleration
from helpers.robots import ARMS, ELBOW, PANDA, UR10E_HOMEWORK
from tests.laws import slow_frames

HOME = np.array(PANDA.home)
IDLE = np.array([1, 0, -1, 0, 0, 0, 0])
TURNED = HOME - np.pi / 2 * IDLE
# A four-bar linkage: base and tip are the ends of its fourth side. At FLAT it is a parallelogram
# with sides of 1 and 2 m, folded flat.
LINKAGE = Arm("linkage", [revolute(a=1), revolute(a=2), revolute(a=1), revolute()])
FLAT = [0, 0, np.pi, -np.pi]


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)
def test_acceleration_matches_finite_differences(arm):
    rng = np.random.default_rng(1)
    q, rates = rng.uniform(-1, 1, (2, arm.dof))
    h = 1e-5
    ahead, behind = jacobian(arm, q + h * rates) @ rates, jacobian(arm, q - h * rates) @ rates
    assert _compute_acceleration(jacobian(arm, q), rates) == pytest.approx(
        (ahead - behind) / (2 * h), abs=1e-8
    )


def test_flat_parallelogram_has_two_self_motions():
    found = self_motion_directions(LINKAGE, FLAT)
    by_hand = np.array([[1, -1, 1, -1], [1, -3, -1, 3]])
    assert found / found[:, :1] == pytest.approx(by_hand)


def test_parallelogram_keeps_its_shape():
    crank = self_motion(LINKAGE, FLAT, 1e-3 * np.array([1, -1, 1, -1]), 3.0)
    turned = crank.q - FLAT
    assert turned == pytest.approx(turned[:, :1] * [1, -1, 1, -1], abs=1e-12)
    at = np.array([[0.0, 0.5], [1.0, 1.5]])
    np.testing.assert_array_equal(crank.path.velocity(at), np.zeros((2, 2, 3)))
    np.testing.assert_array_equal(
        crank.path.position(at), np.full((2, 2, 3), slow_frames(LINKAGE, FLAT)[-1][:3, 3])
    )


def test_arm_without_redundancy_has_no_self_motion():
    assert self_motion_directions(ELBOW, [0.3, 0.4, -0.9]).shape == (0, 3)
    with pytest.raises(ArmError, match="only moves the tip"):
        self_motion(ELBOW, [0.3, 0.4, -0.9], [1, 0, 0], 1.0)


def test_singular_ur10e_wrist_has_self_motion():
    """At q_5 = 0 the axes 2, 3, 4 and 6 of the UR10e are parallel, as in a four-bar linkage."""
    q = [0.1, 0.5, 0.9, 0.3, 0, 0.2]
    (direction,) = self_motion_directions(UR10E_HOMEWORK, q)
    assert direction[[0, 4]] == pytest.approx(0, abs=1e-12)
    run = self_motion(UR10E_HOMEWORK, q, direction, 0.5)
    assert abs(run.q[-1, 3] - q[3]) > 0.1
    pose = slow_frames(UR10E_HOMEWORK, q)[-1]
    for now in run.q[::10]:
        assert slow_frames(UR10E_HOMEWORK, now)[-1] == pytest.approx(pose, abs=1e-12)


def test_direction_excluded_by_second_order_is_left_out():
    """The arm is stretched, so that any motion of its joints moves the tip nearer."""
    straight = Arm("straight", [revolute(a=1), revolute(a=2), revolute(a=1), revolute()])
    assert self_motion_directions(straight, [0, 0, 0, 0]).shape == (0, 4)


def move_elbow_out():
    _, direction = self_motion_directions(PANDA, TURNED)
    return self_motion(PANDA, TURNED, -direction, 2.45)


def test_steps_and_times_are_equally_spaced():
    run = move_elbow_out()
    lengths = np.linalg.norm(np.diff(run.q, axis=0), axis=1)
    assert lengths == pytest.approx(0.01, rel=1e-2)
    assert np.diff(run.t) == pytest.approx(0.01 / 0.5)
    assert run.q_dot[:-1] * 0.02 == pytest.approx(np.diff(run.q, axis=0))
    assert run.report.position_error < 1e-12


def test_self_motion_stops_at_joint_limit():
    _, direction = self_motion_directions(PANDA, TURNED)
    run = self_motion(PANDA, TURNED, -direction, 20.0)
    lower, upper = PANDA.limits
    assert len(run.q) < 600
    assert (run.q >= lower).all()
    assert 0 <= np.minimum(run.q[-1] - lower, upper - run.q[-1]).min() < 0.01


def test_self_motion_at_limit_stays_at_start():
    tight = revolute(alpha="pi/2", d="d_1", limits=(-np.pi / 2, 1.0))
    narrow = replace(PANDA, rows=(tight, *PANDA.rows[1:]))
    for arm, start in ((narrow, TURNED), (PANDA, TURNED - 3 * IDLE)):
        run = self_motion(arm, start, -IDLE, 1.0)
        np.testing.assert_array_equal(run.q, [start, start])


def test_step_too_long_is_rejected():
    _, direction = self_motion_directions(PANDA, TURNED)
    with pytest.raises(ArmError, match="step"):
        self_motion(PANDA, TURNED, direction, 8.0, step=4.0)


def test_too_many_null_directions_are_rejected():
    with pytest.raises(ArmError, match="3 null directions"):
        self_motion_directions(UR10E_HOMEWORK, np.zeros(6))
    plenty = Arm("eight", [revolute(a=0.1, alpha=x, d=0.2) for x in np.linspace(0.2, 1.6, 8)])
    with pytest.raises(ArmError, match="2 null directions and loses 0"):
        self_motion_directions(plenty, np.linspace(0.3, 1.2, 8))
    spindle = Arm("three joints about one axis", [revolute(), revolute(), revolute()])
    with pytest.raises(ArmError, match=r"second order .* at q = \[0.1 0.2 0.3\];"):
        self_motion_directions(spindle, [0.1, 0.2, 0.3])
