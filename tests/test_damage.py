"""Test that a damaged right answer is called right only if its numbers are still right."""

import pytest

from tests.measure.damage import (
    CALLED_RIGHT,
    KINDS,
    draw_damages,
    explain_right,
    judge,
    list_answers,
)

SEED = 68
SHARE = 0.05  # share of all answers that each kind of damage is applied to
# Damaged answers that the judge should refuse, by the topic of the answer, with the reason:
MISSED = {"columns numbered with their unit": "one of the units in headers is not applied"}


@pytest.mark.parametrize("kind", KINDS)
def test_damaged_answer_is_not_called_right(kind):
    wrongly_right = []
    damages = list(draw_damages(list_answers(works=False), SEED, SHARE, [kind]))
    assert damages
    for damage in damages:
        verdict = judge(damage.answer, damage.text)
        if verdict and verdict.grade in CALLED_RIGHT and not explain_right(damage):
            wrongly_right.append((damage.answer.name, damage.damaged, damage.text))
    assert [answer for answer in wrongly_right if answer[0] not in MISSED] == []
