"""Add noise to functions of NumPy and Python, like the round-off of another processor.

Python runs this file at its start if its folder is on PYTHONPATH, as in the kernel beside it. The
noise is up to two units in the last place. It leaves out the functions that OpenBLAS computes: the
kernel changes those by `OPENBLAS_CORETYPE`.
"""

import math

import numpy as np

NUMPY_NAMES = [
    "sin",
    "cos",
    "tan",
    "arcsin",
    "arccos",
    "arctan",
    "arctan2",
    "exp",
    "hypot",
    "einsum",
]
MATH_NAMES = ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "hypot"]
FACTORS = 1 + np.finfo(float).eps * np.array([-1, -0.5, 0, 1])
HASH_FACTOR = np.uint64(0x9E3779B97F4A7C15)  # 2**64 / golden ratio: spreads bits evenly


def add_noise(function):
    """Return a function whose results are multiplied by a factor of `FACTORS`.

    The bits of each result choose its factor, so equal computations give equal results.
    """

    def noisy_function(*args, **options):
        result = function(*args, **options)
        values = np.atleast_1d(result)
        if values.dtype != float:
            return result
        noisy = values * FACTORS[values.view(np.uint64) * HASH_FACTOR >> np.uint64(62)]
        if "out" in options:
            np.copyto(result, noisy)
            return result
        return noisy if np.ndim(result) else type(result)(noisy[0])

    return noisy_function


for module, names in ((np, NUMPY_NAMES), (math, MATH_NAMES)):
    for name in names:
        setattr(module, name, add_noise(getattr(module, name)))
