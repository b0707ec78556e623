"""Check and convert arguments.

Each function returns its argument in the form that the caller computes with, or raises an ArmError
that says what was given and what was expected. The parameter `name` is what a message calls the
argument, and `expected` completes the message's "expected ...".
"""

import math
import sys
import warnings
from collections.abc import Iterable, Mapping
from itertools import permutations
from typing import Any

import numpy as np
from numpy.typing import NDArray

Size = int | None
Array = NDArray[np.float64]


LARGEST = 1e100  # the product of three such numbers is a finite float


class ArmError(ValueError):
    """An arm, or an argument given to it, is wrong."""


def require_type(value: object, kind: type, name: str) -> None:
    """Raise ArmError unless `value` is an instance of `kind`."""
    if not isinstance(value, kind):
        article = "an" if kind.__name__[0] in "AEIO" else "a"
        raise ArmError(f"{name} is {shorten(value)}; expected {article} {kind.__name__}")


def require_callable(value: object, name: str, expected: str) -> None:
    """Raise ArmError unless `value` can be called."""
    if not callable(value):
        raise ArmError(f"{name} is {shorten(value)}; expected {expected}")


def finite_array(
    value: Any, name: str, expected: str, shape: tuple[Size, ...], many: bool = False
) -> Array:
    """Convert `value` to an array of finite numbers and check its shape.

    Args:
        value: Numbers, nested sequences of numbers, or an array.
        name: What messages call the argument.
        expected: What messages say was expected.
        shape: Required shape; None stands for any size.
        many: Whether further axes may come before those of `shape`.

    Returns:
        The array, of shape `shape`, or (..., *shape) with `many`.

    Raises:
        ArmError: The shape is wrong, or a number is not finite or larger than `LARGEST`.
    """
    array = float_array(value, name, expected)
    last = array.shape[max(0, array.ndim - len(shape)) :] if many else array.shape
    fits = len(last) == len(shape) and all(n in (None, m) for n, m in zip(shape, last, strict=True))
    if not fits:
        actual = f"has shape {array.shape}" if array.shape else f"is {shorten(value)}"
        raise ArmError(f"{name} {actual}; expected {expected}")
    if not (np.abs(array) <= LARGEST).all():
        content = f"a number beyond {LARGEST:g}" if np.isfinite(array).all() else "NaN or infinity"
        raise ArmError(f"{name} holds {content}; expected {expected}")
    return array


def float_array(value: Any, name: str, expected: str) -> Array:
    """Convert `value` to an array of real numbers of any shape.

    Raises:
        ArmError: `value` holds text, None, complex numbers or masked entries, or is ragged.
    """
    try:
        array = np.asanyarray(value)
        kind, has_gaps = array.dtype.kind, np.ma.is_masked(array)
        if kind == "O":
            has_gaps = has_gaps or any(x is None for x in array.ravel())
        if kind in "iufO" and not has_gaps:
            return np.asarray(array, dtype=float)
    except (TypeError, ValueError, OverflowError):
        pass
    raise ArmError(f"{name} is {shorten(value)}; expected {expected}")


def finite_number(
    value: Any,
    name: str,
    expected: str = "a finite number",
    *,
    above: float = -math.inf,
    least: float = -math.inf,
) -> float:
    """Convert `value` to a finite float that is greater than `above` and at least `least`."""
    array = float_array(value, name, expected)
    if array.shape or not (np.isfinite(array) and array > above and array >= least):
        raise ArmError(f"{name} is {shorten(value)}; expected {expected}")
    return float(array)


def numbers_by_name(values: Any, name: str) -> dict[str, float]:
    """Convert a mapping from names to numbers to a dict of finite floats."""
    require_type(values, Mapping, name)
    for key in values:
        require_type(key, str, f"a name in {name}")
    return {key: finite_number(x, f"{name}[{key!r}]") for key, x in values.items()}


def whole_number(value: Any, name: str, least: int = 0) -> int:
    """Convert `value` to an int that is at least `least`.

    Booleans are refused.
    """
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
        raise ArmError(f"{name} is {shorten(value)}; expected a whole number of {least} or more")
    return int(value)


def require_choice(value: object, name: str, choices: Iterable[str]) -> str:
    """Return `value` if it is one of the choices.

    Raises ArmError otherwise.
    """
    choices = tuple(choices)
    if not isinstance(value, str) or value not in choices:
        raise ArmError(f"{name} is {shorten(value)}; expected one of {', '.join(choices)}")
    return value


def tuple_of_items(value: Any, name: str, expected: str) -> tuple:
    """Return the items of an iterable as a tuple.

    Raises ArmError for text and for anything that is no iterable.
    """
    if isinstance(value, str | bytes) or not isinstance(value, Iterable):
        raise ArmError(f"{name} are {shorten(value)}; expected {expected}")
    return tuple(value)


def parse_plane(plane: object, name: str = "plane") -> tuple[int, int]:
    """Return the indices 0 to 2 of a plane's two axes, as (1, 2) for "yz"."""
    planes = {a + b: (i, j) for (i, a), (j, b) in permutations(enumerate("xyz"), 2)}
    if not isinstance(plane, str) or plane not in planes:
        raise ArmError(
            f"{name} is {shorten(plane)}; expected two different letters of x, y, z, such as 'yz'"
        )
    return planes[plane]


def broadcast_shape(name: str, *shapes: tuple[int, ...]) -> tuple[int, ...]:
    """Return the common shape to which batches of the given shapes broadcast."""
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        actual = " and ".join(map(str, shapes))
        raise ArmError(f"{name} have shapes {actual}; expected the same or one of one") from None


def warn_caller(message: str) -> None:
    """Issue a warning that points at the user's line, outside this package."""
    depth, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__name__", "").partition(".")[0] == "helpers":
        depth, frame = depth + 1, frame.f_back
    warnings.warn(message, stacklevel=depth)


def shorten(value: object) -> str:
    """Return the repr of `value`, cut to 80 characters, for a message."""
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:77]}..."
