"""Input checked at the door: each function returns what it was given in the form that is computed
with, or raises ArmError, which says what was given and what was expected."""

import math
from collections.abc import Iterable, Mapping
from itertools import permutations
from typing import Any

import numpy as np
from numpy.typing import NDArray

Size = int | None
Array = NDArray[np.float64]


LARGEST = 1e100  # products of three such numbers are finite


class ArmError(ValueError):
    """Something about an arm, or about what it was given, is wrong."""


def must_be(value: object, kind: type, what: str) -> None:
    """Raise ArmError unless `value` is of a kind such as Arm."""
    if not isinstance(value, kind):
        article = "an" if kind.__name__[0] in "AEIO" else "a"
        raise ArmError(f"{what} is {shown(value)}; expected {article} {kind.__name__}")


def must_be_callable(value: object, what: str, wanted: str) -> None:
    """Raise ArmError unless `value` can be called."""
    if not callable(value):
        raise ArmError(f"{what} is {shown(value)}; expected {wanted}")


def numbers(
    value: Any, what: str, wanted: str, shape: tuple[Size, ...], many: bool = False
) -> Array:
    """An array of finite numbers of a shape, None for any size; with `many`, that of its last
    axes."""
    array = floats(value, what, wanted)
    last = array.shape[max(0, array.ndim - len(shape)) :] if many else array.shape
    fits = len(last) == len(shape) and all(n in (None, m) for n, m in zip(shape, last, strict=True))
    if not fits:
        given = f"has shape {array.shape}" if array.shape else f"is {shown(value)}"
        raise ArmError(f"{what} {given}; expected {wanted}")
    if not (np.abs(array) <= LARGEST).all():
        held = f"a number beyond {LARGEST:g}" if np.isfinite(array).all() else "NaN or infinity"
        raise ArmError(f"{what} holds {held}; expected {wanted}")
    return array


def floats(value: Any, what: str, wanted: str) -> Array:
    """An array of real numbers, of any shape; words, None, complex numbers, ragged lists and arrays
    with masked entries are none."""
    try:
        array = np.asanyarray(value)
        kind, lacking = array.dtype.kind, np.ma.is_masked(array)
        if kind == "O":
            lacking = lacking or any(x is None for x in array.ravel())
        if kind in "iufO" and not lacking:
            return np.asarray(array, dtype=float)
    except (TypeError, ValueError, OverflowError):
        pass
    raise ArmError(f"{what} is {shown(value)}; expected {wanted}")


def number(
    value: Any,
    what: str,
    wanted: str = "a finite number",
    *,
    above: float = -math.inf,
    least: float = -math.inf,
) -> float:
    """A finite number that is greater than `above` and not less than `least`."""
    found = floats(value, what, wanted)
    if found.shape or not (np.isfinite(found) and found > above and found >= least):
        raise ArmError(f"{what} is {shown(value)}; expected {wanted}")
    return float(found)


def named(values: Any, what: str) -> dict[str, float]:
    """Numbers by name."""
    must_be(values, Mapping, what)
    for name in values:
        must_be(name, str, f"a name in {what}")
    return {name: number(x, f"{what}[{name!r}]") for name, x in values.items()}


def whole(value: Any, what: str, least: int = 0) -> int:
    """A whole number that is not less than `least`."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
        raise ArmError(f"{what} is {shown(value)}; expected a whole number of {least} or more")
    return int(value)


def one_of(value: object, what: str, known: Iterable[str]) -> str:
    """One of the names that are known."""
    known = tuple(known)
    if not isinstance(value, str) or value not in known:
        raise ArmError(f"{what} is {shown(value)}; expected one of {', '.join(known)}")
    return value


def listed(value: Any, what: str, wanted: str) -> tuple:
    """The items of a list or another collection; a text is none."""
    if isinstance(value, str | bytes) or not isinstance(value, Iterable):
        raise ArmError(f"{what} are {shown(value)}; expected {wanted}")
    return tuple(value)


def plane_axes(plane: object, what: str = "plane") -> tuple[int, int]:
    """Which axes, 0 to 2, a plane such as "yz" is made of, in their order."""
    known = {a + b: (i, j) for (i, a), (j, b) in permutations(enumerate("xyz"), 2)}
    if not isinstance(plane, str) or plane not in known:
        raise ArmError(
            f"{what} is {shown(plane)}; expected two different letters of x, y, z, such as 'yz'"
        )
    return known[plane]


def common_shape(what: str, *shapes: tuple[int, ...]) -> tuple[int, ...]:
    """The shape that batches of these shapes have together."""
    try:
        return np.broadcast_shapes(*shapes)
    except ValueError:
        given = " and ".join(map(str, shapes))
        raise ArmError(f"{what} have shapes {given}; expected the same or one of one") from None


def shown(value: object) -> str:
    """What was given, cut where it is long."""
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:77]}..."
