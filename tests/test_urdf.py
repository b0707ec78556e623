"""Robot descriptions: read right, and refused in words where they are no serial arm."""

import math

import numpy as np
import pytest

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
    shoulder, elbow = (row.joint for row in arm.rows if row.joint.kind != "fixed")
    assert (shoulder.lower, shoulder.upper, shoulder.speed, shoulder.effort) == (-1, 2, 3, 4)
    assert (elbow.lower, elbow.upper, elbow.speed, elbow.effort) == (
        -math.inf,
        math.inf,
        math.inf,
        math.inf,
    )


def test_the_tip_where_the_lengths_put_it():
    """At 0: 1 m up, 0.6 m out, then 0.4 m along the tilted frame's y, which points up."""
    arm = from_urdf(TWO)
    np.testing.assert_allclose(forward_kinematics(arm, [0, 0])[:3, 3], [0.6, 0, 1.4], atol=1e-15)
    np.testing.assert_allclose(
        forward_kinematics(arm, [math.pi / 2, 0])[:3, 3], [0, 0.6, 1.4], atol=1e-15
    )


def test_fixed_links_ride_along():
    """The elbow holds the forearm's kilogram 0.2 m up and the tool's half 0.4 m up; turned to the
    side they weigh."""
    arm = from_urdf(TWO)
    torque = 9.81 * (1 * 0.2 + 0.5 * 0.4)
    np.testing.assert_allclose(gravity_torque(arm, [0, 0]), [0, 0], atol=1e-12)
    np.testing.assert_allclose(abs(gravity_torque(arm, [0, math.pi / 2])), [0, torque], atol=1e-12)


def test_a_normal_that_points_back_makes_half_a_turn():
    """And a link without a mass among others has none."""
    crossed = joint("k", "b", "c", xyz="-0.4 0.1 0", rpy=f"{RIGHT} 0 0")
    arm = from_urdf(robot(link("a"), link("b"), link("c", 1), joint("j", "a", "b"), crossed))
    assert arm.number(arm.rows[0].a) == 0.4
    assert arm.bodies[0].mass == 0


def test_without_masses_there_are_no_bodies():
    links = [link(name) for name in ("base", "upper", "fore", "tool")]
    assert from_urdf(robot(*links, *JOINTS)).bodies == ()


def test_a_file_is_read_as_its_text_is(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(TWO, encoding="utf-8")
    assert from_urdf(path) == from_urdf(str(path)) == from_urdf(TWO)
    latin = robot(*LINKS, *JOINTS, name="zwölf").replace("?>", ' encoding="iso-8859-1"?>')
    assert from_urdf(robot(*LINKS, *JOINTS, "<a>" * 99 + "</a>" * 99)) == from_urdf(TWO)
    path.write_text(latin, encoding="iso-8859-1")
    assert from_urdf(path).name == from_urdf(latin).name == "zwölf"


def test_a_part_of_the_chain_and_a_name():
    arm = from_urdf(TWO, "upper", "fore", name="elbow only")
    assert (arm.name, arm.dof) == ("elbow only", 1)


def test_zero_speed_and_effort_are_not_given():
    limit = '<limit lower="-1" upper="2" velocity="0" effort="0"/>'
    arm = from_urdf(robot(link("a"), link("b"), joint("j", "a", "b", inside=limit)))
    assert (arm.speed_limits[0], arm.effort_limits[0]) == (math.inf, math.inf)


def test_one_limit_left_out_is_zero_both_are_unknown():
    one = joint("j", "a", "b", inside='<limit upper="2" velocity="1" effort="1"/>')
    none = joint("j", "a", "b", inside='<limit velocity="1" effort="1"/>')
    links = link("a"), link("b")
    assert from_urdf(robot(*links, one)).limits[0][0] == 0
    assert from_urdf(robot(*links, none)).limits[0][0] == -math.inf


FINGERS = [link("left", 0.1), link("right", 0.1)]
GRIP = [
    joint("left_finger", "tool", "left", "prismatic", LIMIT, xyz="0.1 0 0"),
    joint("right_finger", "tool", "right", "prismatic", LIMIT, xyz="-0.1 0 0"),
]
GRIPPER = robot(*LINKS, *FINGERS, *JOINTS, *GRIP)


def test_held_fingers_ride_along():
    with pytest.raises(ArmError, match=r"joint \w+_finger on tool branches off .*hold=\{'\w+_fing"):
        from_urdf(GRIPPER, tip="tool")
    arm = from_urdf(GRIPPER, tip="tool", hold={"left_finger": 0.5, "right_finger": 0.0})
    torque = 9.81 * (1 * 0.2 + 0.7 * 0.4)
    held = abs(gravity_torque(arm, [0, math.pi / 2])[1])
    # A finger that is out by 0.5 m along the elbow's axis changes no torque about it.
    assert held == pytest.approx(torque, abs=1e-12)


def test_a_held_joint_on_the_chain_is_locked():
    bent = from_urdf(TWO, hold={"elbow": math.pi / 2})
    free = from_urdf(TWO)
    np.testing.assert_allclose(
        forward_kinematics(bent, [0.3]), forward_kinematics(free, [0.3, math.pi / 2]), atol=1e-15
    )
    slid = from_urdf(GRIPPER, tip="left", hold={"left_finger": 0.5, "right_finger": 0})
    still = from_urdf(GRIPPER, tip="left", hold={"left_finger": 0.0, "right_finger": 0})
    gap = forward_kinematics(slid, [0, 0]) - forward_kinematics(still, [0, 0])
    assert np.linalg.norm(gap[:3, 3]) == pytest.approx(0.5)


MIMIC = '<mimic joint="shoulder"/>'
LOOP = robot(link("a"), link("b"), joint("j", "a", "b"), joint("k", "b", "a"))
BOMB = '<!DOCTYPE r [<!ENTITY a "ha"><!ENTITY b "&a;&a;">]><robot name="&b;"/>'
OUTSIDE = '<!DOCTYPE r [<!ENTITY a SYSTEM "file:///etc/passwd">]><robot name="&a;"/>'
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="a"/></robot>'

REFUSED = {
    "branches": (GRIPPER, {}, r"two branches: beyond base the last links are left, right; say whi"),
    "mimic": (
        robot(*LINKS[:2], joint("m", "base", "upper", inside=MIMIC)),
        {},
        r"joint m mimics shoulder; expected joints that move by themselves.*hold=\{'m': 0.0\}",
    ),
    "planar": (
        robot(*LINKS[:2], joint("m", "base", "upper", "planar")),
        {},
        "joint m is planar; a table has rows for",
    ),
    "floating": (
        robot(*LINKS[:2], joint("m", "base", "upper", "floating")),
        {},
        "joint m is floating; a table has rows for",
    ),
    "no type": (robot(*LINKS[:2], joint("m", "base", "upper", "")), {}, "joint m is ; a table has"),
    "a floating branch": (
        robot(*LINKS, link("cup"), *JOINTS, joint("m", "tool", "cup", "floating")),
        {"tip": "tool"},
        "joint m is floating",
    ),
    "two roots": (robot(link("a"), link("b")), {}, "links without a parent are a, b; expected one"),
    "a loop": (LOOP, {}, "two: links a, b go round in a circle; expected a tree"),
    "a loop with its ends": (LOOP, {"base": "a", "tip": "b"}, "links a, b go round in a circle"),
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
    "a joint twice": (robot(*LINKS, *JOINTS, JOINTS[0]), {}, "joints called shoulder are 2"),
    "a link that is none": (robot(link("a"), joint("j", "a", "b")), {}, "names a link 'b'; there"),
    "a joint without a child": (
        robot(link("a"), '<joint name="j"><parent link="a"/></joint>'),
        {},
        "joint j has no child; expected <child link=...>",
    ),
    "no name": (robot("<link/>"), {}, "a link has no name; expected <link name=...>"),
    "no links": (robot(), {}, "two has no links; expected a robot description"),
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
    "two numbers": (
        robot(*LINKS[:2], joint("m", "base", "upper", rpy="0 0")),
        {},
        "the rpy of m is '0 0'; expected three finite numbers",
    ),
    "no axis": (
        robot(*LINKS[:2], joint("m", "base", "upper").replace("0 0 1", "0 0 0")),
        {},
        "the axis of m is 0 0 0; expected a direction",
    ),
    "a negative mass": (
        robot(link("a"), link("b", -1), joint("j", "a", "b")),
        {},
        "link b has mass -1.0; expected a number of kg, 0 or more",
    ),
    "a mass without a value": (
        robot(link("a"), link("b", 1).replace("value", "val"), joint("j", "a", "b")),
        {},
        "link b has mass None; expected",
    ),
    "an entity bomb": (BOMB, {}, "has a document type, which a robot description does not need"),
    "an entity from outside": (OUTSIDE, {}, "has a document type"),
    "nested without end": ("<a>" * 101 + "</a>" * 101, {}, "nests more than 100 elements"),
    "cut off": (TWO[:-20], {}, r"the text is no XML \(.*\); expected a robot description"),
    "not XML": ("<<<", {}, "the text is no XML"),
    "another document": ("<sdf/>", {}, "the text is a <sdf>; expected a robot description"),
    "a xacro": (XACRO, {}, "is a xacro, a recipe for a robot description; run xacro on it first"),
    "no such file": ("nowhere.urdf", {}, "source is 'nowhere.urdf'; expected a file that exists"),
    "a path with a zero byte": ("a\0b", {}, r"source is 'a\\x00b'"),
    "a path that is too long": ("a" * 5000, {}, "cannot be read|expected a file that exists"),
    "a hold for no joint": (
        TWO,
        {"hold": {"wrist": 0}},
        "no joint 'wrist' can be held; expected one of shoulder, elbow",
    ),
    "a hold among nine joints": (
        robot(*map(link, "abcdefghij"), *map(joint, "123456789", "abcdefghi", "bcdefghij")),
        {"hold": {"wrist": 0}},
        "expected one of 1, 2, 3, 4, 5, 6, 7, 8 and 1 more",
    ),
    "a hold for a fixed joint": (TWO, {"hold": {"flange": 0}}, "no joint 'flange' can be held"),
    "a hold beyond the limits": (
        TWO,
        {"hold": {"shoulder": 3}},
        "shoulder is held at 3; its limits are -1 to 2",
    ),
    "a hold in words": (TWO, {"hold": {"elbow": "bent"}}, "the value of elbow is 'bent'; expected"),
    "everything held": (
        TWO,
        {"hold": {"elbow": 0, "shoulder": 0}},
        "nothing moves from base to to",
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


def test_a_file_that_is_too_large(tmp_path, monkeypatch):
    path = tmp_path / "large.urdf"
    path.write_text(TWO, encoding="utf-8")
    monkeypatch.setattr("helpers.urdf.elements._MOST", 100)
    for source, what in ((path, "large.urdf"), (TWO, "the text")):
        with pytest.raises(ArmError, match=f"{what} has more than 100 bytes"):
            from_urdf(source)


def test_a_description_of_many_links_is_read_in_one_go_over_each(monkeypatch):
    """Counted, not timed: looking through all names for each name would compare them in pairs."""
    looks = 0

    class Name(str):
        def __eq__(self, other):
            nonlocal looks
            looks += 1
            return super().__eq__(other)

        __hash__ = str.__hash__

    monkeypatch.setattr("helpers.urdf.tree.read_name", lambda element, _: Name(element.get("name")))
    names = [f"l{i}" for i in range(300)]
    joints = [joint(f"j{i}", *names[i : i + 2], "fixed") for i in range(298)]
    from_urdf(robot(*map(link, names), *joints, joint("last", *names[-2:])))
    assert looks < 10 * len(names)


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
