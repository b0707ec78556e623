"""The numeric view: frames, forward kinematics and Jacobians of whole batches of joint vectors.

One recursion over the links serves everything. It works on component-major arrays, each entry of a
transform being one contiguous vector over the batch, in chunks that stay in the processor's cache.
"""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, one_of, whole
from helpers.rows import NumericRow

Array = NDArray[np.float64]

_CHUNK = 8192  # so many configurations at a time keep the recursion inside a level-2 cache

# Freed, these 2 MiB teach glibc's malloc to keep as much at hand. Else every call would give the pages of its arrays
# back to the system, and the next would wait for them longer than it computes.
np.empty(1 << 18)


def link_frames(arm: Arm, q: ArrayLike) -> Array:
    """Base-to-link transforms ${}^0T_0 .. {}^0T_n$, shape (..., rows + 1, 4, 4), for q of shape (..., dof).

    Raises ArmError for a q of another length, or with NaN or infinity in it.
    Source: Spong, Hutchinson and Vidyasagar, section 3.1.
    """
    must_be(arm, Arm, "arm")
    return in_chunks(arm, q, (len(arm.rows) + 1, 4, 4), _fill_frames)


def forward_kinematics(arm: Arm, q: ArrayLike) -> Array:
    """The tip's pose ${}^0T_n$ in the base frame, shape (..., 4, 4), for q of shape (..., dof)."""
    must_be(arm, Arm, "arm")
    return in_chunks(arm, q, (4, 4), _fill_tip)


def tip(arm: Arm, q: ArrayLike) -> Array:
    """Where the tip is, shape (..., 3), in m in the base frame, for q of shape (..., dof)."""
    return forward_kinematics(arm, q)[..., :3, 3]


def jacobian(arm: Arm, q: ArrayLike) -> Array:
    """The tip's Jacobian, shape (..., 6, dof): rows (vx, vy, vz, wx, wy, wz) in the base frame.

    A revolute joint i has the column z_{i-1} x (o_n - o_{i-1}) over z_{i-1}, a prismatic one z_{i-1} over 0.
    Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    must_be(arm, Arm, "arm")
    return in_chunks(arm, q, (6, arm.dof), _fill_jacobian)


def jacobian_in_frame(arm: Arm, q: ArrayLike, frame: int) -> Array:
    """The same Jacobian, shape (..., 6, dof), of the same tip, its rows in the axes of a link frame.

    Frame 0 is the base, frame n the tool. Raises ArmError for a frame that does not exist.
    """
    must_be(arm, Arm, "arm")
    if whole(frame, "frame") > len(arm.rows):
        raise ArmError(f"{arm.name}: frame {frame!r} does not exist; expected 0 to {len(arm.rows)}")
    R = link_frames(arm, q)[..., frame, :3, :3]
    J = jacobian(arm, q)
    return np.concatenate(
        [np.swapaxes(R, -1, -2) @ half for half in (J[..., :3, :], J[..., 3:, :])], axis=-2
    )


def analytic_jacobian(arm: Arm, q: ArrayLike) -> Array:
    """Rates of the tip's position and of its ZYZ Euler angles (phi, theta, psi), shape (..., 6, dof).

    Raises ArmError where theta is 0 or pi: there the angles' rates are not defined, whatever the arm can do.
    Source: Spong, Hutchinson and Vidyasagar, section 4.8.
    """
    T, J = forward_kinematics(arm, q), jacobian(arm, q)
    sine = np.hypot(T[..., 0, 2], T[..., 1, 2])
    if (sine < 1e-9).any():
        raise ArmError(
            f"{arm.name}: the ZYZ angles are singular here (theta is 0 or pi); use the geometric Jacobian"
        )
    c, s, cosine = T[..., 0, 2] / sine, T[..., 1, 2] / sine, T[..., 2, 2]
    zero = np.zeros_like(sine)
    rates = np.stack([zero, -s, c * sine, zero, c, s * sine, zero + 1, zero, cosine], axis=-1)
    turning = np.linalg.solve(rates.reshape(*sine.shape, 3, 3), J[..., 3:, :])
    return np.concatenate([J[..., :3, :], turning], axis=-2)


def manipulability(arm: Arm, q: ArrayLike, part: str = "all") -> Array:
    """Yoshikawa's measure, shape (...): the product of the Jacobian's singular values, 0 at a singular pose.

    `part` is "all", "linear" (rows v) or "angular" (rows omega). With as many rows as joints it is the size of det J. With
    fewer joints than rows it is the volume of what the joints can reach, sqrt(det J^T J). The unit of "all" mixes m
    and rad, so compare it only between poses of one arm. Source: Yoshikawa (1985).
    """
    rows = {"all": [0, 1, 2, 3, 4, 5], "linear": [0, 1, 2], "angular": [3, 4, 5]}
    chosen = rows[one_of(part, "part", rows)]
    return np.linalg.svd(jacobian(arm, q)[..., chosen, :], compute_uv=False).prod(axis=-1)


def skeleton(arm: Arm, T: Array) -> Array:
    """The points o_0, o_0 + d z_0, o_1, o_1 + d z_1, ...: what the table's lengths draw, for T of shape (rows + 1, 4, 4)."""
    points = [T[0, :3, 3]]
    for row, frame in zip(arm.numeric, T[1:], strict=True):
        points += [frame[:3, 3] - row.a * frame[:3, 0], frame[:3, 3]]
    return np.array(points)


def in_chunks(arm: Arm, q: ArrayLike, shape: tuple[int, ...], fill) -> Array:
    q = arm.joint_vector(q)
    flat = q.reshape(math.prod(q.shape[:-1]), arm.dof)
    out = np.zeros((len(flat), *shape))
    for start in range(0, len(flat), _CHUNK):
        part = slice(start, start + _CHUNK)
        fill(arm, np.ascontiguousarray(flat[part].T), out[part])
    return out.reshape(*q.shape[:-1], *shape)


def _fill_frames(arm: Arm, q: Array, out: Array) -> None:
    for i, frame in enumerate(frame_columns(arm, q)):
        _store(frame, out[:, i])


def _fill_tip(arm: Arm, q: Array, out: Array) -> None:
    *_, frame = frame_columns(arm, q)
    _store(frame, out)


def _store(frame, out: Array) -> None:
    for column, vector in enumerate(frame):
        out[:, :3, column] = vector.T
    out[:, 3, 3] = 1.0


def _fill_jacobian(arm: Arm, q: Array, out: Array) -> None:
    store_jacobian(arm, list(frame_columns(arm, q)), out)


def store_jacobian(arm: Arm, frames: list[tuple[Array, Array, Array, Array]], out: Array) -> None:
    """Write the Jacobians (batch, 6, dof) that belong to frames as `frame_columns` gives them into zeros."""
    tip = frames[-1][3]
    for column, i in enumerate(arm.joints):
        _, _, z, origin = frames[i - 1]
        if arm.numeric[i - 1].kind == "revolute":
            out[:, :3, column] = cross(z, tip - origin).T
            out[:, 3:, column] = z.T
        else:
            out[:, :3, column] = z.T


def cross(u: Array, v: Array) -> Array:
    w = np.empty(np.broadcast_shapes(u.shape, v.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.subtract(u[j] * v[k], u[k] * v[j], out=w[i, ...])
    return w


def frame_columns(arm: Arm, q: Array) -> Iterator[tuple[Array, Array, Array, Array]]:
    """The columns (x, y, z, origin) of each link frame in turn, each (3, batch) or, while constant, (3, 1)."""
    x, y, z = np.eye(3)[:, :, None]
    origin = np.zeros((3, 1))
    yield x, y, z, origin
    for row, c, s, d in row_motions(arm, q):
        x, y = c * x + s * y, c * y - s * x
        origin = _moved(origin, d, z, row.a, x)
        y, z = tilted(row, y, z)
        yield x, y, z, origin


def row_motions(
    arm: Arm, q: Array
) -> Iterator[tuple[NumericRow, Array | float, Array | float, Array | float]]:
    """Each row with the cosine and sine of its angle and its offset, its joint's motion put in."""
    cosines, sines = cosines_and_sines(q)
    moving = 0
    for row in arm.numeric:
        c, s, d = row.cos_theta, row.sin_theta, row.d
        if row.kind == "revolute":
            c, s = _turned(row, q[moving], cosines[moving], sines[moving])
        elif row.kind == "prismatic":
            d = d + q[moving]
        moving += row.kind != "fixed"
        yield row, c, s, d


def cosines_and_sines(q: Array) -> tuple[Array, Array]:
    # NumPy's tan is vectorised where its sin and cos are not: both come from the half angle, to 3.4e-16.
    t = np.tan(0.5 * q)
    r = 2.0 / (1.0 + t * t)
    return r - 1.0, t * r


def _turned(row: NumericRow, angle: Array, c: Array, s: Array) -> tuple[Array, Array]:
    """Cosine and sine of the angle plus the row's offset, exact where the offset is a quarter turn."""
    match (row.cos_theta, row.sin_theta):
        case (1.0, 0.0):
            return c, s
        case (0.0, 1.0):
            return -s, c
        case (-1.0, 0.0):
            return -c, -s
        case (0.0, -1.0):
            return s, -c
    return np.cos(angle + row.theta), np.sin(angle + row.theta)


def _moved(origin: Array, d, z: Array, a: float, x: Array) -> Array:
    if np.ndim(d) or d:
        origin = origin + d * z
    return origin + a * x if a else origin


def tilted(row: NumericRow, y: Array, z: Array) -> tuple[Array, Array]:
    """Two components, or columns, seen after the row's turn about x."""
    c, s = row.cos_alpha, row.sin_alpha
    match (c, s):
        case (1.0, 0.0):
            return y, z
        case (-1.0, 0.0):
            return -y, -z
        case (0.0, 1.0):
            return z, -y
        case (0.0, -1.0):
            return -z, y
    return c * y + s * z, c * z - s * y
