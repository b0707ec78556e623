"""The way from one link to another: the joints that move, what they carry, and the arm of it."""

import os
from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from helpers.arm import Arm, ArmError
from helpers.derive import Axis, derive
from helpers.inputs import must_be, number, shown
from helpers.urdf.elements import KINDS, Array, FileJoint, read_robot
from helpers.urdf.tree import Tree, some


def from_urdf(
    source: str | os.PathLike[str],
    base: str | None = None,
    tip: str | None = None,
    *,
    hold: Mapping[str, float] | None = None,
    name: str | None = None,
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
        tolerance: as for `helpers.derive.derive`.

    The joints keep their own zeros and signs, so q is the file's. A limit of 0 for speed or effort
    is taken as not given, for many files write 0 there. Raises ArmError where the file is no robot
    description, where the chain branches, or holds joints that are no single turn or slide (planar,
    floating), or that follow another (mimic). Warns as `derive` does where rounded
    angles put a row's common normal far off the arm, which a larger tolerance mends.
    """
    tree = Tree.of(read_robot(source))
    if name is not None:
        must_be(name, str, "an arm's name")
    base = tree.root() if base is None else tree.link(base, "base")
    tip = tree.only_tip(base) if tip is None else tree.link(tip, "tip")
    chain = _walk(tree, tree.way(base, tip), base, _held(hold, tree))
    found = derive(
        chain.axes,
        chain.pose,
        name=tree.name if name is None else name,
        tolerance=tolerance,
    )
    arm = found.with_bodies(chain.masses, chain.centres) if chain.masses.any() else found.arm
    said = f"robot description: {base} to {tip}; joints {', '.join(chain.joints)}"
    return replace(arm, source=said)


class _Chain(NamedTuple):
    """The joints that move from base to tip, their axes, the tip's pose, and the mass (kg) and
    centre (m) that each carries, at q = 0 in base axes."""

    joints: list[str]
    axes: list[Axis]
    pose: Array
    masses: Array
    centres: Array


def _walk(tree: Tree, way: list[FileJoint], base: str, held: dict[str, float]) -> _Chain:
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
    return _Chain(names, axes, pose, masses, centres)


def _load(
    tree: Tree, link: str, pose: Array, onwards: FileJoint | None, held: dict[str, float]
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
                    f" hold it, as in hold={{{joint.name!r}: 0.0}}, or choose a base beyond it"
                )
            waiting.append((joint.child, at @ joint.placed(held)))
    return total


def _held(hold: Mapping[str, float] | None, tree: Tree) -> dict[str, float]:
    if hold is None:
        return {}
    must_be(hold, Mapping, "hold")
    known = {joint.name: joint for joints in tree.joints.values() for joint in joints}
    for name, value in hold.items():
        if name not in known or known[name].kind not in KINDS:
            moving = [joint.name for joint in known.values() if joint.kind in KINDS]
            raise ArmError(
                f"{tree.name}: no joint {shown(name)} can be held; expected one of {some(moving)}"
            )
        at = number(value, f"{tree.name}: the value of {name}")
        lower, upper = known[name].limits.lower, known[name].limits.upper
        if not lower <= at <= upper:
            raise ArmError(
                f"{tree.name}: {name} is held at {at:g}; its limits are {lower:g} to {upper:g}"
            )
    return {name: float(value) for name, value in hold.items()}
