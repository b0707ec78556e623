"""The kinematics of many tables at once, for trying what mistakes would give: each hypothesis is
another table or another q.

Apart from `helpers.kinematics` because here the table varies and the pose does not.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm

Array = NDArray[Any]


@dataclass(frozen=True)
class Chain:
    """Numbers of one or more tables: a, alpha, d, theta of shape (..., rows), the joints' values q
    (..., dof).
    """

    a: Array
    alpha: Array
    d: Array
    theta: Array
    q: Array
    joints: tuple[int, ...]
    turning: NDArray[np.bool_]

    @cached_property
    def frames(self) -> Array:
        """Base-to-link transforms, shape (..., rows + 1, 4, 4)."""
        table = np.broadcast_arrays(self.a, self.alpha, self.d, self.theta, self.q[..., :1])[:4]
        a, alpha, d, theta = map(np.array, table)
        for k, i in enumerate(self.joints):
            (theta if self.turning[k] else d)[..., i - 1] += self.q[..., k]
        return chained(steps(a, alpha, d, theta))

    def with_(self, **changes: Any) -> "Chain":
        """The same with other numbers."""
        return replace(self, **changes)


def chain(arm: Arm, q: Array) -> Chain:
    """An arm at q, shape (..., dof)."""
    table = [[arm.number(e) for e in (r.a, r.alpha, r.d, r.theta)] for r in arm.rows]
    a, alpha, d, theta = np.array(table, dtype=float).T
    return Chain(a, alpha, d, theta, np.asarray(q, dtype=float), arm.joints, arm.turning)


def steps(a: Array, alpha: Array, d: Array, theta: Array) -> Array:
    """Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) for arrays of one shape, with shape (..., 4,
    4).
    """
    c, s, ca, sa = _cos(theta), _sin(theta), _cos(alpha), _sin(alpha)
    zero, one = np.zeros_like(c), np.ones_like(c)
    rows = [
        [c, -s * ca, s * sa, a * c],
        [s, c * ca, -c * sa, a * s],
        [zero, sa, ca, d],
        [zero, zero, zero, one],
    ]
    return np.stack([np.stack(row, -1) for row in rows], -2)


def chained(A: Array) -> Array:
    """The products of steps (..., rows, 4, 4) from the base on, with the identity before them."""
    T = [np.broadcast_to(np.eye(4), A[..., 0, :, :].shape)]
    for k in range(A.shape[-3]):
        T.append(T[-1] @ A[..., k, :, :])
    return np.stack(T, axis=-3)


def _cos(angle: Array) -> Array:
    return _sin(angle + np.pi / 2)


def _sin(angle: Array) -> Array:
    """The sine, exact at multiples of a right angle."""
    quarter = angle / (np.pi / 2)
    whole = np.rint(quarter)
    exact = np.array([0.0, 1.0, 0.0, -1.0])[np.mod(whole, 4).astype(int)]
    return np.where(np.abs(quarter - whole) < 1e-12, exact, np.sin(angle))


def columns(
    chain: Chain,
    *,
    axis: Array | None = None,
    origin: Array | None = None,
    lever: str = "tip - o",
    point: int = -1,
    frames: Array | None = None,
    slides: bool = True,
) -> Array:
    """A Jacobian built column by column, shape (..., 6, dof), with a step of the recipe done
    otherwise.

    `axis` and `origin` are the frames whose z and o serve each joint; `point` is the frame whose
    origin moves.
    """
    T = chain.frames if frames is None else frames
    usual = np.array(chain.joints) - 1
    axis, origin = (usual if x is None else x for x in (axis, origin))
    axes, points = T[..., :3, 2], T[..., :3, 3]
    z, o, tip = axes[..., axis, :], points[..., origin, :], points[..., point, None, :]
    own = points[..., usual + 1, :]
    arm = {"tip - o": tip - o, "tip": np.broadcast_to(tip, o.shape), "o": o, "link": own - o}[lever]
    turns = (chain.turning | (not slides))[:, None]
    linear, angular = np.where(turns, vector_products(z, arm), z), np.where(turns, z, 0.0)
    return np.swapaxes(np.concatenate([linear, angular], axis=-1), -1, -2)


def vector_products(u: Array, v: Array) -> Array:
    """The vector products of u and v (..., 3), several times as fast as NumPy's for a few."""
    (a, b, c), (x, y, z) = (np.moveaxis(w, -1, 0) for w in (u, v))
    return np.stack([b * z - c * y, c * x - a * z, a * y - b * x], axis=-1)


def weights(chain: Chain, masses: Array, centres: Array, gravity: Array) -> Array:
    """g(q), shape (..., dof), for a mass and a centre (in its row's frame) for each row: -z . ((sum
    m c - o sum m) x gravity).
    """
    T = chain.frames
    points = (T[..., 1:, :3, :3] @ centres[..., None])[..., 0] + T[..., 1:, :3, 3]
    mass = np.cumsum(np.broadcast_to(masses, points.shape[:-1])[..., ::-1], axis=-1)[..., ::-1]
    moment = np.cumsum((points * masses[..., None])[..., ::-1, :], axis=-2)[..., ::-1, :]
    at = np.array(chain.joints) - 1
    z, o = T[..., :3, 2][..., at, :], T[..., :3, 3][..., at, :]
    lever = moment[..., at, :] - mass[..., at, None] * o
    turning = -(z * vector_products(lever, gravity)).sum(axis=-1)
    return np.where(chain.turning, turning, -(z @ gravity) * mass[..., at])
