"""The elements of a robot description, each checked and in numbers."""

import math
import os
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import ArmError, Joint
from helpers.derive import Axis
from helpers.inputs import shown
from helpers.rows import Kind, cos_sin

Array = NDArray[np.float64]

_MOST = 50_000_000  # bytes; the largest robot of example-robot-data has 0.2 million
_DEEPEST = 100  # nested elements; a robot description needs seven
KINDS: dict[str, Kind] = {
    "revolute": "revolute",
    "continuous": "revolute",
    "prismatic": "prismatic",
}


@dataclass(frozen=True, eq=False)
class FileJoint:
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
        if self.kind not in KINDS:
            raise ArmError(
                f"joint {self.name} is {self.kind}; a table has rows for revolute, continuous,"
                " prismatic and fixed joints, one freedom each"
            )
        if self.mimics:
            raise ArmError(
                f"joint {self.name} mimics {self.mimics}; expected joints that move by themselves,"
                f" so hold it, as in hold={{{self.name!r}: 0.0}}"
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


def read_robot(source: str | os.PathLike[str]) -> ET.Element:
    """The <robot> element of a file or of a text."""
    if isinstance(source, str) and "<" in source:
        data, what, encoding = source.encode("utf-8", "replace"), "the text", "utf-8"
    else:
        data, what, encoding = _read(source), os.fspath(source), None
    if len(data) > _MOST:
        raise ArmError(f"{what} has more than {_MOST} bytes; expected a robot description")
    parser = ET.XMLParser(target=_Builder(), encoding=encoding)
    try:
        parser.feed(data)
        root = parser.close()
    except ArmError as error:
        raise ArmError(f"{what} {error}") from None
    except (ET.ParseError, LookupError, ValueError) as error:
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
                return file.read(_MOST + 1)
    except (OSError, ValueError) as error:
        raise ArmError(f"source is {shown(source)}, which cannot be read: {error}") from None
    raise ArmError(
        f"source is {shown(source)}; expected a file that exists, or a text with <robot>"
    )


class _Builder(ET.TreeBuilder):
    """Builds the tree of elements; raises ArmError for a document type, which may define entities,
    and for elements nested without end."""

    depth = 0

    def doctype(self, *_: object) -> None:
        raise ArmError("has a document type, which a robot description does not need; take it out")

    def start(self, *element: Any) -> ET.Element:
        self.depth += 1
        if self.depth > _DEEPEST:
            raise ArmError(f"nests more than {_DEEPEST} elements; expected a robot description")
        return super().start(*element)

    def end(self, tag: str) -> ET.Element:
        self.depth -= 1
        return super().end(tag)


def read_name(element: ET.Element, what: str) -> str:
    name = element.get("name")
    if not name:
        raise ArmError(f"a {what} has no name; expected <{what} name=...>")
    return name


def read_joint(element: ET.Element) -> FileJoint:
    name, kind = read_name(element, "joint"), element.get("type", "")
    axis = _triple(element.find("axis"), "xyz", (1, 0, 0), f"the axis of {name}")
    length = np.linalg.norm(axis)
    if kind in KINDS and not length:
        raise ArmError(f"the axis of {name} is 0 0 0; expected a direction")
    mimic = element.find("mimic")
    mimics = "" if mimic is None else mimic.get("joint", "another joint")
    return FileJoint(
        name=name,
        kind=kind,
        parent=_linked(element, "parent", name),
        child=_linked(element, "child", name),
        origin=_origin(element, name),
        axis=axis / length if length else axis,
        limits=_limits(element, name, kind),
        mimics=mimics,
    )


def _linked(element: ET.Element, which: str, name: str) -> str:
    found = element.find(which)
    link = None if found is None else found.get("link")
    if not link:
        raise ArmError(f"joint {name} has no {which}; expected <{which} link=...>")
    return link


def _limits(element: ET.Element, name: str, kind: str) -> Joint:
    """The joint's range, speed and effort; infinite where they are not given, or are 0."""
    limit = element.find("limit")
    if kind not in KINDS or limit is None:
        return Joint(KINDS.get(kind, "fixed"))
    given = {key: _scalar(limit, key, name) for key in ("lower", "upper", "velocity", "effort")}
    ranged = kind != "continuous" and not (given["lower"] is None and given["upper"] is None)
    lower, upper = (
        (given["lower"] or 0.0, given["upper"] or 0.0) if ranged else (-math.inf, math.inf)
    )
    if lower > upper:
        raise ArmError(f"joint {name} has limits {lower:g} to {upper:g}; expected lower <= upper")
    speed, effort = (abs(given[key] or math.inf) for key in ("velocity", "effort"))
    return Joint(KINDS[kind], lower, upper, speed, effort)


def read_mass(link: ET.Element, name: str) -> tuple[float, Array]:
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
