"""A computation recorded once on a tape, then run on numbers or on rows of them.

It is written for one pose, on components, and recorded by running it on `Term`s: what is known to
be 0 or 1 folds, signs move outwards, equal steps merge, and steps that no result needs are dropped.
The tape that is left is a list of sums, differences and products; one pose runs through it in
floats, a batch in contiguous rows, each step one call.
"""

import operator
import threading
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Value = Any  # a Term or a float: the same lines run on both
Step = tuple[str, Any, Any]  # a known number's value, or the places of earlier steps

_ON_NUMBERS = {"+": operator.add, "-": operator.sub, "*": operator.mul}
_ON_ROWS = {"+": np.add, "-": np.subtract, "*": np.multiply}


class Term:
    """A value of the computation that is being recorded: its place on the tape, or the negative of
    what stands there.

    The tape is a dict from each step (operation, first, second) to its place, in the order of
    recording.
    """

    __slots__ = ("at", "minus", "tape")

    def __init__(self, tape: dict[Step, int], at: int, minus: bool = False) -> None:
        self.tape, self.at, self.minus = tape, at, minus

    def _step(self, operation: str, first: float, second: int, minus: bool = False) -> "Term":
        at = self.tape.setdefault((operation, first, second), len(self.tape))
        return Term(self.tape, at, minus)

    def _known(self, value: float) -> "Term":
        return self._step("known", abs(value), 0, minus=value < 0)

    def __neg__(self) -> "Term":
        return Term(self.tape, self.at, not self.minus)

    def __mul__(self, other: Value) -> Value:
        if isinstance(other, Term):
            first, second = sorted((self.at, other.at))
            return self._step("*", first, second, minus=self.minus != other.minus)
        if abs(other) in (0.0, 1.0):
            return 0.0 if not other else self if other > 0 else -self
        return self * self._known(other)

    def __add__(self, other: Value) -> Value:
        if not isinstance(other, Term):
            return self + self._known(other) if other else self
        if self.minus == other.minus:
            first, second = sorted((self.at, other.at))
            return self._step("+", first, second, minus=self.minus)
        plus, less = (other, self) if self.minus else (self, other)
        return self._step("-", plus.at, less.at) if plus.at != less.at else 0.0

    def __sub__(self, other: Value) -> Value:
        return self + -other

    def __rsub__(self, other: Value) -> Value:
        return -self + other

    __rmul__, __radd__ = __mul__, __add__


class Program(NamedTuple):
    """The steps (operation, first, second, to) on places: first the inputs, then what is known,
    then `rows` of work.

    The results stand in the first rows; `copies` (from, to) brings there those that are no step of
    their own.
    """

    known: tuple[float, ...]
    rows: int
    on_numbers: tuple[tuple[Callable, int, int, int], ...]
    on_rows: tuple[tuple[Callable, int, int, int], ...]
    places: tuple[int, ...]
    copies: tuple[tuple[int, int], ...]

    def of_numbers(self, inputs: Sequence[float]) -> list[float]:
        """The results for one set of inputs."""
        values = [*inputs, *self.known, *[0.0] * self.rows]
        for operation, first, second, to in self.on_numbers:
            values[to] = operation(values[first], values[second])
        return [values[place] for place in self.places]

    def of_rows(self, inputs: Sequence[Array | float], rows: Array) -> Array:
        """The results, one row each, for inputs that are rows (batch,) or numbers; `rows` (rows,
        batch) is worked in."""
        values = [
            *inputs,
            *map(np.array, self.known),
            *rows,
        ]  # NumPy takes arrays faster than floats
        for operation, first, second, to in self.on_rows:
            operation(values[first], values[second], values[to])
        for place, to in self.copies:
            rows[to] = values[place]
        return rows[: len(self.places)]


def record(compute: Callable[..., Sequence[Value]], inputs: int) -> Program:
    """The program of `compute`, a function of so many values that gives a list of them.

    It may add, subtract, multiply and negate, and must take the same course whatever the values
    are.
    """
    tape: dict[Step, int] = {("input", i, 0): i for i in range(inputs)}
    places = [_place(tape, value) for value in compute(*(Term(tape, i) for i in range(inputs)))]
    return _with_rows(inputs, list(tape), places)


def _place(tape: dict[Step, int], result: Value) -> int:
    """Where the result stands, once its sign is a step too; 0 - x has no -0.0, which would print as
    such."""
    if not isinstance(result, Term):
        return tape.setdefault(("known", result + 0.0, 0), len(tape))
    if result.minus:
        zero = _place(tape, 0.0)
        return tape.setdefault(("-", zero, result.at), len(tape))
    return result.at


def _with_rows(inputs: int, tape: list[Step], results: list[int]) -> Program:
    """Give each step a row of work: a result's own, or one whose value no later step reads."""
    steps = _needed(tape, results)
    read = {at for _, _, first, second, _ in steps for at in (first, second)}.union(results)
    known = [at for at in sorted(read) if tape[at][0] == "known"]
    place = {at: at for at in range(inputs)} | {at: inputs + i for i, at in enumerate(known)}
    start = inputs + len(known)
    own = {at: start + i for i, at in reversed(list(enumerate(results))) if at not in place}
    free, end, lines = [], start + len(results), []
    for at, operation, first, second, last in steps:
        line = operation, place[first], place[second]
        free += [place[x] for x in last if x not in own and place[x] >= start]
        if at not in own and not free:
            free, end = [end], end + 1
        place[at] = own.get(at) or free.pop()
        lines.append((*line, place[at]))
    places = [place[at] for at in results]
    return Program(
        known=tuple(tape[at][1] for at in known),
        rows=end - start,
        on_numbers=tuple((_ON_NUMBERS[name], i, k, to) for name, i, k, to in lines),
        on_rows=tuple((_ON_ROWS[name], i, k, to) for name, i, k, to in lines),
        places=tuple(places),
        copies=tuple((x, to) for to, x in enumerate(places) if x != start + to),
    )


def _needed(tape: list[Step], results: list[int]) -> list[tuple[int, str, int, int, set[int]]]:
    """The steps that a result needs: where, what, of what, and which of these no later step
    reads."""
    needed, steps = set(results), []
    for at, (operation, first, second) in reversed(list(enumerate(tape))):
        if at in needed and operation in _ON_ROWS:
            last = {first, second} - needed
            steps.append((at, operation, first, second, last))
            needed |= last
    return steps[::-1]


class _Workspace(threading.local):
    """Memory that every run works in, one piece for each thread: fresh pages would cost more than
    the arithmetic."""

    flat = np.empty(0)


_workspace = _Workspace()


def workspace(rows: int, columns: int) -> Array:
    """An array (rows, columns) of anything, good until the thread asks for the next."""
    size = rows * columns
    if _workspace.flat.size < size:
        _workspace.flat = np.empty(size)
    return _workspace.flat[:size].reshape(rows, columns)
