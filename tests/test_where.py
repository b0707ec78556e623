"""The page that says where the book has what the reports contain: no line empty."""

import re
from pathlib import Path

TEXT = (Path(__file__).parents[1] / "book" / "where.md").read_text(encoding="utf-8")


def test_no_line_is_empty():
    rows = re.findall(r"(?m)^\* - (.+)\n  - (.+)$", TEXT)
    assert len(rows) == TEXT.count("\n* - ") > 50
    places = [place for _, place in rows if place != "In the book"]
    assert all(re.search(r"\{(doc|ref|numref|eq)\}`", place) for place in places)
