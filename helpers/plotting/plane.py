"""Draw arms that move in a plane."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import finite_array, parse_plane, require_type
from helpers.kinematics import link_frames, skeleton
from helpers.plotting.style import GREY, SLATE


def compute_frames(arm: Arm, q: ArrayLike) -> NDArray[np.float64]:
    """Return the link frames to draw at a configuration, q of shape (dof,)."""
    require_type(arm, Arm, "arm")
    return link_frames(arm, arm.joint_vector(q, many=False))


def plot_arm(
    ax: Axes, arm: Arm, q: ArrayLike, plane: str = "xz", *, colour: str = GREY, alpha: float = 1.0
) -> None:
    """Draw an arm at q, shape (dof,), in a plane such as "xz", with lengths in m.

    On 3-D axes (``projection="3d"``) the arm is drawn in space.
    """
    shown = [0, 1, 2] if getattr(ax, "name", "") == "3d" else [*parse_plane(plane)]
    T = compute_frames(arm, q)
    points = skeleton(arm, T)[:, shown]
    origins = T[[k - 1 for k in arm.joints], :3, 3][:, shown]
    ax.plot(
        *points.T,
        color=colour,
        alpha=0.75 * alpha,
        lw=5,
        solid_joinstyle="round",
        solid_capstyle="round",
    )
    ax.plot(*origins.T, "o", color=SLATE, alpha=alpha, ms=9)
    ax.plot(*points[-1:].T, "o", color="black", alpha=alpha, ms=4)
    labels = {f"{on}label": f"${'xyz'[k]}$ (m)" for on, k in zip("xyz", shown, strict=False)}
    ax.set(**labels, aspect="equal")


def draw_arrow(
    ax: Axes,
    start: ArrayLike,
    step: ArrayLike,
    colour: str,
    text: str = "",
    *,
    dashed: bool = False,
) -> None:
    """Draw an arrow from a point by a step (m), with a text at its tip."""
    start = finite_array(start, "start", "a point of two finite coordinates", (2,))
    step = finite_array(step, "step", "a step of two finite coordinates", (2,))
    style = {
        "arrowstyle": "-|>",
        "color": colour,
        "lw": 1.8,
        "ls": "--" if dashed else "-",
        "shrinkA": 0,
        "shrinkB": 0,
    }
    (x, y), (u, v) = start, step
    ax.annotate("", xy=(x + u, y + v), xytext=(x, y), arrowprops=style)
    ax.text(x + 1.14 * u, y + 1.14 * v, text, color=colour, ha="center", va="center")
