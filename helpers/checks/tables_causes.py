"""What students make of a right table, undone: each mend changes the rows as typed into what was
meant.
"""

import math
from collections.abc import Callable, Iterator
from itertools import combinations

from helpers.arm import Arm
from helpers.checks.axes import Rows, numeric
from helpers.checks.lengths import wrong_lengths
from helpers.checks.ranking import Cause, cause
from helpers.reading.table import Numbers, from_craig

RAD = math.pi / 180
Mend = Callable[[list[Numbers]], list[Numbers]]


def units(rows: Rows, reference: Rows) -> list[tuple[Cause | None, list[Numbers]]]:
    """The readings of the numbers that their sizes allow: lengths in m, cm or mm, angles in radians
    or degrees.
    """
    total, wanted = (sum(abs(r.a) + abs(r.d) for r in table) or 1.0 for table in (rows, reference))
    lengths: list[tuple[Cause | None, float]] = [(None, 1.0)]
    for key, factor in (("table.millimetres", 1e-3), ("table.centimetres", 1e-2)):
        if 0.2 < total * factor / wanted < 5:
            lengths.append((cause(key), factor))
    angles: list[tuple[Cause | None, float, float]] = [(None, 1.0, 1.0)]
    if max(abs(r.alpha) for r in rows) > 6.4 or max(abs(r.theta) for r in rows) > 6.4:
        angles += [(cause("table.degrees"), RAD, RAD), (cause("table.twists in degrees"), RAD, 1.0)]
    found = []
    for first, f in lengths:
        for second, t, o in angles:
            both = first + second if first and second else first or second
            found.append(
                (
                    both,
                    [
                        r._replace(a=r.a * f, d=r.d * f, alpha=r.alpha * t, theta=r.theta * o)
                        for r in rows
                    ],
                )
            )
    return found


def structures(count: int) -> list[tuple[Cause, Mend]]:
    """Mistakes in the arrangement: columns, rows, convention."""

    def swap(one: str, other: str) -> Mend:
        return lambda rows: [
            r._replace(**{one: getattr(r, other), other: getattr(r, one)}) for r in rows
        ]

    found = [
        (cause("table.alpha and theta"), swap("alpha", "theta")),
        (cause("table.a and d"), swap("a", "d")),
        (cause("table.craig"), from_craig),
        (cause("table.d and theta"), swap("d", "theta")),
        (cause("table.a and alpha"), swap("a", "alpha")),
        (cause("table.twists"), lambda rows: [r._replace(alpha=-r.alpha) for r in rows]),
        (cause("table.rows reversed"), lambda rows: rows[::-1]),
        (cause("table.into craig"), to_craig),
    ]
    for i, j in combinations(range(count), 2):
        found.append((cause("table.rows exchanged", i=i + 1, j=j + 1), _exchanged(i, j)))
    return found


def _exchanged(i: int, j: int) -> Mend:
    def mend(rows: list[Numbers]) -> list[Numbers]:
        if j >= len(rows):
            return rows
        new = list(rows)
        new[i], new[j] = rows[j], rows[i]
        return new

    return mend


def to_craig(rows: list[Numbers]) -> list[Numbers]:
    """The other way: a and alpha stand one row too high."""
    before = [Numbers("F", 0.0, 0.0, 0.0, 0.0), *rows[:-1]]
    return [r._replace(a=b.a, alpha=b.alpha) for r, b in zip(rows, before, strict=True)]


def references(arm: Arm) -> Iterator[tuple[Cause, tuple[Numbers, ...]]]:
    """Other arms that a student may have described: without the pen, or one length taken for
    another.
    """
    for found, other in wrong_lengths(arm):
        yield found, numeric(other)


def flips(rows: Rows) -> Iterator[tuple[Cause, list[Numbers]]]:
    """One sign turned."""
    for k, row in enumerate(rows):
        for column in ("alpha", "a", "d"):
            x = getattr(row, column)
            if x and not (column == "alpha" and abs(math.sin(x)) < 1e-9):
                twist = cause("table.twist", row=k + 1)
                key = twist if column == "alpha" else cause("table.sign", column=column, row=k + 1)
                yield key, [*rows[:k], row._replace(**{column: -x}), *rows[k + 1 :]]
