"""Test pasted answers in Python and on the page, which runs under Node.js here."""

import json
import re
from functools import cache

import numpy as np
import pytest
import sympy as sp

from helpers import checks, inverse, symbolic
from helpers.arm import Arm, Body, fixed, revolute
from helpers.checks.compare import read_numbers
from helpers.explorer import judge
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion import circle_below, rest_to_rest
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E
from helpers.statics import gravity_torque
from tests.cases import MATRICES, QUESTIONS, expect_failures, questions_about, typed_fields
from tests.node import ask_node, needs_node
from tests.test_book import ROOT

REFUSED = ["", "hello", "1 2\n3", "[[1, 2], [3]]", "q_9 1 1", "import os", "__import__('os')",
           "1/0 2 3", "{" * 80, "sin( 1 2", "\\begin{pmatrix}", "1 2 nan", "θ_8 1 1",
           "'\"\\ \t", "1e400 1 1", "1.234.5 1", "1\t2\n3", "1,,2", "#DIV/0!\t1",
           "sin^-1 1 2"]  # fmt: skip


@pytest.mark.parametrize("case", MATRICES, ids=range(len(MATRICES)))
def test_pasted_matrix_is_read_or_refused(case):
    if "refused" in case:
        with pytest.raises(ArmError, match=case["refused"]):
            read_numbers(case["text"], "your matrix")
        return
    typed = read_numbers(case["text"], "your matrix")
    np.testing.assert_allclose(typed.values, case["rows"], rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(typed.units, case.get("units", typed.units), rtol=1e-6)


def test_pasted_matrix_with_nan_is_rejected():
    with pytest.raises(ArmError, match="finite"):
        read_numbers("0.1 nan 0.3", "your matrix")


@pytest.mark.parametrize("arm", [ELBOW, STANFORD, PANDA.lock(3)], ids=str)
@pytest.mark.parametrize("form", [sp.expand_trig, sp.factor, sp.expand])
def test_sympy_latex_of_sums_is_read(arm, form):
    J = symbolic.jacobian(arm).applyfunc(form)
    assert checks.compare_jacobian(sp.latex(J), arm).agrees


@pytest.mark.parametrize("answer", [np.zeros((33, 3)), "0.1 0.2 0.3\n" * 33], ids=["array", "text"])
def test_more_joint_vectors_than_branches_are_refused(answer):
    with pytest.raises(ArmError, match="33 joint vectors; expected: one for each branch"):
        checks.compare_branches(answer, inverse.elbow(ELBOW, [0.3, 0.2, 0.7]))


def test_far_too_many_numbers_for_branches_are_refused():
    with pytest.raises(ArmError, match="I find 1000 numbers"):
        checks.compare_branches("[1,2]," * 500, inverse.elbow(ELBOW, [0.3, 0.2, 0.7]))


@pytest.mark.parametrize("line", ["# a", "```", "q1", "The arm stands.", ""], ids=repr)
def test_far_too_many_lines_are_refused(line):
    text = "1 2 3" + f"\n{line}" * 599 + "\n4 5 6"
    with pytest.raises(ArmError, match="your Jacobian: the text has 601 lines"):
        checks.compare_jacobian(text, ELBOW, [0.5, 0.7, -0.4])
    with pytest.raises(ArmError, match="Your table: the text has 601 lines"):
        checks.compare_tables(text, ELBOW)


def test_answer_among_600_lines_is_read():
    angles = "0.5 0.7 -0.4"
    text = "The arm stands.\n" * 300 + "\n" + angles + "\n" + "Its tool hangs.\n" * 298
    assert read_numbers(text, "your angles").values.tolist() == [[0.5, 0.7, -0.4]]


def test_torque_of_a_single_joint_is_read():
    arm = Arm(
        "pendulum",
        [fixed(alpha="pi/2"), revolute(a=0.0580782)],
        bodies=[Body(0, (0, 0, 0)), Body(1, (0, 0, 0))],
    )
    # 9.81 N * 0.0580782 m * cos(q) is 0.5 at q = 0.5 and 0 at q = pi/2
    assert checks.compare_torques("0.50000", arm, [0.5]).agrees
    assert checks.compare_torques("0.50000\n0.00000", arm, [[0.5], [np.pi / 2]]).agrees
    assert checks.compare_torques("0.40000", arm, [0.5]).grade == "wrong"


# Questions asked on the page

ASKED = ["jacobian", "torques", "table", "branches", "pose", "trace"]


def judge_on_page(questions):
    """Return the page's grade, causes and words, or its error, for each question."""
    arms = [judge.list_entry(call) for call in judge.CALLS]
    return ask_node("judge_page.mjs", {"arms": arms, "questions": questions})


VALUES = {
    "{'L₁': 4/10, \\ell: 0.3}": {"L_1": 0.4, "ell": 0.3},
    "h = 1/2; L1 = 0.4": {"h": 0.5, "L1": 0.4},
    "h = 0.5, b = 0.4, phi = -pi/3": {"h": 0.5, "b": 0.4, "phi": -np.pi / 3},
}
OPTIONS = ("columns", "lengths", "angles", "convention", "wrench")


def judge_in_python(given):
    """Return the verdict on the fields of the page's form, asked in Python."""
    ask, mine, q = given["ask"], given["answer"], given.get("q")
    how = {"angles": given.get("unit", "rad")} if ask != "table" else {}
    how |= {key: given[key] for key in OPTIONS if key in given}
    values = VALUES.get(given.get("values"))
    how |= {"values": values} if values else {}
    if given["arm"] == "own":
        arm = Arm.from_table(given["table"], name="the arm asked about", values=values)
    else:
        arm = judge.catalogue_arm(given["arm"])
    if ask == "jacobian":
        how |= {
            "frame": int(given.get("frame", 0)),
            "angular_first": given.get("first") is not None,
        }
        return checks.compare_jacobian(mine, arm, q, **how)
    if ask == "torques":
        how["wrench"] = np.array(re.findall(r"[-.\d]+", given.get("wrench", "0 " * 6)), float)
        return checks.compare_torques(mine, arm, q, **how)
    if ask == "table":
        return checks.compare_tables(mine, arm, **how)
    if ask == "branches":
        return checks.compare_branches(mine, branches(arm, given["target"]), **how)
    if ask == "pose":
        return checks.compare_pose(mine, arm, given["target"], **how)
    steps = int(given.get("steps", len(mine.splitlines()) - 1))
    start = np.array([float(x) for x in q.split(",")])
    start = np.radians(start) if how["angles"] == "deg" else start
    path = circle_below(
        arm, start, float(given.get("radius", 0.1)), given.get("plane", "zy"), 5, steps
    )
    path = rest_to_rest(path) if "pace" in given else path
    return checks.compare_trace(mine, arm, path, **how)


def branches(arm, typed):
    """Return the branches of a typed point, or of the rigid pose nearest to a typed matrix."""
    target = np.array(read_numbers(typed, "target").values).ravel()
    if target.size == 3:
        return inverse.elbow(arm, target)
    T = np.eye(4)
    T[:3] = target.reshape(3, 4)
    u, _, v = np.linalg.svd(T[:3, :3])
    T[:3, :3] = u @ v
    return (inverse.stanford if arm is STANFORD else inverse.ur)(arm, T)


@needs_node
def test_page_and_python_print_the_same_report():
    """The page gets each question by a link. Advice names an argument in Python, a button there."""
    advice = ("- If that is what you mean, ", "- The arm in your joints is report.")
    asked = [*judge.EXAMPLES, judge.trace_example(), *map(typed_fields, QUESTIONS)]
    for given, answer in zip(asked, judge_on_page(asked), strict=True):
        found = summarize_verdict(given)
        if "error" in answer:
            assert found["grade"] == "refused", given
            assert len(answer["error"]) > 20, answer
            continue
        lines = found["words"].splitlines()
        assert [x for x in lines if not x.startswith(advice)] == answer["words"].splitlines(), given


def summarize_verdict(given):
    """Return grade, words and causes of Python's verdict, from a cache."""
    return _summarize_verdict(json.dumps(given))


@cache
def _summarize_verdict(given):
    try:
        report = judge_in_python(json.loads(given))
    except ArmError as refused:
        return {"grade": "refused", "words": str(refused), "causes": ()}
    return {"grade": report.grade, "words": str(report), "causes": report.causes}


@pytest.mark.parametrize(
    "case", expect_failures(QUESTIONS), ids=lambda case: f"{case['ask']}, {case['about']}"
)
def test_question_gets_expected_verdict(case):
    found = summarize_verdict(typed_fields(case))
    assert found["grade"] == case["grade"], found
    if cause := case.get("cause"):
        assert any(one == cause or one.startswith(f"{cause}:") for one in found["causes"]), found
    assert case.get("cause") != "" or not found["causes"], found
    for words in case.get("said", ()):
        assert words in found["words"], found
    for words in case.get("unsaid", ()):
        assert words not in found["words"], found


# Degrees that are read as radians

UR_DEGREES = np.degrees([0.3, -1.1, 1.4, -0.8, 0.9, 0.2])
COMPARE_AT = {
    "jacobian": lambda q, at: checks.compare_jacobian(jacobian(UR10E, at).round(4), UR10E, q),
    "torques": lambda q, at: checks.compare_torques(gravity_torque(UR10E, at).round(3), UR10E, q),
    "pose": lambda q, at: checks.compare_pose(q, UR10E, forward_kinematics(UR10E, at)),
    "branches": lambda q, at: checks.compare_branches(
        q, inverse.ur(UR10E, forward_kinematics(UR10E, at))
    ),
}


def write_degrees(decimals):
    text = ", ".join(f"{x:.{decimals}f}" for x in UR_DEGREES)
    return text, np.radians([float(x) for x in text.split(",")])


@pytest.mark.filterwarnings("ignore:.*more than four turns")  # of helpers.statics
@pytest.mark.parametrize("topic", COMPARE_AT)
@pytest.mark.parametrize("decimals", [0, 1, 2, 4])
def test_degrees_read_as_radians_are_named(topic, decimals):
    text, exact = write_degrees(decimals)
    rounded = np.radians(UR_DEGREES) if decimals else exact
    for at in (exact, rounded):
        report = COMPARE_AT[topic](text, at)
        assert report.grade == "wrong"
        assert [name.split(".")[1] for name in report.causes] == ["degrees"]
        assert 'say angles="deg"' in str(report)


def test_radians_read_as_degrees_are_named():
    q = np.radians(UR_DEGREES).round(4)
    T = forward_kinematics(UR10E, np.radians(UR_DEGREES))
    for report in (
        checks.compare_pose(q, UR10E, T, angles="deg"),
        checks.compare_branches(q, inverse.ur(UR10E, T), angles="deg"),
    ):
        assert (report.grade, report.causes) == ("wrong", ("ik.radians",))
        assert report.advice == ('If that is what you mean, say angles="rad"',)


@pytest.mark.parametrize("topic", COMPARE_AT)
def test_wrong_answer_asks_about_angle_above_turn(topic):
    text, exact = write_degrees(2)
    report = COMPARE_AT[topic](text, exact + 0.1 * np.arange(1, 7))
    assert (report.grade, report.causes) == ("wrong", ())
    assert "q_1 = 17.19 rad is more than a whole turn. Is it in degrees?" in report.notes
    assert report.advice == ('If that is what you mean, say angles="deg"',)


@pytest.mark.parametrize("topic", COMPARE_AT)
def test_right_answer_with_whole_turns_asks_nothing(topic):
    q = np.radians(UR_DEGREES) + 2 * np.pi
    report = COMPARE_AT[topic](q.round(6), q.round(6))
    assert (report.grade, report.advice) == ("right" if topic != "branches" else "so far", ())


@needs_node
def test_page_examples_name_their_mistakes():
    examples = [*judge.EXAMPLES, judge.trace_example()]
    assert [fields["ask"] for fields in examples] == ASKED
    assert [answer["causes"] for answer in judge_on_page(examples)] == [
        ["J.z_i angular"],
        ["tau.force sign"],
        ["table.craig"],
        ["ik.mixed", "ik.plus for minus"],
        ["ik.offset:q_4"],
        ["trace.backwards"],
    ]


@needs_node
def test_answers_are_judged_in_joint_angles_of_table():
    """The table reverses axes 2 and 3. The Jacobian is the same as in tests/browser."""
    joints = "R 0 -1.57079632679 0.5 0, R 0.4 0 0 0, R 0.3 0 0 0"
    J = "-0.2841 0.3039 0.0778; 0.52 0.166 0.0425; 0 -0.5925 -0.2866; 0 -0.4794 -0.4794; "
    J += "0 0.8776 0.8776; 1 0 0"
    asked = {"ask": "jacobian", "arm": "ELBOW", "q": "0.5, -0.7, 0.4", "answer": J}
    other_arm = joints.replace("0.4", "0.41")
    own, plain, other = judge_on_page(
        [{**asked, "joints": joints}, asked, {**asked, "joints": other_arm}]
    )
    assert (own["grade"], plain["grade"]) == ("right", "wrong")
    assert "another arm: forget them" in other["error"]


@needs_node
def test_pose_in_own_joint_angles_reaches_tool_frame():
    """The table turns the last frame, so that the page must convert the joint angles."""
    mine = PANDA.with_row(7, d=0.207).with_row(6, theta=0.4)
    joints = ", ".join(
        f"R {mine.number(row.a)} {mine.number(row.alpha)} {mine.number(row.d)} {row.theta}"
        for row in mine.rows
    )
    joint_map = checks.compare_tables(mine, PANDA).joint_map
    q = np.array([0.3, -0.4, 0.5, 1.2, -0.6, 0.7, 0.2])
    own = np.array(joint_map.signs) * (q - joint_map.offsets)
    target = forward_kinematics(PANDA, q)[:3].round(6).tolist()
    asked = {"ask": "pose", "arm": "PANDA", "target": str(target), "joints": joints}
    answers = [{**asked, "answer": ", ".join(map(str, x.round(6)))} for x in (own, q)]
    assert [answer["grade"] for answer in judge_on_page(answers)] == ["right", "wrong"]


# Terms that only Python programmers know: shapes, keywords, names and values. Quotations,
# placeholders of messages and the remark about NumPy's print are exempt.
PYTHON = re.compile(
    r"shape \(|\(\d+,\)|\(\d, \d\)|\.\.\., |\w=[^ ]|\b(np\.|report\.|arm\.|robots\.|lambda|dof|None"
    r"|True|False|dtype|tuple|array|argument|Body|numpy|\w+Error|compare_\w+|angular_first)\b"
)
QUOTED = re.compile(
    r"""'[^']*'|"[^"]*"|“[^”]*”|\{call\}\(.*\)|\{\w+\}|\(NumPy.*\)"""  # student's code
)
TYPED = ("answer", "q", "target", "table", "values", "wrench", "steps", "radius")
COUNTS = ["5", "1 2", "1 2 3 4", "[1 2; 3 4]", "[1, 2, 3], [4, 5, 6]", "0.1 ... 3", "± 1 2"]


def test_page_sentences_use_no_python_terms():
    sentences = json.loads((ROOT / "judge" / "sentences.json").read_text("utf-8"))
    assert {k: text for k, text in sentences.items() if PYTHON.search(QUOTED.sub("", text))} == {}


@needs_node
def test_unreadable_input_message_uses_no_python_terms():
    own, framed, *_ = map(typed_fields, questions_about("by link"))
    asked = [*judge.EXAMPLES, judge.trace_example(), {**framed, "ask": "torques"}, own, framed]
    asked += [{**judge.EXAMPLES[3], "arm": "PANDA"}]  # the Panda has no closed form
    bad = [{**one, field: text} for one in asked
           for field in TYPED if field in one for text in [*REFUSED, *COUNTS]]  # fmt: skip
    for given, said in zip(bad, judge_on_page(bad), strict=True):
        words = said.get("error") or said["words"]
        assert given["answer"] not in REFUSED or len(said["error"]) > 20, given
        assert not PYTHON.search(QUOTED.sub("", words)), (given, words)
