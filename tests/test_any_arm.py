"""Test inverse kinematics on random arms of every structure and on published industrial arms.

Forward kinematics decides whether a branch is right. A list is complete if the joint vector that
made the pose is in it, and if a numeric search from many random starts finds no other solution.
"""

import os

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from helpers.arm import Arm, fixed, prismatic, revolute
from helpers.checks.arms import arm_data
from helpers.inputs import ArmError
from helpers.inverse import elbow, solutions, solve, spherical_wrist, stanford, ur
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E
from tests.laws import joint_difference, tip_errors
from tests.node import ask_node, needs_node

HALF = np.pi / 2
ARMS = int(os.environ.get("RANDOM_ARMS", "30"))  # arms per structure; CI tests 1 000 once a week
POSES = 10
# Joints, parallel neighbours (rows with alpha 0 or 180 degrees), neighbours that meet (rows with
# a = 0), and the joint after which three axes meet.
STRUCTURES = {
    "wrist RPP": ("RPPRRR", (), (), 3),
    "wrist PRP": ("PRPRRR", (), (), 3),
    "wrist PPR": ("PPRRRR", (), (), 3),
    "wrist PPP": ("PPPRRR", (), (), 3),
    "wrist, axes 2 and 3 parallel": ("RRRRRR", (1,), (), 3),
    "wrist, axes 1 and 2 parallel": ("RRRRRR", (0,), (), 3),
    "wrist, axes 1 and 2 meet": ("RRRRRR", (), (0,), 3),
    "wrist, axes 2 and 3 meet": ("RRRRRR", (), (1,), 3),
    "wrist on a turning rod": ("RPRRRR", (0, 1), (), 3),
    "first three meet, 5 and 6 parallel": ("RRRRRR", (4,), (), 0),
    "first three meet, 4 and 5 parallel": ("RRRRRR", (3,), (), 0),
    "1 to 3 parallel, 4 and 5 meet": ("RRRRRR", (0, 1), (3,), None),
    "1 to 3 parallel, 5 and 6 meet": ("RRRRRR", (0, 1), (4,), None),
    "2 to 4 parallel, 5 and 6 meet": ("RRRRRR", (1, 2), (4,), None),
    "3 to 5 parallel, 1 and 2 meet": ("RRRRRR", (2, 3), (0,), None),
    "4 to 6 parallel, 1 and 2 meet": ("RRRRRR", (3, 4), (0,), None),
    "4 to 6 parallel, 2 and 3 meet": ("RRRRRR", (3, 4), (1,), None),
    "planar RR": ("RR", (0,), (), None),
    "planar RRR": ("RRR", (0, 1), (), None),
    "SCARA RRPR": ("RRPR", (0, 1, 2), (), None),
    "SCARA RRRP": ("RRRP", (0, 1, 2), (), None),
    "SCARA PRRR": ("PRRR", (0, 1, 2), (), None),
    "position RRP": ("RRP", (0, 1), (), None),
    "position RRR, axes 1 and 2 meet": ("RRR", (), (0,), None),
    "position RRR, axes 2 and 3 parallel": ("RRR", (1,), (), None),
    "position PRP": ("PRP", (), (), None),
    "position RPP": ("RPP", (), (), None),
    "position PPR": ("PPR", (), (), None),
    "position PPP": ("PPP", (), (), None),
}
# Rows (a, alpha, d, theta) in m and rad as their makers or the literature publish them.
PUBLISHED = {
    "PUMA 560": [(0, HALF, 0, 0), (0.4318, 0, 0, 0), (0.0203, -HALF, 0.15005, 0),
                 (0, HALF, 0.4318, 0), (0, -HALF, 0, 0), (0, 0, 0.0563, 0)],
    "KUKA KR210": [(0.35, -HALF, 0.75, 0), (1.25, 0, 0, -HALF), (-0.054, -HALF, 0, 0),
                   (0, HALF, 1.5, 0), (0, -HALF, 0, 0), (0, 0, 0.303, 0)],
    "ABB IRB 140": [(0.07, -HALF, 0.352, 0), (0.36, 0, 0, -HALF), (0, -HALF, 0, 0),
                    (0, HALF, 0.38, 0), (0, -HALF, 0, 0), (0, 0, 0.065, 0)],
    "AR3": [(0.0642, -HALF, 0.16977, 0), (0.305, 0, 0, 0), (0, HALF, 0, 0),
            (0, -HALF, -0.22263, 0), (0, HALF, 0, 0), (0, 0, -0.03625, 0)],
}  # fmt: skip


def make_row(kind, numbers):
    make = revolute if kind == "R" else prismatic
    return make(*(float(x) for x in numbers))


def random_arm(rng, kinds, parallel, meeting, wrist):
    """Return a random arm with exactly this structure."""
    n = len(kinds)
    a = rng.uniform(0.1, 0.6, n) * rng.choice([-1, 1], n)
    d = rng.uniform(-0.5, 0.5, n)
    alpha = rng.uniform(0.4, 2.7, n) * rng.choice([-1, 1], n)
    theta = rng.uniform(-3, 3, n)
    alpha[list(parallel)] = rng.choice([0, np.pi], len(parallel))
    a[list(meeting)] = 0
    if wrist is not None:
        a[wrist : wrist + 2], d[wrist + 1] = 0, 0
    rows = zip(kinds, zip(a, alpha, d, theta, strict=True), strict=True)
    return Arm("random", [make_row(*row) for row in rows])


def random_q(arm, count, rng):
    turning = rng.uniform(-np.pi, np.pi, (count, arm.dof))
    return np.where(arm.turning, turning, rng.uniform(-1, 1, (count, arm.dof)))


def targets_of(arm, q, name=""):
    """Return poses, or positions for an arm that controls only the position of its tip."""
    T = forward_kinematics(arm, q)
    return T[..., :3, 3] if name.startswith("position") or name == "planar RR" else T


def assert_valid(arm, found, targets, within=1e-9):
    """Assert that each valid branch takes the tip to its target."""
    assert tip_errors(arm, found, targets).max(initial=0.0) < within, arm


def has_joint_vector(arm, found, q, within=1e-6):
    """Return for each target whether its solutions contain the joint vector that gave it."""
    gap = joint_difference(arm, found.q, q[:, None])
    return np.where(found.valid, gap, np.inf).min(axis=-1) < within


@pytest.mark.parametrize("name", STRUCTURES)
def test_solutions_contain_the_joint_vector_of_the_pose(name):
    rng = np.random.default_rng(5)
    for _ in range(ARMS):
        arm = random_arm(rng, *STRUCTURES[name])
        q = random_q(arm, POSES, rng)
        targets = targets_of(arm, q, name)
        found = solutions(arm, targets)
        assert_valid(arm, found, targets)
        assert has_joint_vector(arm, found, q).all(), (name, arm, q)
        assert np.all(found.distance == 0)


@pytest.mark.parametrize("name", STRUCTURES)
def test_solutions_list_no_branch_twice(name):
    rng = np.random.default_rng(6)
    arm = random_arm(rng, *STRUCTURES[name])
    found = solutions(arm, targets_of(arm, random_q(arm, 50, rng), name))
    for i in range(found.q.shape[-2]):
        for j in range(i):
            both = found.valid[:, i] & found.valid[:, j]
            gap = joint_difference(arm, found.q[:, i], found.q[:, j])
            assert (gap[both] > 1e-7).all(), (name, i, j)


@pytest.mark.parametrize(
    "arm",
    [
        "wrist, axes 2 and 3 parallel",
        "wrist, axes 1 and 2 meet",
        "2 to 4 parallel, 5 and 6 meet",
        "4 to 6 parallel, 1 and 2 meet",
        ELBOW,
        ELBOW.with_values(d=0.12),
        STANFORD,
        UR10E,
    ],
    ids=str,
)
def test_numeric_search_finds_no_further_solution(arm):
    rng = np.random.default_rng(7)
    arm = arm if isinstance(arm, Arm) else random_arm(rng, *STRUCTURES[arm])
    for q in random_q(arm, 3, rng):
        target = targets_of(arm, q, "position" if arm.dof == 3 else "")
        starts = random_q(arm, 80, rng)
        search = solve(arm, np.broadcast_to(target, (80, *target.shape)), starts, limits=False)
        found = solutions(arm, target)
        for reached in search.q[search.reached]:
            gap = joint_difference(arm, found.q[found.valid], reached)
            assert gap.min() < 1e-5, (arm, reached)


@pytest.mark.parametrize("name", STRUCTURES)
def test_solutions_are_valid_at_special_angles(name):
    """At 0, 90 and 180 degrees roots coincide, axes coincide and joints are free."""
    rng = np.random.default_rng(8)
    for _ in range(5):
        arm = random_arm(rng, *STRUCTURES[name])
        quarter = rng.integers(-1, 3, (20, arm.dof)) * HALF
        q = np.where(arm.turning, quarter, rng.uniform(-1, 1, quarter.shape))
        q = q + rng.choice([0.0, 1e-3, 1e-5, 1e-8], (20, 1)) * rng.uniform(-1, 1, q.shape)
        targets = targets_of(arm, q, name)
        found = solutions(arm, targets)
        assert_valid(arm, found, targets)
        assert found.valid.any(axis=-1).all(), (name, arm, q[~found.valid.any(axis=-1)])


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_arm_has_its_solutions(name):
    arm = Arm(name, [make_row("R", row) for row in PUBLISHED[name]])
    q = random_q(arm, 200, np.random.default_rng(9))
    targets = forward_kinematics(arm, q)
    found = solutions(arm, targets)
    assert_valid(arm, found, targets)
    assert has_joint_vector(arm, found, q).all()
    assert found.times.sum(axis=-1).max() == 8  # Pieper: at most eight


@pytest.mark.parametrize("error", [2e-10, 1e-7, 3e-5])
def test_nearly_parallel_axes_give_exact_solutions(error):
    """UR's own files round pi/2 to 1.570796327; calibrated arms differ from pi/2 by about 1e-4."""
    rng = np.random.default_rng(10)
    rows = [
        revolute(row.a, np.arctan2(row.sin_alpha, row.cos_alpha) + error * side, row.d, row.theta)
        for row, side in zip(UR10E.numeric, rng.uniform(-1, 1, 6), strict=True)
    ]
    arm = Arm("calibrated", rows)
    q = random_q(arm, 300, rng)
    targets = forward_kinematics(arm, q)
    found = solutions(arm, targets)
    assert_valid(arm, found, targets)
    assert has_joint_vector(arm, found, q).mean() > 0.98
    assert "nearly" in found.structure


@pytest.mark.parametrize(
    ("arm", "closed_form"), [(ELBOW, elbow), (STANFORD, stanford), (UR10E, ur)]
)
def test_solutions_of_taught_arms_are_their_closed_forms(arm, closed_form):
    q = random_q(arm, 50, np.random.default_rng(11))
    targets = targets_of(arm, q, "position" if arm is ELBOW else "")
    np.testing.assert_array_equal(solutions(arm, targets).q, closed_form(arm, targets).q)


def test_turned_tool_leaves_the_number_of_solutions():
    puma = Arm("PUMA", [make_row("R", row) for row in PUBLISHED["PUMA 560"]])
    tooled = Arm("PUMA with tool", (*puma.rows, fixed(0.1, 0.7, 0.2, -0.4)))
    q = random_q(puma, 50, np.random.default_rng(12))
    with_tool = solutions(tooled, forward_kinematics(tooled, q))
    without = spherical_wrist(puma, forward_kinematics(puma, q))
    np.testing.assert_array_equal(with_tool.times.sum(axis=-1), without.times.sum(axis=-1))


def test_solutions_out_of_reach_are_no_error():
    arm = Arm("KR210", [make_row("R", row) for row in PUBLISHED["KUKA KR210"]])
    far = np.eye(4)
    far[0, 3] = 9.0
    found = solutions(arm, far)
    assert not found.valid.any()
    # The stretched arm has its wrist centre 0.35 + 1.25 + hypot(1.5, 0.054) m from axis 1. The
    # target is 9 m from axis 1 at the height -0.303 m; the shoulder is at the height 0.75 m.
    reach = 1.25 + np.hypot(1.5, 0.054)
    assert found.distance == pytest.approx(np.hypot(9 - 0.35, 0.75 + 0.303) - reach, abs=1e-9)
    assert "m out of reach" in repr(found)


@pytest.mark.parametrize("name", ["SCARA RRPR", "SCARA RRRP", "planar RRR"])
@pytest.mark.parametrize("degrees", [37, 180])
def test_tilted_target_of_a_scara_is_reported_as_tilted(name, degrees):
    rng = np.random.default_rng(3)
    arm = random_arm(rng, *STRUCTURES[name])
    T = forward_kinematics(arm, random_q(arm, 1, rng)[0])
    # All axes are parallel to z_0. Tilt the tool about the base's x axis, at the same point.
    T[:3, :3] = Rotation.from_euler("x", degrees, degrees=True).as_matrix() @ T[:3, :3]
    found = solutions(arm, T)
    assert not found.valid.any()
    assert np.isnan(found.distance)
    assert f"no solution, the target tilts the tool by {degrees}°" in repr(found)
    assert "out of reach" not in repr(found)


@pytest.mark.parametrize(
    "name",
    [
        "planar RR",
        "position RRR, axes 1 and 2 meet",
        "position RRR, axes 2 and 3 parallel",
    ],
)
def test_distance_out_of_reach_is_the_shortest(name):
    """Of 40 000 random poses none is nearer, and the nearest is about as near."""
    rng = np.random.default_rng(15)
    for _ in range(4):
        arm = random_arm(rng, *STRUCTURES[name])
        tips = forward_kinematics(arm, random_q(arm, 40_000, rng))[:, :3, 3]
        targets = tips[:10] * rng.uniform(0.02, 3, (10, 1))
        distances = solutions(arm, targets).distance
        for target, distance in zip(targets, distances, strict=True):
            nearest = np.linalg.norm(tips - target, axis=-1).min()
            assert distance - 1e-9 < nearest < distance + 0.06


def test_solutions_refuses_an_arm_without_structure():
    with pytest.raises(
        ArmError, match=r"no structure with a closed form.*use helpers\.inverse\.solve"
    ):
        solutions(PANDA.lock(3), np.eye(4))


def test_ur_keeps_joint_1_if_axis_meets_wrist():
    """Without d_4 and d_5 an upright arm has its wrist on axis 1, so joint 1 may have any value."""
    arm = UR10E.with_values(d_4=0.0, d_5=0.0)
    T = forward_kinematics(arm, [0.4, -HALF, 0.0, 0.3, 0.8, 0.2])
    found = ur(arm, T, start=[0.9, 0, 0, 0, 0, 0])
    assert found.free[found.valid][:, 0].all()
    np.testing.assert_allclose(found.q[found.valid][:, 0], 0.9)
    assert_valid(arm, found, T)


@needs_node
@pytest.mark.parametrize("name", STRUCTURES)
def test_page_solutions_equal_python(name):
    rng = np.random.default_rng(13)
    for _ in range(4):
        arm = random_arm(rng, *STRUCTURES[name])
        q = random_q(arm, 10, rng)
        asked = {"job": "solutions", "arm": arm_data(arm), "qs": q.tolist()}
        answers = ask_node("explorer_numbers.mjs", asked)
        for target, branches in zip(targets_of(arm, q, name), answers, strict=True):
            known = solutions(arm, target).by_name
            assert [branch["name"] for branch in branches] == list(known), (name, arm)
            theirs = np.array([branch["q"] for branch in branches])
            assert joint_difference(arm, np.array(list(known.values())), theirs).max() < 1e-7


def test_seven_joint_arm_is_refused_with_advice_to_lock_one():
    with pytest.raises(ArmError, match=r"7 joints, more than the six .* arm.lock\(3\)"):
        solutions(PANDA, forward_kinematics(PANDA, PANDA.home))


def test_solutions_of_one_target_are_a_sequence_of_configurations():
    T = forward_kinematics(UR10E, [0.3, -0.6, 1.2, 0.4, 0.7, -0.2])
    found = solutions(UR10E, T)
    assert len(found) == len([*found]) == len(found.names) == 8
    for name, q in zip(found.names, found, strict=True):
        np.testing.assert_allclose(forward_kinematics(UR10E, q), T, atol=1e-9)
        np.testing.assert_array_equal(q, found.by_name[name])
    np.testing.assert_array_equal(found[0], next(iter(found)))
    np.testing.assert_array_equal(found[-2:], [*found][-2:])
    assert len(solutions(UR10E, T + np.pad([[5.0]], ((0, 3), (3, 0))))) == 0


def test_solutions_of_many_targets_are_a_sequence_of_solutions():
    T = forward_kinematics(PANDA.lock(3), np.zeros((2, 3, 6)) + 0.4)
    many = solutions(UR10E, T)
    assert (len(many), len(many[1]), [*map(len, many[1])]) == (2, 3, [*map(len, [*many][1])])
    alone = solutions(UR10E, T[1, 2])
    np.testing.assert_array_equal(many[1][2].q, alone.q)
    assert many[1][2].names == alone.names
