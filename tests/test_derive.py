"""Test tables derived from joint axes against the product of exponentials.

The product of exponentials uses no DH table.
"""

import math
from itertools import pairwise

import numpy as np
import pytest

from helpers.arm import Joint, revolute
from helpers.conventions import modified_from_standard
from helpers.derive import Axis, derive
from helpers.kinematics import forward_kinematics, link_frames
from helpers.statics import gravity_torque
from tests.laws import central_differences

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
RIGHT = math.pi / 2

PANDA = [  # axes in the zero configuration of the maker's table
    Axis((0, 0, 0), Z),
    Axis((0, 0, 0.333), Y),
    Axis((0, 0, 0), Z),
    Axis((0.0825, 0, 0.649), (0, -1, 0)),
    Axis((0, 0, 0), Z),
    Axis((0, 0, 1.033), (0, -1, 0)),
    Axis((0.088, 0, 0), (0, 0, -1)),
]
PANDA_FLANGE = np.array([[1, 0, 0, 0.088], [0, -1, 0, 0], [0, 0, -1, 0.926], [0, 0, 0, 1]])


def numeric_rows(arm):
    """Return (a, alpha, d, theta) of each row as numbers."""
    return [[arm.number(e) for e in (row.a, row.alpha, row.d, row.theta)] for row in arm.rows]


def joint_motion(axis, q):
    """Return the 4x4 matrix exponential of a joint's twist times q."""
    z, p, T = np.array(axis.direction), np.array(axis.point), np.eye(4)
    if axis.joint.kind == "prismatic":
        T[:3, 3] = q * z
        return T
    K = np.array([[0, -z[2], z[1]], [z[2], 0, -z[0]], [-z[1], z[0], 0]])
    T[:3, :3] = np.eye(3) + math.sin(q) * K + (1 - math.cos(q)) * K @ K
    T[:3, 3] = p - T[:3, :3] @ p
    return T


def tip_by_exponentials(axes, tip, q):
    """Return the tip's pose: the product of all joint motions and the pose at q = 0."""
    T = np.eye(4)
    for axis, value in zip(axes, q, strict=True):
        T = T @ joint_motion(axis, value)
    return T @ tip


def random_pose(rng):
    R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R * np.linalg.det(R), rng.normal(size=3)
    return T


def random_axes(rng, n):
    """Return n axes, each skew, meeting, parallel, collinear or perpendicular to the one before."""
    axes = [Axis(tuple(rng.normal(size=3)), tuple(rng.normal(size=3)))]
    while len(axes) < n:
        p, z = np.array(axes[-1].point), np.array(axes[-1].direction)
        kind = rng.integers(5)
        if kind == 0:
            p, z = rng.normal(size=3), rng.normal(size=3)
        elif kind == 1:
            p, z = p + rng.normal() * z, rng.normal(size=3)
        elif kind == 2:
            p, z = rng.normal(size=3), z * rng.choice([-1, 1])
        elif kind == 3:
            p, z = p + rng.normal() * z, z * rng.choice([-1, 1])
        else:
            across = np.cross(z, rng.normal(size=3))
            p, z = rng.normal(size=3), across
        axes.append(Axis(tuple(p), tuple(z), rng.choice(["revolute", "revolute", "prismatic"])))
    return axes


@pytest.mark.parametrize("negative", [False, True])
@pytest.mark.parametrize("seed", range(60))
def test_derived_arm_matches_product_of_exponentials(seed, negative):
    rng = np.random.default_rng(seed)
    axes, tip = random_axes(rng, rng.integers(1, 8)), random_pose(rng)
    found = derive(axes, tip, negative=negative)
    configurations = rng.uniform(-3, 3, (5, len(axes)))
    theirs = [tip_by_exponentials(axes, tip, q) for q in configurations]
    np.testing.assert_allclose(forward_kinematics(found.arm, configurations), theirs, atol=1e-10)
    assert len(axes) <= len(found.arm.rows) <= len(axes) + 2


@pytest.mark.parametrize("seed", range(20))
def test_derivation_steps_agree_with_frames_and_normals(seed):
    """Frames, feet of the normals and the four numbers of each step must agree."""
    rng = np.random.default_rng(seed)
    found = derive(random_axes(rng, 6), random_pose(rng))
    frames = link_frames(found.arm, np.zeros(6))
    np.testing.assert_allclose(found.frames, frames, atol=1e-9)
    for step, (before, after) in zip(found.steps, pairwise(frames), strict=True):
        start, end = step.normal
        for frame, foot in ((before, start), (after, end)):
            np.testing.assert_allclose(np.cross(foot - frame[:3, 3], frame[:3, 2]), 0, atol=1e-8)
        np.testing.assert_allclose((end - start) @ before[:3, 2], 0, atol=1e-8)
        np.testing.assert_allclose((end - start) @ after[:3, 2], 0, atol=1e-8)
        np.testing.assert_allclose(end - start, step.a * after[:3, 0], atol=1e-8)
        assert step.a >= 0
        assert (step.case in ("skew", "parallel")) == (step.a > 0)
        assert -math.pi < step.theta <= math.pi
        assert -math.pi < step.alpha <= math.pi


def test_panda_axes_give_the_makers_table():
    """The published table is a modified one, and has a_4 = -0.0825."""
    found = derive(PANDA, PANDA_FLANGE, negative=True)
    table = [
        revolute(d="d_1"),
        revolute(alpha="-pi/2"),
        revolute(alpha="pi/2", d="d_3"),
        revolute(a="a_3", alpha="pi/2"),
        revolute(a="-a_4", alpha="-pi/2", d="d_5"),
        revolute(alpha="pi/2"),
        revolute(a="a_6", alpha="pi/2", d="d_7"),
    ]
    assert list(modified_from_standard(found.arm.rows)) == table
    lengths = dict(d_1=0.333, d_3=0.316, a_3=0.0825, a_4=0.0825, d_5=0.384, a_6=0.088, d_7=0.107)
    assert dict(found.arm.values) == lengths
    assert found.arm.source == "derived from its joint axes"


def test_tip_given_as_point_keeps_z_direction():
    """A point has no axes, so the last frame keeps its z axis."""
    found = derive([Axis((0, 0, 0), Z), Axis((0.4, 0, 0), Z)], (0.4, 0.3, 0))
    assert numeric_rows(found.arm) == [[0.4, 0, 0, 0], [0.3, 0, 0, RIGHT]]
    on_axis = derive([Axis((0, 0, 0), Z)], (0, 0, 0.5))
    assert numeric_rows(on_axis.arm) == [[0, 0, 0.5, 0]]
    nearly = derive([Axis((0, 0, 0), (0, 0, 1e100)), Axis((0, 0, 5e-10), Y)], (0.3, 0, 0))
    assert numeric_rows(nearly.arm) == [[0, -RIGHT, 0, 0], [0.3, 0, 0, 0]]


def test_turned_tip_adds_a_fixed_row():
    found = derive(
        [Axis((0, 0, 0), Z)], [[0, -1, 0, 1], [1, 0, 0, 0], [0, 0, 1, 0.2], [0, 0, 0, 1]]
    )
    assert numeric_rows(found.arm) == [[1, 0, 0.2, 0], [0, 0, 0, RIGHT]]
    assert found.arm.rows[1].joint.kind == "fixed"
    assert (found.steps[1].case, found.steps[1].opposite) == ("coincident", False)


def test_slide_without_point_passes_through_next_axis():
    slide, turn = Axis(None, X, "prismatic"), Axis((0.4, 0.3, 0), Y)
    np.testing.assert_allclose(derive([slide, turn], np.eye(4)).lines[0].point, turn.point)
    found = derive([Axis((0, 0, 0), Z), Axis(None, X, "prismatic")], (0.5, 0, 0.2))
    np.testing.assert_allclose(forward_kinematics(found.arm, [0, 0])[:3, 3], (0.5, 0, 0.2))
    np.testing.assert_allclose(found.lines[1].point, (0.5, 0, 0.2))


def test_nearly_parallel_axes_warn_unless_tolerated():
    """A tilt of 1e-5 rad puts the common normal kilometres away, unless the tolerance is larger."""
    axes = [Axis((0, 0, 0), Z), Axis((0.3, 0.1, 0), (0, 1e-5, 1))]
    words = "a tolerance above 1e-05 takes them for parallel"
    with pytest.warns(UserWarning, match=f"^arm: z_0 and z_1 are .* {words}$"):
        exact = derive(axes, (0.5, 0, 0))
    flat = derive(axes, (0.5, 0, 0), tolerance=1e-4)
    assert exact.steps[0].d == pytest.approx(-1e4)
    assert flat.steps[0].d == 0
    z = [link_frames(found.arm, [0, 0])[1, :3, 2] for found in (exact, flat)]
    np.testing.assert_allclose(z, [(0, 1e-5, 1), (0, 0, 1)], atol=1e-9)


def test_rounded_right_angle_becomes_exact_if_tolerated():
    """Otherwise the angle becomes a symbol with the value that was typed."""
    axes = [Axis((0, 0, 0), Z), Axis((0, 0, 0.2), (0, -math.sin(1.5708), math.cos(1.5708)))]
    exact, taken = (derive(axes, (0, 1, 0.2), tolerance=t).arm for t in (1e-9, 1e-3))
    assert exact.rows[0].alpha == "alpha_1"
    assert dict(exact.values)["alpha_1"] == pytest.approx(1.5708, abs=1e-15)
    assert taken.rows[0].alpha == "pi/2"


def test_nearly_meeting_axes_intersect_within_tolerance():
    axes = [Axis((0, 0, 0), Z), Axis((0, 1e-10, 0.2), X)]
    assert derive(axes, (1, 0, 0.2)).steps[0].case == "intersecting"
    assert derive(axes, (1, 0, 0.2), tolerance=1e-11).steps[0].case == "skew"


def test_other_angles_become_symbols():
    found = derive([Axis((0, 0, 0), Z), Axis((0, 0, 1), (0, 1, 1))], (0, 1, 2))
    row = found.arm.rows[0]
    assert (row.alpha, row.theta) == ("-alpha_1", 0)
    assert found.arm.number(row.alpha) == pytest.approx(-math.pi / 4, abs=1e-15)


def test_joint_limits_are_kept():
    joint = Joint("prismatic", -1, 2, 0.5, 40)
    (row,) = derive([Axis((0, 0, 0), Z, joint)], np.eye(4)).arm.rows
    assert row.joint == joint


def test_derived_arm_with_masses_has_right_gravity_torque():
    """The torques are compared with the derivative of the potential energy of the drawing."""
    rng = np.random.default_rng(4)
    axes, tip = random_axes(rng, 5), random_pose(rng)
    masses, centres = rng.uniform(0, 3, 5), rng.normal(size=(5, 3))
    arm = derive(axes, tip).with_bodies(masses, centres)

    def energy(q):
        T, total = np.eye(4), 0.0
        for axis, value, mass, centre in zip(axes, q, masses, centres, strict=True):
            T = T @ joint_motion(axis, value)
            total += 9.81 * mass * (T @ [*centre, 1])[2]
        return total

    q = rng.uniform(-2, 2, 5)
    np.testing.assert_allclose(gravity_torque(arm, q), central_differences(energy, q), atol=1e-7)


def test_offset_base_adds_a_massless_row():
    arm = derive([Axis((1, 0, 0), X)], np.eye(4)).with_bodies([2.0], [[0, 0, 0.1]])
    kinds = [row.joint.kind for row in arm.rows]
    assert kinds == ["fixed", "revolute", "fixed"]
    assert arm.variables == ("q_2",)
    assert [body.mass for body in arm.bodies] == [0, 2.0, 0]
