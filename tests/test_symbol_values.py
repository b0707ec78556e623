"""Test which number a symbol of a student's formula stands for."""

import math

import numpy as np
import pytest

from helpers.checks.arms import judge_data
from helpers.inputs import ArmError
from helpers.robots import ELBOW, PANDA, STANFORD
from tests import reading
from tests.node import needs_node

pytestmark = needs_node

Q3, Q6 = np.array([0.3, 0.5, -0.2]), np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
LOCKED = PANDA.lock(3)  # its joints are 1, 2, 4, 5, 6, 7


def look_up(names, arm, q, values=None):
    """Return the number of each name."""
    pairs = [list(pair) for pair in (values or {}).items()]
    given = dict(names=list(names), arm=judge_data(arm), q=list(q), values=pairs)
    return reading.ask_reader("names", **given)


@pytest.mark.parametrize("typed", ["theta_{1}(t)", "θ₁", "Q_1'", r"\theta_1", "t1", "joint1"])
def test_symbol_is_known_in_each_spelling(typed):
    assert look_up([typed], ELBOW, Q3) == {typed: 0.3}


@pytest.mark.parametrize(
    ("names", "arm", "q", "values", "found"),
    [
        # Joints in all spellings, sines and cosines of their sums, lengths.
        (["q_1", "th2", "theta_3", "t1", "phi2", "j3", "joint1", "x2", "d3"], ELBOW, Q3, {},
         [0.3, 0.5, -0.2, 0.3, 0.5, -0.2, 0.3, 0.5, -0.2]),
        (["s1", "C2", "s_23", "c_{2-3}", "S_{123}", "c-1+2", "c22"], ELBOW, Q3, {},
         [math.sin(0.3), math.cos(0.5), math.sin(0.3), math.cos(0.7), math.sin(0.6),
          math.cos(0.2), 1 * math.cos(1.0)]),
        (["a_2", "a3", "d_1", "h", "q1"], ELBOW, Q3, {"h": 7.0, "d_1": 9.0},
         [0.4, 0.3, 9.0, 7.0, 0.3]),
        (["d_3", "q_3"], STANFORD, Q6, {}, [0.3, 0.3]),
        # The numbers of joints are those of the rows.
        (["q_1", "q_4", "q_7"], LOCKED, Q6, {}, [0.1, 0.3, 0.6]),
        (iter(["q_1", "q_1"]), ELBOW, Q3, None, [0.3]),
    ],
)  # fmt: skip
def test_symbol_has_the_value_of_its_joint_or_length(names, arm, q, values, found):
    names = list(dict.fromkeys(names))
    numbers = look_up(iter(names), arm, q, values)
    assert [numbers[name] for name in names] == pytest.approx(found, rel=1e-15)


@pytest.mark.parametrize(
    ("names", "arm", "unknown"),
    [
        (["q_1", "q_4"], ELBOW, "q_4"),
        (["q_1", "q_3"], LOCKED, "q_3"),
        (["q_1", "beta"], ELBOW, "beta"),
        (["z1"], ELBOW, "z1"),
        (["s"], ELBOW, "s"),
        (["q_123"], ELBOW, "q_123"),
        (["s_14"], ELBOW, "s_14"),
    ],
)
def test_unknown_symbol_is_rejected_with_known_ones(names, arm, unknown):
    known = ", ".join([f"q_{i}" for i in arm.joints] + list(arm.values))
    said = f"{arm.name}: no value for {unknown}; known are {known}"
    with pytest.raises(ArmError) as error:
        look_up(names, arm, np.zeros(arm.dof))
    assert str(error.value) == said


def test_joint_numbered_without_fixed_rows_is_rejected():
    arm = ELBOW.with_base((0, 0, 2.5, "pi", 0, 0))
    with pytest.raises(ArmError, match=r"by their rows, and row 1 is fixed$"):
        look_up(["q_1", "q_2"], arm, np.zeros(arm.dof))


@pytest.mark.parametrize(("zero", "one"), [("q0", "q1"), ("theta_0", "theta_1")])
def test_joints_counted_from_0_are_rejected(zero, one):
    with pytest.raises(ArmError, match=f"from 1 here, so there is no {zero}; write {one} for it"):
        look_up([zero, "q1"], LOCKED, np.zeros(LOCKED.dof))
