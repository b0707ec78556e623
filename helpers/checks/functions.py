"""A student's function, called as it asks to be: f(q), f(q_1, q_2, ...), f(table, q), f(q, table).

It always gets copies, made anew for each call.
"""

import inspect
import re
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.engine import asked, say
from helpers.checks.report import WRONG, Report
from helpers.inputs import ArmError

Array = NDArray[Any]
Said = tuple[str, ...]
Way = tuple[Callable[[], Any], Said]

_ENTRIES = ("a", "alpha", "d", "theta")
_TABLE = re.compile(r"dh\w*|\w*_dh|\w*table|rows?|\w*params?|parameters|denavit\w*|links?", re.I)
_JOINTS = re.compile(r"q\w*|joints?\w*|th\w*|angles?|config\w*", re.I)


def results(function: Callable, arm: Arm, q: Array, what: str) -> Iterator[tuple[Any, Said]]:
    """What a function gives at q, shape (dof,), and how it was called where that needs saying.

    Several where it takes the arm's table, the columns' order of which is the student's choice: the
    book's comes first. Raises ArmError where it fails in every way.
    """
    failed: Exception | None = None
    given = 0
    for call, said in _ways(function, arm, q):
        try:
            found = call()
        except ArmError:
            raise
        except Exception as error:
            failed = failed or error
        else:
            given += 1
            yield found, said
            if not said:
                return
    if not given:
        told = f"{type(failed).__name__}: {failed}"
        given_too = say("and the table") if said else ""
        words = say("function failed", what=what, error=told, dof=arm.dof, too=given_too)
        raise ArmError(words) from failed


def best(reports: Iterator[Report | None]) -> Report:
    """The first report that is not "wrong", or else the first that one mistake explains altogether,
    or else the first; None is no report.
    """
    held: list[Report] = []
    try:
        for report in filter(None, reports):
            if report.grade != WRONG:
                return report
            held.append(report)
    except ArmError:
        if not held:
            raise
    explained = (r for r in held if r.causes and [f.what for f in r.findings] == ["cause"])
    return next(explained, held[0])


def _ways(function: Callable, arm: Arm, q: Array) -> Iterator[Way]:
    names, starred = _asked(function)
    table = _place_of_table(names, arm)
    if table is not None:
        yield from _with_table(function, arm, q, table)
        return
    each = starred or len(names) == arm.dof
    if not (each and arm.dof > 1):
        yield lambda: function(np.array(q)), ()
    if each:
        yield lambda: function(*map(float, q)), ()
    if len(names) == 2 and arm.dof == 2:
        yield from _with_table(function, arm, q, 0)


def _asked(function: Callable) -> tuple[list[str], bool]:
    """The arguments that a function must be given, and whether it takes any number of them."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return [], False
    by_place = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    names = [p.name for p in parameters if p.default is p.empty and p.kind in by_place]
    return names, not names and any(p.kind is p.VAR_POSITIONAL for p in parameters)


def _place_of_table(names: list[str], arm: Arm) -> int | None:
    """Which of two arguments is the arm's table, or None where none is."""
    if len(names) != 2:
        return None
    tables = [bool(_TABLE.fullmatch(name)) for name in names]
    if any(tables):
        return tables.index(True)
    # Neither is called a table: the first one is, if only the second is called joints.
    second = bool(_JOINTS.fullmatch(names[1])) and not _JOINTS.fullmatch(names[0])
    return 0 if second and arm.dof != 2 else None


def _with_table(function: Callable, arm: Arm, q: Array, place: int) -> Iterator[Way]:
    """With the rows in each usual order of columns, then as dicts; with q as it is, or with a 0 for
    each row that is locked, where the function wants one value for each row.
    """
    whole = np.zeros((*q.shape[:-1], len(arm.rows)))
    whole[..., [i - 1 for i in arm.joints]] = q
    joints = [q] if arm.dof == len(arm.rows) else [q, whole]
    form = "f(q, table)" if place else "f(table, q)"
    for order in (_ENTRIES, *(o for o in _orders() if o != _ENTRIES)):
        said = say("taken: function", form=form, columns=", ".join(order))
        for values in joints:
            yield _call(function, place, _table(arm, order), values), (said,)
    by_row = [dict(zip(_ENTRIES, map(float, row), strict=True)) for row in _table(arm, _ENTRIES)]
    by_column = {name: _table(arm, (name,))[:, 0] for name in _ENTRIES}
    said = say("taken: function keyed", form=form, keys="'a', 'alpha', 'd' and 'theta'")
    for table in (by_row, by_column):
        yield _call(function, place, table, q), (said,)


@cache
def _orders() -> list[tuple[str, ...]]:
    """The orders of a table's columns that people use."""
    return [tuple(order) for order in asked("orders")]


def _call(function: Callable, place: int, table: Any, q: Array) -> Callable[[], Any]:
    given = (np.array(q), table) if place else (table, np.array(q))
    return lambda: function(*given)


def _table(arm: Arm, order: tuple[str, ...]) -> Array:
    """The arm's rows in metres and radians, shape (rows, columns)."""
    entries = np.array([[arm.number(x) for x in row.entries] for row in arm.rows], dtype=float)
    return entries[:, [_ENTRIES.index(name) for name in order]]
