"""Robot descriptions: read right, and refused in words where they are no serial arm."""

import math

import numpy as np
import pytest
from scipy.linalg import expm

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


def test_a_chain_with_its_limits_and_names():
    arm = from_urdf(TWO)
    assert arm.name == "two"
    assert arm.source == "robot description: base to tool; joints shoulder, elbow"
    found = (arm.limits[0], arm.limits[1], arm.speed_limits, arm.effort_limits)
    assert np.transpose(found).tolist() == [[-1, 2, 3, 4], [-math.inf, *[math.inf] * 3]]


def test_the_tip_where_the_lengths_put_it():
    """At 0: 1 m up, 0.6 m out, then 0.4 m along the tilted frame's y, which points up."""
    arm = from_urdf(TWO)
    np.testing.assert_allclose(forward_kinematics(arm, [0, 0])[:3, 3], [0.6, 0, 1.4], atol=1e-15)
    np.testing.assert_allclose(
        forward_kinematics(arm, [math.pi / 2, 0])[:3, 3], [0, 0.6, 1.4], atol=1e-15
    )


def test_without_masses_there_are_no_bodies():
    links = [link(name) for name in ("base", "upper", "fore", "tool")]
    assert from_urdf(robot(*links, *JOINTS)).bodies == ()


def test_a_file_is_read_as_its_text_is(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(TWO, encoding="utf-8")
    assert from_urdf(path) == from_urdf(str(path)) == from_urdf(TWO)
    latin = robot(*LINKS, *JOINTS, name="zwölf").replace("?>", ' encoding="iso-8859-1"?>')
    assert from_urdf(robot(*LINKS, *JOINTS, "<a>" * 10**5 + "</a>" * 10**5)) == from_urdf(TWO)
    path.write_text(latin, encoding="iso-8859-1")
    assert from_urdf(path).name == from_urdf(latin).name == "zwölf"


def test_a_part_of_the_chain_and_a_name():
    arm = from_urdf(TWO, "upper", "fore", name="elbow only")
    assert (arm.name, arm.dof) == ("elbow only", 1)


@pytest.mark.parametrize(
    ("given", "limits"),
    [
        ('lower="-1" upper="2" velocity="3" effort="4"', (-1, 2, 3, 4)),
        ('lower="-1" upper="2" velocity="0" effort="0"', (-1, 2, math.inf, math.inf)),
        ('upper="2" velocity="1" effort="1"', (0, 2, 1, 1)),
        ('velocity="1" effort="1"', (-math.inf, math.inf, 1, 1)),
    ],
)
def test_a_limit_left_out_is_zero_and_what_is_zero_is_not_given(given, limits):
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


def test_what_hangs_beside_the_chain_rides_along_at_0():
    """Also a cup that floats, and a finger that a mimic would move."""
    cup = link("cup", 1), joint("m", "tool", "cup", "floating", MIMIC, xyz="0 0 0")
    for more, mass in (((), 0.7), (cup, 1.7)):
        arm = from_urdf(robot(*LINKS, *FINGERS, *JOINTS, *GRIP, *more), tip="tool")
        assert arm.dof == 2
        held = abs(gravity_torque(arm, [0, math.pi / 2])[1])
        assert held == pytest.approx(9.81 * (1 * 0.2 + mass * 0.4), abs=1e-12)
    out = from_urdf(GRIPPER, tip="left")
    gap = forward_kinematics(out, [0, 0, 0.5]) - forward_kinematics(out, [0, 0, 0])
    assert np.linalg.norm(gap[:3, 3]) == pytest.approx(0.5)


def test_a_turned_frame_is_turned_about_x_then_y_then_z_of_the_parent():
    """As the format says: rpy are angles about the fixed axes of the parent."""
    angles = 0.3, -0.4, 0.9
    rpy = " ".join(map(str, angles))
    arm = from_urdf(robot(link("a"), link("b"), link("c"), joint("j", "a", "b", xyz="0 0 0"),
                          joint("k", "b", "c", "fixed", rpy=rpy)))  # fmt: skip
    roll, pitch, yaw = (
        expm(angle * np.cross(np.eye(3), axis))
        for angle, axis in zip(angles, np.eye(3), strict=True)
    )
    np.testing.assert_allclose(forward_kinematics(arm, [0])[:3, :3], yaw @ pitch @ roll, atol=1e-12)


LOOP = robot(link("a"), link("b"), joint("j", "a", "b"), joint("k", "b", "a"))
BOMB = '<!DOCTYPE r [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]><robot name="&b;"/>'
OUTSIDE = '<!DOCTYPE r [<!ENTITY a SYSTEM "file:///etc/passwd">]><robot name="&a;"/>'
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="a"/></robot>'

REFUSED = {
    "branches": (GRIPPER, {}, r"links at the end beyond base are left, right; expected one"),
    "mimic": (
        robot(*LINKS[:2], joint("m", "base", "upper", inside=MIMIC)),
        {},
        "joint m mimics another; a table has rows for",
    ),
    "planar": (
        robot(*LINKS[:2], joint("m", "base", "upper", "planar")),
        {},
        "joint m is planar; a table has rows for",
    ),
    "two roots": (robot(link("a"), link("b")), {}, "links without a parent are a, b; expected one"),
    "a loop": (LOOP, {}, "two: links a, b go round in a circle; expected a tree"),
    "a loop beside a root": (
        LOOP.replace("</robot>", '<link name="w"/></robot>'),
        {},
        "two: links a, b go round in a circle; expected a tree",
    ),
    "nowhere to go": (TWO, {"base": "tool"}, "nothing moves from tool to tool"),
    "the wrong way": (TWO, {"base": "tool", "tip": "base"}, "base does not lie beyond tool"),
    "an unknown base": (TWO, {"base": "hand"}, "base is 'hand'; expected a link, one of base, upp"),
    "an unknown tip": (TWO, {"tip": 3}, "tip is 3; expected a link"),
    "two parents": (
        robot(*LINKS, *JOINTS, joint("extra", "base", "tool")),
        {},
        "joints that carry link tool are 2; expected one",
    ),
    "a link twice": (robot(link("a"), link("a")), {}, "links called a are 2; expected one"),
    "a link that is none": (robot(link("a"), joint("j", "a", "b")), {}, "names a link 'b'; there"),
    "a joint without a child": (
        robot(link("a"), '<joint name="j"><parent link="a"/></joint>'),
        {},
        "the child of joint j has no link; expected link=",
    ),
    "no name": (robot("<link/>"), {}, "a link has no name; expected name="),
    "no links": (robot(), {}, "two: links without a parent are ; expected one"),
    "limits upside down": (
        robot(*LINKS[:2], joint("m", "base", "upper", inside='<limit lower="1" upper="-1"/>')),
        {},
        "joint m has limits 1 to -1; expected lower <= upper",
    ),
    "a limit in words": (
        robot(*LINKS[:2], joint("m", "base", "upper", inside='<limit lower="low"/>')),
        {},
        "m: lower is 'low'; expected a finite number",
    ),
    "NaN": (
        robot(*LINKS[:2], joint("m", "base", "upper", xyz="0 0 nan")),
        {},
        "the xyz of m is '0 0 nan'; expected three finite numbers",
    ),
    "no axis": (
        robot(*LINKS[:2], joint("m", "base", "upper").replace("0 0 1", "0 0 0")),
        {},
        "the axis of m is 0 0 0; expected a direction",
    ),
    "a negative mass": (
        robot(link("a"), link("b", -1), joint("j", "a", "b")),
        {},
        "the mass of b is -1.0; expected a number of kg, 0 or more",
    ),
    "a mass without a value": (
        robot(link("a"), link("b", 1).replace("value", "val"), joint("j", "a", "b")),
        {},
        "the mass of b is nan; expected",
    ),
    "an entity bomb": (BOMB, {}, "has a document type, which a robot description does not need"),
    "an entity from outside": (OUTSIDE, {}, "has a document type"),
    "nested without end": ("<a>" * 10**5 + "</a>" * 10**5, {}, "is a <a>; expected"),
    "cut off": (TWO[:-20], {}, r"the text is no XML \(.*\); expected a robot description"),
    "not XML": ("<<<", {}, "the text is no XML"),
    "another document": ("<sdf/>", {}, "the text is a <sdf>; expected a robot description"),
    "a xacro": (XACRO, {}, "is a xacro, to be run first; expected a robot description"),
    "no such file": ("nowhere.urdf", {}, "source is 'nowhere.urdf'; expected a file that exists"),
    "a path that is too long": ("a" * 5000, {}, "cannot be read|expected a file that exists"),
    "a base among ten links": (
        robot(*map(link, "abcdefghij"), *map(joint, "123456789", "abcdefghi", "bcdefghij")),
        {"base": "wrist"},
        "one of a, b, c, d, e, f, g, h and 2 more",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refused_in_words(case):
    source, arguments, words = REFUSED[case]
    with pytest.raises(ArmError, match=words):
        from_urdf(source, **arguments)


def test_a_folder_and_an_endless_file_are_no_files(tmp_path):
    for path in (tmp_path, "/dev/zero"):
        with pytest.raises(ArmError, match="expected a file that exists"):
            from_urdf(path)


def test_rounded_angles_are_warned_of_with_the_tolerance_that_takes_them():
    """A roll of 3.1416 between parallel axes 0.1 m apart: the common normal is 14 km away."""
    turned = joint("k", "b", "c", xyz="0 0.1 0", rpy="3.1416 0 0")
    text = robot(*map(link, "abc"), joint("j", "a", "b"), turned)
    with pytest.warns(UserWarning, match=r"z_0 and z_1 .* \(d_1 = \S+ m\); a tol.* above 7e-06"):
        far = from_urdf(text)
    assert abs(far.values["d_1"]) > 1e4
    flat = from_urdf(text, tolerance=1e-5)
    assert [flat.number(row.a) for row in flat.rows] == [0.1, 0]


def test_a_side_branch_on_the_base_may_move():
    """What hangs on the base never loads the arm."""
    other = [link("cart", 5), joint("wheel", "base", "cart")]
    arm = from_urdf(robot(*LINKS, *other[:1], *JOINTS, *other[1:]), tip="tool")
    assert gravity_torque(arm, [0.3, 1.0]) == pytest.approx(
        gravity_torque(from_urdf(TWO), [0.3, 1.0])
    )
