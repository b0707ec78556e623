"""Pictures of inverse kinematics: the two views of an elbow arm, many poses in little space,
regions of starts."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Patch
from mpl_toolkits.mplot3d.axes3d import Axes3D
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.inputs import must_be, number, numbers
from helpers.kinematics import link_frames, skeleton
from helpers.plotting.arms import pose_frames
from helpers.plotting.drawing import angle
from helpers.plotting.plane import arm_2d
from helpers.plotting.style import AXIS_COLOURS, BLUE, GREY, ORANGE, RED, SLATE


def from_above(
    ax: Axes, arm: Arm, branches: ArrayLike, names: tuple[str, ...], offset: float
) -> None:
    """Draw branches, shape (k, dof), of an elbow arm seen from above, with the circle that its
    plane is tangent to."""
    must_be(arm, Arm, "arm")
    number(offset, "offset", "a finite length in m")
    poses = numbers(
        branches, "branches", f"joint vectors ({len(names)}, {arm.dof})", (len(names), arm.dof)
    )
    ax.add_patch(Circle((0, 0), abs(offset), fill=False, ls=":", color=GREY))
    for q, name, colour in zip(poses, names, (BLUE, ORANGE), strict=False):
        arm_2d(ax, arm, q, "xy", colour=colour)
        middle = skeleton(arm, link_frames(arm, q))[-3:, :2].mean(axis=0)
        aside = 0.03 if colour == BLUE else -0.04
        ax.text(middle[0], middle[1] + aside, name, color=colour)
    ax.plot(0, 0, "+", color="black")


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
    angle(ax, shoulder, 0.13, 0, lift, r"$\theta_2$", BLUE)
    angle(ax, shoulder, 0.21, bearing, lift, r"$\beta$", ORANGE)
    ahead = elbow + 0.6 * (elbow - shoulder)
    ax.plot(*np.stack([elbow, ahead], axis=1), color=GREY, lw=0.8, ls="--")
    angle(ax, elbow, 0.09, lift + np.degrees(q[2]), lift, r"$-\theta_3$", BLUE)
    angle(ax, elbow, 0.06, lift + 180, lift + 360 + np.degrees(q[2]), r"$\varphi$", ORANGE)
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
    colours: tuple[str, ...],
) -> None:
    """Colour the points of a grid by `which`, whole numbers of shape (len(y), len(x)); `names` are
    those in the legend."""
    x, y = (numbers(v, n, "finite values (n,)", (None,)) for v, n in ((x, "x"), (y, "y")))
    which = numbers(which, "which", f"whole numbers ({len(y)}, {len(x)})", (len(y), len(x)))
    must_be(names, dict, "names")
    hatches = ("", "//", "\\\\", "--", "||")
    key = []
    for (value, name), colour, hatch in zip(names.items(), colours, hatches, strict=False):
        inside = (which == value).astype(float)
        ax.contourf(x, y, inside, levels=[0.5, 1.5], colors=[colour], alpha=0.45, hatches=[hatch])
        key.append(Patch(facecolor=colour, alpha=0.45, hatch=hatch, label=name))
    ax.legend(handles=key, loc="center left", bbox_to_anchor=(1.0, 0.5))
