"""What a student holds as plain data for the judge: arrays, SymPy matrices, pandas tables, lists.

A text stays as it is: only the judge reads texts, and nothing is ever evaluated.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import shown

Data = Any  # str, or nested lists of float, str, None (no finite number), {"tree"} and {"odd"}
_FUNCTIONS = ("sin", "cos", "tan", "asin", "acos", "atan")


def array_data(mine: Any) -> Data:
    """Numbers, formulas as text and SymPy expressions in nested lists; a mapping is its values."""
    if isinstance(mine, Mapping) and mine:
        return [array_data(value) for value in mine.values()]
    if isinstance(mine, np.ndarray) and mine.dtype.kind in "iuf" and not np.ma.isMA(mine):
        return _finite(mine)
    if hasattr(mine, "tolist"):
        mine = mine.tolist()
    elif hasattr(mine, "to_numpy"):
        return array_data(mine.to_numpy())
    if isinstance(mine, list | tuple):
        return [array_data(item) for item in mine]
    return _entry(mine)


def _finite(array: NDArray[Any]) -> list | float | None:
    values = array.astype(float)
    if np.isfinite(values).all():
        return values.tolist()
    return array_data(values.astype(object))


def _entry(x: Any) -> Data:
    """A number as a float, None where it is not finite; {"odd": ...} for what is no number."""
    if isinstance(x, str):
        return x
    if isinstance(x, bool | np.bool_ | complex | None):
        return {"odd": shown(x)}
    try:
        if hasattr(x, "free_symbols"):
            known = x.is_Float or x.is_Integer or x.is_infinite
            return _number(x) if known else {"tree": _tree(x)}
        return _number(x) if isinstance(x, int | float | np.number) else {"odd": shown(x)}
    except (TypeError, ValueError, AttributeError, RecursionError):
        return {"odd": shown(x)}


def _number(x: Any) -> float | None:
    try:
        value = float(x)
    except OverflowError:  # a whole number of more than 308 digits
        return None
    return value if math.isfinite(value) else None


def _tree(e: Any) -> list:
    """A SymPy expression as a formula's tree; sums and products are halved, so that none is deep.

    Raises TypeError where it holds what no formula does.
    """
    from sympy.core.function import AppliedUndef

    if e.is_Symbol or isinstance(e, AppliedUndef):
        return ["name", str(e)]
    if e.is_number and not e.args:
        return ["num", _real(e)]
    if e.is_Add or e.is_Mul:
        return _halved("+" if e.is_Add else "*", [_tree(part) for part in e.args])
    if e.is_Pow:
        return ["^", *map(_tree, e.args)]
    if e.func.__name__ in _FUNCTIONS:
        return ["call", e.func.__name__, _tree(e.args[0])]
    if e.func.__name__ == "exp":
        return ["^", ["num", math.e], _tree(e.args[0])]
    return ["num", _real(e)]


def _real(e: Any) -> float:
    value = float(e)
    if not math.isfinite(value):
        raise TypeError(f"{e} is no finite number")
    return value


def _halved(sign: str, parts: list[list]) -> list:
    if len(parts) == 1:
        return parts[0]
    middle = len(parts) // 2
    return [sign, _halved(sign, parts[:middle]), _halved(sign, parts[middle:])]
