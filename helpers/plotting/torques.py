"""Joint torques along a path, and the forces at the pen's tip."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import must_be, numbers
from helpers.plotting.plane import arrow_2d
from helpers.plotting.style import BLUE, GREEN, GREY, RED, SKY, time_axis


def torques(
    axes: NDArray[Any],
    arm: Arm,
    t: ArrayLike,
    tau: ArrayLike,
    label: str | None = None,
    *,
    limits: bool = False,
    **line: object,
) -> None:
    """Draw each joint's torque (N m) over time in its own axes, its limit in the title; with
    `limits`, what the motor can give is drawn as well, shaded, and sets the scale."""
    must_be(arm, Arm, "arm")
    t = numbers(t, "t", "finite times (n,) in s", (None,))
    tau = numbers(tau, "tau", f"finite torques ({len(t)}, {arm.dof})", (len(t), arm.dof))
    some = slice(None, None, max(1, len(t) // 200))
    for ax, i, values, limit in zip(
        axes.flat, arm.joints, np.transpose(tau), arm.effort_limits, strict=False
    ):
        # A joint that gravity leaves alone has a torque of 1e-17 N m or so, which must not set the
        # scale; nor must a thousandth of what the motor can give.
        ax.plot(t[some], values[some].round(9) + 0.0, label=label, **{"color": BLUE, **line})
        ax.set(title=f"joint {i} (limit ±{limit:g})", ylabel="N m")
        if np.isfinite(limit):
            _at_least(ax, 1e-3 * limit)
        if limits and np.isfinite(limit):
            ax.axhspan(-limit, limit, color=GREEN, alpha=0.12, lw=0)
            for end in (-limit, limit):
                ax.axhline(end, color=RED, ls=":")
            ax.set_ylim(-1.15 * limit, 1.15 * limit)
        time_axis(ax)


def _at_least(ax: Axes, span: float) -> None:
    """Widen what an axes shows to `span`, on both sides alike."""
    low, high = ax.get_ylim()
    if high - low < span:
        ax.set_ylim((low + high - span) / 2, (low + high + span) / 2)


def pen_and_wall(ax: Axes) -> None:
    """The free body that settles the sign: the pen cut loose from the wall, each pushing the
    other."""
    ax.fill_between([1.0, 1.8], -0.42, 0.42, color=SKY, alpha=0.35, lw=0)
    ax.plot([-0.2, 0.7], [0, 0], color=GREY, lw=9, solid_capstyle="round")
    arrow_2d(ax, (0.72, 0.14), (-0.45, 0), RED)
    arrow_2d(ax, (1.02, -0.06), (0.45, 0), BLUE)
    ax.text(0.3, 0.2, "the wall on the pen\n$F = (-5, 0, 0)$ N", color=RED, ha="center")
    ax.text(1.4, -0.33, "the pen on the wall\n$(+5, 0, 0)$ N", color=BLUE, ha="center")
    ax.text(-0.15, -0.08, "pen", ha="center", va="top")
    ax.text(1.4, 0.28, "wall", ha="center")
    ax.set(xlim=(-0.3, 1.82), ylim=(-0.44, 0.44), aspect="equal")
    ax.set_axis_off()
