"""Set colours and style of all figures, and write them as SVG."""

import re
import sys
from hashlib import sha256
from io import BytesIO
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import numpy as np
from cycler import cycler
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Bbox

# Okabe and Ito's palette, which colour-blind readers can distinguish.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY = (
    "#0072B2",
    "#E69F00",
    "#009E73",
    "#D55E00",
    "#CC79A7",
    "#56B4E9",
)
GREY = "#8A8F98"
SLATE = "#5B6472"  # joints
OUTLINED = "outlined"  # gid of a text on top of lines, which needs a white outline
# The stroke width is in glyph units, 6400 per font size. Matplotlib's own outlines would double
# the size of the text.
OUTLINE = "stroke:#fff;stroke-width:1200;stroke-linejoin:round;paint-order:stroke"
PANEL_PADDING = 3  # pt around a panel that a phone shows alone
INLINE_BACKEND_NAMES = ("inline", "module://matplotlib_inline.backend_inline")  # Jupyter's
AXIS_COLOURS = {"x": RED, "y": GREEN, "z": BLUE}

STYLE: dict[Any, Any] = {
    "figure.figsize": (6.0, 3.8),
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "figure.constrained_layout.use": True,
    "savefig.transparent": True,
    "savefig.dpi": 90,
    "svg.hashsalt": "helpers",
    "font.size": 11,  # larger, because labels are mostly formulas with small letters
    **dict.fromkeys(("xtick.labelsize", "ytick.labelsize", "axes.labelsize"), 10),
    "legend.fontsize": 10,
    "mathtext.fontset": "stix",  # the font of formulas on pages
    "axes.titlesize": 11,
    "axes.titleweight": "normal",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#DDDDDD",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.8,
    "legend.frameon": False,
    "axes.prop_cycle": cycler(color=[BLUE, RED, GREEN, ORANGE, PURPLE, SKY, "#000000"]),
}


def use_book_style() -> None:
    """Set the style of figures.

    In a notebook figures are SVG and arrays are printed with four decimals.
    """
    mpl.rcParams.update(STYLE)
    ipython = sys.modules.get(
        "IPython"
    )  # already imported in every notebook; elsewhere no display exists
    if ipython and (shell := ipython.get_ipython()):
        import matplotlib.pyplot as plt
        from matplotlib_inline.backend_inline import set_matplotlib_formats  # part of IPython

        set_matplotlib_formats("svg")
        # Otherwise pyplot would also draw every figure in pixels after each cell, in vain.
        if mpl.get_backend() in INLINE_BACKEND_NAMES:
            plt.uninstall_repl_displayhook()
        shell.display_formatter.formatters["image/svg+xml"].for_type(Figure, format_svg)
        np.set_printoptions(precision=4, suppress=True)


def label_time_axis(ax: Axes) -> None:
    """Label the time axis of a panel, which a phone shows without its neighbours."""
    ax.set_xlabel("$t$ (s)")
    ax.xaxis.set_major_locator(MaxNLocator(2, steps=[1, 2, 2.5, 5, 10]))
    ax.tick_params(labelbottom=True)


def format_svg(figure: Figure) -> str:
    """Return a figure as SVG text, with the same bytes on every machine.

    Numbers are rounded to 0.01 pt and ids are numbered. Each of several panels gets a view of its
    own: `panel-1`, `panel-2` and so on.
    """
    figure.dpi = 72  # at this resolution a pixel is a point of the SVG
    file = BytesIO()
    figure.canvas.print_figure(
        file,
        format="svg",
        dpi=figure.dpi,
        facecolor=figure.get_facecolor(),
        edgecolor=figure.get_edgecolor(),
        bbox_inches="tight",
        metadata={"Date": None, "Creator": None},
    )
    text = re.sub(
        r"\b[1-9]\d*\.\d{3,}(?![\de])",
        lambda number: f"{round(float(number[0]), 2):.15g}",
        file.getvalue().decode(),
    )
    text = re.sub(r"(?<![\w.-])-0(?![\d.])", "0", text)
    # Few lines make a notebook small, since it stores each line as a string. Figure and axes keep
    # their ids, which the tests read.
    text = re.sub(r"(?s)<metadata>.*?</metadata>|<!--.*?-->|<\?xml.*?\?>|<!DOCTYPE.*?>", "", text)
    text = text.replace(f'<g id="{OUTLINED}"', f'<g style="{OUTLINE}"')
    text = re.sub(r'(<g) id="(?!figure_|axes_)[^"]*"', r"\1", re.sub(r"\s*\n\s*", "", text))
    text = re.sub(r' xmlns:xlink="[^"]*"|\bxlink:(?=href=)|(?<=[MLQC]) (?=[-\d])', "", text)
    # Matplotlib's ids are hashes of numbers with round-off; replace them by consecutive numbers.
    ids = {name: str(k) for k, name in enumerate(dict.fromkeys(_HASHED_ID.findall(text)))}
    figure_name = sha256(_replace_ids(text, ids, "").encode()).hexdigest()[:8]
    text = _replace_ids(text, ids, f"f{figure_name}-")
    text = text.replace('<g id="figure_1">', f'{_format_panel_views(figure)}<g id="figure_1">', 1)
    return text.replace("<path", "\n<path")  # short lines make diffs of notebooks readable


def _format_panel_views(figure: Figure) -> str:
    """Return an SVG view of each panel for a phone, or "" if the panels form a column."""
    bars = {
        ax: [artist.colorbar.ax for artist in (*ax.collections, *ax.images) if artist.colorbar]
        for ax in figure.axes
        if ax.get_visible()
    }
    # A panel is a legend of the figure, or axes with their colour bar.
    groups: list[list[Artist]] = [[legend] for legend in figure.legends]
    groups += [[ax, *bars[ax]] for ax in bars if not any(ax in others for others in bars.values())]
    boxes = ([part.get_tightbbox() for part in group] for group in groups)
    panels = [Bbox.union([box for box in group if box is not None]) for group in boxes]
    if all(below.y1 < (above.y0 + above.y1) / 2 for above, below in pairwise(panels)):
        return ""
    page = figure.get_tightbbox().padded(mpl.rcParams["savefig.pad_inches"])  # in inches
    views = []
    for k, box in enumerate((box.padded(PANEL_PADDING) for box in panels), 1):
        sides = (box.x0 - 72 * page.x0, 72 * page.y1 - box.y1, box.width, box.height)
        views.append(
            f'<view id="panel-{k}" viewBox="{" ".join(f"{side:.0f}" for side in sides)}"/>'
        )
    return "".join(views)


_HASHED_ID = re.compile(r'id="([mp][0-9a-f]{10})"')


def _replace_ids(text: str, ids: dict[str, str], prefix: str) -> str:
    return re.sub(
        r"\b[mp][0-9a-f]{10}\b",
        lambda name: prefix + ids[name[0]] if name[0] in ids else name[0],
        text,
    )
