"""Print the check lines of the notebooks."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.inputs import finite_number, require_type


def check(
    label: str, actual: Any, expected: Any, tolerance: float = 0.0, *, book_only: bool = False
) -> None:
    """Print that `actual` agrees with `expected`, or raise AssertionError with the difference.

    Args:
        label: the claim that is checked.
        actual, expected: numbers or arrays, SymPy's too, which agree if no entry differs by more
            than `tolerance`; anything else, such as a matrix with symbols, must be equal.
        tolerance: largest difference of an entry.
        book_only: the expected value holds only for the book's own arms and configurations. A
            difference is printed and does not raise.

    Apart from the commands no other function of the helpers prints.
    """
    require_type(label, str, "label")
    tolerance = finite_number(tolerance, "tolerance", "a number of 0 or more", least=0)
    actual_numbers, expected_numbers = _to_numbers(actual), _to_numbers(expected)
    within = ""
    if (
        actual_numbers is None
        or expected_numbers is None
        or (not tolerance and _is_symbolic(actual, expected))
    ):
        agrees = _is_equal(actual, expected)
        detail = f"got {actual}, expected {expected}"
    elif actual_numbers.shape != expected_numbers.shape:
        agrees, detail = False, f"shape {actual_numbers.shape}, expected {expected_numbers.shape}"
    else:
        difference = float(np.abs(actual_numbers - expected_numbers).max(initial=0.0))
        agrees = difference <= tolerance
        detail = f"off by {difference:.3g}, allowed {tolerance:g}"
        within = f" (within {tolerance:g})" if tolerance else ""
    if agrees:
        print(f"✔ {label}{within}")
    elif book_only:
        print(f"○ {label}: {detail}; it holds for the book's own numbers only")
    else:
        raise AssertionError(f"{label}: {detail}")


def _is_equal(actual: Any, expected: Any) -> bool:
    """Return whether two values that are not numbers are equal, arrays entry by entry."""
    if isinstance(actual, np.ndarray) or isinstance(expected, np.ndarray):
        return np.array_equal(actual, expected)
    return bool(actual == expected)


def _to_numbers(value: Any) -> NDArray[np.float64] | None:
    """Convert numbers, SymPy's too, to an array of floats, and anything else to None."""
    try:
        array = np.asarray(value)
        if array.dtype.kind in "iuf":
            return array.astype(float)
        known = array.dtype == object and all(map(_is_number, array.flat))
        return array.astype(float) if known else None
    except (TypeError, ValueError, OverflowError):
        return None


def _is_number(x: Any) -> bool:
    if isinstance(x, bool):
        return False
    return isinstance(x, int | float | np.number) or bool(getattr(x, "is_number", False))


def _is_symbolic(*values: Any) -> bool:
    """Return whether a value holds exact SymPy numbers, which are compared without tolerance."""
    return any(np.asarray(value).dtype == object for value in values)
