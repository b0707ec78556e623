"""Arms with one length wrong: the pen forgotten, or one of two near lengths taken for the other."""

from collections.abc import Iterator

from helpers.arm import Arm
from helpers.checks.ranking import Cause, cause


def alike(arm: Arm) -> list[tuple[str, str]]:
    """Names of lengths a_i that may be taken for one another: near, and not the same."""
    a = [(n, v) for n, v in arm.values.items() if n.startswith("a_")]
    return [
        (m, n)
        for m, x in a
        for n, y in a
        if m != n and x != y and abs(x - y) < 0.1 * max(abs(x), abs(y))
    ]


def wrong_lengths(arm: Arm) -> Iterator[tuple[Cause, Arm]]:
    """The arm as a student may have it, with what is wrong about it."""
    if arm.values.get("l_pen"):
        yield cause("table.pen"), arm.with_values(l_pen=0)
    for m, n in alike(arm):
        yield cause("table.length", name=m, other=n), arm.with_values(**{m: arm.values[n]})
