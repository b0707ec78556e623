"""A serial arm out of a robot description (URDF): its joint axes at q = 0, and from them its table.

The chain from one link of the tree to another is read with its limits, speeds, efforts, masses and
centres of mass. Fixed joints are folded in, and so are the masses of whatever hangs on the chain at
its side, with its joints at 0. The file is data: only `xml.etree` of the standard library touches
it, a document type is refused, and nothing that it names is opened. Source of the format: the URDF
XML specification, wiki.ros.org/urdf/XML (elements joint, link and inertial).
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
from helpers.inputs import shown
from helpers.rows import Kind, cos_sin

__all__ = ["from_urdf"]

Array = NDArray[np.float64]

_KINDS: dict[str, Kind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
}
_ONE_LIMIT = (math.nan,)  # of a joint, where the file gives none


def from_urdf(
    source: str | os.PathLike[str],
    base: str | None = None,
    tip: str | None = None,
    *,
    tolerance: float = 1e-9,
) -> Arm:
    """The arm from link `base` to link `tip` of a robot description, in standard Denavit-Hartenberg
    form.

    Args:
        source: the file, or its text.
        base: a link; the one without a parent unless given.
        tip: a link beyond it; the last one unless given, where there is only one.
        tolerance: as for `helpers.derive.derive`.

    The joints keep their own zeros and signs, so q is the file's. A limit of 0 for speed or effort
    is taken as not given, for many files write 0 there. Raises ArmError where the file is no robot
    description, and where the chain holds joints that are no single turn or slide (planar,
    floating), or that follow another (mimic). Warns as `derive` does where rounded
    angles put a row's common normal far off the arm, which a larger tolerance mends.
    """
    tree = _tree(_robot(source))
    base = tree.only(tree.roots, "without a parent") if base is None else tree.link(base, "base")
    ends = tree.ends(base)
    tip = tree.only(ends, f"at the end beyond {base}") if tip is None else tree.link(tip, "tip")
    way = tree.way(base, tip)
    axes, pose, loads = _walked(way, tree.carried(way))
    if not axes:
        raise ArmError(
            f"{tree.name}: nothing moves from {base} to {tip}; expected a joint that does"
        )
    found, masses = derive(axes, pose, name=tree.name, tolerance=tolerance), loads[:, 3]
    centres = loads[:, :3] / np.where(masses, masses, 1)[:, None]
    arm = found.with_bodies(masses, centres) if masses.any() else found.arm
    moving = ", ".join(joint.name for joint in way if joint.kind != "fixed")
    return replace(arm, source=f"robot description: {base} to {tip}; joints {moving}")


@dataclass(frozen=True, eq=False)
class _FileJoint:
    """A joint of the file: where its child's frame lies at 0 in its parent's, and how it moves."""

    name: str
    kind: str
    parent: str
    child: str
    origin: Array
    element: ET.Element

    def as_axis(self, pose: Array) -> Axis:
        """Its axis in base axes, where its child's frame has a pose; ArmError where it moves as no
        row of a table can."""
        if self.kind not in _KINDS or self.element.find("mimic") is not None:
            how = f"is {self.kind}" if self.kind not in _KINDS else "mimics another"
            raise ArmError(
                f"joint {self.name} {how}; a table has rows for revolute, continuous, prismatic and"
                " fixed joints, each with a freedom of its own"
            )
        way = _numbers(self.element.find("axis"), "xyz", f"the axis of {self.name}", (1, 0, 0))
        if not way.any():
            raise ArmError(f"the axis of {self.name} is 0 0 0; expected a direction")
        return Axis(tuple(pose[:3, 3]), tuple(pose[:3, :3] @ way), self._limits())

    def _limits(self) -> Joint:
        """The joint's range, speed and effort; infinite where they are not given, or are 0."""
        limit = self.element.find("limit")
        lower, upper, speed, effort = (
            float(_numbers(limit, key, f"{self.name}: {key}", _ONE_LIMIT)[0])
            for key in ("lower", "upper", "velocity", "effort")
        )
        if self.kind == "continuous" or (math.isnan(lower) and math.isnan(upper)):
            lower, upper = -math.inf, math.inf
        lower, upper = (0.0 if math.isnan(end) else end for end in (lower, upper))
        if lower > upper:
            raise ArmError(
                f"joint {self.name} has limits {lower:g} to {upper:g}; expected lower <= upper"
            )
        most = (abs(x) if abs(x) > 0 else math.inf for x in (speed, effort))
        return Joint(_KINDS[self.kind], lower, upper, *most)


def _walked(way: Sequence[_FileJoint], loads: dict[str, Array]) -> tuple[list[Axis], Array, Array]:
    """The axes of the joints that move, the tip's pose, and what each of them carries, (dof, 4),
    as in `_load`; at q = 0 in base axes."""
    pose, axes, carried = np.eye(4), [], []
    for joint in way:
        pose = pose @ joint.origin
        if joint.kind != "fixed":
            axes.append(joint.as_axis(pose))
            carried.append(np.zeros(4))
        if carried:
            carried[-1] += pose @ loads[joint.child]
    return axes, pose, np.array(carried)


@dataclass(frozen=True, eq=False)
class _Tree:
    """The links of a file, each with its load, and its joints, each after those that carry it."""

    name: str
    loads: dict[str, Array]
    joints: list[_FileJoint]

    @property
    def roots(self) -> list[str]:
        """The links without a parent."""
        carried = {joint.child for joint in self.joints}
        return [link for link in self.loads if link not in carried]

    def ends(self, base: str) -> list[str]:
        """The links beyond the base, or the base, on which nothing hangs."""
        beyond = {base}
        for joint in self.joints:
            if joint.parent in beyond:
                beyond.add(joint.child)
        return sorted(beyond - {joint.parent for joint in self.joints})

    def only(self, links: list[str], where: str) -> str:
        if len(links) == 1:
            return links[0]
        raise ArmError(
            f"{self.name}: links {where} are {_some(links)}; expected one, or the name of one as"
            " base and as tip"
        )

    def link(self, name: object, what: str) -> str:
        if isinstance(name, str) and name in self.loads:
            return name
        raise ArmError(
            f"{self.name}: {what} is {shown(name)}; expected a link, one of {_some(self.loads)}"
        )

    def way(self, base: str, tip: str) -> list[_FileJoint]:
        """The joints from a link to one beyond it."""
        above = {joint.child: joint for joint in self.joints}
        found, link = [], tip
        while link != base:
            if link not in above:
                raise ArmError(
                    f"{self.name}: {tip} does not lie beyond {base}; expected a chain from base to"
                    " tip"
                )
            found.append(above[link])
            link = above[link].parent
        return found[::-1]

    def carried(self, way: Sequence[_FileJoint]) -> dict[str, Array]:
        """The load of each link with all that hangs on it, but for what the way leads on to."""
        loads, chain = dict(self.loads), set(way)
        for joint in reversed(self.joints):
            if joint not in chain:
                loads[joint.parent] = loads[joint.parent] + joint.origin @ loads[joint.child]
        return loads


# What stands in the file


def _robot(source: str | os.PathLike[str]) -> ET.Element:
    """The <robot> element of a file or of a text."""
    if isinstance(source, str) and "<" in source:
        text, what = source.encode("utf-8", "replace"), "the text"
        parser = ET.XMLParser(encoding="utf-8")
    else:
        text, what, parser = _bytes_of(source), os.fspath(source), ET.XMLParser()
    if b"<!DOCTYPE" in text:
        raise ArmError(f"{what} has a document type, which a robot description does not need")
    try:
        root = ET.fromstring(text, parser)
    except (ET.ParseError, LookupError, ValueError) as error:
        raise ArmError(f"{what} is no XML ({error}); expected a robot description") from None
    if root.tag != "robot" or any("xacro" in str(element.tag) for element in root.iter()):
        kind = "a xacro, to be run first" if root.tag == "robot" else f"a <{root.tag}>"
        raise ArmError(f"{what} is {kind}; expected a robot description, <robot>")
    return root


def _bytes_of(source: str | os.PathLike[str]) -> bytes:
    if not isinstance(source, str | os.PathLike):
        raise ArmError(f"source is {shown(source)}; expected a file's path, or its text")
    try:
        if Path(source).is_file():
            return Path(source).read_bytes()
    except (OSError, ValueError) as error:
        raise ArmError(f"source is {shown(source)}, which cannot be read: {error}") from None
    raise ArmError(
        f"source is {shown(source)}; expected a file that exists, or a text with <robot>"
    )


def _tree(robot: ET.Element) -> _Tree:
    name = robot.get("name") or "robot"
    links = [(_needed(link, "name", "a link"), link) for link in robot.findall("link")]
    joints = [_joint(element) for element in robot.findall("joint")]
    _once((called for called, _ in links), f"{name}: links called")
    _once((joint.name for joint in joints), f"{name}: joints called")
    _once((joint.child for joint in joints), f"{name}: joints that carry link")
    loads = {called: _load(link, called) for called, link in links}
    below: dict[str, list[_FileJoint]] = {link: [] for link in loads}
    for joint in joints:
        for link in (joint.parent, joint.child):
            if link not in loads:
                raise ArmError(f"{name}: joint {joint.name} names a link {link!r}; there is none")
        below[joint.parent].append(joint)
    reached, ordered = _Tree(name, loads, joints).roots, []
    for link in reached:  # grows by what hangs on it
        ordered += below[link]
        reached += [joint.child for joint in below[link]]
    if loop := sorted({*loads} - {*reached}):
        raise ArmError(
            f"{name}: links {_some(loop)} go round in a circle; expected a tree of links"
        )
    return _Tree(name, loads, ordered)


def _joint(element: ET.Element) -> _FileJoint:
    name = _needed(element, "name", "a joint")
    origin, T = element.find("origin"), np.eye(4)
    turns = _numbers(origin, "rpy", f"the rpy of {name}", (0, 0, 0))
    (c, s), (b, t), (a, r) = (cos_sin(float(angle)) for angle in turns[::-1])
    T[:3, :3] = [
        [c * b, c * t * r - s * a, c * t * a + s * r],
        [s * b, s * t * r + c * a, s * t * a - c * r],
        [-t, b * r, b * a],
    ]
    T[:3, 3] = _numbers(origin, "xyz", f"the xyz of {name}", (0, 0, 0))
    parent, child = (
        _needed(element.find(end), "link", f"the {end} of joint {name}")
        for end in ("parent", "child")
    )
    return _FileJoint(name, element.get("type", ""), parent, child, T, element)


def _load(link: ET.Element, name: str) -> Array:
    """A link's first moment and mass, (m x, m y, m z, m) in its own frame, in kg m and kg; zeros
    where the file gives none."""
    inertial = link.find("inertial")
    if inertial is None:
        return np.zeros(4)
    what = f"the mass of {name}"
    (mass,) = _numbers(inertial.find("mass"), "value", what, _ONE_LIMIT)
    if not mass >= 0:
        raise ArmError(f"{what} is {mass}; expected a number of kg, 0 or more")
    where = f"the centre of mass of {name}"
    return mass * np.append(_numbers(inertial.find("origin"), "xyz", where, (0, 0, 0)), 1)


def _needed(element: ET.Element | None, key: str, what: str) -> str:
    found = None if element is None else element.get(key)
    if not found:
        raise ArmError(f"{what} has no {key}; expected {key}=...")
    return found


def _numbers(element: ET.Element | None, key: str, what: str, default: Sequence[float]) -> Array:
    """The finite numbers of an attribute, as many as the default has, which stands where it is not
    given."""
    text = None if element is None else element.get(key)
    if text is None:
        return np.array(default, float)
    try:
        found = np.array([float(part) for part in text.replace("_", "x").split()])
    except ValueError:
        found = np.empty(0)
    if len(found) != len(default) or not np.isfinite(found).all():
        wanted = "a finite number" if len(default) == 1 else "three finite numbers"
        raise ArmError(f"{what} is {shown(text)}; expected {wanted}")
    return found


def _some(names: Iterable[str]) -> str:
    names = list(names)
    more = f" and {len(names) - 8} more" if len(names) > 8 else ""
    return ", ".join(names[:8]) + more


def _once(names: Iterable[str], what: str) -> None:
    for name, times in Counter(names).most_common(1):
        if times > 1:
            raise ArmError(f"{what} {name} are {times}; expected one")
