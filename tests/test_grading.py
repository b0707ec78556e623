"""The parts of a verdict by hand: what digits promise, how far off is right, which mistake explains
most, how a report reads.
"""

import numpy as np
import pytest

from helpers.checks.digits import Typed, literal, of_floats, units
from helpers.checks.entries import Margins, graded, margins
from helpers.checks.ranking import Cause, Found, Pairs, better, cause, explain, lower, several
from helpers.checks.verdict import Finding, Report

# Digits


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("12.34", (2, 4, 1)),
        (" -0.056 ", (3, 2, -2)),
        ("+ 7", (0, 1, 0)),
        (".5e-3", (4, 1, -4)),
        ("25E+2", (-2, 2, 3)),
        ("0.00", (2, 0, -3)),
        ("", None),
        (".", None),
        ("e5", None),
        ("pi/2", None),
        ("1.2.3", None),
    ],
)
def test_decimals_digits_and_the_first_place_of_a_number(text, expected):
    assert literal(text) == expected


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        (["1.25", "3"], [0.01, 0.01]),
        (["120", "7"], [1, 1]),
        (["12e1", "3e1"], [10, 10]),
        (["0", "0.0"], [1, 1]),
        (["0", "1e-15", "2.5"], [0.1, 0.1, 0.1]),  # what is left of a zero shows no decimals
        (["1e-12", "2.5"], [0.1, 0.1]),
        (["1e-11", "2.5"], [1e-11, 0.1]),  # two significant digits at most
        (["123.4", "0.01234", "0"], [0.1, 1e-5, 1e-5]),  # four significant digits each
        (["123.4", "0.01234", "1e-13"], [0.1, 1e-5, 1e-5]),
        (["123.4", "0.0123"], [0.1, 1e-4]),
        (["123.4", "0.012345"], [1e-6, 1e-6]),
        (["123.4", "0.01", "5.6"], [0.1, 0.01, 0.01]),
        (["0.1234", "0.5"], [1e-4, 1e-4]),
        (["1.234", "0.0567"], [1e-3, 1e-4]),
        (["pi", "0.5"], [0, 0.1]),
        (["pi", "5"], [0, 0]),
        (["1.234567890123", "0.5"], [0, 0]),  # thirteen digits: never rounded
        (["1.23456789012", "0.5"], [1e-11, 1e-11]),
        ([], []),
    ],
)
def test_units_of_numbers_typed_together(texts, expected):
    assert units(texts) == pytest.approx(expected, rel=1e-12, abs=0)


def test_floats_are_told_by_their_shortest_spelling():
    found = of_floats(np.array([[1.0, 2.5], [3.0, 0.125]]))
    assert found == pytest.approx(np.full((2, 2), 1e-3))
    assert of_floats(np.array([3.0, 20.0])) == pytest.approx([1, 1])


def test_what_was_typed_knows_its_decimals_and_its_parts():
    both = Typed(
        np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]), np.array([[0.1, 1e-3, 0], [1, 2e-3, 1e-4]])
    )
    assert (both.decimals, both.symbolic) == (4, False)
    assert Typed(np.ones(2), np.array([10.0, 100.0])).decimals == 0
    assert Typed(np.ones(2), np.zeros(2)).decimals is None
    np.testing.assert_array_equal(both.unwritten, [[0, 1e-3, 0], [0, 0, 1e-4]])
    part = both.at(1, [2, 0])
    assert (part.values.tolist(), part.units.tolist()) == ([6.0, 4.0], [1e-4, 1.0])
    assert both.turned().values.tolist() == [[1, 4], [2, 5], [3, 6]]
    assert both.turned().units.tolist() == [[0.1, 1], [1e-3, 2e-3], [0, 1e-4]]


# Margins

STEPS, SCALE = np.array([0.0, 0.01, 1e-9]), np.array([2.0, 2.0, 5.0])


def test_margins_grow_with_the_unit_and_the_scale():
    m = margins(STEPS, SCALE, np.array([0.0, 0.2, 0.1]))
    assert m.allowed == pytest.approx([2e-6, 0.51 * 0.01, 5e-6])
    assert m.band == pytest.approx([2e-6, 3.01 * 0.01, 5e-6])
    assert m.loose == pytest.approx([2e-3, 0.0301, 5e-3])
    assert m.units is STEPS
    assert m.slop == pytest.approx([0, 0.2, 0.1])
    wide = [2e-6, 0.4301, 0.200005]
    assert [b.tolist() for b in m.bands] == [
        pytest.approx(x) for x in (m.band, wide, [2e-3, 0.4301, 0.200005], m.allowed)
    ]
    part = m.at([1])
    assert [x.item() for x in (part.allowed, part.band, part.loose, part.units, part.slop)] == [
        pytest.approx(x) for x in (0.0051, 0.0301, 0.0301, 0.01, 0.2)
    ]
    even = margins(STEPS, SCALE)
    assert even.slop.tolist() == [0, 0, 0]
    assert [b.tolist() for b in even.bands] == [
        pytest.approx(x) for x in (even.band, even.loose, even.allowed)
    ]


@pytest.mark.parametrize(("tolerance", "expected"), [(0.1, 0.1), (0.0, 2e-9), (1e-12, 2e-9)])
def test_a_tolerance_is_all_that_is_allowed(tolerance, expected):
    m = margins(STEPS, np.full(3, 2.0), np.ones(3), tolerance)
    for width in (m.allowed, m.band, m.loose):
        assert width == pytest.approx([expected] * 3)
    assert not m.units.any()
    assert not m.slop.any()
    assert m.units.shape == m.slop.shape == (3,)


def even(allowed, band, loose, units=0.0, slop=0.0):
    return Margins(*(np.full(2, float(x)) for x in (allowed, band, loose, units, slop)))


NEAR, FAR = np.array([[1.04, 1.0]]), np.array([[5.0, 1.0]])
NONE = np.zeros((0, 2))


@pytest.mark.parametrize(
    ("mine", "m", "made", "grade"),
    [
        ([1.0, 1.0], even(0.01, 0.03, 0.1), FAR, "right"),
        ([1.0, 1.009], even(0.01, 0.03, 0.1), NONE, "right"),
        ([1.0, 1.02], even(0.01, 0.03, 0.1), NONE, "rounded"),
        ([1.0, 1.02], even(0.01, 0.03, 0.1), FAR, "rounded"),
        ([1.0, 1.11], even(0.01, 0.03, 0.1), FAR, "wrong"),
        # The mistake is as near: the digits cannot tell the two apart.
        ([1.02, 1.0], even(0.05, 0.06, 0.1), NEAR, "so far"),
        ([1.02, 1.0], even(0.05, 0.06, 0.1), [[1.08, 1.0]], "right"),
        ([1.02, 1.0], even(0.05, 0.06, 0.1), [[1.002, 1.0]], "right"),  # changes too little to ask
        ([1.02, 1.0], even(0.05, 0.06, 0.1), [[1.08, 1.0], [1.04, 1.02]], "so far"),
        ([1.02, 1.0], even(0.05, 0.06, 0.1), [[1.03, 1.2]], "right"),
        # Units so coarse that the mistake, 0.04 away, would round to the same.
        ([1.0, 1.0], even(0.01, 0.02, 0.1, units=0.0195), NEAR, "so far"),
        ([1.0, 1.0], even(0.01, 0.02, 0.1, units=0.0185), NEAR, "right"),
        ([1.0, 1.0], even(0.01, 0.02, 0.1, units=0.5), NONE, "right"),
        ([1.0, 1.0], even(0.01, 0.02, 0.1, units=0.0195), [*FAR, *NEAR], "so far"),
        # What is right fits only with the digits of q, the mistake without.
        ([1.04, 1.0], even(0.01, 0.03, 0.1, slop=0.1), NEAR, "wrong"),
        ([1.05, 1.0], even(0.01, 0.03, 0.1, slop=0.1), FAR, "right"),
        ([1.05, 1.0], even(0.01, 0.03, 0.1, slop=0.1), NEAR, "so far"),
        ([1.16, 1.0], even(0.01, 0.03, 0.1, slop=0.1), [[1.25, 1.0]], "wrong"),
        # Rounded on the way, and by how much: with the digits of q, and nearer to a mistake.
        ([1.22, 1.0], even(0.01, 0.03, 0.1, slop=0.1), NONE, "rounded"),
        ([1.24, 1.0], even(0.01, 0.03, 0.1, slop=0.1), NONE, "wrong"),
        ([1.24, 1.0], even(0.01, 0.03, 0.3, slop=0.1), NONE, "rounded"),
        ([1.03, 1.0], even(0.01, 0.04, 0.1), [[1.05, 1.0]], "so far"),
        ([1.03, 1.0], even(0.01, 0.04, 0.1), [[1.07, 1.0]], "rounded"),
        ([1.03, 1.0], even(0.01, 0.04, 0.1), [[1.05, 1.1]], "rounded"),
        ([1.03, 1.0], even(0.01, 0.04, 0.1), [[9.0, 1.0], [1.06, 1.0]], "so far"),
    ],
)  # fmt: skip
def test_the_grade_of_two_entries_that_should_be_1(mine, m, made, grade):
    assert graded(np.array(mine), np.ones(2), m, np.array(made)) == grade


# Which mistake explains most

SIX = np.zeros(6)
ONE, TWO, THREE = cause("J.halves"), cause("J.all signs"), cause("J.frame", k=3, _name="frame 3")


def told(mine, made, causes=None, **how):
    causes, made = causes or (ONE, TWO, THREE)[: len(made)], np.array(made, float)
    return explain(np.array(mine), SIX, np.full(6, 0.1), causes, made, **how)


def test_what_explains_all_is_named_however_little_is_wrong():
    found = told([1, 0, 0, 0, 0, 0], [[1, 1, 1, 1, 1, 1], [1.05, 0, 0, 0, 0, 0]])
    assert found.causes == (TWO,)
    assert not found.odd.any()
    assert found.rest.tolist() == pytest.approx([-0.05, 0, 0, 0, 0, 0])
    assert told([0.05, 0, 0, 0, 0, 0], [[0.05, 0, 0, 0, 0, 0]]) is None, "nothing is wrong"
    assert told([1, 0, 0, 0, 0, 0], [[0, 0, 0, 0, 0, 0]]) is None
    assert explain(np.ones(6), SIX, SIX, (), np.zeros((0, 6))) is None


@pytest.mark.parametrize(
    ("mine", "made", "odd"),
    [
        ([1, 1, 1, 2, 0, 0], [1, 1, 1, 0, 0, 0], [3]),  # three of four
        ([1, 1, 2, 2, 0, 0], [1, 1, 0, 0, 0, 0], None),  # two
        ([1, 1, 1, 2, 2, 0], [1, 1, 1, 0, 0, 0], [3, 4]),  # three of five are 60 %
        ([1, 1, 1, 2, 2, 2], [1, 1, 1, 0, 0, 0], None),  # three of six are less
        ([1, 1, 1, 1, 0, 0], [1, 1, 1, 1, 1, 0], [4]),  # one spoiled of four
        ([1, 1, 1, 0, 0, 0], [1, 1, 1, 1, 0, 0], None),
    ],
)
def test_a_mistake_must_gain_three_entries_and_most_of_what_is_wrong(mine, made, odd):
    found = told(mine, [made])
    assert (None if found is None else np.flatnonzero(found.odd).tolist()) == odd


@pytest.mark.parametrize(
    ("mine", "made", "named"),
    [
        ([1, 1, 1, 1, 2, 0], [1, 1, 1, 1, 0, 0], False),  # four of five are 80 %
        ([1, 1, 1, 2, 0, 0], [1, 1, 1, 0, 0, 0], False),
        ([1, 1, 1, 1, 1, 1], [1, 1, 1, 1, 1, 1], True),
    ],
)
def test_two_mistakes_must_gain_more(mine, made, named):
    both = told(mine, [made], Pairs([(ONE, TWO)]))
    same = told(mine, [made], [ONE + TWO])
    assert (both is not None) == (same is not None) == named
    if named:
        assert both.causes == same.causes == (ONE + TWO,)


def test_the_simplest_comes_first_and_what_costs_the_same_beside_it():
    mine = [1, 1, 1, 1, 1, 0]
    found = told(mine, [[1, 1, 1, 1, 0, 0], mine, mine])
    assert found.causes == (TWO, THREE)
    assert not found.odd.any()
    two = Pairs([(ONE, TWO), (TWO, THREE)])
    assert told(mine, [mine, mine], two).causes == (ONE + TWO, TWO + THREE)
    # No two mistakes are needed for one wrong entry.
    one = [1, 0, 0, 0, 0, 0]
    assert told(one, [one, one], two) is None
    # One entry left costs 0.7, less than a second mistake; with a weight of 1.2 it costs more.
    causes, made = [ONE + TWO, THREE], [mine, [1, 1, 1, 1, 0, 0]]
    assert told(mine, made, causes).causes == (THREE,)
    assert told(mine, made, causes, odd=1.2).causes == (ONE + TWO,)


def found(left, *causes):
    return Found(causes, np.arange(6) < left, SIX)


def test_the_better_costs_less():
    single, pair, spoiled = found(0, ONE), found(0, ONE + TWO), found(1, THREE)
    assert better(None, pair, single) is single
    assert better(pair, spoiled) is spoiled
    assert better(pair, spoiled, odd=1.2) is pair
    assert better(single, found(0, TWO)) is single
    assert better(None, None) is None


def test_what_causes_say_and_how_they_are_called():
    assert THREE.name == "J.frame:3"
    assert cause("J in half", half="linear", words="x", _of="J.halves").name == "J.halves"
    both = ONE + TWO
    assert isinstance(both, Cause)
    assert both.name == "J.halves + J.all signs"
    assert ONE.words.startswith("Linear and angular rows are exchanged; angular_first=True")
    assert TWO.words == "Every sign is reversed"
    assert both.words == f"{ONE.words}; and besides, every sign is reversed"
    pairs = Pairs([(ONE, TWO), (TWO, ONE)])
    assert (len(pairs), pairs[1].name) == (2, "J.all signs + J.halves")
    assert [c.name for c in pairs] == ["J.halves + J.all signs", "J.all signs + J.halves"]
    assert pairs.edits.tolist() == [2, 2]


SIGNS = [cause("J.column sign", i=i) for i in range(1, 5)]


def test_up_to_three_single_causes_are_said_and_the_first_of_pairs():
    words = [c.words for c in SIGNS]
    assert several(SIGNS[:1] * 2) == words[0]
    same = "which gives the same numbers here"
    assert several(SIGNS[:2]) == f"{words[0]}; or {lower(words[1])}, {same}"
    assert several(SIGNS) == f"{words[0]}; or {lower(words[1])} or {lower(words[2])}, {same}"
    assert several(SIGNS, most=2) == several(SIGNS[:2])
    assert several([ONE + TWO, TWO + ONE]) == (ONE + TWO).words


@pytest.mark.parametrize(
    ("sentence", "inside"),
    [("The sign", "the sign"), ("A", "a"), ("N mm", "n mm"), ("NM", "NM"), ("A_i is", "A_i is"),
     ("q_1 is", "q_1 is"), ("It_is", "it_is")],
)  # fmt: skip
def test_a_sentence_inside_another(sentence, inside):
    assert lower(sentence) == inside


# Reports


def finding(what, words):
    return Finding(what, "row 2", 1.5, None, words)


def test_a_report_in_lines_and_in_markdown():
    findings = (
        finding("cause", "The sign is wrong."),
        finding("row", "Row 2 is off."),
        finding("row", "Row 3 is off."),
    )
    report = Report(
        "table",
        "Panda",
        "wrong",
        "Not right: row 3 is off.",
        findings,
        (),
        ("degrees",),
        ("Mind.",),
    )
    assert report.lines == ["Row 2 is off.", "Taken as degrees", "Note: Mind."]
    text = "Not right: row 3 is off.\n- Row 2 is off.\n- Taken as degrees\n- Note: Mind."
    assert str(report) == repr(report) == text
    head, rest = text.split("\n", 1)
    assert report._repr_markdown_() == f"✘ **{head}**\n\n{rest}"
    assert [str(f) for f in findings[:2]] == ["The sign is wrong.", "Row 2 is off."]
    assert not report.agrees


@pytest.mark.parametrize(
    ("grade", "mark"), [("right", "✔"), ("so far", "◐"), ("rounded", "≈"), ("wrong", "✘")]
)
def test_the_mark_of_a_grade(grade, mark):
    report = Report("pose", "Panda", grade, "So it is.")
    assert report.agrees == (grade == "right")
    assert report._repr_markdown_() == f"{mark} **So it is.**\n"
    assert (report.findings, report.causes, report.taken, report.notes) == ((), (), (), ())
    assert report.figures == {}
    assert report == Report("pose", "Panda", grade, "So it is.", figures={"worst": 1.0})
