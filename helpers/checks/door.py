"""What a student holds, taken as numbers: arrays, lists, SymPy matrices, functions, pasted text.

Text goes through `helpers.reading`, never through eval or sympify.
"""

import math
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.digits import Typed, of_floats, units
from helpers.checks.names import meanings
from helpers.inputs import ArmError, named, number, one_of, shown
from helpers.reading import formula, grid
from helpers.reading.sentences import say

Array = NDArray[Any]
_SCALED = re.compile(r"(.*?)\*(1(?:\.0+)?e[+-]?\d+)")
_NAMED = re.compile(
    r"['\"][^'\"]*['\"]\s*[,:]\s*|\\?\b(?:q|theta|th|θ|t|tau|τ)_?(?:\d|\{\d\})\s*[=:]\s*",
    flags=re.I,
)
# A vector that NumPy prints over several lines; a sign that stands one upright.
_PRINTED = re.compile(r"[^\[\](){};,|&]*\[[^\[\](){};,|&]*\]\s*")
_UPRIGHT = re.compile(
    r"(?<=[\])}])\s*(?:\^\s*(?:T|\\top|\{\s*(?:T|\\top)\s*\})|\.T|\.?')\s*;?\s*\Z"
)
Lookup = Callable[[set[str]], dict[str, float]]


class Joints:
    """Looks symbols up for one arm at one pose, and remembers what it had to say about them."""

    def __init__(self, arm: Arm, q: Array, values: Mapping[str, float] | None = None) -> None:
        self.arm, self.q, self.values = arm, np.array(q), dict(values or {})
        self.said: tuple[str, ...] = ()

    def __call__(self, names: set[str]) -> dict[str, float]:
        found, said = meanings(names, self.arm, self.q, self.values)
        self.said = tuple(dict.fromkeys(self.said + said))
        return found


def settings(
    angles: str = "rad", tolerance: float | None = None, values: Mapping | None = None
) -> float | None:
    """The tolerance, if there is one; raises ArmError unless the arguments that all checkers share
    are what they should be.
    """
    one_of(angles, "angles", ("rad", "deg"))
    if values is not None:
        named(values, "values")
    if tolerance is None:
        return None
    return number(tolerance, "tolerance", "a number of 0 or more", least=0)


def no_symbols(names: set[str]) -> dict[str, float]:
    """The look-up where numbers are expected."""
    if names:
        raise ArmError(say("symbols for numbers", names=", ".join(sorted(names))))
    return {}


def numbers(mine: Any, what: str, lookup: Lookup = no_symbols, wanted: str = "numbers") -> Typed:
    """Numbers of any shape with the units of their last places; raises ArmError where something
    else is held.

    `lookup` gives values to symbols; a header line of a table of numbers is dropped.
    """
    if isinstance(mine, str):
        return _of_text(mine, what, lookup)
    mine = _opened(mine)
    array = _plain_array(mine)
    if array is None:
        return _of_entries(mine, what, lookup, wanted)
    if not np.isfinite(array).all():
        raise ArmError(say("not finite", what=what, wanted=wanted))
    return Typed(array, of_floats(array))


def unnamed(mine: object) -> object:
    """One value for each joint without the names before them: ('theta1', 0.3) is 0.3."""
    if isinstance(mine, str):
        return _NAMED.sub("", mine)
    if isinstance(mine, Mapping):
        return [unnamed(v) for v in mine.values()]
    if isinstance(mine, list | tuple):
        if len(mine) == 2 and isinstance(mine[0], str) and not isinstance(mine[1], str):
            return unnamed(mine[1])
        return [unnamed(item) for item in mine]
    return mine


def _plain_array(mine: Any) -> Array | None:
    try:
        array = np.asarray(mine)
    except (TypeError, ValueError):
        return None
    return np.array(array, dtype=float) if array.dtype.kind in "iuf" else None


def _opened(mine: Any) -> Any:
    """Arrays and SymPy's matrices as lists, where what is masked is None; tables of pandas as
    arrays, dicts as their values.
    """
    if isinstance(mine, Mapping):
        return list(mine.values())
    if hasattr(mine, "tolist"):
        return mine.tolist()
    if hasattr(mine, "to_numpy"):
        return mine.to_numpy()
    return mine


def _of_text(text: str, what: str, lookup: Lookup) -> Typed:
    rows = _cells(text)
    widths = {len(row) for row in rows}
    if len(widths) > 1:
        told = ", ".join(map(str, sorted(widths)))
        row, count = next((i, len(row)) for i, row in enumerate(rows, 1) if len(row) < max(widths))
        raise ArmError(say("ragged", what=what, widths=told, row=row, count=count))
    shape = (len(rows), widths.pop())
    if (found := _plain_numbers(rows)) is not None:
        texts = [cell for row in rows for cell in row]
        return Typed(found.reshape(shape), np.reshape(units(texts), shape))
    texts = [formula.plain(cell) for row in rows for cell in row]
    scaled = [_scaled(cell) for cell in texts]
    trees = [formula.parse(cell, f"an entry of {what}") for cell in texts]
    names = set().union(*map(formula.symbols, trees))
    known = lookup(names)
    values = [formula.value(tree, known.get) for tree in trees]
    steps = units([first for first, _ in scaled])
    steps = [u * factor for u, (_, factor) in zip(steps, scaled, strict=True)]
    return Typed(np.reshape(values, shape), np.reshape(steps, shape), symbolic=bool(names))


def _cells(text: str) -> grid.Cells:
    """The cells of a text; a vector is one however it is printed or stood upright."""
    bare = _UPRIGHT.sub("", text)
    rows = grid.without_header(grid.cells(bare))
    if bare != text and len(rows) > 1 < len(rows[0]):
        return grid.cells(text)  # which says that a matrix may not be
    if _PRINTED.fullmatch(bare) and len({len(row) for row in rows}) > 1:
        return [[cell for row in rows for cell in row]]
    return rows


def _plain_numbers(rows: grid.Cells) -> Array | None:
    """The values of a long paste of nothing but numbers at once, or None where it holds more."""
    texts = [cell for row in rows for cell in row]
    if not all(map(formula.is_number, texts)):
        return None
    values = np.array(texts, dtype=float)
    return values if np.isfinite(values).all() else None


def _scaled(cell: str) -> tuple[str, float]:
    """A number and the power of ten that MATLAB's heading gave it; 1 for any other cell."""
    match = _SCALED.fullmatch(cell)
    return (match[1], float(match[2])) if match else (cell, 1.0)


def _of_entries(mine: Any, what: str, lookup: Lookup, wanted: str) -> Typed:
    """Nested lists whose entries are numbers, formulas as text, or SymPy expressions."""
    flat = list(_leaves(mine, what, wanted))
    shape = _shape(mine)
    if math.prod(shape) != len(flat):
        raise ArmError(say("ragged list", what=what))
    trees = [formula.parse(x, f"an entry of {what}") if isinstance(x, str) else x for x in flat]
    names = set().union(*(_names(tree) for tree in trees))
    known = lookup(names)
    values = np.array([_entry(tree, known, what) for tree in trees], dtype=float)
    if not np.isfinite(values).all():
        raise ArmError(say("not finite", what=what, wanted=wanted))
    texts = [x if isinstance(x, str) else _spelled(x, v) for x, v in zip(flat, values, strict=True)]
    return Typed(values.reshape(shape), np.reshape(units(texts), shape), symbolic=bool(names))


def _spelled(x: Any, value: float) -> str:
    """A number's shortest spelling; an exact expression is spelled as a formula."""
    is_number = isinstance(x, int | float | np.number) or x.is_Float or x.is_Integer
    return repr(float(value)).removesuffix(".0") if is_number else "exact"


def _leaves(value: Any, what: str, wanted: str) -> Iterator[Any]:
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list | tuple):
        for item in value:
            yield from _leaves(item, what, wanted)
    elif isinstance(value, bool) or value is None or isinstance(value, complex):
        raise ArmError(say("no numbers", what=what, given=shown(value), wanted=wanted))
    elif isinstance(value, str | int | float | np.number) or hasattr(value, "free_symbols"):
        yield value
    else:
        raise ArmError(say("no numbers", what=what, given=shown(value), wanted=wanted))


def _shape(value: Any) -> tuple[int, ...]:
    if hasattr(value, "shape"):
        return tuple(value.shape)
    if isinstance(value, list | tuple):
        inner = {_shape(item) for item in value}
        return (len(value), *(inner.pop() if len(inner) == 1 else ()))
    return ()


def _names(tree: Any) -> set[str]:
    if isinstance(tree, tuple):
        return formula.symbols(tree)
    return {str(s) for s in _free(tree)} if hasattr(tree, "free_symbols") else set()


def _entry(tree: Any, known: dict[str, float], what: str) -> float:
    if isinstance(tree, tuple):
        return formula.value(tree, known.get)
    if hasattr(tree, "free_symbols"):
        return of_sympy(tree, known, what)
    try:
        return float(tree)
    except OverflowError:  # a whole number of more than 308 digits
        return math.inf


def _free(expression: Any) -> set:
    """Symbols, and functions of time such as q1(t), that an expression depends on."""
    from sympy.core.function import AppliedUndef

    functions = expression.atoms(AppliedUndef) if hasattr(expression, "atoms") else set()
    times = set().union(*(f.free_symbols for f in functions))
    return functions | (expression.free_symbols - times)


def of_sympy(expression: Any, known: dict[str, float], what: str) -> float:
    """The number of a SymPy expression, walked as a tree; nothing is compiled."""
    import sympy as sp
    from sympy.core.function import AppliedUndef

    functions = {sp.sin: math.sin, sp.cos: math.cos, sp.tan: math.tan, sp.exp: math.exp}

    def walk(e: Any) -> float:
        if isinstance(e, sp.Symbol | AppliedUndef):
            return known[str(e)]
        if e.is_number and not e.args:
            return float(e)
        if e.is_Add:
            return math.fsum(map(walk, e.args))
        if e.is_Mul:
            return math.prod(map(walk, e.args))
        if e.is_Pow:
            return walk(e.args[0]) ** walk(e.args[1])
        if e.func in functions:
            return functions[e.func](walk(e.args[0]))
        return float(e.subs({s: known[str(s)] for s in _free(e)}))

    try:
        found = walk(expression)
        return float(found)
    except (TypeError, ValueError, ArithmeticError, LookupError, RecursionError):
        raise ArmError(
            say("no numbers", what=what, given=shown(expression), wanted="numbers")
        ) from None


# Joint values


def in_radians(typed: Typed, arm: Arm) -> Typed:
    """Joint vectors (rows, dof) that were typed in degrees.

    Where some joints slide, those that turn have decimals of their own, for metres need more.
    """
    turning, steps = arm.turning, typed.units
    if turning.any() and not turning.all():
        own = of_floats(typed.values[:, turning])
        steps = steps.copy()
        steps[:, turning] = np.where(
            steps[:, turning] > 0, np.maximum(own, steps[:, turning]), steps[:, turning]
        )
    factor = np.where(turning, np.pi / 180, 1.0)
    return Typed(typed.values * factor, steps * factor)


def one_value_each(arm: Arm) -> str:
    """What is expected of a joint vector."""
    return f"one value for each of {', '.join(arm.variables)}"


def pose(q: Any, arm: Arm, angles: str = "rad") -> Typed:
    """One joint vector, with its units."""
    typed = numbers(unnamed(q), f"{arm.name}: q", wanted=one_value_each(arm))
    column = (typed.values.ndim == 2 and typed.values.shape[1] == 1) or isinstance(q, str)
    values, steps = (x.ravel() if column else x for x in (typed.values, typed.units))
    if angles == "deg":
        factor = np.where(arm.turning, np.pi / 180, 1.0) if values.shape == (arm.dof,) else 1.0
        values, steps = values * factor, steps * factor
    return Typed(arm.joint_vector(values, many=False), steps)
