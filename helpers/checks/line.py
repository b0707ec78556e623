"""The visible check line of the notebooks."""

import numpy as np
from numpy.typing import ArrayLike


def check(label: str, actual: ArrayLike, expected: ArrayLike, within: float = 0.0) -> None:
    """Print one line that says `actual` agrees with `expected`, or raise AssertionError that says by how much not.

    Numbers and arrays agree when no entry differs by more than `within`; anything else, SymPy matrices
    too, must be equal. This is the one function of the book that prints: its line is the reader's proof.
    """
    exact = not _numeric(actual) or not _numeric(expected)
    if exact:
        difference, agrees = None, bool(actual == expected)
    else:
        actual, expected = np.asarray(actual, dtype=float), np.asarray(expected, dtype=float)
        if actual.shape != expected.shape:
            raise AssertionError(f"{label}: shape {actual.shape}, expected {expected.shape}")
        difference = float(np.abs(actual - expected).max(initial=0.0))
        agrees = difference <= within
    if not agrees:
        detail = (
            f"got {actual}, expected {expected}"
            if exact
            else f"off by {difference:.3g}, allowed {within:g}"
        )
        raise AssertionError(f"{label}: {detail}")
    print(f"✔ {label}" if exact or not within else f"✔ {label} (within {within:g})")


def _numeric(value: object) -> bool:
    try:
        return np.asarray(value).dtype.kind in "biuf"
    except (TypeError, ValueError):
        return False
