"""Test formulas in named steps against the numeric functions, and the size of long sheets."""

import contextlib
import io

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from answers import make_html_sheet
from answers.content import AnswerSheet
from answers.programs import write_numpy
from helpers import kinematics, statics, symbolic
from helpers.arm import Arm, Body, revolute
from helpers.inputs import ArmError
from helpers.polynomials import is_long
from helpers.robots import ARMS, PANDA, STANFORD, UR10E
from helpers.stepwise import stepwise_formulas
from tests.laws import joint_vectors, random_arms, slow_frames


def skew_arm(dof, bodies=True):
    """Return an arm whose twists are not multiples of a right angle."""
    rows = [revolute(f"a_{i}", 0.3 + 0.1 * i, f"d_{i}") for i in range(1, dof + 1)]
    values = {f"{c}_{i}": 0.1 * i for c in "ad" for i in range(1, dof + 1)}
    links = [Body(1.5 * i, (0.01 * i, 0.02, 0.03)) for i in range(1, dof + 1)] if bodies else []
    return Arm("Skew arm", rows, values=values, bodies=links)


def evaluate_steps(arm, formula, steps, q):
    """Return the number of a formula in named steps at the joint values."""
    numbers = dict(zip(symbolic.joint_symbols(arm), map(float, q), strict=True))
    numbers |= {sp.Symbol(name): value for name, value in arm.values.items()}
    numbers |= symbolic.body_numbers(arm) if arm.bodies else {}
    for name, definition in steps.definitions.items():
        numbers[name] = definition.xreplace(numbers).evalf()
    return np.array(formula.xreplace(numbers).evalf(), dtype=float)


@settings(max_examples=15)
@given(arm=random_arms.filter(lambda arm: arm.dof), seed=st.integers(0, 99))
def test_stepwise_formulas_of_random_arms_match_numeric_view(arm, seed):
    q, steps = joint_vectors(arm, (), seed), stepwise_formulas(arm)
    for T, expected in zip(steps.frames, slow_frames(arm, q), strict=True):
        np.testing.assert_allclose(evaluate_steps(arm, T, steps, q), expected, atol=1e-9)
    J = evaluate_steps(arm, steps.jacobian, steps, q)
    np.testing.assert_allclose(J, kinematics.jacobian(arm, q), atol=1e-9)


@pytest.mark.parametrize("arm", [PANDA, UR10E, skew_arm(8)], ids=lambda arm: arm.name)
def test_stepwise_gravity_matches_numeric_view(arm):
    q, steps = joint_vectors(arm, (), 3), stepwise_formulas(arm)
    torque = evaluate_steps(arm, steps.torque, steps, q)[:, 0]
    np.testing.assert_allclose(torque, statics.gravity_torque(arm, q), atol=1e-9)
    energy = evaluate_steps(arm, sp.Matrix([steps.energy]), steps, q)[0, 0]
    np.testing.assert_allclose(energy, statics.potential_energy(arm, q), atol=1e-9)


def test_stepwise_prismatic_force_matches_numeric_view():
    bodies = [Body(i + 1, (0.1, 0.2, 0.3)) for i in range(len(STANFORD.rows))]
    arm = Arm("Stanford", STANFORD.rows, values=STANFORD.values, bodies=bodies)
    q, steps = joint_vectors(arm, (), 5), stepwise_formulas(arm)
    torque = evaluate_steps(arm, steps.torque, steps, q)[:, 0]
    np.testing.assert_allclose(torque, statics.gravity_torque(arm, q), atol=1e-9)


def test_formula_size_grows_with_the_square_of_joints():
    def count_operations(dof):
        steps = stepwise_formulas(skew_arm(dof))
        formulas = [*steps.definitions.values(), *steps.jacobian, *steps.torque, steps.energy]
        return sum(formula.count_ops() for formula in formulas)

    assert count_operations(16) < 4 * count_operations(8)


def test_catalogue_arms_are_written_out():
    assert not any(map(is_long, ARMS))


def test_written_out_jacobian_of_eight_skew_joints_names_stepwise():
    with pytest.raises(ArmError, match="stepwise_formulas"):
        symbolic.jacobian(skew_arm(8))


def test_determinant_of_six_skew_joints_names_manipulability():
    with pytest.raises(ArmError, match="manipulability"):
        symbolic.determinant(skew_arm(6))


def test_sheet_of_eight_skew_joints_computes_its_numbers():
    arm = skew_arm(8)
    page = make_html_sheet(arm)
    assert len(page) < 1e6
    assert "in the entries of the frame before" in page
    assert "add up" not in page
    sheet = AnswerSheet(arm)
    for item in (sheet.frames[-1], sheet.axes[-1], sheet.jacobian, *sheet.energy_and_torques):
        values: dict = {}
        with contextlib.redirect_stdout(io.StringIO()):
            exec(write_numpy(sheet, item), values)
        np.testing.assert_allclose(values[item.name], np.squeeze(item.home_values), atol=1e-9)
