"""Test inverse kinematics by forward kinematics, and completeness by numbers of the literature.

An elbow arm has four solutions for a point and eight for a pose (Pieper, 1968), and so has the
Stanford arm with an unlimited rod. If that many distinct solutions are found, the list is
complete. The UR's number varies; peers/test_ssik.py compares it with another program.
"""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.inverse import elbow, follow, rod, solve, spherical_wrist, stanford, ur
from helpers.inverse.numeric import rotation_vectors
from helpers.kinematics import forward_kinematics, jacobian, manipulability, tip
from helpers.robots import ARMS, ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from tests.laws import joint_difference, tip_errors

OFFSET = ELBOW.with_values(d=0.12)
# The Puma 560's table with a tilted tool, so that no entry of the last row is 0.
PUMA = Arm(
    "Puma",
    (
        revolute(alpha="pi/2"),
        revolute(a=0.4318),
        revolute(a=0.0203, d=0.15005, alpha="-pi/2"),
        revolute(d=0.4318, alpha="pi/2"),
        revolute(alpha="-pi/2"),
        revolute(a=0.03, d=0.0563, alpha=0.4, theta=0.3),
    ),
)


def random_q(arm, count, seed=0):
    rng = np.random.default_rng(seed)
    slides = np.array([arm.rows[i - 1].joint.kind == "prismatic" for i in arm.joints])
    return np.where(slides, 0.3, np.pi) * rng.uniform(-1, 1, (count, arm.dof))


def solve_and_check(solver, arm, q, off=1e-5):
    """Solve the poses of q, and assert that all branches reach them and that q is one of them.

    Near a singular configuration q may differ from its branch if the tip hardly moves between both.
    """
    T = forward_kinematics(arm, q)
    targets = T[:, :3, 3] if arm.dof == 3 else T
    found = solver(arm, targets)
    assert tip_errors(arm, found, targets).max() < 1e-10
    nearest = np.where(found.valid, joint_difference(arm, found.q, q[:, None]), np.inf).min(axis=1)
    J = jacobian(arm, q)[:, : 3 if arm.dof == 3 else 6]
    weakest = np.linalg.svd(J, compute_uv=False)[:, -1]
    assert ((nearest < off) | (nearest * weakest < 1e-10)).all()
    assert (found.distance == 0).all()
    return found


def assert_branches_differ(arm, found):
    for i in range(found.q.shape[-2]):
        for j in range(i):
            both = found.valid[:, i] & found.valid[:, j]
            assert (joint_difference(arm, found.q[:, i], found.q[:, j])[both] > 1e-7).all(), (
                arm.name,
                i,
                j,
            )


LENGTH, SIGN, ZERO = st.floats(0.1, 1), st.sampled_from((-1, 1)), st.floats(-3, 3)
STRAIGHT, SQUARE = st.sampled_from((0.0, np.pi)), st.sampled_from((-np.pi / 2, np.pi / 2))
SIDE = st.sampled_from((-0.3, 0.0, 0.2))
ELBOWS = st.tuples(
    st.builds(revolute, d=LENGTH, alpha=SQUARE, theta=ZERO),
    st.builds(lambda sign, a, d, alpha, theta: revolute(sign * a, alpha, d, theta),
              SIGN, LENGTH, st.floats(-0.4, 0.4), STRAIGHT, ZERO),
    st.builds(lambda sign, a, theta: revolute(sign * a, 0.7, 0.1, theta), SIGN, LENGTH, ZERO),
    st.just(fixed(d=0.2)),
)  # fmt: skip
URS = st.tuples(
    st.builds(revolute, d=st.just(0.2), alpha=SQUARE, theta=ZERO),
    st.builds(revolute, a=SIGN.map(lambda s: 0.6 * s), d=st.just(0.02), alpha=STRAIGHT, theta=ZERO),
    st.builds(
        revolute, a=SIGN.map(lambda s: 0.5 * s), d=st.just(-0.05), alpha=STRAIGHT, theta=ZERO
    ),
    st.builds(revolute, d=SIGN.map(lambda s: 0.17 * s), alpha=SQUARE, theta=ZERO),
    st.builds(revolute, d=SIGN.map(lambda s: 0.12 * s), alpha=SQUARE, theta=ZERO),
    st.builds(lambda sign, theta: revolute(0.04, 0.5, sign * 0.1, theta), SIGN, ZERO),
)
RODS = st.tuples(
    st.builds(revolute, d=SIDE, alpha=SQUARE, theta=ZERO),
    st.builds(revolute, d=SIDE, alpha=SQUARE, theta=ZERO),
    st.builds(prismatic, d=SIDE, theta=ZERO),
    st.builds(fixed, d=st.sampled_from((0.0, 0.2))),
)


@pytest.mark.parametrize(("solver", "rows"), [(elbow, ELBOWS), (ur, URS), (rod, RODS)])
@settings(max_examples=60)
@given(data=st.data())
def test_closed_form_solves_any_signs_offsets_and_zeros(solver, rows, data):
    arm = Arm("random", data.draw(rows))
    found = solve_and_check(solver, arm, random_q(arm, 50))
    if solver is rod:  # "out": positive length
        assert (found.times.sum(axis=1) == 4).all()  # coinciding branches count once
        out = found.q[..., 2] + sum(row.d for row in arm.rows[2:]) > 0
        assert (out == [True, False, True, False])[found.valid].all()


# Examples computed by hand


def test_branch_names_describe_elbow_and_shoulder():
    p = forward_kinematics(ELBOW, random_q(ELBOW, 300))[:, :3, 3]
    found = elbow(ELBOW, p)
    joint = forward_kinematics(replace(ELBOW, rows=ELBOW.rows[:2], home=()), found.q[..., :2])
    elbow_at = joint[..., :3, 3]
    # Height of the elbow over the line from the shoulder (0, 0, 0.5) to the target, in their
    # vertical plane.
    reach = np.hypot(p[:, 0], p[:, 1])[:, None]
    line = 0.5 + (p[:, 2, None] - 0.5) * (elbow_at[..., :2] @ p[:, :2, None])[..., 0] / reach**2
    above = elbow_at[..., 2] > line
    towards = np.cos(found.q[..., 0] - np.arctan2(p[:, 1], p[:, 0])[:, None]) > 0
    names = [f"{side}, elbow {bend}" for side in ("front", "back") for bend in ("up", "down")]
    assert list(found.branches) == names
    assert (above == ["up" in name for name in names]).all()
    assert (towards == ["front" in name for name in names]).all()


def test_target_out_of_reach_has_distance_without_branch():
    found = elbow(ELBOW, [(1.0, 0.0, 0.5), (0.05, 0.0, 0.5), (0.0, 0.0, 2.0)])
    assert not found.valid.any()
    assert np.isnan(found.q).all()
    np.testing.assert_allclose(found.distance, (0.3, 0.05, 0.8), atol=1e-12)
    # An arm with an offset reaches no point within 0.12 m of its first axis.
    np.testing.assert_allclose(elbow(OFFSET, (0.05, 0.0, 0.8)).distance, 0.07, atol=1e-12)
    np.testing.assert_allclose(rod(SHORT, (0.06, 0.08, 0.3)).distance, 0.054)


def test_target_on_the_boundary_is_reached():
    for p, branches in (
        ((0.7, 0, 0.5), ["front", "back"]),
        ((0, 0.1, 0.5), ["front", "back"]),
        ((0.0, 0.0, 1.2), ["the only one"]),  # joint 1 is free
    ):
        found = elbow(ELBOW, p)
        assert list(found.by_name) == branches
        assert found.times.sum() == 4
        assert tip_errors(ELBOW, found, np.array(p)).max() < 1e-12
    assert not elbow(ELBOW, (0.7 + 1e-9, 0, 0.5)).valid.any()


# Singular targets

TWINS = ELBOW.with_values(a_3=0.4)
SHORT = replace(STANFORD, rows=STANFORD.rows[:3], home=())
MAST = Arm("mast", (revolute(alpha="-pi/2"), revolute(alpha="pi/2"), prismatic()))


@pytest.mark.parametrize(
    ("solver", "arm", "target", "branches", "free"),
    [
        (elbow, ELBOW, (0, 0, 0.9), ["elbow up", "elbow down"], [1]),  # back = front turned
        (elbow, TWINS, (0, 0, 0.5), ["the only one"], [1, 2]),  # folded onto the shoulder
        (rod, MAST, (0, 0, 0.6), ["rod out", "rod through"], [1]),  # upright
        (rod, SHORT, tip(SHORT, (0.4, 0.9, 0)), ["the only one"], [2]),  # tip at the shoulder
    ],
)
@pytest.mark.parametrize("start", [(0.0, 0.3, 0.0), (-2.0, 0.7, 0.3)])
def test_free_joint_keeps_its_start_value(solver, arm, target, branches, free, start):
    found = solver(arm, target, start=start)
    assert list(found.by_name) == branches
    assert found.times.sum() == 4
    expected = [joint in free for joint in (1, 2, 3)]
    assert (found.free[found.valid] == expected).all()
    kept = np.where(expected, found.q[found.valid] - start, 0)
    np.testing.assert_allclose(kept, 0, atol=1e-12)
    assert tip_errors(arm, found, np.array(target)).max() < 1e-12


@pytest.mark.parametrize("flipped", [0.0, np.pi])
@pytest.mark.parametrize(("solver", "arm"), [(stanford, STANFORD), (spherical_wrist, PUMA)])
def test_straight_wrist_leaves_joint_4_free(solver, arm, flipped):
    q = random_q(arm, 200, seed=4)
    q[:, 2] += np.where(arm is STANFORD, 0.5, 0.0)
    q[:, 4] = flipped
    T = forward_kinematics(arm, q)
    near = np.array((0, 0, 0, 1.1, 0, 0))
    found = solver(arm, T, start=near)
    same = (
        joint_difference(
            arm, found.q[..., :3] @ np.eye(3, 6), q[:, None] @ np.diag([1, 1, 1, 0, 0, 0])
        )
        < 1e-6
    )
    assert (same.sum(axis=1) == 1).all()
    assert (found.times[same] == 2).all()  # both wrist branches, which are equal here
    assert found.free[same][:, 3].all()
    assert np.allclose(found.q[same][:, 3], 1.1)
    assert tip_errors(arm, found, T).max() < 1e-10


@pytest.mark.parametrize("arm", [UR10E, UR10E_HOMEWORK])
@pytest.mark.parametrize("bend", [0.0, np.pi])
def test_parallel_wrist_axes_leave_joint_6_free(arm, bend):
    q = random_q(arm, 300, seed=5)
    q[:, 4] = bend
    T = forward_kinematics(arm, q)
    found = ur(arm, T, start=q)
    assert tip_errors(arm, found, T).max() < 1e-10
    assert (
        np.where(found.valid, joint_difference(arm, found.q, q[:, None]), 9).min(axis=1).max()
        < 1e-6
    )
    # The pose can be reached, so a branch is found for each start value of the free joint 6.
    for q6 in np.linspace(-3, 3, 7):
        found = ur(arm, T, start=(0, 0, 0, 0, 0, q6))
        assert found.valid.any(axis=1).all()
        assert tip_errors(arm, found, T).max() < 1e-10
        assert (found.free[..., 5] & found.valid).any(axis=1).all()


@pytest.mark.parametrize(
    ("q", "free", "arm"),
    [
        # At home a single point of joint 6's circle is within reach; with the elbow slightly bent
        # the circle crosses the boundary.
        ((0, 0, 0, 0, 0, 0), False, UR10E_HOMEWORK),
        ((0, 0, 1e-3, 0, 0, 0), True, UR10E_HOMEWORK),
        # d_5 in line with the stretched links; at an angle to them; and back towards the
        # shoulder, so that other values of q_6 bend the elbow.
        ((0.3, -0.7, 0, 0, 0, 0.4), False, UR10E_HOMEWORK),
        ((0.3, -0.7, 0, 0.5, 0, 0.4), True, UR10E_HOMEWORK),
        ((0.3, -0.7, 0, np.pi, 0, 0.4), True, UR10E_HOMEWORK),
        # Folded: only the farthest point of the circle, whose radius is 0.1157 m, is on the inner
        # boundary, |a_2 - a_3| = 0.3127 m.
        ((0.2, 0.4, np.pi, 0, 0, 0.3), False, UR10E_HOMEWORK.with_values(a_3=0.3)),
    ],
)
def test_joint_6_is_free_only_if_several_angles_reach(q, free, arm):
    found = ur(arm, forward_kinematics(arm, np.array(q, float)))
    same_shoulder = found.valid & (np.abs(np.exp(1j * found.q[:, 0]) - np.exp(1j * q[0])) < 1e-5)
    assert same_shoulder.any()
    assert found.free[same_shoulder, 5].any() == free


# Coinciding branches


def add_round_off(targets, rng):
    """Change each entry by up to two units of its last binary digit, as other processors do."""
    digit = np.maximum(np.spacing(np.abs(targets)), 1e-16)
    noisy = targets + digit * rng.integers(-2, 3, targets.shape)
    if targets.shape[-2:] == (4, 4):
        noisy[..., 3, :] = (0, 0, 0, 1)
    return noisy


def targets_with_one_shoulder(arm, near, rng):
    """Return poses of a UR at which both shoulder branches coincide or differ by 2 `near` in q_1.

    They coincide if the wrist centre is as far from axis 1 as the shoulder is wide.
    """
    width, hand = abs(arm.numeric[3].d), arm.numeric[5].d
    poses = np.tile(np.eye(4), (12, len(near), 1, 1))
    for some in poses:
        R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        turn, height = rng.uniform((-np.pi, 0.5), (np.pi, 1.0))
        some[:, :3, :3] = R * np.linalg.det(R)
        out = np.outer(width / np.cos(near), [np.cos(turn), np.sin(turn), 0])
        some[:, :3, 3] = out + [0, 0, height] + hand * some[:, :3, 2]
    return poses.reshape(-1, 4, 4)


def boundary_targets():
    """Yield solver, arm and poses at which branches coincide or joint 4 or 6 is free.

    Neighbours of these poses, at distances down to rounding, are included.
    """
    rng = np.random.default_rng(20)
    near = np.array([0.0, *3 * 10.0 ** -np.arange(3, 13)])  # 3e-k is no tolerance
    for arm, solver in (
        (UR10E_HOMEWORK, ur),
        (UR10E, ur),
        (STANFORD, stanford),
        (PUMA, spherical_wrist),
    ):
        q = []
        straight = np.arctan2(0.4318, 0.0203) if arm is PUMA else 0.0
        for special in ((2,), (4,), (2, 4), (1, 2, 3), (1, 2, 3, 4)):
            some = np.repeat(random_q(arm, 4, seed=len(special)), len(near), axis=0)
            some[:, list(special)] = straight * (np.array(special) == 2)
            some[:, special[-1]] += np.tile(near, 4)
            q.append(some)
        q.append(np.zeros((1, 6)))
        poses = forward_kinematics(arm, np.concatenate(q))
        if solver is ur:
            poses = np.concatenate([poses, targets_with_one_shoulder(arm, near, rng)])
        yield solver, arm, poses
    turn = np.linspace(0, 2 * np.pi, 40)[:, None]
    around, high = np.hstack([np.cos(turn), np.sin(turn), 0 * turn]), np.array([0, 0, 0.5])
    for radius in (0.1, 0.7):
        yield elbow, ELBOW, radius * around + high
    yield elbow, ELBOW, turn / 12 * [0, 0, 1] + [0, 0, 0.65]
    yield elbow, OFFSET, OFFSET.values["d"] * around + high + np.array([0, 0, 0.2])


@pytest.mark.parametrize(("solver", "arm", "targets"), list(boundary_targets()))
def test_branches_do_not_depend_on_round_off(solver, arm, targets):
    """Coinciding branches are listed once, with their multiplicity."""
    rng, found = np.random.default_rng(21), solver(arm, targets)
    assert found.valid.any(axis=1).all()
    # Rounding turns joint 1 of a stretched arm by 1e-8 rad.
    assert tip_errors(arm, found, targets).max() < (2e-9 if arm is UR10E_HOMEWORK else 1e-10)
    assert_branches_differ(arm, found)
    assert (found.times.sum(axis=1) <= len(found.branches)).all()
    assert ((found.times >= 1) == found.valid).all()
    for _ in range(12):
        again = solver(arm, add_round_off(targets, rng))
        np.testing.assert_array_equal(again.valid, found.valid)
        np.testing.assert_array_equal(again.times, found.times)
        np.testing.assert_array_equal(again.free, found.free)


def test_infinite_family_is_listed_as_one_branch():
    """After a quarter of the homework's circle, axes 4 and 6 of the back branches are parallel."""
    T = forward_kinematics(UR10E_HOMEWORK, np.zeros(6))
    T[:3, 3] = (-0.1, 0.3561, 1.328)
    found = ur(UR10E_HOMEWORK, T)
    assert list(found.by_name) == [
        "front, q_5 < 0, elbow +",
        "front, q_5 < 0, elbow -",
        "back, elbow +",
        "back, elbow -",
    ]
    assert found.times.sum() == 6
    back = found.free[found.valid][2:]
    assert back.tolist() == [[False] * 5 + [True]] * 2
    np.testing.assert_array_equal(found.q[[4, 5], 4], 0)
    with pytest.raises(ArmError, match=r"the targets are \(2,\); expected one target"):
        ur(UR10E_HOMEWORK, [T, T]).by_name  # noqa: B018


# Choice of a branch


def limit_joints(arm, limits):
    """Return the arm with these (lower, upper) limits and a home within them."""
    rows = [
        replace(row, joint=replace(row.joint, lower=low, upper=high))
        for row, (low, high) in zip(arm.rows, limits, strict=True)
    ]
    return replace(arm, rows=rows, home=tuple(low for low, _ in limits))


@pytest.mark.parametrize(("solver", "arm"), [(elbow, ELBOW), (stanford, STANFORD)])
@settings(max_examples=60)
@given(seed=st.integers(0, 9999), wide=st.floats(0.5, 12))
def test_nearest_agrees_with_search_over_branches_and_turns(solver, arm, seed, wide):
    """The search tries every whole turn of every revolute joint."""
    rng = np.random.default_rng(seed)
    low = rng.uniform(-wide, 0, arm.dof)
    arm = limit_joints(arm, np.stack([low, low + wide], axis=1))
    start = random_q(arm, 1, seed)[0] * rng.choice([1, 3])
    T = forward_kinematics(arm, random_q(arm, 1, seed + 1)[0])
    found = solver(arm, T[:3, 3] if arm.dof == 3 else T)
    turns = np.array([row.joint.kind == "revolute" for row in arm.rows])[:, None]
    tried = found.q[..., None] + 2 * np.pi * np.arange(-6, 7) * turns
    inside = (tried >= low[:, None]) & (tried <= low[:, None] + wide)
    gaps = np.abs(tried - start[:, None])
    least = np.where(inside, gaps, np.inf).min(axis=-1).max(axis=-1)
    chosen = found.nearest(start)
    assert np.isfinite(chosen).all() == np.isfinite(least).any()
    if np.isfinite(least).any():
        assert np.abs(chosen - start).max() == pytest.approx(least.min(), abs=1e-9)
        assert joint_difference(arm, found.q, chosen)[found.valid].min() < 1e-9
    np.testing.assert_array_equal(found.within_limits, inside.any(axis=-1).all(axis=-1))


@pytest.mark.parametrize("limits", [(-2.0, 1.0), (1.0, 2.0), (-6.0, 1.0)])
def test_joint_at_its_limit_is_within_limits(limits):
    """5e-10 rad beyond the limit is round-off; 1e-6 rad is not."""
    arm = Arm("stopped", (revolute(alpha="pi/2"), revolute(a=1), revolute(a=0.5)))
    arm = limit_joints(arm, [limits, (-9, 9), (-9, 9)])
    out = 1.0 if limits[1] == 1.0 else -1.0
    for over, inside in ((0.0, True), (5e-10, True), (1e-6, limits[0] == -6)):
        q = np.array((1.0 + out * over, 0.4, 0.5))
        found = elbow(arm, forward_kinematics(arm, q)[:3, 3])
        at = int(joint_difference(arm, found.q, q).argmin())
        assert found.within_limits[at] == inside
        if over < 1e-6:
            np.testing.assert_allclose(found.nearest(q), q, atol=1e-9)


def test_follow_keeps_branch_and_free_joint():
    """The path crosses the axis above the shoulder, and the arm leans over without a jump."""
    x = np.linspace(-0.2, 0.2, 81)
    path = np.stack([x, 0 * x, 0 * x + 1.0], axis=-1)
    q0 = elbow(ELBOW, path[0]).q[0]
    q = follow(partial(elbow, ELBOW), path, q0)
    np.testing.assert_allclose(forward_kinematics(ELBOW, q)[:, :3, 3], path, atol=1e-10)
    assert np.abs(np.diff(q, axis=0)).max() < 0.2

    def careless(target, start):
        found = elbow(ELBOW, target, start)
        target += 1.0
        start += 1.0
        return found

    np.testing.assert_array_equal(follow(careless, path, q0), q)
    with pytest.raises(ArmError, match=r"Elbow arm: no branch reaches target 1 of 2"):
        follow(partial(elbow, ELBOW), [path[0], (2, 0, 0)], q0)


# Shapes and bad input


def test_targets_broadcast_beyond_one_chunk():
    q = random_q(UR10E, 9000)
    T = forward_kinematics(UR10E, q)
    assert ur(UR10E, T[:0]).q.shape == (0, 8, 6)
    found = ur(UR10E, T.reshape(3, 3000, 4, 4))
    assert found.q.shape == (3, 3000, 8, 6)
    assert found.valid.shape == (3, 3000, 8)
    assert found.distance.shape == (3, 3000)
    assert found.free.shape == found.q.shape
    for k in (0, 4095, 4096, 8191, 8192, 8999):
        one = ur(UR10E, T[k])
        np.testing.assert_allclose(found.q.reshape(-1, 8, 6)[k], one.q, atol=1e-12)
        np.testing.assert_array_equal(found.valid.reshape(-1, 8)[k], one.valid)


def test_each_target_has_its_start_beyond_one_chunk():
    """Above the shoulder joint 1 is free, so each solution keeps the start value of its target."""
    q1 = np.linspace(-3, 3, 9000)
    near = np.column_stack([q1, 0 * q1, 0 * q1])
    for targets in ((0.0, 0.0, 0.9), np.tile((0.0, 0.0, 0.9), (9000, 1))):
        found = elbow(ELBOW, targets, start=near)
        assert found.free[:, :2, 0].all()
        np.testing.assert_allclose(found.q[:, :2, 0], np.column_stack([q1, q1]), atol=1e-12)


def test_ur_folded_onto_its_shoulder_leaves_joint_2_free():
    """The table has offsets at joints 2 and 3."""
    first, second, third, *others = UR10E.with_values(a_3=0.6127).rows  # as a_2
    offset = replace(second, theta=0.3), replace(third, theta=-0.5)
    twins = replace(UR10E.with_values(a_3=0.6127), rows=[first, *offset, *others])
    q = np.array((0.4, 0.7, np.pi + 0.5, 0.3, 1.1, -0.8))
    T = forward_kinematics(twins, q)
    found = ur(twins, T, start=q)
    folded = found.valid & found.free[:, 1]
    assert folded.any()
    np.testing.assert_allclose(found.q[folded, 1], 0.7, atol=1e-12)
    assert tip_errors(twins, found, T).max() < 1e-10


NO_ROD = [
    (revolute(a=0.1, alpha="pi/2"), revolute(alpha="pi/2"), prismatic()),
    (revolute(alpha=0.3), revolute(alpha="pi/2"), prismatic()),
    (revolute(alpha="pi/2"), revolute(alpha=0.3), prismatic()),
    (revolute(alpha="pi/2"), revolute(alpha="pi/2"), prismatic(alpha="pi/2")),
    (revolute(alpha="pi/2"), revolute(alpha="pi/2"), prismatic(alpha="pi")),
    (revolute(alpha="pi/2"), revolute(alpha="pi/2"), prismatic(), revolute()),
]
NO_UR = [(i, {"a": 0.1}) for i in (1, 4, 5)] + [(i, {"alpha": 0.3}) for i in range(1, 6)]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: elbow(ELBOW.with_values(a_3=0), (0, 0, 1)), "is no elbow arm"),
        *[(lambda rows=r: rod(Arm("odd", rows), (0, 0, 0)), "odd has no rod") for r in NO_ROD],
        (lambda: stanford(PUMA, np.eye(4)), "Puma has no rod through its shoulder"),
        (lambda: spherical_wrist(STANFORD, np.eye(4)), "Stanford arm is no elbow arm"),
        *[
            (lambda i=i, e=e: ur(UR10E.with_row(i, **e), np.eye(4)), "UR10e is no arm of the UR")
            for i, e in [*NO_UR, (2, {"a": 0}), (3, {"a": 0})]
        ],
        (lambda: ur(UR10E, np.diag([1, 1, -1, 1])), "UR10e: a target is no rigid transform, by 2;"),
        (lambda: ur(UR10E, np.eye(4) + np.eye(4)[::-1] * 0.1), "is no rigid transform"),
        (lambda: solve(PANDA, np.zeros((4, 4))), "Panda: a target is no rigid transform"),
    ],
)
def test_unsuitable_arm_or_target_is_rejected(call, message):
    with pytest.raises(ArmError, match=message):
        call()


# The numeric solver


@pytest.mark.parametrize("arm", [PANDA, PANDA.lock(3), UR10E, STANFORD, PUMA])
def test_solve_converges_from_starts_within_0_2_rad(arm):
    """All of 1000 regular targets must be reached, by forward kinematics."""
    lower, upper = (np.clip(limit, -np.pi, np.pi) for limit in arm.limits)
    rng = np.random.default_rng(1)
    q = rng.uniform(lower, upper, (1500, arm.dof))
    q = q[np.linalg.svd(jacobian(arm, q), compute_uv=False)[:, 5] > 0.02][:1000]
    T = forward_kinematics(arm, q)
    found = solve(arm, T, np.clip(q + rng.uniform(-0.2, 0.2, q.shape), *arm.limits))
    assert found.reached.all()
    np.testing.assert_allclose(forward_kinematics(arm, found.q), T, atol=3e-10)
    assert (found.q >= arm.limits[0]).all()
    assert (found.q <= arm.limits[1]).all()
    assert found.position_error.max() <= 1e-10
    assert found.orientation_error.max() <= 1e-10


@pytest.mark.parametrize("arm", ARMS, ids=str)
def test_solve_finds_reachable_target_by_itself(arm):
    """From home, the poses of at least 99.5 % of 1000 random configurations must be reached."""
    lower, upper = (np.clip(limit, -np.pi, np.pi) for limit in arm.limits)
    T = forward_kinematics(arm, np.random.default_rng(3).uniform(lower, upper, (1000, arm.dof)))
    found = solve(arm, T[:, :3, 3] if arm.dof == 3 else T)
    assert found.reached.mean() >= 0.995
    q, reached = found.q[found.reached], T[found.reached]
    off = forward_kinematics(arm, q) - reached
    assert np.abs(off if arm.dof > 3 else off[:, :3, 3]).max() < 3e-10
    assert ((q >= arm.limits[0]) & (q <= arm.limits[1])).all()


def test_solve_reports_distance_of_unreachable_target():
    """The least squares must find the distance that geometry gives for the elbow arm."""
    p = np.random.default_rng(2).uniform(-1.5, 1.5, (200, 3))
    expected = elbow(ELBOW, p).distance
    found = solve(ELBOW, p, (0.1, 0.4, -0.9), restarts=5, iterations=300)
    np.testing.assert_allclose(found.position_error, expected, atol=1e-5)
    np.testing.assert_array_equal(found.reached, expected == 0)
    assert (found.orientation_error == 0).all()


def test_solve_prefers_limits_to_reaching_the_target():
    q = np.array(PANDA.home) + 0.3
    T = forward_kinematics(PANDA, q)
    narrow = limit_joints(PANDA, np.add.outer(PANDA.home, [-0.1, 0.1]))
    found = solve(narrow, T, PANDA.home)
    assert not found.reached
    assert found.position_error > 0.01
    assert (np.abs(found.q - PANDA.home) <= 0.1 + 1e-12).all()
    assert solve(narrow, T, PANDA.home, limits=False).reached


def test_restarts_cover_limits_or_default_range():
    """With no iterations, `solve` returns the restart that is nearest to the target."""
    rows = [
        revolute(limits=(0.2, 0.7)), revolute(a=1, limits=(-np.inf, 0.5)), prismatic(),
        revolute(a=1), prismatic(alpha="pi/2", limits=(0.1, np.inf)),
    ]  # fmt: skip
    targets = forward_kinematics(Arm("five", rows), np.random.default_rng(1).normal(size=(2000, 5)))
    found = solve(
        Arm("five", rows), targets[:, :3, 3], [0.3, 0, 0, 0, 0.2], iterations=0, restarts=1
    )
    moved = found.q[(found.q != [0.3, 0, 0, 0, 0.2]).any(axis=1)]
    assert len(moved) > 200
    lower, upper = [0.2, -np.pi, -1, -np.pi, 0.1], [0.7, 0.5, 1, np.pi, 1]
    share = (moved - lower) / np.subtract(upper, lower)
    np.testing.assert_allclose(
        [share.min(axis=0), share.max(axis=0)], [[0] * 5, [1] * 5], atol=0.04
    )
    assert share.min() >= 0
    assert share.max() <= 1


def test_rotation_vectors_agree_with_scipy():
    """Random turns, small ones, and half turns, whose axis cannot be read from the antisymmetric
    part."""
    rng = np.random.default_rng(8)
    axes = rng.normal(size=(60, 3))
    axes = np.vstack([axes, np.eye(3), -np.eye(3)])
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    for angle in (0.0, 1e-9, 0.3, 3.0, np.pi - 1e-7, np.pi):
        start = np.linalg.qr(rng.normal(size=(len(axes), 3, 3)))[0]
        R = Rotation.from_rotvec(angle * axes).as_matrix()
        vector = rotation_vectors(start.transpose(2, 1, 0), (R @ start).transpose(2, 1, 0)).T
        assert np.allclose(np.linalg.norm(vector, axis=1), angle, atol=1e-8)
        again = Rotation.from_rotvec(vector).as_matrix()
        np.testing.assert_allclose(again, R, atol=1e-7)


def test_solve_broadcasts_beyond_one_chunk():
    q = random_q(ELBOW, 5000, seed=9)
    p = forward_kinematics(ELBOW, q)[:, :3, 3].reshape(2, 2500, 3)
    found = solve(ELBOW, p, q.reshape(2, 2500, 3) + 0.01)
    assert found.q.shape == (2, 2500, 3)
    assert found.reached.shape == (2, 2500)
    far = manipulability(ELBOW, q.reshape(2, 2500, 3), "linear") > 1e-3
    assert found.reached[far].all()
    assert solve(ELBOW, np.zeros((0, 3))).q.shape == (0, 3)
    slider = Arm("slider", (prismatic(),))
    np.testing.assert_allclose(solve(slider, (0, 0, 0.4)).q, [0.4])
