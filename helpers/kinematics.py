"""Compute frames, forward kinematics and Jacobians in numbers, for one pose or a batch of poses.

All functions run recursions over the links that are written for one pose, on components, and
recorded once for each arm (see `helpers.program`). A single pose then takes microseconds, and a
batch runs in contiguous rows, in chunks that stay in the processor's cache.
"""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import (
    ArmError,
    finite_array,
    finite_number,
    require_choice,
    require_type,
    whole_number,
)
from helpers.program import RowMotion, Value, run_recursion
from helpers.rows import NumericRow

__all__ = [
    "forward_kinematics",
    "jacobian",
    "jacobian_in_frame",
    "link_frames",
    "lost_directions",
    "manipulability",
    "planar_jacobian",
    "tip",
]

Array = NDArray[np.float64]
Vector = Sequence[Value]


def link_frames(arm: Arm, q: ArrayLike) -> Array:
    """Compute the transforms T_00 .. T_0n from the base to each link frame.

    Args:
        arm: The arm, with n rows.
        q: Joint values, shape (..., dof), in rad or m.

    Returns:
        Transforms, shape (..., rows + 1, 4, 4).

    Raises:
        ArmError: q has another length, or holds NaN or infinity.

    Example:
        >>> from helpers.robots import ELBOW
        >>> link_frames(ELBOW, [0, 0, 0])[:, :3, 3]
        array([[0. , 0. , 0. ],
               [0. , 0. , 0.5],
               [0.4, 0. , 0.5],
               [0.7, 0. , 0.5]])

    Source: Spong, Hutchinson and Vidyasagar, section 3.1.
    """
    require_type(arm, Arm, "arm")
    return run_recursion(arm, q, _frame_entries, (len(arm.rows) + 1, 4, 4))


def forward_kinematics(arm: Arm, q: ArrayLike) -> Array:
    """Compute the tip's pose T_0n in the base frame.

    Args:
        arm: The arm.
        q: Joint values, shape (..., dof), in rad or m.

    Returns:
        Poses, shape (..., 4, 4).

    Example:
        >>> from helpers.robots import ELBOW
        >>> forward_kinematics(ELBOW, [0, 0, 0])
        array([[ 1. ,  0. ,  0. ,  0.7],
               [ 0. ,  0. , -1. ,  0. ],
               [ 0. ,  1. ,  0. ,  0.5],
               [ 0. ,  0. ,  0. ,  1. ]])
    """
    require_type(arm, Arm, "arm")
    return run_recursion(arm, q, tip_entries, (4, 4))


def tip(arm: Arm, q: ArrayLike) -> Array:
    """Compute the tip's position in the base frame.

    Args:
        arm: The arm.
        q: Joint values, shape (..., dof), in rad or m.

    Returns:
        Positions, shape (..., 3), in m.

    Example:
        >>> from helpers.robots import ELBOW
        >>> tip(ELBOW, [[0, 0, 0], [0.3, 0.5, -0.2]]).round(3)
        array([[0.7  , 0.   , 0.5  ],
               [0.609, 0.188, 0.78 ]])
    """
    return forward_kinematics(arm, q)[..., :3, 3]


def jacobian(arm: Arm, q: ArrayLike) -> Array:
    """Compute the tip's geometric Jacobian in the base frame.

    The column of a revolute joint i is z_{i-1} x (o_n - o_{i-1}) over z_{i-1}, that of a prismatic
    joint z_{i-1} over 0.

    Args:
        arm: The arm.
        q: Joint values, shape (..., dof), in rad or m.

    Returns:
        Jacobians, shape (..., 6, dof), with rows (vx, vy, vz, wx, wy, wz).

    Example:
        >>> from helpers.robots import ELBOW
        >>> jacobian(ELBOW, [0, 0, 0])
        array([[ 0. ,  0. ,  0. ],
               [ 0.7,  0. ,  0. ],
               [ 0. ,  0.7,  0.3],
               [ 0. ,  0. ,  0. ],
               [ 0. , -1. , -1. ],
               [ 1. ,  0. ,  0. ]])

    Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    require_type(arm, Arm, "arm")
    return run_recursion(arm, q, jacobian_entries, (6, arm.dof))


def jacobian_in_frame(arm: Arm, q: ArrayLike, frame: int) -> Array:
    """Compute the tip's Jacobian with its rows in the axes of a link frame.

    The point whose velocity it gives is still the tip.

    Args:
        arm: The arm, with n rows.
        q: Joint values, shape (..., dof), in rad or m.
        frame: Index of the frame: 0 is the base, n the tool.

    Returns:
        Jacobians, shape (..., 6, dof).

    Raises:
        ArmError: The frame does not exist.

    Example:
        >>> from helpers.robots import ELBOW
        >>> jacobian_in_frame(ELBOW, [0.3, 0.5, -0.2], frame=3)[:3].round(3) + 0.0
        array([[ 0.   , -0.079,  0.   ],
               [ 0.   ,  0.692,  0.3  ],
               [-0.638,  0.   ,  0.   ]])
    """
    require_type(arm, Arm, "arm")
    if whole_number(frame, "frame") > len(arm.rows):
        raise ArmError(f"{arm.name}: frame {frame!r} does not exist; expected 0 to {len(arm.rows)}")
    R = link_frames(arm, q)[..., frame, :3, :3]
    J = jacobian(arm, q)
    return np.concatenate(
        [np.swapaxes(R, -1, -2) @ half for half in (J[..., :3, :], J[..., 3:, :])], axis=-2
    )


def planar_jacobian(arm: Arm, q: ArrayLike) -> Array:
    """Compute the tip's Jacobian of an arm that moves in one plane of the base.

    The rows are those of (x, y, phi): the tip's velocity along the plane's two axes and the angular
    velocity about the third. The other three rows of `jacobian` are 0. In the plane of x and z the
    rows are (x, z, phi), in that of y and z (y, z, phi).

    Args:
        arm: The arm.
        q: Joint values, shape (..., dof), in rad or m.

    Returns:
        Jacobians, shape (..., 3, dof).

    Raises:
        ArmError: The arm does not move in such a plane.

    Example:
        >>> from helpers.robots import TWO_LINK
        >>> planar_jacobian(TWO_LINK, [0, 0])
        array([[0. , 0. ],
               [0.9, 0.4],
               [1. , 1. ]])

    Source: Siciliano et al., section 3.1.3.
    """
    require_type(arm, Arm, "arm")
    return jacobian(arm, q)[..., _plane_rows(arm), :]


# Rows of the motions in each plane of the base: two of the velocity, one of the angular velocity.
_PLANES = ([0, 1, 5], [0, 2, 4], [1, 2, 3])


def _plane_rows(arm: Arm) -> list[int]:
    """Return the rows of the Jacobian that a planar arm has."""
    generic_poses = np.random.default_rng(3).uniform(-1, 1, (2, arm.dof))
    sizes = np.abs(jacobian(arm, generic_poses)).max(axis=(0, 2), initial=0)
    # 1e-12 m or rad: some 1000 times the round-off of a row that is 0 at every pose.
    moving = np.flatnonzero(sizes > 1e-12).tolist()
    if moving not in _PLANES:
        raise ArmError(
            f"{arm.name} does not move in one plane of the base; expected joints that turn about"
            " one axis of the base or slide across it"
        )
    return moving


def manipulability(arm: Arm, q: ArrayLike, part: str = "all") -> Array:
    """Compute Yoshikawa's measure, the product of the Jacobian's singular values.

    The measure is 0 at a singular pose. With as many rows as joints it is the absolute value of
    det J; with fewer joints than rows it is the volume sqrt(det J^T J) of the velocities that the
    joints can give. The unit of "all" mixes m and rad, so compare it only between poses of one arm.

    Args:
        arm: The arm.
        q: Joint values, shape (..., dof), in rad or m.
        part: Rows of the Jacobian: "all", "linear" (vx, vy, vz) or "angular" (wx, wy, wz).

    Returns:
        Measures, shape (...).

    Example:
        >>> from helpers.robots import ELBOW
        >>> manipulability(ELBOW, [[0, 0, 0], [0, 0, 1.2]], part="linear").round(4)
        array([0.    , 0.0569])

    Source: Yoshikawa (1985).
    """
    rows = {"all": [0, 1, 2, 3, 4, 5], "linear": [0, 1, 2], "angular": [3, 4, 5]}
    chosen = rows[require_choice(part, "part", rows)]
    return np.linalg.svd(jacobian(arm, q)[..., chosen, :], compute_uv=False).prod(axis=-1)


def lost_directions(J: ArrayLike, cutoff: float = 1e-9) -> Array:
    """Find the velocities that no joint motion can give.

    They are the left singular vectors of singular values that are not above the cutoff.

    Args:
        J: One Jacobian, shape (rows, joints).
        cutoff: Share of the largest singular value up to which a singular value counts as 0.

    Returns:
        Orthonormal vectors, shape (lost, rows).

    Example:
        >>> lost_directions([[1.0, 0.0], [0.0, 0.0]])
        array([[0., 1.]])
    """
    J = finite_array(J, "J", "one matrix of finite numbers", (None, None))
    cutoff = finite_number(cutoff, "cutoff", "a number of 0 or more", least=0)
    U, sizes, _ = np.linalg.svd(J, full_matrices=True)
    return U.T[(sizes > cutoff * sizes.max(initial=0.0)).sum() :]


def skeleton(arm: Arm, T: Array) -> Array:
    """Return the points of the broken line that the table's lengths draw.

    Args:
        arm: The arm.
        T: Link frames at one pose, shape (rows + 1, 4, 4).

    Returns:
        The points o_0, o_0 + d_1 z_0, o_1, o_1 + d_2 z_1, ..., shape (2 rows + 1, 3), in m.
    """
    points = [T[0, :3, 3]]
    for row, frame in zip(arm.numeric, T[1:], strict=True):
        points += [frame[:3, 3] - row.a * frame[:3, 0], frame[:3, 3]]
    return np.array(points)


# Recursions over the links, as `helpers.program` records them


_BASE_COLUMNS: tuple[Vector, ...] = (
    (1.0, 0.0, 0.0),
    (0.0, 1.0, 0.0),
    (0.0, 0.0, 1.0),
    (0.0, 0.0, 0.0),
)


def frame_columns(motions: Sequence[RowMotion]) -> Iterator[tuple[Vector, Vector, Vector, Vector]]:
    """Yield the columns (x, y, z, origin) of each link frame, from the base to the tip."""
    x, y, z, origin = _BASE_COLUMNS
    yield x, y, z, origin
    for row, c, s, d in motions:
        x, y = linear_combination(c, x, s, y), linear_combination(c, y, -s, x)
        step = linear_combination(d, z, row.a, x)
        origin = linear_combination(1.0, origin, 1.0, step)
        y, z = rotate_about_x(row, y, z)
        yield x, y, z, origin


def rotate_about_x(row: NumericRow, y: Vector, z: Vector) -> tuple[Vector, Vector]:
    """Return the y and z axes after the row's rotation by alpha about x."""
    c, s = row.cos_alpha, row.sin_alpha
    return linear_combination(c, y, s, z), linear_combination(c, z, -s, y)


def linear_combination(a: Value, u: Vector, b: Value, v: Vector) -> Vector:
    """Compute a u + b v."""
    return tuple(a * x + b * y for x, y in zip(u, v, strict=True))


def cross_product(u: Vector, v: Vector) -> Vector:
    """Compute u x v."""
    return tuple(u[j] * v[k] - u[k] * v[j] for j, k in ((1, 2), (2, 0), (0, 1)))


def _frame_entries(arm: Arm, motions: Sequence[RowMotion]) -> Sequence[Value]:
    return [x for frame in frame_columns(motions) for x in _matrix_entries(frame)]


def tip_entries(arm: Arm, motions: Sequence[RowMotion]) -> Sequence[Value]:
    """Compute the 16 entries of the tip's pose, row by row."""
    *_, frame = frame_columns(motions)
    return _matrix_entries(frame)


def _matrix_entries(frame: tuple[Vector, Vector, Vector, Vector]) -> list[Value]:
    return [x for line in zip(*frame, strict=True) for x in line] + [0.0, 0.0, 0.0, 1.0]


def jacobian_entries(arm: Arm, motions: Sequence[RowMotion]) -> Sequence[Value]:
    """Compute the 6 dof entries of the Jacobian, row by row."""
    frames = list(frame_columns(motions))
    tip_origin, columns = frames[-1][3], []
    for i in arm.joints:
        _, _, z, origin = frames[i - 1]
        if arm.numeric[i - 1].kind == "revolute":
            lever = linear_combination(1.0, tip_origin, -1.0, origin)
            columns.append((*cross_product(z, lever), *z))
        else:
            columns.append((*z, 0.0, 0.0, 0.0))
    return [x for line in zip(*columns, strict=True) for x in line]
