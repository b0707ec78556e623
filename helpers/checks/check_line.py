"""The visible check line of the notebooks."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import must_be, number


def check(
    label: str, actual: Any, expected: Any, tolerance: float = 0.0, *, book_only: bool = False
) -> None:
    """Print one line that says `actual` agrees with `expected`, or raise AssertionError that says
    by how much not.

    With `book_only`, what is expected is a number of the book's own arms and poses: elsewhere it
    need not hold, so that the line says by how much not, and nothing is raised.

    Numbers and arrays agree when no entry differs by more than `tolerance`, SymPy's numbers too
    where there is one; anything else, such as a matrix with symbols, must be equal. Of the helpers
    it is the one that prints, commands apart: its line is the reader's proof.
    """
    must_be(label, str, "label")
    tolerance = number(tolerance, "tolerance", "a number of 0 or more", least=0)
    got, wanted = _numbers(actual), _numbers(expected)
    within = ""
    if got is None or wanted is None or (not tolerance and _symbolic(actual, expected)):
        agrees = _equal(actual, expected)
        detail = f"got {actual}, expected {expected}"
    elif got.shape != wanted.shape:
        agrees, detail = False, f"shape {got.shape}, expected {wanted.shape}"
    else:
        difference = float(np.abs(got - wanted).max(initial=0.0))
        agrees = difference <= tolerance
        detail = f"off by {difference:.3g}, allowed {tolerance:g}"
        within = f" (within {tolerance:g})" if tolerance else ""
    if agrees:
        print(f"✔ {label}{within}")
    elif book_only:
        print(f"○ {label}: {detail}; it holds for the book's own numbers only")
    else:
        raise AssertionError(f"{label}: {detail}")


def _equal(actual: Any, expected: Any) -> bool:
    """Whether two values that are not numbers are the same; NumPy compares arrays of words entry by
    entry."""
    if isinstance(actual, np.ndarray) or isinstance(expected, np.ndarray):
        return np.array_equal(actual, expected)
    return bool(actual == expected)


def _numbers(value: Any) -> NDArray[np.float64] | None:
    """Numbers as an array, SymPy's among them; None for anything else."""
    try:
        array = np.asarray(value)
        if array.dtype.kind in "biuf":
            return array.astype(float)
        known = array.dtype == object and all(map(_is_number, array.flat))
        return array.astype(float) if known else None
    except (TypeError, ValueError, OverflowError):
        return None


def _is_number(x: Any) -> bool:
    return isinstance(x, int | float | np.number) or bool(getattr(x, "is_number", False))


def _symbolic(*values: Any) -> bool:
    """Whether numbers stand there that are exact, as SymPy's, and so are equal or not."""
    return any(np.asarray(value).dtype == object for value in values)
