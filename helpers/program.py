"""Record a recursion over an arm's links and run it on configurations.

A recursion is written for one configuration, on components. `record_program` runs it on `Term`s,
which write each operation on a tape. Factors 0 and 1 are dropped, signs move outwards, equal steps
are merged, and steps that no result needs are left out. The program is a list of sums, differences
and products. A single configuration runs through it in floats. A batch runs in contiguous rows,
with one NumPy call for each step.
"""

from __future__ import annotations

import math
import operator
import threading
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.rows import NumericRow

Array = NDArray[np.float64]
Value = Any  # a Term or a float; the same code computes with both
TapeStep = tuple[str, Any, Any]  # operation and operands: positions of earlier steps, or a constant
RowMotion = tuple[NumericRow, Value, Value, Value]  # row, cosine and sine of its angle, its offset
Recursion = Callable[..., Sequence[Value]]

# Numbers that are processed at a time: 1 MiB, which fits into a level-2 cache.
_CHUNK_NUMBERS = 1 << 17

_FLOAT_OPERATIONS = {"+": operator.add, "-": operator.sub, "*": operator.mul}
_ROW_OPERATIONS = {"+": np.add, "-": np.subtract, "*": np.multiply}


# Recording


class Term:
    """A value of the computation that is being recorded.

    The tape is a dict from each step (operation, first, second) to its position, in the order of
    recording.

    Attributes:
        tape: The tape on which operations are recorded.
        position: Position on the tape of the step that gives the value.
        is_negative: Whether the value is the negative of that step's result.
    """

    __slots__ = ("is_negative", "position", "tape")

    def __init__(self, tape: dict[TapeStep, int], position: int, is_negative: bool = False) -> None:
        self.tape, self.position, self.is_negative = tape, position, is_negative

    def _record_step(
        self, operation: str, first: float, second: int, is_negative: bool = False
    ) -> Term:
        position = self.tape.setdefault((operation, first, second), len(self.tape))
        return Term(self.tape, position, is_negative)

    def _record_constant(self, value: float) -> Term:
        return self._record_step("constant", abs(value), 0, is_negative=value < 0)

    def __neg__(self) -> Term:
        return Term(self.tape, self.position, not self.is_negative)

    def __mul__(self, other: Value) -> Value:
        if isinstance(other, Term):
            first, second = sorted((self.position, other.position))
            is_negative = self.is_negative != other.is_negative
            return self._record_step("*", first, second, is_negative=is_negative)
        if abs(other) in (0.0, 1.0):
            return 0.0 if not other else self if other > 0 else -self
        return self * self._record_constant(other)

    def __add__(self, other: Value) -> Value:
        if not isinstance(other, Term):
            return self + self._record_constant(other) if other else self
        if self.is_negative == other.is_negative:
            first, second = sorted((self.position, other.position))
            return self._record_step("+", first, second, is_negative=self.is_negative)
        positive, negative = (other, self) if self.is_negative else (self, other)
        if positive.position == negative.position:
            return 0.0
        return self._record_step("-", positive.position, negative.position)

    def __sub__(self, other: Value) -> Value:
        return self + -other

    def __rsub__(self, other: Value) -> Value:
        return -self + other

    __rmul__, __radd__ = __mul__, __add__


class Program(NamedTuple):
    """Recorded steps (operation, first, second, target) on numbered positions.

    Positions count the inputs first, then the constants, then the rows of work. The results stand
    in the first rows of work.

    Attributes:
        constants: The constants.
        rows: How many rows of work a batch needs.
        float_steps: The steps with the operations of floats.
        row_steps: The same steps with the operations of NumPy.
        result_positions: Position of each result.
        copies: Pairs (from, to) that bring results which are no step of their own, such as an
            input, to the first rows.
    """

    constants: tuple[float, ...]
    rows: int
    float_steps: tuple[tuple[Callable, int, int, int], ...]
    row_steps: tuple[tuple[Callable, int, int, int], ...]
    result_positions: tuple[int, ...]
    copies: tuple[tuple[int, int], ...]

    def run_on_floats(self, inputs: Sequence[float]) -> list[float]:
        """Compute the results for one set of inputs."""
        values = [*inputs, *self.constants, *[0.0] * self.rows]
        for operation, first, second, target in self.float_steps:
            values[target] = operation(values[first], values[second])
        return [values[position] for position in self.result_positions]

    def run_on_rows(self, inputs: Sequence[Array | float], rows: Array) -> Array:
        """Compute the results for a batch of inputs.

        Args:
            inputs: One row of shape (batch,), or one number, for each input.
            rows: Memory to work in, shape (rows, batch).

        Returns:
            The results, shape (results, batch): the first of `rows`.
        """
        # NumPy computes faster with 0-dimensional arrays than with floats.
        values = [*inputs, *map(np.array, self.constants), *rows]
        for operation, first, second, target in self.row_steps:
            operation(values[first], values[second], values[target])
        for position, target in self.copies:
            rows[target] = values[position]
        return rows[: len(self.result_positions)]


def record_program(compute: Callable[..., Sequence[Value]], inputs: int) -> Program:
    """Record a computation as a program.

    Args:
        compute: A function of `inputs` values that returns a sequence of values. It may add,
            subtract, multiply and negate, and must do the same whatever the values are.
        inputs: The number of its inputs.
    """
    tape: dict[TapeStep, int] = {("input", i, 0): i for i in range(inputs)}
    terms = (Term(tape, i) for i in range(inputs))
    results = [_find_result_position(tape, value) for value in compute(*terms)]
    return _assign_rows(inputs, list(tape), results)


def _find_result_position(tape: dict[TapeStep, int], result: Value) -> int:
    """Return the position of a result on the tape, recording a negative result as 0 - x.

    0 - x is never -0.0, which would be printed as "-0.".
    """
    if not isinstance(result, Term):
        return tape.setdefault(("constant", result + 0.0, 0), len(tape))
    if result.is_negative:
        zero = _find_result_position(tape, 0.0)
        return tape.setdefault(("-", zero, result.position), len(tape))
    return result.position


def _assign_rows(inputs: int, tape: list[TapeStep], results: list[int]) -> Program:
    """Keep the steps that a result needs, and give each a row of work.

    A result has a row of its own. Another step takes a row that no later step reads.
    """
    # Go backwards, and store each needed step with the operands that no later step reads.
    needed, steps = set(results), []
    for at, (operation, first, second) in reversed(list(enumerate(tape))):
        if at in needed and operation in _ROW_OPERATIONS:
            last_reads = {first, second} - needed
            needed |= last_reads
            steps.append((at, operation, first, second, last_reads))
    constants = [at for at in sorted(needed) if tape[at][0] == "constant"]
    position = {at: at for at in range(inputs)}
    position |= {at: inputs + i for i, at in enumerate(constants)}
    start = inputs + len(constants)
    result_rows = {
        at: start + i for i, at in reversed(list(enumerate(results))) if at not in position
    }
    free, end, lines = [], start + len(results), []
    for at, operation, first, second, last_reads in reversed(steps):
        operands = position[first], position[second]
        free += [position[x] for x in last_reads if x not in result_rows and position[x] >= start]
        if at not in result_rows and not free:
            free, end = [end], end + 1
        position[at] = result_rows.get(at) or free.pop()
        lines.append((operation, *operands, position[at]))
    result_positions = [position[at] for at in results]
    return Program(
        constants=tuple(tape[at][1] for at in constants),
        rows=end - start,
        float_steps=tuple((_FLOAT_OPERATIONS[name], i, k, to) for name, i, k, to in lines),
        row_steps=tuple((_ROW_OPERATIONS[name], i, k, to) for name, i, k, to in lines),
        result_positions=tuple(result_positions),
        copies=tuple((x, to) for to, x in enumerate(result_positions) if x != start + to),
    )


class _Workspace(threading.local):
    """Memory that a thread reuses, since allocating it would take longer than the arithmetic."""

    flat = np.empty(0)


_workspace = _Workspace()


def get_workspace(rows: int, columns: int) -> Array:
    """Return an uninitialised array (rows, columns), valid until the thread's next call."""
    size = rows * columns
    if _workspace.flat.size < size:
        _workspace.flat = np.empty(size)
    return _workspace.flat[:size].reshape(rows, columns)


# Programs of an arm


def run_recursion(
    arm: Arm,
    q: ArrayLike,
    recursion: Recursion,
    shape: tuple[int, ...],
    constants: Sequence[float] = (),
) -> Array:
    """Run a recursion over an arm's links at every q.

    Args:
        arm: The arm; its program of the recursion is recorded at the first call.
        q: Joint values, shape (..., dof).
        recursion: A function of the arm, the motions of its rows and the constants.
        shape: Shape of the result at one configuration.
        constants: Further inputs of the recursion, such as gravity.

    Returns:
        The results, shape (..., *shape).
    """
    q = arm.joint_vector(q)
    program = get_program(arm, recursion, constants)
    if q.ndim == 1:
        return np.array(_run_once(program, q, constants)).reshape(shape)
    flat = q.reshape(math.prod(q.shape[:-1]), arm.dof)
    results = np.empty((len(flat), len(program.result_positions)))
    chunk = max(1, _CHUNK_NUMBERS // (3 * arm.dof + program.rows + 1))
    for start in range(0, len(flat), chunk):
        part = slice(start, start + chunk)
        results[part] = run_batch(program, flat[part].T, constants).T
    return results.reshape(*q.shape[:-1], *shape)


def get_program(arm: Arm, recursion: Recursion, constants: Sequence[float] = ()) -> Program:
    """Return the arm's program of a recursion, recording it at the first call.

    A constant that is 0 is recorded as 0, so that its terms are left out of the program.
    """
    nonzero = tuple(x != 0 for x in constants)
    if (recursion, nonzero) not in arm.programs:
        n = arm.dof

        def compute(*terms: Value) -> Sequence[Value]:
            motions = list(row_motions(arm, terms[:n], terms[n : 2 * n], terms[2 * n : 3 * n]))
            inputs = zip(terms[3 * n :], nonzero, strict=True)
            return recursion(arm, motions, *(x if is_nonzero else 0.0 for x, is_nonzero in inputs))

        arm.programs[recursion, nonzero] = record_program(compute, 3 * n + len(constants))
    return arm.programs[recursion, nonzero]


def run_batch(program: Program, q: Array, constants: Sequence[float] = ()) -> Array:
    """Run a program on joint vectors in columns.

    Args:
        program: A program that `get_program` returned.
        q: Joint values, shape (dof, batch).
        constants: The constants that the program was recorded with.

    Returns:
        The results, shape (results, batch), valid until this thread's next call.
    """
    n, batch = q.shape
    if batch == 1:
        return np.array(_run_once(program, q[:, 0], constants))[:, None]
    space = get_workspace(3 * n + program.rows, batch)
    cosines, sines, values = space[: 3 * n].reshape(3, n, batch)
    values[...] = q
    cosines_and_sines(values, cosines, sines)
    return program.run_on_rows([*space[: 3 * n], *map(np.array, constants)], space[3 * n :])


def _run_once(program: Program, q: Array, constants: Sequence[float]) -> list[float]:
    values = q.tolist()
    inputs = [*map(math.cos, values), *map(math.sin, values), *values, *constants]
    return program.run_on_floats(inputs)


def cosines_and_sines(
    q: Array, cosines: Array | None = None, sines: Array | None = None
) -> tuple[Array, Array]:
    """Compute the cosines and sines of many angles, to 3.4e-16.

    The half angle's tangent gives both; of the three functions, only NumPy's tan is vectorised.
    The results are written into `cosines` and `sines` where these are given.
    """
    t = np.multiply(0.5, q, out=sines)
    t = np.tan(t, out=t)
    r = np.multiply(t, t, out=cosines)
    r += 1.0
    r = np.divide(2.0, r, out=r)
    t *= r
    r -= 1.0
    return r, t


def row_motions(
    arm: Arm, cosines: Sequence[Value], sines: Sequence[Value], q: Sequence[Value]
) -> Iterator[RowMotion]:
    """Yield each row with the cosine and sine of its angle and its offset, the joint moved."""
    joint = 0
    for row in arm.numeric:
        c, s, d = row.cos_theta, row.sin_theta, row.d
        if row.kind == "revolute":
            c, s = (
                cosines[joint] * c - sines[joint] * s,
                sines[joint] * c + cosines[joint] * s,
            )
        elif row.kind == "prismatic":
            d = q[joint] + d
        joint += row.kind != "fixed"
        yield row, c, s, d
