"""A Denavit-Hartenberg table as people hold it, put before the judge's reader."""

import math
from collections.abc import Iterable, Mapping
from typing import Any

from helpers.checks.engine import asked, say
from helpers.inputs import ArmError, listed, named, one_of, shown
from helpers.rows import Joint, Row

_FORMULAS: dict[int, float | str] = {-2: "-pi", -1: "-pi/2", 0: 0, 1: "pi/2", 2: "pi"}


def rows_of(
    source: Any,
    *,
    columns: Any,
    lengths: Any,
    angles: Any,
    convention: Any,
    values: Mapping[str, float] | None,
) -> tuple[tuple[Row, ...], list[str]]:
    """The rows of an arm, right angles as formulas, and how the table was taken.

    Raises ArmError for what is no table, or holds a symbol without a value.
    """
    options: dict[str, Any] = reading_options(columns, lengths, angles, convention)
    options["values"] = [list(pair) for pair in named(values or {}, "values").items()]
    found = asked("rows", mine=table_text(source), options=options)
    rows = tuple(
        Row(r["a"], _right_angle(r["alpha"]), r["d"], _right_angle(r["theta"]), Joint(r["kind"]))
        for r in found["rows"]
    )
    return rows, found["said"]


def _right_angle(angle: float) -> float | str:
    """A multiple of a right angle, to four decimals, as a formula."""
    turns = round(angle / (math.pi / 2))
    if abs(angle - turns * math.pi / 2) > 1e-4:
        return angle
    return _FORMULAS.get(turns, f"{turns} * pi / 2")


def reading_options(columns: Any, lengths: Any, angles: Any, convention: Any) -> dict[str, str]:
    """How a table is to be read, where that is said; raises ArmError for what is not known."""
    found = {}
    if columns is not None:
        wanted = "a, alpha, d and theta in your order"
        names = [columns] if isinstance(columns, str) else listed(columns, "columns", wanted)
        found["columns"] = " ".join(map(str, names))
    if lengths is not None:
        found["lengths"] = one_of(lengths, "lengths", ("m", "cm", "mm"))
    if angles is not None:
        found["angles"] = one_of(angles, "angles", ("rad", "deg"))
    if convention is not None:
        known = ("standard", "craig", "modified")
        found["convention"] = one_of(str(convention).lower(), "convention", known)
        found["convention"] = found["convention"].replace("modified", "craig")
    return found


def table_text(source: Any) -> str:
    """A table as its print-out, which the judge reads as it reads a paste: a mapping, rows of
    mappings, an array or rows in lists, 4 x 4 matrices.

    Raises ArmError for what is no table.
    """
    if isinstance(source, str):
        return source
    if isinstance(source, Mapping):
        return _of_mapping({str(name): _listed(x) for name, x in source.items()})
    if hasattr(source, "columns") and hasattr(source, "to_numpy"):
        return _below(source.columns, source.to_numpy().tolist())
    held = _listed(source)
    if not isinstance(held, list | tuple):
        raise ArmError(say("no table", given=shown(source)))
    if held and all(isinstance(row, Mapping) for row in held):
        heads = list(dict.fromkeys(name for row in held for name in row))
        return _below(heads, [[row.get(name, 0) for name in heads] for row in held])
    if held and all(isinstance(row, str) for row in held):
        return "\n".join(held)
    rows = list(map(_listed, held))
    if rows and all(_is_matrix(row) for row in rows):
        rows = [_listed(line) for matrix in rows for line in matrix]
    if not rows or not all(map(_is_row, rows)):
        raise ArmError(say("no rows", given=shown(source)))
    return f"[{', '.join(map(_line, rows))}]"


def _listed(x: Any) -> Any:
    return x.tolist() if hasattr(x, "tolist") else x


def _is_row(x: Any) -> bool:
    return isinstance(x, list | tuple) and bool(x) and not any(map(_is_list, x))


def _is_list(x: Any) -> bool:
    return isinstance(x, list | tuple | Mapping)


def _is_matrix(x: Any) -> bool:
    return isinstance(x, list | tuple) and len(x) == 4 and all(_is_row(_listed(row)) for row in x)


def _of_mapping(held: Mapping[str, Any]) -> str:
    """Parallel lists, or entries by column and number."""
    lists = list(held.values())
    if not held or not (all(map(_is_list, lists)) or not any(map(_is_list, lists))):
        raise ArmError(say("no entries", given=shown(held)))
    if not _is_list(lists[0]):
        return "{" + ", ".join(f"'{name}': {_cell(x)}" for name, x in held.items()) + "}"
    counts = sorted({len(column) for column in lists})
    if len(counts) > 1:
        raise ArmError(say("uneven lists", counts=", ".join(map(str, counts))))
    if counts == [0]:
        raise ArmError(say("no rows", given=shown(held)))
    return _below(held, zip(*lists, strict=True))


def _below(heads: Iterable, rows: Iterable[Iterable]) -> str:
    """Rows below their heads, as Markdown has them."""
    heads = list(heads)
    lines = [map(str, heads), ["---"] * len(heads), *(map(_cell, row) for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _line(row: Iterable) -> str:
    return f"[{', '.join(map(_cell, row))}]"


def _cell(x: Any) -> str:
    if x is None:
        return "*"
    if isinstance(x, float):
        return repr(float(x)).removesuffix(".0")
    return str(x) or "0"
