"""Test that `Arm.from_table` says how it read a table, and where a guess may be wrong."""

import warnings

import numpy as np
import pytest

from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.kinematics import forward_kinematics

# Kinova's user guide of the Gen3: its first row leads from the base to joint 1.
GEN3 = """i alpha_i a_i d_i theta_i
0 pi 0 0 0
1 pi/2 0 -0.2848 q1
2 pi/2 0 -0.0118 q2 + pi
3 pi/2 0 -0.4208 q3 + pi
"""
# Universal Robots' page on its DH parameters, the UR3e.
UR3E = """Kinematics\ttheta [rad]\ta [m]\td [m]\talpha [rad]\tDynamics\tMass [kg]\tCenter of Mass
Joint 1\t0\t0\t0.15185\tπ/2\tLink 1\t1.98\t[0, -0.02, 0]
Joint 2\t0\t-0.24355\t0\t0\tLink 2\t3.4445\t[0.13, 0, 0.1157]
Joint 3\t0\t-0.2132\t0\t0\tLink 3\t1.437\t[0.05, 0, 0.0238]
Joint 4\t0\t0\t0.13105\tπ/2\tLink 4\t0.871\t[0, 0, 0.01]
Joint 5\t0\t0\t0.08535\t-π/2\tLink 5\t0.805\t[0, 0, 0.01]
Joint 6\t0\t0\t0.0921\t0\tLink 6\t0.261\t[0, 0, -0.02]
"""
CRAIG = """alpha a d theta
0 0 0 q1
-90 0 0 q2
0 0.4318 0.15 q3
-90 0.0203 0.4318 q4
"""


def test_fixed_first_row_warns_of_renumbered_joints():
    with pytest.warns(UserWarning, match="your q1 to q3 are q_2 to q_4 here, since row 1 is fixed"):
        arm = Arm.from_table(GEN3)
    assert "your q1 to q3 are q_2 to q_4 here" in arm.source
    with pytest.raises(ArmError, match=r"joint 1 cannot be locked; its free joints are 2, 3, 4"):
        arm.lock(1)


def test_joints_counted_from_zero_are_reported():
    with pytest.warns(UserWarning, match="your q0 and q1 are q_1 and q_2 here, since joints"):
        Arm.from_table("a alpha d theta\n0.3 0 0 q0\n0.2 0 0 q1")


def test_joint_names_that_fit_the_rows_give_no_warning():
    arm = Arm.from_table("a alpha d theta\n0.3 90 0 θ1\n0.2 0 d2 0")
    assert arm.source == "columns a α d θ; the standard convention; lengths in m; angles in degrees"


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


def test_markdown_columns_of_limits_are_left_out():
    rule = "|--|--|--|--|--|--|"
    text = f"| a | alpha | d | theta | min | max |\n{rule}\n| 0.3 | 0 | 0.1 | q1 | -2 | 2 |"
    arm = Arm.from_table(text)
    assert arm.rows[0].entries == (0.3, 0, 0.1, 0)
    assert "columns left out: min and max" in arm.source


@pytest.mark.parametrize(
    ("typed", "taken"), [("1.57", "pi/2"), ("3.14", "pi"), ("1.571", "pi/2"), ("-1.571", "-pi/2")]
)
def test_rounded_right_angle_is_taken_with_a_warning(typed, taken):
    with pytest.warns(UserWarning, match=rf"alpha in row 1, {typed}, is taken as {taken}"):
        arm = Arm.from_table(f"a alpha d theta\n0.3 {typed} 0.1 q1\n0.2 0 0 q2")
    assert arm.rows[0].alpha == taken
    assert f"{typed}, is taken as {taken}" in arm.source


def test_right_angle_of_four_decimals_is_reported_in_source():
    arm = Arm.from_table("a alpha d theta\n0.3 1.5708 0.1 q1\n0.2 0 0 q2")
    assert arm.rows[0].alpha == "pi/2"
    assert "1.5708, is taken as pi/2" in arm.source


@pytest.mark.parametrize("typed", ["1.5", "1.55", "1.5730"])
def test_angle_away_from_right_angles_is_kept(typed):
    arm = Arm.from_table(f"a alpha d theta\n0.3 {typed} 0.1 q1\n0.2 0 0 q2")
    assert arm.rows[0].alpha == float(typed)


def test_bare_numbers_give_one_warning():
    with pytest.warns(UserWarning, match="convention='standard' or 'craig'") as warned:
        Arm.from_table("0 0 0.3 0\n0.4 90 0 0\n0.2 0 0 0")
    assert len(warned) == 1


def test_first_row_as_in_craigs_convention_warns():
    with pytest.warns(UserWarning, match=r"write convention='craig' .* else convention='standard'"):
        arm = Arm.from_table(CRAIG)
    assert "the standard convention" in arm.source
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert "Craig" in Arm.from_table(CRAIG, convention="craig").source
        Arm.from_table(CRAIG, convention="standard")
        # A cylindrical arm turns about one axis, lifts along it and reaches across it.
        Arm.from_table("a alpha d theta\n0 0 0.4 q1\n0 -90 d2 0\n0 0 d3 0")


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
