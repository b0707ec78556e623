"""Test the fields below exercises: what they read, and that each accepts its solution."""

import json
import re
from functools import cache
from pathlib import Path

import nbformat
import pytest
import quickjs

from tools.numbering import list_notebooks, page_name
from tools.plain_markdown import DATA, OPEN_ANSWER

SCRIPT = Path(__file__).parents[1] / "book/assets/answer.js"
NUMBER = re.compile(r"(?<![\w.])-?\d+\.?\d*(?:e-?\d+)?")
EXERCISE = re.compile(r"(?m)^### Exercise ([\d.]+)")
# Exercises whose answer is a sentence, a formula or a matrix of formulas.
WITHOUT_NUMBERS = {
    *("ex-wrong-sign", "ex-three-factors", "ex-elsewhere", "ex-chance", "ex-lagrange", "ex-polar"),
}


@cache
def load_script():
    context = quickjs.Context()
    context.eval(SCRIPT.read_text(encoding="utf-8"))
    return context


def judge(text, **question):
    return json.loads(
        load_script().eval(
            f"JSON.stringify(judgeAnswer({json.dumps(text)}, {json.dumps(question)}))"
        )
    )


def list_fields():
    """Yield each field's data with the text and outputs of the solution below it."""
    for path in list_notebooks():
        number, field, in_solution = "", None, False
        for cell in nbformat.read(path, as_version=4).cells:
            if cell.cell_type == "markdown" and re.search(r"(?m)^#", cell.source):
                in_solution = "#### Solution" in cell.source
                if field and not in_solution:
                    yield field
                    field = None
            if match := EXERCISE.search(cell.source):
                number = match[1]
            if tag := OPEN_ANSWER.search(cell.source):
                field = {
                    "id": f"{page_name(path)} {number}",
                    "data": dict(DATA.findall(tag[1])),
                    "text": cell.source[tag.end() :].partition("</div>")[0],
                    "solution": "",
                }
            if field and in_solution:
                outputs = [str(o.get("text") or o.get("data", {})) for o in cell.get("outputs", [])]
                field["solution"] += "\n".join(["", cell.source, *outputs])


FIELDS = [*list_fields()]


def list_questions():
    """Yield each exercise's anchor with its text above the solution."""
    for path in list_notebooks():
        anchor, text = "", ""
        for cell in nbformat.read(path, as_version=4).cells:
            if cell.cell_type == "markdown" and re.search(r"(?m)^#", cell.source):
                if anchor:
                    yield anchor, text
                anchor, text = "", ""
                if EXERCISE.search(cell.source):
                    (anchor,) = re.findall(r'<a id="(ex-[\w-]+)">', cell.source)
            text += cell.source if cell.cell_type == "markdown" else ""


def test_each_exercise_has_a_hint_before_its_solution():
    assert not [anchor for anchor, text in list_questions() if "> **Hint**" not in text]


def test_each_exercise_with_numbers_has_a_field_or_a_form():
    has_field = re.compile('<div class="(answer|judge)"')
    without = {anchor for anchor, text in list_questions() if not has_field.search(text)}
    assert without == WITHOUT_NUMBERS


@pytest.mark.parametrize("field", FIELDS, ids=[field["id"] for field in FIELDS])
def test_field_accepts_the_numbers_of_its_solution(field):
    """Each number of the answer must occur in the solution's text or outputs, to the tolerance."""
    data = field["data"]
    solution = field["solution"].replace("\N{MINUS SIGN}", "-")
    printed = [float(number) for number in NUMBER.findall(solution)]
    for answer in data["answer"].split("|"):
        for value in map(float, answer.split()):
            nearest = min(printed, key=lambda number: abs(number - value))
            assert abs(nearest - value) <= float(data["within"]), (value, nearest)
        assert judge(answer, **data)["right"]
        wrong = " ".join(
            str(float(value) + 3 * float(data["within"]) + 1) for value in answer.split()
        )
        assert not judge(wrong, **data)["right"]


# Units of the quantities that a field asks for, by the words that its text uses.
QUANTITIES = {
    "speed": ["rad/s"],
    "acceleration": ["rad/s²"],
    "push|force": ["N"],
    "torque": ["N m"],
    "angle|degrees|joints": ["°", "rad"],
    "period": ["s"],
    "radius|above the top|far is|flange's|rows": ["m", "cm", "mm"],
}
WITH_UNIT = [field for field in FIELDS if "unit" in field["data"]]


@pytest.mark.parametrize("field", WITH_UNIT, ids=[field["id"] for field in WITH_UNIT])
def test_units_fit_the_quantities_that_a_field_asks_for(field):
    units = field["data"]["unit"].split(", ")
    words = re.findall("|".join(QUANTITIES), field["text"])
    for unit, word in zip(units, words[: len(units)], strict=True):
        (allowed,) = [units for names, units in QUANTITIES.items() if word in names.split("|")]
        assert unit in allowed


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("1.571, -0.8", True),
        ("(pi/2; -0.8)", True),
        ("0.5*pi −0.8", True),
        ("q = 1.571, -0.8", False),
        ("1.571", False),
        ("1,571 -0.8", False),
        ("1.571 0.8", False),
        ("-0.8 1.571", False),
        ("2 3", True),
    ],
)
def test_field_reads_numbers_in_order(text, right):
    assert judge(text, answer="1.5708 -0.8 | 2 3", within="0.001")["right"] is right


def test_field_accepts_only_the_unit_that_it_names():
    question = {"answer": "53", "within": "1", "unit": "mm"}
    assert judge("53 mm", **question)["right"]
    verdict = judge("0.053 m", **question)
    assert verdict == {
        "right": False,
        "message": 'I read numbers only, not "m". Expected: 1 number in mm.',
    }
