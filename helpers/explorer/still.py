"""Draw still pictures of arms, which notebooks show if no kernel runs."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm

ISOMETRIC = (-45.0, math.degrees(math.atan(math.sqrt(0.5))))  # azimuth and elevation, degrees


def draw_still(arm: Arm, q: ArrayLike) -> str:
    """Return a picture of an arm at q, shape (dof,), as SVG text.

    Equal arguments give equal bytes.

    Matplotlib is imported here, since the build of the book's pages needs no still pictures.
    """
    import matplotlib as mpl
    from matplotlib.figure import Figure

    from helpers import plotting
    from helpers.plotting.style import STYLE, format_svg

    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(3.6, 3.6))
        plotting.draw_arm(figure.subplots(), arm, np.asarray(q, dtype=float), ISOMETRIC)
        return format_svg(figure)
