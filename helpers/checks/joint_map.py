"""How the joints of one valid table count in those of another: q_2 of the reference = -q_2 of yours
- 90°.

Axis by axis from the base: a joint's zero is found from where it carries the next axis, or at the
end the tip and the tool.
"""

import math
from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from helpers.arm import Arm, Body, Joint, Row
from helpers.checks.axes import (
    BASE,
    Compared,
    Frame,
    Numbers,
    Rows,
    Side,
    Vector,
    add,
    cross,
    dot,
    frames,
    mix,
    scaled,
    sub,
)
from helpers.reading.sentences import say, size
from helpers.rows import Kind

_SEEN = 1e-6  # m, or the sine of an angle: less than this fixes no direction
_LEAST = _SEEN**2
_POSES = (0.3, 0.7, 1.1, 1.9)  # joint k of each is the sine of k times this


_UPSIDE_DOWN = Frame((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (0.0, 0.0, 0.0))


class Map(NamedTuple):
    """The reference's joint k is signs[k] times yours plus offsets[k] (rad or m); your base's frame
    in the reference's.
    """

    signs: tuple[int, ...]
    offsets: tuple[float, ...]
    base: Frame

    def yours(self, joints: Iterable[float]) -> list[float]:
        """Your joints where the reference's have these values."""
        both = zip(self.signs, self.offsets, joints, strict=True)
        return [s * (x - c) for s, c, x in both]


class _Feature(NamedTuple):
    """What a joint carries: a line (point, direction), a direction without place, or a point."""

    point: Vector | None
    direction: Vector | None


def joint_map(mine: Side, reference: Side, found: Compared, tolerance: float = 1e-6) -> Map | None:
    """The map between two tables that agree, or None where it cannot be confirmed by the tips of
    some poses.
    """
    base = _base(mine, reference, found)
    ours = _features(mine.rows, [0.0] * len(mine.joints), base, found.signs)
    offsets = [0.0] * len(mine.joints)
    forward = (1,) * len(mine.joints)
    own = [_placed(base, F).o for F in frames(mine.rows, [0.0] * len(mine.joints))]
    # Where the next axis tells nothing, one farther out does, once the zeros between are known.
    for k, i in 2 * list(enumerate(reference.joints)):
        T = frames(reference.rows, offsets)[i - 1]
        theirs = _features(reference.rows, offsets, BASE, forward)
        turns = reference.rows[i - 1].kind == "R"
        for m, r in zip(ours[k + 1 :], theirs[k + 1 :], strict=True):
            moved = _turn(T.z, own[mine.joints[k] - 1], m, T.o, r) if turns else _slide(T.z, m, r)
            if moved is not None:
                offsets[k] += moved
                break
    wrapped = [
        _wrapped(c) if reference.rows[i - 1].kind == "R" else c
        for c, i in zip(offsets, reference.joints, strict=True)
    ]
    return _confirmed(mine, reference, Map(found.signs, tuple(wrapped), base), tolerance)


def _base(mine: Side, reference: Side, found: Compared) -> Frame:
    """Your base's frame in the reference's, as far as axis 1 tells."""
    axis = frames(reference.rows[: reference.joints[0] - 1], ())[-1].z
    up = mine.up * found.signs[0]
    base = _UPSIDE_DOWN if found.upside_down else BASE
    return base._replace(o=scaled(up * found.base_higher, axis))


def _features(rows: Rows, q, base: Frame, signs: tuple[int, ...]) -> list[_Feature]:
    """Each joint's axis, then the tip and the axes of the tool, in the reference's base."""
    T = [_placed(base, F) for F in frames(rows, q)]
    moving = [i for i, row in enumerate(rows, 1) if row.kind != "F"]
    found = []
    for k, i in enumerate(moving):
        direction = scaled(signs[k], T[i - 1].z)
        found.append(_Feature(T[i - 1].o if rows[i - 1].kind == "R" else None, direction))
    tip = T[-1]
    return [*found, _Feature(tip.o, None), _Feature(None, tip.z), _Feature(None, tip.x)]


def _placed(base: Frame, F: Frame) -> Frame:
    x, y, z, o = (_from_axes(base, v) for v in F)
    return Frame(x, y, z, add(base.o, o))


def _from_axes(F: Frame, v: Sequence[float]) -> Vector:
    """The vector with these parts along the axes of a frame."""
    return add(mix(v[0], F.x, v[1], F.y), scaled(v[2], F.z))


def _turn(z: Vector, p: Vector, m: _Feature, o: Vector, r: Any) -> float | None:
    """The angle about an axis along z, through p here and o there, that carries r to m."""
    pairs: list[Any] = []
    if m.direction is not None:
        pairs.append((m.direction, r.direction))
    if m.point is not None:
        pairs.append((sub(m.point, p), sub(r.point, o)))
    for u, v in ((_across(u, z), _across(v, z)) for u, v in pairs):
        if dot(u, u) > _LEAST and dot(v, v) > _LEAST:
            return math.atan2(dot(z, cross(v, u)), dot(u, v))
    return None


def _across(w: Vector, d: Vector) -> Vector:
    """What of w is perpendicular to the unit vector d."""
    return sub(w, scaled(dot(w, d), d))


def _slide(z: Vector, m: _Feature, r: Any) -> float | None:
    """How far along z r is carried to m, where it shows."""
    if m.point is None:
        return None
    w = sub(m.point, r.point)
    if m.direction is None:
        return dot(w, z)
    along = _across(z, r.direction)
    return dot(w, along) / dot(along, along) if dot(along, along) > _LEAST else None


def _confirmed(mine: Side, reference: Side, found: Map, tolerance: float) -> Map | None:
    """The map, if the tips of some poses agree by it, up to the height of the base on axis 1."""
    off = []
    for step in _POSES:
        q = [math.sin(step * k) for k in range(1, len(mine.joints) + 1)]
        other = [s * x + c for s, x, c in zip(found.signs, q, found.offsets, strict=True)]
        here = _placed(found.base, frames(mine.rows, q)[-1]).o
        off.append(sub(frames(reference.rows, other)[-1].o, here))
    allowed = 10 * max(tolerance, 1e-6)
    height = off[0][2]
    if any(max(abs(x), abs(y), abs(z - height)) > allowed for x, y, z in off):
        return None
    base = found.base._replace(o=add(found.base.o, (0.0, 0.0, height)))
    return found._replace(base=base) if abs(height) > allowed else found


def _wrapped(angle: float) -> float:
    angle = math.remainder(angle, 2 * math.pi)
    return math.pi if angle <= -math.pi + 1e-9 else angle


def words(found: Map, mine: Sequence[int], reference: Side) -> list[str]:
    """The joints that count otherwise, one equation each; `mine` are the numbers of your joints."""
    said = []
    for s, c, i, j in zip(found.signs, found.offsets, mine, reference.joints, strict=True):
        turns = reference.rows[j - 1].kind == "R"
        shift = round(math.degrees(c) if turns else 1000 * c, 6)
        unit = "°" if turns else " mm"
        sign = "-" if shift < 0 else "+"
        tail = f" {sign} {size(abs(shift), 5)}{unit}" if abs(shift) > 1e-3 else ""
        if s < 0 or tail:
            said.append(say("map back" if s < 0 else "map joint", joint=j, mine=i, tail=tail))
    return said


def in_own_joints(rows: Rows, arm: Arm, found: Map, reference: Side, name: str) -> Arm:
    """The reference as an arm of the student's own table: its limits and bodies carried over to
    these rows.
    """
    ends = [found.yours(x) for x in arm.limits]
    new, k = [], 0
    for row in rows:
        joint = Joint("fixed")
        if row.kind != "F":
            low, high = sorted(end[k] for end in ends)
            kind: Kind = "revolute" if row.kind == "R" else "prismatic"
            joint = Joint(kind, low, high, arm.speed_limits[k], arm.effort_limits[k])
            k += 1
        new.append(Row(row.a, row.alpha, row.d, row.theta, joint))
    bodies = _bodies(rows, arm, found, reference) if arm.bodies else ()
    return Arm(name, tuple(new), bodies=bodies, home=found.yours(arm.home), source=arm.source)


def _bodies(rows: Rows, arm: Arm, found: Map, reference: Side) -> tuple[Body, ...]:
    """Each link's mass in the frame of the row that moves with it in the student's table."""
    ours = [_placed(found.base, F) for F in frames(rows, [0.0] * len(found.signs))]
    theirs = frames(reference.rows, found.offsets)
    totals: list[list[Any]] = [[0.0, np.zeros(3)] for _ in rows]
    owner = _owners(rows)
    for i, (body, joint) in enumerate(zip(arm.bodies, _owners(reference.rows), strict=True), 1):
        moved = [k for k, o in enumerate(owner) if o == joint]
        if not moved:
            continue  # it stands on the base, of which the student has no row
        row = moved[-1]
        c = [arm.number(x) for x in body.com]
        F, G = theirs[i], ours[row + 1]
        w = sub(add(F.o, _from_axes(F, c)), G.o)
        mass = arm.number(body.mass)
        totals[row][0] += mass
        totals[row][1] += mass * np.array([dot(w, G.x), dot(w, G.y), dot(w, G.z)])
    return tuple(Body(m, tuple(map(float, s / m)) if m else (0, 0, 0)) for m, s in totals)


def _owners(rows: tuple[Numbers, ...] | Rows) -> list[int]:
    """The number of joints that move each row's link."""
    count, found = 0, []
    for row in rows:
        count += row.kind != "F"
        found.append(count)
    return found
