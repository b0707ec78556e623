"""How an answer's entries are graded: what each may be off by, and whether a mistake lies as near
as what is right.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.checks.digits import EXACT, HALF, HAND, RIGHT, ROUNDED, SLOPPY, SO_FAR, TELLING, WRONG

Array = NDArray[Any]


@dataclass(frozen=True)
class Margins:
    """Per entry: up to `allowed` it is right, up to `band` it was rounded on the way, up to `loose`
    perhaps. `slop` is what the unwritten digits of q add, tried only where it fails without.
    """

    allowed: Array
    band: Array
    loose: Array
    units: Array
    slop: Array

    def at(self, pick: Any) -> "Margins":
        """Those of a part of the entries."""
        return Margins(
            self.allowed[pick],
            self.band[pick],
            self.loose[pick],
            self.units[pick],
            self.slop[pick],
        )

    @property
    def bands(self) -> tuple[Array, ...]:
        """How near an answer may be to a mistake's, the narrowest first."""
        wide = (self.band + 2 * self.slop,) if self.slop.any() else ()
        return (self.band, *wide, np.maximum(self.loose, self.band + 2 * self.slop), self.allowed)


def margins(
    units: Array, scale: Array, slop: Array | float = 0.0, tolerance: float | None = None
) -> Margins:
    """From the units of the last places, the scale of each entry's block, and what the digits of q
    leave open.
    """
    exact = EXACT * scale
    if tolerance is not None:
        allowed = np.broadcast_to(np.maximum(tolerance, exact * 1e-3), units.shape)
        return Margins(allowed, allowed, allowed, np.zeros_like(units), np.zeros_like(units))
    allowed, band = np.maximum(HALF * units, exact), np.maximum(HAND * units, exact)
    slop = np.broadcast_to(slop, units.shape)
    return Margins(allowed, band, np.maximum(band, SLOPPY * scale), units, slop)


def graded(mine: Array, right: Array, m: Margins, made: Array) -> str:
    """The grade; `made` holds the answers of known mistakes, shape (causes, *mine.shape)."""
    off = np.abs(mine - right)
    axes = tuple(range(1, made.ndim))
    telling = made[(np.abs(made - right) > TELLING).any(axes)] if len(made) else made
    near = np.abs(mine - telling)
    for allowed in (m.allowed, m.allowed + m.slop):
        mistaken = bool((near <= allowed).all(axes).any())
        if (off <= allowed).all():
            coarse = float(m.units.max(initial=0.0))
            gap = np.abs(telling - right).max(axes).min(initial=np.inf) if len(telling) else np.inf
            return SO_FAR if mistaken or coarse > gap / 2.1 else RIGHT
        if mistaken:
            return WRONG
    if (off <= np.maximum(m.loose, m.band + 2 * m.slop)).all():
        nearer = bool((near.max(axes) <= off.max()).any())
        return SO_FAR if nearer else ROUNDED
    return WRONG
