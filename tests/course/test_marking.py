"""Test the credit of answers for several arms, topics and mistakes."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from course import marking
from course.making import make_right_answers
from course.marking import MISTAKE_SHARE, mark_part, mark_sheet
from course.sheets import Section, Sheet, draw_sheet
from course.topics import make_camera_arm
from helpers.arm import Arm, prismatic, revolute
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E
from tests.course.parts import as_text, list_measured_parts, mark_text

RODS = Arm(
    "Two joints and a rod",
    (
        revolute(a=0.4, alpha="pi/2", limits=(-1, 2)),
        prismatic(d=0.1, limits=(0.1, 0.5)),
        revolute(a=0.3, limits=(-2, 2)),
    ),
)
HANGING = PANDA.lock(3)
TARGET = {"target": [[0.3], [0.2], [0.7]], "solution": [0, 0, 0]}
TABLE_ROWS = [
    {"kind": "revolute", "a": 0.3, "alpha": "pi/2", "d": 0.1, "theta": "0"},
    {"kind": "prismatic", "a": 0.2, "alpha": "-pi/2", "d": 0.2, "theta": "pi/2"},
    {"kind": "revolute", "a": 0.4, "alpha": "pi/2", "d": 0.0, "theta": "0"},
    {"kind": "revolute", "a": 0.5, "alpha": "0", "d": 0.3, "theta": "0"},
]
NUMBERS = {
    "forward kinematics": {"q": [0.3, 0.9, -0.7]},
    "Jacobian": {
        "q": [0.3, 0.9, -0.7],
        "q_dot": [0.5, -1.0, 0.2],
        "column": 2,
        "link": 3,
        "camera": [0.05, -0.1],
        "configurations": [[0.31, 0.92, -0.73], [1.1, -0.4, 0.6]],
    },
    "inverse kinematics": TARGET,
    "DH table": {"rows": TABLE_ROWS, "along": [0.0, 0.05, 0.1, 0.0]},
}
ELBOWS = Sheet((Section(ELBOW, NUMBERS),))
ONE_SOLUTION = [0.5, 0.2, 0.4]
SLIDER = Sheet(
    (
        Section(
            RODS,
            {
                "inverse kinematics": {
                    "target": forward_kinematics(RODS, ONE_SOLUTION)[:3, 3:].tolist(),
                    "solution": ONE_SOLUTION,
                }
            },
        ),
    )
)
laws = pytest.mark.parametrize("arm", [ELBOW, HANGING, STANFORD, RODS], ids=lambda arm: arm.name)


@cache
def get_sheet(arm):
    """Draw the sheet of an arm, or return it from a cache."""
    return draw_sheet(arm, "law 0")


def get_value(name, own=ELBOWS):
    return own.parts[name].value


def mark(name, answer, own=ELBOWS):
    return mark_part(own, name, answer).credit


@laws
def test_right_answer_in_asked_digits_earns_full_credit(arm):
    own = get_sheet(arm)
    for part in list_measured_parts(own):
        assert f"`{part.name}`: {part.description}; {part.digits} decimals; " in "\n".join(
            question.markdown for question in own.questions
        )
        cut = np.trunc(part.value * 10**part.digits) / 10**part.digits
        for numbers, digits in ((part.value, part.digits), (part.value, 8), (cut, part.digits)):
            assert mark_text(own, part, numbers, digits).message == "Right."
    assert all(mark.credit == 1 for mark in mark_sheet(own, make_right_answers(own)))


@laws
def test_every_named_mistake_earns_the_same_credit(arm):
    """An answer that only copies numbers of the question earns nothing."""
    own = get_sheet(arm)
    for part in list_measured_parts(own):
        for mistake in part.mistakes:
            mark = mark_text(own, part, mistake.values, 6)
            is_copied = np.abs(mistake.values - part.baseline).max() <= part.unit
            assert mark.credit == (0 if is_copied else MISTAKE_SHARE), (part.name, mistake.name)
            assert is_copied or mistake.name in mark.mistakes


@laws
def test_too_few_digits_earn_credit_only_for_right_numbers(arm):
    own, rng = get_sheet(arm), np.random.default_rng(1)
    for digits in (0, 1, 2):
        for part in list_measured_parts(own):
            if digits >= part.digits:
                continue
            for size in rng.uniform(0.003, 0.1, 5):
                wrong = part.value * (1 + size * rng.choice([-1, 1], np.shape(part.value)))
                earned = mark_text(own, part, wrong, digits).credit
                is_right = np.abs(np.round(wrong, digits) - part.value) <= part.unit
                is_right &= np.abs(part.value - part.baseline) > part.unit
                assert earned == 0 if not is_right.any() else earned < 1


@laws
def test_wrong_additional_numbers_never_raise_the_credit(arm):
    own, rng = get_sheet(arm), np.random.default_rng(4)
    for part in list_measured_parts(own):
        some = np.where(rng.random(np.shape(part.value)) < 0.5, part.value, 0)
        more = np.where(some == part.value, some, rng.uniform(20, 30, np.shape(part.value)))
        assert mark_text(own, part, more, 6).credit <= mark_text(own, part, some, 6).credit


NOTHING = [
    None, "", " ", [], [[]], {}, [[], []], "...", "[]", [None] * 6, ["..."] * 6, "0", 0, False * 1,
    {"a": None}, "0.000", [["0"] * 4] * 4, "[0, 0, 0]", float("nan"), [float("inf")] * 6, True,
]  # fmt: skip


def list_guesses(right, question):
    """List answers that need no work, in the right shape and in other shapes."""
    shape = np.shape(right)
    for x in (1, -1, 0.5, 1e5, 1e22, "1e9"):
        yield np.full(shape, x).tolist()
    yield np.eye(*(*shape, 1, 1)[:2]).reshape(*shape, -1).squeeze().tolist()
    for key in ("q", "q_dot", "force", "target"):
        yield question.numbers.get(key)
    yield list(question.arm.values.values())
    yield list(question.arm.home)


@pytest.mark.parametrize("arm", [HANGING, RODS], ids=str)
def test_guesses_without_work_earn_nothing(arm):
    own = get_sheet(arm)
    right = make_right_answers(own)
    kinds = set()
    for question in own.questions:
        for part in question.parts:
            nothing = [] if part.kind in kinds else NOTHING
            kinds.add(part.kind)
            for guess in [*nothing, *list_guesses(right[part.name], question)]:
                assert mark(part.name, guess, own) == 0, (part.name, guess)
    assert mark("tau", as_text(own.parts["g"].value, 4), own) == 0 if arm is HANGING else True


@pytest.mark.parametrize(
    ("name", "change", "expected", "message"),
    [
        ("p", lambda p: p.tolist(), 1, "Right."),
        ("p", lambda p: p[:, None].tolist(), 1, "Right."),
        ("p", lambda p: {"x": p[0], "y": p[1], "z": p[2]}, 1, "Right."),
        ("p", lambda p: ", ".join(f"{1000 * x:.1f} mm" for x in p), 1, "Right."),
        ("p", lambda p: [f"{1000 * x:.1f} mm" for x in p], 1, "Right."),
        ("p", lambda p: [f"{x:.4f}".replace(".", ",") for x in p], 1, "Right."),
        ("p", lambda p: "; ".join(f"{x:.4f}".replace(".", ",") for x in p), 1, "Right."),
        ("p", lambda p: [*p[:2], p[2] + 0.0009], 1, "Right."),
        ("p", lambda p: [*p[:2], p[2] + 0.0021], 1 / 3, "Not right: number 3."),
        ("p", lambda p: [*p[:2].round(5), f"{p[2]:.1f}"], 1 / 3, "Too few decimals: 3 were asked"),
        ("p", lambda p: (1000 * p).tolist(), 0.5, "millimetres"),
        ("p", lambda p: p[:2].tolist(), 0, "Not read: 2 numbers given, expected 3; write 0 for"),
        ("p", lambda p: "a" * 8001, 0, "Not read: it has more than 8000 characters."),
        ("p", lambda p: ["x", 1, 2], 0, "Not read: x has no value"),
        ("R", lambda R: R.T.tolist(), 0.5, "transposed"),
        ("J", lambda J: J[:3].tolist(), 0.5, "The angular rows are zero"),
        ("J", lambda J: J[3:].tolist(), 0.5, "The linear rows are zero"),
    ],
)  # fmt: skip
def test_numbers_are_read_as_students_write_them(name, change, expected, message):
    mark = mark_part(ELBOWS, name, change(get_value(name)))
    assert mark.credit == pytest.approx(expected)
    assert message in mark.message


SIX = ELBOWS.parts["J_column"].formulas


@pytest.mark.parametrize(
    ("answer", "expected", "message"),
    [
        (list(SIX), 1, "Right."),
        ([[x] for x in SIX], 1, "Right."),
        ("[" + ", ".join(SIX) + "]", 1, "Right."),
        ("\n".join(SIX), 1, "Right."),
        (SIX[:5], 0, "expected"),
        ([*SIX[:3], "0", "0", "0"], 0.5, "Not right: the angular half."),
        (["0", "0", "0", *SIX[3:]], 0.5, "Not right: the linear half."),
        ([*SIX[:5], "7"], 0.5, "Not right: the angular half."),
        (["1"] * 6, 0, "Not right"),
        (["__import__('os')", *SIX[1:]], 0, "Not read"),
        ("9**9**9**9", 0, "Not read"),
    ],
)
def test_formulas_are_judged_at_secret_configurations(answer, expected, message):
    mark = mark_part(ELBOWS, "J_column", list(answer) if isinstance(answer, tuple) else answer)
    assert mark.credit == expected
    assert message in mark.message


def test_constants_for_joints_are_wrong():
    """The answer has six numbers that are right at the configuration of the sheet."""
    question = ELBOWS.questions[1]
    camera = make_camera_arm(ELBOW, question.numbers)
    numbers = jacobian(camera, question.numbers["q"])[:, question.numbers["column"] - 1]
    assert mark("J_column", [f"{x:.6f}" for x in numbers]) < 0.5


TABLE = make_right_answers(ELBOWS)["table"]
# The same arm with z_1 reversed: alpha_1, d_2, alpha_2 and q_2 change sign.
OTHER_FRAMES = [
    ["0.3", "-pi/2", "0.1", "q_1"], ["0.2", "pi/2", "-q_2 - 0.2", "-pi/2"], *TABLE[2:],
]  # fmt: skip


@pytest.mark.parametrize("frames", [TABLE, OTHER_FRAMES], ids=["key", "other frames"])
@pytest.mark.parametrize(
    ("row", "column", "entry"),
    [(0, 0, "0.45"), (2, 1, "-pi/2"), (3, 2, "0"), (2, 0, "0"), (3, 0, "-0.5")],
)
def test_table_mistake_costs_the_same_for_any_choice_of_frames(frames, row, column, entry):
    assert mark("table", frames) == 1
    table = [list(entries) for entries in frames]
    table[row][column] = entry
    assert mark("table", table) == MISTAKE_SHARE


def test_table_of_wrong_shape_earns_nothing():
    for other in ([row[:3] for row in TABLE], "a b"):
        assert mark("table", other) == 0


def test_extra_row_costs_as_much_as_a_wrong_row():
    assert mark("table", [*TABLE, TABLE[3]]) == mark("table", TABLE[:3])


def test_first_rows_of_a_table_earn_half_their_share():
    assert mark("table", TABLE[:3]) == MISTAKE_SHARE * 3 / 4


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        (lambda four: four, 1),
        (lambda four: four + 2 * np.pi, 1),
        (lambda four: four[::-1], 1),
        (lambda four: four[:2], 0.5),
        (lambda four: np.add(four, [[0.3], [0], [0], [0]]), 0.75),
        (lambda four: np.r_[four, four[:1] + 0.3], 1),
        (lambda four: np.r_[four[:1] + 0.3, four], 0.75),
        (lambda four: np.r_[four[:1], four[:1], four[1:]], 0.75),
        (lambda four: four.round(1), 0),
    ],
)
def test_each_right_branch_earns_its_share(change, expected):
    assert mark("q", change(get_value("q")).tolist()) == expected


def test_branches_with_too_few_digits_are_reported():
    mark = mark_part(ELBOWS, "q", as_text(get_value("q"), 2))
    assert "Too few decimals: 3 were asked." in mark.message
    assert mark.mistakes == ()


@pytest.mark.parametrize("turns", [[1, 0, 0], [-1, 0, 0], [3, 0, -3], [40, 0, 0]])
def test_whole_turns_are_ignored(turns):
    q = np.array(ONE_SOLUTION) + 2 * np.pi * np.array(turns)
    assert mark("q", q.tolist(), SLIDER) == 1
    assert mark("q", (q + 0.02).tolist(), SLIDER) == 0


def test_branches_beyond_limits_are_not_required():
    rows = [replace(row, joint=replace(row.joint, lower=-2, upper=2)) for row in ELBOW.rows]
    limited = Section(replace(ELBOW, rows=rows), {"inverse kinematics": TARGET})
    near = Sheet((limited,))
    two, four = get_value("q", near), get_value("q")
    assert (len(two), len(four)) == (2, 4)
    assert "There are 2; of more rows the first 2 count." in near.questions[0].text
    assert mark("q", two.tolist(), near) == 1


def test_crash_while_marking_affects_only_that_part(monkeypatch):
    def fail(*_):
        raise RecursionError

    monkeypatch.setattr(marking, "_mark_numbers", fail)
    message = "Not read (RecursionError): write numbers or formulas as on the sheet."
    marks = {mark.part: mark.message for mark in mark_sheet(ELBOWS, {"p": [1, 2, 3]})}
    assert (marks["p"], marks["R"]) == (message, "Not answered.")


NUMBER = re.compile(r"\d+[.,]\d+")


@laws
def test_hints_show_no_number_and_no_right_entry(arm):
    own = get_sheet(arm)
    right = make_right_answers(own)
    for name, part in own.parts.items():
        answers = [right[name]]
        if part in list_measured_parts(own):
            answers.append(as_text(part.value * 1.07, 4))
        answers += [[["1"] * 4] * 4, [[4] * 6] * 6]
        for answer in answers:
            hint = mark_part(own, name, answer).hint
            assert "Right" not in hint
            assert not NUMBER.search(hint.replace("8000", "")), hint


def test_hint_does_not_reveal_the_wrong_entry_of_a_table():
    right = make_right_answers(ELBOWS)["table"]
    wrong = [[str(float(right[0][0]) + 0.1), *right[0][1:]], *right[1:]]
    hints = [mark_part(ELBOWS, "table", answer).hint for answer in (right, wrong)]
    assert hints[0] == hints[1]


def test_hint_is_the_same_for_right_and_unexplained_answers():
    right = mark_part(ELBOWS, "p", get_value("p").tolist())
    wrong = mark_part(ELBOWS, "p", (get_value("p") + 0.05).tolist())
    assert right.hint == wrong.hint
    assert "millimetres" in mark_part(ELBOWS, "p", (1000 * get_value("p")).tolist()).hint


@pytest.mark.parametrize("arm", [ELBOW, UR10E], ids=lambda arm: arm.name)
def test_random_sheets_have_similar_formula_lengths(arm):
    drawn = [draw_sheet(arm, f"even {n}", ("Jacobian", "inverse kinematics")) for n in range(6)]
    lengths = [len("".join(one.parts["J_column"].formulas)) for one in drawn]
    assert max(lengths) <= 1.6 * min(lengths)  # 1.25 squared, and more
    assert len({len(one.parts["q"].value) for one in drawn}) == 1
