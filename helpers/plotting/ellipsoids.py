"""Ellipsoids at the tip, and maps of a measure over joint angles."""

import numpy as np
from matplotlib.axes import Axes
from mpl_toolkits.mplot3d.axes3d import Axes3D
from numpy.typing import ArrayLike

from helpers.inputs import number, numbers
from helpers.plotting.style import SKY


def ellipsoid_3d(
    ax: Axes3D,
    centre: ArrayLike,
    axes: ArrayLike,
    *,
    scale: float = 1.0,
    colour: str = SKY,
    label: str | None = None,
) -> None:
    """Draw an ellipsoid by its three principal ellipses and semi-axes; `axes` holds the semi-axes
    as columns."""
    centre = numbers(centre, "centre", "three finite coordinates in m", (3,))
    scale = number(scale, "scale", "a finite number > 0", above=0)
    axes = scale * numbers(axes, "axes", "three finite semi-axes as columns, (3, 3)", (3, 3))
    turn = np.linspace(0, 2 * np.pi, 49)
    for k, (i, j) in enumerate(((0, 1), (1, 2), (0, 2))):
        ring = (
            centre[:, None]
            + np.outer(axes[:, i], np.cos(turn))
            + np.outer(axes[:, j], np.sin(turn))
        )
        ax.plot(*ring, color=colour, lw=1.3, label=label if k == 0 else None)
    for axis in axes.T:
        ax.plot(*np.stack([centre - axis, centre + axis], axis=1), color=colour, lw=0.8, ls=":")


def map_2d(ax: Axes, x: ArrayLike, y: ArrayLike, values: ArrayLike, label: str) -> None:
    """Draw `values`, shape (len(y), len(x)), as filled contours with a colour bar; darker is
    more."""
    x, y = (numbers(v, n, "finite values (n,)", (None,)) for v, n in ((x, "x"), (y, "y")))
    wanted = f"finite values ({len(y)}, {len(x)})"
    values = numbers(values, "values", wanted, (len(y), len(x)))
    filled = ax.contourf(x, y, values, levels=9, cmap="Blues")
    bar = ax.figure.colorbar(filled, ax=ax)
    bar.set_label(label, labelpad=12)
    bar.outline.set_visible(False)
