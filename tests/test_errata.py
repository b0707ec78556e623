"""Test that the errata page and the slip boxes agree and quote what the reports contain."""

import re
from pathlib import Path

import nbformat
import pytest

from tools.numbering import list_notebooks

BOOK = Path(__file__).parents[1] / "book"
REPORTS = ("Panda report", "UR10e report", "Elbow and Stanford report")
# The kind of each slip, decided by reading the reports. A change of this table changes what the
# book says of a report.
KINDS = {
    "Wrong result": {12, 15, 18, 19},
    "Wrong word": {1, 3, 4, 5, 6, 11, 13, 16, 17, 20},
    "Given": {2, 9, 21, 25},
    "Stated approximation": {8},
    "Incomplete": {14, 22, 23},
    "Unproved": {7, 10},
    "Withdrawn": {24, 26, 27},
}
# Words that must occur in the slip's box and its errata entry, since they are fair to the report.
IN_FAIRNESS = {
    3: "mended by the report itself",
    4: "a picture may be lost",
    5: "mended by the report itself",
    6: "mended by the report itself",
    7: "Except link 2 & link 3",
    10: "resulting graph was obtained",
    11: "polar coordinates of the circle that needs to be traced",
    12: "of the other elbow",
    13: r"\theta'_1 = \pi + ",
    16: "two slips that cancel",
    17: "mended by the report itself",
    20: "is the number of iterations",
    21: "mended by the report itself",
    24: "The report says neither",
    25: "initial column vector is given",
    26: "Next pages contain the same report",
    27: "$o_4$ has the right term",
}
NUMBERS = range(1, 28)
BOX = re.compile(r'<a id="(slip-[\w-]+)"></a>\n\n> \*\*Slip .*\n((?:>.*\n?)*)')


def _entries():
    text = (BOOK / "errata.md").read_text(encoding="utf-8")
    found = re.findall(r"^### (\d+) · [^\n]+\n(.+?)(?=^##|\Z)", text, re.M | re.S)
    return [(int(number), entry) for number, entry in found]


def _boxes():
    """Every slip box of the chapters by its label, with whether code follows before the next
    heading or box."""
    found = {}
    for path in list_notebooks():
        cells = nbformat.read(path, as_version=4).cells
        for i, cell in enumerate(cells):
            for anchor, quoted in BOX.findall(cell.source):
                assert anchor not in found, anchor
                near = cells[max(i - 1, 0) : i + 2]
                found[anchor] = (
                    re.sub("(?m)^> ?", "", quoted),
                    any(
                        "check(" in c.source or "compare_" in c.source or "print(" in c.source
                        for c in near
                        if c.cell_type == "code"
                    ),
                )
    return found


ENTRIES, BOXES = _entries(), _boxes()


def _quotation(text):
    return "\n".join(line[1:].strip() for line in text.splitlines() if line.startswith(">"))


def _must_quote(text):
    *words, report = [line for line in _quotation(text).splitlines() if line]
    assert report in REPORTS
    assert sum(map(len, words)) > 10


def _kind(text):
    (kind, *_) = re.findall(r"^\*\*([^*]+)\*\*", text, re.M)
    assert kind in KINDS
    return kind


def test_errata_list_27_slips_once():
    assert sorted(number for number, _ in ENTRIES) == list(NUMBERS)
    assert sorted(number for numbers in KINDS.values() for number in numbers) == list(NUMBERS)


@pytest.mark.parametrize(("number", "text"), ENTRIES, ids=[str(number) for number, _ in ENTRIES])
def test_entry_has_quotation_kind_and_link(number, text):
    _must_quote(text)
    assert number in KINDS[_kind(text)]
    links = re.findall(r"\]\([\w/]+\.ipynb#(slip-[\w-]+)\)", text)
    if number not in KINDS["Withdrawn"]:  # withdrawn slips have no link from a chapter
        assert f"slip-{number}" in links
        assert set(links) <= set(BOXES)


@pytest.mark.parametrize("number", sorted(set(NUMBERS) - KINDS["Withdrawn"]))
def test_box_agrees_with_its_entry_and_has_a_proof(number):
    text, proved = BOXES[f"slip-{number}"]
    entry = dict(ENTRIES)[number]
    _must_quote(text)
    assert _quotation(text) == _quotation(entry)
    assert _kind(text) == _kind(entry)
    assert proved
    if _kind(text) == "Wrong word":
        assert "right" in text, "state that the formula or result beside the word is right"


@pytest.mark.parametrize(("number", "words"), IN_FAIRNESS.items())
def test_mitigating_facts_are_mentioned(number, words):
    assert words in dict(ENTRIES)[number]
    if number not in KINDS["Withdrawn"]:
        assert words in BOXES[f"slip-{number}"][0]


def test_withdrawn_slips_have_no_box():
    assert not {f"slip-{number}" for number in KINDS["Withdrawn"]} & set(BOXES)


def test_withdrawn_claims_do_not_appear():
    text = "\n".join([*(text for text, _ in BOXES.values()), *(entry for _, entry in ENTRIES)])
    for words in (
        "six of eight",
        "1.4 N m in joint 2",
        "known textbook form",
        "and so have its $A_3$",
        "largest error of this report",
        "half of all targets",
        "for the second solution",
        "centre is left out",
        "without its centre",
        "without saying so",
        "Jacobian beside it is right",
        "Each page is right",
    ):
        assert words not in text


def test_book_does_not_speculate_about_programs():
    for path in [*BOOK.glob("*.md"), *list_notebooks()]:
        words = path.read_text(encoding="utf-8")
        if path.suffix == ".ipynb":
            words = "\n".join(c.source for c in nbformat.reads(words, 4).cells)
        assert not re.search(r"report's program|lists every slip|reports? expects?", words), (
            path.name
        )
