"""The picture of the four Denavit-Hartenberg numbers."""

import numpy as np
from mpl_toolkits.mplot3d.axes3d import Axes3D

from helpers.arm import Arm, revolute
from helpers.inputs import number
from helpers.kinematics import link_frames
from helpers.plotting.arms import barrel
from helpers.plotting.style import BLUE, GREY, ORANGE, PURPLE, RED

_COLOURS = {"theta": ORANGE, "d": BLUE, "a": RED, "alpha": PURPLE}


def dh_numbers(
    ax: Axes3D, a: float = 1.2, alpha: float = 0.7, d: float = 0.9, theta: float = 0.75
) -> None:
    """Draw two joint axes, their common normal, and the four numbers between frames i-1 and i (m,
    rad)."""
    for name, value in dict(a=a, alpha=alpha, d=d, theta=theta).items():
        number(value, name, "a finite number of m or rad")
    first, second = link_frames(Arm("one link", [revolute(a, alpha, d)]), [theta])
    foot = first.copy()
    foot[:3, 3] = second[:3, 3] - a * second[:3, 0]
    _axis(ax, first, -0.3, d + 1.0)
    _axis(ax, second, -0.7, 1.0)
    for frame in (first, second):
        barrel(ax, frame, 0.13, 24, 0.9)
    _number(ax, first[:3, 3], foot[:3, 3], "d", (0, 0.1, 0.1))
    _number(ax, foot[:3, 3], second[:3, 3], "a", (0, 0, 0.12))
    _arc(ax, foot, 0.55, theta, "theta")
    tilted = second.copy()
    tilted[:3, :3] = np.stack(
        [first[:3, 2], np.cross(second[:3, 0], first[:3, 2]), second[:3, 0]], axis=1
    )
    _arc(ax, tilted, 0.6, alpha, "alpha")
    _arrows(ax, first, "i-1", 0.62)
    _arrows(ax, second, "i", 0.75)
    ax.set_axis_off()
    ax.set_proj_type("ortho")
    ax.set(xlim=(-0.3, 1.5), ylim=(-0.5, 1.4), zlim=(-0.1, 1.9))
    ax.set_box_aspect((1.8, 1.9, 2.0), zoom=1.2)
    ax.view_init(elev=22, azim=-27)


def _axis(ax: Axes3D, frame: np.ndarray, low: float, high: float) -> None:
    line = np.array([frame[:3, 3] + h * frame[:3, 2] for h in (low, high)])
    ax.plot(*line.T, color=GREY, lw=1.2, ls=(0, (8, 3, 2, 3)))


def _number(ax: Axes3D, start: np.ndarray, end: np.ndarray, name: str, shift: tuple) -> None:
    ax.plot(*np.array([start, end]).T, color=_COLOURS[name], lw=4, solid_capstyle="butt")
    place = (start + end) / 2 + shift
    ax.text(*place, f"${name}_i$", color=_COLOURS[name], fontsize=14, ha="center")


def _arc(ax: Axes3D, frame: np.ndarray, radius: float, angle: float, name: str) -> None:
    """An angle turned about the frame's z axis from its x axis, with a dashed line where it
    starts."""
    turn = np.linspace(0, angle, 30)
    ring = frame[:3, 3:] + radius * frame[:3, :2] @ [np.cos(turn), np.sin(turn)]
    start = np.stack([frame[:3, 3], frame[:3, 3] + 1.25 * radius * frame[:3, 0]])
    ax.plot(*start.T, color=_COLOURS[name], lw=1.2, ls="--")
    ax.plot(*ring, color=_COLOURS[name], lw=2.2)
    middle = frame[:3, 3] + 1.3 * radius * frame[:3, :2] @ [np.cos(angle / 2), np.sin(angle / 2)]
    ax.text(*middle, rf"$\{name}_i$", color=_COLOURS[name], fontsize=14, ha="center", va="center")


def _arrows(ax: Axes3D, frame: np.ndarray, index: str, length: float) -> None:
    for name, axis, away in (
        ("x", frame[:3, 0], 0.12 if index == "i" else 0.3),
        ("z", frame[:3, 2], 0.1),
    ):
        look = dict(color="black", lw=1.6, arrow_length_ratio=0.15, clip_on=False)
        ax.quiver(*frame[:3, 3], *length * axis, **look)
        tip = frame[:3, 3] + (length + away) * axis
        text, side = f"${name}_{{{index}}}\\;\\;$", "right" if name == "z" else "center"
        ax.text(*tip, text, fontsize=14, ha=side)
