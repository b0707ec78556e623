"""Test reading robot descriptions, and the messages if one is not a serial arm."""

import itertools
import math

import numpy as np
import pytest

import helpers
from answers.command_line import read_arm
from helpers.arm import ArmError
from helpers.kinematics import forward_kinematics
from helpers.statics import gravity_torque
from helpers.urdf import from_urdf

RIGHT = "1.5707963267948966"


def joint(name, parent, child, kind="revolute", inside="", xyz="0 0 1", rpy="0 0 0"):
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 0 1"/>{inside}</joint>'
    )


def link(name, mass=None, xyz="0 0 0"):
    if mass is None:
        return f'<link name="{name}"/>'
    inertial = f'<inertial><origin xyz="{xyz}"/><mass value="{mass}"/></inertial>'
    return f'<link name="{name}">{inertial}</link>'


def robot(*elements, name="two"):
    return f'<?xml version="1.0"?><robot name="{name}">{"".join(elements)}</robot>'


LIMIT = '<limit lower="-1" upper="2" velocity="3" effort="4"/>'
LINKS = [link("base"), link("upper", 2, "0.3 0 0"), link("fore", 1, "0 0.2 0"), link("tool", 0.5)]
JOINTS = [
    joint("shoulder", "base", "upper", inside=LIMIT),
    joint("elbow", "upper", "fore", "continuous", xyz="0.6 0 0", rpy=f"{RIGHT} 0 0"),
    joint("flange", "fore", "tool", "fixed", xyz="0 0.4 0"),
]
TWO = robot(*LINKS, *JOINTS)


def test_chain_keeps_names_and_limits():
    arm = from_urdf(TWO)
    assert arm.name == "two"
    assert arm.source == (
        "robot description: base to tool; joints shoulder, elbow; without inertia tensors, so taken"
        " as point masses: upper, fore, tool"
    )
    found = (arm.limits[0], arm.limits[1], arm.speed_limits, arm.effort_limits)
    assert np.transpose(found).tolist() == [[-1, 2, 3, 4], [-math.inf, *[math.inf] * 3]]


def test_urdf_without_masses_has_no_bodies():
    links = [link(name) for name in ("base", "upper", "fore", "tool")]
    assert from_urdf(robot(*links, *JOINTS)).bodies == ()


def test_urdf_is_read_by_the_class_of_arms():
    assert helpers.Arm.from_urdf(TWO, tip="fore") == from_urdf(TWO, tip="fore")
    with pytest.raises(AttributeError, match="has no attribute 'PUMA'"):
        helpers.PUMA  # noqa: B018


def test_file_and_text_give_the_same_arm(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(TWO, encoding="utf-8")
    assert from_urdf(path) == from_urdf(str(path)) == from_urdf(TWO)
    latin = robot(*LINKS, *JOINTS, name="zwölf").replace("?>", ' encoding="iso-8859-1"?>')
    assert from_urdf(robot(*LINKS, *JOINTS, "<a>" * 10**5 + "</a>" * 10**5)) == from_urdf(TWO)
    path.write_text(latin, encoding="iso-8859-1")
    assert from_urdf(path).name == from_urdf(latin).name == "zwölf"


def test_base_and_tip_select_part_of_chain():
    assert from_urdf(TWO, "upper", "fore").source.startswith(
        "robot description: upper to fore; joints elbow;"
    )


@pytest.mark.parametrize(
    ("given", "limits"),
    [
        ('lower="-1" upper="2" velocity="3" effort="4"', (-1, 2, 3, 4)),
        ('lower="-1" upper="2" velocity="0" effort="0"', (-1, 2, math.inf, math.inf)),
        ('upper="2" velocity="1" effort="1"', (0, 2, 1, 1)),
        ('velocity="1" effort="1"', (-math.inf, math.inf, 1, 1)),
    ],
)
def test_missing_and_zero_limits_follow_urdf_rules(given, limits):
    moved = joint("j", "a", "b", inside=f"<limit {given}/>")
    arm = from_urdf(robot(link("a"), link("b"), moved))
    assert (*np.ravel(arm.limits), *arm.speed_limits, *arm.effort_limits) == limits


MIMIC = '<mimic joint="shoulder"/>'
FINGERS = [link("left", 0.1), link("right", 0.1)]
GRIP = [
    joint("left_finger", "tool", "left", "prismatic", LIMIT, xyz="0.1 0 0"),
    joint("right_finger", "tool", "right", "prismatic", LIMIT, xyz="-0.1 0 0"),
]
GRIPPER = robot(*LINKS, *FINGERS, *JOINTS, *GRIP)


def test_side_links_add_mass_at_zero_angle():
    """The side links are two fingers, one with a mimic joint, and a cup with a floating joint."""
    cup = link("cup", 1), joint("m", "tool", "cup", "floating", MIMIC, xyz="0 0 0")
    for more, mass in (((), 0.7), (cup, 1.7)):
        arm = from_urdf(robot(*LINKS, *FINGERS, *JOINTS, *GRIP, *more), tip="tool")
        assert arm.dof == 2
        torque = abs(gravity_torque(arm, [0, math.pi / 2])[1])
        assert torque == pytest.approx(9.81 * (1 * 0.2 + mass * 0.4), abs=1e-12)
    out = from_urdf(GRIPPER, tip="left")
    gap = forward_kinematics(out, [0, 0, 0.5]) - forward_kinematics(out, [0, 0, 0])
    assert np.linalg.norm(gap[:3, 3]) == pytest.approx(0.5)


def test_mass_of_a_side_link_acts_at_its_own_centre():
    camera = link("camera", 0.3), joint("mount", "tool", "camera", "fixed", xyz="0 0.15 0")
    arm = from_urdf(robot(*LINKS, *JOINTS, *camera), tip="tool")
    torque = abs(gravity_torque(arm, [0, math.pi / 2])[1])
    assert torque == pytest.approx(9.81 * (1 * 0.2 + 0.5 * 0.4 + 0.3 * 0.55), abs=1e-12)


LOOP = robot(link("a"), link("b"), joint("j", "a", "b"), joint("k", "b", "a"))
BOMB = '<!DOCTYPE r [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]><robot name="&b;"/>'
OUTSIDE = '<!DOCTYPE r [<!ENTITY a SYSTEM "file:///etc/passwd">]><robot name="&a;"/>'
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="a"/></robot>'

TEN = robot(*map(link, "abcdefghij"), *map(joint, "123456789", "abcdefghi", "bcdefghij"))


def make_single_joint_robot(*how, **more):
    """Return a robot description with one link on a base, by joint m."""
    return robot(*LINKS[:2], joint("m", "base", "upper", *how, **more))


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (GRIPPER, r"beyond base are left, right; expected one. Say which .* with base and tip"),
        (
            make_single_joint_robot(inside=MIMIC),
            "joint m follows joint shoulder .mimic.; .* tip = 'base', or remove",
        ),
        (
            make_single_joint_robot("planar"),
            "joint m is planar; a table has rows for .* it, with base = 'upper'",
        ),
        (
            make_single_joint_robot("floating"),
            "joint m is floating; a table has rows for .* beyond it, with base =",
        ),
        (robot(link("a"), link("b")), "links without a parent are a, b; expected one"),
        (LOOP, "two: links a, b go round in a circle; .* Remove the joint that closes the loop"),
        (LOOP.replace("</robot>", '<link name="w"/></robot>'), "links a, b go round in a circle"),
        (robot(*LINKS, *JOINTS, joint("extra", "base", "tool")), "that carry link tool are 2; exp"),
        (robot(link("a"), link("a")), "links called a are 2; expected one"),
        (robot(link("a"), joint("j", "a", "b")), "names a link 'b'; there"),
        (
            make_single_joint_robot().replace("child", "kid"),
            "the child of joint m has no link; expected link=",
        ),
        (robot("<link/>"), "a link has no name; expected name="),
        (robot(), "two: links without a parent are ; expected one"),
        (
            make_single_joint_robot(inside='<limit lower="1" upper="-1"/>'),
            "m has limits 1 to -1; expected lower <= up",
        ),
        (
            make_single_joint_robot(inside='<limit lower="low"/>'),
            "m: lower is 'low'; expected a finite number",
        ),
        (
            make_single_joint_robot(xyz="0 0 nan"),
            "the xyz of m is '0 0 nan'; expected three finite numbers",
        ),
        (
            make_single_joint_robot().replace('<axis xyz="0 0 1', '<axis xyz="0 0 0'),
            "the axis of m is 0 0 0; expected",
        ),
        (
            make_single_joint_robot().replace('"2"', '"-1"'),
            "the mass of upper is -1.0; expected a number of kg, 0 or",
        ),
        (make_single_joint_robot().replace("value", "val"), "the mass of upper is nan; expected"),
        (BOMB, "has a document type, which a robot description does not need"),
        (OUTSIDE, "has a document type"),
        ("<a>" * 10**5 + "</a>" * 10**5, "is a <a>; expected"),
        (TWO[:-20], r"the text is no XML \(.*\); expected a robot description"),
        ("<<<", "the text is no XML"),
        ("<sdf/>", "the text is an SDF model of Gazebo; give the robot's URDF"),
        ("<mujoco/>", "the text is an MJCF model of MuJoCo; give the robot's URDF"),
        (XACRO, "the text holds xacro macros; expand them first, by `xacro arm.urdf.xacro >"),
        (make_single_joint_robot(rpy="${pi/2} 0 0"), "the text holds xacro macros"),
        ("nowhere.urdf", "source is 'nowhere.urdf'; expected a file that exists"),
        ("a" * 5000, "cannot be read|expected a file that exists"),
    ],
    ids=itertools.count(),
)
def test_invalid_description_is_rejected(source, words):
    with pytest.raises(ArmError, match=words):
        from_urdf(source)


@pytest.mark.parametrize(
    ("source", "ends", "words"),
    [
        (TWO, ("tool", None), "nothing moves from tool to tool"),
        (TWO, ("tool", "base"), "base does not lie beyond tool"),
        (TWO, ("hand", None), "base is 'hand'; expected a link, one of base, upp"),
        (TWO, (None, 3), "tip is 3; expected a link"),
        (TEN, ("wrist", None), "one of a, b, c, d, e, f, g, h and 2 more"),
    ],
)
def test_invalid_base_or_tip_is_rejected(source, ends, words):
    with pytest.raises(ArmError, match=words):
        from_urdf(source, *ends)


def test_folder_or_device_is_rejected(tmp_path):
    for path in (tmp_path, "/dev/zero"):
        with pytest.raises(ArmError, match="expected a file that exists"):
            from_urdf(path)


def test_rounded_angle_warns_with_needed_tolerance():
    """A roll of 3.1416 between parallel axes 0.1 m apart puts the common normal 14 km away."""
    turned = joint("k", "b", "c", xyz="0 0.1 0", rpy="3.1416 0 0")
    text = robot(*map(link, "abc"), joint("j", "a", "b"), turned)
    with pytest.warns(UserWarning, match=r"z_0 and z_1 .* \(d_1 = \S+ m\); a tol.* above 7e-06"):
        far = from_urdf(text, angle_tolerance=0)
    assert abs(far.values["d_1"]) > 1e4
    flat = from_urdf(text, tolerance=1e-5, angle_tolerance=0)
    assert [flat.number(row.a) for row in flat.rows] == [0.1, 0]


def test_moving_branch_on_base_adds_no_torque():
    """A branch on the base does not load the arm."""
    other = [link("cart", 5), joint("wheel", "base", "cart")]
    arm = from_urdf(robot(*LINKS, *other[:1], *JOINTS, *other[1:]), tip="tool")
    assert gravity_torque(arm, [0.3, 1.0]) == pytest.approx(
        gravity_torque(from_urdf(TWO), [0.3, 1.0])
    )


def test_rounded_right_angles_are_exact_and_named_in_source():
    """A roll of 3.1416 and an axis that is 4e-5 rad off count as exact; 2e-4 rad does not."""
    turned = joint("k", "b", "c", xyz="0 0.1 0", rpy="3.1416 0 0")
    tilted = joint("l", "c", "d", xyz="0.1 0 0").replace('axis xyz="0 0', 'axis xyz="0 4e-5')
    arm = from_urdf(robot(*map(link, "abcd"), joint("j", "a", "b"), turned, tilted))
    assert [arm.number(row.alpha) for row in arm.rows] == [math.pi, 0, 0]
    assert arm.source.endswith(
        "joints j, k, l; angles of 2 joints are taken as the right angles that they are within"
        " 4e-05 rad of"
    )
    turned = turned.replace("3.1416", "3.1418")
    with pytest.warns(UserWarning, match="of parallel"):
        skew = from_urdf(robot(*map(link, "abc"), joint("j", "a", "b"), turned))
    assert "right angle" not in skew.source
    assert [row.alpha for row in skew.rows] != ["pi", 0]


def test_base_may_be_fixed_beside_the_chain():
    """UR's controller frame "base" is fixed to base_link, turned by half a turn."""
    beside = joint("side", "base", "controller", "fixed", xyz="0 0 0.2", rpy="0 0 3.1415926535")
    text = robot(*LINKS, link("controller"), *JOINTS, beside)
    q, T = [0.4, -0.9], np.diag([-1.0, -1.0, 1.0, 1.0])
    T[2, 3] = -0.2
    for tip in ("tool", None):
        arm = from_urdf(text, "controller", tip)
        expected = T @ forward_kinematics(from_urdf(TWO), q)
        assert forward_kinematics(arm, q) == pytest.approx(expected, abs=1e-12)
    with pytest.raises(ArmError, match="base does not lie beyond upper"):
        from_urdf(text, "upper", "base")


def test_base_may_be_fixed_behind_two_turned_joints():
    """The links after the base turn by a right angle about x, then about z."""
    mount = joint("mount", "base", "plate", "fixed", xyz="0.1 0 0.2", rpy=f"{RIGHT} 0 0")
    behind = joint("side", "plate", "controller", "fixed", xyz="0 0.3 0", rpy=f"0 0 {RIGHT}")
    text = robot(*LINKS, link("plate"), link("controller"), *JOINTS, mount, behind)
    controller = np.array([[0, -1, 0, 0.1], [0, 0, -1, 0], [1, 0, 0, 0.5], [0, 0, 0, 1]])
    q = [0.4, -0.9]
    expected = np.linalg.inv(controller) @ forward_kinematics(from_urdf(TWO), q)
    arm = from_urdf(text, "controller", "tool")
    assert forward_kinematics(arm, q) == pytest.approx(expected, abs=1e-12)


def test_blank_first_line_and_missing_meshes_are_accepted(tmp_path):
    mesh = '<visual><geometry><mesh filename="package://nowhere/a.stl"/></geometry></visual>'
    text = "\n  " + TWO.replace('<link name="base"/>', f'<link name="base">{mesh}</link>')
    path = tmp_path / "two.URDF"
    path.write_text(text, encoding="utf-8")
    assert from_urdf(text) == from_urdf(path) == from_urdf(TWO) == read_arm(str(path))


def test_command_line_passes_tolerance(tmp_path):
    path = tmp_path / "arm.urdf"
    skew = joint("k", "b", "c", xyz="0 0.1 0", rpy="3.1418 0 0")
    path.write_text(robot(*map(link, "abc"), joint("j", "a", "b"), skew), encoding="utf-8")
    flat = read_arm(str(path), tolerance=1e-3)
    assert [flat.number(row.a) for row in flat.rows] == [0.1, 0]
