"""Find all solutions of an arm from its structure (`helpers.inverse.structure`).

A target T is a motion G = T T_ref^-1 of the tip away from its pose at the reference. It is the
product of the joints' motions, G = E_1 E_2 ... E_n, in which E_i turns about (or slides along)
axis i by q_i - q_ref,i. Everything below is about lines and points, so that no Denavit-Hartenberg
parameter, tool or base enters.

Three joints place a point w: E_1 E_2 E_3 w = p. Joint 3 moves w along a circle; joint 1, undone,
moves p along another. Joint 2 must take a point of the one to a point of the other, and leaves two
numbers of a point alone: the height along its axis and the squared distance from a point of it. In
the plane of these two numbers the circles are ellipses, and a solution is a point where they cross.
Where neighbouring axes meet or are parallel, one ellipse is flattened to a segment, and the
equation a cos q + b sin q = c, twice, gives all crossings.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers.inverse.axes import (
    Array,
    JointAxis,
    cross,
    dot,
    invert_transform,
    move_direction,
    move_point,
    perpendicular_part,
    rotate,
    transform_direction,
    transform_point,
    unit_perpendicular,
)
from helpers.inverse.curves import Flatness, compute_invariants, find_flatness, joint_curve
from helpers.inverse.equations import (
    Roots,
    angle_between,
    double,
    solve_cosine_sine,
    solve_quadratic,
    turns_to_angle,
)
from helpers.inverse.structure import (
    FIRST_THREE_MEET,
    NEARLY,
    PARALLEL,
    PLANAR_2R,
    POSITION,
    WRIST,
    Structure,
    meeting_point,
)

Mask = NDArray[np.bool_]


@dataclass
class Candidates:
    """Joint motions that may solve each target, with their choices of roots and free joints.

    Attributes:
        motions: for each joint, in the order of the structure's axes, (branches, batch), rad or m.
        choices: the name of each choice between two roots, first to last.
        equal: for each choice, whether both roots are one, (branches before the choice, batch).
        free: for a joint's index, where any motion will do, (branches, batch).
    """

    motions: list[Array]
    choices: list[str] = field(default_factory=list)
    equal: list[Mask] = field(default_factory=list)
    free: dict[int, Mask] = field(default_factory=dict)


def find_candidates(structure: Structure, targets: Array, start: Array) -> Candidates:
    """Return every combination of roots for a batch of targets.

    Args:
        targets: poses (4, 4, batch), or positions (3, batch) for POSITION and PLANAR_2R.
        start: motions that free joints take, (dof, batch).
    """
    axes, size = structure.axes, structure.size
    tip = structure.tip[:3, 3][:, None, None]
    if structure.kind == POSITION:
        return _place_point(axes, tip, targets[:, None], size, start)
    if structure.kind == PLANAR_2R:
        # A third parallel axis through the tip makes it an arm of three parallel joints. Their last
        # angle is not used.
        three = (*axes, JointAxis(axes[0].direction, tip, True))
        goal, start = targets[:, None], np.concatenate([start, start[:1]])
        found = _find_triangle_candidates(three, lambda x: goal + 0 * x, size, start)
        return replace(found, motions=found.motions[:2])
    G = np.einsum("ijn,jk->ikn", targets, np.linalg.inv(structure.tip))
    if structure.kind == WRIST:
        return _find_wrist_candidates(structure, axes, G, start)
    if structure.kind == FIRST_THREE_MEET:
        # An arm whose first three axes meet is a wrist if it is counted from the tip.
        found = _find_wrist_candidates(structure, axes[::-1], invert_transform(G), -start[::-1])
        free = {5 - joint: where for joint, where in found.free.items()}
        return replace(found, motions=[-motion for motion in found.motions[::-1]], free=free)
    if structure.kind == PARALLEL:
        return _find_parallel_candidates(structure, G, start)
    return _find_planar_candidates(structure, G, start)


def _solve_along(
    n: Array, conic: tuple[Array, bool], c: Array, size: float, chosen: Array
) -> Roots:
    """Solve n . (A (x, y)) = c for the joint value of a curve, given as A and whether it turns."""
    A, turns = conic
    a, b = (n[0] * A[0, i] + n[1] * A[1, i] for i in (0, 1))
    return solve_cosine_sine(a, b, c, size, chosen) if turns else solve_quadratic(a, b, c, size)


def _invariants_at(A: Array, q: Array, turns: bool) -> Array:
    """Return the invariants A (x, y) at joint values q."""
    x, y = (np.cos(q), np.sin(q)) if turns else (q, q * q)
    return A[:, 0] * x + A[:, 1] * y


def _place_point(
    axes: tuple[JointAxis, ...], w: Array, p: Array, size: float, start: Array
) -> Candidates:
    """Return the motions of three joints that take the point w to p, E_1 E_2 E_3 w = p.

    Args:
        w: (3, 1, 1), in m.
        p: (3, 1, batch), in m.
        start: motions that free joints take, (3, batch).

    The structure was found, so one of the curves is a segment or both are circles or parabolas.
    """
    first, second, third = axes
    flat_1, flat_3 = find_flatness(first, second, size), find_flatness(third, second, size)
    A_1, b_1 = compute_invariants(second, joint_curve(first, p), size)  # of -q_1
    A_3, b_3 = compute_invariants(second, joint_curve(third, w), size)
    if flat_3.width < NEARLY:
        shoulder, elbow = _cross_segment(
            flat_3, (A_3, b_3, third.turns), (A_1, b_1, first.turns), size, (start[2], -start[0])
        )
        choices = [(_root_name("shoulder", first), shoulder), (_root_name("elbow", third), elbow)]
        q_1, q_3 = -double(shoulder.values), elbow.values
        free = {0: double(double(shoulder.free)), 2: double(elbow.free)}
    elif flat_1.width < NEARLY:
        elbow, shoulder = _cross_segment(
            flat_1, (A_1, b_1, first.turns), (A_3, b_3, third.turns), size, (-start[0], start[2])
        )
        choices = [(_root_name("elbow", third), elbow), (_root_name("shoulder", first), shoulder)]
        q_1, q_3 = -shoulder.values, double(elbow.values)
        free = {0: double(shoulder.free), 2: double(double(elbow.free))}
    else:
        shoulder, q_3 = _cross_alike((A_1, b_1), (A_3, b_3), first.turns, -start[0])
        choices = [(_root_name("shoulder", first), shoulder)]
        q_1, free = -shoulder.values, {0: double(shoulder.free)}
    q_1, q_3 = np.broadcast_arrays(q_1, q_3)
    near, far = move_point(third, q_3, w), move_point(first, -q_1, p)
    if second.turns:
        q_2, free[1] = angle_between(
            second.direction, near - second.point, far - second.point, size, start[1]
        )
    else:
        q_2 = dot(second.direction, far - near)
    names, roots = zip(*choices, strict=True)
    return Candidates([q_1, q_2, q_3], list(names), [root.equal for root in roots], free)


def _root_name(name: str, axis: JointAxis) -> str:
    """Name the choice between two roots of a joint.

    A sliding joint is a rod.
    """
    return name if axis.turns else "rod"


def _cross_segment(
    flat: Flatness,
    segment: tuple[Array, Array, bool],
    conic: tuple[Array, Array, bool],
    size: float,
    start: tuple[Array, Array],
) -> tuple[Roots, Roots]:
    """Return the joint values at which a conic crosses a segment: the conic's, then the segment's.

    Args:
        flat: the directions along and across the segment.
        segment, conic: A (2, 2, ...) and b (2, ...) of `compute_invariants`, and whether the joint
            turns.
        start: motions that the segment's and the conic's joint take where they are free.
    """
    (A_s, b_s, turns_s), (A_c, b_c, turns_c) = segment, conic
    along, across = flat.directions.T
    first = _solve_along(
        across, (A_c, turns_c), _multiply_by_normal(across, b_s - b_c), size, start[1]
    )
    offset = _invariants_at(A_c, first.values, turns_c) + b_c - b_s
    second = _solve_along(along, (A_s, turns_s), _multiply_by_normal(along, offset), size, start[0])
    return first, second


def _cross_alike(
    one: tuple[Array, Array], other: tuple[Array, Array], turns: bool, chosen: Array
) -> tuple[Roots, Array]:
    """Return the values of joints 1 and 3 at which two circles, or two parabolas, cross.

    Their difference is a line, so that no quartic is left.
    """
    (A_1, b_1), (A_3, b_3) = one, other
    inverse = np.linalg.inv(A_3[:, :, 0, 0])
    D = np.einsum("ij,jk...->ik...", inverse, A_1)
    e = np.einsum("ij,j...->i...", inverse, b_1 - b_3)
    if turns:  # |D (cos, sin) + e| = 1
        a, b = (2 * (D[0, i] * e[0] + D[1, i] * e[1]) for i in (0, 1))
        c = 1.0 - e[0] ** 2 - e[1] ** 2 - D[0, 0] ** 2 - D[1, 0] ** 2
        roots = solve_cosine_sine(a, b, c, 1.0, chosen)
    else:  # (D (q, q^2) + e)_0 squared is (D (q, q^2) + e)_1
        a, b = 2 * D[0, 0] * e[0] - D[1, 0], D[0, 0] ** 2 - D[1, 1]
        roots = solve_quadratic(a, b, e[1] - e[0] ** 2, 1.0)
    x, y = _invariants_at(D, roots.values, turns) + e
    return roots, np.arctan2(y, x) if turns else x


def _multiply_by_normal(n: Array, b: Array) -> Array:
    """Return the product of a constant direction of the plane with the invariants b (2, ...)."""
    return n[0] * b[0] + n[1] * b[1]


def _find_wrist_candidates(
    structure: Structure, axes: tuple[JointAxis, ...], G: Array, start: Array
) -> Candidates:
    """Return the motions of an arm whose last three axes meet in a point.

    The first three joints place this point, the last three the orientation.
    """
    w = structure.centre
    assert w is not None
    placed = _place_point(axes[:3], w, transform_point(G, w), structure.size, start[:3])

    def before(x: Array) -> Array:
        """Undo the motion of joints 1 to 3 on directions."""
        for axis, q in zip(axes[:3], placed.motions, strict=True):
            x = move_direction(axis, -q, x)
        return x

    fourth, fifth, sixth = (axis.direction for axis in axes[3:])
    wanted = before(transform_direction(G, sixth))
    roots = turns_to_angle(fifth, sixth + 0 * wanted, fourth, wanted)
    q_5, wanted = roots.values, double(wanted)
    q_4, singular = angle_between(fourth, rotate(fifth, q_5, sixth), wanted, 1.0, start[3])
    # Compute joint 6 from joint 4: near a straight wrist each angle is uncertain, and only their
    # sum is accurate.
    mark = cross(sixth, fifth)
    turned = double(before(transform_direction(G, mark)))
    turned = rotate(fifth, -q_5, rotate(fourth, -q_4, turned))
    q_6, _ = angle_between(sixth, mark, turned, 1.0, start[5])
    return Candidates(
        [*map(double, placed.motions), q_4, q_5, q_6],
        [*placed.choices, "wrist"],
        [*placed.equal, roots.equal],
        {**{joint: double(where) for joint, where in placed.free.items()}, 3: singular},
    )


def _find_parallel_candidates(structure: Structure, G: Array, start: Array) -> Candidates:
    """Return the motions of an arm with three parallel axes.

    The other three joints a, b, c follow the parallel ones in the loop that base and target close.
    Joints before the parallel ones are seen beyond the target, their axes moved back by it.
    """
    first, back = structure.first, invert_transform(G)
    three = structure.axes[first : first + 3]
    others = [(first + 3 + i) % 6 for i in range(3)]
    axes = [structure.axes[i] for i in others]
    axes = [
        JointAxis(
            transform_direction(back, axis.direction), transform_point(back, axis.point), axis.turns
        )
        if i < first
        else axis
        for i, axis in zip(others, axes, strict=True)
    ]
    loop = _Loop(three[0].direction, G, structure.size, start[others])
    met = None
    if others[1] == others[0] + 1:
        met = meeting_point((structure.axes[others[0]], structure.axes[others[1]]), loop.size)
    if met is not None:
        point = transform_point(back, met[0]) if others[0] < first else met[0]
        rest = _solve_last_joint_first(loop, axes, point)
    else:
        met = meeting_point((structure.axes[others[1]], structure.axes[others[2]]), loop.size)
        assert met is not None
        point = transform_point(back, met[0]) if others[1] < first else met[0]
        rest = _solve_first_joint_first(loop, axes, point)

    def planar(x: Array) -> Array:
        """Return the points to which the three parallel joints must move the points x."""
        for axis, q in zip(axes, rest.motions, strict=True):
            x = move_point(axis, -q, x)
        return transform_point(G, x)

    triangle = _find_triangle_candidates(three, planar, structure.size, start[first : first + 3])
    motions = {first + i: motion for i, motion in enumerate(triangle.motions)}
    motions |= {joint: double(q) for joint, q in zip(others, rest.motions, strict=True)}
    free = {first + i: where for i, where in triangle.free.items()}
    free |= {others[i]: double(where) for i, where in rest.free.items()}
    return Candidates(
        [motions[joint] for joint in range(6)],
        ["shoulder", "wrist", "elbow"],
        [*rest.equal, *triangle.equal],
        free,
    )


class _Loop(NamedTuple):
    """The direction (3, 1, 1) of three parallel axes, the motion G (4, 4, batch) that the arm must
    make, the arm's size in m, and motions (3, batch) that the other joints take where free."""

    parallel: Array
    G: Array
    size: float
    start: Array


def _solve_last_joint_first(loop: _Loop, axes: list[JointAxis], point: Array) -> Candidates:
    """Return the motions of joints a, b, c, if axes a and b meet in a point: c is solved first.

    Only joint c changes the height of the point along the parallel axes.
    """
    a, b, c = axes
    h, h_back = loop.parallel, transform_direction(invert_transform(loop.G), loop.parallel)
    curve = joint_curve(c, point)
    shift = dot(h, loop.G[:3, 3][:, None])
    height = dot(h, point) - shift - dot(h_back, curve.centre)
    roots = solve_cosine_sine(
        dot(h_back, curve.X), dot(h_back, curve.Y), height, loop.size, -loop.start[2]
    )
    q_c = -roots.values
    seen = rotate(c.direction, q_c, h_back)
    turns = turns_to_angle(b.direction, seen, a.direction, h)
    q_b, seen = turns.values, double(seen)
    turned = rotate(b.direction, q_b, seen)
    q_a, free = angle_between(a.direction, turned, h, 1.0, loop.start[0])
    return Candidates(
        [q_a, q_b, double(q_c)],
        equal=[roots.equal, turns.equal],
        free={0: free, 2: double(double(roots.free))},
    )


def _solve_first_joint_first(loop: _Loop, axes: list[JointAxis], point: Array) -> Candidates:
    """Return the motions of joints a, b, c, if axes b and c meet in a point: a is solved first."""
    a, b, c = axes
    h, h_back = loop.parallel, transform_direction(invert_transform(loop.G), loop.parallel)
    curve = joint_curve(a, point)
    height = dot(h, transform_point(loop.G, point)) - dot(h, curve.centre)
    roots = solve_cosine_sine(dot(h, curve.X), dot(h, curve.Y), height, loop.size, loop.start[0])
    seen = rotate(a.direction, -roots.values, h)
    turns = turns_to_angle(c.direction, h_back, b.direction, seen)
    turned = rotate(c.direction, turns.values, h_back)
    q_b, free = angle_between(b.direction, turned, double(seen), 1.0, loop.start[1])
    return Candidates(
        [double(roots.values), q_b, turns.values],
        equal=[roots.equal, turns.equal],
        free={1: free, 0: double(double(roots.free))},
    )


def _find_triangle_candidates(
    three: tuple[JointAxis, ...], planar: Callable[[Array], Array], size: float, start: Array
) -> Candidates:
    """Return the motions of three parallel joints that move points as `planar` does."""
    first, second, third = three
    flat = lambda x: perpendicular_part(first.direction, x)  # noqa: E731
    end = flat(planar(third.point) - first.point)
    curve = joint_curve(second, third.point)
    r, mark = flat(curve.centre - first.point), unit_perpendicular(first.direction)
    needed = (dot(end, end) - dot(r, r) - dot(curve.X, curve.X)) / size
    root = solve_cosine_sine(
        2 * dot(r, curve.X) / size, 2 * dot(r, curve.Y) / size, needed, size, start[1]
    )
    q_2 = root.values
    reached = flat(move_point(second, q_2, third.point) - first.point)
    q_1, free_1 = angle_between(first.direction, reached, double(end), size, start[0])
    heading = planar(third.point + mark) - planar(third.point)
    total, _ = angle_between(first.direction, mark, double(heading), 1.0, start[2])
    sign_2, sign_3 = (dot(axis.direction, first.direction) for axis in (second, third))
    q_3 = sign_3 * (total - q_1 - sign_2 * q_2)
    return Candidates([q_1, q_2, q_3], ["elbow"], [root.equal], {0: free_1, 1: double(root.free)})


def _find_planar_candidates(structure: Structure, G: Array, start: Array) -> Candidates:
    """Return the motions of a planar three-link arm or a SCARA arm."""
    axes = structure.axes
    turning = [i for i, axis in enumerate(axes) if axis.turns]
    found = _find_triangle_candidates(
        tuple(axes[i] for i in turning),
        lambda x: transform_point(G, x),
        structure.size,
        start[turning],
    )
    motions = dict(zip(turning, found.motions, strict=True))
    for i, axis in enumerate(axes):
        if not axis.turns:
            motions[i] = dot(axis.direction, transform_point(G, axis.point) - axis.point)
    free = {turning[i]: where for i, where in found.free.items()}
    return Candidates([motions[i] for i in range(len(axes))], found.choices, found.equal, free)
