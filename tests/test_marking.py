"""What an answer is worth, and what is said of it: marks of right, slipped and unreadable work."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from helpers import checks, symbolic, variants
from helpers.arm import Arm, ArmError, prismatic, revolute
from helpers.checks.verdict import Report
from helpers.course import marking
from helpers.course.marking import Mark, mark, mark_sheet, prove
from helpers.course.store import Rules
from helpers.robots import ELBOW, PANDA
from helpers.variants import Sheet

HALF_TURNS = Arm(
    "Two joints and a rod",
    (
        revolute(a=0.4, alpha="pi/2", limits=(-1, 2)),
        prismatic(d=0.1, limits=(0.1, 0.5)),
        revolute(a=0.3, limits=(-2, 2)),
    ),
)
HANGING = PANDA.lock(3)
DRAWN = {
    "forward kinematics": {"q": [0.3, 0.9, -0.7]},
    "Jacobian": {"q": [0.3, 0.9, -0.7], "q_dot": [0.5, -1.0, 0.2], "column": 2},
    "inverse kinematics": {"target": [[0.3], [0.2], [0.7]]},
    "DH table": {
        "rows": [
            {"kind": "revolute", "a": 0.3, "alpha": "pi/2", "d": 0.1, "theta": "0"},
            {"kind": "prismatic", "a": 0.2, "alpha": "-pi/2", "d": 0.2, "theta": "pi/2"},
            {"kind": "revolute", "a": 0.4, "alpha": "pi/2", "d": 0.0, "theta": "0"},
            {"kind": "revolute", "a": 0.5, "alpha": "0", "d": 0.3, "theta": "0"},
        ],
        "along": [0.0, 0.05, 0.1, 0.0],
    },
}
ELBOWS = Sheet(ELBOW, DRAWN)
WEIGHED = Sheet(
    HANGING, {"static torque": {"q": [0.4, -0.6, 1.1, 0.8, 1.9, 0.3], "force": [0.0, 0.0, -12.5]}}
)
TARGET = variants.forward_kinematics(HALF_TURNS, [0.5, 0.2, 0.4])[:3, 3]
SLIDER = Sheet(HALF_TURNS, {"inverse kinematics": {"target": TARGET[:, None].tolist()}})


def value(name, sheet=ELBOWS):
    return sheet.parts[name].value


def marked(name, answer, rules=None, sheet=ELBOWS):
    return mark(sheet, sheet.parts[name], answer, rules or Rules())


def plain(name, credit, words, *causes):
    return Mark(name, credit, words, words, causes)


def nudged(name, by):
    """The right numbers of a part, the first off by so much."""
    found = np.array(value(name))
    found.flat[0] += by
    return found.tolist()


@pytest.mark.parametrize(
    ("name", "answer", "rules", "expected"),
    [
        ("p", None, {}, (0.0, "Not answered.")),
        ("p", "", {}, (0.0, "Not answered.")),
        ("p", [], {}, (0.0, "Not answered.")),
        ("p", lambda p: p.tolist(), {}, (1.0, "Right.")),
        ("p", lambda p: p[:, None].tolist(), {}, (1.0, "Right.")),
        ("p", lambda p: [f"{x:.2f}" for x in np.add(p, [0.002, 0, 0])], {"digits": 0.7},
         (0.7, "Right as far as it goes: give more digits.")),
        ("p", lambda p: [f"{x:.1f}" for x in np.add(np.round(p, 1), [0.1, 0, 0])], {}, None),
        ("p", lambda p: nudged("p", 9e-4), {}, (1.0, "Right.")),
        ("p", lambda p: nudged("p", 11e-4), {},
         (0.0, "Not right: 1 of 3 entries are off, by up to 0.0011.")),
        ("R", lambda R: nudged("R", 0.25), {},
         (0.0, "Not right: 1 of 9 entries are off, by up to 0.25.")),
        ("p", lambda p: p[:2].tolist(), {}, (0.0, "It has shape (2,); expected (3,).")),
        ("p", lambda p: (1000 * p + 0.9).tolist(), {},
         (0.0, "Right in millimetres; metres were asked.", "numbers.millimetres")),
        ("p", lambda p: (1000 * p).tolist(), {"causes": {"numbers.millimetres": 0.6}},
         (0.6, "Right in millimetres; metres were asked.", "numbers.millimetres")),
        ("xi", lambda xi: np.degrees(xi).tolist(), {"causes": {"numbers.degrees": 0.25}},
         (0.25, "Right in degrees; radians were asked.", "numbers.degrees")),
        ("p", lambda p: (-p).tolist(), {},
         (0.0, "Every sign is the other way round.", "numbers.sign")),
        ("R", lambda R: R.T.tolist(), {},
         (0.0, "It is the transpose of what was asked.", "numbers.transposed")),
        ("p", "a" * 8001, {}, (0.0, "Not read: it has more than 8000 entries or characters.")),
        ("J_column", ["1", "2"], {}, (0.0, "Expected a list of six formulas.")),
        ("J_column", "q_1", {}, (0.0, "Expected a list of six formulas.")),
    ],
)  # fmt: skip
def test_numbers_are_right_or_their_mistake_is_named(name, answer, rules, expected):
    found = marked(name, answer(value(name)) if callable(answer) else answer, Rules(**rules))
    if expected is None:
        assert found.headline.startswith("Not right: 1 of 3 entries are off, by up to 0.")
        return
    credit, words, *causes = expected
    assert found == plain(name, credit, words, *causes)


def test_a_reader_that_breaks_costs_its_own_part(monkeypatch):
    def broken(*_):
        raise RecursionError

    monkeypatch.setitem(marking._KINDS, "numbers", broken)
    words = "Not read (RecursionError): write numbers or formulas as on the sheet."
    assert marked("p", [1, 2, 3]) == plain("p", 0.0, words)


@pytest.mark.parametrize(
    ("answer", "size"),
    [
        ("abc", 3), ("", 0), (5, 1), (None, 1), ([1, "ab"], 4), ((), 1), ({"a": "xyz", "b": 1}, 5),
        (np.zeros((3, 4)), 12), ([[[[["ab"]]]]], 7), ([[[[[["ab"]]]]]], 8006),
        ("a" * 8000, 8000), ([{"a": [1]}], 4),
    ],
)  # fmt: skip
def test_how_much_there_is_to_read(answer, size):
    assert marking._size(answer) == size


def test_as_much_as_8000_is_read_and_what_the_reader_says_is_said():
    found = marked("p", "a" * 8000)
    assert found.credit == 0
    assert found.words == found.headline
    assert found.words.startswith("Not read: there is no value for aaa")


def columned(formulas):
    """The Jacobian of the elbow arm with other formulas in its second column."""
    J = symbolic.jacobian(ELBOW).tolist()
    return [[r[0], formula, r[2]] for r, formula in zip(J, formulas, strict=True)]


def pushed(force):
    return {"arm": HANGING, "q": WEIGHED.drawn["static torque"]["q"], "wrench": [*force, 0, 0, 0]}


# Answers that the checkers judge: sheet, part, answer, credit, and the same checker's report, with
# the sheet's tolerance (2e-3 and so on) where that lets it pass.


def jacobians():
    q, J = DRAWN["Jacobian"]["q"], value("J")
    rounded, halved = J.round(3), np.r_[J[3:], J[:3]]
    for answer, credit, how in (
        (J.tolist(), 1.0, {"tolerance": 2e-3}),
        ((J + 1.9e-3).tolist(), 1.0, {"tolerance": 2e-3}),
        (rounded.tolist(), 1.0, {"tolerance": 2e-3}),
        (J.round(1).tolist(), 0.9, {}),
        (halved.tolist(), 0.0, {}),
    ):
        yield ELBOWS, "J", answer, credit, checks.compare_jacobian(answer, ELBOW, q, **how)


def columns():
    six = value("J_column")
    for answer, credit in ((six, 1.0), ([*six[:5], "7"], 0.0), ([*six[:2], "-a_3", *six[3:]], 0.0)):
        yield ELBOWS, "J_column", answer, credit, checks.compare_jacobian(columned(answer), ELBOW)
    in_rows = [[formula] for formula in six]
    yield ELBOWS, "J_column", in_rows, 1.0, checks.compare_jacobian(columned(six), ELBOW)


def torques():
    for name, force in (("g", [0, 0, 0]), ("tau", [0, 0, -12.5])):
        tau = value(name, WEIGHED)
        for answer, credit, how in (
            (tau.tolist(), 1.0, {"tolerance": 5e-3}),
            ((tau + 4.9e-3).tolist(), 1.0, {"tolerance": 5e-3}),
            ((-tau).tolist(), 1 / 6, {}),  # the upright joint carries nothing
            ([*tau[:4], tau[4] + 1, tau[5] - 1], 4 / 6, {}),
        ):
            report = checks.compare_torques(answer, **pushed(force), **how)
            yield WEIGHED, name, answer, credit, report


def tables():
    drawn = value("table")
    rows = [[str(entry) for entry in row.entries] for row in drawn.rows]
    same = replace(drawn, name="the answer")
    right = checks.compare_tables(same, drawn, tolerance=5e-4)
    yield ELBOWS, "table", rows, 1.0, right
    slipped = [rows[0], rows[1], ["0.45", *rows[2][1:]], rows[3]]
    other = Arm("the answer", (*drawn.rows[:2], revolute(0.45, "pi/2", "0.0", "0"), drawn.rows[3]))
    yield ELBOWS, "table", slipped, 0.0, checks.compare_tables(other, drawn)
    degrees = {"0": "0", "pi/2": "90", "-pi/2": "-90"}  # the sheet asks for radians
    typed = [[a, degrees[alpha], d, degrees[theta]] for a, alpha, d, theta in rows]
    turned = [
        replace(row, alpha=e[1], theta=e[3]) for row, e in zip(drawn.rows, typed, strict=True)
    ]
    other = Arm("the answer", tuple(turned))
    yield ELBOWS, "table", typed, 0.0, checks.compare_tables(other, drawn)


def branches():
    four = value("q")
    known = variants.closed_form(ELBOW)(ELBOW, np.array([0.3, 0.2, 0.7]))
    for answer, credit, how in (
        (four.tolist(), 1.0, {"tolerance": 1e-2}),
        (four[:2].tolist(), 0.5, {}),
        (four[1:].tolist(), 0.75, {}),
        (np.add(four, [[0.3], [0], [0], [0]]).tolist(), 0.75, {}),
    ):
        yield ELBOWS, "q", answer, credit, checks.compare_branches(answer, known, **how)


def poses():
    one = value("q", SLIDER)
    for answer, credit, how in (
        (one.tolist(), 1.0, {"tolerance": 1e-2}),
        ((one + 0.05).tolist(), 0.0, {}),
    ):
        yield SLIDER, "q", answer, credit, checks.compare_pose(answer, HALF_TURNS, TARGET, **how)


@pytest.mark.parametrize("cases", [jacobians, columns, torques, tables, branches, poses])
def test_the_checkers_words_stand_in_the_mark(cases):
    for sheet, name, answer, credit, report in cases():
        found = marked(name, answer, None, sheet)
        assert found.credit == pytest.approx(credit), (name, answer)
        assert (found.part, found.headline, found.words) == (name, report.headline, str(report))
        assert found.causes == (() if credit == 1 else report.causes)


@pytest.mark.parametrize(
    ("report", "rules", "credit"),
    [
        ({"grade": "right"}, {}, 0.9),
        ({"grade": "rounded", "figures": {"right": 1, "of": 2}}, {"digits": 0.3}, 0.3),
        ({"grade": "so far"}, {"digits": 0.3}, 0.3),
        ({"grade": "so far", "figures": {"right": 0, "of": 4}}, {}, 0.9),
        ({"grade": "so far", "figures": {"right": 3, "of": 4}}, {"columns": 0.1}, 0.75),
        ({"figures": {"right": 3, "of": 4}}, {}, 0.75),
        ({"figures": {"right": 3, "of": 4}}, {"columns": 0.5}, 0.375),
        ({"figures": {"right": 2}}, {"columns": 0.5}, 1.0),
        ({"figures": {"of": 2}}, {}, 0.0),
        ({"figures": {"right": 0, "of": 0}}, {}, 0.0),
        ({}, {}, 0.0),
        ({"causes": ("a",)}, {"causes": {"b": 0.5}}, 0.0),
        ({"causes": ("a", "b")}, {"causes": {"a": 0.2, "b": 0.5}}, 0.2),
        ({"causes": ("a", "b")}, {"causes": {"b": 0.5}}, 0.5),
        ({"causes": ("a:1:x + b:2",)}, {"causes": {"a + b": 0.4}}, 0.4),
        ({"causes": ("a:1 + b:2",)}, {"causes": {"a + b": 0.4, "a:1 + b:2": 0.3}}, 0.3),
        ({"causes": ("a",), "figures": {"right": 3, "of": 4}}, {"causes": {"a": 0.2}}, 0.75),
    ],
)  # fmt: skip
def test_what_a_report_is_worth(report, rules, credit):
    found = Report("pose", "an arm", **{"grade": "wrong", "headline": "", **report})
    assert marking._credit(found, Rules(**rules)) == pytest.approx(credit)


@pytest.mark.parametrize(
    ("answer", "credit", "words"),
    [
        (lambda q, turn: np.add(q, [turn, 0, 0]), 1, None),
        (lambda q, turn: q - [turn, 0, 0], 1, None),
        (lambda q, turn: np.add(q, [3 * turn, 0, -3 * turn]), 1, None),
        (lambda q, turn: q - [3 * turn, 0, -3 * turn], 1, None),
        (
            lambda q, turn: np.add(q, [4 * turn, 0, 0]),
            0,
            "q_1 = 25.63 lies beyond its limits, -1 to 2.",
        ),
        (lambda q, turn: q - [0, 0, 4 * turn], 0, "q_3 = -24.73 lies beyond its limits, -2 to 2."),
    ],
)
def test_joint_values_count_within_the_limits_whole_turns_aside(answer, credit, words):
    found = marked("q", answer(np.array([0.5, 0.2, 0.4]), 2 * np.pi).tolist(), None, SLIDER)
    assert found.credit == credit
    assert words is None or found == plain("q", 0.0, words)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ([[0.1, 0.1, 0.1]], ""),
        ([[-1.0, 0.5, 2.0]], ""),
        ([[2 + 1e-10, 0.1 - 1e-10, -2 - 1e-10]], ""),
        ([[2 + 1e-8, 0.2, 0]], "q_1 = 2 lies beyond its limits, -1 to 2."),
        ([[0, 0.2, 0], [0, 0.1 - 1e-8, 0]], "q_2 = 0.1 lies beyond its limits, 0.1 to 0.5."),
        ([[0, 0.2 + 2 * np.pi, 0]], "q_2 = 6.483 lies beyond its limits, 0.1 to 0.5."),
        ([[0, 9]], ""),
    ],
)
def test_the_first_joint_value_beyond_its_limits_is_told(rows, words):
    assert marking._beyond_limits(HALF_TURNS, rows) == words


@pytest.mark.parametrize("count", [3, 5])
def test_a_table_of_another_shape_is_not_filled_up_from_the_key(count):
    rows = marking.rounded(ELBOWS.parts["table"])
    other = [*rows, rows[3]][:count]
    found = marked("table", other)
    assert (found.credit, found.words) == (0, str(checks.compare_tables(other, value("table"))))
    other = [[*entries, "0"][:count] for entries in rows]
    with pytest.raises(ArmError) as told:
        checks.compare_tables(other, value("table"))
    assert marked("table", other) == plain("table", 0.0, f"Not read: {told.value}")


def test_a_wrong_or_a_named_answer_keeps_its_own_words():
    far = [0.5, 9.0, 0.4]  # beyond the limits, and wrong
    found = marked("q", far, Rules(columns=0), SLIDER)
    assert "limits" not in found.headline or found.words != found.headline
    named = Mark("q", 0.5, "h", "w", ("a",))
    assert marking._within_limits(HALF_TURNS, SLIDER.parts["q"], far, named) is named
    assert marking._within_limits(
        HALF_TURNS, SLIDER.parts["q"], far, replace(named, causes=())
    ) == plain("q", 0.0, "q_2 = 9 lies beyond its limits, 0.1 to 0.5.")


def test_every_part_is_marked_in_the_sheets_order():
    found = mark_sheet(ELBOWS, {"R": value("R").tolist(), "zz": 1}, Rules())
    assert [m.part for m in found] == ["p", "R", "J", "xi", "J_column", "q", "table"]
    assert [m.credit for m in found] == [0, 1, 0, 0, 0, 0, 0]


def at(arm, topic, **given):
    return Sheet(arm, {topic: given}).questions[0]


def hidden(question):
    return {part.name: marking.unseen(question, part) for part in question.parts}


def test_a_pose_that_hides_a_mistake_is_found_and_one_that_every_pose_hides_is_none():
    q = [0.4, -0.6, 1.1, 0.8, 1.9, 0.3]
    seen = hidden(at(HANGING, "static torque", q=q, force=[0.0, 0.0, -12.5]))
    weightless = hidden(at(HANGING, "static torque", q=q, force=[0.0, 0.0, 0.0]))
    # The first joint is upright, so its link weighs on none; where the tip is tells a force only.
    assert seen == {"g": {"tau.mass missing:1", "table.pen"}, "tau": {"tau.mass missing:1"}}
    assert weightless == {"g": seen["g"], "tau": seen["g"]}
    home = at(ELBOW, "Jacobian", q=[0.0, 0.0, 0.0], q_dot=[0.0, 0.0, 0.0], column=1)
    generic = at(ELBOW, "Jacobian", q=[0.37, 0.6, 0.83], q_dot=[0.0, 0.0, 0.0], column=1)
    always = hidden(generic)["J"]
    assert {"table.sign:d:1", "table.missing:d:1"} <= always  # the elbow's d is 0
    assert hidden(generic) == {"J": always, "xi": set(), "J_column": set()}
    assert hidden(home) == {**hidden(generic), "J": always | {"J.degrees"}}  # no angle, no unit
    assert marking._generic(home).given["q"] == pytest.approx([0.37, 0.6, 0.83])
    assert marking._generic(home).given["column"] == 1


def test_what_is_proved_is_that_its_key_is_right_and_that_it_shows_the_mistakes():
    prove(ELBOWS)
    prove(WEIGHED)
    flat = Sheet(ELBOW, {"Jacobian": {"q": [0.0] * 3, "q_dot": [0.1] * 3, "column": 1}})
    with pytest.raises(ArmError) as told:
        prove(flat)
    assert str(told.value) == "`J` cannot be marked: it does not show J.degrees"
    key = replace(value_of := ELBOWS.parts["p"], value=value_of.value + 1)
    question = replace(ELBOWS.questions[0], parts=(key,))
    wrong = SimpleNamespace(parts={"p": key}, questions=[replace(question, parts=())])
    with pytest.raises(StopIteration):
        prove(wrong)
    tight = replace(key, tolerance=1e-9)
    wrong = SimpleNamespace(parts={"p": tight}, questions=[replace(question, parts=(tight,))])
    with pytest.raises(ArmError) as told:
        prove(wrong)
    said = "'Right as far as it goes: give more digits.'"
    assert str(told.value) == f"`p` cannot be marked: its own key is judged {said}"


def test_a_key_is_written_as_a_student_writes_it():
    drawn = marking.rounded(ELBOWS.parts["table"])
    assert drawn[1] == ["0.2", "-pi/2", "0.2", "pi/2"]
    assert marking.rounded(ELBOWS.parts["J_column"])[3:] == ["sin(q_1)", "-cos(q_1)", "0"]
    p = marking.rounded(ELBOWS.parts["p"])
    assert p == [0.5184, 0.1604, 0.8729]
