"""A serial arm out of a robot description (URDF): its joint axes at q = 0, and from them its table.

The chain from one link of the tree to another is read with its limits, speeds, efforts, masses and
centres of mass. Fixed joints are folded in, and so are the masses of whatever is fastened to the
chain at its side. The file is data: only `xml.etree` and `xml.parsers.expat` of the standard
library touch it, a document type (which could hide an entity bomb or another file) is refused, and
nothing that it names is opened. Source of the format: the URDF XML specification,
wiki.ros.org/urdf/XML (elements joint, link and inertial).
"""

import math
import os
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from xml.parsers import expat

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm, ArmError, Joint
from helpers.derive import Axis, Derivation, derive
from helpers.inputs import must_be, number, shown
from helpers.rows import Kind, cos_sin

__all__ = ["Chain", "from_urdf", "read_chain"]

Array = NDArray[np.float64]

_MOST = 50_000_000  # bytes; the largest robot of example-robot-data has 0.2 million
_DEEPEST = 100  # nested elements; a robot description needs seven
_KINDS: dict[str, Kind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
}


@dataclass(frozen=True, eq=False)
class Chain:
    """What a robot description says of the way from its link `base` to its link `tip`, at q = 0, in
    base axes.

    Attributes:
        name: the robot's name.
        base, tip: the two links.
        joints: the names of the joints that move, base to tip.
        axes: their axes, with limits, speeds and efforts.
        pose: the tip link's pose, 4x4.
        masses: the mass (kg) that moves with each joint, shape (dof,); all 0 where the file gives
            none.
        centres: its centre of mass (m), shape (dof, 3).
    """

    name: str
    base: str
    tip: str
    joints: tuple[str, ...]
    axes: tuple[Axis, ...]
    pose: Array
    masses: Array
    centres: Array

    def derive(self, *, negative: bool = False, tolerance: float = 1e-9) -> Derivation:
        """The chain's table, row by row; the arm has masses where the file gives any."""
        found = derive(self.axes, self.pose, name=self.name, negative=negative, tolerance=tolerance)
        arm = found.with_bodies(self.masses, self.centres) if self.masses.any() else found.arm
        source = f"robot description: {self.base} to {self.tip}; joints {', '.join(self.joints)}"
        return replace(found, arm=replace(arm, source=source))


def from_urdf(
    source: str | os.PathLike[str],
    base: str | None = None,
    tip: str | None = None,
    *,
    hold: Mapping[str, float] | None = None,
    name: str | None = None,
    negative: bool = False,
    tolerance: float = 1e-9,
) -> Arm:
    """The arm from link `base` to link `tip` of a robot description, in standard Denavit-Hartenberg
    form.

    Args:
        source: the file, or its text.
        base: a link; the one without a parent unless given.
        tip: a link beyond it; the last one unless given, where there is only one.
        hold: joints by name that are held at a value (rad or m), as ``{"finger_joint": 0.02}``: on
            the chain they are locked, beside it their links' masses ride along.
        name: the arm's name; the robot's unless given.
        negative, tolerance: as for `helpers.derive.derive`.

    The joints keep their own zeros and signs, so q is the file's. A limit of 0 for speed or effort
    is taken as not given, for many files write 0 there. Raises ArmError where the file is no robot
    description, where the chain branches, or holds joints that are no single turn or slide (planar,
    floating), or that follow another (mimic).
    """
    return (
        read_chain(source, base, tip, hold=hold, name=name)
        .derive(negative=negative, tolerance=tolerance)
        .arm
    )


def read_chain(
    source: str | os.PathLike[str],
    base: str | None = None,
    tip: str | None = None,
    *,
    hold: Mapping[str, float] | None = None,
    name: str | None = None,
) -> Chain:
    """What `from_urdf` reads, before a table is made of it; the same arguments and errors."""
    tree = _Tree.of(_root(source))
    if name is not None:
        must_be(name, str, "an arm's name")
    base = tree.root() if base is None else tree.link(base, "base")
    tip = tree.only_tip(base) if tip is None else tree.link(tip, "tip")
    held = _held(hold, tree)
    found = _walk(tree, tree.way(base, tip), base, held)
    return Chain(tree.name if name is None else name, base, tip, *found)


# Along the chain


def _walk(
    tree: "_Tree", way: list["_Joint"], base: str, held: dict[str, float]
) -> tuple[tuple[str, ...], tuple[Axis, ...], Array, Array, Array]:
    """The joints that move, their axes, the tip's pose, and for each joint the mass and centre that
    it carries."""
    pose, names, axes, carried = np.eye(4), [], [], []
    for joint, after in zip(way, [*way[1:], None], strict=False):
        pose = pose @ joint.placed(held)
        if joint.moves(held):
            names.append(joint.name)
            axes.append(joint.as_axis(pose))
            carried.append(np.zeros(4))
        if carried:
            carried[-1] += _load(tree, joint.child, pose, after, held)
    if not axes:
        end = way[-1].child if way else base
        raise ArmError(
            f"{tree.name}: nothing moves from {base} to {end}; expected a joint that does"
        )
    masses = np.array([load[0] for load in carried])
    moments = np.array([load[1:] for load in carried])
    centres = np.divide(moments, masses[:, None], where=masses[:, None] > 0, out=0 * moments)
    return tuple(names), tuple(axes), pose, masses, centres


def _load(
    tree: "_Tree", link: str, pose: Array, onwards: "_Joint | None", held: dict[str, float]
) -> Array:
    """The mass of a link and of all that hangs on it beside the chain, and its first moment: (m, m
    x, m y, m z)."""
    total, waiting = np.zeros(4), [(link, pose)]
    while waiting:
        link, at = waiting.pop()
        mass, centre = tree.masses[link]
        total += mass * (at @ [*centre, 1])[[3, 0, 1, 2]]
        for joint in tree.joints_on(link):
            if joint is onwards:
                continue
            if joint.moves(held):
                raise ArmError(
                    f"{tree.name}: joint {joint.name} on {link} branches off the chain and moves;"
                    " hold it, as in"
                    f" hold={{{joint.name!r}: 0.0}}, or choose a base beyond it"
                )
            waiting.append((joint.child, at @ joint.placed(held)))
    return total


def _held(hold: Mapping[str, float] | None, tree: "_Tree") -> dict[str, float]:
    if hold is None:
        return {}
    must_be(hold, Mapping, "hold")
    known = {joint.name: joint for joints in tree.joints.values() for joint in joints}
    for name, value in hold.items():
        if name not in known or known[name].kind not in _KINDS:
            moving = [joint.name for joint in known.values() if joint.kind in _KINDS]
            raise ArmError(
                f"{tree.name}: no joint {shown(name)} can be held; expected one of {_some(moving)}"
            )
        at = number(value, f"{tree.name}: the value of {name}")
        lower, upper = known[name].limits.lower, known[name].limits.upper
        if not lower <= at <= upper:
            raise ArmError(
                f"{tree.name}: {name} is held at {at:g}; its limits are {lower:g} to {upper:g}"
            )
    return {name: float(value) for name, value in hold.items()}


# The tree of links


@dataclass(frozen=True, eq=False)
class _Joint:
    """A joint of the file: where its child's frame lies at 0 in its parent's, and how it moves."""

    name: str
    kind: str
    parent: str
    child: str
    origin: Array
    axis: Array
    limits: Joint
    mimics: str

    def moves(self, held: Mapping[str, float]) -> bool:
        """Whether it is free to move; ArmError where it moves as no row of a table can."""
        if self.kind == "fixed" or self.name in held:
            return False
        if self.kind not in _KINDS:
            raise ArmError(
                f"joint {self.name} is {self.kind}; a table has rows for revolute, continuous,"
                " prismatic and fixed"
                " joints, one freedom each"
            )
        if self.mimics:
            raise ArmError(
                f"joint {self.name} mimics {self.mimics}; expected joints that move by themselves,"
                " so hold it, as in"
                f" hold={{{self.name!r}: 0.0}}"
            )
        return True

    def placed(self, held: Mapping[str, float]) -> Array:
        """The child's frame in the parent's, 4x4, the joint at 0 or where it is held."""
        if self.name not in held:
            return self.origin
        moved = np.eye(4)
        if self.kind == "prismatic":
            moved[:3, 3] = held[self.name] * self.axis
        else:
            moved[:3, :3] = _turned(self.axis, held[self.name])
        return self.origin @ moved

    def as_axis(self, pose: Array) -> Axis:
        """Its axis in base axes, where its child's frame has a pose."""
        return Axis(tuple(pose[:3, 3]), tuple(pose[:3, :3] @ self.axis), self.limits)


@dataclass(frozen=True, eq=False)
class _Tree:
    """The links of a file, each with its mass and centre of mass, and the joints on each."""

    name: str
    masses: dict[str, tuple[float, Array]]
    joints: dict[str, list[_Joint]]

    @classmethod
    def of(cls, robot: ET.Element) -> "_Tree":
        name = robot.get("name") or "robot"
        links = robot.findall("link")
        if not links:
            raise ArmError(f"{name} has no links; expected a robot description with <link>s in it")
        names = [_name(link, "link") for link in links]
        masses = {called: _mass(link, called) for called, link in zip(names, links, strict=True)}
        joints = [_joint(element) for element in robot.findall("joint")]
        _once(names, f"{name}: links called")
        _once([joint.name for joint in joints], f"{name}: joints called")
        _once([joint.child for joint in joints], f"{name}: joints that carry link")
        found: dict[str, list[_Joint]] = {}
        for joint in joints:
            for link in (joint.parent, joint.child):
                if link not in masses:
                    raise ArmError(
                        f"{name}: joint {joint.name} names a link {link!r}; there is none"
                    )
            found.setdefault(joint.parent, []).append(joint)
        return cls(name, masses, found)

    def joints_on(self, link: str) -> list[_Joint]:
        return self.joints.get(link, [])

    def link(self, name: object, what: str) -> str:
        if not isinstance(name, str) or name not in self.masses:
            raise ArmError(
                f"{self.name}: {what} is {shown(name)}; expected a link, one of"
                f" {_some(self.masses)}"
            )
        return name

    def root(self) -> str:
        """The one link without a parent."""
        carried = {joint.child for joints in self.joints.values() for joint in joints}
        free = [link for link in self.masses if link not in carried]
        if len(free) != 1:
            given = f"are {_some(free)}" if free else "do not exist: its links go round in a circle"
            raise ArmError(
                f"{self.name}: links without a parent {given}; expected one, or the name of the"
                " base"
            )
        return free[0]

    def only_tip(self, base: str) -> str:
        """The one last link beyond the base."""
        ends, waiting, seen = [], [base], set()
        while waiting:
            link = waiting.pop()
            if link in seen:
                raise ArmError(f"{self.name}: the links beyond {base} go round in a circle")
            seen.add(link)
            beyond = [joint.child for joint in self.joints_on(link)]
            waiting += beyond
            ends += [] if beyond else [link]
        if len(ends) != 1:
            raise ArmError(
                f"{self.name} branches: beyond {base} the last links are {_some(sorted(ends))};"
                " say which is the tip"
            )
        return ends[0]

    def way(self, base: str, tip: str) -> list[_Joint]:
        """The joints from a link to one beyond it."""
        above = {joint.child: joint for joints in self.joints.values() for joint in joints}
        found: list[_Joint] = []
        link = tip
        while link != base:
            if link not in above or len(found) > len(above):
                raise ArmError(
                    f"{self.name}: {tip} does not lie beyond {base}; expected a chain from base to"
                    " tip"
                )
            found.append(above[link])
            link = above[link].parent
        return found[::-1]


def _some(names) -> str:
    names = list(names)
    more = f" and {len(names) - 8} more" if len(names) > 8 else ""
    return ", ".join(map(str, names[:8])) + more


def _once(names: list[str], what: str) -> None:
    twice = sorted(name for name in set(names) if names.count(name) > 1)
    if twice:
        raise ArmError(f"{what} {twice[0]} are {names.count(twice[0])}; expected one")


# Elements


def _root(source: str | os.PathLike[str]) -> ET.Element:
    """The <robot> element of a file or of a text."""
    if isinstance(source, str) and "<" in source:
        data, what, encoding = source.encode("utf-8", "replace"), "the text", "utf-8"
    else:
        data, what, encoding = _read(source), os.fspath(source), None
    try:
        _refuse_traps(data, encoding, what)
        parser = ET.XMLParser(encoding=encoding)
        root = ET.fromstring(data, parser)
    except (expat.ExpatError, ET.ParseError, LookupError, ValueError) as error:
        if isinstance(error, ArmError):
            raise
        raise ArmError(f"{what} is no XML ({error}); expected a robot description") from None
    if any("xacro" in str(element.tag) for element in root.iter()):
        raise ArmError(
            f"{what} is a xacro, a recipe for a robot description; run xacro on it first"
        )
    if root.tag != "robot":
        raise ArmError(f"{what} is a <{root.tag}>; expected a robot description, <robot>")
    return root


def _read(source: str | os.PathLike[str]) -> bytes:
    if not isinstance(source, str | os.PathLike):
        raise ArmError(f"source is {shown(source)}; expected a file's path, or its text")
    try:
        path = Path(source)
        if path.is_file():
            with path.open("rb") as file:
                data = file.read(_MOST + 1)
            if len(data) <= _MOST:
                return data
            raise ArmError(f"{path} has more than {_MOST} bytes; expected a robot description")
    except (OSError, ValueError) as error:
        if isinstance(error, ArmError):
            raise
        raise ArmError(f"source is {shown(source)}, which cannot be read: {error}") from None
    raise ArmError(
        f"source is {shown(source)}; expected a file that exists, or a text with <robot>"
    )


def _refuse_traps(data: bytes, encoding: str | None, what: str) -> None:
    """Raise ArmError for a document type, which may define entities, and for elements nested
    without end."""
    depth = 0

    def doctype(*_: object) -> None:
        raise ArmError(
            f"{what} has a document type, which a robot description does not need; take it out"
        )

    def start(*_: object) -> None:
        nonlocal depth
        depth += 1
        if depth > _DEEPEST:
            raise ArmError(
                f"{what} nests more than {_DEEPEST} elements; expected a robot description"
            )

    def end(*_: object) -> None:
        nonlocal depth
        depth -= 1

    parser = expat.ParserCreate(encoding)
    parser.StartDoctypeDeclHandler = doctype
    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.Parse(data, True)


def _name(element: ET.Element, what: str) -> str:
    name = element.get("name")
    if not name:
        raise ArmError(f"a {what} has no name; expected <{what} name=...>")
    return name


def _joint(element: ET.Element) -> _Joint:
    name, kind = _name(element, "joint"), element.get("type", "")
    ends = [_linked(element, which, name) for which in ("parent", "child")]
    axis = _triple(element.find("axis"), "xyz", (1, 0, 0), f"the axis of {name}")
    length = np.linalg.norm(axis)
    if kind in _KINDS and not length:
        raise ArmError(f"the axis of {name} is 0 0 0; expected a direction")
    mimic = element.find("mimic")
    mimics = "" if mimic is None else mimic.get("joint", "another joint")
    origin = _origin(element, name)
    axis = axis / length if length else axis
    return _Joint(name, kind, ends[0], ends[1], origin, axis, _limits(element, name, kind), mimics)


def _linked(element: ET.Element, which: str, name: str) -> str:
    found = element.find(which)
    link = None if found is None else found.get("link")
    if not link:
        raise ArmError(f"joint {name} has no {which}; expected <{which} link=...>")
    return link


def _limits(element: ET.Element, name: str, kind: str) -> Joint:
    """The joint's range, speed and effort; infinite where they are not given, or are 0."""
    limit = element.find("limit")
    if kind not in _KINDS or limit is None:
        return Joint(_KINDS.get(kind, "fixed"))
    given = {key: _scalar(limit, key, name) for key in ("lower", "upper", "velocity", "effort")}
    ranged = kind != "continuous" and not (given["lower"] is None and given["upper"] is None)
    lower, upper = (
        (given["lower"] or 0.0, given["upper"] or 0.0) if ranged else (-math.inf, math.inf)
    )
    if lower > upper:
        raise ArmError(f"joint {name} has limits {lower:g} to {upper:g}; expected lower <= upper")
    speed, effort = (abs(given[key] or math.inf) for key in ("velocity", "effort"))
    return Joint(_KINDS[kind], lower, upper, speed, effort)


def _mass(link: ET.Element, name: str) -> tuple[float, Array]:
    """A link's mass (kg) and centre of mass (m) in its own frame; no mass where the file gives
    none."""
    inertial = link.find("inertial")
    if inertial is None:
        return 0.0, np.zeros(3)
    element = inertial.find("mass")
    mass = None if element is None else _scalar(element, "value", name)
    if mass is None or mass < 0:
        raise ArmError(f"link {name} has mass {mass}; expected a number of kg, 0 or more")
    centre = _triple(inertial.find("origin"), "xyz", (0, 0, 0), f"the centre of mass of {name}")
    return mass, centre


def _origin(element: ET.Element, name: str) -> Array:
    origin, T = element.find("origin"), np.eye(4)
    roll, pitch, yaw = _triple(origin, "rpy", (0, 0, 0), f"the rpy of {name}")
    x, y, z = np.eye(3)
    T[:3, :3] = _turned(z, yaw) @ _turned(y, pitch) @ _turned(x, roll)
    T[:3, 3] = _triple(origin, "xyz", (0, 0, 0), f"the xyz of {name}")
    return T


def _turned(axis: Array, angle: float) -> Array:
    """The rotation about a unit vector, by Rodrigues' formula."""
    c, s = cos_sin(float(angle))
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + s * cross + (1 - c) * cross @ cross


def _triple(element: ET.Element | None, key: str, default: tuple, what: str) -> Array:
    text = None if element is None else element.get(key)
    if text is None:
        return np.array(default, float)
    values = [_float(part) for part in text.split()]
    if len(values) != 3 or None in values:
        raise ArmError(f"{what} is {shown(text)}; expected three finite numbers")
    return np.array(values)


def _scalar(element: ET.Element, key: str, name: str) -> float | None:
    text = element.get(key)
    if text is None:
        return None
    value = _float(text)
    if value is None:
        raise ArmError(f"{name}: {key} is {shown(text)}; expected a finite number")
    return value


def _float(text: str) -> float | None:
    """The finite number that a text is, or None."""
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) and "_" not in text else None
