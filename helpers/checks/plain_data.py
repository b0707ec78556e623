"""Convert a student's arrays, SymPy matrices, pandas tables and lists to plain data.

Text stays as it is: only the judge reads text, and nothing is ever evaluated.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import shorten

# str, or nested lists of float, str, None (number not finite), {"tree"}, {"odd"} and {"named"}
Data = Any
_FUNCTIONS = ("sin", "cos", "tan", "asin", "acos", "atan")


def to_plain_data(answer: Any) -> Data:
    """Convert numbers, text and SymPy expressions to nested lists, mappings to named values."""
    if isinstance(answer, Mapping) and answer:
        return {"named": [[str(key), to_plain_data(value)] for key, value in answer.items()]}
    if isinstance(answer, np.ndarray) and answer.dtype.kind in "iuf" and not np.ma.isMA(answer):
        return _convert_array(answer)
    if hasattr(answer, "tolist"):
        answer = answer.tolist()
    elif hasattr(answer, "to_numpy"):
        return to_plain_data(answer.to_numpy())
    if isinstance(answer, list | tuple):
        return [to_plain_data(item) for item in answer]
    return _convert_entry(answer)


def _convert_array(array: NDArray[Any]) -> list | float | None:
    values = array.astype(float)
    if np.isfinite(values).all():
        return values.tolist()
    return to_plain_data(values.astype(object))


def _convert_entry(x: Any) -> Data:
    """Convert a number to a float, or to None if it is not finite.

    Anything else becomes {"odd": its text}.
    """
    if isinstance(x, str):
        return x
    if isinstance(x, bool | np.bool_ | complex | None):
        return {"odd": shorten(x)}
    try:
        if hasattr(x, "free_symbols"):
            known = x.is_Float or x.is_Integer or x.is_infinite
            return _convert_number(x) if known else {"tree": _make_tree(x)}
        return _convert_number(x) if isinstance(x, int | float | np.number) else {"odd": shorten(x)}
    except (TypeError, ValueError, AttributeError, RecursionError):
        return {"odd": shorten(x)}


def _convert_number(x: Any) -> float | None:
    try:
        value = float(x)
    except OverflowError:  # an integer of more than 308 digits
        return None
    return value if math.isfinite(value) else None


def _make_tree(e: Any) -> list:
    """Convert a SymPy expression to the tree of a formula.

    Sums and products are split into halves, which keeps the tree shallow. Raises TypeError for an
    expression that the judge's formulas do not have.
    """
    from sympy.core.function import AppliedUndef

    if e.is_Symbol or isinstance(e, AppliedUndef):
        return ["name", str(e)]
    if e.is_number and not e.args:
        return ["num", _evaluate_real(e)]
    if e.is_Add or e.is_Mul:
        return _split_into_halves("+" if e.is_Add else "*", [_make_tree(part) for part in e.args])
    if e.is_Pow:
        return ["^", *map(_make_tree, e.args)]
    if e.func.__name__ in _FUNCTIONS:
        return ["call", e.func.__name__, _make_tree(e.args[0])]
    if e.func.__name__ == "exp":
        return ["^", ["num", math.e], _make_tree(e.args[0])]
    return ["num", _evaluate_real(e)]


def _evaluate_real(e: Any) -> float:
    value = float(e)
    if not math.isfinite(value):
        raise TypeError(f"{e} is no finite number")
    return value


def _split_into_halves(operator: str, parts: list[list]) -> list:
    if len(parts) == 1:
        return parts[0]
    middle = len(parts) // 2
    return [
        operator,
        _split_into_halves(operator, parts[:middle]),
        _split_into_halves(operator, parts[middle:]),
    ]
