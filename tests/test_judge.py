"""The page's judge: in JavaScript it says what the checkers say in Python, letter by letter."""

import contextlib
import io
import json
import os
from functools import partial

import numpy as np
import pytest
import sympy as sp

from helpers import checks, inverse, symbolic
from helpers.checks.door import numbers
from helpers.explorer import judge
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics
from helpers.reading.sentences import templates
from helpers.robots import ELBOW, PANDA, STANFORD
from tests import judge_words, motion_pastes, table_pastes
from tests.judge_motion import FORMS, path_of
from tests.judge_words import different, in_node, page_words, parts_of, python_words
from tests.node import needs_node
from tests.pastes import FORMATS, MATRICES, lines, pastes, wide

Q = [0.5, 0.7, -0.4]
# The elbow arm's Jacobian at Q by hand: c_1, s_1 of 0.5; r = 0.4 cos 0.7 + 0.3 cos 0.3, and so on.
ROWS = MATRICES[0]


def joined(*between):
    return lines(*between)(ROWS)


LATEX = joined(" & ", r" \\ ")
SPACED = joined(" & ", r" \\[4pt] ")
DECIMAL = joined("\t", "\n").replace(".", ",")
PASTES = {
    "numpy repr": joined(", ", "],\n       [", "array([[", "]])"),
    "numpy named": joined(", ", "],\n [", "J = np.array([[", "]])"),
    "numpy dtype": joined(", ", "], [", "array([[", "]], dtype=float32)"),
    "numpy print": joined("  ", "]\n [", "[[", "]]"),
    "numpy matrix": joined(", ", "], [", "np.matrix([[", "]])"),
    "lists": joined(", ", "], [", "[[", "]]"),
    "tuples": joined(", ", "), (", "((", "))"),
    "sympy": joined(", ", "], [", "Matrix([[", "]])"),
    "matlab typed": joined(" ", "; ", "J = [", "];"),
    "matlab commas": joined(", ", ";\n     ", "J = [", "]"),
    "matlab lines": joined("   ", "\n", "J = [\n", "\n];"),
    "matlab dots": joined(" ", "; ...\n", "[", "]"),
    "matlab print": "\nJ =\n\n" + wide(ROWS) + "\n",
    "matlab columns": "J =\n\n  Columns 1 through 2\n\n"
    + wide([line[:2] for line in ROWS])
    + "\n\n  Column 3\n\n"
    + wide([line[2:] for line in ROWS]),
    "bmatrix": rf"\begin{{bmatrix}} {LATEX} \end{{bmatrix}}",
    "pmatrix": rf"$$J = \begin{{pmatrix}} {LATEX} \\ \end{{pmatrix}}$$",
    "left matrix": rf"\left[\begin{{matrix}}{LATEX}\end{{matrix}}\right]",
    "array": rf"J(q) = \left( \begin{{array}}{{ccc}} {LATEX} \end{{array}} \right)",
    "tabular": rf"\begin{{tabular}}{{rrr}} \hline {LATEX} \\ \hline \end{{tabular}}",
    "latex spaced": rf"\begin{{bmatrix}} {SPACED} \end{{bmatrix}}",
    "bare latex": LATEX,
    "csv": joined(",", "\n"),
    "csv spaced": joined(", ", "\n"),
    "csv headed": "q1,q2,q3\n" + joined(",", "\n"),
    "csv end": joined(",", ",\n", "", ","),
    "semicolons": joined(";", "\n"),
    "decimal semicolons": joined(";", "\n").replace(".", ","),
    "windows": joined(",", "\r\n"),
    "excel": joined("\t", "\n"),
    "excel decimal": DECIMAL,
    "excel headed": "q1\tq2\tq3\n" + joined("\t", "\n"),
    "excel windows": DECIMAL.replace("\n", "\r\n") + "\r\n",
    "markdown": "| a | b | c |\n|--:|--:|--:|\n| " + joined(" | ", " |\n| ", "", " |"),
    "minus": joined("  ", "\n").replace("-", "−"),
    "no-break": joined("\u00a0\u00a0", "\n"),
    "short": joined(" ", "\n").replace(".0000", ".0").replace("0.", "."),
    "code fence": "```\n" + joined(" ", "\n") + "\n```",
}  # fmt: skip
REFUSED = ["", "hello", "1 2\n3", "[[1, 2], [3]]", "q_9 1 1", "import os", "__import__('os')",
           "1/0 2 3", "{" * 80, "sin( 1 2", "\\begin{pmatrix}", "1 2 nan", "θ_7 1 1",
           "'\"\\ \t", "1e400 1 1", "((1))" * 9,
           "[1 2; 3 4]'", "1,250\t0.5", "0,5 pi/2", "1.234.5 1", "1\t2\n3", "1,,2",
           '"1,250",2', "- 1, 2\n- 3, 4", "90 -45 30°", "#DIV/0!\t1", "sin^-1 1 2"]  # fmt: skip


def asked(typed, **options):
    return ELBOW, {"topic": "jacobian", "typed": typed, "q": Q, "options": options}


# As many as `make judge` asks where `make mutants` counts what the tests notice.
CASES, SEED = int(os.environ.get("JUDGE_CASES", "300")), 2026
SLICE = {"trace": 20, "corpus's traces": 5, "readings": 30}  # of the others 100: they take a second
SLICES = [(part, k) for part in parts_of(CASES) for k in range(0, part[2], SLICE.get(part[0], 100))]


@needs_node
@pytest.mark.parametrize(("part", "first"), SLICES, ids=str)
def test_its_words_are_pythons(part, first):
    asked = judge_words.answered(SEED, part)[first : first + SLICE.get(part[0], 100)]
    assert next(judge_words.unlike(asked), None) is None


@needs_node
def test_another_word_would_be_noticed():
    said = {**templates(), "J right": "The Jacobian of {arm} is good{where}{precision}."}
    ours, theirs = python_words(*asked(PASTES["csv"])), page_words([asked(PASTES["csv"])], said)[0]
    assert ours[:2] == theirs[:2] == ["right", []]
    assert ours[2] != theirs[2]


@needs_node
def test_pastes_are_read_as_they_were_meant_in_both_languages():
    wanted = "The Jacobian of Elbow arm is right at this pose to the 4 decimals you gave."
    read = zip(PASTES, page_words([asked(text) for text in PASTES.values()]), strict=True)
    for name, (_, _, words, _) in read:
        assert words.startswith(wanted), (name, words)
        assert python_words(*asked(PASTES[name]))[2] == words, name


@needs_node
@pytest.mark.parametrize("format_", FORMATS)
def test_a_hundred_pastes_of_each_format_are_read_as_they_were_meant(format_):
    given = list(pastes(format_))
    assert len(given) >= 100
    asked = [
        (ELBOW, {"topic": "read", "typed": text, "q": Q, "options": {}}) for _, text, _ in given
    ]
    for (name, text, wanted), (_, shape, words) in zip(given, page_words(asked), strict=True):
        ours = numbers(text, "your matrix")
        np.testing.assert_allclose(ours.values, wanted, rtol=1e-9, atol=1e-12, err_msg=name)
        np.testing.assert_array_equal(shape, ours.values.shape, err_msg=name)
        np.testing.assert_array_equal([float(x) for x in words.split()], ours.values.ravel(), name)


@needs_node
def test_what_cannot_be_read_is_refused_in_the_same_words():
    for text, said in zip(REFUSED, page_words([asked(text) for text in REFUSED]), strict=True):
        assert said == python_words(*asked(text)), text
        assert said[0] in ("refused", "wrong"), text
        assert len(said[2]) > 20, text


@pytest.mark.parametrize("arm", [ELBOW, STANFORD, PANDA.lock(3)], ids=str)
@pytest.mark.parametrize("form", [sp.expand_trig, sp.factor, sp.expand])
def test_a_sum_keeps_its_brackets_in_sympys_latex(arm, form):
    J = symbolic.jacobian(arm).applyfunc(form)
    assert checks.compare_jacobian(sp.latex(J), arm).agrees


def test_a_factor_of_one_is_no_scale():
    report = checks.compare_jacobian("[1*1/3, 2; 3, 4]", ELBOW, Q)
    assert report.causes == ("J.shape",)


def table(typed, **options):
    return ELBOW, {"topic": "table", "typed": typed, "options": options}


@needs_node
def test_tables_are_read_as_they_were_meant_in_both_languages():
    pastes = table_pastes.RIGHT
    said = page_words([table(text) for text in pastes.values()])
    for (name, text), theirs in zip(pastes.items(), said, strict=True):
        assert theirs[2].startswith("Your table describes the same arm as Elbow arm.\n") or (
            theirs[2] == "Your table describes the same arm as Elbow arm."
        ), (name, theirs[2])
        assert python_words(*table(text)) == theirs, name


@needs_node
def test_what_is_no_table_is_refused_in_the_same_words():
    refused = table_pastes.REFUSED
    said = page_words([table(text) for text in refused])
    for (text, words), theirs in zip(refused.items(), said, strict=True):
        assert theirs[0] == "refused", text
        assert words in theirs[2], text
        assert python_words(*table(text)) == theirs, text


@needs_node
@pytest.mark.parametrize(
    "options",
    [
        {"columns": "theta d a alpha"},
        {"columns": "a b c d"},
        {"lengths": "mm", "angles": "deg"},
        {"convention": "craig"},
        {"tolerance": 0.02},
    ],
    ids=str,
)
def test_tables_read_as_they_were_not_meant_are_judged_in_the_same_words(options):
    asked = [table(text, **options) for text in table_pastes.RIGHT.values()]
    assert not [*different(asked)]


# Joint angles and runs


def pose(typed, **options):
    question = {"topic": "pose", "typed": typed, "target": motion_pastes.POINT, "options": options}
    return ELBOW, question


@needs_node
@pytest.mark.parametrize("options", [{}, {"angles": "deg"}], ids=str)
def test_joint_angles_are_read_as_they_were_meant_in_both_languages(options):
    pastes = motion_pastes.IN_DEGREES if options else motion_pastes.ANGLES
    said = page_words([pose(text, **options) for text in pastes.values()])
    for (name, text), theirs in zip(pastes.items(), said, strict=True):
        assert theirs[2].startswith("The joints take the tip of Elbow arm there."), (name, theirs)
        assert python_words(*pose(text, **options)) == theirs, name


@needs_node
def test_no_tolerance_leaves_nothing_to_the_last_bit():
    """Two slips that give the same angles, of which rounding chose one."""
    question = {"topic": "pose", "typed": "0, -90, 180", "target": [-0.7, 0.0, 0.5]}
    asked = (ELBOW, {**question, "options": {"angles": "deg", "tolerance": 0.0}})
    assert not [*different([asked])]


@needs_node
def test_what_are_no_joint_angles_is_refused_in_the_same_words():
    said = page_words([pose(text) for text in motion_pastes.UNREAD])
    for text, theirs in zip(motion_pastes.UNREAD, said, strict=True):
        assert theirs[0] == "refused", text
        assert len(theirs[2]) > 20, text
        assert python_words(*pose(text)) == theirs, text


@needs_node
def test_the_branches_at_singular_poses_are_pythons():
    """Stretched, folded or with a straight wrist: joints are free, and branches merge."""
    rng, asked = np.random.default_rng(5), []
    for arm, solver in FORMS * 4:
        q = np.where(arm.turning, rng.uniform(-1.4, 1.4, arm.dof), 0.3)
        q[rng.choice(np.flatnonzero(arm.turning), 2, replace=False)] = 0
        T = forward_kinematics(arm, q)
        target = T if arm.dof == 6 else T[:3, 3]
        found = solver(arm, target)
        mine = found.q[found.valid].tolist()
        question = {"topic": "branches", "typed": mine, "target": target.tolist(), "options": {}}
        asked.append((arm, question))
    assert not [*different(asked)]
    right = [python_words(*one)[0] for one in asked]
    assert right.count("right") > 0.8 * len(right)


@needs_node
def test_runs_are_read_as_they_were_meant_in_both_languages():
    asked = dict(start=Q, radius=0.02, plane="zy", period=5.0, steps=40)
    path = path_of(ELBOW, asked)
    q = inverse.follow(partial(inverse.elbow, ELBOW), path.positions, Q)
    runs = [
        (ELBOW, {"topic": "trace", "typed": make(q), "path": asked, "options": {}})
        for make in motion_pastes.RUNS.values()
    ]
    said = page_words(runs)
    for name, (arm, question), theirs in zip(motion_pastes.RUNS, runs, said, strict=True):
        assert theirs[2].startswith("Elbow arm draws the path."), (name, theirs)
        assert python_words(arm, question) == theirs, name


# The page's questions

ASKED = ["jacobian", "torques", "table", "branches", "pose", "trace"]

OWN = "0, pi/2, 0.5, q1\n0.4, 0, 0, q2\n0.3, 0, 0, q3"
OWN_LETTERS = """-s_1*(L_1*c_2+ell*c_23) -c_1*(L_1*s_2+ell*s_23) -ell*c_1*s_23
c_1*(L_1*c_2+ell*c_23) -s_1*(L_1*s_2+ell*s_23) -ell*s_1*s_23
0 L_1*c_2+ell*c_23 ell*c_23
0 s_1 s_1
0 -c_1 -c_1
1 0 0"""
BY_LINK = [
    *judge.EXAMPLES,
    judge.traced(),
    {"ask": "jacobian", "arm": "ELBOW", "q": "30, 40, -20", "unit": "deg",
     "answer": PASTES["bmatrix"]},
    {"ask": "jacobian", "arm": "own", "table": OWN, "q": "0.5 0.7 -0.4", "answer": PASTES["csv"]},
    {"ask": "jacobian", "arm": "ELBOW", "q": "0.5, 0.7, -0.4", "frame": "2", "first": "omega",
     "answer": PASTES["matlab print"]},
    {"ask": "table", "arm": "ELBOW", "lengths": "m", "answer": table_pastes.RIGHT["craig"]},
    {"ask": "table", "arm": "ELBOW", "angles": "deg", "columns": "a alpha d theta",
     "convention": "standard", "answer": "0 90 0.5 q1\n0.4 0 0 q2\n0.2 0 0 q3"},
    {"ask": "branches", "arm": "ELBOW", "target": "0.3, 0.1, 0.7",
     "answer": "theta1 = 0.3, theta2 = 1.2, theta3 = -1.5"},
    {"ask": "branches", "arm": "UR10E", "unit": "deg", "answer": "0 0 0 0 0 0",
     "target": "[[1, 0, 0, 0.5], [0, 0, -1, -0.3], [0, 1, 0, 0.4]]"},
    {"ask": "branches", "arm": "STANFORD", "answer": "0.4 0.7 0.3 0.2 0.5 0.1",
     "target": "0.707 0.707 0 0.3\n-0.707 0.707 0 0.2\n0 0 1 0.4"},
    {"ask": "pose", "arm": "ELBOW", "target": "0.3, 0.1, 0.7",
     "answer": "('Theta1', 0.3), ('Theta2', -1.12 + pi/2), ('Theta3', 0.2)"},
    {"ask": "pose", "arm": "own", "table": OWN, "unit": "deg", "answer": "10, 20, 30",
     "target": "cos(q1), s_23, 0.4"},
    {"ask": "trace", "arm": "ELBOW", "q": "0.3, 0.4, 0.9", "radius": "0.05", "pace": "rest",
     "answer": "\n".join(f"{0.3 + 0.01 * k}, 0.4, 0.9" for k in range(40))},
    {"ask": "trace", "arm": "ELBOW", "q": "10, 20, 50", "unit": "deg", "plane": "xz", "steps": "40",
     "answer": "t,q1,q2,q3\n" + "\n".join(f"{k / 8},10,20,50" for k in range(40))},
    {"ask": "torques", "arm": "PANDA", "q": "0.1 0.2 0.3 -1 0.5 0.6 0.7", "answer": '"""\\ 1'},
    {"ask": "jacobian", "arm": "ELBOW", "q": "0.5, 0.7, -0.4", "answer": OWN_LETTERS,
     "values": "{'L₁': 4/10, \\ell: 0.3}"},
    {"ask": "jacobian", "arm": "own", "table": "0, pi/2, h, q1\nL1, 0, 0, q2\n0.3, 0, 0, q3",
     "q": "0.5 0.7 -0.4", "answer": PASTES["csv"], "values": "h = 1/2; L1 = 0.4"},
    {"ask": "table", "arm": "ELBOW", "answer": "0 pi/2 h q1\nb 0 0 q2\n0.3 0 0 q3 - phi",
     "values": "h = 0.5, b = 0.4, phi = -pi/3"},
]  # fmt: skip


@needs_node
def test_the_call_in_python_says_what_the_page_says():
    """Each question goes through a link first."""
    arms = [judge.listed(call) for call in judge.CALLS]
    answers = in_node(arms, [{"topic": "page", "fields": fields} for fields in BY_LINK])
    for fields, (grade, _, words, *call) in zip(BY_LINK, answers, strict=True):
        if grade == "refused":
            assert "Panda: your torques is" in words, words
            continue
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            exec(call[0], {})
        assert said.getvalue() == f"{words}\n", fields


@needs_node
def test_the_examples_name_their_mistakes():
    arms = [judge.listed(call) for call in judge.CALLS]
    examples = [*judge.EXAMPLES, judge.traced()]
    asked = [{"topic": "page", "fields": fields} for fields in examples]
    named = [causes for _, causes, *_ in in_node(arms, asked)]
    assert [fields["ask"] for fields in examples] == ASKED
    assert named == [
        ["J.z_i angular"],
        ["tau.force sign"],
        ["table.craig"],
        ["ik.plus for minus", "ik.sign:q_3"],
        ["ik.offset:q_4"],
        ["trace.backwards"],
    ]


def test_the_stub_holds_its_arms_and_what_is_given():
    start, end = judge.stub()
    assert start == '<div class="arm-judge">'
    assert end.count("</script>") == 1
    start, end = judge.stub({"ask": "torques", "arm": "PANDA, UR10E", "q": "</script>"})
    data = json.loads(
        end.removeprefix('<script type="application/json">').partition("</script>")[0]
    )
    assert [arm["key"] for arm in data["arms"]] == ["PANDA", "UR10E"]
    assert data["given"] == {"ask": "torques", "q": "</script>"}
    assert start == '<div class="arm-judge small">'
    with pytest.raises(ArmError, match="no arm is called 'HAL'"):
        judge.stub({"arm": "HAL"})
