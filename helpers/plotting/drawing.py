"""Draw arms without perspective, with their lengths, joint axes and frames.

A `view` is a plane such as "xz", whose first axis points right and whose second points up, or the
azimuth and elevation of the viewer in degrees. The axes of a drawing are in m.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Arc, Polygon
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.derive import Derivation, DerivationStep
from helpers.expressions import entry_latex
from helpers.inputs import (
    ArmError,
    finite_array,
    finite_number,
    parse_plane,
    require_choice,
    require_type,
    shorten,
    tuple_of_items,
    whole_number,
)
from helpers.kinematics import skeleton
from helpers.plotting.plane import compute_frames
from helpers.plotting.style import AXIS_COLOURS, BLUE, GREY, ORANGE, OUTLINED, RED, SLATE

Array = NDArray[np.float64]
View = str | tuple[float, float]

_PALE = "#C9CDD3"


def project_points(points: ArrayLike, view: View) -> Array:
    """Project points, shape (..., 3), to right, up and towards the viewer."""
    points = finite_array(points, "points", "points (..., 3), finite, in m", (3,), many=True)
    return np.asarray(points @ get_view_axes(view).T)


def get_view_axes(view: View) -> Array:
    """Return the unit vectors to the right, up and towards the viewer as rows, shape (3, 3)."""
    if isinstance(view, str):
        right, up = np.eye(3)[list(parse_plane(view, "view"))]
    else:
        expected = "a plane such as 'xz', or an azimuth and an elevation in degrees"
        azimuth, elevation = np.radians(finite_array(view, "view", expected, (2,)))
        right = np.array([-np.sin(azimuth), np.cos(azimuth), 0])
        back = np.array([np.cos(azimuth), np.sin(azimuth), 0])
        up = np.cos(elevation) * np.array([0, 0, 1]) - np.sin(elevation) * back
    return np.stack([right, up, np.cross(right, up)])


def draw_arm(ax: Axes, arm: Arm, q: ArrayLike, view: View, *, size: float = 1.0) -> None:
    """Draw an arm with a barrel for each revolute joint and a box for each prismatic joint.

    Args:
        ax: Axes to draw on.
        arm: The arm; its links follow the steps d and a of its table.
        q: The joint vector, shape (dof,).
        view: A plane, or azimuth and elevation in degrees.
        size: Factor on the size of the joints.
    """
    T, eye = compute_frames(arm, q), get_view_axes(view)
    points = skeleton(arm, T)
    radius = (
        0.028
        * finite_number(size, "size", "a finite number > 0", above=0)
        * _measure_extent(points)
    )
    ax.plot(
        *project_points(points, view).T[:2], color=GREY, lw=4, solid_joinstyle="round", zorder=2
    )
    for i in arm.joints:
        draw_joint(ax, T[i - 1], eye, radius, arm.rows[i - 1].joint.kind == "revolute")
    ax.plot(*project_points(points[-1], view)[:2], "o", color="black", ms=4, zorder=5)
    _draw_ground(ax, project_points(T[0, :3, 3], view), 3 * radius)
    hide_axes(ax)


def hide_axes(ax: Axes) -> None:
    """Hide the axes and draw at equal scale."""
    ax.set_aspect("equal")
    ax.set_axis_off()


def _measure_extent(points: Array) -> float:
    """Return the diagonal of the points' bounding box."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def _draw_ground(ax: Axes, centre: Array, half_width: float) -> None:
    x, y = centre[:2]
    ax.plot([x - half_width, x + half_width], [y, y], color=SLATE, lw=1.6, zorder=1)


def draw_joint(ax: Axes, frame: Array, eye: Array, radius: float, is_revolute: bool) -> None:
    """Draw a barrel about z, or a box along it for a prismatic joint.

    Args:
        ax: Axes to draw on.
        frame: Frame whose z axis is the joint axis, shape (4, 4).
        eye: Unit vectors of the view as rows, of `get_view_axes`.
        radius: Radius of the barrel or half diagonal of the box, m.
        is_revolute: Whether the joint turns.
    """
    sides = 18 if is_revolute else 4
    angle = 2 * np.pi * (np.arange(sides) + 0.5) / sides
    ring = radius * frame[:3, :2] @ [np.cos(angle), np.sin(angle)] + frame[:3, 3:]
    along = 1.3 * radius * frame[:3, 2:3] * (1 if eye[2] @ frame[:3, 2] >= -1e-9 else -1)
    near, far = (eye[:2] @ (ring + end * along) for end in (1, -1))
    both = np.hstack([near, far])
    # Rounding makes every processor choose the same one of several corners at equal distance.
    outline = both[:, np.unique(np.argmax(np.round(_DIRECTIONS @ both, 9), axis=1))]
    # Rounding, and + 0.0 for -0.0, give a corner to the left the angle 180°, never -180°.
    from_middle = np.round(outline - outline.mean(axis=1, keepdims=True), 9) + 0.0
    order = np.argsort(np.arctan2(*from_middle[::-1]))
    look: dict[str, Any] = dict(edgecolor=SLATE, lw=0.8, zorder=3)
    ax.add_patch(Polygon(outline[:, order].T, facecolor=_PALE, **look))
    ax.add_patch(Polygon(near.T, facecolor="white", **look))


_TURNS = np.linspace(0, 2 * np.pi, 181)
_DIRECTIONS = np.stack([np.cos(_TURNS), np.sin(_TURNS)], axis=1)


def draw_lengths(
    ax: Axes, arm: Arm, q: ArrayLike, view: View, aside: dict[str, tuple[float, float]]
) -> None:
    """Draw dimension lines with lengths in mm for steps of the table.

    Args:
        ax: Axes to draw on.
        arm: The arm.
        q: The joint vector, shape (dof,).
        view: A plane, or azimuth and elevation in degrees.
        aside: For each step, how far its line is moved right and up, m: {"a_2": (-0.2, 0)}. The
            step "d_4" is along z_3, "a_4" along x_4.
    """
    require_type(aside, dict, "aside")
    points = skeleton(arm, compute_frames(arm, q))
    steps = {f"{kind}_{i}": (i, kind) for i in range(1, len(arm.rows) + 1) for kind in "da"}
    for name, shift in aside.items():
        if name not in steps:
            raise ArmError(f"aside names {shorten(name)}; expected steps such as 'd_1' or 'a_2'")
        i, kind = steps[name]
        first = 2 * i - (2 if kind == "d" else 1)
        ends = project_points(points[[first, first + 1]], view)[:, :2]
        length = 1000 * float(np.linalg.norm(np.diff(points[[first, first + 1]], axis=0)))
        row, symbol = arm.rows[i - 1], f"q_{{{i}}}"
        if kind == "a" or row.joint.kind != "prismatic" or arm.numeric[i - 1].d:
            symbol = entry_latex(getattr(row, kind)).strip("-()")
        draw_dimension(ax, ends[0], ends[1], shift, f"${symbol} = {round(length, 2):g}$")


def draw_dimension(
    ax: Axes, start: ArrayLike, end: ArrayLike, aside: tuple[float, float], text: str
) -> None:
    """Draw a dimension line between two points, moved aside (m), with a text at its middle."""
    start_point, end_point, shift = (
        finite_array(value, what, "two finite coordinates in m", (2,))
        for value, what in ((start, "start"), (end, "end"), (aside, "aside"))
    )
    for foot in (start_point, end_point):
        ax.plot(*np.stack([foot, foot + 1.08 * shift], axis=1), color=GREY, lw=0.6, zorder=1)
    ends = dict(arrowstyle="<|-|>", color="black", lw=0.8, shrinkA=0, shrinkB=0, mutation_scale=7)
    ax.annotate("", xy=tuple(end_point + shift), xytext=tuple(start_point + shift), arrowprops=ends)
    away = shift / max(float(np.linalg.norm(shift)), 1e-9)
    x, y = (start_point + end_point) / 2 + shift
    ax.annotate(
        text, (x, y), xytext=tuple(6 * away), textcoords="offset points",
        ha=_choose_alignment(away[0], "right", "left"),
        va=_choose_alignment(away[1], "top", "bottom"),
        gid=OUTLINED,
    )  # fmt: skip
    ax.update_datalim([start_point + 1.3 * shift, end_point + 1.3 * shift])


def _choose_alignment(component: float, negative: str, positive: str) -> str:
    """Return the text alignment for a component of a unit vector."""
    return "center" if abs(component) < 0.35 else negative if component < 0 else positive


def draw_angle(
    ax: Axes,
    centre: ArrayLike,
    radius: float,
    between: tuple[float, float],
    text: str,
    *,
    colour: str = BLUE,
) -> None:
    """Draw an arc between two directions (degrees), with its name beside its middle."""
    x, y = finite_array(centre, "centre", "two finite coordinates in m", (2,))
    radius = finite_number(radius, "radius", "a finite length > 0 in m", above=0)
    start, end = np.sort(finite_array(between, "between", "two finite angles in degrees", (2,)))
    size = 2 * radius
    ax.add_patch(Arc((x, y), size, size, theta1=start, theta2=end, color=colour, lw=1.4, zorder=4))
    middle = np.radians((start + end) / 2)
    position = x + 1.28 * radius * np.cos(middle), y + 1.28 * radius * np.sin(middle)
    text_colour = "black" if colour == ORANGE else colour  # orange text is too pale to read
    label = ax.text(*position, text, color=text_colour, ha="center", va="center")
    label.set_gid(OUTLINED)


def draw_joint_axes(ax: Axes, derivation: Derivation, view: View, length: float) -> None:
    """Draw the joint axes of a derivation as dash-dotted lines with arrows and names.

    Each line is `length` (m) longer than the part of the axis that the table uses. Axes on one line
    share an arrow.
    """
    require_type(derivation, Derivation, "derivation")
    finite_number(length, "length", "a finite length > 0 in m", above=0)
    shared = defaultdict(list)
    for k, (line, frame) in enumerate(zip(derivation.lines, derivation.frames, strict=False)):
        foot = line.point - (line.point @ line.z) * line.z
        used = [line.point, frame[:3, 3], derivation.steps[k].normal[0]]
        along = [float(point @ line.z) for point in used]
        shared[tuple(np.round([*foot, *line.z], 6) + 0.0)].append((k, along))
    last = derivation.steps[-1]
    if last.case == "coincident" and not last.opposite:
        next(reversed(shared.values())).append((last.number, []))
    middle = project_points([line.point for line in derivation.lines], view)[:, 0].mean()
    for foot_and_z, group in shared.items():
        foot, z = np.array(foot_and_z[:3]), np.array(foot_and_z[3:])
        used = [value for _, along in group for value in along]
        ends = [foot + (min(used) - length / 2) * z, foot + (max(used) + length / 2) * z]
        start, end = project_points(ends, view)[:, :2]
        ax.plot(*np.stack([start, end], axis=1), color=BLUE, lw=1, ls=_DASHED, zorder=4)
        name = f"$z_{{{','.join(str(k) for k, _ in group)}}}$"
        outwards = 16 if end[0] < middle else -16
        side = outwards if len(group) > 1 else 0  # a long name is placed beside its arrow
        draw_named_arrow(ax, (end - 0.01 * (end - start), end), BLUE, name, side)
    hide_axes(ax)


def draw_named_arrow(
    ax: Axes, ends: tuple[Array, Array], colour: str, text: str, side: float = 0
) -> None:
    """Draw an arrow with its name beyond its tip, or `side` points (pt) to the left if not 0."""
    start, end = ends
    look = dict(arrowstyle="-|>", color=colour, lw=1.4, shrinkA=0, shrinkB=0, mutation_scale=9)
    ax.annotate("", xy=tuple(end), xytext=tuple(start), arrowprops=look, zorder=6)
    step = end - start
    direction = step / max(float(np.linalg.norm(step)), 1e-12)
    ahead = 8 if "," in text else 2  # distance of a wide name from the arrow's tip
    left = np.array([-direction[1], direction[0]])
    offset = ahead * direction + side * left if side else 9 * direction
    ax.annotate(
        text, tuple(end), xytext=tuple(offset), textcoords="offset points", color=colour,
        ha="center", va="center", zorder=7,
        gid=OUTLINED,
    )  # fmt: skip
    ax.update_datalim([start, end + 0.35 * step])


def draw_frames(
    ax: Axes,
    arm: Arm,
    q: ArrayLike,
    view: View,
    length: float,
    *,
    which: Iterable[int] | None = None,
    names: str = "xz",
) -> None:
    """Draw the x and z axes of an arm's frames as arrows.

    Equal arrows share a name.

    Args:
        ax: Axes to draw on.
        arm: The arm.
        q: The joint vector, shape (dof,).
        view: A plane, or azimuth and elevation in degrees.
        length: Length of the arrows, m.
        which: Numbers of the frames to draw, from 0; all if None.
        names: The axes to draw: "xz", "x" or "z".
    """
    T = compute_frames(arm, q)
    finite_number(length, "length", "a finite length > 0 in m", above=0)
    require_choice(names, "names", ("xz", "x", "z"))
    shared = defaultdict(list)
    for i in range(len(T)) if which is None else tuple_of_items(which, "which", _INDICES):
        if whole_number(i, "which") >= len(T):
            raise ArmError(f"which holds {i}; expected {_INDICES}, here 0 to {len(T) - 1}")
        for name in names:
            axis = T[i, :3, "xyz".index(name)]
            shared[name, *np.round([*T[i, :3, 3], *axis], 6) + 0.0].append(i)
    for (name, *start_and_axis), indices in shared.items():
        start, axis = np.array(start_and_axis[:3]), np.array(start_and_axis[3:])
        ends = project_points([start, start + length * axis], view)[:, :2]
        text = f"${name}_{{{','.join(map(str, indices))}}}$"
        partner = T[indices[0], :3, 2 if name == "x" else 0]
        side = _choose_label_side(axis, partner, view, 10)
        draw_named_arrow(ax, (ends[0], ends[1]), AXIS_COLOURS[name], text, side)


_INDICES = "numbers of frames"


def draw_row(ax: Axes, derivation: Derivation, row: int, view: View) -> None:
    """Draw how a row of a table is derived.

    The drawing shows both axes and their common normal, the frame before (grey), the frame that the
    row places (black), and the steps d (blue) and a (red).
    """
    require_type(derivation, Derivation, "derivation")
    if whole_number(row, "row", 1) > len(derivation.steps):
        raise ArmError(f"row is {row}; expected one of 1 to {len(derivation.steps)}")
    step = derivation.steps[row - 1]
    before, foot, origin = step.before[:3, 3], *step.normal
    # The window is a square around the row, and arrows end at its edge.
    corners = skeleton(derivation.arm, derivation.frames)
    points = project_points([before, foot, origin], view)[:, :2]
    low, high = points.min(axis=0), points.max(axis=0)
    extent = float((high - low).max())
    middle, half = (low + high) / 2, max(0.8 * extent, 0.19 * _measure_extent(corners))
    reach = min(0.65 * half, 1.15 * half - 0.5 * extent)
    ax.plot(
        *project_points(corners, view).T[:2],
        color=_PALE,
        lw=5,
        solid_joinstyle="round",
        zorder=1,
    )
    for (name, start, end), indices in _list_frame_arrows(step, reach).items():
        text = f"${name}_{{{','.join(map(str, indices))}}}$"
        colour = "black" if row in indices else SLATE
        ends = project_points([start, end], view)[:, :2]
        ax.plot(*ends.T, color=colour, lw=1, ls=_DASHED if name == "z" else "-", zorder=2)
        frame = step.frame if row in indices else step.before
        side = _choose_label_side(frame[:3, 0], frame[:3, 2], view, 9) if name == "x" else 0
        draw_named_arrow(ax, (ends[1] - 0.01 * (ends[1] - ends[0]), ends[1]), colour, text, side)
    for pair, colour in (((before, foot), BLUE), ((foot, origin), RED)):
        ax.plot(
            *project_points(pair, view).T[:2], color=colour, lw=4, solid_capstyle="butt", zorder=3
        )
    ax.plot(*project_points(origin, view)[:2], "o", color="black", ms=4, zorder=7)
    ax.set(xlim=middle[0] + half * _SPAN, ylim=middle[1] + half * _SPAN)
    ax.set_title(f"row {row}", fontsize=10)
    hide_axes(ax)


def _choose_label_side(axis: Array, other_axis: Array, view: View, side: float) -> float:
    """Return the offset, in pt to the left, that keeps an axis's name away from `other_axis`."""
    (x, y), (other_x, other_y) = project_points([axis, other_axis], view)[:, :2]
    return -side if x * other_y > y * other_x else side


_DASHED = (0, (8, 3, 2, 3))
_SPAN = np.array([-1.35, 1.35])


def _list_frame_arrows(step: DerivationStep, reach: float) -> dict[tuple, list[int]]:
    """Return the x and z arrows of a step's two frames, with the indices of their frames.

    A z arrow covers the part of its axis that the table uses, and `reach` (m) beyond.
    """
    arrows: dict[Any, list] = defaultdict(list)
    spans = ((step.before, [step.before[:3, 3], step.normal[0]]), (step.frame, [step.normal[1]]))
    for index, (frame, used) in enumerate(spans, step.number - 1):
        x, z, origin = frame[:3, 0], frame[:3, 2], frame[:3, 3]
        along = [float((point - origin) @ z) for point in used]
        ends = [(min(along) - 0.6 * reach) * z, (max(along) + reach) * z]
        if index == step.number and step.case == "coincident" and not step.opposite:
            arrows[next(key for key in arrows if key[0] == "z")].append(index)
        else:
            arrows["z", *(tuple(np.round(origin + end, 9) + 0.0) for end in ends)].append(index)
        tips = (tuple(np.round(p, 9) + 0.0) for p in (origin, origin + 0.75 * reach * x))
        arrows["x", *tips].append(index)
    return arrows


def draw_postures(
    axes: Iterable[Axes],
    arm: Arm,
    configurations: ArrayLike,
    titles: Iterable[str],
    view: View,
    *,
    tool: float = 0.0,
) -> None:
    """Draw an arm in several configurations at the same scale, each on its own axes.

    Args:
        axes: Axes to draw on, one for each configuration.
        arm: The arm.
        configurations: Joint vectors, shape (k, dof).
        titles: Title of each configuration.
        view: A plane, or azimuth and elevation in degrees.
        tool: Length of the arrows x and z at the tip, m; 0 draws a star instead.
    """
    require_type(arm, Arm, "arm")
    expected = f"joint vectors (k, {arm.dof})"
    configurations = finite_array(configurations, "configurations", expected, (None, arm.dof))
    T = [compute_frames(arm, q) for q in configurations]
    lines = [project_points(skeleton(arm, frames_of_q), view)[:, :2] for frames_of_q in T]
    low, high = np.vstack(lines).min(axis=0), np.vstack(lines).max(axis=0)
    finite_number(tool, "tool", "a finite length of 0 or more in m", least=0)
    rim = 0.12 * float((high - low).max()) + tool
    half = max(np.ptp(line[:, 0]) for line in lines) / 2 + rim
    origins = [i - 1 for i in arm.joints]
    for ax, q, frames, line, title in zip(axes, configurations, T, lines, titles, strict=True):
        _draw_ground(ax, line[0], rim - tool)
        ax.plot(*line.T, color=GREY, lw=4, solid_joinstyle="round", zorder=2)
        ax.plot(
            *project_points(frames[origins, :3, 3], view)[:, :2].T, "o", color=SLATE, ms=5, zorder=3
        )
        middle = (line[:, 0].min() + line[:, 0].max()) / 2
        ax.set(xlim=(middle - half, middle + half), ylim=(low[1] - rim, high[1] + rim))
        if tool:  # a star would cover an arrow that points towards the viewer
            draw_frames(ax, arm, q, view, tool, which=[len(arm.rows)])
        else:
            ax.plot(*line[-1], "*", color=RED, ms=10, zorder=4)
        ax.set_title(title, fontsize=9)
        hide_axes(ax)
