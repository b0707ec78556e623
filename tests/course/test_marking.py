"""What an answer is worth, and what is said of it: right, slipped, unreadable and no work."""

import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from course import marking
from course.making import right_work
from course.marking import Mark, mark, mark_sheet
from course.sheets import Sheet, sheet
from helpers.arm import Arm, prismatic, revolute
from helpers.kinematics import forward_kinematics
from helpers.robots import ARMS, ELBOW, PANDA, STANFORD

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
    "Jacobian": {
        "q": [0.3, 0.9, -0.7],
        "q_dot": [0.5, -1.0, 0.2],
        "column": 2,
        "link": 3,
        "camera": [0.05, -0.1],
    },
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


def value(name, of=ELBOWS):
    return of.parts[name].value


def marked(name, answer, of=ELBOWS):
    return mark(of, name, answer)


# The laws of marks, over every arm and topic


ARMS_ASKED = [*ARMS, HANGING, RODS]
MEASURED = ("numbers", "rotation", "jacobian", "torques")


@cache
def parts(arm, seed=0):
    mine = sheet(arm, f"law {seed}")
    return mine, [part for part in mine.parts.values() if part.kind in MEASURED]


def as_text(x, decimals):
    """Rounded numbers as they are typed, zeros at the end and all."""
    return np.vectorize(lambda v: f"{v:.{decimals}f}")(x).tolist()


@pytest.fixture
def wordless(monkeypatch):
    """Credit alone, without what the judge says beside it, which takes most of the time."""
    monkeypatch.setattr(marking, "_judged", lambda *_: [])


laws = pytest.mark.parametrize("arm", ARMS_ASKED, ids=lambda arm: f"{arm.name}-{arm.dof}")


@laws
def test_the_key_in_the_decimals_asked_or_more_gets_everything(arm):
    for seed in range(2):
        mine, asked = parts(arm, seed)
        text = "\n".join(question.markdown for question in mine.questions)
        for part in asked:
            assert f"`{part.name}`: {part.what}; {part.digits} decimals; " in text
            nearest = min(np.abs(wrong - part.value).max() for _, wrong in part.slips)
            fewest = 2 if part.name in ("quarter", "half") else 3
            assert 2 * part.unit < nearest
            assert part.digits == fewest or 20 * part.unit >= nearest
            for decimals in (part.digits, part.digits + 1, 8):
                found = mark(mine, part.name, as_text(part.value, decimals))
                assert found == Mark(part.name, 1.0, "Right.")
            cut = np.trunc(part.value * 10**part.digits) / 10**part.digits
            assert mark(mine, part.name, as_text(cut, part.digits)).credit == 1


@laws
def test_rounding_never_pays(arm, wordless):
    """Neither the right numbers nor those of any known slip, from one decimal to the next."""
    mine, asked = parts(arm)
    for part in asked:
        for words, wrong in (("right", part.value), *part.slips):
            credits = [mark(mine, part.name, as_text(wrong, n)).credit for n in range(5, -1, -1)]
            assert credits == sorted(credits, reverse=True), (part.name, words, credits)
            assert (credits[0] < 1) == (words != "right")


@laws
def test_joint_values_are_right_in_the_decimals_asked_and_rounding_never_pays(arm):
    mine, _ = parts(arm)
    part = mine.parts["q"]
    for off in (0, 0.02):
        credits = [
            mark(mine, "q", as_text(part.value + off, n)).credit for n in (6, part.digits, 1)
        ]
        assert credits[:2] == [float(not off)] * 2
        assert credits[2] <= credits[0]


@pytest.mark.parametrize(("row", "length"), [(1, "0.2"), (1, "-0.2"), (1, "0"), (2, "0.53")])
def test_a_table_is_worth_no_more_where_its_lengths_are_rounded(row, length):
    """The same of its key, whose row 2 has a length of 0.2 m."""

    def credits(rows):
        texts = [[[rounded(e, n) for e in row] for row in rows] for n in (3, 1, 0)]
        return [marked("table", text).credit for text in texts]

    wrong = [[*([length] if i == row else r[:1]), *r[1:]] for i, r in enumerate(TABLE)]
    found = credits(wrong)
    assert found == sorted(found, reverse=True)
    assert found[0] == (1 if wrong == TABLE else 0.75)


def rounded(entry, decimals):
    """An entry of a table, where it is a number."""
    return f"{float(entry):.{decimals}f}" if re.fullmatch(r"-?[\d.]+", entry) else entry


@laws
def test_a_slip_is_worth_its_right_numbers_and_is_named(arm, wordless):
    """Halves of columns, columns or numbers, counted here once more."""
    mine, asked = parts(arm)
    for part in asked:
        for words, wrong in part.slips:
            off = np.abs(wrong - part.value) > part.unit
            idle = mine.drawn["circle tracing"]["q"] if part.name in ("quarter", "half") else 0
            zero = np.abs(part.value - idle) <= part.unit
            if part.kind == "jacobian":
                off, zero = (np.vstack([x[:3], x[3:]]) for x in (off, zero))
                off = np.r_[off[:3].any(axis=0), off[3:].any(axis=0)]
                zero = np.r_[zero[:3].all(axis=0), zero[3:].all(axis=0)]
            elif part.kind == "rotation":
                off, zero = off.any(axis=0), zero.all(axis=0)
            share = max(0, 1 - off.sum() / (~zero).sum())
            found = mark(mine, part.name, as_text(wrong, 6))
            assert found.credit <= share + 1e-12, (part.name, words)
            assert words in found.words or not wrong.any()


@laws
def test_wrong_numbers_never_help_and_what_is_left_out_counts_as_zero(arm, wordless):
    rng = np.random.default_rng(3)
    mine, asked = parts(arm)
    for part in asked:
        right, flat = np.asarray(part.value, dtype=float), np.size(part.value)
        for _ in range(4):
            some = right.copy()
            some.flat[rng.permutation(flat)[: rng.integers(1, flat + 1)]] = 0
            credit = mark(mine, part.name, as_text(some, 6)).credit
            left = as_text(some, 6)
            left = [None if x == "0.000000" else x for x in left] if right.ndim == 1 else left
            assert mark(mine, part.name, left).credit == credit
            worse = np.where(some == right, some, rng.uniform(20, 30, right.shape))
            assert mark(mine, part.name, as_text(worse, 6)).credit <= credit
        short = as_text(right, 6)[:-1]
        assert mark(mine, part.name, short).credit == 0
        assert mark(mine, part.name, np.zeros_like(right).tolist()).credit == 0


@laws
def test_half_a_jacobian_is_half_the_work(arm, wordless):
    mine, _ = parts(arm)
    J = mine.parts["J"].value
    linear, angular = (np.abs(half).max(axis=0) > 1e-3 for half in (J[:3], J[3:]))
    for half, rows, worth in ((J[:3], slice(0, 3), linear), (J[3:], slice(3, 6), angular)):
        whole = np.zeros_like(J)
        whole[rows] = half
        share = worth.sum() / (linear.sum() + angular.sum())
        for answer in (half, whole):
            assert mark(mine, "J", as_text(answer, 4)).credit == pytest.approx(share)


def test_too_few_decimals_are_worth_the_worst_slip_that_fits_them_and_are_told():
    """The Panda's torques in whole N m: 9.8 for 9.81 cannot be told from them."""
    part = WEIGHED.parts["g"]
    assert part.digits == 3
    found = mark(WEIGHED, "g", as_text(part.value, 0))
    fitting = [
        marked("g", wrong.tolist(), WEIGHED).credit
        for _, wrong in part.slips
        if np.abs(np.round(part.value) - wrong).max() <= 1
    ]
    assert 0 <= found.credit <= min(fitting) < 1
    assert found.words.startswith("Right to the decimals that you gave, but 3 were asked.")
    assert "9.8 for 9.81" in str([words for words, _ in part.slips])


def test_what_is_asked_in_symbols_differs_from_student_to_student():
    asked = [sheet(ELBOW, f"student {n}").parts["J_column"].value for n in range(40)]
    assert len({str(six) for six in asked}) >= 39


@pytest.mark.parametrize(
    ("name", "answer", "credit", "words"),
    [
        ("p", lambda p: p.tolist(), 1, "Right."),
        ("p", lambda p: p[:, None].tolist(), 1, "Right."),
        ("p", lambda p: {"x": p[0], "y": p[1], "z": p[2]}, 1, "Right."),
        ("p", lambda p: [*p[:2], p[2] + 0.0009], 1, "Right."),
        ("p", lambda p: [*p[:2], p[2] + 0.0021], 2 / 3, "Not right: number 3."),
        ("p", lambda p: [*p[:2].round(5), f"{p[2]:.1f}"], 2 / 3, "Too few decimals, 3 were asked"),
        ("p", lambda p: (1000 * p).tolist(), 0, "millimetres for metres"),
        ("p", lambda p: p[:2].tolist(), 0, "Not read: 2 numbers given, expected 3; write 0 for"),
        ("p", lambda p: "a" * 8001, 0, "Not read: it has more than 8000 characters."),
        ("p", lambda p: ["x", 1, 2], 0, "Not read: there is no value for x"),
        ("R", lambda R: R.T.tolist(), 0, "the transpose"),
        ("J_column", lambda six: six[:5], 0, "Not read: expected a list of six formulas"),
        ("J_column", lambda six: [*six[:3], "0", "0", "0"], 0.5, ""),
        ("J_column", lambda six: ["0", "0", "0", *six[3:]], 0.5, ""),
        ("J_column", lambda six: [[x] for x in six], 1, ""),
        ("J_column", lambda six: [*six[:5], "7"], 0.5, ""),
        ("J_column", lambda six: ["1"] * 6, 0, ""),
    ],
)  # fmt: skip
def test_what_a_student_may_type_and_what_is_said(name, answer, credit, words):
    found = marked(name, answer(value(name)))
    assert found.credit == pytest.approx(credit)
    assert words in found.words


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


@pytest.mark.parametrize("arm", [HANGING, STANFORD, RODS], ids=str)
def test_no_work_earns_no_marks(arm, wordless):
    """These three have every topic, and every kind of part."""
    mine, _ = parts(arm)
    right = right_work(mine)
    for question in mine.questions:
        for part in question.parts:
            for guess in [*NOTHING, *guesses(right[part.name], question)]:
                found = mark(mine, part.name, guess)
                assert found.credit == 0, (part.name, guess, found)


SLIPPED = [*TABLE[:2], ["0.45", *TABLE[2][1:]], TABLE[3]]
JUDGED = [
    ("table", lambda _: np.array(TABLE), 1),
    ("table", lambda _: np.array(SLIPPED), 3 / 4),
    ("q", lambda four: four, 1),
    ("q", lambda four: four + 2 * np.pi, 1),
    ("q", lambda four: four[:2], 0.5),
    ("q", lambda four: four[1:], 0.75),
    ("q", lambda four: np.add(four, [[0.3], [0], [0], [0]]), 0.75),
    ("q", lambda four: np.r_[four, four[:1] + 0.3], 4 / 5),
]


@pytest.mark.parametrize(("name", "change", "credit"), JUDGED)
def test_tables_and_ways_by_what_is_right_of_them(name, change, credit):
    assert marked(name, change(value(name)).tolist()).credit == pytest.approx(credit)


def test_a_table_of_another_shape_is_not_filled_up_from_the_key():
    for other in (TABLE[:3], [*TABLE, TABLE[3]], [row[:3] for row in TABLE], "a b"):
        assert marked("table", other).credit == 0


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
    found = marked("q", [2.0008, 0.2, 0.4], edge)
    assert found.credit == 1
    assert "q_1 would be beyond the real arm's range" in found.words


def at(q):
    return forward_kinematics(RODS, q)[:3, 3][:, None].tolist()
