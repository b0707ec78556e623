"""A reader may change a length: a chapter then runs to its end, and what held for the book's own
numbers only says so.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import pytest

from helpers import robots
from helpers.checks.arms import judged_data

BOOK = Path(__file__).parents[1] / "book"


@pytest.mark.parametrize(
    ("chapter", "arm", "length", "least"),
    [
        ("02_jacobian", "UR10E_HOMEWORK", {"d_5": 0.12}, 2),
        ("04_static_torque", "PANDA", {"a_3": 0.09075}, 3),
    ],
)
def test_a_chapter_runs_to_its_end(chapter, arm, length, least, monkeypatch, capsys):
    monkeypatch.setattr(robots, arm, getattr(robots, arm).with_values(**length))
    monkeypatch.setattr(plt, "rcParams", plt.rcParams.copy())
    names = {}
    for cell in nbformat.read(BOOK / f"{chapter}.ipynb", as_version=4).cells:
        if cell.cell_type == "code":
            exec(compile(cell.source, cell.id, "exec"), names)
    plt.close("all")
    judged_data.cache_clear()  # it knows the changed arm by a name of the catalogue
    lines = capsys.readouterr().out.splitlines()
    of_the_book = [line for line in lines if line.startswith("○")]
    assert len(of_the_book) >= least
    assert all("the book's own numbers" in line for line in of_the_book)
