"""Test that `Arm.from_table` reports how it read a table, and warns where it guessed."""

import re
import warnings

import numpy as np
import pytest

from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.kinematics import forward_kinematics
from tests.cases import OWN_TABLES

# Kinova's user guide of the Gen3: its first row leads from the base to joint 1.
GEN3 = """i alpha_i a_i d_i theta_i
0 pi 0 0 0
1 pi/2 0 -0.2848 q1
2 pi/2 0 -0.0118 q2 + pi
3 pi/2 0 -0.4208 q3 + pi
"""
# The UR3e's table on Universal Robots' page of DH parameters.
UR3E = """Kinematics\ttheta [rad]\ta [m]\td [m]\talpha [rad]\tDynamics\tMass [kg]\tCenter of Mass
Joint 1\t0\t0\t0.15185\tπ/2\tLink 1\t1.98\t[0, -0.02, 0]
Joint 2\t0\t-0.24355\t0\t0\tLink 2\t3.4445\t[0.13, 0, 0.1157]
Joint 3\t0\t-0.2132\t0\t0\tLink 3\t1.437\t[0.05, 0, 0.0238]
Joint 4\t0\t0\t0.13105\tπ/2\tLink 4\t0.871\t[0, 0, 0.01]
Joint 5\t0\t0\t0.08535\t-π/2\tLink 5\t0.805\t[0, 0, 0.01]
Joint 6\t0\t0\t0.0921\t0\tLink 6\t0.261\t[0, 0, -0.02]
"""


def test_fixed_first_row_warns_of_renumbered_joints():
    with pytest.warns(UserWarning, match="your q1 to q3 are q_2 to q_4 here, since row 1 is fixed"):
        arm = Arm.from_table(GEN3)
    assert "your q1 to q3 are q_2 to q_4 here" in arm.source
    with pytest.raises(ArmError, match=r"joint 1 cannot be locked; its free joints are 2, 3, 4"):
        arm.lock(1)


@pytest.mark.parametrize("case", OWN_TABLES, ids=lambda case: case["about"])
def test_own_table_is_read_with_its_warnings(case):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        arm = Arm.from_table(case["text"], **case.get("options", {}))
    for warning, message in zip(caught, case.get("warnings", ()), strict=True):
        assert re.search(message, str(warning.message))
    for words in case.get("source", ()):
        assert words in arm.source
    if "rows" in case:
        assert [[*row.entries] for row in arm.rows] == case["rows"]


@pytest.mark.parametrize("change", ["limits", "speed", "effort"])
def test_fixed_row_has_no_limits(change):
    arm = Arm("with base", [fixed(d=0.2), revolute(a=0.3)])
    with pytest.raises(ArmError, match=rf"row 1 is fixed and has no {change}; .* with joints, 2"):
        arm.with_row(1, **{change: (-1, 1) if change == "limits" else 1})


def test_columns_of_masses_are_left_out():
    arm = Arm.from_table(UR3E)
    assert "columns left out: Mass [kg] and Center of Mass" in arm.source
    # The pose at q = 0 by hand: both links along -x, the wrist's offsets along -y and -z.
    T = forward_kinematics(arm, np.zeros(6))
    np.testing.assert_allclose(
        T[:3, 3], [-0.24355 - 0.2132, -0.13105 - 0.0921, 0.15185 - 0.08535], atol=1e-12
    )


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda arm: arm.with_row(1, limits=(-170, 170)), r"np\.radians"),
        (lambda arm: arm.with_row(2, limits=(0, 150)), "millimetres divide by 1000"),
        (lambda arm: arm.with_row(1, a=75), "for millimetres write 75 / 1000"),
        (lambda arm: revolute(d=-300), "for millimetres write -300 / 1000"),
        (lambda arm: prismatic(limits=(0, 400)), "millimetres divide by 1000"),
    ],
)
def test_value_in_another_unit_warns(make, message):
    with pytest.warns(UserWarning, match=message):
        make(Arm("two", [revolute(a=0.3), prismatic()]))


def test_greek_symbols_of_a_table_are_typeset():
    arm = Arm("g", [revolute(alpha="alpha_1", theta="-phi_2")], dict(alpha_1=0.3, phi_2=1.2))
    text = arm._repr_markdown_()
    assert r"$\alpha_{1}$" in text
    assert r"q_{1} - \phi_{2}" in text
    assert r"$\phi_{2} = 1.2$" in text
