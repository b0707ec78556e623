"""What the digits of an answer promise: the unit of the last place of each entry, and what follows
from it.

Four grades: "right" · "so far" (right as far as it goes: too few digits, or part of it missing) ·
"rounded" (the last digit is off: cut, or rounded on the way) · "wrong". The rules and why are in
the book's appendix on the checkers.
"""

import re
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]

RIGHT, SO_FAR, ROUNDED, WRONG = "right", "so far", "rounded", "wrong"

HALF = 0.51  # units: a number rounded rightly, and a hair for the arithmetic
HAND = 3.01  # units: products of rounded numbers, by 540 hand-rounded Jacobians, and a hair
EXACT = 1e-6  # of the scale: what floating point and a symbol's digits may leave
SLOPPY = 1e-3  # of the scale: full floats from inputs that were rounded on the way
TELLING = 2.1e-3  # a mistake that changes less cannot be asked for: three decimals do not show it
_FULL = 13  # significant digits from which a float was never rounded
_NOISE = -12  # the power of ten below which a number is a rounded zero
_NUMBER = re.compile(r"[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?")


@dataclass(frozen=True)
class Typed:
    """Numbers as they were handed in: their values, and the unit of each one's last place (0 where
    exact).
    """

    values: Array
    units: Array
    symbolic: bool = False

    @property
    def decimals(self) -> int | None:
        """How many decimals the entries show, or None where they show all a computer has."""
        coarse = self.units[self.units > 0]
        return None if not coarse.size else max(0, round(-np.log10(coarse.min())))

    @property
    def unwritten(self) -> Array:
        """The units of numbers with three decimals or more, whose unwritten digits may count; 0 for
        the others.
        """
        return np.where((self.units > 0) & (self.units < 2e-3), self.units, 0.0)

    def at(self, *index) -> "Typed":
        """A part of it, or another order of its entries."""
        return replace(self, values=self.values[index], units=self.units[index])

    def turned(self) -> "Typed":
        """Rows as columns."""
        return replace(self, values=self.values.T, units=self.units.T)


def literal(text: str) -> tuple[int, int, int] | None:
    """Decimals, significant digits and the exponent of the first one of a plain number as typed;
    None for a formula.
    """
    match = _NUMBER.fullmatch(text.strip())
    if not match or not (match[1] or match[2]):
        return None
    power = int(match[3] or 0)
    digits = (match[1] + match[2]).lstrip("0")
    decimals = len(match[2]) - power
    return decimals, len(digits), len(digits) - 1 - decimals


def units(texts: list[str]) -> list[float]:
    """The unit of the last place of each of a set of numbers typed together; 0 for formulas and for
    full floats.

    They share their number of decimals, for trailing zeros are left out, unless they were cut to so
    many significant digits, as 12.3, 0.456 and 0.0789 were. Whole numbers among formulas are exact.
    """
    found = [literal(text) for text in texts]
    telling = [f for f in found if f and f[1] and f[2] > _NOISE]
    decimals, most = (max((f[k] for f in telling), default=0) for k in (0, 1))
    if most >= _FULL or (None in found and decimals <= 0):
        return [0.0] * len(texts)
    by_figures = all(f[0] <= most - 1 - f[2] for f in telling) and any(
        f[1] == most and f[0] < decimals for f in telling
    )
    return [0.0 if f is None else _unit(f, decimals, most if by_figures else None) for f in found]


def _unit(found: tuple[int, int, int], decimals: int, figures: int | None) -> float:
    _, digits, first = found
    if figures is None or not digits or first <= _NOISE:
        return 10.0**-decimals
    return 10.0 ** max(-decimals, first - figures + 1)


def of_floats(values: Array) -> Array:
    """The units of numbers that were handed over as numbers, by their shortest spelling."""
    flat = [repr(float(x)).removesuffix(".0") for x in values.ravel()]
    return np.reshape(units(flat), values.shape)
