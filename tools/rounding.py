"""Rounding as another processor would do it: seeded noise on whatever its arithmetic decides.

`install` comes before the first import of `helpers`. From then on each result of `numpy.linalg`,
of a product of matrices, of trigonometry and of the public functions of `helpers.kinematics` is
off by up to two units of its last place.
"""

import ast
import builtins
import math
import struct
import sys
from collections.abc import Callable
from importlib.machinery import ModuleSpec, PathFinder, SourceFileLoader
from types import CodeType, ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

FACTORS = 1 + np.finfo(float).eps * np.array([-1, -0.5, 0, 1])  # two units of 1.99 or 0.99, at most
FACTOR = FACTORS.tolist()  # of one number
TRIGONOMETRY = ["sin", "cos", "tan", "arcsin", "arccos", "arctan", "arctan2"]
OF_MATH = ["sin", "cos", "tan", "asin", "acos", "atan", "atan2"]
PRODUCTS = ["matmul", "dot", "inner", "vecdot", "tensordot", "einsum"]
LINALG = [
    "cholesky",
    "cond",
    "det",
    "eig",
    "eigh",
    "eigvals",
    "eigvalsh",
    "inv",
    "lstsq",
    "matrix_power",
    "norm",
    "pinv",
    "qr",
    "slogdet",
    "solve",
    "svd",
    "svdvals",
]
GOLDEN = 0x9E3779B97F4A7C15  # 2**64 over the golden ratio
TOP_BITS = 62
MATMUL = "_noisy_matmul"


class Noise:
    """Multiplies a number by a factor drawn from its own bits and a seed.

    So the same computation gives the same result twice, as on any processor.
    """

    def __init__(self, seed: int = 0) -> None:
        self.reseed(seed)

    def reseed(self, seed: int) -> None:
        """Take another processor."""
        self._salt = pow(GOLDEN, 2 * seed + 1, 2**64)

    def __call__(self, value: Any) -> Any:
        if isinstance(value, float):  # most are, and an array of one costs ten times as much
            (bits,) = struct.unpack("<Q", struct.pack("<d", value))
            return type(value)(value * FACTOR[bits * self._salt % 2**64 >> TOP_BITS])
        if isinstance(value, tuple):
            parts = map(self, value)
            return type(value)(*parts) if hasattr(value, "_fields") else tuple(parts)
        kind = value.dtype.kind if isinstance(value, np.ndarray | np.generic) else ""
        if kind == "c":
            return self(np.real(value)) + 1j * self(np.imag(value))
        return value * FACTORS[self._drawn(value)] if kind == "f" else value

    def _drawn(self, value: NDArray) -> NDArray:
        """0 to 3, by Fibonacci hashing of the bits."""
        return value.view(np.uint64) * np.uint64(self._salt) >> np.uint64(TOP_BITS)


class Noisy:
    """A function with noise on what it returns; all else that it has, it keeps."""

    def __init__(self, function: Callable) -> None:
        self._function = function
        self.__name__, self.__doc__ = function.__name__, function.__doc__

    def __call__(self, *args: Any, **options: Any) -> Any:
        result = self._function(*args, **options)
        if options.get("out") is None:
            return NOISE(result)
        result[...] = NOISE(result)
        return result

    def __getattr__(self, name: str) -> Any:
        return getattr(self._function, name)


NOISE = Noise()


def install() -> None:
    """Put the noise into NumPy and `math`, and into `helpers` as it is imported."""
    if any(name.split(".")[0] == "helpers" for name in sys.modules):
        raise ImportError("rounding.install comes before the first import of helpers")
    for module, names in ((np.linalg, LINALG), (np, TRIGONOMETRY + PRODUCTS), (math, OF_MATH)):
        for name in names:
            _replace(getattr(module, name))
    setattr(builtins, MATMUL, lambda a, b: NOISE(a @ b))
    sys.meta_path.insert(0, _Finder())


def _replace(function: Callable) -> None:
    """Wherever NumPy and `math` know the function by name, since `pinv` calls `svd`, `roots`
    `eigvals`."""
    noisy = Noisy(function)
    for module in [m for name, m in sys.modules.items() if name.split(".")[0] in ("numpy", "math")]:
        for name in [name for name, value in vars(module).items() if value is function]:
            setattr(module, name, noisy)


class Products(ast.NodeTransformer):
    """Writes `a @ b` as a call, since no array can be told to multiply otherwise."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        if not isinstance(node.op, ast.MatMult):
            return node
        call = ast.Call(ast.Name(MATMUL, ast.Load()), [node.left, node.right], [])
        return ast.fix_missing_locations(ast.copy_location(call, node))


class _Finder:
    """Finds the modules of `helpers` where they always are, and has them read with noise."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        if name.split(".")[0] != "helpers":
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec and isinstance(spec.loader, SourceFileLoader):
            spec.loader = _Loader(name, spec.loader.path)
        return spec


class _Loader(SourceFileLoader):
    def get_code(self, fullname: str) -> CodeType:
        """Compiled anew: nothing noisy may be left behind as bytecode."""
        tree = Products().visit(ast.parse(self.get_data(self.path)))
        return compile(tree, self.path, "exec", dont_inherit=True)

    def exec_module(self, module: ModuleType) -> None:
        super().exec_module(module)
        if module.__name__ == "helpers.kinematics":
            for name in module.__all__:
                setattr(module, name, Noisy(getattr(module, name)))
