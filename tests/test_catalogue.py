"""Test that the checks name each mistake of the corpus and ignore no number of an answer."""

import json
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from helpers import checks
from helpers.arm import Body
from helpers.inputs import ArmError
from helpers.robots import ELBOW, UR10E
from helpers.statics import static_torque
from tests.cases import QUESTIONS, typed_fields
from tests.corpus import jacobians, tables, torques
from tests.corpus.arms import KNOWN, draw_configuration
from tests.corpus.machine import Machine
from tests.mixed import add_masses, make_arm
from tests.test_judge import judge_in_python

# For some planted mistakes the judge names another cause that is also true. Planted and named
# mistakes are given by the beginnings of their keys.
ALSO = {
    "table.twist": ("table.no twist",),
    "table.sign:alpha": ("table.twist",),
    "table.a and d": ("table.a and d in row",),
}


def names_mistake(report, mistakes, typed):
    """Return whether a report names a mistake that gives the typed numbers."""
    true = [key for key, numbers in mistakes.items() if tables.alike(numbers, typed)]
    also = tuple(key for cause in true for start, keys in ALSO.items()
                 if cause.startswith(start) for key in keys)  # fmt: skip
    named = [causes.split(" + ")[0] for causes in report.causes]
    return any(cause in true or cause.startswith(also) for cause in named)


def visible(mistakes, right):
    """Yield the mistakes that change a shape, or an entry by more than 5e-3."""
    for key, typed in mistakes.items():
        if typed.shape != right.shape or np.abs(typed - right).max() > 5e-3:
            yield key, typed


HERE = Path(__file__).parent
CAUSE = re.compile(
    r'(?:makeCause|make\w*Mistake|with\w*Options)\(\s*"([^"]+)"|\["((?:J|ik|pose|table|tau|trace)\.[^"]+)"'
)
# These keys describe wrong entries. They are no causes.
DESCRIPTIONS = {"J.entries", "J.entry signs"}


def test_every_cause_has_a_test_case():
    """The test case may be in tests/cases.json, in the corpus, or in a test file."""
    files = [*HERE.glob("*.py"), *HERE.glob("corpus/*.py"), HERE / "cases.json"]
    planted = "".join(file.read_text("utf-8") for file in files)
    sources = (HERE.parent / "judge").glob("*/*.js")
    matches = CAUSE.findall("".join(file.read_text("utf-8") for file in sources))
    keys = {key for pair in matches for key in pair if "." in key} - DESCRIPTIONS
    assert len(keys) > 80
    sentences = json.loads((HERE.parent / "judge" / "sentences.json").read_text("utf-8"))
    assert not keys - {*sentences}, "add a sentence for each to judge/sentences.json"
    untested = {key for key in keys if not re.search(re.escape(key) + '(?:[":]| [+])', planted)}
    assert not untested, "add a question with each cause to tests/cases.json"


@pytest.mark.parametrize("name", ["UR10E_HOMEWORK", "STANFORD", "PANDA.lock(3)"])
def test_jacobian_mistake_is_named(name):
    m, rng = KNOWN[name], np.random.default_rng(3)
    q = draw_configuration(m, rng)
    right = m.jacobian(q)
    mistakes = dict([*jacobians.before(m, q, rng), *jacobians.of_tables(m, q, rng)])
    mistakes |= {key: write(right) for key, write in jacobians.after(m, q, rng)}
    for key, typed in visible(mistakes, right):
        report = checks.compare_jacobian(typed.round(5), make_arm(m), q)
        assert names_mistake(report, mistakes, typed), (key, report)


@pytest.mark.parametrize("name", ["PANDA", "STANFORD"])
def test_torque_mistake_is_named(name):
    m, rng = KNOWN[name], np.random.default_rng(4)
    q, links, F = (
        draw_configuration(m, rng),
        torques.bodies(m, rng),
        np.array([3, -5, 8, 1, -2, 0.5]),
    )
    mistakes = dict(torques.mistakes(m, links, q, F, rng))
    right = torques.weight(m, links, q) - torques.force(m, F, q)
    arm = make_arm(m) if name == "PANDA" else add_masses(m, links)
    for key, typed in visible(mistakes, right):
        report = checks.compare_torques(typed.round(5), arm, q, F)
        assert names_mistake(report, mistakes, typed), (key, report)


@pytest.mark.parametrize("name", ["PANDA.lock(3)", "UR10E_HOMEWORK"])
def test_table_mistake_is_named(name):
    m = KNOWN[name]
    mistakes = tables.mistakes(m, np.random.default_rng(5))
    typed = {key: tables.numbers(rows) for key, rows in mistakes.items()}
    for key, rows in mistakes.items():
        report = checks.compare_tables(make_arm(Machine(rows)), make_arm(m))
        free = report.mark or report.figures.get("same machine")  # see tests/test_tables.py
        assert names_mistake(report, typed, typed[key]) or free, (key, report)


RIGHT = [case for case in QUESTIONS if case["grade"] == "right" and case["answer"]]
BLANK_OR_HIDDEN = re.compile(r"<[a-z/][^<>]*>|# .*\n?|(\s)")
DICTIONARIES = next(case for case in RIGHT if case["answer"].startswith("{'a'"))


@settings(max_examples=40)
@example(case=RIGHT[0], place=0.0)
@example(case=DICTIONARIES, place=0.0)
@example(case=DICTIONARIES, place=1.0)
@given(case=st.sampled_from(RIGHT), place=st.floats(0, 1))
def test_stray_number_is_never_ignored(case, place):
    """A right answer with an extra number is refused or wrong, or the number is shown as ignored.

    Its line is quoted, or the text with its numbers marked calls it a label or no part of the
    answer. Blanks within a tag of HTML do not count, since no reader sees a number there, nor do
    those of a comment.
    """
    text = case["answer"]
    blanks = [0, *(blank.start(1) for blank in BLANK_OR_HIDDEN.finditer(text + "\n") if blank[1])]
    at = blanks[round(place * (len(blanks) - 1))]
    try:
        report = judge_in_python(
            {**typed_fields(case), "answer": f"{text[:at]} 99.125 {text[at:]}"}
        )
    except ArmError:
        return
    owners = [number.owner for number in report.read if "99.125" in number.text]
    is_reported = "99.125" in str(report) or owners in (["context"], ["label"])
    assert report.grade == "wrong" or report.mark or is_reported, (report, owners)


def test_link_without_joint_kind_is_rejected():
    with pytest.raises(ArmError, match="0 for a joint that turns or 1 for one that slides"):
        checks.compare_tables("L1 = Link([0 0.5 0 pi/2]); L2 = Link([0 0 0.4 0 99.125])", ELBOW)


Q, PUSH = [0.3, -1.1, 1.4, -0.8, 0.9, 0.2], [0, 0, -20, 0, 0, 0]


def test_answer_number_selects_one_of_two_answers():
    right = static_torque(UR10E, Q, PUSH).round(4)
    text = f"{right.tolist()}\nor\n{(2 * right).tolist()}"
    for number, agrees in ((1, True), (2, False)):
        assert checks.compare_torques(text, UR10E, Q, PUSH, answer_number=number).agrees is agrees


def test_small_gravity_error_is_not_rounding():
    """With g = 9.8 in place of 9.81 the torques of light links are off by a thousandth."""
    light = UR10E.with_bodies([Body(body.mass / 40, body.com) for body in UR10E.bodies])
    push = [0, 0, -20, 3, 0, 0]
    mine = static_torque(light, Q, push) - 0.01 / 9.81 * static_torque(light, Q, [0] * 6)
    assert checks.compare_torques(mine.round(5), light, Q, push).causes == ("tau.gravity:9.8",)


def test_table_with_other_zeros_reports_the_start_in_its_joints():
    report = checks.compare_tables("q1 0.5 0 90\nq2+30 0 0.4 0\nq3 0 0.3 0", ELBOW)
    assert report.figures["same machine"]
    start = np.degrees(np.subtract(ELBOW.home, [0, np.pi / 6, 0]))
    assert "your joint values are ({:g}°, {:g}°, {:g}°)".format(*start.round(4)) in str(report)
