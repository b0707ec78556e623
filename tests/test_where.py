"""The page that says where the book has what the reports contain: no line empty."""

import re
from pathlib import Path

import nbformat

BOOK = Path(__file__).parents[1] / "book"
TEXT = (BOOK / "where.md").read_text(encoding="utf-8")


def test_every_line_has_a_reference():
    rows = re.findall(r"(?m)^\* - (.+)\n  - (.+)$", TEXT)
    assert len(rows) == TEXT.count("\n* - ") > 50
    places = [place for _, place in rows if place not in ("In the book", "Where to look")]
    assert all(re.search(r"\{(doc|ref|numref|eq)\}`|<a href=", place) for place in places)


def test_tables_and_frames_point_to_sections():
    table = TEXT.partition("## Tables and frames")[2].partition("\n## ")[0]
    rows = re.findall(r"(?m)^\* - (.+)\n  - (.+)$", table)[1:]
    assert all(re.search(r"\{(ref|numref|eq)\}`", place) for _, place in rows)


def test_each_arm_has_a_figure_of_its_frames():
    (places,) = re.findall(r"each arm with all its frames\n  - (.+)", TEXT)
    cells = nbformat.read(BOOK / "01_dh_tables.ipynb", as_version=4).cells
    figures = {
        cell.metadata.mystnb.figure.name: cell.source for cell in cells if "mystnb" in cell.metadata
    }
    drawn = [figures[name] for name in re.findall(r"\{numref\}`([^`]+)`", places)]
    assert len(drawn) == 4
    assert all("plotting.frames(" in source for source in drawn)
