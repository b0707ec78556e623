"""The unit of the last place of what was typed, and how a report reads."""

import numpy as np
import pytest

from helpers.checks import Finding, Report
from helpers.checks.compare import numbers


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["1.25", "3"], [0.01, 0.01]),
        (["120", "7"], [1, 1]),
        (["12e1", "3e1"], [10, 2]),  # a fifth of the number at most: 1e9 shows no torque
        (["0", "0.0"], [1, 1]),
        (["0", "1e-15", "2.5"], [0.1, 0.1, 0.1]),  # what is left of a zero shows no decimals
        (["1e-12", "2.5"], [0.1, 0.1]),
        (["1e-11", "2.5"], [1e-11, 0.1]),  # two significant digits at most
        (["123.4", "0.01234", "0"], [0.1, 1e-5, 1e-5]),  # four significant digits each
        (["123.4", "0.01234", "1e-13"], [0.1, 1e-5, 1e-5]),
        (["123.4", "0.0123"], [0.1, 1e-4]),
        (["123.4", "0.012345"], [1e-6, 1e-6]),
        (["123.4", "0.01", "5.6"], [0.1, 0.01, 0.01]),
        (["0.1234", "0.5"], [1e-4, 1e-4]),
        (["1.234", "0.0567"], [1e-3, 1e-4]),
        (["pi", "0.5"], [0, 0.1]),
        (["pi", "5"], [0, 0]),
        (["1.234567890123", "0.5"], [0, 0]),  # thirteen digits: never rounded
        (["1.23456789012", "0.5"], [1e-11, 1e-11]),
        ([], []),
    ],
)
def test_units_of_numbers_typed_together(texts, expected):
    assert numbers(texts, "yours").units == pytest.approx(np.array(expected), rel=1e-12, abs=0)


def test_floats_are_told_by_their_shortest_spelling():
    found = numbers(np.array([[1.0, 2.5], [3.0, 0.125]]), "yours").units
    assert found == pytest.approx(np.full((2, 2), 1e-3))
    assert numbers(np.array([3.0, 20.0]), "yours").units == pytest.approx([1, 1])


def finding(what, words):
    return Finding(what, "row 2", 1.5, None, words)


def test_a_report_in_lines_and_in_markdown():
    findings = (
        finding("cause", "The sign is wrong."),
        finding("row", "Row 2 is off."),
        finding("row", "Row 3 is off."),
    )
    report = Report(
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
    ("grade", "mark"), [("right", "✔"), ("so far", "◐"), ("rounded", "≈"), ("wrong", "✘")]
)
def test_the_mark_of_a_grade(grade, mark):
    report = Report("pose", "Panda", grade, "So it is.")
    assert report.agrees == (grade == "right")
    assert report._repr_markdown_() == f"{mark} **So it is.**\n"
    assert (report.findings, report.causes, report.taken, report.notes) == ((), (), (), ())
    assert report.figures == {}
    assert report == Report("pose", "Panda", grade, "So it is.", figures={"worst": 1.0})
