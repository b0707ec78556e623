"""A student's function, called as it asks to be: f(q) or f(q_1, q_2, ...)."""

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.checks.engine import say
from helpers.inputs import ArmError

Array = NDArray[Any]


def value_at(function: Callable, q: Array, what: str) -> Any:
    """What a function gives at q, shape (dof,); it gets a copy.

    Raises ArmError, which calls the function `what`, where it fails.
    """
    each = _wants_each(function, len(q))
    calls: list[list] = [] if each else [[np.array(q)]]
    calls += [[*map(float, q)]] if each or len(q) == 1 else []
    failed: list[Exception] = []
    for given in calls:
        try:
            return function(*given)
        except ArmError:
            raise
        except Exception as error:
            failed.append(error)
    told = f"{type(failed[0]).__name__}: {failed[0]}"
    raise ArmError(say("function failed", what=what, error=told, dof=len(q))) from failed[0]


def _wants_each(function: Callable, dof: int) -> bool:
    """Whether a function asks for the joints one by one."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return False
    by_place = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    needed = sum(p.default is p.empty and p.kind in by_place for p in parameters)
    return needed == dof > 1 or (not needed and any(p.kind is p.VAR_POSITIONAL for p in parameters))
