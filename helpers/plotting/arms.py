"""Arms in space, with their frames."""

from collections import defaultdict

import numpy as np
from matplotlib.ticker import MaxNLocator
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from mpl_toolkits.mplot3d.axes3d import Axes3D
from numpy.typing import ArrayLike

from helpers.arm import Arm
from helpers.inputs import must_be
from helpers.kinematics import link_frames, skeleton
from helpers.plotting.style import AXIS_COLOURS, GREY, SLATE

_LINK = 6.0  # points: the width of an arm's line, and of no other


def arm_3d(
    ax: Axes3D,
    arm: Arm,
    q: ArrayLike,
    *,
    frames: bool = True,
    colour: str = GREY,
    alpha: float = 1.0,
    label: str | None = None,
) -> None:
    """Draw an arm at q, shape (dof,): each link as its steps d along z and a along x, with its
    frames.

    Several arms may share the axes; the view grows to hold them all. Lengths in m.
    """
    T = pose_frames(arm, q)
    _links(ax, skeleton(arm, T), colour, alpha, label)
    for i in arm.joints:
        # An even number of sides leaves faces at equal depth, which rounding noise would then put
        # in order.
        sides = 13 if arm.rows[i - 1].joint.kind == "revolute" else 4
        barrel(ax, T[i - 1], 0.032 * _reach(arm), sides, alpha)
    ax.plot(*T[-1, :3, 3:], "o", color="black", alpha=alpha, ms=4)
    if frames:
        _triads(ax, T, 0.13 * _reach(arm))
    _fit(ax, 0.16 * _reach(arm))


def pose_frames(arm: Arm, q: ArrayLike) -> np.ndarray:
    """The link frames at one pose, q of shape (dof,): what can be drawn."""
    must_be(arm, Arm, "arm")
    return link_frames(arm, arm.joint_vector(q, many=False))


def _reach(arm: Arm) -> float:
    """The length of the arm's links at home, which sets the size of its joints and frames."""
    steps = np.diff(skeleton(arm, link_frames(arm, arm.home)), axis=0)
    return float(np.linalg.norm(steps, axis=1).sum())


def _links(ax: Axes3D, points: np.ndarray, colour: str, alpha: float, label: str | None) -> None:
    ax.plot(
        *points.T[:2],
        0 * points[:, 0],
        color=GREY,
        alpha=0.25 * alpha,
        lw=3,
        solid_joinstyle="round",
    )
    ax.plot(*points.T, color=colour, alpha=0.75 * alpha, lw=_LINK, label=label,
            solid_joinstyle="round", solid_capstyle="round")  # fmt: skip


def barrel(ax: Axes3D, frame: np.ndarray, size: float, sides: int, alpha: float) -> None:
    """A joint: a round barrel about z where it turns, a square one where it slides."""
    angle = 2 * np.pi * (np.arange(sides) + 0.5) / sides
    ring = 0.8 * size * np.stack([np.cos(angle), np.sin(angle), 0 * angle])
    bottom, top = (frame[:3, :3] @ ring + frame[:3, 3:] + h * frame[:3, 2:3] for h in (-size, size))
    quads = np.stack([bottom, np.roll(bottom, 1, 1), np.roll(top, 1, 1), top]).transpose(2, 0, 1)
    faces = [*quads, bottom.T, top.T]
    solid = Poly3DCollection(
        faces, facecolors=SLATE, edgecolors=SLATE, lw=0.3, alpha=alpha, shade=True
    )
    # Where faces differ in length, Matplotlib pads them with whatever is in memory and would scale
    # the view by that.
    ax.add_collection3d(solid, autolim=False)


def _triads(ax: Axes3D, T: np.ndarray, length: float) -> None:
    """Frames as arrows; arrows that coincide share one label, as in z_{1,3}."""
    shared = defaultdict(list)
    for i, frame in enumerate(T):
        for name, axis in zip("xyz", frame[:3, :3].T, strict=True):
            shared[name, *np.round(frame[:3, 3], 6), *np.round(axis, 6) + 0.0].append(i)
    for (name, *place), indices in shared.items():
        start, axis = np.array(place[:3]), np.array(place[3:])
        ax.quiver(*start, *length * axis, color=AXIS_COLOURS[name], lw=1.4, arrow_length_ratio=0.22)
        if name != "y":
            tip = start + 1.25 * length * axis
            text = f"${name}_{{{','.join(map(str, indices))}}}$"
            ax.text(*tip, text, color=AXIS_COLOURS[name], fontsize=10, ha="center", va="center")


def _fit(ax: Axes3D, margin: float) -> None:
    """Grow the view to hold the frames of every arm drawn here and the floor, at equal scale."""
    links = [line for line in ax.lines if line.get_linewidth() == _LINK]
    frames = np.vstack([np.transpose(line.get_data_3d())[::2] for line in links])
    held = np.vstack([frames, frames * [1, 1, 0]])
    low, high = held.min(axis=0) - margin, held.max(axis=0) + margin
    low[2] = min(0.0, held[:, 2].min())
    # A tall thin box would leave no room for its labels: the floor is at least half as wide as the
    # box is high.
    spread = np.maximum(0.0, 0.5 * (high - low).max() - (high - low)) / 2
    low[:2], high[:2] = low[:2] - spread[:2], high[:2] + spread[:2]
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set(xlabel="$x$ (m)", ylabel="$y$ (m)", zlabel="$z$ (m)")
    ax.set_box_aspect(high - low)
    for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
        axis.set_pane_color((0.5, 0.5, 0.5, 0.04))
        axis.set_major_locator(MaxNLocator(4))
        axis.set_tick_params(labelsize=8, pad=1)
