"""Read a serial arm from a robot description (URDF) by its joint axes at q = 0.

The chain of joints from one link to another is read with its limits, speeds, efforts, masses,
centres of mass and inertia tensors. Fixed joints are merged into their neighbours. The masses of
side branches count with their joints at 0. The file is read as data only: by `xml.etree` of the
standard library, without a document type, and no file that it names is opened. Source of the
format: the URDF XML specification, wiki.ros.org/urdf/XML (elements joint, link and inertial).
"""

import math
import os
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm, ArmError, Joint
from helpers.derive import Axis, derive
from helpers.inputs import finite_number, shorten
from helpers.rows import Kind, rotation_from_angles

__all__ = ["from_urdf"]

Array = NDArray[np.float64]

_KINDS: dict[str, Kind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
}
_MISSING_NUMBER = (math.nan,)

# Advice for a file of another format, by its root element.
_OTHER_FORMATS = {
    "sdf": "an SDF model of Gazebo; give the robot's URDF, from which most SDF models are made",
    "mujoco": "an MJCF model of MuJoCo; give the robot's URDF, which its README mostly names",
}


def from_urdf(
    source: str | os.PathLike[str],
    base: str | None = None,
    tip: str | None = None,
    *,
    tolerance: float = 1e-9,
    angle_tolerance: float = 1e-4,
) -> Arm:
    """Read an arm from a robot description, in standard Denavit-Hartenberg form.

    The joints keep the zeros and signs of the file, so q is the file's. A limit of 0 for speed or
    effort counts as unknown, because many files write 0 there. Files round right angles, to 1.5708
    for instance; such angles are taken as exact, and the arm's `source` says so. Other rounded
    angles can give the warning of `helpers.derive.derive`, which a larger tolerance mends.

    Args:
        source: The file's path, or its text.
        base: Name of the link where the chain begins; by default the one without a parent. It may
            be fixed to a link of the chain, as UR's "base" is to "base_link".
        tip: Name of the link where it ends; by default the last one, if there is only one.
        tolerance: As for `helpers.derive.derive`.
        angle_tolerance: Angles this close (rad) to a multiple of a right angle are taken as that;
            0 takes every angle as it stands.

    Raises:
        ArmError: The file is no robot description, or the chain has a planar or floating joint, or
            one that follows another joint (mimic).

    Example:
        >>> text = '''<robot name="slide"><link name="a"/><link name="b"/>
        ... <joint name="j" type="prismatic"><parent link="a"/><child link="b"/>
        ... <axis xyz="0 0 1"/></joint></robot>'''
        >>> from_urdf(text)
        <Arm slide: 1 rows, P>
    """
    expected = "a number of rad, 0 or more"
    angle_tolerance = finite_number(angle_tolerance, "angle_tolerance", expected, least=0)
    tree = _read_tree(_read_robot(source), angle_tolerance)
    if base is None:
        base = tree.require_single(tree.roots, "without a parent")
    base = tree.require_link(base, "base")
    if tip is None:
        tip = tree.require_single(tree.ends_from(base), f"at the end beyond {base}")
    tip = tree.require_link(tip, "tip")
    pose, chain = tree.chain(base, tip)
    bodies = tree.bodies_with_branches(chain)

    # Follow the chain at q = 0, in base axes. A joint carries the masses up to the next joint.
    axes, carried = [], []
    for joint in chain:
        pose = pose @ joint.origin
        if joint.kind != "fixed":
            axes.append(joint.as_axis(pose))
            carried.append(np.zeros((4, 4)))
        if carried:
            carried[-1] += pose @ bodies[joint.child] @ pose.T
    if not axes:
        raise ArmError(
            f"{tree.name}: nothing moves from {base} to {tip}; expected a joint that does"
        )
    derivation = derive(axes, pose, name=tree.name, tolerance=tolerance)
    arm, moments = derivation.arm, np.array(carried)
    if (masses := moments[:, 3, 3]).any():
        centres = moments[:, :3, 3] / np.where(masses, masses, 1)[:, None]
        squares = masses[:, None, None] * centres[:, :, None] * centres[:, None, :]
        spread = moments[:, :3, :3] - squares
        inertias = np.trace(spread, axis1=1, axis2=2)[:, None, None] * np.eye(3) - spread
        # 1e-14 is the relative round-off of the products in the differences above
        largest = np.abs(moments).max(axis=(1, 2), keepdims=True)
        inertias = np.where(np.abs(inertias) < 1e-14 * largest, 0.0, inertias)
        arm = derivation.with_bodies(masses, centres, inertias)

    moving = ", ".join(joint.name for joint in chain if joint.kind != "fixed")
    source = f"robot description: {base} to {tip}; joints {moving}"
    if changes := [joint.angle_change for joint in chain if joint.angle_change > 1e-11]:
        source += (
            f"; angles of {len(changes)} joints are taken as the right angles that they are within"
            f" {max(changes):.1g} rad of"
        )
    if points := tree.point_masses_moved_by(chain):
        source += f"; without inertia tensors, so taken as point masses: {_list_names(points)}"
    return replace(arm, source=source)


@dataclass(frozen=True, eq=False)
class _FileJoint:
    """A joint of the file.

    Attributes:
        name: Its name.
        kind: Its type, as the file writes it.
        parent: Name of the link that carries it.
        child: Name of the link that it moves.
        origin: Pose of the child's frame in the parent's at q = 0, 4x4.
        element: The element <joint>.
        direction: Direction of its axis in the child's frame, shape (3,).
        angle_change: Largest change, in rad, that rounding made to an angle of its origin or axis.
    """

    name: str
    kind: str
    parent: str
    child: str
    origin: Array
    element: ET.Element
    direction: Array
    angle_change: float

    def as_axis(self, pose: Array) -> Axis:
        """Return the joint's axis in base axes.

        Args:
            pose: Pose of the child's frame in base axes, 4x4.

        Raises:
            ArmError: No row of a table moves as the joint does.
        """
        if self.kind not in _KINDS:
            raise ArmError(
                f"joint {self.name} is {self.kind}; a table has rows for revolute, continuous,"
                " prismatic and fixed joints. Begin the chain beyond it, with base ="
                f" {self.child!r}, or end it before, with tip = {self.parent!r}"
            )
        if (mimic := self.element.find("mimic")) is not None:
            raise ArmError(
                f"joint {self.name} follows joint {mimic.get('joint')} (mimic); a row of a table"
                " moves by itself. End the chain before it, with tip ="
                f" {self.parent!r}, or remove <mimic> to move it by itself"
            )
        if not self.direction.any():
            raise ArmError(f"the axis of {self.name} is 0 0 0; expected a direction")
        # A missing or zero range, speed or effort means that it is unlimited.
        limit = self.element.find("limit")
        lower, upper, speed, effort = (
            float(_read_numbers(limit, key, f"{self.name}: {key}", _MISSING_NUMBER)[0])
            for key in ("lower", "upper", "velocity", "effort")
        )
        if self.kind == "continuous" or (math.isnan(lower) and math.isnan(upper)):
            lower, upper = -math.inf, math.inf
        lower, upper = (0.0 if math.isnan(end) else end for end in (lower, upper))
        if lower > upper:
            raise ArmError(
                f"joint {self.name} has limits {lower:g} to {upper:g}; expected lower <= upper"
            )
        speed, effort = (abs(x) if abs(x) > 0 else math.inf for x in (speed, effort))
        limits = Joint(_KINDS[self.kind], lower, upper, speed, effort)
        return Axis(tuple(pose[:3, 3]), tuple(pose[:3, :3] @ self.direction), limits)


@dataclass(frozen=True, eq=False)
class _Tree:
    """The links and joints of a file.

    Attributes:
        name: Name of the robot.
        bodies: For each link its body, as `_read_body` returns it.
        point_masses: The links that have a mass and no inertia tensor, or one of zeros.
        joints: The joints; each comes after those that carry it.
    """

    name: str
    bodies: dict[str, Array]
    point_masses: set[str]
    joints: list[_FileJoint]

    @property
    def roots(self) -> list[str]:
        """Names of the links without a parent."""
        carried = {joint.child for joint in self.joints}
        return [link for link in self.bodies if link not in carried]

    def ends_from(self, base: str) -> list[str]:
        """Return the last links beyond the base, or beyond the links to which it is fixed."""
        carriers = {joint.parent for joint in self.joints}
        for root in (base, list(self.fixed_ancestors(base))[-1]):
            beyond = {root}
            for joint in self.joints:
                if joint.parent in beyond:
                    beyond.add(joint.child)
            if ends := sorted(beyond - carriers - {base}):
                return ends
        return [base]

    def require_single(self, links: list[str], where: str) -> str:
        """Return the only link of a list.

        Raises ArmError if there are none or several.
        """
        if len(links) == 1:
            return links[0]
        raise ArmError(
            f"{self.name}: links {where} are {_list_names(links)}; expected one. Say which link"
            " begins the chain and which ends it, with base and tip (--base and --tip at the"
            " command line)"
        )

    def require_link(self, name: object, argument: str) -> str:
        """Return the name of a link.

        Raises ArmError if there is no such link.
        """
        if isinstance(name, str) and name in self.bodies:
            return name
        raise ArmError(
            f"{self.name}: {argument} is {shorten(name)}; expected a link, one of"
            f" {_list_names(self.bodies)}"
        )

    def fixed_ancestors(self, base: str) -> dict[str, Array]:
        """Return the links to which `base` is fixed, itself first, with their poses in `base`."""
        above = {joint.child: joint for joint in self.joints}
        link, pose = base, np.eye(4)
        poses = {base: pose}
        while link in above and above[link].kind == "fixed":
            pose = pose @ np.linalg.inv(above[link].origin)
            link = above[link].parent
            poses[link] = pose
        return poses

    def chain(self, base: str, tip: str) -> tuple[Array, list[_FileJoint]]:
        """Return the joints from the link `base` to the link `tip`.

        Where `base` is fixed to a link of the chain, the chain begins with that link.

        Returns:
            The pose of the first link in `base`, 4x4, and the joints.
        """
        starts = self.fixed_ancestors(base)
        above = {joint.child: joint for joint in self.joints}
        joints, link = [], tip
        while link not in starts:
            if link not in above:
                raise ArmError(
                    f"{self.name}: {tip} does not lie beyond {base}; expected a chain from base to"
                    " tip"
                )
            joints.append(above[link])
            link = above[link].parent
        return starts[link], joints[::-1]

    def bodies_with_branches(self, chain: Sequence[_FileJoint]) -> dict[str, Array]:
        """Return the body of each link, including the side branches that it carries."""
        bodies, on_chain = dict(self.bodies), set(chain)
        for joint in reversed(self.joints):
            if joint not in on_chain:
                carried = joint.origin @ bodies[joint.child] @ joint.origin.T
                bodies[joint.parent] = bodies[joint.parent] + carried
        return bodies

    def point_masses_moved_by(self, chain: Sequence[_FileJoint]) -> list[str]:
        """Return the moving links that have a mass and no inertia tensor."""
        moving: set[str] = set()
        for joint in self.joints:
            if joint.parent in moving or (joint in chain and joint.kind != "fixed"):
                moving.add(joint.child)
        return [link for link in self.bodies if link in moving & self.point_masses]


# Reading the file


def _read_robot(source: str | os.PathLike[str]) -> ET.Element:
    """Return the element <robot> of a file or a text."""
    if isinstance(source, str) and "<" in source:
        text, name = source.encode("utf-8", "replace"), "the text"
        parser = ET.XMLParser(encoding="utf-8")
    elif isinstance(source, str | os.PathLike):
        try:
            is_file = Path(source).is_file()
            text = Path(source).read_bytes() if is_file else b""
        except (OSError, ValueError) as error:
            raise ArmError(f"source is {shorten(source)}, which cannot be read: {error}") from None
        if not is_file:
            raise ArmError(
                f"source is {shorten(source)}; expected a file that exists, or a text with <robot>"
            )
        name, parser = os.fspath(source), ET.XMLParser()
    else:
        raise ArmError(f"source is {shorten(source)}; expected a file's path, or its text")
    if b"<!DOCTYPE" in text:
        raise ArmError(f"{name} has a document type, which a robot description does not need")
    try:
        # XML forbids a blank first line, but copied text often has one.
        root = ET.fromstring(text.lstrip(), parser)
    except (ET.ParseError, LookupError, ValueError) as error:
        raise ArmError(f"{name} is no XML ({error}); expected a robot description") from None
    if root.tag != "robot":
        kind = _OTHER_FORMATS.get(
            root.tag, f"a <{root.tag}>; expected a robot description, <robot>"
        )
        raise ArmError(f"{name} is {kind}")
    if any("xacro" in str(element.tag) or "${" in str(element.attrib) for element in root.iter()):
        raise ArmError(
            f"{name} holds xacro macros; expand them first, by `xacro arm.urdf.xacro > arm.urdf`,"
            " and give arm.urdf"
        )
    return root


def _read_tree(robot: ET.Element, angle_tolerance: float) -> _Tree:
    """Read the links and joints of a robot, and check that they form a tree."""
    name = robot.get("name") or "robot"
    links = [(_require_attribute(link, "name", "a link"), link) for link in robot.findall("link")]
    joints = [_read_joint(element, angle_tolerance) for element in robot.findall("joint")]
    for names, description in (
        ((link_name for link_name, _ in links), "links called"),
        ((joint.name for joint in joints), "joints called"),
        ((joint.child for joint in joints), "joints that carry link"),
    ):
        for repeated, times in Counter(names).most_common(1):
            if times > 1:
                raise ArmError(f"{name}: {description} {repeated} are {times}; expected one")
    bodies = {link_name: _read_body(link, link_name) for link_name, link in links}
    point_masses = {
        link_name
        for link_name, link in links
        if bodies[link_name][3, 3] and not _read_tensor(link.find("inertial"), link_name).any()
    }
    below: dict[str, list[_FileJoint]] = {link: [] for link in bodies}
    for joint in joints:
        for link in (joint.parent, joint.child):
            if link not in bodies:
                raise ArmError(f"{name}: joint {joint.name} names a link {link!r}; there is none")
        below[joint.parent].append(joint)
    # The loop extends `reached` by the children of each link, so parents come before children.
    reached, ordered = _Tree(name, bodies, point_masses, joints).roots, []
    for link in reached:
        ordered += below[link]
        reached += [joint.child for joint in below[link]]
    if loop := sorted({*bodies} - {*reached}):
        raise ArmError(
            f"{name}: links {_list_names(loop)} go round in a circle; expected a tree of links."
            " Remove the joint that closes the loop"
        )
    return _Tree(name, bodies, point_masses, ordered)


def _read_joint(element: ET.Element, tolerance: float) -> _FileJoint:
    """Read a joint, its angles rounded to right angles that are within the tolerance (rad)."""
    name = _require_attribute(element, "name", "a joint")
    origin, T = element.find("origin"), np.eye(4)
    written = _read_numbers(origin, "rpy", f"the rpy of {name}", (0, 0, 0))
    right = np.round(written / (np.pi / 2)) * (np.pi / 2)
    angles = np.where(np.abs(written - right) <= tolerance, right, written)
    T[:3, :3] = rotation_from_angles(angles)
    T[:3, 3] = _read_numbers(origin, "xyz", f"the xyz of {name}", (0, 0, 0))
    parent, child = (
        _require_attribute(element.find(end), "link", f"the {end} of joint {name}")
        for end in ("parent", "child")
    )
    axis = _read_numbers(element.find("axis"), "xyz", f"the axis of {name}", (1, 0, 0))
    along = np.where(np.arange(3) == np.abs(axis).argmax(), axis, 0.0)  # largest component only
    is_near = np.linalg.norm(axis - along) <= tolerance * np.linalg.norm(along)
    direction = along if is_near else axis
    tilt = np.linalg.norm(direction - axis) / (np.linalg.norm(axis) or 1)
    change = float(max(np.abs(angles - written).max(), tilt))
    kind = element.get("type", "")
    return _FileJoint(name, kind, parent, child, T, element, direction, change)


def _read_body(link: ET.Element, name: str) -> Array:
    """Return the second moments of a link's mass in its own frame, 4x4.

    The integral of p p^T dm with p = (x, y, z, 1) holds the mass, the first moments and, but for
    signs, the inertia tensor. In another frame it is T S T^T, and bodies add up. It is zero where
    the file gives none.
    """
    inertial = link.find("inertial")
    if inertial is None:
        return np.zeros((4, 4))
    mass_name = f"the mass of {name}"
    (mass,) = _read_numbers(inertial.find("mass"), "value", mass_name, _MISSING_NUMBER)
    if not mass >= 0:
        raise ArmError(f"{mass_name} is {mass}; expected a number of kg, 0 or more")
    tensor = _read_tensor(inertial, name)
    origin = inertial.find("origin")
    T = np.eye(4)
    turns = _read_numbers(origin, "rpy", f"the rpy of {name}'s inertia", (0, 0, 0))
    T[:3, :3] = rotation_from_angles(turns)
    T[:3, 3] = _read_numbers(origin, "xyz", f"the centre of mass of {name}", (0, 0, 0))
    moments = np.diag([0.0, 0, 0, mass])
    moments[:3, :3] = np.trace(tensor) / 2 * np.eye(3) - tensor
    return T @ moments @ T.T


def _read_tensor(inertial: ET.Element | None, name: str) -> Array:
    """Return the inertia tensor of a link's element <inertial>, 3x3, or zeros without one."""
    element = None if inertial is None else inertial.find("inertia")
    xx, xy, xz, yy, yz, zz = (
        float(_read_numbers(element, f"i{axes}", f"the i{axes} of {name}", (0,))[0])
        for axes in ("xx", "xy", "xz", "yy", "yz", "zz")
    )
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def _require_attribute(element: ET.Element | None, key: str, owner: str) -> str:
    text = None if element is None else element.get(key)
    if not text:
        raise ArmError(f"{owner} has no {key}; expected {key}=...")
    return text


def _read_numbers(
    element: ET.Element | None, key: str, name: str, default: Sequence[float]
) -> Array:
    """Return the finite numbers of an attribute, or the default where it is missing.

    Args:
        element: The element, or None where the file has none.
        key: The attribute.
        name: What messages call it.
        default: Its default; there must be as many numbers.
    """
    text = None if element is None else element.get(key)
    if text is None:
        return np.array(default, float)
    try:
        # float() would accept 1_000, which is not a number in XML.
        numbers = np.array([float(part) for part in text.replace("_", "x").split()])
    except ValueError:
        numbers = np.empty(0)
    if len(numbers) != len(default) or not np.isfinite(numbers).all():
        expected = "a finite number" if len(default) == 1 else "three finite numbers"
        raise ArmError(f"{name} is {shorten(text)}; expected {expected}")
    return numbers


def _list_names(names: Iterable[str]) -> str:
    """Join up to eight names, and count the others."""
    names = list(names)
    more = f" and {len(names) - 8} more" if len(names) > 8 else ""
    return ", ".join(names[:8]) + more
