"""Draw joint torques along a path and the forces at the pen's tip."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import finite_array, require_type
from helpers.plotting.style import BLUE, GREEN, ORANGE, PURPLE, RED, label_time_axis


def plot_torques(
    axes: NDArray[Any], arm: Arm, t: ArrayLike, tau: ArrayLike, **line: object
) -> None:
    """Draw each joint's torque over time in its own axes, one joint below the other.

    Args:
        axes: Axes of a column, one for each joint. With two columns, shape (dof, 2), the right one
            has the same curves again, between the limits of the joint's motor.
        arm: The arm, with its torque limits.
        t: Times, shape (n,), s.
        tau: Torques, shape (n, dof), N m.
        line: Settings of the line, as in `Axes.plot`.
    """
    require_type(arm, Arm, "arm")
    t = finite_array(t, "t", "finite times (n,) in s", (None,))
    tau = finite_array(tau, "tau", f"finite torques ({len(t)}, {arm.dof})", (len(t), arm.dof))
    shown_steps = slice(None, None, max(1, len(t) // 200))
    own_scale, *between_limits = np.reshape(axes, (len(axes), -1)).T
    joints = zip(own_scale, arm.joints, arm.effort_limits, strict=False)
    for k, (ax, i, limit) in enumerate(joints):
        # An unloaded joint must not be scaled to its round-off of 1e-17 N m, nor a joint to a range
        # below a thousandth of the motor's limit.
        curve = t[shown_steps], tau[shown_steps, k].round(9) + 0.0
        ax.plot(*curve, **{"color": BLUE, **line})
        ax.set_ylabel(f"joint {i}\n(N m)", rotation=0, ha="right", va="center")
        ax.yaxis.set_label_coords(-0.16 * (1 + len(between_limits)), 0.5)  # in panel widths
        ax.yaxis.set_major_locator(MaxNLocator(3))
        low, high = ax.get_ylim()
        if np.isfinite(limit) and high - low < 1e-3 * limit:
            ax.set_ylim((low + high - 1e-3 * limit) / 2, (low + high + 1e-3 * limit) / 2)
        for column in between_limits:
            column[k].plot(*curve, **{"color": BLUE, **line})
            column[k].yaxis.set_major_locator(MaxNLocator(3))
            if np.isfinite(limit) and not column[k].texts:  # the first curve has drawn them
                column[k].set_ylim(-1.2 * limit, 1.2 * limit)
                words = f"joint {i}: limits ±{limit:g} N m"
                column[k].text(
                    0.5, 0.25, words, transform=column[k].transAxes, ha="center", va="center"
                )
                for end in (-limit, limit):
                    column[k].axhline(end, color=RED, ls=":")
    for column in (own_scale, *between_limits):
        label_time_axis(column[-1])


def plot_torque_shares(ax: Axes, arm: Arm, runs: Mapping[str, ArrayLike]) -> None:
    """Draw the range of each joint's torque as a percentage of its limit.

    Args:
        ax: Axes to draw on.
        arm: The arm, with its torque limits.
        runs: Torques along each trajectory, shape (n, dof), N m, by the trajectory's name.
    """
    require_type(arm, Arm, "arm")
    require_type(runs, Mapping, "runs")
    width = 0.8 / max(1, len(runs))
    ax.axhspan(-100, 100, color=GREEN, alpha=0.12, lw=0)
    for end in (-100, 100):
        ax.axhline(end, color=RED, ls=":")
    for k, (name, tau) in enumerate(runs.items()):
        tau = finite_array(tau, "runs", f"finite torques (n, {arm.dof})", (None, arm.dof))
        share = 100 * tau / arm.effort_limits
        low, high = share.min(axis=0), share.max(axis=0)
        positions = np.array(arm.joints) + (k - (len(runs) - 1) / 2) * width
        colour, hatch = (BLUE, ORANGE, PURPLE)[k % 3], ("", "//", "..")[k % 3]
        # At least 2 % high, so that the bar of a constant torque is visible.
        height = np.maximum(high - low, 2)
        ax.bar(
            positions, height, width, low, label=name, color=colour, hatch=hatch, ec="white", lw=0
        )
    ax.legend(ncols=2, loc="lower right", bbox_to_anchor=(1, 0.1))
    ax.set(xlabel="joint", ylabel="share of the limit (%)", xticks=arm.joints)
