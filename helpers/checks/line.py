"""The visible check line of the notebooks."""

from typing import Any

import numpy as np

from helpers.inputs import must_be, number


def check(
    label: str, actual: Any, expected: Any, tolerance: float = 0.0, *, book_only: bool = False
) -> None:
    """Print one line that says `actual` agrees with `expected`, or raise AssertionError that says
    by how much not.

    With `book_only`, what is expected is a number of the book's own arms and poses: elsewhere it
    need not hold, so that the line says by how much not, and nothing is raised.

    Numbers and arrays agree when no entry differs by more than `tolerance`; anything else, SymPy
    matrices too, must be equal. Of the helpers it is the one that prints, commands apart: its line
    is the reader's proof.
    """
    must_be(label, str, "label")
    number(tolerance, "tolerance", "a number of 0 or more", least=0)
    exact = not _numeric(actual) or not _numeric(expected)
    if exact:
        difference, agrees = None, _equal(actual, expected)
    else:
        got, wanted = np.shape(actual), np.shape(expected)
        if got != wanted:
            raise AssertionError(f"{label}: shape {got}, expected {wanted}")
        difference = float(np.abs(np.subtract(actual, expected, dtype=float)).max(initial=0.0))
        agrees = difference <= tolerance
    if agrees:
        print(f"✔ {label}" if exact or not tolerance else f"✔ {label} (within {tolerance:g})")
        return
    detail = (
        f"got {actual}, expected {expected}"
        if exact
        else f"off by {difference:.3g}, allowed {tolerance:g}"
    )
    if not book_only:
        raise AssertionError(f"{label}: {detail}")
    print(f"○ {label}: {detail}; it holds for the book's own numbers only")


def _equal(actual: Any, expected: Any) -> bool:
    """Whether two values that are not numbers are the same; NumPy compares arrays of words entry by
    entry."""
    if isinstance(actual, np.ndarray) or isinstance(expected, np.ndarray):
        return np.array_equal(actual, expected)
    return bool(actual == expected)


def _numeric(value: object) -> bool:
    try:
        return np.asarray(value).dtype.kind in "biuf"
    except (TypeError, ValueError):
        return False
