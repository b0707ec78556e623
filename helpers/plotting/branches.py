"""Draw the triangles of inverse kinematics, and regions of start values by their result."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, PathPatch
from matplotlib.path import Path
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, finite_array, finite_number, require_type
from helpers.kinematics import link_frames
from helpers.plotting.drawing import draw_angle
from helpers.plotting.plane import compute_frames, plot_arm
from helpers.plotting.style import BLUE, GREY, ORANGE, PURPLE, RED, SLATE

Array = NDArray[np.float64]


def draw_shoulder_triangles(
    ax: Axes, point: ArrayLike, offset: float, names: tuple[str, str], symbols: tuple[str, str]
) -> None:
    """Draw the two right triangles that give the first joint angle of a point, seen from above.

    The hypotenuse leads from the first axis to the point. One leg is the offset of the arm's plane
    from the axis, the other the reach in that plane.

    Args:
        ax: Axes to draw on.
        point: x and y of the point, shape (2,), m.
        offset: Distance of the plane from the axis, m. Without one both triangles lie on their
            hypotenuse, which alone is drawn.
        names: Names of the solutions with the shoulder on the left and on the right.
        symbols: Symbols of the leg along the offset and of the leg along the reach.
    """
    point = finite_array(point, "point", "two finite coordinates in m", (2,))
    offset = finite_number(offset, "offset", "a length in m, 0 or more", least=0)
    distance = float(np.hypot(*point))
    if distance <= offset:
        raise ArmError(
            f"point is {distance:g} m from the axis; expected more than the offset {offset:g}"
        )
    heading, half = np.arctan2(point[1], point[0]), np.arccos(offset / distance)
    ax.add_patch(Circle((0, 0), offset, fill=False, ls=":", color=GREY))
    ax.plot(*np.stack([(0, 0), point], axis=1), color=RED, lw=1.2, ls="--")
    if not offset:
        return
    for side, name, colour in zip((1, -1), names, (BLUE, ORANGE), strict=True):
        direction = heading + side * half
        foot = offset * np.array([np.cos(direction), np.sin(direction)])
        ax.plot(*np.stack([(0, 0), foot, point], axis=1), color=colour, lw=2)
        _write_beside(ax, 0 * foot, foot, symbols[0], 0.07 * distance * side)
        _write_beside(ax, foot, point, symbols[1], 0.07 * distance * side)
        x, y = 1.3 * foot
        ax.text(x, y, name, ha="center", va="center")
    ax.plot(0, 0, "o", color=SLATE, ms=7)
    ax.plot(*point, "*", color=RED, ms=11)
    ax.set_aspect("equal")


def draw_ur_triangle(ax: Axes, arm: Arm, q: ArrayLike) -> None:
    """Draw a UR arm in its own plane, with the triangle of joints 2 and 3 and the step d_5.

    x_1 points right and z up. `arm` has the rows of the homework's table; q has shape (6,).
    """
    _require_rows(arm, 6, "an arm of the UR family")
    T = compute_frames(arm, q)
    points = np.stack([T[:, :3, 3] @ T[1, :3, 0], T[:, 2, 3]], axis=1)[[1, 2, 3, 5]]
    shoulder, elbow, end, wrist = points
    ax.plot(*np.stack([(0, 0), shoulder], axis=1), color=GREY, lw=4, alpha=0.5)
    ax.plot(*points.T, color=GREY, lw=4, alpha=0.75, solid_joinstyle="round")
    ax.plot(*points[:3].T, "o", color=SLATE, ms=8)
    ax.plot(*wrist, "*", color=RED, ms=11)
    vertical = np.stack([shoulder, shoulder + np.array([0, 0.3])], axis=1)
    ax.plot(*vertical, color=GREY, lw=0.8, ls="--")
    _draw_triangle(ax, points[:3], 0.06, ("$r_4$", "$s_4$"))
    _write_beside(ax, end, wrist, "$d_5$", 0.06)
    lean, fore = _compute_direction(shoulder, elbow), _compute_direction(elbow, end)
    draw_angle(ax, shoulder, 0.2, (lean, 90), "$q_2$")
    draw_angle(ax, elbow, 0.15, (fore, lean), "$q_3$")
    ax.text(wrist[0] + 0.05, wrist[1] + 0.03, "$o_5$", color=RED, ha="left")
    ax.set(xlabel="along $x_1$ (m)", ylabel="$z$ (m)", aspect="equal")


def draw_law_of_cosines(ax: Axes, arm: Arm, q: ArrayLike) -> None:
    """Draw an elbow arm in its own plane, with the triangle that gives its joint angles.

    A second, right triangle shows the tip's foot on the line of the first link. The arm has no
    offset at its shoulder; q has shape (3,), and q_1 is taken as 0.
    """
    _require_rows(arm, 3, "an elbow arm")
    q = np.array([0.0, *arm.joint_vector(q, many=False)[1:]])
    shoulder, elbow, tip = points = link_frames(arm, q)[1:4, [0, 2], 3]
    plot_arm(ax, arm, q)
    _draw_triangle(ax, points, 0.04, ("$r$", "$s$"))
    along = (elbow - shoulder) / np.linalg.norm(elbow - shoulder)
    foot = shoulder + along * ((tip - shoulder) @ along)
    ax.plot(*np.stack([elbow, foot, tip], axis=1), color=PURPLE, lw=1.2, ls="-.")
    _write_beside(ax, elbow, foot, r"$a_3\cos\theta_3$", 0.07)
    _write_beside(ax, foot, tip, r"$-a_3\sin\theta_3$", 0.07)
    lift, bend = np.degrees(q[1:3])
    draw_angle(ax, shoulder, 0.13, (0, lift), r"$\theta_2$")
    draw_angle(
        ax, shoulder, 0.21, (_compute_direction(shoulder, tip), lift), r"$\beta$", colour=ORANGE
    )
    draw_angle(ax, elbow, 0.09, (lift + bend, lift), r"$-\theta_3$")
    draw_angle(ax, elbow, 0.06, (lift + 180, lift + 360 + bend), r"$\varphi$", colour=ORANGE)
    ax.set(ylim=(shoulder[1] - 0.12, max(elbow[1], foot[1]) + 0.07))


def _require_rows(arm: Arm, rows: int, kind: str) -> None:
    """Raise ArmError unless an arm has this number of rows, all revolute."""
    require_type(arm, Arm, "arm")
    if len(arm.rows) != rows or arm.dof != rows or not arm.turning.all():
        raise ArmError(f"{arm.name} is no {kind.partition(' ')[2]}; expected {rows} turning joints")


def _draw_triangle(ax: Axes, points: Array, distance: float, legs: tuple[str, str]) -> None:
    """Draw the triangle of shoulder, elbow and end, with the legs from the shoulder to the end.

    Args:
        ax: Axes to draw on.
        points: Shoulder, elbow and end, shape (3, 2), m.
        distance: Distance of each name from its side, m.
        legs: Symbols of the horizontal and of the vertical leg.
    """
    shoulder, elbow, end = points
    corner, ahead = np.array([end[0], shoulder[1]]), elbow + 0.5 * (elbow - shoulder)
    ax.plot(*np.stack([shoulder, end], axis=1), color=RED, lw=1.2, ls="--")
    ax.plot(*np.stack([shoulder, corner, end], axis=1), color=GREY, lw=1, ls=":")
    ax.plot(*np.stack([elbow, ahead], axis=1), color=GREY, lw=0.8, ls="--")
    _write_beside(ax, shoulder, elbow, "$a_2$", distance)
    _write_beside(ax, elbow, end, "$a_3$", distance)
    _write_beside(ax, corner, shoulder, legs[0], distance)
    _write_beside(ax, corner, end, legs[1], distance)


def _write_beside(ax: Axes, start: Array, stop: Array, text: str, distance: float) -> None:
    """Write a text to the left of the middle of a line."""
    step = stop - start
    x, y = (start + stop) / 2 + distance * np.array([-step[1], step[0]]) / np.linalg.norm(step)
    ax.text(x, y, text, ha="center", va="center")


def _compute_direction(start: Array, stop: Array) -> float:
    """Return the direction from `start` to `stop` in degrees, counterclockwise from x."""
    return float(np.degrees(np.arctan2(*(stop - start)[::-1])))


def plot_regions(
    ax: Axes,
    x: ArrayLike,
    y: ArrayLike,
    which: ArrayLike,
    names: dict[int, str],
    *,
    colours: tuple[str, ...],
) -> None:
    """Colour the cells around the points of an even grid by the region they belong to.

    Args:
        ax: Axes to draw on.
        x: Horizontal coordinates of the grid, shape (n,).
        y: Vertical coordinates of the grid, shape (m,).
        which: Number of each point's region, shape (m, n).
        names: Name in the legend by number of region; regions without a name stay white.
        colours: Colour of each named region.
    """
    x, y = (finite_array(v, n, "finite values (n,)", (None,)) for v, n in ((x, "x"), (y, "y")))
    which = finite_array(which, "which", f"whole numbers ({len(y)}, {len(x)})", (len(y), len(x)))
    require_type(names, dict, "names")
    hatches = ("", "//", "\\\\", "--", "||")
    half_x, half_y = (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    codes = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    for (value, name), colour, hatch in zip(names.items(), colours, hatches, strict=False):
        # Draw a rectangle for each run of neighbouring grid points in a row of the region.
        edge = np.diff(np.pad((which == value).astype(int), ((0, 0), (1, 1))), axis=1)
        rows, first = np.nonzero(edge == 1)
        last = np.nonzero(edge == -1)[1] - 1
        low, high = y[rows] - half_y, y[rows] + half_y
        left, right = x[first] - half_x, x[last] + half_x
        corners = np.array([[left, low], [right, low], [right, high], [left, high], [left, low]])
        outline = Path(corners.transpose(2, 0, 1).reshape(-1, 2), codes * len(rows))
        patch = PathPatch(outline, lw=0, label=name)
        patch.set(facecolor=colour, alpha=0.45, hatch=hatch)
        ax.add_patch(patch)
    ax.autoscale_view()
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def draw_wrist_triangles(ax: Axes, twists: tuple[float, float], apart: float) -> None:
    """Draw the two spherical triangles of a wrist on the sphere of directions.

    The corners are the directions of axes 4, 5 and 6. Axes 4 and 6 are given, axis 5 lies at the
    twists from them, on either side.

    Args:
        ax: The axes to draw into.
        twists: Angles between axes 4 and 5 and between axes 5 and 6, in degrees.
        apart: Angle between axes 4 and 6, in degrees.

    Raises:
        ArmError: There is no triangle with these sides.
    """
    sides = finite_array(twists, "twists", "two angles in degrees", (2,))
    apart = finite_number(apart, "apart", "an angle in degrees between 0 and 180", above=0)
    first, second, across = np.radians([*sides, apart])
    # Spherical law of cosines for the angle at axis 4.
    cosine = (np.cos(second) - np.cos(first) * np.cos(across)) / (np.sin(first) * np.sin(across))
    if not abs(cosine) < 1:
        raise ArmError(f"twists are {twists}, apart is {apart:g}; expected sides of a triangle")
    fourth = np.array([np.sin(across / 2), 0, np.cos(across / 2)])
    sixth = fourth * [-1, 1, 1]
    ahead = np.array([-np.cos(across / 2), 0, np.sin(across / 2)])  # from axis 4 towards axis 6
    ax.add_patch(Circle((0, 0), 1, fill=False, color=GREY, lw=0.8))
    _draw_great_circle(ax, fourth, sixth, RED, "--")
    for side, colour in ((1, BLUE), (-1, ORANGE)):
        leaning = cosine * ahead + side * np.sqrt(1 - cosine**2) * np.array([0, 1.0, 0])
        fifth = np.cos(first) * fourth + np.sin(first) * leaning
        _draw_great_circle(ax, fourth, fifth, colour, "-")
        _draw_great_circle(ax, fifth, sixth, colour, "-")
        _mark_direction(ax, fifth, "$z_4$" if side > 0 else "$z_4'$", colour)
    _mark_direction(ax, fourth, "$z_3$", SLATE)
    _mark_direction(ax, sixth, "$z_5$", SLATE)
    ax.set(xlim=(-1.15, 1.15), ylim=(-1.15, 1.15), aspect="equal")
    ax.axis("off")


def _draw_great_circle(ax: Axes, start: Array, stop: Array, colour: str, style: str) -> None:
    """Draw the shorter arc between two unit vectors, seen along z."""
    share = np.linspace(0, 1, 40)[:, None]
    arc = (1 - share) * start + share * stop
    arc /= np.linalg.norm(arc, axis=1, keepdims=True)
    ax.plot(arc[:, 0], arc[:, 1], color=colour, lw=2, ls=style)


def _mark_direction(ax: Axes, vector: Array, name: str, colour: str) -> None:
    """Mark a unit vector on the sphere, seen along z, with its name outside."""
    ax.plot(*vector[:2], "o", color=colour, ms=7)
    x, y = 1.22 * vector[:2]
    ax.text(x, y, name, ha="center", va="center", color=colour)
