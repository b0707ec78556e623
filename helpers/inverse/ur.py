"""Solve arms with three parallel axes in the middle, as Universal Robots builds them.

The parallel axes z_1, z_2, z_3 leave three problems, one after another. With the UR10e's twists:

1. The shoulder turns a plane beside the wrist's centre o_5 = (x_c, y_c, z_c), which is the tip less
   the tool along z_6. Along z_1 it lies d_4 from the base's axis, front or back:

       x_c sin(theta_1) - y_c cos(theta_1) = d_4

2. Only joints 5 and 6 turn the tool against z_1, so its axes seen along z_1 give both, with either
   sign of theta_5:

       z_6 . z_1 = cos(theta_5)
       x_6 . z_1 = sin(theta_5) cos(theta_6)        y_6 . z_1 = -sin(theta_5) sin(theta_6)

   Where sin(theta_5) = 0 the second line says nothing, and theta_6 may be chosen.

3. In the plane, r along the arm and s upwards from o_1, two links remain. They end at (r, s), which
   is o_5 less d_5 along z_4, and x_4 stands at the angle psi that the tool and joints 5 and 6 fix:

       r^2 + s^2 = a_2^2 + a_3^2 + 2 a_2 a_3 cos(theta_3)        theta_2 + theta_3 + theta_4 = psi

   The two signs of theta_3 are the two elbows; theta_2 follows as in the elbow arm's triangle.

Other twists of a right angle change signs, which `_read_shape` returns.
Source: Hawkins (2013), derived anew from the axes so that any signs of the twists will do.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, require_type
from helpers.inverse.geometry import (
    NOISE,
    REACH,
    SINGULAR,
    Links,
    Plane,
    Tool,
    remove_last_twist,
    solve_two_links,
    turn_plane_to_target,
    wrist_centre,
)
from helpers.inverse.solutions import (
    BranchArrays,
    Solutions,
    check_poses,
    each_branch,
    subtract_offset,
    wrap_angle,
)
from helpers.program import cosines_and_sines

Array = NDArray[np.float64]

# Below this sine of joint 5, round-off of joint 6 can move a target on the boundary out of reach.
UNCERTAIN = 1e-3
BRANCHES = (("front", "back"), ("q_5 > 0", "q_5 < 0"), ("elbow +", "elbow -"))


def ur(arm: Arm, targets: ArrayLike, start: ArrayLike | None = None) -> Solutions:
    """Return the eight branches of an arm of the UR family in closed form.

    Branches are named by the two directions in which joint 1 can turn the arm's plane to the wrist
    ("front", "back"), the sign of the angle in joint 5's row, and the sign of the elbow's bend
    about z_1.

    Args:
        arm: An arm of six revolute joints with alpha = (+-90, 0 or 180, 0 or 180, +-90, +-90, any)
            degrees and a_1 = a_4 = a_5 = 0.
        targets: Poses of the tip, shape (..., 4, 4).
        start: Values of free joints, shape (..., 6); zeros by default. Joint 6 is free if q_5 makes
            axes 4 and 6 parallel: it keeps this value, or gets one that brings the wrist within
            reach. If a single value does, with the elbow stretched or folded, joint 6 is not free.

    Raises:
        ArmError: The arm has another table, or a target is no pose.
    """
    require_type(arm, Arm, "arm")
    if not is_ur_arm(arm):
        raise ArmError(
            f"{arm.name} is no arm of the UR family; expected six revolute joints, alpha = (+-90,"
            " 0 or 180, 0 or 180, +-90, +-90, any) degrees, a_1 = a_4 = a_5 = 0 and links a_2, a_3;"
            " for other arms, calibrated ones for instance, use helpers.inverse.solutions"
        )
    return each_branch(arm, check_poses(arm, targets), start, BRANCHES, _solve_columns)


def _solve_columns(arm: Arm, columns: Array, start: Array) -> BranchArrays:
    """Solve poses in columns (16, batch) for all branches."""
    rows, shape, tool = arm.numeric, _read_shape(arm), remove_last_twist(arm, columns)
    plane = turn_plane_to_target(
        rows[0], shape.offset, wrist_centre(arm, tool), start[0] + rows[0].theta
    )
    wrist = _solve_wrist(arm, shape, plane, tool, start[5])
    end = _end_of_links(shape, (plane.x[:, None], plane.y[:, None]), (wrist.ux, wrist.uy))
    end, chosen = (end[0][:, :, None], end[1][:, :, None]), start[1] + rows[1].theta
    bend = solve_two_links(shape.links, end, _SIGNS, chosen, wrist.blur[:, None, None])
    heading = np.arctan2(wrist.uy, wrist.ux)[:, :, None]
    q = (
        subtract_offset(plane.phi, rows[0].theta)[:, None, None],
        subtract_offset(bend.phi_2, rows[1].theta),
        subtract_offset(rows[1].cos_alpha * bend.phi_3, rows[2].theta),
        wrap_angle(shape.turn_3 * (heading - bend.phi_2 - bend.phi_3) - rows[3].theta),
        subtract_offset(wrist.phi_5, rows[4].theta)[:, :, None],
        subtract_offset(wrist.phi_6, rows[5].theta)[:, :, None],
    )
    valid = plane.exists & bend.exists
    # Distances out of reach: perpendicular to the arm's plane, and for the links in the plane.
    x, y, _ = wrist_centre(arm, tool)
    aside, length = np.maximum(abs(shape.offset) - np.hypot(x, y), 0.0), np.hypot(*end)
    short = length - np.clip(length, shape.links.inner, shape.links.outer)
    missing = np.hypot(aside, short).min(axis=(0, 1, 2))
    one = wrist.singular[:, None, None]
    free = {0: plane.free, 1: bend.free}
    if one.any():
        free[5] = one & ~_is_isolated(shape, plane)[:, None, None]
    return BranchArrays(
        q,
        {joint: np.asarray(where) for joint, where in free.items() if where.any()},
        valid,
        (plane.is_double, one, bend.is_double),
        np.where(valid.any(axis=(0, 1, 2)), 0.0, missing),
    )


_SIGNS = np.array([1.0, -1.0])[:, None]


class Shape(NamedTuple):
    """Signs and lengths of the arm's table.

    Attributes:
        turn_3: Sign of axis 3 against z_1.
        side: Sign of z_4 against x_4 turned by a right angle in the plane.
        offset: Distance of the plane from the base's axis along z_1, m.
        links: The two links.
        step: Signed d_5, which follows the links, m.
    """

    turn_3: float
    side: float
    offset: float
    links: Links
    step: float


def _read_shape(arm: Arm) -> Shape:
    _, second, third, fourth, fifth, _ = arm.numeric
    turn_3 = second.cos_alpha * third.cos_alpha
    offset = second.d + second.cos_alpha * third.d + turn_3 * fourth.d
    side = -fourth.sin_alpha * turn_3
    return Shape(turn_3, side, offset, Links(second.a, third.a), side * fifth.d)


class Wrist(NamedTuple):
    """Both wrist branches of each shoulder branch, in arrays (2 shoulders, 2 wrists, batch).

    Attributes:
        phi_5: Joint 5's angle with its offset, rad.
        phi_6: Joint 6's angle with its offset, rad.
        ux: Component of x_4 along x_1.
        uy: Component of x_4 along y_1.
        singular: Where both wrists are the same, shape (2 shoulders, batch).
        blur: How far rounding may move the links' end, shape (2 shoulders, batch), m.
    """

    phi_5: Array
    phi_6: Array
    ux: Array
    uy: Array
    singular: NDArray[np.bool_]
    blur: Array


def _solve_wrist(arm: Arm, shape: Shape, plane: Plane, tool: Tool, start: Array) -> Wrist:
    """Compute joints 5 and 6 from the tool's axes along z_1, then x_4.

    In the plane z_5 is x_4 times sin(phi_5), and x_5 is x_4 times cos(phi_5). Together they give
    x_4 with full precision at every angle of the wrist. Where sin(phi_5) is 0, joint 6 keeps its
    value of `start`.
    """
    first, fifth, sixth = arm.numeric[0], arm.numeric[4], arm.numeric[5]
    c, s = cosines_and_sines(plane.phi)
    axes_x, axes_y, axes_z = tool.axes[:, :, None]
    along = first.sin_alpha * (s * axes_x - c * axes_y)
    (xx, yx, zx), (xy, yy, zy) = c * axes_x + s * axes_y, first.sin_alpha * axes_z
    sine = np.sqrt(along[0] * along[0] + along[1] * along[1])
    cosine = shape.side * fifth.sin_alpha * along[2]
    singular = sine < SINGULAR
    sine = np.where(singular, 0.0, sine)
    scale = shape.side / np.where(singular, 1.0, sine)
    c6, s6 = -scale * along[0], scale * along[1]
    phi_6 = np.arctan2(s6, c6)
    if singular.any():
        phi_6 = np.where(singular, start + sixth.theta, phi_6)
        c6, s6 = np.where(singular, np.cos(phi_6), c6), np.where(singular, np.sin(phi_6), s6)
    tilt = fifth.sin_alpha * sine
    ux = tilt * zx + cosine * (c6 * xx - s6 * yx)
    uy = tilt * zy + cosine * (c6 * xy - s6 * yy)
    phi_5 = np.arctan2(sine, cosine)
    flip = np.where(singular, 0.0, np.pi)
    sign = np.where(singular, 1.0, -1.0)
    wrist = Wrist(
        _stack_pair(phi_5, -phi_5),
        _stack_pair(phi_6, phi_6 - np.copysign(flip, phi_6)),
        _stack_pair(ux, sign * ux),
        _stack_pair(uy, sign * uy),
        singular,
        abs(shape.step) * NOISE / np.where(singular, np.inf, sine),
    )
    loose = np.nonzero(sine < UNCERTAIN)
    if loose[0].size:
        _bring_within_reach(arm, shape, plane, wrist, loose)
    return wrist


def _end_of_links(
    shape: Shape, centre: tuple[Array, Array], x_4: tuple[Array, Array]
) -> tuple[Array, Array]:
    """Return the end of the two links in the plane: the wrist's centre minus d_5 z_4."""
    return centre[0] + shape.step * x_4[1], centre[1] - shape.step * x_4[0]


def _is_isolated(shape: Shape, plane: Plane) -> NDArray[np.bool_]:
    """Return where only a single joint 6 lets the links reach, (2 shoulders, batch).

    The links must end on a circle of radius |d_5| about the wrist's centre (x, y), at a distance of
    r_min to r_max from the shoulder. A single point of the circle is within reach if its nearest
    point is r_max away, or its farthest point r_min.
    """
    far, arc = np.hypot(plane.x, plane.y), abs(shape.step)
    stretched = np.abs(far - arc) >= shape.links.outer - 2 * REACH
    folded = far + arc <= shape.links.inner + 2 * REACH
    return (stretched | folded) & (np.minimum(far, arc) > REACH)


def _bring_within_reach(
    arm: Arm, shape: Shape, plane: Plane, wrist: Wrist, loose: tuple[NDArray[Any], ...]
) -> None:
    """Change joint 6 so that the links reach the wrist, if this does not move the tool.

    If axes 4 and 6 are nearly parallel, turning x_4 against joint 6 turns the tool only by
    sin(phi_5) times as much. An isolated solution gets the only possible angle.

    Args:
        arm, shape, plane: The arm, its signs and lengths, and its plane.
        wrist: Angles to change, in place.
        loose: Indices of shoulders and poses with a small sine of joint 5.
    """
    both, at = (loose[0], slice(None), loose[1]), (*loose, None)
    centre, u = (plane.x[at], plane.y[at]), (wrist.ux[both], wrist.uy[both])
    end, arc = _end_of_links(shape, centre, u), abs(shape.step)
    far, length = np.hypot(*centre), np.hypot(*end)
    wanted = np.clip(length, shape.links.inner, shape.links.outer)
    # The angle at the wrist's centre from the shoulder to the links' end, rad.
    (x, y), (vx, vy) = centre, (centre[0] - end[0], centre[1] - end[1])
    angle, isolated = np.arctan2(x * vy - y * vx, x * vx + y * vy), _is_isolated(shape, plane)[at]
    cosine = (far**2 + arc**2 - wanted**2) / np.maximum(2 * far * arc, 1e-300)
    cosine = np.where(isolated, np.rint(cosine), cosine)
    turn = np.copysign(np.arccos(np.clip(cosine, -1.0, 1.0)), angle) - angle
    stays = np.abs(np.sin(wrist.phi_5[both]) * turn) <= SINGULAR
    turn = np.where(stays & (isolated | (length != wanted)), turn, 0.0)
    c, s = np.cos(turn), np.sin(turn)
    wrist.ux[both], wrist.uy[both] = c * u[0] - s * u[1], s * u[0] + c * u[1]
    along = shape.side * arm.numeric[4].sin_alpha * np.cos(wrist.phi_5[both])
    wrist.phi_6[both] = wrap_angle(wrist.phi_6[both] - np.sign(along) * turn)


def _stack_pair(one: Array, other: Array) -> Array:
    pair = np.empty((len(one), 2, *one.shape[1:]))
    pair[:, 0], pair[:, 1] = one, other
    return pair


def is_ur_arm(arm: Arm) -> bool:
    """Return whether an arm has the table of the UR family, with exact right angles."""
    rows = arm.numeric
    return (
        len(rows) == 6
        and all(row.kind == "revolute" for row in rows)
        and rows[0].a == rows[3].a == rows[4].a == 0.0
        and rows[0].cos_alpha == rows[3].cos_alpha == rows[4].cos_alpha == 0.0
        and rows[1].sin_alpha == rows[2].sin_alpha == 0.0
        and rows[1].a * rows[2].a != 0.0
    )
