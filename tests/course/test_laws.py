"""Test laws of marks over random sheets and random mistakes in every topic."""

from functools import cache

import numpy as np
import pytest

from course.making import make_right_answers
from course.marking import MISTAKE_SHARE, mark_part
from course.sheets import draw_sheet
from helpers.robots import ELBOW, PANDA, STANFORD
from tests.course.parts import as_text

ARMS = (ELBOW, STANFORD, PANDA.lock(3))
SEEDS = range(50)
NUMBERS = ("numbers", "rotation", "jacobian", "torques", "branches", "pose")
each_sheet = pytest.mark.parametrize("seed", SEEDS)


@cache
def draw(seed):
    """Draw the sheet of a seed, for one of three arms."""
    return draw_sheet(ARMS[seed % 3], f"law {seed}")


def list_number_parts(sheet):
    return [part for part in sheet.parts.values() if part.kind in NUMBERS]


def earn(sheet, part, values, digits=8):
    return mark_part(sheet, part.name, as_text(values, digits)).credit


def spoil(value, rng):
    """Change some numbers by 5 to 50 percent, or change their signs."""
    factors = rng.choice([-1, 0.5, 0.95, 1.05, 1.5], np.shape(value))
    return value * np.where(rng.random(np.shape(value)) < 0.4, factors, 1)


@each_sheet
def test_leaving_out_entries_never_raises_the_credit(seed):
    sheet, rng = draw(seed), np.random.default_rng(seed)
    for part in list_number_parts(sheet):
        wrong = spoil(part.value, rng)
        written = earn(sheet, part, wrong)
        for _ in range(3):
            left_out = np.where(rng.random(wrong.shape) < 0.4, 0, wrong)
            assert earn(sheet, part, left_out) <= written, part.name
    table = make_right_answers(sheet)["table"]
    row, column = rng.integers(4), rng.integers(4)
    table[row][column] += " + 0.7"
    table[rng.integers(4)][rng.integers(4)] += rng.choice([" + pi/2", " + 0.3", ""])
    written = mark_part(sheet, "table", table).credit
    for count in range(1, 4):
        assert mark_part(sheet, "table", table[:count]).credit <= written, table


@each_sheet
def test_extra_digits_never_raise_the_credit(seed):
    """An error of up to half a unit is right with any digits; an error above a unit is wrong."""
    sheet, rng = draw(seed), np.random.default_rng(seed)
    for part in list_number_parts(sheet):
        for size in (0.0, 0.3, 0.49, 1.01, 1.4, 3.0):
            values = part.value + size * part.unit * rng.choice([-1, 1], np.shape(part.value))
            as_asked = earn(sheet, part, values, part.digits)
            assert earn(sheet, part, values) <= as_asked, (part.name, size)
        assert earn(sheet, part, part.value, part.digits) == 1


@each_sheet
def test_wrong_unit_costs_the_same_in_every_topic(seed):
    sheet = draw(seed)
    arm = sheet.sections[0].arm
    slides = ~np.asarray(arm.turning)
    for part in list_number_parts(sheet):
        if part.name in ("p", "centre", "g", "tau"):
            in_other_units = [1000.0]
        elif part.name in ("quarter", "half", "q"):
            in_other_units = [np.where(slides, 1, 180 / np.pi)]
            in_other_units += [np.where(slides, 1000, 1)] if slides.any() else []
        elif part.kind == "jacobian" or part.name == "xi":
            rows = np.r_[np.full(3, 1000.0), np.ones(3)]
            in_other_units = [rows[:, None] if part.kind == "jacobian" else rows]
        else:
            continue
        for factors in in_other_units:
            assert earn(sheet, part, part.value * factors) == MISTAKE_SHARE, part.name
    own = sheet.parts["table"].value
    numbers = np.array([[own.number(entry) for entry in row.entries] for row in own.rows])
    for length, angle in ((1000, 1), (1, 180 / np.pi), (1000, 180 / np.pi)):
        table = as_text(numbers * [length, angle, length, angle], 4)
        for number, row in enumerate(own.rows, 1):
            table[number - 1][3 if row.joint.kind == "revolute" else 2] += f" + q_{number}"
        assert mark_part(sheet, "table", table).credit == MISTAKE_SHARE, table


@each_sheet
def test_rotation_is_marked_by_columns(seed):
    sheet = draw(seed)
    part = sheet.parts["R"]
    column_wrong, row_wrong = part.value.copy(), part.value.copy()
    column_wrong[:, 1] += 0.05
    row_wrong[1] += 0.05
    assert earn(sheet, part, column_wrong) == pytest.approx(MISTAKE_SHARE * 2 / 3)
    assert earn(sheet, part, row_wrong) == 0
