"""Read a Denavit-Hartenberg table from text, lists, arrays or matrices."""

import math
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from helpers.checks.engine import ask_judge
from helpers.inputs import ArmError, numbers_by_name, require_choice, shorten, tuple_of_items
from helpers.rows import RIGHT_ANGLES, Joint, Row


class TableReading(NamedTuple):
    """A table as it was read.

    Attributes:
        rows: The rows of the arm.
        reading: How the table was read, in words.
        has_guessed_order: Whether the order of the columns is a guess from numbers alone.
        warnings: What the reader must know, a sentence each.
    """

    rows: tuple[Row, ...]
    reading: str
    has_guessed_order: bool
    warnings: list[str]


def read_table(
    text: str,
    *,
    columns: Any,
    lengths: Any,
    angles: Any,
    convention: Any,
    values: Mapping[str, float] | None,
) -> TableReading:
    """Read a typed table as the rows of an arm.

    Multiples of a right angle become formulas, such as "pi/2". Raises ArmError if `text` is not a
    table, or holds a symbol without a value.
    """
    options: dict[str, Any] = check_reading_options(columns, lengths, angles, convention)
    options["values"] = [list(pair) for pair in numbers_by_name(values or {}, "values").items()]
    answer = ask_judge("rows", mine=text, options=options)
    rows = tuple(
        Row(
            r["a"],
            _format_right_angle(r["alpha"]),
            r["d"],
            _format_right_angle(r["theta"]),
            Joint(r["kind"]),
        )
        for r in answer["rows"]
    )
    return TableReading(rows, answer["reading"], answer["guessed"], answer["warnings"])


def _format_right_angle(angle: float) -> float | str:
    """Return a multiple of a right angle (to 1e-4 rad) as a formula, other angles unchanged."""
    turns = round(angle / (math.pi / 2))
    if abs(angle - turns * math.pi / 2) > 1e-4:
        return angle
    return RIGHT_ANGLES.get(turns, f"{turns} * pi / 2")


def check_reading_options(
    columns: Any, lengths: Any, angles: Any, convention: Any
) -> dict[str, str]:
    """Check the options for reading a table and return those that are not None."""
    options = {}
    if columns is not None:
        wanted = "a, alpha, d and theta in your order"
        names = (
            [columns] if isinstance(columns, str) else tuple_of_items(columns, "columns", wanted)
        )
        options["columns"] = " ".join(map(str, names))
    if lengths is not None:
        options["lengths"] = require_choice(lengths, "lengths", ("m", "cm", "mm"))
    if angles is not None:
        options["angles"] = require_choice(angles, "angles", ("rad", "deg"))
    if convention is not None:
        known = ("standard", "craig", "modified")
        options["convention"] = require_choice(str(convention).lower(), "convention", known)
        options["convention"] = options["convention"].replace("modified", "craig")
    return options


def format_table(source: Any) -> str:
    """Print a table as text that the judge reads like pasted text.

    Args:
        source: text, a mapping, rows of mappings, an array, rows in lists, or 4 x 4 matrices.

    Raises ArmError if `source` is not a table.
    """
    if isinstance(source, str):
        return source
    if isinstance(source, Mapping):
        return _format_mapping({str(name): _to_list(x) for name, x in source.items()})
    if hasattr(source, "columns") and hasattr(source, "to_numpy"):
        return _format_markdown(source.columns, source.to_numpy().tolist())
    table = _to_list(source)
    if not isinstance(table, list | tuple):
        raise ArmError(f"the table is {shorten(source)}; expected rows or text")
    if table and all(isinstance(row, Mapping) for row in table):
        headers = list(dict.fromkeys(name for row in table for name in row))
        return _format_markdown(headers, [[row.get(name, 0) for name in headers] for row in table])
    if table and all(isinstance(row, str) for row in table):
        return "\n".join(table)
    rows = list(map(_to_list, table))
    if rows and all(_is_matrix(row) for row in rows):
        rows = [_to_list(line) for matrix in rows for line in matrix]
    if not rows or not all(map(_is_row, rows)):
        raise ArmError(f"the table is {shorten(source)}; expected rows of four entries")
    return f"[{', '.join(map(_format_row, rows))}]"


def _to_list(x: Any) -> Any:
    return x.tolist() if hasattr(x, "tolist") else x


def _is_row(x: Any) -> bool:
    return isinstance(x, list | tuple) and bool(x) and not any(map(_is_list, x))


def _is_list(x: Any) -> bool:
    return isinstance(x, list | tuple | Mapping)


def _is_matrix(x: Any) -> bool:
    return isinstance(x, list | tuple) and len(x) == 4 and all(_is_row(_to_list(row)) for row in x)


def _format_mapping(table: Mapping[str, Any]) -> str:
    """Print a mapping of column headers to lists, or of entry names such as a_1 to numbers."""
    lists = list(table.values())
    if not table or not (all(map(_is_list, lists)) or not any(map(_is_list, lists))):
        raise ArmError(
            f"the table is {shorten(table)};"
            " expected lists such as 'a': [...], or entries such as 'd1': 0.3"
        )
    if not _is_list(lists[0]):
        return "{" + ", ".join(f"'{name}': {_format_cell(x)}" for name, x in table.items()) + "}"
    counts = sorted({len(column) for column in lists})
    if len(counts) > 1:
        sizes = ", ".join(map(str, counts))
        raise ArmError(f"the table's lists have {sizes} entries; expected as many in each")
    if counts == [0]:
        raise ArmError(f"the table is {shorten(table)}; expected rows of four entries")
    return _format_markdown(table, zip(*lists, strict=True))


def _format_markdown(headers: Iterable, rows: Iterable[Iterable]) -> str:
    """Print rows as a Markdown table below their column headers."""
    headers = list(headers)
    lines = [map(str, headers), ["---"] * len(headers), *(map(_format_cell, row) for row in rows)]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _format_row(row: Iterable) -> str:
    return f"[{', '.join(map(_format_cell, row))}]"


def _format_cell(x: Any) -> str:
    if x is None:
        return "*"
    if isinstance(x, float):
        return repr(float(x)).removesuffix(".0")
    return str(x) or "0"
