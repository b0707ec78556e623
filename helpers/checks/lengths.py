"""Arms with wrong lengths: the pen forgotten, one of two near lengths taken for the other, or those
of another robot.
"""

from collections.abc import Iterator

from helpers.arm import Arm
from helpers.checks.ranking import Cause, cause
from helpers.robots import UR10E, UR10E_HOMEWORK

_NAMES = ("d_1", "a_2", "a_3", "d_4", "d_5", "d_6")
# Robots of nearly one name: the UR10 as its manual's drawing has it and as its maker's table of
# Denavit-Hartenberg parameters does, and the UR10e.
_ROBOTS = (
    ("UR10", {name: UR10E_HOMEWORK.values[name] for name in _NAMES}),
    ("UR10", dict(d_1=0.1273, a_2=0.612, a_3=0.5723, d_4=0.163941, d_5=0.1157, d_6=0.0922)),
    ("UR10e", {name: UR10E.values[name] for name in _NAMES}),
)


def alike(arm: Arm) -> list[tuple[str, str]]:
    """Names of lengths a_i that may be taken for one another: near, and not the same."""
    a = [(n, v) for n, v in arm.values.items() if n.startswith("a_")]
    return [
        (m, n)
        for m, x in a
        for n, y in a
        if m != n and x != y and abs(x - y) < 0.1 * max(abs(x), abs(y))
    ]


def other_robots(arm: Arm) -> list[tuple[str, Arm]]:
    """The arm with the lengths of a robot that is called nearly as it is, and that robot's name."""
    own = next((name for name, lengths in _ROBOTS if lengths.items() <= arm.values.items()), None)
    return [(name, arm.with_values(**x)) for name, x in _ROBOTS if own and name != own]


def wrong_lengths(arm: Arm) -> Iterator[tuple[Cause, Arm]]:
    """The arm as a student may have it, with what is wrong about it."""
    if arm.values.get("l_pen"):
        yield cause("table.pen"), arm.with_values(l_pen=0)
    for m, n in alike(arm):
        yield cause("table.length", name=m, other=n), arm.with_values(**{m: arm.values[n]})
