"""Maps of a measure over joint angles."""

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from helpers.inputs import numbers

# Blues, without the palest: those are greys nearly, which change sides on a dark page.
COLOURS = mpl.colors.ListedColormap(mpl.colormaps["Blues"](np.linspace(0.35, 1, 256)))


def map_2d(ax: Axes, x: ArrayLike, y: ArrayLike, values: ArrayLike, label: str) -> None:
    """Draw `values` (len(y), len(x)) as filled contours with a colour bar; darker is more."""
    x, y = (numbers(v, n, "finite values (n,)", (None,)) for v, n in ((x, "x"), (y, "y")))
    wanted = f"finite values ({len(y)}, {len(x)})"
    values = numbers(values, "values", wanted, (len(y), len(x)))
    filled = ax.contourf(x, y, values, levels=9, cmap=COLOURS)
    bar = ax.figure.colorbar(filled, ax=ax)
    bar.set_label(label, labelpad=12)
    bar.outline.set_visible(False)
