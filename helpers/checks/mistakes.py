"""What the usual mistakes make of an arm's Jacobian: pairs of a sentence and the matrix that it
explains."""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.kinematics import jacobian, jacobian_in_frame, link_frames

Array = NDArray[np.float64]
Mistakes = Iterator[tuple[str, Array]]


def usual_mistakes(arm: Arm, q: Array, frame: int) -> Mistakes:
    """Every mistake in turn, as a 6 x dof matrix in the axes of the base; `frame` is the one
    declared."""
    yield from _rows(arm, q, frame)
    yield from _units(arm, q)
    yield from _axes(arm, q)
    yield from _levers(arm, q)
    yield from _frames(arm, q, frame)


def rotated(M: Array, R: Array) -> Array:
    """Both halves of a Jacobian turned by the rotation R."""
    return np.vstack([R @ M[:3], R @ M[3:]])


def _rows(arm: Arm, q: Array, frame: int) -> Mistakes:
    right = jacobian(arm, q)
    v, w = right[:3], right[3:]
    exchanged = (
        "Linear and angular rows are exchanged; if you mean (omega, v), say angular_first=True"
    )
    yield exchanged, np.vstack([w, v])
    crossed = "The cross product is taken the wrong way round: z x (o_n - o), not (o_n - o) x z"
    yield crossed, np.vstack([np.where(arm.turning, -v, v), w])
    yield "Every sign is reversed", -right
    unturned = "The angular rows are zero: a joint that turns contributes its axis z_{i-1}"
    yield unturned, np.vstack([v, 0 * w])
    if arm.dof == 6:
        R = link_frames(arm, q)[frame, :3, :3]
        transposed = jacobian_in_frame(arm, q, frame).T
        yield "It is transposed: one column per joint, six rows", rotated(transposed, R)


def _units(arm: Arm, q: Array) -> Mistakes:
    right, turning = jacobian(arm, q), arm.turning
    millimetres = (
        "The linear rows are in millimetres, the angular ones are not: use metres throughout"
    )
    yield millimetres, right * np.repeat([1000, 1], 3)[:, None]
    degrees = "q is taken in degrees: sines and cosines here take radians"
    yield degrees, jacobian(arm, np.where(turning, np.radians(q), q))
    yield degrees, jacobian(arm, np.where(turning, np.degrees(q), q))
    yield "It is per degree: angles are in radians", np.where(turning, np.radians(right), right)


def _axes(arm: Arm, q: Array) -> Mistakes:
    right, late = _built(arm, q), _built(arm, q, axis=1, origin=1)
    angular = (
        "The angular rows use z_i where z_{i-1} belongs: joint i turns about the axis of the"
        " frame before it"
    )
    yield angular, np.vstack([right[:3], late[3:]])
    yield (
        "Axes and origins are one frame too far: joint i has z_{i-1} and o_{i-1}, not z_i and o_i",
        late,
    )
    both = "The axes are one frame too far: joint i turns about z_{i-1}, not z_i"
    yield both, _built(arm, q, axis=1)
    rows = "Axes and origins are read from the rows of T: they are its columns"
    yield rows, _built(arm, q, read=lambda T: np.swapaxes(T, -1, -2))
    slides = "A joint that slides is treated as one that turns: its column is z over 0"
    yield slides, _built(arm, q, slides=False)


def _levers(arm: Arm, q: Array) -> Mistakes:
    start = "The lever arm starts at o_i: it goes from o_{i-1}, a point on the joint's axis"
    yield start, _built(arm, q, origin=1)
    tip_only = "The lever arm is o_n alone: subtract o_{i-1}, the point on the joint's axis"
    yield tip_only, _built(arm, q, lever=lambda o, tip: tip)
    origin_only = "The lever arm is o_{i-1} alone: it goes from o_{i-1} to the tip, o_n - o_{i-1}"
    yield origin_only, _built(arm, q, lever=lambda o, tip: o)
    for k, point in enumerate(link_frames(arm, q)[:-1, :3, 3]):
        elsewhere = f"The linear rows are the velocity of a point at o_{k}, not of the tip"
        yield elsewhere, _built(arm, q, lever=lambda o, tip, p=point: p - o)


def _frames(arm: Arm, q: Array, frame: int) -> Mistakes:
    names = ["the base", *(f"frame {k}" for k in range(1, len(arm.rows) + 1))]
    R = link_frames(arm, q)[frame, :3, :3]
    for k, name in enumerate(names):
        if k != frame:
            words = (
                f"The rows are in the axes of {name}, not of {names[frame]}; if you mean that,"
                f" say frame={k}"
            )
            yield words, rotated(jacobian_in_frame(arm, q, k), R)


def _built(
    arm: Arm,
    q: Array,
    *,
    axis: int = 0,
    origin: int = 0,
    lever: Callable = lambda o, tip: tip - o,
    read: Callable = lambda T: T,
    slides: bool = True,
) -> Array:
    """The Jacobian built column by column with a step done otherwise; `axis` and `origin` count
    frames too far."""
    T = read(link_frames(arm, q))
    columns = []
    for i, turns in zip(arm.joints, arm.turning, strict=True):
        z, o = T[i - 1 + axis, :3, 2], T[i - 1 + origin, :3, 3]
        swings = turns or not slides
        halves = [np.cross(z, lever(o, T[-1, :3, 3])), z] if swings else [z, 0 * z]
        columns.append(np.concatenate(halves))
    return np.stack(columns, axis=1)
