"""Test the slider cells of the chapters, which need a running notebook."""

import ast
import re
from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import numpy as np
import pytest
from IPython.display import display
from ipywidgets import interactive

from helpers.robots import PANDA_HOMEWORK
from helpers.statics import static_torque

CHAPTERS = sorted((Path(__file__).parents[1] / "book").glob("0*.ipynb"))


def slider_cells(path):
    cells = nbformat.read(path, as_version=4).cells
    return [
        cell
        for cell in cells
        if cell.cell_type == "code" and "remove-cell" in cell.metadata.get("tags", [])
    ]


def run(path):
    """Run a chapter's imports and slider cell; return its names and the widget."""
    cells = nbformat.read(path, as_version=4).cells
    imports = next(cell for cell in cells if cell.cell_type == "code")
    (sliders,) = slider_cells(path)
    *lines, last = ast.parse(sliders.source).body
    names = {"display": display}
    exec(imports.source, names)
    exec(compile(ast.Module(lines, []), sliders.id, "exec"), names)
    return eval(ast.unparse(last), names)


@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_sliders_run_over_their_whole_range(path, capsys):
    widget = run(path)
    assert isinstance(widget, interactive)
    assert widget.manual
    capsys.readouterr()
    sliders = widget.kwargs_widgets
    for end in ("value", "min", "max"):
        widget.f(**{slider._kwarg: getattr(slider, end) for slider in sliders})
        assert capsys.readouterr().out
    plt.close("all")


def test_force_slider_matches_static_torque(capsys):
    pushed = run(next(path for path in CHAPTERS if "torque" in path.stem)).f
    capsys.readouterr()
    pushed(F_x=20, F_y=0, F_z=-10)
    told = re.findall(r"joint \d: +(-?[\d.]+) N m", capsys.readouterr().out)
    tau = static_torque(PANDA_HOMEWORK, PANDA_HOMEWORK.home, [20, 0, -10, 0, 0, 0])
    assert np.array(told, dtype=float) == pytest.approx(tau, abs=6e-4)
