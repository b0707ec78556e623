"""The generator of clothed answers draws by seed and keeps the numbers readable."""

import numpy as np

from tests.clothed.draws import draw_answer, draw_twin

DRAWS = range(60)


def test_draws_of_one_seed_are_reproducible():
    assert [draw_answer(7, i).text for i in DRAWS] == [draw_answer(7, i).text for i in DRAWS]


def test_text_contains_each_typed_number():
    for i in DRAWS:
        draw = draw_answer(7, i)
        text = "".join(draw.text.replace("\u00a0", " ").split())
        assert all("".join(number.split()) in text for number in draw.typed), (i, draw.text)


def test_twin_differs_from_its_right_answer():
    for i in DRAWS:
        right, twin = draw_answer(7, i), draw_twin(7, i)
        assert right.text != twin.text, i
        assert right.features == twin.features, i
        assert np.array_equal(right.question.right, twin.question.right), i
