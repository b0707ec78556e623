"""Draw traced paths, joint values over time, and an animated SVG."""

from html import escape
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from helpers.inputs import parse_plane, require_type, tuple_of_items, whole_number
from helpers.kinematics import link_frames, skeleton
from helpers.motion import Trace
from helpers.plotting.style import BLUE, GREEN, GREY, RED, label_time_axis

Array = NDArray[np.floating]


def plot_path(ax: Axes, run: Trace, *, colour: str = BLUE) -> None:
    """Draw the wanted path (dashed) and the traced path (solid) in their plane, in m."""
    require_type(run, Trace, "run")
    normal_axis = int(np.abs(run.path.normal).argmax())
    i, j = (k for k in range(3) if k != normal_axis)
    steps = _choose_plotted_steps(run)
    wanted, traced = run.path.positions[steps], run.poses[steps, :3, 3]
    ax.plot(wanted[:, i], wanted[:, j], "--", color=GREY, label="wanted")
    ax.plot(traced[:, i], traced[:, j], color=colour, lw=1.4, label="traced")
    ax.plot(traced[0, i], traced[0, j], "ko", ms=4)
    ax.set(xlabel=f"${'xyz'[i]}$ (m)", ylabel=f"${'xyz'[j]}$ (m)", aspect="equal")
    ax.xaxis.set_major_locator(MaxNLocator(5))
    ax.yaxis.set_major_locator(MaxNLocator(5))


def plot_joints(axes: NDArray[Any], run: Trace) -> None:
    """Draw each joint's angle (degrees) over time on its own axes, with its range shaded."""
    require_type(run, Trace, "run")
    lower, upper = np.degrees(run.arm.limits)
    steps = _choose_plotted_steps(run)
    t, angles = run.t[steps], np.degrees(run.q[steps].T)
    for ax, i, angle, low, high in zip(
        axes.flat, run.arm.joints, angles, lower, upper, strict=False
    ):
        ax.plot(t, angle, color=BLUE)
        if np.isfinite([low, high]).all():
            ax.axhspan(low, high, color=GREEN, alpha=0.12, lw=0)
        ax.plot(t, np.where((angle < low) | (angle > high), angle, np.nan), color=RED, lw=3)
        ax.set(title=f"joint {i} (°)")
        ax.yaxis.set_major_locator(MaxNLocator(3))
        label_time_axis(ax)


def _choose_plotted_steps(run: Trace) -> NDArray[np.intp]:
    """Return indices of enough steps for a smooth line, with the first and the last."""
    return np.unique(np.linspace(0, len(run.t) - 1, 61).astype(int))


def animate_trace(run: Trace, planes: tuple[str, str] = ("xz", "yz"), frames: int = 48) -> str:
    """Return an animated SVG of the arm drawing its path, seen in two planes.

    The animation is part of the SVG and needs no script. It lasts as long as the trajectory.
    Readers who prefer reduced motion see the start with the finished path.

    Args:
        run: The traced path.
        planes: The two planes.
        frames: Number of configurations in the animation.
    """
    require_type(run, Trace, "run")
    whole_number(frames, "frames", least=1)
    planes = tuple_of_items(planes, "planes", "two planes such as ('xz', 'yz')")
    steps = np.searchsorted(run.t, np.linspace(run.t[0], run.t[-1], frames + 1) - 1e-9)
    T = link_frames(run.arm, run.q[steps])
    bones = np.array([skeleton(run.arm, frame) for frame in T])
    tips = run.poses[steps, :3, 3]
    low, high = bones.min(axis=(0, 1)), bones.max(axis=(0, 1))
    scale, seconds = 240 / (high - low).max(), float(run.t[-1] - run.t[0])
    bones, tips = scale * (bones - low), scale * (tips - low)
    parts = [
        _format_panel(bones, tips, plane, seconds, 20 + 300 * k) for k, plane in enumerate(planes)
    ]
    style = (
        "@media (prefers-reduced-motion: reduce) {.moving {display: none}} .still {display:"
        " none} @media (prefers-reduced-motion: reduce) {.still {display: inline}}"
    )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 310" width="600" height="310"'
        ' font-family="DejaVu Sans, Verdana, sans-serif">'
        f"<style>{escape(style)}</style>{''.join(parts)}</svg>"
    )


def _format_panel(bones: Array, tips: Array, plane: str, seconds: float, left: float) -> str:
    """Return the arm's links and the path of its tip in a plane, in pixels."""
    i, j = parse_plane(plane)

    def points(array: Array) -> list[str]:
        x, y = left + array[..., i], 270 - array[..., j]
        return [
            " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(*line, strict=True))
            for line in zip(x, y, strict=True)
        ]

    postures, (path,) = points(bones), points(tips[None])
    repeat = f'dur="{seconds:g}s" repeatCount="indefinite"'
    pieces = np.linalg.norm(np.diff(tips[:, [i, j]], axis=0), axis=1)
    to_draw = np.append(pieces[::-1].cumsum()[::-1], 0.0)
    hidden = ";".join(f"{rest:.1f}" for rest in to_draw)
    look = 'fill="none" stroke-linejoin="round" stroke-linecap="round"'
    arm = f'{look} stroke="{GREY}" stroke-width="7"'
    ink = f'{look} stroke="{RED}" stroke-width="2.5"'
    drawn = f'<animate attributeName="stroke-dashoffset" values="{hidden}" {repeat}/>'
    moved = f'<animate attributeName="points" values="{";".join(postures)}" {repeat}/>'
    return (
        f'<text x="{left}" y="302" font-size="16">{plane[0]}–{plane[1]} plane</text>'
        f'<polyline points="{path}" {look} stroke="{GREY}" stroke-width="1" stroke-dasharray="3'
        ' 3"/>'
        f'<g class="moving"><polyline points="{postures[0]}" {arm}>{moved}</polyline>'
        f'<polyline points="{path}" {ink}'
        f' stroke-dasharray="{to_draw[0]:.1f}">{drawn}</polyline></g>'
        f'<g class="still"><polyline points="{postures[0]}" {arm}/><polyline points="{path}"'
        f" {ink}/></g>"
    )
