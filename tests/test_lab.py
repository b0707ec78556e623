"""A reader's own copies: nothing in them is dead, and what the sliders do runs."""

import re
import runpy
from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import numpy as np
import pytest

from helpers.explorer import ArmFigure
from helpers.robots import PANDA
from helpers.statics import static_torque
from tools import lab

ROOT = Path(__file__).parents[1]
BOOK = sorted(ROOT.glob("book/*.ipynb"))
SLIDERS = sorted(lab.SLIDERS.glob("*.py"))


def sources(notebook, kind):
    return [cell.source for cell in notebook.cells if cell.cell_type == kind]


@pytest.mark.parametrize("path", BOOK, ids=lambda path: path.stem)
def test_a_copy_says_what_the_book_says_and_every_figure_lives(path):
    book, copy = nbformat.read(path, as_version=4), lab.own_copy(path)
    nbformat.validate(copy)
    told = "\n".join(sources(book, "markdown"))
    text = "\n".join(sources(copy, "markdown"))
    assert not re.findall(r"data-figure|cite:|\{(?:foot)?bibliography", text)
    figures = [code for code in sources(copy, "code") if "ArmFigure(" in code]
    dead = told.count("data-figure=")
    assert len(figures) - dead == sum("ArmFigure(" in code for code in sources(book, "code"))
    for code in set(figures) - set(sources(book, "code")):
        names = {}
        exec(code.rsplit("\n", 1)[0], names)
        made = eval(code.rsplit("\n", 1)[1], names)
        assert isinstance(made, ArmFigure)
    added = len(sources(copy, "code")) - len(sources(book, "code"))
    assert added == dead + (path.stem in {sliders.stem for sliders in SLIDERS})
    words = re.sub(r"<div class=.arm-explorer.*?</div>|\{footcite.*?`.*?`", "", told, flags=re.S)
    for line in words.split("\n"):
        if not line.startswith(("```", ":")):
            assert all(word in text for word in line.split())


def test_citations_stand_in_words():
    text = "\n".join(sources(lab.own_copy(ROOT / "book/01_dh_tables.ipynb"), "markdown"))
    assert "(Spong and others 2020)" in text
    assert "(Denavit and Hartenberg 1955)" in text
    assert "- Craig: *Introduction to Robotics: Mechanics and Control*, 2018." in text


def test_every_chapter_has_sliders_beside_its_figure():
    chapters = [path for path in BOOK if path.stem[0] == "0"]
    assert [path.stem for path in SLIDERS] == [path.stem for path in chapters]
    for path in chapters:
        cells = lab.own_copy(path).cells
        place = next(i for i, cell in enumerate(cells) if "@interact(" in cell.source)
        assert "ArmFigure(" in cells[place - 1].source


@pytest.mark.parametrize("path", SLIDERS, ids=lambda path: path.stem)
def test_sliders_run_where_they_begin_and_end(path, capsys):
    names = runpy.run_path(str(path))
    ((ranges, function),) = re.findall(r"@interact\((.*)\)\ndef (\w+)", path.read_text("utf-8"))
    ends = eval(f"dict({ranges})")
    names[function]()
    for end in (0, 1):
        names[function](**{name: span[end] for name, span in ends.items()})
    plt.close("all")
    assert capsys.readouterr().out


def test_the_force_is_the_chapters_own(capsys):
    function = runpy.run_path(str(lab.SLIDERS / "04_static_torque.py"))["pushed"]
    capsys.readouterr()
    function(F_x=20, F_y=0, F_z=-10)
    told = re.findall(r"joint \d: +(-?[\d.]+) N m", capsys.readouterr().out)
    tau = static_torque(PANDA, PANDA.home, [20, 0, -10, 0, 0, 0])
    assert np.array(told, dtype=float) == pytest.approx(tau, abs=6e-4)


def test_a_copy_that_is_there_stays(tmp_path):
    folder = tmp_path / "my"
    lab.main(folder, BOOK[:1])
    mine = folder / BOOK[0].name
    assert "@interact(" in mine.read_text("utf-8")
    mine.write_text("mine", "utf-8")
    lab.main(folder, BOOK[:2])
    assert mine.read_text("utf-8") == "mine"
    assert sorted(path.name for path in folder.iterdir()) == [path.name for path in BOOK[:2]]
