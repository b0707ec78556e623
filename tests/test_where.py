"""Test that every line of the page "where" points to a place in the book."""

import re
from itertools import pairwise
from pathlib import Path

import nbformat

from tests.test_prose_numbers import find_unbacked_numbers

BOOK = Path(__file__).parents[1] / "book"
ROW = re.compile(r"(?m)^\| ?(.+?) ?\| ?(.+?) ?\|$")
TEXT = (BOOK / "where.md").read_text(encoding="utf-8")


def test_every_line_has_a_reference():
    rows = re.findall(ROW, TEXT)
    assert len(rows) == TEXT.count("\n|") > 50
    places = [place for _, place in rows if not re.match(r"In the book|:--", place)]
    assert not [place for place in places if not re.search(r"\]\([\w/.]+", place)], "add a link"


def test_tables_and_frames_point_to_sections():
    table = TEXT.partition("## Tables and frames")[2].partition("\n## ")[0]
    rows = re.findall(ROW, table)[2:]
    assert not [place for _, place in rows if "(01_dh_tables.ipynb#" not in place]


def test_each_arm_has_a_figure_of_its_frames():
    (places,) = re.findall(r"each arm with all its frames \| (.+)", TEXT)
    cells = nbformat.read(BOOK / "01_dh_tables.ipynb", as_version=4).cells
    figures = {
        name: cell.source
        for cell, below in pairwise(cells)
        for name in re.findall(r'<a id="(fig-[\w-]+)">', below.source)
    }
    drawn = [figures[name] for name in re.findall(r"#(fig-[\w-]+)\)", places)]
    assert len(drawn) == 4
    assert not [source for source in drawn if "plotting.draw_frames(" not in source]


def test_results_of_assignment_sheets_are_on_linked_pages():
    sheets = TEXT.partition("## Assignment sheets")[2].partition("\n## ")[0]
    results = [
        row for row in re.findall(r"(?m)^\| (.+?) \| (.+?) \| (.+?) \|$", sheets) if "](" in row[1]
    ]
    assert len(results) == 26
    for task, place, result in results:
        pages = [BOOK / name for name in re.findall(r"\]\(([\w/]+\.ipynb)", place)]
        cells = [cell for page in pages for cell in nbformat.read(page, as_version=4).cells]
        code = [cell for cell in cells if cell.cell_type == "code"]
        prose = nbformat.v4.new_markdown_cell(result.replace("\N{MINUS SIGN}", "-"))
        assert find_unbacked_numbers([prose, *code]) == [], task
