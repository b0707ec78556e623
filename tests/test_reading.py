"""Test that typed formulas, grids and tables are read as the numbers they were made from."""

import math
import random
import re
from collections import defaultdict
from functools import partial

import numpy as np
import pytest
import sympy as sp

from helpers.arm import Arm
from helpers.checks.tables import format_table
from helpers.inputs import ArmError
from tests import reading
from tests.cases import FORMULAS, QUESTIONS, TABLES
from tests.node import needs_node

pytestmark = needs_node
QUESTIONS_ABOUT_TABLES = [case for case in QUESTIONS if case["ask"] == "table"]

NO_ROWS = "the table is {}; expected rows of four entries"
NO_LINES = (
    "I find no rows of four entries in {}; write a line for each joint with its a, alpha, d and "
    "theta, and commas or blanks between"
)
NO_ENTRIES = "the table is {}; expected lists such as 'a': [...], or entries such as 'd1': 0.3"
UNEVEN, MANY = (
    "the table's lists have {} entries; expected as many in each",
    "the table has {} rows; expected at most 32",
)
UNIT = "[[1, 0, 0, 0], [1, 0, 0, 0], [1, 0, 0, 0]"
NO_TABLES = [
    ([], NO_ROWS, "[]"),
    ([[]], NO_ROWS, "[[]]"),
    ([1, 2], NO_ROWS, "[1, 2]"),
    ([[0, 0, 0, 0], "0 0 0 0"], NO_ROWS, "[[0, 0, 0, 0], '0 0 0 0']"),
    (np.zeros(4), NO_ROWS, "array([0., 0., 0., 0.])"),
    ([[0, [1], 1, 2]], NO_ROWS, "[[0, [1], 1, 2]]"),
    ([[[1, 0, 0, 0]] * 3], NO_ROWS, f"[{UNIT}]]"),
    ({}, NO_ENTRIES, "{}"),
    ({"a": [1], "d": 2}, NO_ENTRIES, "{'a': [1], 'd': 2}"),
    ({"a1": 0, "size": 2}, NO_LINES, "\"{'a1': 0, 'size': 2}\""),
    (None, "the table is {}; expected rows or text", "None"),
    ([[0, 0, 0]], NO_LINES, "'[[0, 0, 0]]'"),
    ({"a": [1], "alpha": [0, 0], "d": [1, 2], "theta": [1, 2, 3]}, UNEVEN, "1, 2, 3"),
    ([[0, 0, 0, 0]] * 33, MANY, "33"),
    (np.tile(np.eye(4), (33, 1, 1)), MANY, "33"),
]


@pytest.mark.parametrize(("table", "message", "shown"), NO_TABLES, ids=range(len(NO_TABLES)))
def test_object_without_table_is_rejected_with_message(table, message, shown):
    with pytest.raises(ArmError) as error:
        reading.read_tables(table)
    assert str(error.value) == message.replace("{}", shown)


@pytest.mark.parametrize("sign", "+-*/")
def test_formula_of_4000_terms_is_evaluated(sign):
    found = reading.read_formula(sign.join(["q", *["1"] * 4000]), q=5.0)
    expected = {"+": 4005, "-": -3995}.get(sign, 5)
    assert found == {"names": ["q"], "value": expected}


@pytest.mark.parametrize(
    "form", ["sin ", "-", "+", "2^", "(|)", "2^(|)/3", "sin(|)", "-cos -(|)"], ids=str
)
def test_formula_depth_has_a_limit(form):
    start, _, end = form.partition("|")
    most = {"2^(|)/3": 30, "sin(|)": 30, "-cos -(|)": 20}.get(form, 60)
    deep = reading.ask_reader("formula", text=start * most + "x" + end * most, what="y", known=None)
    assert deep["names"] == ["x"]
    with pytest.raises(ArmError, match="; expected one formula, such as"):
        reading.read_formula(start * (most + 1) + "x" + end * (most + 1), "y")


def test_formula_over_20000_characters_is_rejected():
    assert reading.read_formula("1+" * 9999 + "10")["value"] == 10_009
    with pytest.raises(ArmError, match="y has 20001 characters; expected at most 20000"):
        reading.read_formula("1+" * 10_000 + "1", "y")


QUARTER = "1.5707963267948966"
NUMBERS = np.array([[0, math.pi / 2, 0.5, 0], [0.4, 0, 0, 0], [0.3, 0, 0.25, 0]])
A, ALPHA, D, _ = NUMBERS.T.tolist()
Q = ["q1", "q_2", None]
LINES = [[a, alpha, d, q] for a, alpha, d, q in zip(A, ALPHA, D, Q, strict=True)]
ORDER = {"columns": "a alpha d theta"}


class Frame:
    """Imitate the part of a data frame of pandas that the judge reads."""

    columns = ("theta", "d (m)", "a (m)", "alpha")

    def to_numpy(self):
        return np.array([[q, d, a, alpha] for a, alpha, d, q in LINES], dtype=object)


@pytest.mark.parametrize(
    ("table", "options"),
    [
        ({"a": A, "alpha": ALPHA, "d": D, "theta": Q}, {}),
        ({"theta_i": Q, "d": np.array(D), "r": tuple(A), "α": np.array(ALPHA)}, {}),
        (Frame(), {}),
        ([{"d": 0.5, "alpha": math.pi / 2, "theta": "q1"}, {"a": 0.4, "theta": "q2"},
          {"a": 0.3, "d": 0.25, "theta": "q"}], {}),
        (["a alpha d theta", f"0 {QUARTER} 0.5 q1", "0.4 0 0 q2", "0.3 0 0.25 *"], {}),
        (LINES, ORDER),
        (tuple(map(tuple, LINES)), ORDER),
        (np.array(LINES, dtype=object), ORDER),
        (NUMBERS, ORDER),
        ([*NUMBERS], {"columns": "a; alpha,  d|theta", "convention": "Standard"}),
        ([[1, *LINES[0]], [2, *LINES[1]], [3, *LINES[2]]], ORDER),
        ([[0, *LINES[0]], [1, *LINES[1]], [2, *LINES[2]]], ORDER),
    ],
    ids=range(12),
)  # fmt: skip
def test_table_is_read_from_any_container(table, options):
    [read] = reading.read_tables(table, **options)
    rows = reading.list_rows(read)
    np.testing.assert_array_equal([r[1:] for r in rows], NUMBERS)
    assert [kind for kind, *_ in rows] == ["revolute"] * 3
    texts = [row["texts"] for row in read["rows"]]
    assert [(t["a"], t["alpha"], t["d"]) for t in texts] == [
        ("0", QUARTER, "0.5"), ("0.4", "0", "0"), ("0.3", "0", "0.25")]  # fmt: skip


def compute_link_matrix(theta, alpha, a, d):
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]


def stack_rows(matrices):
    return [row for A in matrices for row in A]


def test_smallest_and_unusual_tables_are_read():
    assert len(reading.read_tables([[0, 0, 0, 0]] * 32)[0]["rows"]) == 32
    [still] = reading.read_tables(["0 0 0 0"], convention="craig", kinds=["fixed"], **ORDER)
    assert reading.list_rows(still) == [("fixed", 0, 0, 0, 0)]
    [read] = reading.read_tables(["a_{i-1} alpha_{i-1} d theta", "0 0 0.5 q", "0.4 pi 0 0"])
    assert reading.list_rows(read) == [("revolute", 0.4, math.pi, 0.5, 0)]


@pytest.mark.parametrize("arrange", [list, np.array, stack_rows, lambda matrices: matrices * 2])
def test_link_matrices_are_read_as_table_rows(arrange):
    rows = [(0.7, -0.4, 0.3, 0.25), (-2.1, 2.2, 0.15, -0.6)]
    matrices = arrange([compute_link_matrix(*row) for row in rows])
    [read] = reading.read_tables(matrices, lengths="m", angles="rad")
    found = [
        [row["numbers"][name] for name in ("theta", "alpha", "a", "d")] for row in read["rows"]
    ]
    np.testing.assert_allclose(found, rows * (len(found) // 2), atol=1e-12)
    assert {(row["kind"], row["backwards"]) for row in read["rows"]} == {("unknown", False)}
    assert (read["lengths"], read["angles"]) == ("m", "rad")
    texts = {"a": "0.3", "alpha": "-0.4", "d": "0.25", "theta": "0.7"}
    assert read["rows"][0]["texts"] == texts


def test_matrix_that_is_no_link_transform_is_rejected():
    """At q = 0 a wrong sign of a sine, or a missing cosine, has no effect."""
    link = "cos(q{0}) sin(q{0}) 0 {2}\nsin(q{0}) -cos(q{0}) 0 0.4*sin(q{0})\n0 0 {1} 0.1\n0 0 0 1\n"
    good = link.format(1, -1, "0.4*cos(q1)")
    for wrong, at in ((link.format(2, 1, "0.4*cos(q2)"), "2, column 2"),
                      (link.format(2, -1, "0.4"), "1, column 4")):  # fmt: skip
        with pytest.raises(ArmError, match=f"A_2 is no link matrix: its entry in row {at}"):
            reading.read_tables(good + wrong)


def test_columns_without_headers_are_a_alpha_d_theta():
    assert reading.read_tables("0 0 0.5 q1\n0 0 0.3 q2")[0]["assumptions"] == [
        "columns a alpha d theta"
    ]


def test_matrix_with_symbols_has_a_joint():
    still, moves = "1 0 0 .3\n0 0 -1 0\n0 1 0 .2\n", "C1 -S1 0 C1/2\nS1 C1 0 S1/2\n0 0 1 0\n"
    [read] = reading.read_tables(f"{still}0 0 0 1\n{moves}0 0 0 1")
    found = [(row["kind"], row["numbers"]["a"]) for row in read["rows"]]
    assert found == [("unknown", 0.3), ("revolute", 0.5)]


@pytest.mark.parametrize(
    ("headers", "expected"),
    [
        ("a [mm] alpha (Deg) d theta", ("mm", "deg", None)),
        ("a, α [°], d, theta", (None, "deg", None)),
        ("a (m), alpha [rad], d, theta", ("m", "rad", None)),
        ("a (mm)\tα_{i-1} in radians\td\ttheta", ("mm", "rad", "craig")),
        ("r [ cm ] , twist , offset , q", ("cm", None, None)),
        ("alpha,theta,a_i-1,d [m", ("m", None, "craig")),
        ("a/m,alpha/rad,d/m,theta/rad", ("m", "rad", None)),
        ("a_mm,alpha_deg,d_mm,theta_deg", ("mm", "deg", None)),
    ],
)
def test_headers_give_units_and_convention(headers, expected):
    sign = next((sign for sign in ",\t" if sign in headers), " ")
    [read] = reading.read_tables(f"{headers}\n{sign.join('1111')}")
    assert (read["lengths"], read["angles"], read["convention"]) == expected


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"lengths": "ft"}, "lengths is 'ft'; expected one of m, cm, mm"),
        ({"angles": "mm"}, "angles is 'mm'; expected one of rad, deg"),
        ({"convention": 5}, "convention is '5'; expected one of standard, craig, modified"),
        ({"columns": "a b c d"}, "'a b c d'"),
        ({"columns": 5}, "5"),
    ],
)
def test_contradictory_table_option_is_rejected(options, words):
    with pytest.raises(ArmError) as error:
        Arm.from_table(format_table(NUMBERS), **options)
    assert words in str(error.value)


def test_exchanged_headers_are_corrected():
    text = "a,alpha,d,theta\n0,q1,0.5,90\n0.4,q2,0,0\n0.3,q3,0,0"
    [read] = reading.read_tables(text, lengths="m", angles="deg", convention="craig")
    assert read["isExchanged"]
    assert (read["lengths"], read["angles"], read["convention"]) == ("m", "deg", "craig")
    assert [row["numbers"]["alpha"] for row in read["rows"]] == [90, 0, 0]


@pytest.mark.parametrize("case", FORMULAS, ids=lambda case: case["text"])
def test_typed_formula_is_evaluated(case):
    found = reading.read_formula(case["text"], x=0.7, q_1=0.4)["value"]
    assert found == pytest.approx(case["value"], rel=1e-9, abs=1e-12)


def draw_sum(rng, terms):
    """Return a sum of two of these terms with rational factors."""
    factors = (sp.Rational(rng.randint(-12, 12), rng.choice([1, 2, 4, 100])) for _ in range(2))
    return sum(factor * rng.choice(terms) for factor in factors)


PLAIN_TERMS = [0, 1, sp.pi, sp.sqrt(2), sp.sqrt(10) * sp.pi, sp.Float(0.37) * sp.sqrt(3)]
ODD_TERMS = [sp.pi**2, sp.root(2, 3), 1 / (1 + sp.pi), sp.pi**3, sp.sqrt(2 + sp.sqrt(3))]
NAMES_BEFORE = ["", "J = ", "My answer:\n\n", "Out[3]:\n"]


@pytest.mark.parametrize("use_unicode", [True, False])
def test_sympy_print_is_read_or_rejected(use_unicode):
    rng = random.Random(52)
    texts_read = 0
    for k in range(30):
        terms = [*PLAIN_TERMS, ODD_TERMS[k % 5]] if k % 2 else PLAIN_TERMS
        matrix = sp.Matrix(2, 3, lambda i, j, terms=terms: draw_sum(rng, terms))
        text = rng.choice(NAMES_BEFORE) + sp.pretty(matrix, use_unicode=use_unicode)
        try:
            values = reading.read_matrix(text, 2, 3)
        except ArmError:
            continue
        np.testing.assert_allclose(values, [float(entry) for entry in matrix], 1e-6, err_msg=text)
        texts_read += 1
    assert texts_read >= 6


@pytest.mark.parametrize("case", TABLES, ids=range(len(TABLES)))
def test_typed_table_is_read_or_refused(case):
    if "refused" in case:
        with pytest.raises(ArmError, match=case["refused"]):
            reading.read_tables(case["text"])
        return
    tables = reading.read_tables(case["text"], **case.get("options", {}))
    kinds, *numbers = zip(*case["rows"], strict=True)
    expected = np.array(numbers) * np.array([[1], [math.radians(1)], [1], [math.radians(1)]])

    def is_right(rows):
        found_kinds, *found = zip(*rows, strict=True)
        return [kind[0].upper() for kind in found_kinds] == [*kinds] and np.allclose(
            found, expected, atol=2e-5
        )

    readings = [*map(reading.list_rows, tables)]
    assert any(map(is_right, readings if case.get("guessed") else readings[:1])), readings[0]


# A number that is not part of a name, such as q_1, q_{1}, q1, q[1] and deg2rad.
_NUMBER = re.compile(r"(?<![A-Za-zα-ω_₀-₉])(?<!_\{)(?<![qθa][\[(])(?:\d+(?:\.\d*)?|\.\d+)")


def list_wrong_marks(table):
    """List the entries whose marked numbers are not those of the text that was read there.

    Zeros do not count, because the text may leave them out. Link matrices have no text for an
    entry of the table; a matrix is listed if none of its numbers is marked.
    """
    owners = {token["owner"] for token in table["tokens"]}
    assert owners <= {"entry", "label", "header", "given", "context"}, owners
    marked = defaultdict(str)
    for token in table["tokens"]:
        if token["owner"] == "entry":
            marked[token["row"], token.get("column")] += token["text"]
    if any("matrix" in token for token in table["tokens"]):
        return [row for row in range(len(table["rows"])) if (row, None) not in marked]
    texts = {
        (row, column): entries["texts"][name]
        for row, entries in enumerate(table["rows"])
        for column, name in enumerate(("a", "alpha", "d", "theta"))
    }
    digits = partial(re.sub, "[0.]", "")
    return [
        (at, text, marked[at])
        for at, text in texts.items()
        if digits("".join(_NUMBER.findall(text))) != digits(marked[at])
    ]


@pytest.mark.parametrize("case", [case for case in TABLES if "rows" in case])
def test_numbers_of_typed_table_have_owners(case):
    [table, *_] = reading.read_tables(case["text"], **case.get("options", {}))
    assert not list_wrong_marks(table)


def test_numbers_of_stored_tables_have_owners():
    options = "columns", "lengths", "angles", "convention"
    count = 0
    for case in QUESTIONS_ABOUT_TABLES:
        try:
            [table, *_] = reading.read_tables(
                case["answer"], **{key: case[key] for key in options if key in case}
            )
        except ArmError:
            continue
        count += 1
        assert not list_wrong_marks(table), case["answer"]
    assert count > 70  # the other tables (of 94) are refused or contain symbols of their arm


# The time is measured, because JavaScript cannot count the steps of a pattern. A text four times
# as long takes two to six times as long, and sixteen times if the number of steps is quadratic.
REPEATED = ["-", "[", "(", "{", ",", " ", "\t", "1", ".", "+", "a=", "a - ", "a_1 = ", "dict(",
            "Link(", "a(", "\\begin{", "Columns 1", "q1 = 1\n", "<a,", "(/ ", "0·0 ",
            "\\underbrace{", " = J_w = J_w"]  # fmt: skip


@pytest.mark.parametrize("kind", ["table", "numbers"])
@pytest.mark.parametrize("text", REPEATED)
def test_reading_time_grows_linearly_with_length(text, kind):
    question = {"as": kind, "text": text, "counts": [8_000, 32_000], "factor": 9}
    short, long = reading.ask_reader("pace", **question)
    assert long < 9 * short, (short, long)


@pytest.mark.parametrize("kind", ["table", "numbers"])
@pytest.mark.parametrize("gap", [" ", "\n", "\u2028", "\u00a0"])
def test_reading_time_grows_linearly_with_gap(gap, kind):
    question = {"as": kind, "text": gap, "counts": [8_000, 32_000], "factor": 9}
    short, long = reading.ask_reader("pace", before="0.5 1", behind="2 3", **question)
    assert long < 9 * short, (short, long)


def test_text_of_far_too_many_numbers_is_no_table():
    expected = "Your table: I find 1100 numbers; expected: at most 32 rows of four entries"
    with pytest.raises(ArmError, match=expected):
        reading.read_tables("1\n" * 1100)


def test_right_angles_of_table_become_formulas():
    quarters = "-3 * pi / 2", "-pi", "-pi/2", 0, "pi/2", "pi", "3 * pi / 2"
    for k, expected in zip(range(-3, 4), quarters, strict=True):
        for offset, is_exact in ((0.9e-4, True), (-0.9e-4, True), (1.1e-4, False)):
            angle = k * math.pi / 2 + offset
            [made] = Arm.from_table(f"0.1 {angle} d1 {-angle}", angles="rad", **ORDER).rows
            assert made.alpha == (expected if is_exact else pytest.approx(angle))
            assert made.joint.kind == "prismatic"
