"""What an answer is worth, and what is said of it: right, slipped, unreadable and no work."""

from dataclasses import replace

import numpy as np
import pytest

from helpers import checks
from helpers.arm import Arm, prismatic, revolute
from helpers.course import marking
from helpers.course.making import right_work
from helpers.course.marking import Mark, mark, mark_sheet
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, PANDA, STANFORD
from helpers.variants import Sheet, sheet

RODS = Arm(
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
ONE_WAY = [0.5, 0.2, 0.4]
TARGET = forward_kinematics(RODS, ONE_WAY)[:3, 3]
LIMITED = [replace(row, joint=replace(row.joint, lower=-2, upper=2)) for row in ELBOW.rows]
SLIDER = Sheet(
    RODS, {"inverse kinematics": {"target": TARGET[:, None].tolist(), "one way": ONE_WAY}}
)
TABLE = right_work(ELBOWS)["table"]
SIX = ELBOWS.parts["J_column"].value


def value(name, of=ELBOWS):
    return of.parts[name].value


def marked(name, answer, of=ELBOWS):
    return mark(of, name, answer)


def nudged(name, by):
    found = np.array(value(name))
    found.flat[0] += by
    return found.tolist()


def typed(values, decimals):
    return [f"{x:.{decimals}f}" for x in values]


@pytest.mark.parametrize(
    ("name", "answer", "expected"),
    [
        ("p", lambda p: p.tolist(), (1.0, "Right.")),
        ("p", lambda p: p[:, None].tolist(), (1.0, "Right.")),
        ("p", lambda p: typed(p, 2),
         (0.9, "Right as far as it goes: give more digits.")),
        ("p", lambda p: typed(p, 0),
         (0.0, "Not right: 3 of 3 entries are off, by up to 0.482.")),
        ("p", lambda p: nudged("p", 9e-4), (1.0, "Right.")),
        ("p", lambda p: nudged("p", 11e-4),
         (0.0, "Not right: 1 of 3 entries are off, by up to 0.0011.")),
        ("R", lambda R: nudged("R", 0.25),
         (0.0, "Not right: 1 of 9 entries are off, by up to 0.25.")),
        ("p", lambda p: p[:2].tolist(), (0.0, "It has shape (2,); expected (3,).")),
        ("p", lambda p: (1000 * p + 0.9).tolist(),
         (0.0, "Right in millimetres; metres were asked.", "numbers.millimetres")),
        ("p", lambda p: (1000 * p).tolist(),
         (0.0, "Right in millimetres; metres were asked.", "numbers.millimetres")),
        ("xi", lambda xi: np.degrees(xi).tolist(),
         (0.0, "Right in degrees; radians were asked.", "numbers.degrees")),
        ("p", lambda p: (-p).tolist(),
         (0.0, "Every sign is the other way round.", "numbers.sign")),
        ("R", lambda R: R.T.tolist(),
         (0.0, "It is the transpose of what was asked.", "numbers.transposed")),
        ("p", lambda p: "a" * 8001, (0.0, "Not read: it has more than 8000 characters.")),
        ("J_column", lambda six: six[:5], (0.0, "Expected a list of six formulas.")),
        ("J_column", lambda six: "q_1", (0.0, "Expected a list of six formulas.")),
    ],
)  # fmt: skip
def test_numbers_are_right_or_their_mistake_is_named(name, answer, expected):
    credit, words, *causes = expected
    assert marked(name, answer(value(name))) == Mark(name, credit, words, words, (*causes,))


def test_a_reader_that_breaks_costs_its_own_part(monkeypatch):
    def broken(*_):
        raise RecursionError

    monkeypatch.setattr(marking, "_numbers", broken)
    words = "Not read (RecursionError): write numbers or formulas as on the sheet."
    assert [m.words for m in mark_sheet(ELBOWS, {"p": [1, 2, 3]})][:2] == [
        words, "Not answered.",
    ]  # fmt: skip


NOTHING = [
    None, "", " ", [], [[]], {}, [[], []], "...", "[]", [None] * 6, ["..."] * 6, "0", 0, False * 1,
    {"a": None}, "0.000", [["0"] * 4] * 4, "[0, 0, 0]", float("nan"), [float("inf")] * 6, True,
]  # fmt: skip


def guesses(right, question):
    """Answers that need no work, in the shape of the right one and in others."""
    shape = np.shape(right)
    same = [1, -1, 0.5, 1e5, 1e6, 1e9, 1e22, "1e9", "1e5"]
    yield from (np.full(shape, x).tolist() for x in same)
    yield (
        np.eye(*(*shape, 1, 1)[:2]).reshape(*shape, -1).squeeze().tolist() if len(shape) < 3 else 0
    )
    for key in ("q", "q_dot", "force", "target"):
        yield question.given.get(key)
    yield list(question.arm.values.values())
    yield list(question.arm.home)


@pytest.mark.parametrize(
    ("arm", "topics"),
    [(HANGING, ("static torque", "circle tracing")), (STANFORD, None), (RODS, None)],
    ids=str,
)
def test_no_work_earns_no_marks(arm, topics):
    """These three have every topic, and every kind of part."""
    mine = sheet(arm, "no work", topics)
    for nothing in NOTHING:
        found = mark_sheet(mine, dict.fromkeys(mine.parts, nothing))
        assert sum(m.credit for m in found) == 0, nothing
    for question in mine.questions:
        for part in question.parts:
            for guess in guesses(right_work(mine)[part.name], question):
                found = mark(mine, part.name, guess)
                assert found.credit == 0, (part.name, guess, found)


ONE_WRONG = np.eye(6, 3, k=-1) * [0, 0, 0.3]
SLIPPED = [*TABLE[:2], ["0.45", *TABLE[2][1:]], TABLE[3]]
JUDGED = [
    (ELBOWS, "J", lambda J: J, 1),
    (ELBOWS, "J", lambda J: J + 1.9e-3, 1),
    (ELBOWS, "J", lambda J: J.round(3), 1),
    (ELBOWS, "J", lambda J: J.round(2), 0.9),
    (ELBOWS, "J", lambda J: J + ONE_WRONG, 2 / 3),
    (ELBOWS, "J", lambda J: np.r_[J[3:], J[:3]], 0),
    *((WEIGHED, name, *case) for name in ("g", "tau") for case in (
        (lambda tau: tau, 1),
        (lambda tau: tau + 4.9e-3, 1),
        (lambda tau: -tau, 0),
        # The upright joint carries nothing, and counts for nothing.
        (lambda tau: np.add(tau, [0, 0, 0, 0, 1, -1]), 3 / 5),
    )),
    (ELBOWS, "table", lambda _: np.array(TABLE), 1),
    (ELBOWS, "table", lambda _: np.array(SLIPPED), 0),
    (ELBOWS, "q", lambda four: four, 1),
    (ELBOWS, "q", lambda four: four + 2 * np.pi, 1),
    (ELBOWS, "q", lambda four: four[:2], 0.5),
    (ELBOWS, "q", lambda four: four[1:], 0.75),
    (ELBOWS, "q", lambda four: np.add(four, [[0.3], [0], [0], [0]]), 0.75),
    (ELBOWS, "q", lambda four: np.r_[four, four[:1] + 0.3], 4 / 5),
    (SLIDER, "q", lambda one: one, 1),
    (SLIDER, "q", lambda one: one + 0.05, 0),
]  # fmt: skip


@pytest.mark.parametrize(("of", "name", "change", "credit"), JUDGED)
def test_the_checkers_words_stand_in_the_mark(of, name, change, credit, monkeypatch):
    """Those of the last report: by the sheet's tolerance where that lets the answer pass, else by
    its digits."""
    reports = []
    for question in ("tables", "jacobian", "torques", "branches", "pose"):
        compare = getattr(checks, f"compare_{question}")

        def noted(*asked, compare=compare, **how):
            reports.append((how["tolerance"], compare(*asked, **how)))
            return reports[-1][1]

        monkeypatch.setattr(checks, f"compare_{question}", noted)
    found = marked(name, change(value(name, of)).tolist(), of)
    assert found.credit == pytest.approx(credit)
    tolerance, report = reports[-1]
    assert tolerance == (of.parts[name].tolerance if credit == 1 else None)
    assert (found.part, found.headline, found.words) == (name, report.headline, str(report))
    assert found.causes == (() if credit == 1 else report.causes)


def test_a_column_is_six_formulas_each_by_itself_or_in_a_row_of_its_own():
    for answer, credit in ((SIX, 1), ([[x] for x in SIX], 1), ([*SIX[:5], "7"], 0), (["1"] * 6, 0)):
        assert marked("J_column", answer).credit == credit


def test_a_table_of_another_shape_is_not_filled_up_from_the_key():
    for other in (TABLE[:3], [*TABLE, TABLE[3]], [row[:3] for row in TABLE], "a b"):
        assert marked("table", other).credit == 0


J = np.array(value("J"))
ANGULAR = np.r_[1, 1, 1, -1, -1, -1][:, None]
PLANTED = [
    ("J", np.r_[J[3:], J[:3]], "J.halves"), ("J", -J, "J.all signs"),
    ("J", J * [1, -1, 1], "J.column sign:2"), ("J", J * ANGULAR, "J.angular sign"),
    ("p", 1000 * value("p"), "numbers.millimetres"), ("R", value("R").T, "numbers.transposed"),
    ("q", np.degrees(value("q")).round(2), "ik.degrees"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("name", "answer", "cause"), PLANTED, ids=lambda x: x if isinstance(x, str) else ""
)
def test_a_planted_mistake_is_named(name, answer, cause):
    found = marked(name, answer.tolist())
    assert found.credit < 1
    assert found.causes[0] == cause


@pytest.mark.parametrize("turns", [[1, 0, 0], [-1, 0, 0], [3, 0, -3], [40, 0, 0]])
def test_whole_turns_do_not_count(turns):
    q = np.array(ONE_WAY) + 2 * np.pi * np.array(turns)
    assert marked("q", q.tolist(), SLIDER).credit == 1


def test_branches_beyond_limits_that_the_sheet_tells_are_not_asked_for():
    """Of the four two would turn joint 1 by more than 2 rad."""
    near = Sheet(replace(ELBOW, rows=LIMITED), {"inverse kinematics": DRAWN["inverse kinematics"]})
    two, four = value("q", near), value("q")
    assert (len(two), len(four)) == (2, 4)
    assert marked("q", two.tolist(), near).credit == 1
    assert marked("q", four.tolist(), near).credit < 1


def test_limits_that_the_sheet_does_not_tell_are_only_noted():
    given = {"target": at([2.0, 0.2, 0.4]), "one way": [2.0, 0.2, 0.4]}
    edge = Sheet(RODS, {"inverse kinematics": given})
    assert "Limits" not in edge.questions[0].text
    found = marked("q", [2.008, 0.2, 0.4], edge)
    assert found.credit == 1
    assert "q_1 would be beyond the real arm's range" in found.words


def at(q):
    return forward_kinematics(RODS, q)[:3, 3][:, None].tolist()
