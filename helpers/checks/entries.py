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
    """Per entry: `allowed` is right, up to `band` it was rounded on the way, up to `loose`
    perhaps.
    """

    allowed: Array
    band: Array
    loose: Array
    units: Array


def margins(
    units: Array, scale: Array, slop: Array | float = 0.0, tolerance: float | None = None
) -> Margins:
    """From the units of the last places, the scale of each entry's block, and what the digits of q
    leave open.
    """
    exact = EXACT * scale
    if tolerance is not None:
        allowed = np.broadcast_to(np.maximum(tolerance, exact * 1e-3), units.shape)
        return Margins(allowed, allowed, allowed, np.zeros_like(units))
    allowed = np.maximum(HALF * units, exact) + slop
    band = np.maximum(HAND * units, exact) + 2 * slop
    return Margins(allowed, band, np.maximum(band, SLOPPY * scale), units)


def graded(mine: Array, right: Array, m: Margins, made: Array) -> tuple[str, Array]:
    """The grade, and which entries are wrong; `made` holds the answers of known mistakes, (causes,
    *mine.shape).
    """
    off = np.abs(mine - right)
    axes = tuple(range(1, made.ndim))
    telling = made[(np.abs(made - right) > TELLING).any(axes)] if len(made) else made
    near = np.abs(mine - telling)
    mistaken = bool((near <= m.allowed).all(axes).any())
    if (off <= m.allowed).all():
        coarse = float(m.units.max(initial=0.0))
        gap = np.abs(telling - right).max(axes).min(initial=np.inf) if len(telling) else np.inf
        return (SO_FAR if mistaken or coarse > gap / 2.1 else RIGHT), off > m.allowed
    if (off <= m.loose).all() and not mistaken:
        nearer = bool((near.max(axes) <= off.max()).any())
        return (SO_FAR if nearer else ROUNDED), off > m.allowed
    return WRONG, off > m.band
