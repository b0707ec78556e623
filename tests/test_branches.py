"""Test that valid branches reach their pose at 22 500 configurations at and around all boundaries.

Link matrices and Jacobians are computed here, without `helpers`.
"""

import numpy as np
import pytest

from helpers import inverse
from helpers.arm import Arm, revolute
from helpers.robots import ELBOW, STANFORD, UR10E, UR10E_HOMEWORK
from tests.laws import joint_difference

ROD = Arm("rod", STANFORD.rows[:3], STANFORD.values)
WRIST = Arm(
    "elbow arm with a wrist",
    (
        *ELBOW.rows[:2],
        revolute(alpha="pi/2"),
        revolute(alpha="-pi/2", d=0.3),
        revolute(alpha="pi/2"),
        revolute(d=0.1),
    ),
    ELBOW.with_values(d=0.1).values,
)
CASES = [
    pytest.param(form, arm, id=f"{form.__name__} {arm.name} {i}")
    for i, (form, arm) in enumerate(
        [
            (inverse.elbow, ELBOW),
            (inverse.elbow, ELBOW.with_values(d=0.12)),
            (inverse.rod, ROD),
            (inverse.rod, ROD.with_values(d_2=0)),
            (inverse.stanford, STANFORD),
            (inverse.stanford, STANFORD.with_values(d_2=0)),
            (inverse.spherical_wrist, WRIST),
            (inverse.ur, UR10E),
            (inverse.ur, UR10E_HOMEWORK),
        ]
    )
]


def poses(arm, q):
    """Return the tip poses (n, 4, 4) at q (n, dof), link by link."""
    T = np.tile(np.eye(4), (len(q), 1, 1))
    for row, x in zip(arm.numeric, q.T, strict=True):
        theta = row.theta + x * (row.kind == "revolute")
        d = row.d + x * (row.kind == "prismatic")
        A = np.zeros_like(T)
        c, s, ca, sa = np.cos(theta), np.sin(theta), row.cos_alpha, row.sin_alpha
        A[:, 0] = np.stack([c, -s * ca, s * sa, row.a * c], axis=1)
        A[:, 1] = np.stack([s, c * ca, -c * sa, row.a * s], axis=1)
        A[:, 2, 1], A[:, 2, 2], A[:, 2, 3], A[:, 3, 3] = sa, ca, d, 1
        T = T @ A
    return T


def jacobians(arm, q, h=1e-6):
    """Return Jacobians (n, 6, dof) by central differences."""
    T, columns = poses(arm, q), []
    for step in h * np.eye(arm.dof):
        rate = (poses(arm, q + step) - poses(arm, q - step)) / (2 * h)
        skew = rate[:, :3, :3] @ T[:, :3, :3].transpose(0, 2, 1)
        turn = np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1)
        columns.append(np.hstack([rate[:, :3, 3], turn]))
    return np.stack(columns, axis=-1)


def at_boundaries(arm, n, rng):
    """Return joints at 0, 90°, -90° and 180°, moved by 10^-6 to 10^-16; slides near 0 too."""
    q = rng.uniform(-np.pi, np.pi, (n, arm.dof))
    off = rng.choice([-1, 0, 1], q.shape) * 10.0 ** -rng.integers(6, 17, q.shape)
    special = rng.choice([0, np.pi / 2, -np.pi / 2, np.pi], q.shape) + off
    q = np.where(rng.random(q.shape) < 0.7, special, q)
    near_0 = rng.choice([-1, 0, 1], n) * 10.0 ** -rng.integers(1, 17, n)
    slides = ~arm.turning
    q[:, slides] = np.where(rng.random(n) < 0.5, near_0, rng.uniform(-1, 1, n))[:, None]
    return q


def solve_poses(form, arm, q, **start):
    """Return the solutions for the targets of q, and a function that gives the target of a pose.

    The target is the whole pose for an arm of six joints, and the position for other arms.
    """
    T = poses(arm, q)
    asked = T if arm.dof == 6 else T[:, :3, 3]
    return form(arm, asked, **start), (lambda T: T) if arm.dof == 6 else (lambda T: T[:, :3, 3])


@pytest.mark.parametrize(("form", "arm"), CASES)
def test_valid_solutions_reach_and_contain_the_pose(form, arm):
    q = at_boundaries(arm, 2500, np.random.default_rng(1))
    found, asked = solve_poses(form, arm, q, start=q)
    n, branch = np.nonzero(found.valid)
    assert set(n) == set(range(len(q))), "a pose without a branch"
    miss = asked(poses(arm, found.q[n, branch])) - asked(poses(arm, q[n]))
    assert np.abs(miss).max() < 1e-9
    nearest = np.full(len(q), np.inf)
    np.minimum.at(nearest, n, joint_difference(arm, found.q[n, branch], q[n]))
    # Branches coincide if the tip moves by less than 1e-10 between them, a tenth of the tolerance.
    rows = slice(None) if arm.dof == 6 else slice(3)
    lost = nearest > 1e-6
    weakest = np.linalg.svd(jacobians(arm, q[lost])[:, rows], compute_uv=False)[:, -1]
    assert (nearest[lost] * weakest).max(initial=0.0) < 1e-10


def test_distance_out_of_reach_is_known_for_every_arm():
    """The offset arm's distances are compared with a fine grid of points within reach.

    A UR pose that is moved by 1.1 times its distance must be within reach.
    """
    rng, arm = np.random.default_rng(3), ELBOW.with_values(d=0.12)
    grid = np.stack(np.meshgrid(*[np.linspace(-np.pi, np.pi, 500)] * 2), axis=-1).reshape(-1, 2)
    T = poses(arm, np.insert(grid, 0, 0, axis=1))
    reach = np.stack([np.hypot(T[:, 0, 3], T[:, 1, 3]), T[:, 2, 3]], axis=1)
    places = rng.uniform([-0.9, -0.9, -0.5], [0.9, 0.9, 1.5], (60, 3))
    for place, distance in zip(places, inverse.elbow(arm, places).distance, strict=True):
        beside = np.hypot(*place[:2]), place[2]
        assert abs(np.linalg.norm(reach - beside, axis=1).min() - distance) < 6e-3
    T = poses(UR10E, rng.uniform(-3, 3, (40, 6)))
    T[:, :3, 3] *= rng.uniform(0.1, 1.8, (40, 1))
    found = inverse.ur(UR10E, T)
    assert ((found.distance > 0) == ~found.valid.any(axis=1)).all()
    directions = rng.normal(size=(2000, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    for pose, distance in zip(T, found.distance, strict=True):
        moved = np.tile(pose, (len(directions), 1, 1))
        moved[:, :3, 3] += 1.1 * distance * directions
        assert inverse.ur(UR10E, moved).valid.any()


def test_solutions_print_as_table_of_named_branches():
    one = inverse.elbow(ELBOW, (0.5, 0.0, 0.5))
    assert repr(one).splitlines()[0] == "Elbow arm, solution, q_1, q_2, q_3:"
    assert repr(one).splitlines()[1].startswith("  front, elbow up, 0.0000, 0.")
    assert one._repr_markdown_().startswith("| solution | $q_1$ | $q_2$ | $q_3$ |\n| :-- | --: ")
    assert "any" in repr(inverse.elbow(ELBOW, (0.0, 0.0, 0.95)))
    assert repr(inverse.elbow(ELBOW, (1.0, 0.0, 0.5))).endswith("is 0.3 m out of reach")
    many = inverse.elbow(ELBOW, [(0.5, 0.0, 0.5), (1.0, 0.0, 0.5)])
    assert repr(many) == "Elbow arm: 1 of 2 targets within reach"
    assert repr(inverse.solve(ELBOW, (1.0, 0.0, 0.5))).startswith(
        "not reached from 21 starts, 0.3 m and 0 rad off; try restarts=105: q = "
    )
    limited = ELBOW.with_row(1, limits=(-3, 3))
    assert repr(inverse.solve(limited, [(1.0, 0.0, 0.5)], restarts=0)).endswith(
        "0.3 m and 0 rad off, from 1 start within the limits; try restarts=20, or limits=False"
    )
    assert repr(inverse.solve(ELBOW, (0.5, 0.0, 0.5))).startswith("reached in ")
    found = inverse.solve(ELBOW, (0.5, 0.0, 0.5))._repr_markdown_().splitlines()
    assert found[:2] == ["| result | $q_1$ | $q_2$ | $q_3$ |", "| :-- | --: | --: | --: |"]
    assert found[2].startswith("| reached in ")
