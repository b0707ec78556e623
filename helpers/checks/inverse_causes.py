"""What slips make of right joint angles, undone: each gives the angles that would have come out
without it.
"""

import math
from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.ranking import Cause, cause

Array = NDArray[Any]

_JOINT: tuple[tuple[str, Callable[[float], float]], ...] = (
    ("ik.sign", lambda x: -x),
    ("ik.half turn", lambda x: x + math.pi),
    ("ik.other axis", lambda x: math.pi / 2 - x),
    ("ik.supplement", lambda x: math.pi - x),
    ("ik.offset", lambda x: x + math.pi / 2),
    ("ik.offset", lambda x: x - math.pi / 2),
)
_SCALES = {"ik.slide in millimetres": 1e-3, "ik.slide in centimetres": 1e-2}


def whole(arm: Arm, q: Array) -> Iterator[tuple[Cause, Array]]:
    """Slips in all joints at once."""
    yield cause("ik.degrees"), np.where(arm.turning, np.radians(q), q)
    yield cause("ik.all signs"), -q
    slides = ~arm.turning
    if slides.any():
        yield cause("ik.slide in millimetres"), np.where(slides, q / 1000, q)
        yield cause("ik.slide in centimetres"), np.where(slides, q / 100, q)
        yield (
            cause("ik.degrees") + cause("ik.slide in millimetres"),
            np.where(slides, q / 1000, np.radians(q)),
        )
    if arm.dof > 1:
        yield cause("ik.reversed order"), q[::-1]
    for which in combinations(range(arm.dof), 3):
        names = ", ".join(f"q_{arm.joints[k]}" for k in which)
        yield cause("ik.signs", joints=names), np.where(np.isin(np.arange(arm.dof), which), -q, q)


def scales(c: Cause) -> bool:
    """Whether a slip only scales joints, so that near zero it cannot be told."""
    return any(key in _SCALES or key == "ik.degrees" for key in c.keys)


def scale(c: Cause, arm: Arm) -> Array:
    """What such a slip's units are worth, by joint, shape (dof,)."""
    slide = next((_SCALES[key] for key in c.keys if key in _SCALES), 1.0)
    return np.where(arm.turning, math.pi / 180 if "ik.degrees" in c.keys else 1.0, slide)


def single(arm: Arm, q: Array) -> Iterator[tuple[Cause, Array]]:
    """Slips in one joint, or in one step of a closed form."""
    yield from _elbow_formula(arm, q)
    for k, i in enumerate(arm.joints):
        for key, change in _JOINT:
            if key == "ik.sign" or (arm.turning[k] and (k or key != "ik.supplement")):
                mended = q.copy()
                mended[k] = change(q[k])
                yield cause(key, joint=f"q_{i}"), mended


def kept(q: Array, branches: Array) -> Iterator[tuple[Cause, Array]]:
    """theta_1 = +-pi/2 kept from the singular case where an offset shoulder has two general
    values.
    """
    if abs(abs(q[0]) - math.pi / 2) < 1e-4:
        for branch in branches:
            mended = q.copy()
            mended[0] = branch[0]
            yield cause("ik.quarter turn"), mended


def _elbow_formula(arm: Arm, q: Array) -> Iterator[tuple[Cause, Array]]:
    """theta_2 = atan2(s, r) + ... for minus, where two parallel axes carry two links."""
    rows = arm.numeric
    if arm.dof < 3 or abs(rows[1].sin_alpha) > 1e-9 or not (rows[1].a and rows[2].a):
        return
    bend = rows[1].cos_alpha * (q[2] + rows[2].theta)
    lean = math.atan2(rows[2].a * math.sin(bend), rows[1].a + rows[2].a * math.cos(bend))
    mended = q.copy()
    mended[1] -= 2 * lean
    yield cause("ik.plus for minus"), mended


def double(arm: Arm, q: Array) -> Iterator[tuple[Cause, Array]]:
    """Slips in two joints."""
    for i, j in combinations(range(arm.dof), 2):
        if not (arm.turning[i] and arm.turning[j]):
            continue
        for key, change in _JOINT:
            for other, then in _JOINT:
                mended = q.copy()
                mended[i], mended[j] = change(q[i]), then(q[j])
                yield (
                    cause(key, joint=f"q_{arm.joints[i]}")
                    + cause(other, joint=f"q_{arm.joints[j]}"),
                    mended,
                )
