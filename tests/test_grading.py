"""The unit of the last place of what was typed, and how a report reads."""

import numpy as np
import pytest

from helpers.checks import Finding, Verdict
from helpers.checks.compare import read_numbers


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["1.25", "3"], [0.01, 1]),
        (["120", "7"], [1, 1]),
        (["12e1", "3e1"], [10, 10]),
        (["0", "0.0"], [0, 0]),  # zeros alone say how many digits they have to nobody
        (["0", "1"], [1, 1]),
        (["0", "-1.", "2.50"], [0.01, 0.01, 0.01]),  # as programs print an exact 0 and 1
        (["0.00", "2.5"], [0.01, 0.1]),
        (["0", "6.1e-17", "2.5"], [0.1, 1e-18, 0.1]),  # what is left of a zero shows no decimals
        (["123.4", "0.01234", "0"], [0.1, 1e-5, 1e-5]),
        (["36.3", "1.96", "-18.7"], [0.1, 0.01, 0.1]),
        (["pi", "0.5"], [0, 0.1]),
        (["pi", "0"], [0, 0]),
        (["1.234567890123", "0.5"], [0, 0]),  # thirteen digits: never rounded
        (["1.23456789012", "0.5"], [1e-11, 0.1]),
        ([], []),
    ],
)
def test_the_unit_of_each_number_is_that_of_its_own_last_place(texts, expected):
    assert read_numbers(texts, "yours").units == pytest.approx(np.array(expected), rel=1e-12, abs=0)


def finding(what, words):
    return Finding(what, "row 2", 1.5, None, words)


def test_a_report_in_lines_and_in_markdown():
    findings = (
        finding("cause", "The sign is wrong."),
        finding("row", "Row 2 is off."),
        finding("row", "Row 3 is off."),
    )
    report = Verdict(
        "table",
        "Panda",
        "wrong",
        "Not right: row 3 is off.",
        findings,
        taken=("degrees",),
        notes=("Mind.",),
        advice=("Write radians.",),
    )
    lines = ["Row 2 is off.", "Taken as degrees", "Note: Mind.", "Write radians."]
    assert report.lines == lines
    text = "\n- ".join(["Not right: row 3 is off.", *lines])
    assert str(report) == repr(report) == text
    head, rest = text.split("\n", 1)
    assert report._repr_markdown_() == f"✘ **{head}**\n\n{rest}"
    assert [str(f) for f in findings[:2]] == ["The sign is wrong.", "Row 2 is off."]
    assert not report.agrees


@pytest.mark.parametrize(
    ("grade", "mark"),
    [("right", "✔"), ("right by map", "✔"), ("so far", "◐"), ("rounded", "≈"), ("wrong", "✘")],
)
def test_the_mark_of_a_grade(grade, mark):
    report = Verdict("pose", "Panda", grade, "So it is.")
    assert report.agrees == grade.startswith("right")
    assert report._repr_markdown_() == f"{mark} **So it is.**\n"
    assert (report.findings, report.causes, report.taken, report.notes) == ((), (), (), ())
    assert report.figures == {}
    assert report == Verdict("pose", "Panda", grade, "So it is.", figures={"worst": 1.0})
