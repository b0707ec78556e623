"""Test that the generator of answers is reproducible and that its texts contain the numbers."""

from dataclasses import replace

import numpy as np
import pytest

from helpers.inputs import ArmError
from tests.measure.random_answers.draws import draw_answer, draw_twin, shows_mistake
from tests.measure.random_answers.numbers import NumberFormat, write_number
from tests.measure.random_answers.questions import ask_judge

DRAWS = range(60)


def test_draws_of_one_seed_are_reproducible():
    assert [draw_answer(7, i).text for i in DRAWS] == [draw_answer(7, i).text for i in DRAWS]


def test_text_contains_each_typed_number():
    for i in DRAWS:
        draw = draw_answer(7, i)
        text = "".join(draw.text.replace("\u00a0", " ").split())
        assert all("".join(number.split()) in text for number in draw.typed), (i, draw.text)


def test_wrong_answer_differs_from_its_right_answer():
    for i in DRAWS:
        right, twin = draw_answer(7, i), draw_twin(7, i)
        assert right.text != twin.text, i
        assert right.features == twin.features, i
        assert np.array_equal(right.question.right, twin.question.right), i


def test_mistake_within_typed_digits_is_right():
    draw = replace(draw_answer(331127, 493), units=np.full((6, 3), 0.1))
    right = draw.question.right
    assert not shows_mistake(draw, right + 0.05)  # 0.15 may be typed as 0.2
    assert shows_mistake(draw, right + 0.2)


@pytest.mark.parametrize(
    ("value", "kind", "text", "unit"),
    [
        (0.2003, "general", "0.2", 0.1),
        (0.2, "trimmed", "0.2", 0.1),
        (0.0001, "trimmed", "0", 0.001),
        (1234.5, "fixed", "1234.500", 0.001),
    ],
)
def test_number_has_unit_of_last_typed_digit(value, kind, text, unit):
    typed = write_number(value, NumberFormat(kind, 3), "text")
    assert typed == (text, pytest.approx(unit))


# Right answers that the judge once called wrong, as seed and index, and what it says now.
ONCE_WRONG = {
    "commas between whole torques and limits": (407521, 4106, "right"),
    "a comma behind a unit": (407521, 5480, "refused"),
    "arguments of a function above a table": (407521, 2328, "right"),
    "a number in a sentence below a column": (407521, 10595, "right"),
    "solutions called q^(1)": (407521, 12760, "right"),
    "an unread row beside code": (915273, 2482, "refused"),
    "two answers beside code": (407521, 16535, "refused"),
    "an arrow that opens a bracket": (982033, 3571, "refused"),
}


@pytest.mark.parametrize(("seed", "index", "grade"), ONCE_WRONG.values(), ids=ONCE_WRONG)
def test_right_answer_is_not_called_wrong(seed, index, grade):
    draw = draw_answer(seed, index)
    try:
        assert ask_judge(draw.question, draw.text, draw.angles).grade == grade
    except ArmError:
        assert grade == "refused"
