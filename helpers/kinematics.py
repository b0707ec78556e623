"""Compute frames, forward kinematics and Jacobians in numbers, for one configuration or a batch.

All functions run recursions over the links that are written for one configuration, on components,
and recorded once for each arm (see `helpers.program`). A single configuration then takes
microseconds, and a batch runs in contiguous rows, in chunks that stay in the processor's cache.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.deprecated import deprecated_names
from helpers.inputs import (
    ArmError,
    finite_array,
    finite_number,
    float_array,
    require_choice,
    require_type,
    shorten,
)
from helpers.program import RowMotion, Value, run_recursion
from helpers.rows import NumericRow

__all__ = [
    "forward_kinematics",
    "jacobian",
    "link_frames",
    "lost_directions",
    "manipulability",
    "quaternion",
    "roll_pitch_yaw",
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


def jacobian(arm: Arm, q: ArrayLike, frame: int | str = "base") -> Array:
    """Compute the tip's geometric Jacobian.

    The column of a revolute joint i is z_{i-1} x (o_n - o_{i-1}) over z_{i-1}, that of a prismatic
    joint z_{i-1} over 0. It gives the velocity of the tip in the axes of any frame.

    Args:
        arm: The arm, with n rows.
        q: Configurations, shape (..., dof), in rad or m.
        frame: The frame in whose axes the rows are: "base", "tool", or the index of a link frame,
            of which 0 is the base and n the tool.

    Returns:
        Jacobians, shape (..., 6, dof), with rows (vx, vy, vz, wx, wy, wz).

    Raises:
        ArmError: The frame does not exist.

    Example:
        >>> from helpers.robots import ELBOW
        >>> jacobian(ELBOW, [0, 0, 0])
        array([[ 0. ,  0. ,  0. ],
               [ 0.7,  0. ,  0. ],
               [ 0. ,  0.7,  0.3],
               [ 0. ,  0. ,  0. ],
               [ 0. , -1. , -1. ],
               [ 1. ,  0. ,  0. ]])
        >>> jacobian(ELBOW, [0.3, 0.5, -0.2], frame="tool")[:3].round(3) + 0.0
        array([[ 0.   , -0.079,  0.   ],
               [ 0.   ,  0.692,  0.3  ],
               [-0.638,  0.   ,  0.   ]])

    Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    require_type(arm, Arm, "arm")
    J = run_recursion(arm, q, jacobian_entries, (6, arm.dof))
    if frame == "base":
        return J
    names: dict[object, int] = {"base": 0, "tool": len(arm.rows)}
    number = names.get(frame, frame) if isinstance(frame, str) else frame
    if isinstance(number, bool | str) or number not in range(len(arm.rows) + 1):
        raise ArmError(
            f'{arm.name}: frame is {shorten(frame)}; expected "base", "tool", or 0 to'
            f" {len(arm.rows)}"
        )
    R = np.swapaxes(link_frames(arm, q)[..., number, :3, :3], -1, -2)
    return np.concatenate([R @ half for half in (J[..., :3, :], J[..., 3:, :])], axis=-2)


_JACOBIAN_ROWS = {"all": [0, 1, 2, 3, 4, 5], "linear": [0, 1, 2], "angular": [3, 4, 5]}


def manipulability(arm: Arm, q: ArrayLike, part: str = "all") -> Array:
    """Compute Yoshikawa's measure, the product of the Jacobian's singular values.

    The measure is 0 at a singular configuration. With as many rows as joints it is the absolute
    value of det J; with fewer joints than rows it is the volume sqrt(det J^T J) of the velocities
    that the joints can give. The unit of "all" mixes m and rad, so compare it only between
    configurations of one arm.

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
    chosen = _JACOBIAN_ROWS[require_choice(part, "part", _JACOBIAN_ROWS)]
    return np.linalg.svd(jacobian(arm, q)[..., chosen, :], compute_uv=False).prod(axis=-1)


def lost_directions(
    arm: Arm | ArrayLike, q: ArrayLike | None = None, part: str = "all", *, cutoff: float = 1e-9
) -> Array:
    """Find the velocities that no joint motion can give.

    They are the left singular vectors of singular values that are not above the cutoff.

    Args:
        arm: The arm; or, without q, a Jacobian of your own, shape (rows, joints).
        q: One configuration, shape (dof,), in rad or m.
        part: Rows of the Jacobian: "all", "linear" (vx, vy, vz) or "angular" (wx, wy, wz).
        cutoff: Share of the largest singular value up to which a singular value counts as 0.

    Returns:
        Orthonormal vectors, shape (lost, rows).

    Example:
        >>> from helpers.robots import ELBOW
        >>> lost_directions(ELBOW, [0, 0, 0], "linear") + 0.0
        array([[1., 0., 0.]])
        >>> lost_directions([[1.0, 0.0], [0.0, 0.0]])
        array([[0., 1.]])
    """
    if isinstance(arm, Arm):
        configuration = arm.joint_vector([] if q is None else q, many=False)
        J = jacobian(arm, configuration)[
            _JACOBIAN_ROWS[require_choice(part, "part", _JACOBIAN_ROWS)]
        ]
    else:
        expected = "an Arm and q, or one matrix of finite numbers"
        J = finite_array(arm, "arm", expected, (None, None))
    cutoff = finite_number(cutoff, "cutoff", "a number of 0 or more", least=0)
    U, sizes, _ = np.linalg.svd(J, full_matrices=True)
    return U.T[(sizes > cutoff * sizes.max(initial=0.0)).sum() :]


def roll_pitch_yaw(T: ArrayLike) -> Array:
    """Compute the angles of R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).

    Where pitch is a right angle, only a sum or a difference of the others is fixed; roll is then 0.

    Args:
        T: Poses, shape (..., 4, 4), or rotations, shape (..., 3, 3).

    Returns:
        Roll, pitch and yaw, shape (..., 3), in rad.

    Example:
        >>> from helpers.robots import ELBOW
        >>> roll_pitch_yaw(forward_kinematics(ELBOW, [0.2, 0, 0])).round(4) + 0.0
        array([1.5708, 0.    , 0.2   ])
    """
    R = _rotations(T)
    level = np.hypot(R[..., 0, 0], R[..., 1, 0])
    upright = level < 1e-9  # 1e7 times the round-off of a cosine
    roll = np.where(upright, 0.0, np.arctan2(R[..., 2, 1], R[..., 2, 2]))
    yaw_if_upright = np.arctan2(-R[..., 0, 1], R[..., 1, 1])
    yaw = np.where(upright, yaw_if_upright, np.arctan2(R[..., 1, 0], R[..., 0, 0]))
    return np.stack([roll, np.arctan2(-R[..., 2, 0], level), yaw], axis=-1)


def quaternion(T: ArrayLike) -> Array:
    """Compute the unit quaternions (w, x, y, z) of poses, with w >= 0.

    ROS, SciPy and Pinocchio write (x, y, z, w): that is ``np.roll(quaternion(T), -1, axis=-1)``.

    Args:
        T: Poses, shape (..., 4, 4), or rotations, shape (..., 3, 3).

    Returns:
        Quaternions, shape (..., 4).

    Example:
        >>> quaternion([[0, -1, 0], [1, 0, 0], [0, 0, 1]]).round(4)
        array([0.7071, 0.    , 0.    , 0.7071])
    """
    R = _rotations(T)
    # Each row is 4 w, 4 x, 4 y or 4 z times the quaternion. The longest row is the most accurate.
    w = np.trace(R, axis1=-2, axis2=-1)[..., None, None]
    products = np.empty((*R.shape[:-2], 4, 4))
    products[..., 1:, 1:] = R + np.swapaxes(R, -1, -2) + (1 - w) * np.eye(3)
    products[..., 0, 0] = 1 + w[..., 0, 0]
    for i, (j, k) in enumerate(((2, 1), (0, 2), (1, 0)), 1):
        products[..., 0, i] = products[..., i, 0] = R[..., j, k] - R[..., k, j]
    lengths = np.linalg.norm(products, axis=-1)
    longest = lengths.argmax(axis=-1)[..., None]
    row = np.take_along_axis(products, longest[..., None], axis=-2)[..., 0, :]
    row = row / np.take_along_axis(lengths, longest, axis=-1)
    return np.where(row[..., :1] < 0, -row, row)


def _rotations(T: ArrayLike) -> Array:
    expected = "poses (..., 4, 4) or rotations (..., 3, 3)"
    T = float_array(T, "T", expected)
    size = T.shape[-1] if T.ndim and T.shape[-1] in (3, 4) else 4
    T = finite_array(T, "T", expected, (size, size), many=True)
    return T[..., :3, :3]


def skeleton(arm: Arm, T: Array) -> Array:
    """Return the points of the broken line given by the table's lengths.

    Args:
        arm: The arm.
        T: Link frames at one configuration, shape (rows + 1, 4, 4).

    Returns:
        The points o_0, o_0 + d_1 z_0, o_1, o_1 + d_2 z_1, ..., shape (2 rows + 1, 3), in m.
    """
    points = [T[0, :3, 3]]
    for row, frame in zip(arm.numeric, T[1:], strict=True):
        points += [frame[:3, 3] - row.a * frame[:3, 0], frame[:3, 3]]
    return np.array(points)


# Recursions over the links, which `helpers.program` records


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


__getattr__ = deprecated_names(__name__, jacobian_in_frame="jacobian")
