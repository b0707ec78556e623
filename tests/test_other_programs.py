"""Test the code that `helpers.other_programs` writes, by running it in those programs."""

import numpy as np
import pytest

from helpers.arm import Arm, fixed, prismatic, revolute
from helpers.kinematics import forward_kinematics, jacobian
from helpers.other_programs import write_code, write_urdf
from helpers.robots import ARMS, ELBOW, PANDA, STANFORD
from helpers.statics import gravity_torque
from helpers.urdf import from_urdf

MIXED = Arm(
    "mixed <&> 'arm'",
    [
        fixed(d=0.2, alpha=0.3),
        revolute(a=0.3, alpha="pi/3", theta=0.4, limits=(-1, 2), speed=2),
        prismatic(d=0.1, theta=0.7, a=-0.2, alpha="-pi/2", effort=9),
        fixed(a=0.1),
        revolute(d="l", alpha=-0.2),
    ],
    dict(l=0.25),
)
EVERY_ARM = pytest.mark.parametrize(
    "arm", [*ARMS, PANDA.lock(3, 0.4), MIXED], ids=lambda arm: f"{arm.name}, {arm.dof} joints"
)


def joint_values(arm):
    return np.random.default_rng(1).uniform(-1, 1, arm.dof)


def run(arm, program):
    """Run the code with random joint values in place of its zeros, and return its variables."""
    q = joint_values(arm)
    text = write_code(arm, program)
    zeros = f"q = np.zeros({arm.dof})"
    assert program == "sympy" or zeros in text
    variables = {}
    exec(text.replace(zeros, f"q = np.array({q.tolist()})"), variables)
    return q, variables


@EVERY_ARM
def test_urdf_is_read_back_as_the_same_arm(arm):
    q, back = joint_values(arm), from_urdf(write_urdf(arm), angle_tolerance=0)
    np.testing.assert_allclose(forward_kinematics(back, q), forward_kinematics(arm, q), atol=1e-10)
    np.testing.assert_allclose(jacobian(back, q), jacobian(arm, q), atol=1e-10)
    if arm.bodies:
        np.testing.assert_allclose(gravity_torque(back, q), gravity_torque(arm, q), atol=1e-8)
    np.testing.assert_array_equal(back.limits, arm.limits)
    np.testing.assert_array_equal(back.speed_limits, arm.speed_limits)
    np.testing.assert_array_equal(back.effort_limits, arm.effort_limits)


@EVERY_ARM
def test_sympy_code_gives_pose_and_jacobian(arm):
    q, variables = run(arm, "sympy")
    numbers = dict(zip(variables["q"], q, strict=True)) | variables["numbers"]
    for name, expected in (("T", forward_kinematics(arm, q)), ("J", jacobian(arm, q))):
        actual = np.array(variables[name].subs(numbers), float)
        np.testing.assert_allclose(actual, expected, atol=1e-12)


@EVERY_ARM
def test_modern_robotics_code_gives_pose_and_jacobians(arm):
    pytest.importorskip("modern_robotics", reason="Modern Robotics is not installed here")
    q, variables = run(arm, "modern robotics")
    in_tool = jacobian(arm, q, "tool")
    np.testing.assert_allclose(variables["T"], forward_kinematics(arm, q), atol=1e-10)
    np.testing.assert_allclose(variables["J"], jacobian(arm, q), atol=1e-10)
    np.testing.assert_allclose(variables["J_tool"], in_tool, atol=1e-10)


@EVERY_ARM
def test_pinocchio_code_gives_pose_jacobians_and_torques(arm):
    pytest.importorskip("pinocchio", reason="Pinocchio is not installed here")
    q, variables = run(arm, "pinocchio")
    J = jacobian(arm, q)
    in_tool = jacobian(arm, q, "tool")
    tip = forward_kinematics(arm, q)[:3, 3]
    np.testing.assert_allclose(variables["T"], forward_kinematics(arm, q), atol=1e-10)
    np.testing.assert_allclose(variables["J"], J, atol=1e-10)
    np.testing.assert_allclose(variables["J_tool"], in_tool, atol=1e-10)
    # v + w x (0 - tip) is the velocity of the body's point at the base's origin.
    at_origin = J[:3] - np.cross(J[3:].T, tip).T
    np.testing.assert_allclose(variables["J_space"], [*at_origin, *J[3:]], atol=1e-10)
    if arm.bodies:
        np.testing.assert_allclose(variables["g"], gravity_torque(arm, q), atol=1e-8)


def test_toolbox_code_writes_each_row():
    """The toolbox adds theta of a revolute joint, or d of a prismatic one, to q as its offset."""
    text = write_code(MIXED, "robotics toolbox")
    assert "RevoluteDH(d=0.2, a=0, alpha=0.3, offset=0),  # row 1 does not move" in text
    assert "PrismaticDH(theta=0.7, a=-0.2, alpha=-pi/2, offset=0.1)," in text
    assert "moving = [1, 2, 4]" in text
    assert "L(3) = Prismatic('theta', 0, 'a', 0, 'alpha', 0, 'offset', 0);" in write_code(
        STANFORD, "matlab"
    )


@EVERY_ARM
def test_robotics_toolbox_code_gives_pose_and_jacobians(arm):
    pytest.importorskip("roboticstoolbox", reason="the Robotics Toolbox is not installed here")
    q = joint_values(arm)
    full = np.zeros(len(arm.rows))
    full[np.array(arm.joints) - 1] = q
    text = write_code(arm, "robotics toolbox")
    zeros = f"q = np.zeros({len(arm.rows)})"
    assert zeros in text
    variables = {}
    exec(text.replace(zeros, f"q = np.array({full.tolist()})"), variables)
    in_tool = jacobian(arm, q, "tool")
    np.testing.assert_allclose(variables["T"], forward_kinematics(arm, q), atol=1e-10)
    np.testing.assert_allclose(variables["J"], jacobian(arm, q), atol=1e-10)
    np.testing.assert_allclose(variables["J_tool"], in_tool, atol=1e-10)


def test_every_program_is_written_for_an_arm_without_symbols():
    arm = Arm("plain", [revolute(a=0.4), revolute(a=0.3)])
    names = ("Robotics Toolbox", "MATLAB", "Modern Robotics", "Pinocchio", "SymPy")
    assert all(write_code(arm, name) == write_code(arm, name.lower()) != "" for name in names)
    offset = Arm("offset", [revolute(a="l - 0.307")], dict(l=0.1))
    assert "a=-0.207," in write_code(offset, "Robotics Toolbox")
    assert "'mixed <&> ''arm'''" in write_code(MIXED, "matlab")
    assert write_code(ELBOW, "matlab").startswith("L(1) = Revolute('d', 0.5, 'a', 0, 'alpha', pi/2")
