"""Compare `from_urdf` with Pinocchio on every serial arm of example-robot-data.

Poses, Jacobians and gravity torques must agree. Most files write a right angle with eleven digits.
`from_urdf` takes it as exact, which moves a tip by up to 1e-11 m, so torques are compared to 1e-10
of the arm's largest torque.
"""

import os
import re
import sys
import sysconfig
from pathlib import Path

import numpy as np
import pytest

from helpers.arm import Arm, Body, prismatic, revolute
from helpers.dynamics import inverse_dynamics
from helpers.inverse import solve
from helpers.kinematics import forward_kinematics, jacobian
from helpers.other_programs import write_urdf
from helpers.statics import gravity_torque
from helpers.urdf import from_urdf

if os.environ.get("CI") and sys.platform == "linux":
    import pinocchio
else:
    pinocchio = pytest.importorskip("pinocchio", reason="Pinocchio is not installed here")

ROBOTS = Path(sysconfig.get_paths()["purelib"], "cmeel.prefix/share/example-robot-data/robots")
FINGERS = ("panda_finger_joint1", "panda_finger_joint2")

UR = "ur_description/urdf/ur"

# The SO-ARM100 file rolls parallel axes by 3.14159, so that their common normal is 7 km away.
pytestmark = pytest.mark.filterwarnings("ignore:so_arm100. z_0 and z_1 are within 0.00036°")

# File, base link, tip link, and the joints beside the chain, which stay at 0.
ARMS = {
    "UR3": (f"{UR}3_robot.urdf", "world", "tool0", ()),
    "UR5": (f"{UR}5_robot.urdf", "world", "tool0", ()),
    "UR5 with a gripper": (f"{UR}5_gripper.urdf", "world", "tool0", ()),
    "UR10, joints limited": (f"{UR}10_joint_limited_robot.urdf", "world", "ee_link", ()),
    "Panda": ("panda_description/urdf/panda.urdf", None, "panda_hand_tcp", FINGERS),
    "Panda's finger": (
        "panda_description/urdf/panda_collision.urdf",
        None,
        "panda_leftfinger",
        FINGERS[1:],
    ),
    "Jaco": ("kinova_description/robots/kinova.urdf", None, "j2s6s200_end_effector", ()),
    "xArm7": ("xarm_description/urdf/xarm7.urdf", None, None, ()),
    "Z1 with its gripper": ("z1_description/urdf/z1.urdf", None, None, ()),
    "SO-100": ("so_arm_description/urdf/so100.urdf", None, None, ()),
    "SO-101": ("so_arm_description/urdf/so101.urdf", None, "moving_jaw_so101_v1_link", ()),
    "two joints": ("asr_twodof_description/urdf/TwoDofs.urdf", None, None, ()),
    "double pendulum": ("double_pendulum_description/urdf/double_pendulum.urdf", None, None, ()),
    "finger": ("finger_edu_description/robots/finger_edu.urdf", None, None, ()),
    "flying arm of five joints": (
        "hextilt_description/urdf/hextilt_flying_arm_5.urdf", None, None, (),
    ),
    "flying arm of two joints": (
        "borinot_description/urdf/borinot_flying_arm_2.urdf", None, None, (),
    ),
}  # fmt: skip

# Arms of robots with several chains: file, base link, tip link. The remaining joints stay at 0.
LIMBS = {
    "Talos": ("talos_data/robots/talos_reduced.urdf", "base_link", "gripper_left_base_link"),
    "Tiago": ("tiago_description/robots/tiago_no_hand.urdf", "base_footprint", "arm_tool_link"),
    "Baxter": ("baxter_description/urdf/baxter.urdf", "base", "left_gripper"),
    "PR2": ("pr2_description/urdf/pr2.urdf", "base_footprint", "r_gripper_tool_frame"),
    "Z1 on a dog": ("b1_description/urdf/b1-z1.urdf", "base", "gripperStator"),
    "Jaco on a dog": ("anymal_b_simple_description/robots/anymal-kinova.urdf", "base",
    "j2s6s200_end_effector"),
    "iCub": ("icub_description/robots/icub_reduced.urdf", "base_link", "l_hand"),
    "G1": ("g1_description/urdf/g1_29dof_rev_1_0.urdf", "pelvis", "left_rubber_hand"),
}  # fmt: skip


def pinocchio_model(text, others):
    """Return Pinocchio's model and data of the arm, with other joints locked at 0."""
    model = pinocchio.buildModelFromXML(text)
    if locked := [model.getJointId(name) for name in others]:
        model = pinocchio.buildReducedModel(model, locked, pinocchio.neutral(model))
    return model, model.createData()


def frame_of(model, link):
    """Return Pinocchio's frame number of a link."""
    return model.getFrameId(link, pinocchio.FrameType.BODY)


def largest_differences(text, base, tip, others):
    """Return the largest differences of pose, Jacobian and torque, and the largest torque."""
    arm = from_urdf(text, base, tip, angle_tolerance=0)
    model, data = pinocchio_model(text, others)
    rng, worst = np.random.default_rng(15), np.zeros(4)
    for q in rng.uniform(-3, 3, (40, arm.dof)):
        T, J, g = compute_by_pinocchio(model, data, arm, q)
        ours = forward_kinematics(arm, q), jacobian(arm, q), gravity_torque(arm, q)
        off = [abs(a - b).max() for a, b in zip(ours, (T, J, g), strict=True)]
        worst = np.maximum(worst, [*off, abs(g).max()])
    return worst


def compute_by_pinocchio(model, data, arm, q):
    """Return pose, Jacobian and gravity torques at q in the axes of the base."""
    ends, names = re.match("robot description: (.*); joints ([^;]*)", arm.source).groups()
    first, last = ends.split(" to ")
    full, columns = pinocchio.neutral(model), []
    for name, value in zip(names.split(", "), q, strict=True):
        joint = model.joints[model.getJointId(name)]
        angle = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]
        full[joint.idx_q : joint.idx_q + joint.nq] = angle
        columns.append(joint.idx_v)
    pinocchio.framesForwardKinematics(model, data, full)
    base, tip = (data.oMf[frame_of(model, link)].homogeneous for link in (first, last))
    assert np.array_equal(base, np.eye(4)), "gravity must point along the base's z axis"
    axes = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
    J = pinocchio.computeFrameJacobian(model, data, full, frame_of(model, last), axes)
    g = pinocchio.computeGeneralizedGravity(model, data, full)
    return tip, J.reshape(6, -1)[:, columns], g[columns]


def assert_same_arm(text, base, tip, others):
    """Compare both readings of a description, and return the largest torque."""
    pose, J, torque, largest = largest_differences(text, base, tip, others)
    assert pose < 1e-10
    assert J < 1e-10
    assert torque < 1e-10 * max(1, largest)
    return largest


@pytest.mark.parametrize("name", ARMS)
def test_serial_arm_matches_pinocchio(name):
    file, base, tip, others = ARMS[name]
    largest = assert_same_arm((ROBOTS / file).read_text(encoding="utf-8"), base, tip, others)
    assert largest > 1 or name not in ("UR5", "Panda", "Jaco", "xArm7", "Z1 with its gripper")


@pytest.mark.parametrize(
    "name",
    [
        "UR3", "UR5", "UR10, joints limited", "Panda", "Jaco", "xArm7", "Z1 with its gripper",
        "SO-100", "Talos", "Tiago", "Baxter",
    ],
)  # fmt: skip
def test_solve_finds_reachable_pose_by_itself(name):
    """At least 99.5 % of 1000 random configurations within the limits, from home."""
    file, base, tip, *_ = {**ARMS, **LIMBS}[name]
    arm = from_urdf(ROBOTS / file, base, tip)
    far = np.where(arm.turning, np.pi, 1.0)
    lower, upper = (np.clip(limit, -far, far) for limit in arm.limits)
    q = np.random.default_rng(3).uniform(lower, upper, (1000, arm.dof))
    assert solve(arm, forward_kinematics(arm, q)).reached.mean() >= 0.995


def made_up_arms():
    """Yield two arms whose bodies have the tensors of clouds of points."""
    rng = np.random.default_rng(21)
    for kinds in ("RRPRRR", "RPRRRRR"):
        rows, bodies = [], []
        for kind in kinds:
            a, d = rng.uniform(-0.4, 0.4, 2)
            alpha, theta = rng.uniform(-np.pi, np.pi, 2)
            rows.append({"R": revolute, "P": prismatic}[kind](a, alpha, d, theta))
            points, mass = rng.normal(0, 0.1, (8, 3)), rng.uniform(0.5, 5)
            points -= points.mean(axis=0)
            squares = np.einsum("ki,ki->k", points, points)
            tensor = np.mean(
                [s * np.eye(3) - np.outer(p, p) for s, p in zip(squares, points, strict=True)], 0
            )
            bodies.append(Body(mass, tuple(rng.normal(0, 0.2, 3)), mass * tensor))
        yield Arm(kinds, rows, bodies=bodies)


def read_robot(name):
    """Return the description of one of `ARMS`, its ends and the joints beside the chain."""
    file, base, tip, others = ARMS[name]
    return (ROBOTS / file).read_text(encoding="utf-8"), base, tip, others


DYNAMIC = {
    **{
        name: read_robot(name)
        for name in ("UR10, joints limited", "UR5", "Panda", "Jaco", "xArm7", "Z1 with its gripper")
    },
    **{arm.name: (write_urdf(arm), "base", "tool", ()) for arm in made_up_arms()},
}


@pytest.mark.parametrize("name", DYNAMIC)
def test_inverse_dynamics_matches_rnea(name):
    """The tensors of the file, merged over fixed joints and side branches, are Pinocchio's."""
    text, base, tip, others = DYNAMIC[name]
    arm = from_urdf(text, base, tip, angle_tolerance=0)
    assert np.any([body.inertia for body in arm.bodies])
    model, data = pinocchio_model(text, others)
    again = from_urdf(write_urdf(arm), angle_tolerance=0)
    for q, q_dot, q_ddot in np.random.default_rng(5).uniform(-2, 2, (40, 3, arm.dof)):
        full = pinocchio.neutral(model)
        for joint, value in zip(list(model.joints)[1:], q, strict=True):
            angle = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]
            full[joint.idx_q : joint.idx_q + joint.nq] = angle
        expected = pinocchio.rnea(model, data, full, q_dot, q_ddot)
        for arm_or_copy in (arm, again):
            tau = inverse_dynamics(arm_or_copy, q, q_dot, q_ddot)
            np.testing.assert_allclose(tau, expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", LIMBS)
def test_limb_of_larger_robot_matches_pinocchio(name):
    file, base, tip = LIMBS[name]
    text = (ROBOTS / file).read_text(encoding="utf-8")
    model = pinocchio.buildModelFromXML(text)
    chain = set(model.supports[model.frames[frame_of(model, tip)].parentJoint])
    others = [model.names[k] for k in range(1, model.njoints) if k not in chain]
    assert_same_arm(text, base, tip, others)
