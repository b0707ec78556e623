"""Colours and settings of all figures."""

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

# Okabe and Ito's colours, told apart by colour-blind readers too.
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
PAD = 3  # points around a panel that is shown alone
AXIS_COLOURS = {"x": RED, "y": GREEN, "z": BLUE}

STYLE: dict[Any, Any] = {
    "figure.figsize": (6.0, 3.8),
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "figure.constrained_layout.use": True,
    "savefig.transparent": True,
    "savefig.dpi": 90,
    "svg.hashsalt": "helpers",
    "font.size": 10,
    "mathtext.fontset": "dejavuserif",
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
    """Set the book's style: in a notebook, sharp, small SVG figures with the same bytes on every
    run, and arrays printed to four digits."""
    mpl.rcParams.update(STYLE)
    ipython = sys.modules.get("IPython")  # loaded in every notebook, and of no use elsewhere
    if ipython and (shell := ipython.get_ipython()):
        from matplotlib_inline.backend_inline import set_matplotlib_formats  # comes with IPython

        set_matplotlib_formats("svg")
        shell.display_formatter.formatters["image/svg+xml"].for_type(Figure, svg)
        np.set_printoptions(precision=4, suppress=True)


def time_axis(ax: Axes) -> None:
    """Label the time axis of this panel too, since a phone shows one panel at a time."""
    ax.set_xlabel("$t$ (s)")
    ax.xaxis.set_major_locator(MaxNLocator(2, steps=[1, 2, 2.5, 5, 10]))
    ax.tick_params(labelbottom=True)


def svg(figure: Figure) -> str:
    """A figure as SVG text, the same on every machine: numbers to 0.01 pt, ids from what they
    name. Of several panels each is a view of it, `panel-1`, `panel-2` and so on."""
    figure.dpi = 72  # of which an SVG is made
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
    text = re.sub(r"\b[1-9]\d*\.\d{3,}(?![\de])", _to_hundredths, file.getvalue().decode())
    text = _with_own_ids(_lean(re.sub(r"(?<![\w.-])-0(?![\d.])", "0", text)))
    text = text.replace('<g id="figure_1">', f'{_views(figure)}<g id="figure_1">', 1)
    return text.replace("<path", "\n<path")  # lines short enough for a diff of two notebooks


def _views(figure: Figure) -> str:
    """Where the panels of a drawn figure stand in its SVG, for a screen that has room for one; of
    panels one above the other nothing is said."""
    panels = _panels(figure)
    if all(below.y1 < (above.y0 + above.y1) / 2 for above, below in pairwise(panels)):
        return ""
    page = figure.get_tightbbox().padded(mpl.rcParams["savefig.pad_inches"])  # in inches
    views = []
    for k, box in enumerate((box.padded(PAD) for box in panels), 1):
        sides = (box.x0 - 72 * page.x0, 72 * page.y1 - box.y1, box.width, box.height)
        views.append(
            f'<view id="panel-{k}" viewBox="{" ".join(f"{side:.0f}" for side in sides)}"/>'
        )
    return "".join(views)


def _panels(figure: Figure) -> list[Bbox]:
    """The boxes of a figure's axes, each with its colour bar, in the order of reading, and of the
    legends of all."""
    bars = {
        ax: [artist.colorbar.ax for artist in (*ax.collections, *ax.images) if artist.colorbar]
        for ax in figure.axes
        if ax.get_visible()
    }
    alone: list[list[Artist]] = [
        [ax, *bars[ax]] for ax in bars if not any(ax in of for of in bars.values())
    ]
    keys: list[list[Artist]] = [[legend] for legend in figure.legends]
    boxes = ([part.get_tightbbox() for part in group] for group in [*keys, *alone])
    return [Bbox.union([box for box in group if box is not None]) for group in boxes]


def _to_hundredths(number: re.Match[str]) -> str:
    return f"{round(float(number[0]), 2):.15g}"


def _lean(text: str) -> str:
    """The same picture in fewer characters. A notebook keeps every line as a string of its own, so
    line ends cost most; of the groups only figure and axes keep their names, for the tests."""
    text = re.sub(r"(?s)<metadata>.*?</metadata>|<!--.*?-->|<\?xml.*?\?>|<!DOCTYPE.*?>", "", text)
    text = re.sub(r'(<g) id="(?!figure_|axes_)[^"]*"', r"\1", re.sub(r"\s*\n\s*", "", text))
    return re.sub(r' xmlns:xlink="[^"]*"|\bxlink:(?=href=)|(?<=[MLQC]) (?=[-\d])', "", text)


def _with_own_ids(text: str) -> str:
    """Matplotlib hashes unrounded numbers into ids; number them instead, apart from other figures
    on the page."""
    hashed = dict.fromkeys(re.findall(r'id="([mp][0-9a-f]{10})"', text))
    order = {name: str(number) for number, name in enumerate(hashed)}

    def renamed(prefix: str) -> str:
        return re.sub(
            r"\b[mp][0-9a-f]{10}\b",
            lambda name: prefix + order[name[0]] if name[0] in order else name[0],
            text,
        )

    figure = sha256(renamed("").encode()).hexdigest()[:8]
    return renamed(f"f{figure}-")
