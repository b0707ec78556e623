"""Is my table wrong, or only different?"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

from helpers.arm import Arm
from helpers.checks import door
from helpers.checks import tables_causes as usual
from helpers.checks.axes import (
    Compared,
    Difference,
    Numbers,
    Rows,
    Side,
    angle_between,
    compared,
    numeric,
    side,
)
from helpers.checks.digits import RIGHT, ROUNDED, WRONG, units
from helpers.checks.joint_map import Map, in_own_joints, joint_map, words
from helpers.checks.ranking import Cause, cause, lower
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be, shown
from helpers.reading import table as reading
from helpers.reading.sentences import say, size

_ANGLE = 1e-4  # rad: angles are often written with four decimals
_LENGTH = 1e-6  # m
_COARSEST = 1e-3  # m: lengths typed to the millimetre are still lengths


@dataclass(frozen=True)
class Table:
    """A student's table in numbers: as typed, in SI units where they were said, with the units of
    the last places.
    """

    name: str
    rows: list[Numbers]
    texts: list[Mapping[str, str]]
    length_unit: float
    angle_unit: float
    said: tuple[str, ...]


def compare_tables(
    mine: Any,
    reference: Arm,
    *,
    columns: str | None = None,
    lengths: str | None = None,
    angles: str | None = None,
    convention: str | None = None,
    values: Mapping[str, float] | None = None,
    tolerance: float | None = None,
) -> Report:
    """Whether two DH tables describe the same arm, and if not, where they differ and why.

    Compared is what no choice of frames can change: the kind of each joint, distance and twist
    between neighbouring axes, the offset along each axis (along parallel axes only the sum), and
    where the tip is on the last link. Free are the directions of the axes but z_0, the places of
    common normals between parallel axes, the zeros of the joints, the place of a sliding axis and
    the number of fixed rows. Where the joints of a right table count otherwise, the report prints
    the map and holds the arm in your joints, ``report.figures["arm"]``.

    Args:
        mine: an `Arm`, or rows in a list, text, `Link(...)` lines or 4 x 4 matrices, as
            ``Arm.from_table`` takes them.
        reference: the arm it should describe.
        columns, lengths, angles, convention, values: how to read `mine`; guessed, and said, unless
            given.
        tolerance: the largest deviation of a length (m); inferred from the digits typed unless
            given.

    Raises ArmError where an arm has no joint or `mine` is no table. Source: Siciliano et al.,
    Robotics, section 2.8.2, on the free choices.
    """
    must_be(reference, Arm, "the reference")
    door.settings("rad", tolerance, values)
    if not reference.dof or (isinstance(mine, Arm) and not mine.dof):
        raise ArmError(
            f"cannot compare {shown(mine)} with {reference!r}; expected arms with one joint or more"
        )
    tables = _tables(mine, reference, columns, lengths, angles, convention, values)
    reports = (_judged(table, reference, tolerance) for table in tables)
    first = next(reports)
    return first if first.grade != WRONG else next((r for r in reports if r.grade != WRONG), first)


# What was typed


def _tables(
    mine: Any, reference: Arm, columns, lengths, angles, convention, values
) -> Iterator[Table]:
    if isinstance(mine, Arm):
        if given := [x for x in (columns, lengths, angles, convention) if x is not None]:
            raise ArmError(say("arm is read", given=", ".join(map(shown, given))))
        texts = [{n: str(getattr(r, n)) for n in reading.ENTRIES} for r in mine.rows]
        yield _table(mine.name, list(numeric(mine)), texts, ())
        return
    known = {**dict(reference.values), **(values or {})}
    for typed in reading.read(mine, columns, lengths, angles, convention, known):
        yield _of_typed(typed, reference)


def _of_typed(typed: reading.TypedTable, reference: Arm) -> Table:
    meant = reading.meant(typed, [r.kind for r in numeric(reference)])
    none: list[Any] = [{}]
    texts = none * (len(meant.rows) - len(typed.rows)) + [r.texts for r in typed.rows]
    table = _table(say("your table"), meant.rows, texts, meant.said)
    return replace(
        table,
        length_unit=table.length_unit * meant.length,
        angle_unit=table.angle_unit * meant.angle,
    )


def _table(name: str, rows: list[Numbers], texts: list, said: tuple[str, ...]) -> Table:
    length = units([t[c] for t in texts for c in ("a", "d") if c in t])
    angle = units([t[c] for t in texts for c in ("alpha", "theta") if c in t])
    return Table(name, rows, texts, max(length, default=0.0), max(angle, default=0.0), said)


def _squared(rows: Rows, unit: float) -> list[Numbers]:
    """The rows with angles near a multiple of a right angle taken as that: 1.57 is meant as
    pi/2.
    """
    return [r._replace(alpha=_square(r.alpha, unit), theta=_square(r.theta, unit)) for r in rows]


def _square(angle: float, unit: float) -> float:
    right = round(angle / (math.pi / 2)) * math.pi / 2
    near = max(_ANGLE, 0.51 * unit if unit <= 0.02 else 0.0)
    return right if abs(angle - right) < near else angle


# The verdict


@dataclass(frozen=True)
class _Try:
    """One reading of what was meant: its causes, the rows, the arm they are held against, and what
    is left.
    """

    cause: Cause | None
    rows: list[Numbers]
    reference: tuple[Numbers, ...]
    entries: int

    def found(self, length: float) -> Compared:
        return compared(side(self.rows), side(self.reference), length, _ANGLE)


def _judged(table: Table, reference: Arm, tolerance: float | None) -> Report:
    wanted = tuple(_squared(numeric(reference), 0.0))
    rows = _squared(table.rows, table.angle_unit)
    mine, ref = side(rows) if any(r.kind != "F" for r in rows) else None, side(wanted)
    if mine is None:
        raise ArmError(say("table no joint", name=table.name))
    exact = _LENGTH if tolerance is None else max(tolerance, 1e-12)
    found = compared(mine, ref, exact)
    if not found.differences:
        return _same(RIGHT, table, reference, mine, ref, found, rows)
    rounded = 0.51 * table.length_unit if tolerance is None else 0.0
    if exact < rounded <= 0.51 * _COARSEST:
        near = compared(mine, ref, 2 * rounded)
        if not near.differences:
            return _same(ROUNDED, table, reference, mine, ref, near, rows)
    return _different(table, reference, rows, wanted, found, max(exact, min(rounded, _COARSEST)))


def _same(
    grade: str,
    table: Table,
    reference: Arm,
    mine: Side,
    ref: Side,
    found: Compared,
    rows: list[Numbers],
) -> Report:
    loose = _LENGTH if grade == RIGHT else 10 * table.length_unit
    mapped = joint_map(mine, ref, found, loose)
    figures: dict[str, Any] = {"signs": found.signs}
    notes = [
        *_zeros(mapped, mine, ref, table, reference),
        *_base(mine, found),
        *_tool(found),
        *_written(table),
    ]
    if mapped is not None:
        figures["joint_map"] = tuple(zip(mapped.signs, mapped.offsets, strict=True))
        figures["arm"] = in_own_joints(
            rows, reference, mapped, mine, ref, say("own joints", arm=reference.name)
        )
    key = "table same" if grade == RIGHT else "table rounded"
    headline = say(key, mine=table.name, reference=reference.name)
    return Report(
        "table", reference.name, grade, headline, (), (), table.said, tuple(notes), figures
    )


def _zeros(
    mapped: Map | None, mine: Side, ref: Side, table: Table, reference: Arm
) -> Iterator[str]:
    if mapped is None:
        yield say("map unknown")
    elif not mapped.is_identity:
        yield say("map", equations="; ".join(words(mapped, mine, ref)))


def _base(mine: Side, found: Compared) -> Iterator[str]:
    if found.signs[0] < 0:
        yield say("base upside down")
    elif abs(found.base_higher) > _LENGTH:
        way = say("higher") if found.base_higher > 0 else say("lower")
        first = next(g for g in mine.gaps if g.places_base)
        row = mine.joints[first.bunch[-1]]
        yield say("base", height=size(1000 * abs(found.base_higher), 4), way=way, row=row)


def _tool(found: Compared) -> Iterator[str]:
    m, r = found.tilts
    if angle_between(m, r) > _ANGLE:
        yield say("tool", mine=size(math.degrees(m), 4), reference=size(math.degrees(r), 4))


def _written(table: Table) -> Iterator[str]:
    """A word on each angle that was taken as a multiple of a right angle though it is not quite
    one.
    """
    names = {-2: "-pi", -1: "-pi/2", 1: "pi/2", 2: "pi"}
    for i, row in enumerate(table.rows, 1):
        for column in ("alpha", "theta"):
            x = getattr(row, column)
            right = _square(x, table.angle_unit)
            if abs(x - right) > 1e-9:
                turns = round(right / (math.pi / 2))
                wanted = names.get(turns, "0" if not turns else f"{turns} pi/2")
                yield say(
                    "write right angle",
                    column=column,
                    row=i,
                    typed=_typed(table, i, column),
                    wanted=wanted,
                )


def _typed(table: Table, row: int, column: str) -> str:
    return table.texts[row - 1].get(column, size(getattr(table.rows[row - 1], column), 6))


# What differs, and why


def _different(
    table: Table,
    reference: Arm,
    rows: list[Numbers],
    wanted: tuple[Numbers, ...],
    found: Compared,
    length: float,
) -> Report:
    tries = list(_tries(rows, reference, wanted))
    best = _agreeing(tries, length) or _one_sign(rows, wanted, found, length)
    if best is not None:
        return _bad(table, reference, best.cause, (), ())
    close = [t for t in tries if 0 < t.entries <= max(3, len(wanted) // 2 + 1)]
    close.sort(key=lambda t: _edits(t.cause) + 0.7 * t.entries)
    if close:
        first = close[0]
        entries = list(_entries(table, first, length))
        if entries:
            notes = () if first.cause else tuple(_base(side(rows), found))
            return _bad(table, reference, first.cause, entries, notes)
    likely, left = _fewest(tries, length, found)
    notes = () if likely or not found.signs else tuple(_base(side(rows), found))
    return _bad(table, reference, likely, [_geometry(d) for d in left], notes)


def _edits(c: Cause | None) -> int:
    return 0 if c is None else len(c.keys)


def _tries(rows: list[Numbers], reference: Arm, wanted: tuple[Numbers, ...]) -> Iterator[_Try]:
    """Every reading with up to two causes, fewest first, each with how many entries differ from the
    reference's.
    """
    starts = usual.units(rows, wanted)
    others = [
        (None, wanted),
        *((c, tuple(_squared(r, 0.0))) for c, r in usual.references(reference)),
    ]
    mends = usual.structures(len(rows))
    found: list[Any] = []
    for first, read in starts:
        for other, arm in others:
            both = first + other if first and other else first or other
            found.append((both, _squared(read, 0.0), arm))
            for second, mend in mends:
                whole = both + second if both else second
                if len(whole.keys) <= 2:
                    found.append((whole, _squared(mend(list(read)), 0.0), arm))
        for k, (second, mend) in enumerate(mends):
            for third, then in mends[k + 1 :]:
                if first is None and third.keys[0] != "table.rows exchanged":
                    found.append((second + third, _squared(then(mend(list(read))), 0.0), wanted))
    for whole, read, arm in sorted(found, key=lambda f: _edits(f[0])):
        yield _Try(whole, read, arm, _unequal(read, arm))


def _unequal(rows: Rows, wanted: Rows) -> int:
    """How many entries differ, the zeros of joints that turn not counted; many where the rows do
    not correspond.
    """
    return len(_unequal_entries(rows, wanted)) if _alike(rows, wanted) else 99


def _alike(rows: Rows, wanted: Rows) -> bool:
    return [r.kind for r in rows] == [r.kind for r in wanted]


def _unequal_entries(rows: Rows, wanted: Rows, length: float = _LENGTH) -> list[tuple[int, str]]:
    found = []
    for k, (row, other) in enumerate(zip(rows, wanted, strict=True)):
        for column in ("a", "alpha", "d", "theta"):
            x, y = getattr(row, column), getattr(other, column)
            free = (column == "theta" and row.kind == "R") or (column == "d" and row.kind == "P")
            off = (
                angle_between(x, y) > _ANGLE
                if column in ("alpha", "theta")
                else abs(x - y) > length
            )
            if off and not free:
                found.append((k, column))
    return found


def _agreeing(tries: list[_Try], length: float) -> _Try | None:
    """The first reading that leaves nothing: entries equal, or single causes and units judged by
    the axes.
    """
    return next(
        (
            t
            for t in tries
            if t.cause is not None and _likely(t) and not t.found(length).differences
        ),
        None,
    )


def _likely(t: _Try) -> bool:
    """Whether a reading is worth a comparison of the axes."""
    if all(r.kind == "F" for r in t.rows):
        return False
    keys = t.cause.keys if t.cause else ()
    single = len(keys) == 1 or t.entries <= 2 * len(t.reference)
    return t.entries == 0 or (single and keys[-1:] != ("table.rows exchanged",))


def _one_sign(
    rows: list[Numbers], wanted: tuple[Numbers, ...], found: Compared, length: float
) -> _Try | None:
    near = {d.row + k for d in found.differences for k in (-1, 0, 1)}
    fits = []
    for c, mended in usual.flips(rows, near):
        t = _Try(c, mended, wanted, _unequal(mended, wanted))
        if not t.found(length).differences:
            fits.append(t)
    return min(fits, key=lambda t: t.entries, default=None)


def _entries(table: Table, t: _Try, length: float) -> Iterator[Finding]:
    """The fewest entries that must change to agree with the reference, in the student's numbers."""
    shift = len(t.rows) - len(table.rows)
    for k, column in _needed(t, length):
        x, y = getattr(t.rows[k], column), getattr(t.reference[k], column)
        yield _entry(table, t, k + 1 - shift, column, x, y)


def _needed(t: _Try, length: float) -> tuple[tuple[int, str], ...]:
    wrong = _unequal_entries(t.rows, t.reference, length)
    for count in range(1, len(wrong)):
        for chosen in combinations(wrong, count):
            rows = list(t.rows)
            for k, column in chosen:
                rows[k] = rows[k]._replace(**{column: getattr(t.reference[k], column)})
            if not compared(side(rows), side(t.reference), length, _ANGLE).differences:
                return chosen
    return tuple(wrong)


def _entry(table: Table, t: _Try, row: int, column: str, mine: float, wanted: float) -> Finding:
    """One wrong entry; its row is the student's, also where a and alpha were read one row on."""
    if t.cause is not None and "table.craig" in t.cause.keys and column in ("a", "alpha"):
        row += 1
    key, fields = _kind_of_error(column, row, mine, wanted)
    typed = (
        _typed(table, row, column) if t.cause is None or len(t.cause.keys) == 0 else size(mine, 6)
    )
    said = say("table entry", row=row, column=column, typed=typed, words=lower(say(key, **fields)))
    return Finding(cause(key, **fields).name, f"row {row}, {column}", typed, None, said)


def _kind_of_error(column: str, row: int, mine: float, wanted: float) -> tuple[str, dict]:
    angular = column in ("alpha", "theta")
    same = angle_between(mine, -wanted) < _ANGLE if angular else abs(mine + wanted) < _LENGTH
    if same and column == "alpha":
        return "table.twist", dict(row=row)
    if same:
        return "table.sign", dict(column=column, row=row)
    if not mine and column == "alpha":
        return "table.no twist", dict(row=row)
    if not mine:
        return "table.missing", dict(column=column, row=row)
    if not wanted:
        return "table.too much", dict(column=column, row=row)
    if angular:
        return "table.angle", dict(
            column=column, row=row, _off=size(math.degrees(angle_between(mine, wanted)), 4)
        )
    if mine * wanted < 0:
        return "table.number and sign", dict(column=column, row=row)
    way = say("long") if abs(mine) > abs(wanted) else say("short")
    return "table.number", dict(
        column=column, row=row, _off=size(1000 * abs(mine - wanted), 4), _way=way
    )


def _fewest(
    tries: list[_Try], length: float, found: Compared
) -> tuple[Cause | None, tuple[Difference, ...]]:
    """The single cause that leaves much less than none does, and what it leaves."""
    best: tuple[float, Cause | None, tuple[Difference, ...]] = (
        0.7 * len(found.differences),
        None,
        found.differences,
    )
    for t in tries:
        if (
            t.cause is not None
            and len(t.cause.keys) == 1
            and t.cause.keys[0] != "table.rows exchanged"
        ):
            left = t.found(length).differences if any(r.kind != "F" for r in t.rows) else ()
            cost = 1 + 0.7 * len(left)
            if left and cost < best[0]:
                best = (cost, t.cause, left)
    return best[1], best[2]


def _geometry(d: Difference) -> Finding:
    i, j = (*d.ends, 0, 0)[:2]
    end = say("the tip") if d.key == "table distance" and not j else say("axis", i=j)
    along = say("axis", i=i) if i == j else say("parallel axes", i=i, j=j)
    what = say(f"{d.key} what", start=i, end=end, along=along, j=j)
    said = say("table at", row=d.row, entry=d.entry, words=_amount(d, what))
    return Finding("row", f"row {d.row}, {d.entry}", d.mine, d.reference, said)


def _amount(d: Difference, what: str) -> str:
    if isinstance(d.mine, str) or d.key == "table count":
        return say("table other", what=what, mine=d.mine, reference=d.reference)
    if d.key in ("table between", "table held"):
        x, y = (d.mine, d.reference) if d.mine >= 0 else (-d.mine, -d.reference)
        off = size(math.degrees(angle_between(x, y)), 6)
        return say(
            "table angle",
            what=what,
            mine=size(math.degrees(x), 6),
            reference=size(math.degrees(y), 6),
            off=off,
        )
    if d.mine * d.reference < 0:
        return say(
            "table other way", what=what, mine=size(d.mine, 6), reference=size(d.reference, 6)
        )
    way = say("long") if abs(d.mine) > abs(d.reference) else say("short")
    off = size(1000 * abs(d.mine - d.reference), 4)
    return say(
        "table length",
        what=what,
        mine=size(abs(d.mine), 6),
        reference=size(abs(d.reference), 6),
        off=off,
        way=way,
    )


def _bad(table: Table, reference: Arm, named: Cause | None, findings, notes) -> Report:
    findings = tuple(findings)
    own = [f.what for f in findings if "." in f.what]
    single = findings[0] if len(findings) == len(own) == 1 else None
    parts = [*([named.name] if named else []), *(own if len(own) == len(findings) else [])]
    causes = [" + ".join(parts)] if parts else []
    if named:
        rest = "" if not findings else say("and what remains")
        text = say(
            "table wrong",
            mine=table.name,
            reference=reference.name,
            cause=lower(named.words) + rest,
        )
        findings = (Finding("cause", "", None, None, f"{named.words}."), *findings)
    elif single is not None:
        text = say(
            "table wrong",
            mine=table.name,
            reference=reference.name,
            cause=lower(single.words).rstrip("."),
        )
        findings = (Finding("cause", single.where, single.mine, None, single.words),)
    else:
        text = say("table other arm", mine=table.name, reference=reference.name)
    return Report("table", reference.name, WRONG, text, findings, tuple(causes), table.said, notes)
