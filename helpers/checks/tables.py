"""Is my table wrong, or only different?"""

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
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
from helpers.checks.ranking import Cause, cause, lower, several
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be, shown
from helpers.reading import table as reading
from helpers.reading.sentences import say, size

_UNITS = (
    "table.millimetres",
    "table.centimetres",
    "table.mixed units",
    "table.degrees",
    "table.twists in degrees",
)
_ONE_ENTRY = ("table.pen", "table.length")  # a wrong entry whose reason is known
_ENTRY = 0.7  # what a wrong entry costs, where a cause costs 1
_BY_AXES = 0.5  # what it costs besides that entries still differ though the axes agree
_ANGLES = ("alpha", "theta")
_ANGLE = 1e-4  # rad: angles are often written with four decimals
_LENGTH = 1e-6  # m
_DECIMAL = re.compile(r"\d*\.\d+(?:[eE][+-]?\d+)?")
_LOW = 1e-2  # m: a base no higher tells no unit
_SHORT = 1e3 / math.sqrt(10)  # mm for each m: less is nearer to the arm's size in centimetres
_COARSEST = 1e-3  # m: lengths typed to the millimetre are still lengths
_WHOLES = re.compile(r"(?:[-+−()$\s0-9]|(?<=[0-9])\.(?![0-9]))*")  # and their sums


@dataclass(frozen=True)
class Table:
    """A student's table in numbers: as typed, in SI units where they were said, with the units of
    the last places.

    In the modified convention a and alpha stand one row further down than in `rows`; `added` is 1
    where a fixed row before the typed ones holds the first of them. `exchanged` where the heads of
    alpha and theta are, `other_size` where it is the table before with lengths of another size.
    """

    name: str
    rows: list[Numbers]
    texts: list[Mapping[str, str]]
    length_unit: float
    angle_unit: float
    length_scale: float
    angle_scale: float
    said: tuple[str, ...]
    modified: bool = False
    added: int = 0
    exchanged: bool = False
    other_size: bool = False

    def row_of(self, row: int, column: str) -> int:
        """The typed row, from 1, that holds an entry of a row of `rows`."""
        return row - self.added + int(self.modified and column in ("a", "alpha"))

    def text(self, row: int, column: str) -> str | None:
        """What was typed as an entry of a row of `rows`; None where no row holds it."""
        typed = dict(enumerate(self.texts, 1))
        return typed.get(self.row_of(row, column), {}).get(column)


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
    tolerance = door.settings("rad", tolerance, values)
    if not reference.dof or (isinstance(mine, Arm) and not mine.dof):
        raise ArmError(
            f"cannot compare {shown(mine)} with {reference!r}; expected arms with one joint or more"
        )
    readings = _tables(mine, reference, columns, lengths, angles, convention, values)
    tables = [_Judged.of(table, reference, tolerance) for table in readings]
    if good := next(filter(None, (t.good() for t in tables)), None):
        return good
    first = tables[0].bad()
    if not first.causes and len(tables) > 1 and tables[1].table.other_size:
        other = tables[1].bad()
        return other if other.causes else first
    return first


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
    wanted = numeric(reference)
    for typed in reading.read(mine, columns, lengths, angles, convention, known, mend=True):
        for n, one in enumerate(_sizes(typed, wanted)):
            yield replace(_of_typed(one, wanted), other_size=bool(n))


def _sizes(typed: reading.TypedTable, wanted: Rows) -> Iterator[reading.TypedTable]:
    """The sizes that large lengths may have where nobody said it: millimetres, or centimetres; that
    which is nearer to the reference's first.
    """
    if not typed.in_millimetres:
        yield typed
        return
    said = (*typed.said, say("taken: centimetres"))
    both = (typed, replace(typed, lengths="cm", said=said))
    lengths = (abs(row.numbers[c]) for row in typed.rows for c in ("a", "d"))
    yield from both[:: -1 if sum(lengths) < _SHORT * usual.total_length(wanted) else 1]


def _of_typed(typed: reading.TypedTable, wanted: Rows) -> Table:
    meant = reading.meant(typed, [r.kind for r in wanted])
    table = _table(say("your table"), meant.rows, [r.texts for r in typed.rows], meant.said)
    modified = typed.convention == "craig"
    first = typed.rows[0].numbers
    return replace(
        table,
        length_unit=_whole_unit(typed, meant.length) or table.length_unit * meant.length,
        length_scale=meant.length,
        angle_unit=table.angle_unit * meant.angle,
        angle_scale=meant.angle,
        modified=modified,
        added=int(modified and bool(first["a"] or first["alpha"])),
        exchanged=typed.exchanged,
    )


def _table(name: str, rows: list[Numbers], texts: list, said: tuple[str, ...]) -> Table:
    length, angle = (_unit(texts, columns) for columns in (("a", "d"), _ANGLES))
    return Table(name, rows, texts, length, angle, 1.0, 1.0, said)


def _unit(texts: list[Mapping[str, str]], columns: tuple[str, str]) -> float:
    """The unit of the last place of the decimals in some columns; 0 where there are none."""
    found = [x for t in texts for c in columns for x in _DECIMAL.findall(t.get(c, ""))]
    return max(units(found), default=0.0)


def _whole_unit(typed: reading.TypedTable, scale: float) -> float:
    """The unit of lengths that are all whole numbers of a small size; 0 for others. Whole numbers
    among formulas are exact.
    """
    lengths = (
        row.texts[c] for row in typed.rows for c in ("a", "d") if (row.kind, c) != ("P", "d")
    )
    return scale if scale <= _COARSEST and all(map(_WHOLES.fullmatch, lengths)) else 0.0


def _squared(rows: Rows) -> list[Numbers]:
    """The rows with angles near a multiple of a right angle taken as that."""
    return list(map(_squared_row, rows))


@lru_cache(1024)
def _squared_row(row: Numbers) -> Numbers:
    return row._replace(alpha=_square(row.alpha), theta=_square(row.theta))


def _square(angle: float, unit: float = 0.0) -> float:
    right = round(angle / (math.pi / 2)) * math.pi / 2
    return right if abs(angle - right) < max(_ANGLE, 0.51 * unit) else angle


def _meant(table: Table) -> list[Numbers]:
    """The rows with angles that were cut to two decimals or more taken as the right angles that
    they are near: 1.57 is meant as pi/2.
    """
    rows = []
    for i, row in enumerate(table.rows, 1):
        alpha, theta = (_square(getattr(row, c), _own_unit(table, i, c)) for c in _ANGLES)
        rows.append(row._replace(alpha=alpha, theta=theta))
    return rows


def _own_unit(table: Table, row: int, column: str) -> float:
    """The unit of the last decimal in one angle, where it has two or more."""
    found = _DECIMAL.findall(table.text(row, column) or "")
    places = len(found[-1].partition(".")[2]) if found else 0
    return table.angle_scale * 10.0**-places if places >= 2 else 0.0


# The verdict


@dataclass(frozen=True)
class _Try:
    """One reading of what was meant: its causes, the rows, the arm they are held against, and what
    is left.
    """

    cause: Cause | None
    rows: list[Numbers]
    reference: Side
    entries: float

    def found(self, length: float) -> Compared:
        return compared(side(self.rows), self.reference, length, _ANGLE)


@dataclass(frozen=True)
class _Judged:
    """One reading of a table beside the reference."""

    table: Table
    reference: Arm
    tolerance: float | None
    mine: Side
    ref: Side

    @classmethod
    def of(cls, table: Table, reference: Arm, tolerance: float | None) -> "_Judged":
        ref = side(_squared(numeric(reference)))
        return cls(table, reference, tolerance, side(_meant(table)), ref)

    @property
    def exact(self) -> float:
        return _LENGTH if self.tolerance is None else max(self.tolerance, 1e-12)

    @cached_property
    def found(self) -> Compared:
        return compared(self.mine, self.ref, self.exact)

    def good(self) -> Report | None:
        """The report on the same arm; None where it is another."""
        if not self.found.differences:
            return self._same(RIGHT, self.found)
        if self.tolerance is None:
            length, angle = _rounding(self.table)
            # A turned axis meets the next one elsewhere.
            wide = max(self.exact, 2 * length, 2.5 * angle * _reach(self.mine.rows))
            near = compared(self.mine, self.ref, wide, max(_ANGLE, 4 * angle))
            if not near.differences:
                return self._same(ROUNDED, near)
        return None

    def _same(self, grade: str, found: Compared) -> Report:
        if self.table.exchanged:
            return _bad(self.table, self.reference, [cause("table.alpha and theta")])
        return _same(grade, self.table, self.reference, self.mine, self.ref, found)

    def bad(self) -> Report:
        """The report on another arm."""
        length = _rounding(self.table)[0] if self.tolerance is None else 0.0
        return _different(self.table, self.reference, self.mine, self.ref, max(self.exact, length))


def _reach(rows: Rows) -> float:
    return max(abs(x) for r in rows for x in (r.a, r.d))


def _rounding(table: Table) -> tuple[float, float]:
    """Half a unit of the lengths and of the angles, where it is small enough to be a rounding."""
    length, angle = (
        0.51 * unit if unit <= _COARSEST else 0.0 for unit in (table.length_unit, table.angle_unit)
    )
    return length, angle


def _same(
    grade: str, table: Table, reference: Arm, mine: Side, ref: Side, found: Compared
) -> Report:
    last = table.length_unit or table.angle_unit * _reach(mine.rows)
    loose = _LENGTH if grade == RIGHT else 10 * last
    mapped = joint_map(mine, ref, found, loose)
    figures: dict[str, Any] = {"upside down": found.upside_down}
    notes = [
        *_zeros(table, mapped, mine, ref),
        *_base(table, mine, found, mapped),
        *_two_units(table, mine, found),
        *_tool(found),
        *_written(table),
    ]
    if mapped is not None:
        figures["joint_map"] = tuple(zip(mapped.signs, mapped.offsets, strict=True))
        figures["arm"] = in_own_joints(
            mine.rows, reference, mapped, ref, say("own joints", arm=reference.name)
        )
    key = "table same" if grade == RIGHT else "table rounded"
    headline = say(key, mine=table.name, reference=reference.name)
    return Report(
        "table", reference.name, grade, headline, (), (), table.said, tuple(notes), figures
    )


def _zeros(table: Table, mapped: Map | None, mine: Side, ref: Side) -> Iterator[str]:
    if mapped is None:
        yield say("map unknown")
    elif told := words(mapped, [table.row_of(i, "d") for i in mine.joints], ref):
        yield say("map", equations="; ".join(told))


def _base(table: Table, mine: Side, found: Compared, mapped: Map | None = None) -> Iterator[str]:
    """A word on where the base's frame stands on axis 1, and on z_0 where axis 1 leans from it."""
    if found.upside_down:
        yield say("base upside down")
        return
    along, lean = found.base_higher, mine.foot[1]
    rest = 0.0 if mapped is None else mapped.base.o[2] - along * math.cos(lean)
    first = next((g for g in mine.gaps if g.places_base), None)
    row = table.row_of(mine.joints[first.bunch[-1] if first else 0], "d")
    leaning = (("base", along), ("base on z_0", rest))
    for key, higher in leaning if lean > _ANGLE else (("base", along + rest),):
        if abs(higher) > _LENGTH:
            way = say("higher") if higher > 0 else say("lower")
            yield say(key, height=size(round(1000 * abs(higher), 6), 4), way=way, row=row)


def _two_units(table: Table, mine: Side, found: Compared) -> Iterator[str]:
    """A word on the row up to joint 1 whose d puts the base where the reference's is once it is
    read in metres among smaller units, or in millimetres among metres.
    """
    factor = 1 / table.length_scale if table.length_scale < 1 else 1e-3
    for row in range(1, mine.joints[0] + 1):
        d = table.rows[row - 1].d
        off = abs(abs(d * (factor - 1)) - abs(found.base_higher))
        others = usual.total_length(table.rows) > abs(d)
        if others and abs(d * factor) >= _LOW and off < 0.51 * _COARSEST:
            yield say("base unit", row=table.row_of(row, "d"))


def _tool(found: Compared) -> Iterator[str]:
    m, r = found.tilts
    if angle_between(m, r) > _ANGLE:
        mine, reference = (size(round(math.degrees(x), 4), 4) for x in (m, r))
        yield say("tool", mine=mine, reference=reference)


def _written(table: Table) -> Iterator[str]:
    """A word on each angle that was taken as a multiple of a right angle though it is not quite
    one.
    """
    names = {-2: "-pi", -1: "-pi/2", 0: "0", 1: "pi/2", 2: "pi"}
    for i, row in enumerate(table.rows, 1):
        for column in _ANGLES:
            x = getattr(row, column)
            right = _square(x, _own_unit(table, i, column))
            if abs(x - right) > 1e-9:
                turns = round(right / (math.pi / 2))
                yield say(
                    "write right angle",
                    column=column,
                    row=table.row_of(i, column),
                    typed=_typed(table, i, column),
                    wanted=names.get(turns, f"{turns} pi/2"),
                )


def _typed(table: Table, row: int, column: str) -> str:
    text = table.text(row, column)
    return size(getattr(table.rows[row - 1], column), 6) if text is None else text


# What differs, and why


def _different(table: Table, reference: Arm, mine: Side, ref: Side, length: float) -> Report:
    """Why a table is another arm, the simplest first: causes after which every entry agrees, one or
    two wrong entries, causes and single signs after which the axes agree, more wrong entries, or
    what is left of the axes.
    """
    found = compared(mine, ref, length)
    tries = list(_tries(list(mine.rows), reference, ref, table.modified, length))
    equal = [t.cause for t in tries if t.cause and not t.entries]
    if equal:
        fewest = min(len(c.keys) for c in equal)
        return _bad(table, reference, [c for c in equal if len(c.keys) == fewest])
    notes = tuple(_base(table, mine, found))
    local = _local(tries, len(ref.rows), length)
    most = local[0] if local else math.inf
    whole = _agreeing(tries, length, most)
    if whole is None and most > 1 + _BY_AXES:
        whole = _one_sign(mine.rows, ref, length)
    if whole is not None and whole.cause:
        return _bad(table, reference, [whole.cause])
    if local is not None and most <= _by_axes(found, local[1].cause):
        _, t, needed = local
        entries = [_entry(table, t, k, column, length) for k, column in needed]
        return _bad(
            table, reference, [t.cause] if t.cause else [], entries, () if t.cause else notes
        )
    first, left = _fewest(tries, length, found)
    findings = [_geometry(table, d) for d in left]
    return _bad(table, reference, [first] if first else [], findings, () if first else notes)


def _local(
    tries: list[_Try], rows: int, length: float
) -> tuple[float, _Try, tuple[tuple[int, str], ...]] | None:
    """The reading that needs least besides a few entries: its cost, and the entries."""
    close = [t for t in tries if 0 < t.entries <= max(3, rows // 2 + 1)]
    if not close:
        return None
    best = min(close, key=lambda t: _cost(t.cause) + _ENTRY * t.entries)
    needed = _needed(best, length)
    mistakes = sum(_mistakes(best, k, column, length) for k, column in needed)
    return _cost(best.cause) + _ENTRY * mistakes, best, needed


def _mistakes(t: _Try, k: int, column: str, length: float) -> int:
    """How many mistakes a wrong entry is: two where neither number nor sign is right."""
    mine, wanted = getattr(t.rows[k], column), getattr(t.reference.rows[k], column)
    return 1 + (_kind_of_error(column, k, mine, wanted, length)[0] == "table.number and sign")


def _by_axes(found: Compared, c: Cause | None) -> float:
    """What the differences of the axes cost, by which a table in frames of its own is judged.

    No bound where joints do not correspond, or against entries alone where a twist differs: axes
    that are parallel, and should not be, hide lengths.
    """
    hidden = c is None and any(d.entry == "alpha" for d in found.differences)
    return math.inf if hidden or not found.signs else _ENTRY * len(found.differences)


def _cost(c: Cause | None) -> float:
    """What a reading costs; units go wrong so often that they are cheap."""
    cheap = dict.fromkeys(_UNITS, 0.5) | dict.fromkeys(_ONE_ENTRY, 0.6)
    return 0 if c is None else sum(cheap.get(key, 1) for key in c.keys)


def _apart(c: Cause) -> float:
    """What it costs besides that entries still differ: nothing where the cause is one entry."""
    return 0 if len(c.keys) == 1 and c.keys[0] in _ONE_ENTRY else _BY_AXES


def _tries(
    rows: list[Numbers], reference: Arm, ref: Side, modified: bool, length: float
) -> Iterator[_Try]:
    """Every reading with up to two causes, each with how many entries differ from the arm's."""
    others = [
        (None, ref),
        *((c, side(_squared(r))) for c, r in usual.references(reference)),
    ]
    mends = usual.structures(len(rows), modified)
    whole = [(c, mend) for c, mend in mends if c.keys[0] != usual.EXCHANGED]

    def held(why: Cause | None, read: list[Numbers], arm: Side) -> _Try:
        squared = _squared(read)
        return _Try(why, squared, arm, _unequal(squared, arm.rows, length))

    for first, read in usual.units(rows, ref.rows):
        for other, arm in others:
            both = usual.joined(first, other)
            yield held(both, read, arm)
            for second, mend in mends if both is None or len(both.keys) == 1 else ():
                yield held(usual.joined(both, second), mend(read), arm)
        for (second, mend), (third, then) in combinations(whole, 2) if first is None else ():
            yield held(second + third, then(mend(rows)), ref)


def _unequal(rows: Rows, wanted: Rows, length: float) -> float:
    """How many entries differ, the zeros of joints not counted; all where the rows do not
    correspond.
    """
    alike = [r.kind for r in rows] == [r.kind for r in wanted]
    return len(_unequal_entries(rows, wanted, length)) if alike else math.inf


def _unequal_entries(rows: Rows, wanted: Rows, length: float) -> list[tuple[int, str]]:
    found = []
    for k, (row, other) in enumerate(zip(rows, wanted, strict=True)):
        kind, a, alpha, d, theta = row
        if abs(a - other.a) > length:
            found.append((k, "a"))
        if alpha != other.alpha and angle_between(alpha, other.alpha) > _ANGLE:
            found.append((k, "alpha"))
        if kind != "P" and abs(d - other.d) > length:
            found.append((k, "d"))
        if kind != "R" and angle_between(theta, other.theta) > _ANGLE:
            found.append((k, "theta"))
    return found


def _agreeing(tries: list[_Try], length: float, most: float) -> _Try | None:
    """The first reading after which the axes agree, though entries differ, below a cost."""
    for t in tries:
        if t.cause is None or _cost(t.cause) + _apart(t.cause) >= most:
            continue
        # Two causes after which most entries differ, and exchanged rows, fit by chance only;
        # Craig's rows may be one more than the reference's.
        few = len(t.cause.keys) == 1 or t.entries <= 2 * len(t.reference.rows)
        last = t.cause.keys[-1]
        likely = (few or last == "table.craig") and last != usual.EXCHANGED
        if likely and not t.found(length).differences:
            return t
    return None


def _one_sign(rows: Rows, ref: Side, length: float) -> _Try | None:
    tries = (
        _Try(c, mended, ref, _unequal(mended, ref.rows, length)) for c, mended in usual.flips(rows)
    )
    fits = [t for t in tries if not t.found(length).differences]
    return min(fits, key=lambda t: t.entries, default=None)


def _needed(t: _Try, length: float) -> tuple[tuple[int, str], ...]:
    wanted = t.reference.rows
    wrong = _unequal_entries(t.rows, wanted, length)
    for count in range(1, len(wrong)):
        for chosen in combinations(wrong, count):
            rows = list(t.rows)
            for k, column in chosen:
                rows[k] = rows[k]._replace(**{column: getattr(wanted[k], column)})
            if not compared(side(rows), t.reference, length, _ANGLE).differences:
                return chosen
    return tuple(wrong)


def _entry(table: Table, t: _Try, k: int, column: str, length: float) -> Finding:
    """One wrong entry in the student's numbers; its row is the student's, also where a and alpha
    were read one row on.
    """
    mine, wanted = getattr(t.rows[k], column), getattr(t.reference.rows[k], column)
    craig = t.cause is not None and "table.craig" in t.cause.keys
    shift = int(craig and bool(table.rows[0].a or table.rows[0].alpha))
    row = table.row_of(k + 1, column) - shift + int(craig and column in ("a", "alpha"))
    key, fields = _kind_of_error(column, row, mine, wanted, length)
    typed = _typed(table, k + 1, column) if t.cause is None else size(mine, 6)
    said = say("table entry", typed=typed, words=say(key, **fields))
    return Finding(cause(key, **fields).name, f"row {row}, {column}", typed, None, said)


def _kind_of_error(
    column: str, row: int, mine: float, wanted: float, length: float
) -> tuple[str, dict]:
    angular = column in _ANGLES
    same = angle_between(mine, -wanted) < _ANGLE if angular else abs(mine + wanted) <= length
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
            column=column,
            row=row,
            _off=size(round(math.degrees(angle_between(mine, wanted)), 6), 4),
        )
    if mine * wanted < 0:
        return "table.number and sign", dict(column=column, row=row)
    way = say("long") if abs(mine) > abs(wanted) else say("short")
    return "table.number", dict(
        column=column, row=row, _off=size(round(1000 * abs(mine - wanted), 6), 4), _way=way
    )


def _fewest(
    tries: list[_Try], length: float, found: Compared
) -> tuple[Cause | None, tuple[Difference, ...]]:
    """The single cause that leaves much less than none does, and what it leaves: differences of
    axes, for where joints do not correspond these are not seen.
    """
    best: tuple[float, Cause | None, tuple[Difference, ...]] = (
        0.7 * len(found.differences),
        None,
        found.differences,
    )
    for t in tries:
        if t.cause and len(t.cause.keys) == 1 and t.cause.keys[0] != usual.EXCHANGED:
            left = t.found(length)
            cost = 1 + 0.7 * len(left.differences)
            if left.signs and left.differences and cost < best[0]:
                best = (cost, t.cause, left.differences)
    return best[1:]


def _geometry(table: Table, d: Difference) -> Finding:
    """One difference, in the rows and axes of the table as typed."""
    to_base = d.key in ("table lean", "table foot")
    row = d.row if to_base else table.row_of(d.row, d.entry)
    where = f"row {row}, {d.entry}"
    if d.key == "table count":
        said = say("table count words", mine=d.mine, reference=d.reference)
        return Finding("row", where, d.mine, d.reference, said)
    i, j = (end and table.row_of(end, "d") for end in d.ends)
    to_tip = d.key in ("table distance", "table side") and not j
    end = say("the tip") if to_tip else say("axis", i=j)
    along = say("axis", i=i) if i == j else say("parallel axes", i=i, j=j)
    what = say(f"{d.key} what", start=i, end=end, along=along, j=j)
    said = say("table at", row=row, entry=d.entry, words=_amount(d, what))
    if d.key == "table side":
        return Finding("row", where, None, None, said)
    return Finding("row", where, d.mine, d.reference, said)


def _amount(d: Difference, what: str) -> str:
    if isinstance(d.mine, str):
        return say("table other", what=what, mine=d.mine, reference=d.reference)
    if d.key == "table side":
        return say("table side", what=what)
    if d.key in ("table between", "table held", "table lean"):
        signed = d.key == "table held" or d.mine >= 0  # held as theta is, about the student's axis
        x, y = (d.mine, d.reference) if signed else (-d.mine, -d.reference)
        angles = (round(math.degrees(angle), 4) for angle in (x, y, angle_between(x, y)))
        mine, reference, off = (size(angle, 6) for angle in angles)
        return say("table angle", what=what, mine=mine, reference=reference, off=off)
    # To a micrometre: where axes are nearly parallel, rounding leaves no more of a distance. First
    # to a nanometre, so that half a micrometre is one for the page's judge too.
    x, y = (round(round(length, 9), 6) for length in (d.mine, d.reference))
    if x * y < 0:
        return say("table other way", what=what, mine=size(x, 6), reference=size(y, 6))
    way = say("long") if abs(x) > abs(y) else say("short")
    off = size(round(1000 * abs(d.mine - d.reference), 6), 4)
    mine, reference = size(abs(x), 6), size(abs(y), 6)
    return say("table length", what=what, mine=mine, reference=reference, off=off, way=way)


def _bad(
    table: Table, reference: Arm, causes: list[Cause], findings=(), notes: tuple[str, ...] = ()
) -> Report:
    """`causes` explain the same; of the findings those with a cause of their own add to it."""
    findings = tuple(findings)
    own = [f.what for f in findings if "." in f.what]
    added = own if len(own) == len(findings) else []
    names = [" + ".join([c.name, *added]) for c in causes] or ([" + ".join(added)] if added else [])
    names_of = dict(mine=table.name, reference=reference.name)
    if causes:
        words = several(causes)
        rest = say("and what remains") if findings else ""
        headline = say("table wrong", cause=lower(words) + rest, **names_of)
        findings = (Finding("cause", "", None, None, f"{words}."), *findings)
    elif len(findings) == len(own) == 1:
        only = findings[0]
        headline = say("table wrong", cause=lower(only.words).rstrip("."), **names_of)
        findings = (Finding("cause", only.where, only.mine, None, only.words),)
    else:
        headline = say("table other arm", **names_of)
    return Report(
        "table", reference.name, WRONG, headline, findings, tuple(names), table.said, notes
    )
