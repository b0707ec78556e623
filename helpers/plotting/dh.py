"""Draw the four Denavit-Hartenberg parameters."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, revolute
from helpers.kinematics import link_frames
from helpers.plotting.drawing import (
    draw_joint,
    draw_named_arrow,
    get_view_axes,
    hide_axes,
    project_points,
)
from helpers.plotting.style import BLUE, GREY, ORANGE, PURPLE, RED

_COLOURS = {"theta": ORANGE, "d": BLUE, "a": RED, "alpha": PURPLE}
_VIEW = (-27.0, 22.0)
_A, _ALPHA, _D, _THETA = 1.2, 0.7, 0.9, 0.75  # m and rad; angles that cannot be taken for 90°


def draw_dh_numbers(ax: Axes) -> None:
    """Draw two joint axes, their common normal, and the four numbers between frames i-1 and i."""
    first, second = link_frames(Arm("one link", [revolute(_A, _ALPHA, _D)]), [_THETA])
    foot = first.copy()
    foot[:3, 3] = second[:3, 3] - _A * second[:3, 0]
    for frame, low, high in ((first, -0.3, _D + 1.0), (second, -0.7, 1.0)):
        axis_ends = [frame[:3, 3] + h * frame[:3, 2] for h in (low, high)]
        _draw_line(ax, axis_ends, color=GREY, lw=1.2, ls=(0, (8, 3, 2, 3)))
        draw_joint(ax, frame, get_view_axes(_VIEW), 0.13, True)
    _draw_length(ax, first[:3, 3], foot[:3, 3], "d", (0, 0.1, 0.1))
    _draw_length(ax, foot[:3, 3], second[:3, 3], "a", (0, 0, 0.12))
    _draw_angle(ax, foot, 0.55, _THETA, "theta")
    tilted, z = second.copy(), first[:3, 2]
    tilted[:3, :3] = np.stack([z, np.cross(second[:3, 0], z), second[:3, 0]], axis=1)
    _draw_angle(ax, tilted, 0.6, _ALPHA, "alpha")
    for frame, index, length in ((first, "i-1", 0.62), (second, "i", 0.75)):
        for name, axis in (("x", frame[:3, 0]), ("z", frame[:3, 2])):
            ends = project_points([frame[:3, 3], frame[:3, 3] + length * axis], _VIEW)[:, :2]
            side = 14 if name == "z" else 0
            draw_named_arrow(ax, (ends[0], ends[1]), "black", f"${name}_{{{index}}}$", side)
    hide_axes(ax)


def _draw_line(ax: Axes, points: ArrayLike, **look: Any) -> None:
    ax.plot(*project_points(points, _VIEW)[:, :2].T, **look)


def _write_symbol(ax: Axes, position: NDArray[np.float64], name: str) -> None:
    x, y = project_points(position, _VIEW)[:2]
    # Orange text would be too pale.
    text_colour = "black" if name == "theta" else _COLOURS[name]
    symbol = name if len(name) == 1 else f"\\{name}"
    ax.text(x, y, f"${symbol}_i$", color=text_colour, fontsize=14, ha="center", va="center")


def _draw_length(ax: Axes, start: NDArray, end: NDArray, name: str, shift: tuple) -> None:
    _draw_line(ax, [start, end], color=_COLOURS[name], lw=4, solid_capstyle="butt")
    _write_symbol(ax, (start + end) / 2 + shift, name)


def _draw_angle(ax: Axes, frame: NDArray, radius: float, angle: float, name: str) -> None:
    """Draw an angle about the frame's z axis, from its x axis, which is dashed."""
    origin, (x, y) = frame[:3, 3], frame[:3, :2].T

    def point_at(turn: ArrayLike, scale: float) -> NDArray:
        turn = np.asarray(turn)[..., None]
        return origin + scale * radius * (np.cos(turn) * x + np.sin(turn) * y)

    _draw_line(ax, [origin, point_at(0.0, 1.25)], color=_COLOURS[name], lw=1.2, ls="--")
    _draw_line(ax, point_at(np.linspace(0, angle, 30), 1), color=_COLOURS[name], lw=2.2)
    _write_symbol(ax, point_at(angle / 2, 1.3), name)
