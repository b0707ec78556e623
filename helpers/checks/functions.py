"""Call a student's function by its own signature, f(q) or f(q_1, q_2, ...)."""

import inspect
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import ArmError

Array = NDArray[Any]


def call_student_function(function: Callable, q: Array, name: str) -> Any:
    """Return the value of a student's function at q.

    Args:
        function: takes q, or its joints one by one.
        q: shape (dof,); the function receives a copy.
        name: name of the function in messages.

    Raises ArmError if the function fails.
    """
    is_separate = _takes_joints_separately(function, len(q))
    calls: list[list] = [] if is_separate else [[np.array(q)]]
    calls += [[*map(float, q)]] if is_separate or len(q) == 1 else []
    failures: list[Exception] = []
    for arguments in calls:
        try:
            return function(*arguments)
        except ArmError:
            raise
        except Exception as error:
            failures.append(error)
    raise ArmError(
        f"{name}: your function failed ({type(failures[0]).__name__}: {failures[0]}); it was called"
        f" with q of {len(q)} values. Wrap it, as in lambda q: f(q, ...)"
    ) from failures[0]


def _takes_joints_separately(function: Callable, dof: int) -> bool:
    """Return whether a function takes the joints as separate arguments."""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return False
    positional = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    needed = sum(p.default is p.empty and p.kind in positional for p in parameters)
    return needed == dof > 1 or (not needed and any(p.kind is p.VAR_POSITIONAL for p in parameters))
