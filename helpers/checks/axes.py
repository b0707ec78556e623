"""What all Denavit-Hartenberg tables of one arm have in common: the geometry of its joint axes.

A table can be written in many ways. Each joint axis may point either way; the common normal of two parallel
axes may stand anywhere; the x axis between two axes that meet may point either way; every joint may count
from another zero; the axis of a sliding joint may be moved parallel to itself. `canonical` undoes all these
choices but one: where two axes meet at a right angle, nothing ties the direction of the second to the first.
Those directions are left as signs, to be tried out.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.kinematics import link_frames

Vector = NDArray[np.float64]

_TINY = 1e-9  # m, rad: closer than this, axes meet or are parallel


@dataclass(frozen=True)
class Step:
    """From one joint axis to the next, or to the tip: what no choice of frames can change.

    `d` is None where it is a free choice or belongs to the base, `theta` is None where the joint turns.
    `axes` are the parallel axes, counted from 1, along which `d` was added up.
    """

    row: int
    kind: str
    a: float
    alpha: float | None
    d: float | None
    theta: float | None
    axes: tuple[int, ...]


@dataclass(frozen=True)
class _Raw:
    """A step before its signs are chosen.

    `x` is the common normal's direction, None where the axes coincide; `leave` its foot, None between parallel axes.
    """

    step: Step
    x: Vector | None
    axis: Vector
    leave: Vector | None


def canonical(arm: Arm, signs: Sequence[int] = ()) -> tuple[Step, ...]:
    """The arm's steps from axis to axis, for one choice of the signs that geometry leaves open.

    `signs` holds +1 or -1 for the first axis and for each right-angled meeting of two axes; those not given are +1.
    """
    return tuple(_signed(_walk(arm), list(signs)))


def open_signs(arm: Arm) -> int:
    """How many signs geometry leaves open: one, and one for each pair of axes that meet at a right angle."""
    return 1 + sum(_is_open(raw.step) for raw in _walk(arm))


def base_height(arm: Arm) -> float:
    """How far (m) along axis 1 the base frame's origin is from where the common normal leaves that axis."""
    first = next(raw for raw in _walk(arm) if raw.leave is not None)
    return float(abs(first.axis @ (first.leave - link_frames(arm, np.zeros(arm.dof))[0, :3, 3])))


def _walk(arm: Arm) -> list[_Raw]:
    """The steps with their signs as the table happens to have them."""
    T = link_frames(arm, np.zeros(arm.dof))
    tip = T[-1, :3, 3]
    axes = [*(T[i - 1, :3, 2] for i in arm.joints), None]
    points = [*(T[i - 1, :3, 3] for i in arm.joints), tip]
    slides = [*(arm.rows[i - 1].joint.kind == "prismatic" for i in arm.joints), False]
    on_next = [_lies_on_next(i, axes, slides) for i in range(arm.dof)] + [False]
    points = [points[i + on_next[i]] for i in range(arm.dof + 1)]
    foot, bunch, raws = _start(axes, points, slides), [0], []
    for i, row in enumerate(arm.joints):
        u, v = axes[i], axes[i + 1]
        moved = slides[i + 1] and not on_next[i + 1]
        leave, arrive = _normal(foot, u, foot if moved else points[i + 1], v)
        a, x = _gap(leave, arrive, u, v)
        goes_on = v is not None and _parallel(u, v)
        absorbed = goes_on or moved or 0 in bunch or any(slides[j] for j in bunch)
        step = Step(
            row=row,
            kind=arm.rows[row - 1].joint.kind,
            a=a,
            alpha=None if v is None else _angle(u, v, x),
            d=None if absorbed else float(u @ (leave - foot)),
            theta=None,
            axes=tuple(j + 1 for j in bunch),
        )
        raws.append(_Raw(step, x, u, None if goes_on else leave))
        foot, bunch = arrive, [*bunch, i + 1] if goes_on else [i + 1]
    return raws


def _is_open(step: Step) -> bool:
    return step.alpha is not None and step.a < _TINY and abs(abs(step.alpha) - math.pi / 2) < _TINY


def _lies_on_next(i: int, axes: list, slides: list[bool]) -> bool:
    """Whether axis i slides and is parallel to a turning axis after it: it is then moved onto that one.

    Any other sliding axis is moved to where the axis before it was reached.
    """
    if not slides[i] or axes[i + 1] is None or slides[i + 1]:
        return False
    return _parallel(axes[i], axes[i + 1])


def _parallel(u: Vector, v: Vector) -> bool:
    return bool(np.linalg.norm(np.cross(u, v)) < _TINY)


def _start(axes: list, points: list[Vector], slides: list[bool]) -> Vector:
    """A point on axis 1; if that joint slides, its axis is first moved to meet the first axis that turns."""
    turning = slides.index(False)
    if axes[turning] is None or turning == 0:
        return points[turning]
    return _normal(points[turning], axes[turning], points[turning + 1], axes[turning + 1])[0]


def _normal(p: Vector, u: Vector, q: Vector, v: Vector | None) -> tuple[Vector, Vector]:
    """The feet of the common normal from the line (p, u) to the line (q, v), or to the point q.

    From parallel axes it starts at p.
    """
    if v is None:
        return p + u * (u @ (q - p)), q
    if _parallel(u, v):
        return p, q + v * (v @ (p - q))
    s, t, _ = np.linalg.solve(np.stack([u, -v, np.cross(u, v)], axis=1), q - p)
    return p + s * u, q + t * v


def _gap(leave: Vector, arrive: Vector, u: Vector, v: Vector | None) -> tuple[float, Vector | None]:
    """The normal's length and direction; where the lines meet, the direction across both."""
    a = float(np.linalg.norm(arrive - leave))
    if a > _TINY:
        return a, (arrive - leave) / a
    across = np.zeros(3) if v is None else np.cross(u, v)
    length = np.linalg.norm(across)
    return 0.0, None if length < _TINY else across / length


def _angle(u: Vector, v: Vector, x: Vector | None) -> float:
    """The angle from u to v about x."""
    cross = np.cross(u, v)
    return math.atan2(cross @ x if x is not None else np.linalg.norm(cross), u @ v)


def _signed(raws: list[_Raw], signs: list[int]):
    """The steps with every axis direction settled: twists in [0, pi), or in [0, pi/2] where axes meet."""
    f, previous = (signs.pop(0) if signs else 1), None
    for raw in raws:
        step, x, before = raw.step, raw.x, f
        if step.alpha is not None:
            g, f = _settle(step, f, signs)
            x = None if x is None else g * x
            step = replace(step, alpha=_wrapped(g * step.alpha + (math.pi if f != before else 0)))
        if step.kind == "prismatic" and previous is not None and x is not None:
            step = replace(step, theta=_wrapped(before * _angle(previous, x, raw.axis)))
        yield replace(step, d=None if step.d is None else before * step.d)
        previous = x


def _settle(step: Step, f: int, signs: list[int]) -> tuple[int, int]:
    """Signs of x and of the next axis that bring the twist into its range."""
    if _is_open(step):
        g = signs.pop(0) if signs else 1
        return g, f if _wrapped(g * step.alpha) < math.pi else -f
    meets = step.a < _TINY
    limit = math.pi / 2 if meets else math.pi - _TINY
    choices = [(g, turn) for g in ((1, -1) if meets else (1,)) for turn in (1, -1)]
    fitting = (c for c in choices if _wrapped(c[0] * step.alpha + (c[1] < 0) * math.pi) < limit)
    g, turn = next(fitting)
    return g, f * turn


def _wrapped(angle: float) -> float:
    """The angle in [0, 2 pi), with what is within rounding of a full turn taken as 0."""
    angle %= 2 * math.pi
    return 0.0 if 2 * math.pi - angle < _TINY else angle
