"""What people paste, through the judge's two doors: Python's, and the page's under Node.js."""

import json
import random
import re
from functools import partial

import numpy as np
import pytest
import sympy as sp

from helpers import checks, inverse, symbolic
from helpers.arm import Arm
from helpers.checks.compare import numbers
from helpers.explorer import judge
from helpers.inputs import ArmError
from helpers.motion import circle_below, rest_to_rest
from helpers.robots import ELBOW, PANDA, STANFORD
from tests import motion_pastes, table_pastes
from tests.brought import BROUGHT
from tests.node import ask_node, needs_node
from tests.pastes import MATRICES, PROGRAMS, lines
from tests.test_book import ROOT

Q = [0.5, 0.7, -0.4]
# The elbow arm's Jacobian at Q by hand: c_1, s_1 of 0.5; r = 0.4 cos 0.7 + 0.3 cos 0.3, and so on.
ROWS = MATRICES[0]
CSV = lines(",", "\n")(ROWS)
REFUSED = ["", "hello", "1 2\n3", "[[1, 2], [3]]", "q_9 1 1", "import os", "__import__('os')",
           "1/0 2 3", "{" * 80, "sin( 1 2", "\\begin{pmatrix}", "1 2 nan", "θ_8 1 1",
           "'\"\\ \t", "1e400 1 1", "1.234.5 1", "1\t2\n3", "1,,2", "#DIV/0!\t1",
           "sin^-1 1 2"]  # fmt: skip


@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("seed", range(2))
def test_pastes_of_each_program_are_read_as_they_were_meant(program, seed):
    for text, wanted in PROGRAMS[program].pastes(random.Random(seed)):
        found = numbers(text, "your matrix").values
        np.testing.assert_allclose(found, wanted, rtol=1e-6, atol=1e-9, err_msg=text)


@pytest.mark.parametrize("arm", [ELBOW, STANFORD, PANDA.lock(3)], ids=str)
@pytest.mark.parametrize("form", [sp.expand_trig, sp.factor, sp.expand])
def test_a_sum_keeps_its_brackets_in_sympys_latex(arm, form):
    J = symbolic.jacobian(arm).applyfunc(form)
    assert checks.compare_jacobian(sp.latex(J), arm).agrees


# Joint angles and runs


@pytest.mark.parametrize("name", motion_pastes.ANGLES)
def test_joint_angles_are_read_as_they_were_meant(name):
    report = checks.compare_pose(motion_pastes.ANGLES[name], ELBOW, motion_pastes.POINT)
    assert report.headline.startswith("The joints take the tip of Elbow arm there.")


@pytest.mark.parametrize("name", motion_pastes.RUNS)
def test_a_run_is_read_as_it_was_meant(name):
    path = circle_below(ELBOW, Q, 0.02, "zy", 5.0, 40)
    q = inverse.follow(partial(inverse.elbow, ELBOW), path.positions, Q)
    report = checks.compare_trace(motion_pastes.RUNS[name](q), ELBOW, path)
    assert report.headline.startswith("Elbow arm draws the path.")


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
    {"ask": "jacobian", "arm": "own", "table": OWN, "q": "0.5 0.7 -0.4", "answer": CSV},
    {"ask": "jacobian", "arm": "ELBOW", "q": "0.5, 0.7, -0.4", "frame": "2", "first": "omega",
     "answer": lines("  ", "\n", "J =\n\n")(ROWS)},
    {"ask": "table", "arm": "ELBOW", "lengths": "m", "answer": table_pastes.RIGHT["craig"]},
    {"ask": "table", "arm": "ELBOW", "angles": "deg", "columns": "a alpha d theta",
     "convention": "standard", "answer": "0 90 0.5 q1\n0.4 0 0 q2\n0.2 0 0 q3"},
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
     "q": "0.5 0.7 -0.4", "answer": CSV, "values": "h = 1/2; L1 = 0.4"},
    {"ask": "table", "arm": "ELBOW", "answer": "0 pi/2 h q1\nb 0 0 q2\n0.3 0 0 q3 - phi",
     "values": "h = 0.5, b = 0.4, phi = -pi/3"},
]  # fmt: skip


def in_page(questions):
    arms = [judge.listed(call) for call in judge.CALLS]
    return ask_node("judge_page.mjs", {"arms": arms, "questions": questions})


VALUES = {
    "{'L₁': 4/10, \\ell: 0.3}": {"L_1": 0.4, "ell": 0.3},
    "h = 1/2; L1 = 0.4": {"h": 0.5, "L1": 0.4},
    "h = 0.5, b = 0.4, phi = -pi/3": {"h": 0.5, "b": 0.4, "phi": -np.pi / 3},
}
OPTIONS = ("columns", "lengths", "angles", "convention", "wrench")


def in_python(fields):
    """The same question as Python asks it, of the arm that is called so."""
    ask, mine, q = fields["ask"], fields["answer"], fields.get("q")
    how = {"angles": fields.get("unit", "rad")} if ask != "table" else {}
    how |= {key: fields[key] for key in OPTIONS if key in fields}
    how |= {"values": VALUES[fields["values"]]} if "values" in fields else {}
    if fields["arm"] == "own":
        arm = Arm.from_table(fields["table"], name="the arm asked about", values=how.get("values"))
    else:
        arm = judge.catalogue_arm(fields["arm"])
    if ask == "jacobian":
        how |= {
            "frame": int(fields.get("frame", 0)),
            "angular_first": fields.get("first") is not None,
        }
        return checks.compare_jacobian(mine, arm, q, **how)
    if ask == "torques":
        how["wrench"] = np.array(re.findall(r"[-.\d]+", fields.get("wrench", "0 " * 6)), float)
        return checks.compare_torques(mine, arm, q, **how)
    if ask == "table":
        return checks.compare_tables(mine, arm, **how)
    if ask == "branches":
        return checks.compare_branches(mine, branches(arm, fields["target"]), **how)
    if ask == "pose":
        return checks.compare_pose(mine, arm, fields["target"], **how)
    steps = int(fields.get("steps", len(mine.splitlines()) - 1))
    start = np.array([float(x) for x in q.split(",")])
    start = np.radians(start) if how["angles"] == "deg" else start
    path = circle_below(
        arm, start, float(fields.get("radius", 0.1)), fields.get("plane", "zy"), 5, steps
    )
    path = rest_to_rest(path) if "pace" in fields else path
    return checks.compare_trace(mine, arm, path, **how)


def branches(arm, typed):
    """Those of a point, or of a pose whose axes are made perpendicular as the nearest ones."""
    target = np.array(numbers(typed, "target").values).ravel()
    if target.size == 3:
        return inverse.elbow(arm, target)
    T = np.eye(4)
    T[:3] = target.reshape(3, 4)
    u, _, v = np.linalg.svd(T[:3, :3])
    T[:3, :3] = u @ v
    return (inverse.stanford if arm is STANFORD else inverse.ur)(arm, T)


@needs_node
def test_the_page_says_what_python_says():
    """Each question goes through a link first. Advice is an argument here, a button there."""
    advice = ("- If that is what you mean, ", "- The arm in your joints is report.")
    for fields, answer in zip(BY_LINK, in_page(BY_LINK), strict=True):
        if "error" in answer:
            assert len(answer["error"]) > 20, answer
            continue
        lines = str(in_python(fields)).splitlines()
        assert [x for x in lines if not x.startswith(advice)] == answer["words"].splitlines(), (
            fields
        )


@pytest.mark.parametrize(("finding", "fields", "words"), BROUGHT)
def test_what_people_bring_is_told_in_python(finding, fields, words):
    try:
        said = str(in_python(fields))
    except ArmError as refused:
        said = str(refused)
    assert words in said


@needs_node
def test_the_examples_name_their_mistakes():
    examples = [*judge.EXAMPLES, judge.traced()]
    assert [fields["ask"] for fields in examples] == ASKED
    assert [answer["causes"] for answer in in_page(examples)] == [
        ["J.z_i angular"],
        ["tau.force sign"],
        ["table.craig"],
        ["ik.mixed", "ik.plus for minus"],
        ["ik.offset:q_4"],
        ["trace.backwards"],
    ]


# What only a reader of Python knows: shapes, keywords, names and values. Not what is quoted or put
# in, and a print from NumPy is told about to who has one.
PYTHON = re.compile(
    r"shape \(|\(\d+,\)|\(\d, \d\)|\.\.\., |\w=[^ ]|\b(np\.|report\.|arm\.|robots\.|lambda|dof|None"
    r"|True|False|dtype|tuple|array|argument|Body|numpy|\w+Error|compare_\w+|angular_first)\b"
)
QUOTED = re.compile(r"""'[^']*'|"[^"]*"|“[^”]*”|\{\w+\}|\(NumPy.*\)""")
TYPED = ("answer", "q", "target", "table", "values", "wrench", "steps", "radius")
COUNTS = ["5", "1 2", "1 2 3 4", "[1 2; 3 4]", "[1, 2, 3], [4, 5, 6]", "0.1 ... 3", "± 1 2"]


def test_no_sentence_that_the_page_may_say_speaks_python():
    """All but those that Python's own doors say."""
    keys = json.loads((ROOT / "judge" / "sentences.json").read_text("utf-8"))
    doors = "".join(file.read_text("utf-8") for file in (ROOT / "helpers/checks").glob("*.py"))
    told = {key: words for key, words in keys.items() if f'say("{key}"' not in doors}
    assert len(told) > 0.9 * len(keys)
    assert {k: w for k, w in told.items() if PYTHON.search(QUOTED.sub("", w))} == {}


@needs_node
def test_what_cannot_be_read_is_refused_without_speaking_python():
    asked = [*judge.EXAMPLES, judge.traced(), {**BY_LINK[7], "ask": "torques"}, *BY_LINK[6:8]]
    asked += [{**judge.EXAMPLES[3], "arm": "PANDA"}]  # of which there is no formula
    bad = [{**one, field: text} for one in asked
           for field in TYPED if field in one for text in [*REFUSED, *COUNTS]]  # fmt: skip
    for fields, said in zip(bad, in_page(bad), strict=True):
        words = said.get("error") or said["words"]
        assert fields["answer"] not in REFUSED or len(said["error"]) > 20, fields
        assert not PYTHON.search(QUOTED.sub("", words)), (fields, words)
