"""Test how a verdict prints, as text and as Markdown."""

import pytest

from helpers.checks import Finding, Verdict


def make_finding(what, words):
    return Finding(what, "row 2", 1.5, None, words)


def test_verdict_prints_as_lines_and_markdown():
    findings = (
        make_finding("cause", "The sign is wrong."),
        make_finding("row", "Row 2 is off."),
        make_finding("row", "Row 3 is off."),
    )
    verdict = Verdict(
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
    assert verdict.lines == lines
    text = "\n- ".join(["Not right: row 3 is off.", *lines])
    assert str(verdict) == repr(verdict) == text
    head, rest = text.split("\n", 1)
    assert verdict._repr_markdown_() == f"✘ **{head}**\n\n{rest}"
    assert [str(f) for f in findings[:2]] == ["The sign is wrong.", "Row 2 is off."]
    assert not verdict.agrees


@pytest.mark.parametrize(
    ("grade", "mark"),
    [("right", "✔"), ("right by map", "✔"), ("so far", "◐"), ("rounded", "≈"), ("wrong", "✘")],
)
def test_each_grade_has_its_mark(grade, mark):
    verdict = Verdict("pose", "Panda", grade, "So it is.")
    assert verdict.agrees == grade.startswith("right")
    assert verdict._repr_markdown_() == f"{mark} **So it is.**\n"
    assert (verdict.findings, verdict.causes, verdict.taken, verdict.notes) == ((), (), (), ())
    assert verdict.figures == {}
    assert verdict == Verdict("pose", "Panda", grade, "So it is.", figures={"worst": 1.0})
