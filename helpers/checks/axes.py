"""What all Denavit-Hartenberg tables of one arm have in common: the geometry of its joint axes.

The axes that turn are lines in space. From one to the next there is a distance, a twist, and on
each an offset between the feet of the two common normals; along parallel axes only the sum of the
offsets is fixed, for their common normals may stand anywhere. An axis that slides has a direction
and no place. Sliding moves the lines after it, so lengths are taken where the slides make the sum
of their squares least: all tables find the same place. What is left open is which way each axis
points: a sign per joint, which the comparison chooses.

Plain numbers and tuples: a comparison tries hundreds of tables, and the page's judge is a port of
this.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise, product
from typing import Any, NamedTuple

import numpy as np

from helpers.arm import Arm, cos_sin
from helpers.reading.table import Numbers

Vector = tuple[float, float, float]

NORMAL = -1  # stands for the common normal where joints are listed by position
_TINY = 1e-9  # m, or the sine of an angle: closer than this, axes meet or are parallel
_KINDS = {"revolute": "R", "prismatic": "P", "fixed": "F"}


Rows = Sequence[Numbers]


def numeric(arm: Arm) -> tuple[Numbers, ...]:
    """An arm's rows in numbers."""
    return tuple(
        Numbers(_KINDS[r.joint.kind], *(arm.number(e) for e in (r.a, r.alpha, r.d, r.theta)))
        for r in arm.rows
    )


def joints(rows: Rows) -> list[int]:
    """The numbers, counted from 1, of the rows that move."""
    return [i for i, row in enumerate(rows, 1) if row.kind != "F"]


class Frame(NamedTuple):
    """A link frame: its axes and its origin."""

    x: Vector
    y: Vector
    z: Vector
    o: Vector


BASE = Frame((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0))


def frames(rows: Rows, q: Sequence[float]) -> list[Frame]:
    """The base's frame and each link's, joints at q."""
    found, values = [BASE], iter(q)
    for row in rows:
        c, s = cos_sin(row.theta + next(values) if row.kind == "R" else row.theta)
        ca, sa = cos_sin(row.alpha)
        x, y, z, o = found[-1]
        d = row.d + next(values) if row.kind == "P" else row.d
        new_x, turned = mix(c, x, s, y), mix(c, y, -s, x)
        o = add(o, mix(d, z, row.a, new_x))
        found.append(Frame(new_x, mix(ca, turned, sa, z), mix(ca, z, -sa, turned), o))
    return found


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
    length: float
    shape: dict[tuple[int, ...], float]
    offset: float | None
    bunch: tuple[int, ...]
    from_base: bool = False
    to_tip: bool = False

    @property
    def places_base(self) -> bool:
        """Whether `offset` is the height of the base frame, with no slide to make up for it."""
        still = self.bunch == tuple(range(len(self.bunch))) and len(self.joints) + self.to_tip == 2
        return self.from_base and self.offset is not None and still


def gaps(rows: Rows) -> list[Gap]:
    """The arm's gaps from base to tip, with its slides where they make the lengths least."""
    kinds = [row.kind for row in rows if row.kind != "F"]
    slides = [k for k, kind in enumerate(kinds) if kind == "P"]
    q = [0.0] * len(kinds)
    if slides:
        start = _lengths(_walk(rows, q))
        rates = []
        for k in slides:
            step = [1.0 if k == j else 0.0 for j in range(len(kinds))]
            rates.append(np.subtract(_lengths(_walk(rows, step)), start))
        A = np.stack(rates, axis=1)
        A[np.abs(A) < _TINY] = 0.0  # a slide that changes no length stays where it is
        for k, x in zip(
            slides, np.linalg.lstsq(A, np.negative(start), rcond=_TINY)[0], strict=True
        ):
            q[k] = float(x)
    return _walk(rows, q)


def tool_tilt(rows: Rows) -> float:
    """The cosine of the angle between the last joint axis and the z axis of the last frame."""
    moving = joints(rows)
    T = frames(rows, [0.0] * len(moving))
    return dot(T[moving[-1] - 1].z, T[-1].z)


def _lengths(walk: list[Gap]) -> list[float]:
    offsets = [gap.offset for gap in walk if gap.offset is not None and not gap.from_base]
    return [*(x for gap in walk for x in gap.normal), *offsets]


def _walk(rows: Rows, q: Sequence[float]) -> list[Gap]:
    T, moving = frames(rows, q), joints(rows)
    axes, points = [T[i - 1].z for i in moving], [T[i - 1].o for i in moving]
    dof = len(moving)
    turning = [k for k, i in enumerate(moving) if rows[i - 1].kind == "R"]
    first = [*turning, dof][0]
    found = [_gap(axes, range(min(first + 1, dof)), (0.0, 0.0, 0.0), None, ())]
    bunch: tuple[int, ...] = ()
    foot = _feet(BASE.o, BASE.z, points[first], axes[first])[1] if turning else BASE.o
    for i, j in pairwise([*turning, dof]):
        end, other = (points[j], axes[j]) if j < dof else (T[-1].o, None)
        foot = foot if bunch else _onto(points[i], axes[i], foot)
        leave, arrive = _feet(foot, axes[i], end, other)
        bunch = (*bunch, i)
        goes_on = j < dof and _parallel(axes[i], axes[j])
        offset = None if goes_on else dot(axes[i], sub(leave, foot))
        between = range(i, min(j + 1, dof))
        found.append(
            _gap(axes, between, sub(arrive, leave), offset, bunch, bunch[0] == turning[0], j == dof)
        )
        foot, bunch = arrive, bunch if goes_on else ()
    return found


def _gap(axes: list[Vector], between: range, normal: Vector, *rest) -> Gap:
    directions = {k: axes[k] for k in between}
    length = math.sqrt(dot(normal, normal))
    if length > _TINY:
        directions[NORMAL] = scaled(1 / length, normal)
    shape: dict[tuple[int, ...], float] = {
        (i, j): dot(directions[i], directions[j]) for i, j in combinations(between, 2)
    }
    for i, j, k in combinations(directions, 3):
        shape[i, j, k] = dot(cross(directions[i], directions[j]), directions[k])
    return Gap(tuple(between), normal, length, shape, *rest)


def _onto(p: Vector, u: Vector, point: Vector) -> Vector:
    """The foot of a point on the line (p, u)."""
    return add(p, scaled(dot(u, sub(point, p)), u))


def _feet(p: Vector, u: Vector, q: Vector, v: Vector | None) -> tuple[Vector, Vector]:
    """The feet of the common normal from the line (p, u) to the line (q, v), or to the point q.

    From parallel axes it starts at p.
    """
    if v is None:
        return _onto(p, u, q), q
    if _parallel(u, v):
        return p, _onto(q, v, p)
    w, uv = sub(q, p), dot(u, v)
    below = 1.0 - uv * uv
    s = (dot(u, w) - uv * dot(v, w)) / below
    t = (uv * dot(u, w) - dot(v, w)) / below
    return add(p, scaled(s, u)), add(q, scaled(t, v))


def _parallel(u: Vector, v: Vector) -> bool:
    n = cross(u, v)
    return dot(n, n) < _TINY * _TINY


def dot(u: Vector, v: Vector) -> float:
    """The inner product."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vector, v: Vector) -> Vector:
    """The vector product."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def add(u: Vector, v: Vector) -> Vector:
    """u + v."""
    return u[0] + v[0], u[1] + v[1], u[2] + v[2]


def sub(u: Vector, v: Vector) -> Vector:
    """u - v."""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


def scaled(a: float, u: Vector) -> Vector:
    """a u."""
    return a * u[0], a * u[1], a * u[2]


def mix(a: float, u: Vector, b: float, v: Vector) -> Vector:
    """a u + b v."""
    return a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]


# Two walks side by side


class Difference(NamedTuple):
    """What differs in a gap: the key of its sentence, the row and entry it shows in, what it is in
    both tables (m, rad, or words), and the joints it lies between, 0 for the base and the tip."""

    key: str
    row: int
    entry: str
    mine: Any
    reference: Any
    ends: tuple[int, int] = (0, 0)


@dataclass(frozen=True)
class Side:
    """One table's walk, ready to be compared: `foot` is how far axis 1 passes from z_0 and how far
    it leans from it, none but where fixed rows come first; `axis` is its direction, and `up` is 1,
    or -1 where it points down.
    """

    rows: tuple[Numbers, ...]
    joints: list[int]
    gaps: list[Gap]
    tilt: float
    foot: tuple[float, float]
    axis: Vector
    up: int


@dataclass(frozen=True)
class Compared:
    """The differences that are left once each axis of the reference is turned the way that makes
    them fewest; those of the joints alone where they do not correspond.
    """

    differences: tuple[Difference, ...]
    signs: tuple[int, ...] = ()
    base_higher: float = 0.0
    upside_down: bool = False
    tilts: tuple[float, float] = (0.0, 0.0)


def side(rows: Rows) -> Side:
    """A table's walk; it needs a joint."""
    axis = frames(rows[: joints(rows)[0] - 1], ())[-1]
    up = -1 if axis.z[2] < -_TINY else 1
    return Side(
        tuple(rows), joints(rows), gaps(rows), tool_tilt(rows), _foot(rows, axis), axis.z, up
    )


def _foot(rows: Rows, axis: Frame) -> tuple[float, float]:
    n = cross(BASE.z, axis.z)
    sine = math.sqrt(dot(n, n))
    far = abs(dot(axis.o, n)) / sine if sine > _TINY else math.hypot(*axis.o[:2])
    turns = rows[joints(rows)[0] - 1].kind == "R"
    return far if turns else 0.0, _arc(abs(axis.z[2]))


def compared(mine: Side, reference: Side, length: float = 1e-6, angle: float = 1e-4) -> Compared:
    """Compare two arms, lengths to within `length` (m) and angles to within `angle` (rad).

    The signs of the axes are chosen gap by gap from the base on, keeping for each sign of the last
    axis the cheapest choice.
    """
    unlike = tuple(_unlike(mine, reference))
    if unlike:
        return Compared(unlike)
    feet = tuple(_stands(mine, reference, length, angle))
    far = sum(abs(x.mine - x.reference) for x in feet)
    best: dict[int, tuple] = {s: ((len(feet), far, 0), (s,), feet) for s in (1, -1)}
    for m, r in zip(mine.gaps, reference.gaps, strict=True):
        best = _step(mine, reference, m, r, best, length, angle)
    ends = []
    for last, (cost, signs, found) in best.items():
        tilts = (_arc(mine.tilt), _arc(last * reference.tilt))
        note = angle_between(*tilts) > angle
        ends.append(((cost[0], cost[1], cost[2] + note, -sum(signs)), signs, found, tilts))
    _, signs, found, tilts = min(ends, key=lambda end: end[0])
    upside_down = _upside_down(mine, reference, signs)
    return Compared(found, signs, _base_higher(mine, reference, signs), upside_down, tilts)


def _upside_down(mine: Side, reference: Side, signs: tuple[int, ...]) -> bool:
    """Whether z_0 points the other way, where axis 1 tells."""
    return not _level(mine) and signs[0] * mine.up * reference.up < 0


def _level(one: Side) -> bool:
    """Whether axis 1 points neither up nor down."""
    return abs(one.axis[2]) < _TINY


def _step(
    mine: Side, reference: Side, m: Gap, r: Gap, best: dict, length: float, angle: float
) -> dict:
    """The cheapest choices up to the end of a gap, for each sign of its last joint; the gap begins
    with the last one's end.
    """
    found: dict[int, tuple] = {}
    alike = m.places_base and r.places_base and m.bunch == r.bunch
    for signs in product((1, -1), repeat=len(m.joints)):
        (count, far, notes), before, old = best[signs[0]]
        new = tuple(
            _differences(mine, m, r, dict(zip(m.joints, signs, strict=True)), length, angle)
        )
        note = alike and abs(_height(m, r, signs[0])) > length
        over = _upside_down(mine, reference, before)
        turned = over or (_level(mine) and before[0] * dot(mine.axis, reference.axis) < 0)
        if note and over and mine.joints[0] == 1:
            new += (Difference("table base", 1, "d", m.offset, -(r.offset or 0.0)),)
        far += sum(abs(x.mine - x.reference) for x in new)
        cost = (count + len(new), round(far, 9), notes + note + turned)
        choice = (cost, before + signs[1:], old + new)
        last = signs[-1]
        if last not in found or choice[0] < found[last][0]:
            found[last] = choice
    return found


def _height(m: Gap, r: Gap, sign: int) -> float:
    return sign * (r.offset or 0.0) - (m.offset or 0.0)


def _base_higher(mine: Side, reference: Side, signs: tuple[int, ...]) -> float:
    m, r = (next((g for g in s.gaps if g.places_base), None) for s in (mine, reference))
    if m is None or r is None or m.bunch != r.bunch:
        return 0.0
    # The height is along the last of parallel axes, which may point the other way than axis 1.
    turned = math.prod(g.shape[g.joints] for g in mine.gaps[1 : len(m.bunch)])
    return mine.up * round(turned) * _height(m, r, signs[m.bunch[-1]])


def _unlike(mine: Side, reference: Side) -> Iterator[Difference]:
    if len(mine.joints) != len(reference.joints):
        row = mine.joints[min(len(mine.joints), len(reference.joints)) - 1]
        yield Difference("table count", row, "joints", len(mine.joints), len(reference.joints))
        return
    names = {"R": "revolute", "P": "prismatic"}
    for i, j in zip(mine.joints, reference.joints, strict=True):
        kind, wanted = names[mine.rows[i - 1].kind], names[reference.rows[j - 1].kind]
        if kind != wanted:
            yield Difference("table kind", i, "joint", kind, wanted)


def _stands(mine: Side, reference: Side, length: float, angle: float) -> Iterator[Difference]:
    """Where axis 1 stands to z_0; the other way along it is free."""
    (far, lean), (other, wanted) = mine.foot, reference.foot
    ends = (0, mine.joints[0])
    if abs(lean - wanted) > angle:
        yield Difference("table lean", 1, "alpha", lean, wanted, ends)
    if abs(far - other) > length:
        yield Difference("table foot", 1, "a", far, other, ends)


def _differences(
    mine: Side, m: Gap, r: Gap, signs: dict[int, int], length: float, angle: float
) -> Iterator[Difference]:
    first = mine.joints[m.joints[0]]
    if abs(m.length - r.length) > length:
        end = 0 if m.to_tip else mine.joints[m.joints[-1]]
        yield Difference("table distance", first, "a", m.length, r.length, (first, end))
    twists = list(_twists(mine, m, r, signs, angle))
    yield from twists or _slide(mine, m, r, signs, angle)
    if m.from_base or m.bunch != r.bunch:
        return
    if m.offset is not None and r.offset is not None:
        wanted = signs[m.joints[0]] * r.offset
        if abs(m.offset - wanted) > length:
            ends = (mine.joints[m.bunch[0]], mine.joints[m.bunch[-1]])
            yield Difference("table along", ends[1], "d", m.offset, wanted, ends)


def _twists(
    mine: Side, m: Gap, r: Gap, signs: dict[int, int], angle: float
) -> Iterator[Difference]:
    for i, j in pairwise(m.joints):
        sided = len(m.joints) == 2 and (i, j, NORMAL) in m.shape and (i, j, NORMAL) in r.shape
        x, y = _twist(m, (i, j), sided, {}), _twist(r, (i, j), sided, signs)
        if angle_between(x, y) > angle:
            ends = (mine.joints[i], mine.joints[j])
            yield Difference("table between", ends[0], "alpha", x, y, ends)


def _twist(gap: Gap, pair: tuple[int, int], sided: bool, signs: dict[int, int]) -> float:
    """The angle between two axes: about their common normal if `sided`, else between 0 and pi."""
    cosine = _product(gap, pair, signs)
    return math.atan2(_product(gap, (*pair, NORMAL), signs), cosine) if sided else _arc(cosine)


def _product(gap: Gap, which: tuple[int, ...], signs: dict[int, int]) -> float:
    """One of the gap's products, each joint's direction turned by its sign."""
    found = gap.shape[which]
    for k in which:
        found *= signs.get(k, 1)
    return found


def _slide(mine: Side, m: Gap, r: Gap, signs: dict[int, int], angle: float) -> Iterator[Difference]:
    """A slide does not turn: it holds what comes before and after it at an angle about itself, and
    the shortest way across it points one way.
    """
    slides = any(mine.rows[mine.joints[k] - 1].kind == "P" for k in m.joints)
    both = m.shape.keys() & r.shape.keys() if slides else ()
    if all(abs(m.shape[which] - _product(r, which, signs)) <= angle for which in both):
        return
    for row, x, y in _held(mine, m, r, signs):
        if angle_between(x, y) > angle:
            yield Difference("table held", row, "theta", x, y)
            return
    start, end = (mine.joints[m.joints[k]] for k in (0, -1))
    ends = (start, 0 if m.to_tip else end)
    yield Difference("table side", start, "a", 0.0, math.pi, ends)


def _held(mine: Side, m: Gap, r: Gap, signs: dict[int, int]) -> Iterator[tuple[int, float, float]]:
    """The row of each slide between axes that are not parallel to it, and the angle about it from
    the common normal before it to the one after it, these taken the way that is nearer to theta.
    """

    def skew(i: int, k: int) -> bool:
        return 1 - m.shape[i, k] ** 2 > _TINY

    for k in m.joints[1:-1]:
        before = [i for i in m.joints if i < k and skew(i, k)]
        after = [j for j in m.joints if j > k and skew(k, j)]
        if before and after:
            three, row = (before[-1], k, after[0]), mine.joints[k]
            # Not at a right angle, where it would be left to rounding.
            back = angle_between(_about(m, three, {}, 1), mine.rows[row - 1].theta) > 2
            way = -1 if back else 1
            yield row, _about(m, three, {}, way), _about(r, three, signs, way)


def _about(gap: Gap, three: tuple[int, int, int], signs: dict[int, int], way: int) -> float:
    """The angle about the second of three axes from the common normal of the first two to that of
    the last two.
    """
    i, k, j = three
    u, v, w = (_product(gap, pair, signs) for pair in ((i, k), (k, j), (i, j)))
    found = math.atan2(way * _product(gap, three, signs), way * (u * v - w))
    return math.pi if found < _TINY - math.pi else found


def _arc(cosine: float) -> float:
    """The angle (rad) with this cosine, rounding past 1 forgiven."""
    return math.acos(max(-1.0, min(1.0, cosine)))


def angle_between(left: float, right: float) -> float:
    """How far two angles (rad) are apart, whole turns aside."""
    return abs((left - right + math.pi) % (2 * math.pi) - math.pi)
