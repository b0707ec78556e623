"""Colours and settings shared by all figures."""

import re

import matplotlib as mpl
from IPython import get_ipython
from IPython.core.pylabtools import print_figure
from matplotlib.figure import Figure
from matplotlib_inline.backend_inline import set_matplotlib_formats

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
AXIS_COLOURS = {"x": RED, "y": GREEN, "z": BLUE}

STYLE = {
    "figure.figsize": (6.0, 3.8),
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "figure.constrained_layout.use": True,
    "savefig.transparent": True,
    "savefig.dpi": 90,
    "svg.hashsalt": "helpers",
    "font.size": 10,
    "mathtext.fontset": "cm",
    "axes.titlesize": 11,
    "axes.titleweight": "normal",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#DDDDDD",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.8,
    "legend.frameon": False,
    "axes.prop_cycle": mpl.cycler(color=[BLUE, RED, GREEN, ORANGE, PURPLE, SKY, "#000000"]),
}


def use_book_style() -> None:
    """Set the book's style for this notebook: sharp, small SVG figures with the same bytes on every run."""
    mpl.rcParams.update(STYLE)
    set_matplotlib_formats("svg")
    if shell := get_ipython():
        shell.display_formatter.formatters["image/svg+xml"].for_type(Figure, svg)


def svg(figure: Figure) -> str:
    """A figure as SVG text, its coordinates rounded to 0.01 pt so that no machine's last digit shows."""
    text = print_figure(
        figure, fmt="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None}
    )
    text = re.sub(r"\b[1-9]\d*\.\d{3,}(?![\de])", lambda number: f"{float(number[0]):.2f}", text)
    text = re.sub(r"(?s)<metadata>.*?</metadata>|<!--.*?-->", "", text)
    return re.sub(r"\s*\n\s*([LCQMz]\b)?", lambda found: found[1] or "\n", text)
