"""Another processor's last digit: with this folder on PYTHONPATH, each Python starts with seeded
noise of up to two units in the last place on what OpenBLAS does not compute.

What it does compute, `OPENBLAS_CORETYPE` moves; `make elsewhere` does both.
"""

import math

import numpy as np

NAMES = ["sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2", "exp", "hypot", "einsum"]
OF_MATH = ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "hypot"]
FACTORS = 1 + np.finfo(float).eps * np.array([-1, -0.5, 0, 1])
GOLDEN = np.uint64(0x9E3779B97F4A7C15)  # 2**64 over the golden ratio


def noisy(function):
    """The function with each of its numbers off by a factor that the number's own bits draw: the
    same computation gives the same twice."""

    def moved(*args, **options):
        found = function(*args, **options)
        values = np.atleast_1d(found)
        if values.dtype != float:
            return found
        off = values * FACTORS[values.view(np.uint64) * GOLDEN >> np.uint64(62)]
        if "out" in options:
            np.copyto(found, off)
            return found
        return off if np.ndim(found) else type(found)(off[0])

    return moved


for module, names in ((np, NAMES), (math, OF_MATH)):
    for name in names:
        setattr(module, name, noisy(getattr(module, name)))
