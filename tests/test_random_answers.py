"""Test that the generator of answers is reproducible and that its texts contain the numbers."""

from dataclasses import replace

import numpy as np
import pytest

from tests.measure.random_answers.draws import draw_answer, draw_twin, shows_mistake
from tests.measure.random_answers.numbers import NumberFormat, write_number

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
