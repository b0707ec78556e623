"""Draw inverse kinematics: two views of an elbow arm, regions of starts."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, PathPatch
from matplotlib.path import Path
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, finite_array, finite_number, require_type
from helpers.kinematics import link_frames
from helpers.plotting.drawing import angle
from helpers.plotting.plane import arm_2d, pose_frames
from helpers.plotting.style import BLUE, GREY, ORANGE, PURPLE, RED, SLATE

Array = NDArray[np.float64]


def shoulder_triangles(
    ax: Axes, point: ArrayLike, offset: float, names: tuple[str, str], letters: tuple[str, str]
) -> None:
    """Draw the two right triangles that turn an arm's plane to a point, seen from above: hypotenuse
    from the axis to the point, one leg the offset (m) of the plane, the other the reach in it.

    `names` are those of the shoulder on the left and on the right, `letters` those of the legs.
    """
    point = finite_array(point, "point", "two finite coordinates in m", (2,))
    offset = finite_number(offset, "offset", "a length in m that is above 0", above=0)
    far = float(np.hypot(*point))
    if far <= offset:
        raise ArmError(
            f"point is {far:g} m from the axis; expected more than the offset {offset:g}"
        )
    heading, half = np.arctan2(point[1], point[0]), np.arccos(offset / far)
    ax.add_patch(Circle((0, 0), offset, fill=False, ls=":", color=GREY))
    ax.plot(*np.stack([(0, 0), point], axis=1), color=RED, lw=1.2, ls="--")
    for side, name, colour in zip((1, -1), names, (BLUE, ORANGE), strict=True):
        way = heading + side * half
        foot = offset * np.array([np.cos(way), np.sin(way)])
        ax.plot(*np.stack([(0, 0), foot, point], axis=1), color=colour, lw=2)
        _beside(ax, 0 * foot, foot, letters[0], 0.07 * far * side)
        _beside(ax, foot, point, letters[1], 0.07 * far * side)
        x, y = 1.3 * foot
        ax.text(x, y, name, ha="center", va="center")
    ax.plot(0, 0, "o", color=SLATE, ms=7)
    ax.plot(*point, "*", color=RED, ms=11)
    ax.set_aspect("equal")


def ur_triangle(ax: Axes, arm: Arm, q: ArrayLike) -> None:
    """Draw a UR arm of the homework's table in its own plane, x_1 to the right, z up, from the
    shoulder to the wrist, with the triangle of joints 2 and 3 and the step d_5."""
    _require_rows(arm, 6, "an arm of the UR family")
    T = pose_frames(arm, q)
    points = np.stack([T[:, :3, 3] @ T[1, :3, 0], T[:, 2, 3]], axis=1)[[1, 2, 3, 5]]
    shoulder, elbow, end, wrist = points
    ax.plot(*np.stack([(0, 0), shoulder], axis=1), color=GREY, lw=4, alpha=0.5)
    ax.plot(*points.T, color=GREY, lw=4, alpha=0.75, solid_joinstyle="round")
    ax.plot(*points[:3].T, "o", color=SLATE, ms=8)
    ax.plot(*wrist, "*", color=RED, ms=11)
    upright = np.stack([shoulder, shoulder + np.array([0, 0.3])], axis=1)
    ax.plot(*upright, color=GREY, lw=0.8, ls="--")
    _triangle(ax, points[:3], 0.06, ("$r_4$", "$s_4$"))
    _beside(ax, end, wrist, "$d_5$", 0.06)
    lean, fore = _bearing(shoulder, elbow), _bearing(elbow, end)
    angle(ax, shoulder, 0.2, (lean, 90), "$q_2$")
    angle(ax, elbow, 0.15, (fore, lean), "$q_3$")
    ax.text(wrist[0] + 0.05, wrist[1] + 0.03, "$o_5$", color=RED, ha="left")
    ax.set(xlabel="along $x_1$ (m)", ylabel="$z$ (m)", aspect="equal")


def law_of_cosines(ax: Axes, arm: Arm, q: ArrayLike) -> None:
    """Draw an elbow arm without offset in its own plane, with the triangle that gives its angles,
    and the foot of its tip on the first link's line with its legs; q_1 is taken as 0."""
    _require_rows(arm, 3, "an elbow arm")
    q = np.array([0.0, *arm.joint_vector(q, many=False)[1:]])
    shoulder, elbow, tip = points = link_frames(arm, q)[1:4, [0, 2], 3]
    arm_2d(ax, arm, q)
    _triangle(ax, points, 0.04, ("$r$", "$s$"))
    along = (elbow - shoulder) / np.linalg.norm(elbow - shoulder)
    foot = shoulder + along * ((tip - shoulder) @ along)
    ax.plot(*np.stack([elbow, foot, tip], axis=1), color=PURPLE, lw=1.2, ls="-.")
    _beside(ax, elbow, foot, r"$a_3\cos\theta_3$", 0.07)
    _beside(ax, foot, tip, r"$-a_3\sin\theta_3$", 0.07)
    lift, bend = np.degrees(q[1:3])
    angle(ax, shoulder, 0.13, (0, lift), r"$\theta_2$")
    angle(ax, shoulder, 0.21, (_bearing(shoulder, tip), lift), r"$\beta$", colour=ORANGE)
    angle(ax, elbow, 0.09, (lift + bend, lift), r"$-\theta_3$")
    angle(ax, elbow, 0.06, (lift + 180, lift + 360 + bend), r"$\varphi$", colour=ORANGE)
    ax.set(ylim=(shoulder[1] - 0.12, max(elbow[1], foot[1]) + 0.07))


def _require_rows(arm: Arm, rows: int, kind: str) -> None:
    """Raise ArmError unless an arm has so many rows, all of which turn."""
    require_type(arm, Arm, "arm")
    if len(arm.rows) != rows or arm.dof != rows or not arm.turning.all():
        raise ArmError(f"{arm.name} is no {kind.partition(' ')[2]}; expected {rows} turning joints")


def _triangle(ax: Axes, points: Array, away: float, legs: tuple[str, str]) -> None:
    """The triangle of shoulder, elbow and end, shape (3, 2), the end's place over the shoulder, by
    its two legs, and where the first link points, with the sides' names so far (m) beside them."""
    shoulder, elbow, end = points
    corner, ahead = np.array([end[0], shoulder[1]]), elbow + 0.5 * (elbow - shoulder)
    ax.plot(*np.stack([shoulder, end], axis=1), color=RED, lw=1.2, ls="--")
    ax.plot(*np.stack([shoulder, corner, end], axis=1), color=GREY, lw=1, ls=":")
    ax.plot(*np.stack([elbow, ahead], axis=1), color=GREY, lw=0.8, ls="--")
    _beside(ax, shoulder, elbow, "$a_2$", away)
    _beside(ax, elbow, end, "$a_3$", away)
    _beside(ax, corner, shoulder, legs[0], away)
    _beside(ax, corner, end, legs[1], away)


def _beside(ax: Axes, start: Array, stop: Array, text: str, away: float) -> None:
    """Write a text to the left of the middle of a line."""
    step = stop - start
    x, y = (start + stop) / 2 + away * np.array([-step[1], step[0]]) / np.linalg.norm(step)
    ax.text(x, y, text, ha="center", va="center")


def _bearing(start: Array, stop: Array) -> float:
    return float(np.degrees(np.arctan2(*(stop - start)[::-1])))


def regions(
    ax: Axes,
    x: ArrayLike,
    y: ArrayLike,
    which: ArrayLike,
    names: dict[int, str],
    *,
    colours: tuple[str, ...],
) -> None:
    """Colour the cells around the points of an even grid by `which`, whole numbers of shape
    (len(y), len(x)); `names` are those in the legend."""
    x, y = (finite_array(v, n, "finite values (n,)", (None,)) for v, n in ((x, "x"), (y, "y")))
    which = finite_array(which, "which", f"whole numbers ({len(y)}, {len(x)})", (len(y), len(x)))
    require_type(names, dict, "names")
    hatches = ("", "//", "\\\\", "--", "||")
    for (value, name), colour, hatch in zip(names.items(), colours, hatches, strict=False):
        patch = PathPatch(_cells(x, y, which == value), lw=0, label=name)
        patch.set(facecolor=colour, alpha=0.45, hatch=hatch)
        ax.add_patch(patch)
    ax.autoscale_view()
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def _cells(x: NDArray, y: NDArray, inside: NDArray) -> Path:
    """Return a rectangle for each unbroken row of grid points inside a region."""
    half_x, half_y = (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    edge = np.diff(np.pad(inside.astype(int), ((0, 0), (1, 1))), axis=1)
    rows, first = np.nonzero(edge == 1)
    last = np.nonzero(edge == -1)[1] - 1
    low, high = y[rows] - half_y, y[rows] + half_y
    left, right = x[first] - half_x, x[last] + half_x
    corners = np.array([[left, low], [right, low], [right, high], [left, high], [left, low]])
    codes = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    return Path(corners.transpose(2, 0, 1).reshape(-1, 2), codes * len(rows))
