"""Test that Python, the explorer and the form read a pasted table in the same way."""

import re
import warnings

import numpy as np
import pytest

from helpers.arm import Arm, Joint, Row
from helpers.checks import compare_jacobian, compare_tables
from helpers.explorer import judge
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW
from tests.cases import PASTED_TABLES, PUBLIC, expect_failures, questions_about
from tests.corpus.arms import CATALOGUE
from tests.corpus.machine import Machine
from tests.node import ask_node, needs_node

ENTRIES = ("a", "alpha", "d", "theta")


def make_machine(name):
    """Return the independent model of an arm such as ``PANDA.lock(3)``."""
    name, _, locked = name.partition(".lock(")
    machine = CATALOGUE[name]
    fixed = int(locked[:-1]) if locked else None
    return machine.with_rows(
        [("F", *row[1:]) if i == fixed else row for i, row in enumerate(machine.rows, start=1)]
    )


HOMEWORK_TABLES = [case for case in questions_about("homework: table") if case["grade"] == "right"]


def assert_same_arm(arm, machine, tolerance):
    assert arm.dof == machine.dof
    for q in np.random.default_rng(68).uniform(-1.2, 1.2, (4, machine.dof)):
        np.testing.assert_allclose(forward_kinematics(arm, q), machine.tip(q), atol=tolerance)


@pytest.mark.filterwarnings("ignore")  # they say what was guessed
@pytest.mark.parametrize("case", expect_failures(HOMEWORK_TABLES), ids=lambda case: case["about"])
def test_homework_table_makes_the_arm_of_the_homework(case):
    values = judge.catalogue_arm(case["arm"]).values
    arm = Arm.from_table(case["answer"], columns=case.get("columns"), values=values)
    assert_same_arm(arm, make_machine(case["arm"]), 1e-9)


@pytest.mark.filterwarnings("ignore")  # they say what was guessed
@pytest.mark.parametrize("case", expect_failures(PUBLIC), ids=lambda case: case["about"])
def test_public_answer_is_judged_right_or_refused_for_its_reason(case):
    refusal = ""
    try:
        if case["ask"] == "table":
            arm = Arm.from_table(case["answer"], **case.get("options", {}))
        else:
            arm = Arm.from_table(case["table"])
            verdict = compare_jacobian(
                case["answer"], arm, case.get("q"), values=case.get("values")
            )
    except ArmError as error:
        refusal = str(error)
    if refusal:
        assert re.search(case.get("refused", "no refusal is expected"), refusal)
        return
    if case["ask"] == "jacobian":
        assert re.search(case["said"], str(verdict), re.DOTALL)
        return
    rows = [(k, a, np.radians(alpha), d, np.radians(t)) for k, a, alpha, d, t in case["rows"]]
    assert_same_arm(arm, Machine(rows), 2e-4)  # the sources round to 0.1 mm and 1e-4 rad


# The same reading, or the same refusal, at every input

KINDS = {"R": "revolute", "P": "prismatic", "F": "fixed"}


def make_expected_arm(rows):
    """Return the arm of rows such as ["R", a, alpha in degrees, d, theta in degrees]."""
    return Arm(
        "the arm",
        tuple(
            Row(a, np.radians(alpha), d, np.radians(theta), Joint(KINDS[kind]))
            for kind, a, alpha, d, theta in rows
        ),
    )


def list_rows(arm):
    """Return kind, a, alpha, d and theta (m, rad) of each row."""
    return [
        (row.joint.kind, *(arm.number(getattr(row, name)) for name in ENTRIES)) for row in arm.rows
    ]


def read_on_page(text):
    """Yield how the explorer and the form read a table with each unit: name, rows, refusal."""
    for unit in ("deg", "rad"):
        for place, answer in ask_node("pasted_tables.mjs", {"text": text, "unit": unit}).items():
            rows = [
                (row["kind"], *(row[name] for name in ENTRIES)) for row in answer.get("rows", ())
            ]
            yield f"{place} in {unit}", rows, answer.get("error", "")


def read_in_python(text):
    """Return the rows of `Arm.from_table` and its refusal or its warning about a guess."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            rows = list_rows(Arm.from_table(text))
        except ArmError as refusal:
            return [], str(refusal)
    return rows, next((str(w.message) for w in caught if "a guess reads it" in str(w.message)), "")


def assert_same_rows(place, rows, expected):
    assert [row[0] for row in rows] == [row[0] for row in expected], place
    numbers, wanted = ([row[1:] for row in table] for table in (rows, expected))
    np.testing.assert_allclose(numbers, wanted, atol=1e-5, err_msg=place)  # 1.5708 may be pi/2


@needs_node
@pytest.mark.parametrize("case", expect_failures(PASTED_TABLES), ids=lambda case: case["about"])
def test_pasted_table_is_read_or_asked_about_alike(case):
    """A case with rows must give these rows at each input; a case without rows is refused there."""
    text = case["text"]
    python_rows, python_question = read_in_python(text)
    if "rows" in case:
        arm = make_expected_arm(case["rows"])
        assert_same_rows("Arm.from_table", python_rows, list_rows(arm))
        for place, rows, _ in read_on_page(text):
            assert_same_rows(place, rows, list_rows(arm))
        reference = make_expected_arm(case.get("reference", case["rows"]))
        assert compare_tables(text, reference).grade == "right"
        return
    assert python_question
    for place, rows, question in read_on_page(text):
        assert question, (place, rows)
    try:
        verdict = str(compare_tables(text, ELBOW))
    except ArmError:
        return
    assert "Taken as columns" in verdict
