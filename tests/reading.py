"""Ask the judge's reader, under Node.js, how it reads a text."""

from typing import Any

from helpers.checks.tables import format_table
from helpers.inputs import ArmError
from tests.node import ask_node


def ask_reader(job: str, **question: Any) -> Any:
    """Return the answer of a job in judge_reading.mjs.

    Raises:
        ArmError: The reader refused the text.
    """
    answer = ask_node("judge_reading.mjs", {"job": job, **question})
    if "refused" in answer:
        raise ArmError(answer["refused"])
    return answer["answer"]


def read_formula(text: str, what: str = "the formula", **values: float) -> dict:
    """Return the names in a formula and its value for these values of its symbols."""
    return ask_reader("formula", text=text, what=what, known=values)


def read_tables(typed_table: Any, *, values=(), kinds=(), **options: str) -> list[dict]:
    """Return the readings of a table, the likeliest first.

    Args:
        typed_table: What the student typed: a text, rows of numbers, a data frame.
        values: The numbers of its symbols.
        kinds: The kind of each row's joint, where the question says it.
        options: What the student declares, such as ``angles="deg"``.
    """
    pairs = [list(pair) for pair in dict(values).items()]
    text = format_table(typed_table)
    return ask_reader("tables", text=text, options=options, values=pairs, kinds=kinds)


def read_matrix(text: str, rows: int, columns: int) -> list[float]:
    """Return the entries of a pasted matrix of this size, row by row."""
    return ask_reader("matrix", text=text, rows=rows, columns=columns)


def list_rows(table: dict) -> list[tuple]:
    """Return kind, a, alpha, d and theta of each row of a reading."""
    names = ("kind", "a", "alpha", "d", "theta")
    return [tuple(row[name] for name in names) for row in table["converted"]["rows"]]
