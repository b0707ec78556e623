"""The links of a robot description and the joints between them: a tree."""

import xml.etree.ElementTree as ET
from collections import Counter
from dataclasses import dataclass
from operator import itemgetter

from helpers.inputs import ArmError, shown
from helpers.urdf.elements import Array, FileJoint, read_joint, read_mass, read_name


@dataclass(frozen=True, eq=False)
class Tree:
    """The links of a file, each with its mass and centre of mass, and the joints on each."""

    name: str
    masses: dict[str, tuple[float, Array]]
    joints: dict[str, list[FileJoint]]

    @classmethod
    def of(cls, robot: ET.Element) -> "Tree":
        name = robot.get("name") or "robot"
        links = robot.findall("link")
        if not links:
            raise ArmError(f"{name} has no links; expected a robot description with <link>s in it")
        names = [read_name(link, "link") for link in links]
        masses = {
            called: read_mass(link, called) for called, link in zip(names, links, strict=True)
        }
        joints = [read_joint(element) for element in robot.findall("joint")]
        _once(names, f"{name}: links called")
        _once([joint.name for joint in joints], f"{name}: joints called")
        _once([joint.child for joint in joints], f"{name}: joints that carry link")
        found: dict[str, list[FileJoint]] = {}
        for joint in joints:
            for link in (joint.parent, joint.child):
                if link not in masses:
                    raise ArmError(
                        f"{name}: joint {joint.name} names a link {link!r}; there is none"
                    )
            found.setdefault(joint.parent, []).append(joint)
        tree = cls(name, masses, found)
        tree.refuse_loops()
        return tree

    def joints_on(self, link: str) -> list[FileJoint]:
        return self.joints.get(link, [])

    def link(self, name: object, what: str) -> str:
        if not isinstance(name, str) or name not in self.masses:
            raise ArmError(
                f"{self.name}: {what} is {shown(name)}; expected a link, one of {some(self.masses)}"
            )
        return name

    def root(self) -> str:
        """The one link without a parent."""
        free = self._roots()
        if len(free) != 1:
            raise ArmError(
                f"{self.name}: links without a parent are {some(free)}; expected one, or the name"
                " of the base"
            )
        return free[0]

    def only_tip(self, base: str) -> str:
        """The one last link beyond the base."""
        ends = [link for link in self._beyond([base]) if not self.joints_on(link)]
        if len(ends) != 1:
            raise ArmError(
                f"{self.name} branches: beyond {base} the last links are {some(sorted(ends))};"
                " say which is the tip"
            )
        return ends[0]

    def _roots(self) -> list[str]:
        carried = {joint.child for joints in self.joints.values() for joint in joints}
        return [link for link in self.masses if link not in carried]

    def _beyond(self, links: list[str]) -> list[str]:
        """These links and all that hang on them."""
        found = list(links)
        for link in found:
            found += [joint.child for joint in self.joints_on(link)]
        return found

    def refuse_loops(self) -> None:
        """Raise ArmError unless every link hangs on one without a parent."""
        if loop := sorted({*self.masses} - {*self._beyond(self._roots())}):
            raise ArmError(
                f"{self.name}: links {some(loop)} go round in a circle; expected a tree of links"
            )

    def way(self, base: str, tip: str) -> list[FileJoint]:
        """The joints from a link to one beyond it."""
        above = {joint.child: joint for joints in self.joints.values() for joint in joints}
        found: list[FileJoint] = []
        link = tip
        while link != base:
            if link not in above:
                raise ArmError(
                    f"{self.name}: {tip} does not lie beyond {base}; expected a chain from base to"
                    " tip"
                )
            found.append(above[link])
            link = above[link].parent
        return found[::-1]


def some(names) -> str:
    names = list(names)
    more = f" and {len(names) - 8} more" if len(names) > 8 else ""
    return ", ".join(map(str, names[:8])) + more


def _once(names: list[str], what: str) -> None:
    name, times = max(Counter(names).items(), key=itemgetter(1), default=("", 0))
    if times > 1:
        raise ArmError(f"{what} {name} are {times}; expected one")
