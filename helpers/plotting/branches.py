"""Pictures of inverse kinematics: the two views of an elbow arm, many poses in little space,
regions of starts."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, PathPatch
from matplotlib.path import Path
from mpl_toolkits.mplot3d.axes3d import Axes3D
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, number, numbers
from helpers.kinematics import link_frames, skeleton
from helpers.plotting.arms import pose_frames
from helpers.plotting.drawing import angle
from helpers.plotting.plane import arm_2d
from helpers.plotting.style import AXIS_COLOURS, BLUE, GREY, ORANGE, RED, SLATE


def shoulder_triangles(
    ax: Axes, point: ArrayLike, offset: float, names: tuple[str, str], letters: tuple[str, str]
) -> None:
    """Draw the two right triangles that turn an arm's plane to a point, seen from above: hypotenuse
    from the axis to the point, one leg the offset (m) of the plane, the other the reach in it.

    `names` are those of the shoulder on the left and on the right, `letters` those of the legs.
    """
    point = numbers(point, "point", "two finite coordinates in m", (2,))
    offset = number(offset, "offset", "a length in m that is above 0", above=0)
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
        across = side * np.array([-np.sin(heading), np.cos(heading)])
        back = -np.array([np.cos(heading), np.sin(heading)])
        for spot, text, way_off in (
            (foot / 2, letters[0], back),
            ((2 * foot + 3 * point) / 5, letters[1], across),
        ):
            x, y = spot + 0.07 * far * way_off
            ax.text(x, y, text, ha="center", va="center")
        x, y = 1.3 * foot
        ax.text(x, y, name, ha="center", va="center")
    ax.plot(0, 0, "o", color=SLATE, ms=7)
    ax.plot(*point, "*", color=RED, ms=11)
    ax.set_aspect("equal")


def ur_triangle(ax: Axes, arm: Arm, q: ArrayLike) -> None:
    """Draw a UR arm of the homework's table in its own plane, r to the right, z up, from the
    shoulder to the wrist, with the triangle of joints 2 and 3 and the step d_5."""
    must_be(arm, Arm, "arm")
    T = pose_frames(arm, q)
    forward = T[1, :3, 0]
    points = np.stack([T[:, :3, 3] @ forward, T[:, 2, 3]], axis=1)[[1, 2, 3, 5]]
    shoulder, elbow, end, wrist = points
    ax.plot(*np.stack([(0, 0), shoulder], axis=1), color=GREY, lw=4, alpha=0.5)
    ax.plot(*points.T, color=GREY, lw=4, alpha=0.75, solid_joinstyle="round")
    ax.plot(*points[:3].T, "o", color=SLATE, ms=8)
    ax.plot(*wrist, "*", color=RED, ms=11)
    corner = np.array([end[0], shoulder[1]])
    ax.plot(*np.stack([shoulder, end], axis=1), color=RED, lw=1.2, ls="--")
    ax.plot(*np.stack([shoulder, corner, end], axis=1), color=GREY, lw=1, ls=":")
    lean = np.degrees(np.arctan2(*(elbow - shoulder)[::-1]))
    fore = np.degrees(np.arctan2(*(end - elbow)[::-1]))
    upright = np.stack([shoulder, shoulder + np.array([0, 0.3])], axis=1)
    ax.plot(*upright, color=GREY, lw=0.8, ls="--")
    ahead = elbow + 0.5 * (elbow - shoulder)
    ax.plot(*np.stack([elbow, ahead], axis=1), color=GREY, lw=0.8, ls="--")
    angle(ax, shoulder, 0.2, (lean, 90), "$q_2$")
    angle(ax, elbow, 0.15, (fore, lean), "$q_3$")
    for start, stop, text in (
        (shoulder, elbow, "$a_2$"), (elbow, end, "$a_3$"), (end, wrist, "$d_5$"),
        (corner, shoulder, "$r$"), (corner, end, "$s$"),
    ):  # fmt: skip
        across = np.array([start[1] - stop[1], stop[0] - start[0]])
        x, y = (start + stop) / 2 + 0.06 * across / np.linalg.norm(across)
        ax.text(x, y, text, ha="center", va="center")
    ax.text(wrist[0] + 0.05, wrist[1] + 0.03, "$o_5$", color=RED, ha="left")
    ax.set(xlabel="$r$ (m)", ylabel="$z$ (m)", aspect="equal")


def law_of_cosines(ax: Axes, arm: Arm, q: ArrayLike) -> None:
    """Draw an elbow arm without offset in its own plane, with the triangle that gives its angles;
    q_1 is taken as 0."""
    must_be(arm, Arm, "arm")
    q = np.array([0.0, *arm.joint_vector(q, many=False)[1:]])
    shoulder, elbow, tip = (link_frames(arm, q)[i, [0, 2], 3] for i in (1, 2, 3))
    arm_2d(ax, arm, q)
    ax.plot(*np.stack([shoulder, tip], axis=1), color=RED, lw=1.2, ls="--")
    corner = np.array([tip[0], shoulder[1]])
    ax.plot(*np.stack([shoulder, corner, tip], axis=1), color=GREY, lw=1, ls=":")
    bearing = np.degrees(np.arctan2(*(tip - shoulder)[::-1]))
    lift = np.degrees(q[1])
    angle(ax, shoulder, 0.13, (0, lift), r"$\theta_2$")
    angle(ax, shoulder, 0.21, (bearing, lift), r"$\beta$", colour=ORANGE)
    ahead = elbow + 0.6 * (elbow - shoulder)
    ax.plot(*np.stack([elbow, ahead], axis=1), color=GREY, lw=0.8, ls="--")
    angle(ax, elbow, 0.09, (lift + np.degrees(q[2]), lift), r"$-\theta_3$")
    around = lift + 180, lift + 360 + np.degrees(q[2])
    angle(ax, elbow, 0.06, around, r"$\varphi$", colour=ORANGE)
    for start, end, text in ((shoulder, elbow, "$a_2$"), (elbow, tip, "$a_3$")):
        across = np.array([start[1] - end[1], end[0] - start[0]])
        x, y = (start + end) / 2 + 0.12 * across
        ax.text(x, y, text, ha="center", va="center")
    x, y = (shoulder + corner) / 2
    ax.text(x, y - 0.025, "$r$", ha="center", va="center")
    x, y = (corner + tip) / 2
    ax.text(x + 0.025, y, "$s$", ha="center", va="center")
    ax.set(ylim=(shoulder[1] - 0.15, elbow[1] + 0.15))


def stick_3d(ax: Axes3D, arm: Arm, q: ArrayLike, colour: str = BLUE, title: str = "") -> None:
    """Draw an arm at q as one line with dots at its joints, on a square of floor: small enough to
    set many side by side."""
    T = pose_frames(arm, q)
    points = skeleton(arm, T)
    reach = 0.15 * np.ptp(points, axis=0).max()
    tool = T[-1, :3, 3] + reach * T[-1, :3, :3].T
    seen = np.vstack([points, tool, 0.2 * _SQUARE])
    low, high = seen.min(axis=0), seen.max(axis=0)
    half, middle = 0.5 * (high - low).max(), 0.5 * (low + high)
    ax.plot(*0.2 * _SQUARE.T, color=GREY, lw=0.8)
    ax.plot(*points.T, color=colour, lw=3, solid_joinstyle="round")
    ax.plot(*T[[i - 1 for i in arm.joints], :3, 3].T, "o", color=SLATE, ms=4)
    for end, shade in zip(tool, AXIS_COLOURS.values(), strict=True):
        ax.plot(*np.stack([T[-1, :3, 3], end], axis=1), color=shade, lw=1.2)
    limits = np.stack([middle - half, middle + half], axis=1)
    ax.set(xlim=limits[0], ylim=limits[1], zlim=limits[2], title=title)
    ax.set_box_aspect((1, 1, 1), zoom=1.2)
    ax.set_axis_off()


_SQUARE = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (-1, -1, 0)])


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
    x, y = (numbers(v, n, "finite values (n,)", (None,)) for v, n in ((x, "x"), (y, "y")))
    which = numbers(which, "which", f"whole numbers ({len(y)}, {len(x)})", (len(y), len(x)))
    must_be(names, dict, "names")
    hatches = ("", "//", "\\\\", "--", "||")
    for (value, name), colour, hatch in zip(names.items(), colours, hatches, strict=False):
        patch = PathPatch(_cells(x, y, which == value), lw=0, label=name)
        patch.set(facecolor=colour, alpha=0.45, hatch=hatch)
        ax.add_patch(patch)
    ax.autoscale_view()
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)


def _cells(x: NDArray, y: NDArray, inside: NDArray) -> Path:
    """One rectangle for each run of grid points in a row that are inside."""
    half_x, half_y = (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    edge = np.diff(np.pad(inside.astype(int), ((0, 0), (1, 1))), axis=1)
    rows, first = np.nonzero(edge == 1)
    last = np.nonzero(edge == -1)[1] - 1
    low, high = y[rows] - half_y, y[rows] + half_y
    left, right = x[first] - half_x, x[last] + half_x
    corners = np.array([[left, low], [right, low], [right, high], [left, high], [left, low]])
    codes = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    return Path(corners.transpose(2, 0, 1).reshape(-1, 2), codes * len(rows))
