"""Test that a pasted table is read alike wherever it can be pasted."""

import warnings

import numpy as np
import pytest

from helpers.arm import Arm
from helpers.explorer import judge
from helpers.kinematics import forward_kinematics
from tests.cases import expect_failures, questions_about
from tests.corpus.arms import CATALOGUE


def make_machine(name):
    """Return the rows of an arm such as ``PANDA.lock(3)``, typed without `helpers`."""
    name, _, locked = name.partition(".lock(")
    machine = CATALOGUE[name]
    fixed = int(locked[:-1]) if locked else None
    return machine.with_rows(
        [("F", *row[1:]) if i == fixed else row for i, row in enumerate(machine.rows, start=1)]
    )


HOMEWORK_TABLES = [case for case in questions_about("homework: table") if case["grade"] == "right"]


@pytest.mark.parametrize("case", expect_failures(HOMEWORK_TABLES), ids=lambda case: case["about"])
def test_homework_table_makes_the_arm_of_the_homework(case):
    machine = make_machine(case["arm"])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        arm = Arm.from_table(
            case["answer"],
            columns=case.get("columns"),
            values=judge.catalogue_arm(case["arm"]).values,
        )
    assert arm.dof == machine.dof
    for q in np.random.default_rng(68).uniform(-1.2, 1.2, (4, machine.dof)):
        np.testing.assert_allclose(forward_kinematics(arm, q), machine.tip(q), atol=1e-9)
