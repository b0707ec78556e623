"""What all Denavit-Hartenberg tables of one arm have in common: the geometry of its joint axes.

The axes that turn are lines in space. From one to the next there is a distance, a twist, and on
each an offset between the feet of the two common normals; along parallel axes only the sum of the
offsets is fixed, for their common normals may stand anywhere. An axis that slides has a direction
and no place. Sliding moves the lines after it, so lengths are taken where the slides make the sum
of their squares least: all tables find the same place. What is left open is which way each axis
points: a sign per joint, which the comparison tries out.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.kinematics import link_frames

Vector = NDArray[np.float64]

NORMAL = -1  # stands for the common normal where joints are listed by position
_TINY = 1e-9  # m, or the sine of an angle: closer than this, axes meet or are parallel


@dataclass(frozen=True)
class Gap:
    """From one turning axis to the next, or to the tip, across the slides between them.

    Joints are listed by position, from 0. `shape` holds the products that fix the directions in the
    gap: u.v for two of them, u x v . w for three, the common normal among them where it has a
    length. `offset` is the signed length along the parallel axes `bunch`, measured along the last
    of them; None while that bunch goes on. The first bunch has `from_base`: its offset only tells
    where the base frame stands.
    """

    joints: tuple[int, ...]
    normal: Vector
    shape: dict[tuple[int, ...], float]
    offset: float | None
    bunch: tuple[int, ...]
    from_base: bool
    to_tip: bool

    @property
    def places_base(self) -> bool:
        """Whether `offset` is the height of the base frame, with no slide to make up for it."""
        still = self.bunch == tuple(range(len(self.bunch))) and len(self.joints) + self.to_tip == 2
        return self.from_base and self.offset is not None and still

    @property
    def length(self) -> float:
        """The distance (m) between the two axes, or from the axis to the tip."""
        return float(np.linalg.norm(self.normal))


def gaps(arm: Arm) -> list[Gap]:
    """The arm's gaps from base to tip, with its slides where they make the lengths least."""
    slides = [k for k, turns in enumerate(arm.turning) if not turns]
    q, steps = np.zeros(arm.dof), np.eye(arm.dof)[slides]
    if slides:
        start = _lengths(_walk(arm, q))
        rates = np.stack([_lengths(_walk(arm, step)) - start for step in steps], axis=1)
        rates[np.abs(rates) < _TINY] = 0.0  # a slide that changes no length stays where it is
        q[slides] = np.linalg.lstsq(rates, -start, rcond=_TINY)[0]
    return _walk(arm, q)


def tool_tilt(arm: Arm) -> float:
    """The cosine of the angle between the last joint axis and the z axis of the last frame."""
    T = link_frames(arm, np.zeros(arm.dof))
    return float(T[arm.joints[-1] - 1, :3, 2] @ T[-1, :3, 2])


def _lengths(walk: list[Gap]) -> Vector:
    offsets = [gap.offset for gap in walk if gap.offset is not None and not gap.from_base]
    return np.concatenate([*(gap.normal for gap in walk), offsets])


def _walk(arm: Arm, q: Vector) -> list[Gap]:
    T = link_frames(arm, q)
    axes, points = ([T[i - 1, :3, column] for i in arm.joints] for column in (2, 3))
    turning = [k for k, turns in enumerate(arm.turning) if turns]
    first, *others = [*turning, arm.dof]
    found = [_gap(axes, range(min(first + 1, arm.dof)), np.zeros(3), None, (), True, False)]
    foot, bunch = T[0, :3, 3], ()
    for i, j in zip(turning, others, strict=True):
        ends = (points[j], axes[j]) if j < arm.dof else (T[-1, :3, 3], None)
        foot = foot if bunch else points[i] + axes[i] * (axes[i] @ (foot - points[i]))
        leave, arrive = _feet(foot, axes[i], *ends)
        bunch = (*bunch, i)
        goes_on = j < arm.dof and _parallel(axes[i], axes[j])
        offset = None if goes_on else float(axes[i] @ (leave - foot))
        joints = range(i, min(j + 1, arm.dof))
        from_base, to_tip = bunch[0] == turning[0], j == arm.dof
        found.append(_gap(axes, joints, arrive - leave, offset, bunch, from_base, to_tip))
        foot, bunch = arrive, bunch if goes_on else ()
    return found


def _gap(axes: list, joints: range, normal: Vector, *rest) -> Gap:
    directions = {k: axes[k] for k in joints}
    length = np.linalg.norm(normal)
    if length > _TINY:
        directions[NORMAL] = normal / length
    pairs = {pair: float(np.dot(*map(directions.get, pair))) for pair in combinations(joints, 2)}
    triples = {
        three: float(np.linalg.det([directions[k] for k in three]))
        for three in combinations(directions, 3)
    }
    return Gap(tuple(joints), normal, pairs | triples, *rest)


def _feet(p: Vector, u: Vector, q: Vector, v: Vector | None) -> tuple[Vector, Vector]:
    """The feet of the common normal from the line (p, u) to the line (q, v), or to the point q.

    From parallel axes it starts at p.
    """
    if v is None:
        return p + u * (u @ (q - p)), q
    if _parallel(u, v):
        return p, q + v * (v @ (p - q))
    s, t, _ = np.linalg.solve(np.stack([u, -v, np.cross(u, v)], axis=1), q - p)
    return p + s * u, q + t * v


def _parallel(u: Vector, v: Vector) -> bool:
    return bool(np.linalg.norm(np.cross(u, v)) < _TINY)
