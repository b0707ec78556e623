"""A Denavit-Hartenberg table as people hold it: rows in any order of columns, parallel lists,
Link(...) lines, A matrices.

What is not said is guessed, and every guess is told.
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import permutations
from typing import Any, NamedTuple

from helpers.inputs import ArmError, one_of, shown
from helpers.reading import around, formula, grid
from helpers.reading.sentences import listed, say, size
from helpers.rows import Joint, Kind, Row

ENTRIES = ("a", "alpha", "d", "theta")
_JOINTS: dict[str, Kind] = {"R": "revolute", "P": "prismatic", "F": "fixed"}
_UNITS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
_MILLIMETRES = 10.0  # a length this large is no number of metres
_DEGREES = 2 * math.pi + 0.1  # an angle this large is no number of radians
KNOWN_ORDERS = (
    ("theta", "d", "a", "alpha"),
    ("a", "alpha", "d", "theta"),
    ("alpha", "a", "d", "theta"),
    ("alpha", "a", "theta", "d"),
    ("a", "d", "alpha", "theta"),
    ("d", "theta", "a", "alpha"),
    ("theta", "alpha", "a", "d"),
    ("a", "alpha", "theta", "d"),
    ("theta", "a", "d", "alpha"),
    ("d", "a", "alpha", "theta"),
)
_EXCHANGED = {"alpha": "theta", "theta": "alpha"}
_WORDS = {
    **dict.fromkeys(
        ("theta", "th", "q", "jointangle", "angle", "tht", "thetai", "qi", "thi"), "theta"
    ),
    **dict.fromkeys(("d", "offset", "linkoffset", "di", "dm", "dmm"), "d"),
    **dict.fromkeys(("a", "r", "linklength", "length", "ai", "ri"), "a"),
    **dict.fromkeys(("alpha", "twist", "linktwist", "alphai", "al", "alp"), "alpha"),
    **dict.fromkeys(
        ("i", "link", "joint", "j", "n", "frame", "row", "#", "no", "linki", "jointi", "k"), "i"
    ),
}
MOST_ROWS = 32
_BOX = re.compile(r"^[^\n]*│[^\n]*(?:\n[^\n]*[│├┼╪][^\n]*)*", re.M)  # a table drawn with lines
_RECORDS = re.compile(
    r"\{((?:[^{}]|\{[^{}:=,]*\})*)\}|\bdict\(((?:[^()]|\([^()]*\))*)\)"  # q_{1} may stand in one
)
_PAIRS = re.compile(r"['\"]?\b([A-Za-z]+)_?\{?(\d+)\}?['\"]?\s*[:=]\s*((?:[^,;\n{}]|\{[^{}]*\})+)")
_UNIT = re.compile(r"[(\[]?\s*(?:(mm|cm|m|in|deg|degrees|rad|radians|°)|[-–—]?)\s*[)\]]?", re.I)
_JOINT = re.compile(r"(?:q|th|theta|t|phi)_?\{?\d+\}?'?")
_VARIABLE = re.compile(r"(?:inf|nan|var|variable|\*|-|–|—|\?|q|theta|th|θ|d)\*?", re.I)


class Numbers(NamedTuple):
    """A row of a table in numbers: "R" turns, "P" slides, "F" does neither; m and rad."""

    kind: str
    a: float
    alpha: float
    d: float
    theta: float


@dataclass(frozen=True)
class TypedRow:
    """A row as it was meant: "R" turns, "P" slides, "F" is fixed, "?" has no variable in it; its
    numbers as typed.

    Entries with pi or a degree sign in them are in `radians`, whatever the others are in.
    """

    kind: str
    numbers: dict[str, float]
    texts: dict[str, str]
    backwards: bool = False
    radians: frozenset[str] = frozenset()


@dataclass(frozen=True)
class TypedTable:
    """The rows in the units typed, and what was said or guessed of them; None where nothing was.

    `exchanged` where the heads of alpha and theta stand over one another's entries, as the joints'
    variables show.
    """

    rows: tuple[TypedRow, ...]
    lengths: str | None
    angles: str | None
    convention: str | None
    said: tuple[str, ...]
    exchanged: bool = False

    @property
    def in_millimetres(self) -> bool:
        """Whether the lengths are taken as millimetres though nobody said so."""
        sizes = [abs(row.numbers[c]) for row in self.rows for c in ("a", "d")]
        return self.lengths is None and max(sizes) >= _MILLIMETRES


def read(
    source: Any,
    columns: str | Iterable[str] | None = None,
    lengths: str | None = None,
    angles: str | None = None,
    convention: str | None = None,
    values: Mapping[str, float] | None = None,
    mend: bool = False,
) -> list[TypedTable]:
    """The readings of a table, the likeliest first: more than one only where the order of the
    columns had to be guessed. Where `mend`, one whose heads of alpha and theta are exchanged is
    read too.

    Raises ArmError, in words, for what is no table.
    """
    if lengths is not None:
        one_of(lengths, "lengths", _UNITS)
    if angles is not None:
        one_of(angles, "angles", ("rad", "deg"))
    if convention is not None:
        convention = one_of(
            str(convention).lower(), "convention", ("standard", "craig", "modified")
        )
        convention = "craig" if convention == "modified" else convention
    cells, heads, said = _cells(source)
    if not all([cells, *cells]):
        raise ArmError(say("no rows", given=shown(source)))
    known = {_simple(k): float(v) for k, v in (values or {}).items()}
    if matrices := _matrices(cells):
        _few(len(matrices))
        rows = tuple(_from_matrix(i, A, known) for i, A in enumerate(matrices, 1))
        return [TypedTable(rows, lengths, angles, convention, (say("taken: matrices"),))]
    cells, heads = _without_index(cells, heads)
    _few(len(cells))
    try:
        orders, sure = _orders(cells, heads, columns)
    except ArmError:
        if not isinstance(source, str) or not _even(source):
            raise
        apart = grid.apart(source)
        return read(apart, columns, lengths, angles, convention, values, mend)
    unit, angle, modified = _from_heads(heads)
    lengths, angles, convention = (
        lengths or unit,
        angles or angle,
        convention or ("craig" if modified else None),
    )
    tables, errors = [], []
    for order in orders:
        words = (*said, *(() if sure else (say("taken: columns", columns=" ".join(order)),)))
        try:
            rows = _rows(cells, order, known)
        except ArmError as error:
            errors.append(error)
        else:
            tables.append(TypedTable(rows, lengths, angles, convention, words))
    if not tables and mend and sure and _variables_in_alpha(cells, orders[0]):
        order = tuple(_EXCHANGED.get(name, name) for name in orders[0])
        rows = _rows(cells, order, known)
        return [TypedTable(rows, lengths, angles, convention, said, exchanged=True)]
    if not tables:
        raise errors[0]
    return tables


def _even(text: str) -> bool:
    """Whether two blanks and more part the lines of a text into as many cells, and single ones
    stand in some.
    """
    apart = grid.apart(text)
    return apart != text and len({len(row) for row in grid.cells(apart)}) == 1


def _rows(cells: grid.Cells, order: tuple[str, ...], known: Mapping) -> tuple[TypedRow, ...]:
    entries = (dict(zip(order, row, strict=False)) for row in cells)
    return tuple(_row(i, row, known) for i, row in enumerate(entries, 1))


def _variables_in_alpha(cells: grid.Cells, order: tuple[str, ...]) -> bool:
    alphas, thetas = ([row[order.index(name)] for row in cells] for name in _EXCHANGED)
    return any(map(_is_variable, alphas)) and not any(map(_is_variable, thetas))


class Meant(NamedTuple):
    """A table as it was meant: standard rows in m and rad, what was guessed, and the sizes of the
    units typed.
    """

    rows: list[Numbers]
    said: tuple[str, ...]
    length: float
    angle: float

    def as_rows(self) -> tuple[Row, ...]:
        """The rows of an arm, right angles as formulas."""
        return tuple(
            Row(r.a, _right_angle(r.alpha), r.d, _right_angle(r.theta), Joint(_JOINTS[r.kind]))
            for r in self.rows
        )


def _right_angle(angle: float) -> float | str:
    """A multiple of a right angle, to four decimals, as a formula."""
    turns = round(angle / (math.pi / 2))
    if abs(angle - turns * math.pi / 2) > 1e-4:
        return angle
    formulas: dict[int, float | str] = {-2: "-pi", -1: "-pi/2", 0: 0, 1: "pi/2", 2: "pi"}
    return formulas.get(turns, f"{turns} * pi / 2")


def meant(table: TypedTable, kinds: Iterable[str] = ()) -> Meant:
    """The rows in SI units and the standard convention; units not said are guessed by size, and
    told.

    `kinds` are taken where no row holds a variable and there are as many; all turn otherwise.
    """
    said = list(table.said)
    unit, angle = table.lengths, table.angles
    if table.in_millimetres:
        unit = "mm"
        said.append(say("taken: millimetres"))
    open_ = [
        abs(r.numbers[c]) for r in table.rows for c in ("alpha", "theta") if c not in r.radians
    ]
    if angle is None and any(x > _DEGREES for x in open_):
        angle = "deg"
        said.append(say("taken: degrees"))
    f, t = _UNITS[unit or "m"], math.pi / 180 if angle == "deg" else 1.0
    wanted = tuple(kinds)
    if wanted and len(wanted) < len(table.rows) and {r.kind for r in table.rows} == {"?"}:
        fixed = list(range(len(wanted) + 1, len(table.rows) + 1))
        said.append(say("taken: fixed", rows=_named(fixed)))
    rows = []
    for kind, row in zip(_kinds(table, wanted), table.rows, strict=True):
        n = row.numbers
        alpha, theta = (n[c] * (1.0 if c in row.radians else t) for c in ("alpha", "theta"))
        rows.append(Numbers(kind, n["a"] * f, alpha, n["d"] * f, theta))
    if table.convention == "craig":
        rows = from_craig(rows)
        said.append(say("taken: craig"))
    if backwards := [i for i, row in enumerate(table.rows, 1) if row.backwards]:
        said.append(say("taken: backwards", rows=_named(backwards)))
    return Meant(rows, tuple(said), f, t)


def _named(rows: list[int]) -> str:
    if len(rows) == 1:
        return say("row", row=rows[0])
    return say("rows", rows=listed([str(i) for i in rows]))


def _kinds(table: TypedTable, wanted: tuple[str, ...]) -> Iterable[str]:
    kinds = [row.kind for row in table.rows]
    if set(kinds) == {"?"}:
        more = len(kinds) - len(wanted)
        return (*wanted, *("F" * more)) if wanted and more >= 0 else ["R"] * len(kinds)
    return ["F" if kind == "?" else kind for kind in kinds]


def from_craig(rows: list[Numbers]) -> list[Numbers]:
    """Standard rows from modified ones, which begin with a_{i-1}, alpha_{i-1}.

    A fixed row before them takes a_0 and alpha_0; a last one that is left empty goes.
    """
    empty = Numbers("F", 0.0, 0.0, 0.0, 0.0)
    after = [*rows[1:], empty]
    shifted = [r._replace(a=n.a, alpha=n.alpha) for r, n in zip(rows, after, strict=True)]
    if len(shifted) > 1 and shifted[-1] == empty:
        shifted.pop()
    first = empty._replace(a=rows[0].a, alpha=rows[0].alpha)
    return shifted if first == empty else [first, *shifted]


# From what is held to rows of cells


def _cells(source: Any) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    if isinstance(source, Mapping):
        return _of_mapping({str(k): v for k, v in source.items()})
    if isinstance(source, str):
        return _of_text(source)
    if hasattr(source, "columns") and hasattr(source, "to_numpy"):
        return _strings(source.to_numpy().tolist()), [str(c) for c in source.columns], ()
    if hasattr(source, "tolist"):
        source = source.tolist()
    try:
        rows = list(source)
    except TypeError:
        raise ArmError(say("no table", given=shown(source))) from None
    if rows and all(isinstance(row, Mapping) for row in rows):
        heads = list(dict.fromkeys(str(k) for row in rows for k in row))
        return [[_text(row.get(h, 0)) for h in heads] for row in rows], heads, ()
    if rows and all(isinstance(row, str) for row in rows):
        return _of_text("\n".join(rows))
    rows = [row.tolist() if hasattr(row, "tolist") else row for row in rows]
    return _strings(rows), [], ()


def _few(count: int) -> None:
    if count > MOST_ROWS:
        raise ArmError(say("many rows", count=count, most=MOST_ROWS))


def _strings(rows: list) -> Any:
    if not all(isinstance(row, list | tuple) for row in rows):
        raise ArmError(say("no rows", given=shown(rows)))
    return [[x if isinstance(x, list | tuple) else _text(x) for x in row] for row in rows]


def _text(x: Any) -> str:
    if x is None:
        return "*"
    return repr(float(x)).removesuffix(".0") if isinstance(x, float) else str(x)


def _of_mapping(held: dict[str, Any]) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    lists = {k: v.tolist() if hasattr(v, "tolist") else v for k, v in held.items()}
    if lists and all(isinstance(v, list | tuple) for v in lists.values()):
        return _parallel(lists)
    indexed = [(re.fullmatch(r"([A-Za-z]+)_?\{?(\d+)\}?", k), v) for k, v in held.items()]
    known = [(m[1].lower(), int(m[2]), v) for m, v in indexed if m and m[1].lower() in _WORDS]
    if len(known) < max(1, len(indexed)):
        raise ArmError(say("no entries", given=shown(held)))
    return _numbered([(_WORDS[word], row, _text(v)) for word, row, v in known])


def _parallel(lists: Mapping[str, Any]) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    lengths = {len(v) for v in lists.values()}
    if len(lengths) != 1:
        raise ArmError(say("uneven lists", counts=", ".join(map(str, sorted(lengths)))))
    return [[_text(x) for x in row] for row in zip(*lists.values(), strict=True)], list(lists), ()


def _numbered(entries: list[tuple[str, int, str]]) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    """Entries by column and number; a_0 and alpha_0 tell Craig's convention, whose row i has
    a_{i-1} and alpha_{i-1}: a last one with nothing else in it is the tool's.
    """
    early = ("a", "alpha")
    craig = any(c in early and i == 0 for c, i, _ in entries)
    held = {(c, i + 1 if craig and c in early else i): text for c, i, text in entries}
    last = max(i for _, i in held)
    _few(last)
    moving = max((i for c, i in held if c not in early), default=last) if craig else last
    cells = [
        [held.get((c, i), f"q_{i}" if c == "theta" and i <= moving else "0") for c in ENTRIES]
        for i in range(1, last + 1)
    ]
    heads = [f"{c}_{{i-1}}" if craig and c in early else c for c in ENTRIES]
    return cells, heads, ()


def _of_text(text: str) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    text = _unboxed(around.straight(text))
    if links := re.findall(
        r"((?<![A-Za-z])(?:DH)?Link|(?:Revolute|Prismatic)\w*)\s*\(((?:[^()]|\([^()]*\))*)\)",
        text,
    ):
        return _links(links)
    if records := _records(text):
        return records
    named = re.findall(
        r"(?:^|[{,(])\s*['\"]?([A-Za-z_]\w*|[αθ])['\"]?\s*[=:]\s*(?:np\.array|array|sp\.Matrix|Matrix)?"
        r"\s*\(?\s*(\[[^\]]*\]|\{[^}]*\})",
        text,
        re.M,
    )
    words = [_head(name) or "" for name, _ in named]
    if len(named) >= 3 and set(words) <= set(ENTRIES):
        return _parallel(
            {w: grid.cells(f"[{body[1:-1]}]")[0] for w, (_, body) in zip(words, named, strict=True)}
        )
    pairs = _PAIRS.findall(text)
    if (
        len(pairs) >= 6
        and all(p[0].lower() in _WORDS for p in pairs)
        and not text.lstrip().startswith("|")
    ):
        return _numbered([(_WORDS[name.lower()], int(i), _unquoted(x)) for name, i, x in pairs])
    rows = grid.cells(re.sub(r"^\s*#", "", text))
    for k, row in enumerate(rows[:3]):  # a caption may stand above the heads
        if _heading(row):
            return _below(_with_units(row), rows[k + 1 :])
    return rows, [], ()


def _below(heads: list[str], rows: grid.Cells) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    """The rows below the heads; one of units goes to the heads."""
    units = [_UNIT.fullmatch(cell) for cell in rows[0]] if rows else []
    last = len(heads) - len(units)  # a spreadsheet's last cell may be empty
    if last not in (0, 1) or not all(units) or not any(m and m[1] for m in units):
        return rows, heads, ()
    units += [None] * last
    heads = [f"{h} ({m[1]})" if m and m[1] else h for h, m in zip(heads, units, strict=True)]
    return rows[1:], heads, ()


def _unquoted(text: str) -> str:
    return text.strip().strip("'\"")


def _with_units(heads: list[str]) -> list[str]:
    """The heads with a unit that stands apart, as in ``a (mm)``, joined to its own."""
    found: list[str] = []
    for head in heads:
        if found and re.fullmatch(r"[(\[].*[)\]]", head):
            found[-1] += f" {head}"
        else:
            found.append(head)
    return found


def _unboxed(text: str) -> str:
    """The first table drawn with lines, as robotics toolboxes print it, with plain bars."""
    box = _BOX.search(text)
    if not box:
        return text
    rows = [line for line in box[0].splitlines() if "│" in line]
    return "\n".join(rows).replace("│", "|").replace("⍺", "α").replace("ⱼ", "")


def _records(text: str) -> tuple[grid.Cells, list[str], tuple[str, ...]] | None:
    """A dictionary for each row, {'a': 0, 'alpha': pi/2, ...} or dict(a=0, ...)."""
    found = []
    for braced, called in _RECORDS.findall(text):
        pairs = re.findall(r"['\"]?([A-Za-zαθ]+)['\"]?\s*[:=]\s*([^,\[]+)", braced or called)
        row = {_head(name): _unquoted(x) for name, x in pairs}
        if len(row.keys() & set(ENTRIES)) >= 3:
            found.append(row)
    if len(found) < 2:
        return None
    cells = [
        [row.get(e, f"q_{i}" if e == "theta" else "0") for e in ENTRIES]
        for i, row in enumerate(found, 1)
    ]
    return cells, list(ENTRIES), ()


def _links(links: list[tuple[str, str]]) -> tuple[grid.Cells, list[str], tuple[str, ...]]:
    """Link('d', 0.3, 'a', 0, 'alpha', pi/2), Link([theta d a alpha sigma]) and RevoluteDH(d=0.3,
    alpha=pi/2).
    """
    rows = []
    for i, (kind, body) in enumerate(links, 1):
        if body.strip().startswith("["):
            entries = grid.cells(body.partition("]")[0] + "]")[0]
            slides = len(entries) > 4 and formula.number(entries[4]) == 1
            row = dict(zip(("theta", "d", "a", "alpha", "sigma", "offset"), entries, strict=False))
        else:
            found = re.findall(r"['\"]?\b(a|alpha|d|theta|offset)['\"]?\s*[,=]\s*([^,]+)", body)
            row = {k: x.strip() for k, x in found}
            slides = (
                "prismatic" in (kind + body).lower()
                or ("theta" in row and "d" not in row)
                or re.search(r"sigma['\"]?\s*[,=]\s*1", body) is not None
            )
        row = dict.fromkeys((*ENTRIES, "offset"), "0") | row
        moves = "d" if slides else "theta"
        still = row[moves] if formula.number(row[moves]) else row["offset"]
        row[moves] = f"q_{i} + ({still})"
        rows.append([row[k] for k in ENTRIES])
    return rows, list(ENTRIES), (say("taken: links"),)


# Heads, columns, rows


def _simple(name: str) -> str:
    return re.sub(r"[_{}\s*'^\\]", "", name).lower()


def _head(cell: str) -> str | None:
    word = formula.plain(re.sub(r"-\s*1", "", cell)).replace("*", "")
    word = re.sub(r"\(.*?\)|\[.*?(?:\]|$)|\bin\b.*|[,/].*|_(?:mm|cm|deg|rad)$", "", word)
    word = re.sub(r"[\s_{}$\\^'\"().]", "", word).lower()
    return _WORDS.get(word) or _WORDS.get(re.sub(r"(?:i|j|k|n)$", "", word))


def _heading(row: list) -> bool:
    return len({_head(str(cell)) for cell in row} & set(ENTRIES)) >= 3


def _from_heads(heads: list[str]) -> tuple[str | None, str | None, bool]:
    text = " ".join(heads)
    unit = next((u for u in ("mm", "cm") if re.search(rf"[(\[ /_]{u}\b", text)), None)
    for own in ("m", "in"):
        unit = unit or (own if re.search(rf"[(\[]\s*{own}\s*(?:[)\]]|$)|/{own}\b", text) else None)
    radians = "rad" if re.search(r"(?:\b|_)rad", text) else None
    angle = "deg" if re.search(r"deg|°", text, re.I) else radians
    return unit, angle, bool(re.search(r"-\s*1", text))


def _without_index(cells: grid.Cells, heads: list[str]) -> tuple[grid.Cells, list[str]]:
    """The cells without the column that numbers the rows. Where they are not numbered and one
    short, the first head goes alone: nobody typed its column, or it is half of ``Joint type``.
    """
    words = [_head(h) for h in heads]
    first = [formula.plain(row[0]) for row in cells]
    counted = all(
        re.fullmatch(rf"(?:link|joint|l|j|i=)?\s*_?{i}\.?", x, re.I) for i, x in enumerate(first, 1)
    )
    from_zero = list(map(formula.number, first)) == list(range(len(cells)))  # as pandas does
    counted = counted or from_zero
    short = all(len(row) == len(heads) - 1 for row in cells) and words[0] not in ENTRIES
    if short and not counted:
        return cells, heads[1:]
    if "i" in words:
        at = words.index("i")
        *cells, heads = [row[:at] + row[at + 1 :] for row in (*cells, heads)]
        return cells, heads
    if all(len(row) > 4 for row in cells) and counted:
        return [row[1:] for row in cells], heads[1:] if len(heads) > 4 else heads
    return cells, heads


def _orders(cells: grid.Cells, heads: list[str], columns: str | Iterable[str] | None):
    """The orders of the columns that are possible, and whether it was said."""
    if columns is not None:
        order = tuple(_head(c) for c in _words(columns))
        if sorted(map(str, order)) != sorted(ENTRIES):
            raise ArmError(say("no columns", given=shown(columns)))
        _wide(cells)
        return [order], True
    words = [_head(h) for h in heads]
    if set(words) >= set(ENTRIES) and all(0 <= len(heads) - len(row) <= 1 for row in cells):
        offsets = [i for i, head in enumerate(heads) if "offset" in head.lower()]
        if words.count("d") > 1:
            words = ["" if i in offsets else word for i, word in enumerate(words)]
        keep = [words.index(e) for e in ENTRIES]
        added = next((i for i in offsets if i not in keep), None)
        for k, row in enumerate(cells):
            still = row[added] if added is not None and added < len(row) else "0"
            kept = [row[i] if i < len(row) else "0" for i in keep]
            none = formula.number(still.strip("-–— ") or "0") == 0
            cells[k] = kept if none else _offset(k + 1, kept, still)
        return [ENTRIES], True
    _wide(cells)
    usual = [*KNOWN_ORDERS, *(o for o in permutations(ENTRIES) if o not in KNOWN_ORDERS)]
    fits = [order for order in usual if _possible(cells, order, looks=True)]
    fits = fits or [order for order in usual if _possible(cells, order, looks=False)]
    fits.sort(key=lambda order: not _turning(cells, order))
    return fits or [KNOWN_ORDERS[0]], False


def _offset(i: int, row: list[str], still: str) -> list[str]:
    """A row whose joint's offset, in a column of its own, is added to what moves."""
    d, theta = (formula.number(row[k] or "0") is None for k in (2, 3))
    at = 2 if d and not theta else 3
    moves = f"q_{i}" if _VARIABLE.fullmatch(formula.plain(row[at])) else row[at] or "0"
    return [*row[:at], f"{moves} + ({still})", *row[at + 1 :]]


def _words(columns: Any) -> list[str]:
    if isinstance(columns, str):
        return re.split(r"[\s,;|]+", columns.strip())
    return [str(c) for c in columns] if isinstance(columns, Iterable) else []


def _wide(cells: grid.Cells) -> None:
    widths = sorted({len(row) for row in cells})
    told = ", ".join(map(str, widths))
    if len(widths) > 1:
        row, count = next((i, len(row)) for i, row in enumerate(cells, 1) if len(row) != 4)
        raise ArmError(say("row widths", widths=told, row=row, count=count))
    if widths != [4]:
        raise ArmError(say("row width", widths=told))


def _possible(cells: grid.Cells, order: tuple[str, ...], looks: bool) -> bool:
    """Whether the variables stand in theta (or d), and, where `looks` count, no length or angle
    looks like the other; those of an arm with skew axes do.
    """
    at = {name: [row[order.index(name)] for row in cells] for name in ENTRIES}
    if any(
        _is_variable(x) or re.search(r"\bd_?\d", x) for name in ("a", "alpha") for x in at[name]
    ):
        return False
    angular = any(re.search(r"pi|deg|°|π", x) for name in ("a", "d") for x in at[name])
    if not looks:
        return not angular
    alphas = [formula.number(x) for x in at["alpha"]]
    right = all(x is None or _angle_like(x) for x in alphas)
    lengths = [formula.number(x) for name in ("a", "d") for x in at[name]]
    spread = not all(x is None or (x and _angle_like(x)) for x in lengths) or not any(lengths)
    return not angular and right and spread


def _turning(cells: grid.Cells, order: tuple[str, ...]) -> bool:
    """Whether no fewer joints would turn than slide, as in most arms."""
    turns, slides = (
        sum(_is_variable(row[order.index(c)]) for row in cells) for c in ("theta", "d")
    )
    return turns >= slides


@lru_cache(formula.KEPT)
def _is_variable(text: str) -> bool:
    plain = formula.plain(text)
    if _VARIABLE.fullmatch(plain.strip()):
        return True
    try:
        names = formula.symbols(formula.parse(plain.rstrip("*")))
    except ArmError:
        return False
    return any(_JOINT.fullmatch(n) for n in names)


def _angle_like(x: float) -> bool:
    in_radians = (
        abs(x) <= 2 * math.pi + 0.01 and abs(x / (math.pi / 12) - round(x / (math.pi / 12))) < 0.02
    )
    return in_radians or (x % 15 == 0 and abs(x) <= 360)


def _row(i: int, entries: Mapping[str, str], known: Mapping[str, float]) -> TypedRow:
    parsed, free = {}, {}
    for name in ENTRIES:
        text = formula.plain(entries[name])
        if name in ("theta", "d") and _VARIABLE.fullmatch(text) and _simple(text) not in known:
            text = f"q_{i}"
        tree = formula.parse(text.rstrip("*") or "0", f"{name} in row {i}")
        parsed[name] = tree
        free[name] = sorted(n for n in formula.symbols(tree) if _simple(n) not in known)
    mover = _mover(free)
    stray = [
        n for name in ENTRIES for n in free[name] if name != mover or n != _joint_of(free[mover])
    ]
    if stray:
        key = "row unit" if stray[0] in _UNITS else "row symbol"
        raise ArmError(say(key, row=i, name=stray[0]))
    numbers, backwards = {}, False
    radians = frozenset(
        n for n in ENTRIES if re.search(r"\b(?:pi|deg|rad)\b", formula.plain(entries[n]))
    )
    for name in ENTRIES:
        numbers[name] = formula.value(parsed[name], lambda n: known.get(_simple(n), 0.0))
        if name == mover:
            there = formula.value(parsed[name], lambda n: known.get(_simple(n), 1.0))
            rate = there - numbers[name]
            if min(abs(abs(rate) - slope) for slope in (1, math.pi / 180)) > 1e-6:
                raise ArmError(say("row slope", row=i, name=name, rate=size(rate)))
            backwards = rate < 0
    kinds: dict[str | None, str] = {"theta": "R", "d": "P", None: "?"}
    kind = kinds[mover]
    return TypedRow(kind, numbers, {n: entries[n].strip() for n in ENTRIES}, backwards, radians)


def _mover(free: Mapping[str, list[str]]) -> str | None:
    """Which entry holds the joint's variable."""
    if free["theta"]:
        return "theta"
    return "d" if free["d"] else None


def _joint_of(names: list[str]) -> str:
    """The joint's variable among the symbols of an entry: the one called like a joint."""
    return next((n for n in names if re.match(r"q|th|t_?\d|x_?\d|phi", n)), names[0])


# 4 x 4 matrices


def _matrices(cells: grid.Cells) -> list | None:
    """The rows of cells as matrices A_i, where they are such."""
    if any(isinstance(x, list | tuple) for row in cells for x in row):
        if {len(x) if isinstance(x, list | tuple) else 0 for A in cells for x in (A, *A)} != {4}:
            raise ArmError(say("no rows", given=shown(cells)))
        return [[[_text(x) for x in r] for r in A] for A in cells]
    square = len(cells) >= 8 and len(cells) % 4 == 0 and {len(row) for row in cells} == {4}
    if square and all([*map(formula.number, row)] == [0, 0, 0, 1] for row in cells[3::4]):
        return [cells[k : k + 4] for k in range(0, len(cells), 4)]
    return None


def _from_matrix(i: int, A: list, known: Mapping[str, float]) -> TypedRow:
    trees = [[formula.parse(formula.plain(x), f"A_{i}") for x in row] for row in A]
    names = {n for row in trees for t in row for n in formula.symbols(t) if _simple(n) not in known}

    def at(x: float) -> list[list[float]]:
        look = {n: _short(n, x) for n in names}
        return [
            [formula.value(t, lambda n: look.get(n, known.get(_simple(n)))) for t in row]
            for row in trees
        ]

    zero, one = at(0.0), at(0.5)
    c, s = zero[0][0], zero[1][0]
    numbers = {
        "a": zero[0][3] * c + zero[1][3] * s,
        "alpha": math.atan2(zero[2][1], zero[2][2]),
        "d": zero[2][3],
        "theta": math.atan2(s, c),
    }
    slid = one[2][3] - zero[2][3]
    turned = math.sin(math.atan2(one[1][0], one[0][0]) - numbers["theta"])
    slides = abs(slid) > 1e-9
    kind = "P" if slides else "R" if names else "?"
    backwards = (slid if slides else turned) < 0
    return TypedRow(kind, numbers, {n: size(x, 6) for n, x in numbers.items()}, backwards)


def _short(name: str, x: float) -> float:
    """A joint's value, or its cosine or sine where the name is c_1 or s1."""
    match = re.fullmatch(r"([csCS])(?:theta|th|q)?_?\{?\d+\}?", name)
    if not match:
        return x
    return math.cos(x) if match[1] in "cC" else math.sin(x)
