"""What students make of a right table, undone: each mend changes the rows as typed into what was
meant.
"""

import math
from collections.abc import Callable, Iterator
from itertools import combinations

from helpers.arm import Arm
from helpers.checks.axes import Rows, numeric
from helpers.checks.lengths import other_robots, wrong_lengths
from helpers.checks.ranking import Cause, cause
from helpers.reading.table import Numbers, from_craig

RAD = math.pi / 180
EXCHANGED = "table.rows exchanged"
_SMALL, _LARGE = 1e-2, 10.0  # m: lengths beyond these were meant in the other unit
_TURN = 6.4  # rad: a larger angle was meant in degrees
Mend = Callable[[list[Numbers]], list[Numbers]]


def units(rows: Rows, reference: Rows) -> list[tuple[Cause | None, list[Numbers]]]:
    """The readings of the numbers that their sizes allow: lengths in m, cm or mm, angles in radians
    or degrees.
    """
    lengths: list[tuple[Cause | None, list[Numbers]]] = [(None, list(rows))]
    for key, read in (
        ("table.millimetres", _scaled(rows, 1e-3)),
        ("table.centimetres", _scaled(rows, 1e-2)),
        ("table.mixed units", _of_one_size(rows)),
    ):
        if read and 0.2 < total_length(read) / (total_length(reference) or 1.0) < 5:
            lengths.append((cause(key), read))
    angles: list[tuple[Cause | None, float, float]] = [(None, 1.0, 1.0)]
    if max(max(abs(r.alpha), abs(r.theta)) for r in rows) > _TURN:
        # The zero of a joint that turns is free: only its size tells in what unit it is.
        held = any(r.theta for r in rows if r.kind != "R")
        small = 0 < max(abs(r.theta) for r in rows) <= _TURN
        if held or not small:
            angles.append((cause("table.degrees"), RAD, RAD))
        if held or small:
            angles.append((cause("table.twists in degrees"), RAD, 1.0))
    found = []
    for first, read in lengths:
        for second, t, o in angles:
            turned = [r._replace(alpha=r.alpha * t, theta=r.theta * o) for r in read]
            found.append((joined(first, second), turned))
    return found


def joined(first: Cause | None, second: Cause | None) -> Cause | None:
    """Both causes, or that which there is."""
    return first + second if first and second else first or second


def total_length(rows: Rows) -> float:
    """All lengths of a table added up."""
    return sum(abs(r.a) + abs(r.d) for r in rows)


def _scaled(rows: Rows, factor: float) -> list[Numbers]:
    return [r._replace(a=r.a * factor, d=r.d * factor) for r in rows]


def _of_one_size(rows: Rows) -> list[Numbers] | None:
    """Lengths of which some were typed in metres and some in millimetres, all in metres; None where
    they are of one size.
    """

    def read(x: float) -> float:
        return x * 1e3 if abs(x) < _SMALL else x * 1e-3 if abs(x) >= _LARGE else x

    kept = {read(x) == x for r in rows for x in (r.a, r.d) if x}
    if kept != {True, False}:
        return None
    return [r._replace(a=read(r.a), d=read(r.d)) for r in rows]


def structures(count: int, modified: bool) -> list[tuple[Cause, Mend]]:
    """Mistakes in the arrangement: columns, rows, convention (where it is not the modified one)."""

    def swap(one: str, other: str) -> Mend:
        return lambda rows: [
            r._replace(**{one: getattr(r, other), other: getattr(r, one)}) for r in rows
        ]

    found = [
        (cause("table.alpha and theta"), swap("alpha", "theta")),
        (cause("table.a and d"), swap("a", "d")),
        *([] if modified else [(cause("table.craig"), from_craig)]),
        (cause("table.d and theta"), swap("d", "theta")),
        (cause("table.a and alpha"), swap("a", "alpha")),
        (cause("table.twists"), lambda rows: [r._replace(alpha=-r.alpha) for r in rows]),
        (cause("table.rows reversed"), lambda rows: rows[::-1]),
        (cause("table.into craig"), to_craig),
    ]
    for i, j in combinations(range(count), 2):
        found.append((cause(EXCHANGED, i=i + 1, j=j + 1), _exchanged(i, j)))
    return found


def _exchanged(i: int, j: int) -> Mend:
    def mend(rows: list[Numbers]) -> list[Numbers]:
        new = list(rows)
        new[i], new[j] = rows[j], rows[i]
        return new

    return mend


def to_craig(rows: list[Numbers]) -> list[Numbers]:
    """The other way: a and alpha stand one row too high."""
    before = [rows[0]._replace(a=0.0, alpha=0.0), *rows[:-1]]
    return [r._replace(a=b.a, alpha=b.alpha) for r, b in zip(rows, before, strict=True)]


def references(arm: Arm) -> Iterator[tuple[Cause, tuple[Numbers, ...]]]:
    """Other arms that a student may have described: without the pen, one length taken for another,
    or another robot of a like name.
    """
    for found, other in wrong_lengths(arm):
        yield found, numeric(other)
    for name, other in other_robots(arm):
        found = cause("table.robot", name=name)
        yield found, numeric(other)
        if arm.values.get("l_pen"):
            yield found + cause("table.pen"), numeric(other.with_values(l_pen=0))


def flips(rows: Rows) -> Iterator[tuple[Cause, list[Numbers]]]:
    """One sign turned."""
    for k, row in enumerate(rows):
        for column in ("alpha", "a", "d"):
            x = getattr(row, column)
            if x and not (column == "alpha" and abs(math.sin(x)) < 1e-9):
                twist = cause("table.twist", row=k + 1)
                key = twist if column == "alpha" else cause("table.sign", column=column, row=k + 1)
                yield key, [*rows[:k], row._replace(**{column: -x}), *rows[k + 1 :]]
