"""What mistakes make of a right Jacobian: in the table or q (before), in the recipe, and in how it
is written down (after).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.chains import Chain, chain, columns
from helpers.checks.lengths import wrong_lengths
from helpers.checks.ranking import Cause, Pairs, cause

Array = NDArray[Any]
RAD = np.pi / 180
_MILLIMETRES = 10.0  # a slide this long is in no metres


@dataclass(frozen=True)
class Catalogue:
    """Mistaken Jacobians in the axes of the declared frame: their causes, and matrices (causes, 6,
    dof).
    """

    right: Array
    causes: Sequence[Cause]
    made: Array


def singles(arm: Arm, q: Array, frame: int) -> Catalogue:
    """Every single mistake of the catalogue."""
    at = _At(arm, q, frame)
    befores = [*at.recipes(), *at.tables()]
    afters = list(at.afters())
    causes = [c for c, _ in befores] + [c for c, _ in afters]
    made = [at.seen(J) for _, J in befores] + [after(at.right) for _, after in afters]
    return Catalogue(at.seen(at.right), tuple(causes), np.stack(made))


def pairs(arm: Arm, q: Array, frame: int) -> Catalogue:
    """Every pair of a mistake in the table, the recipe or the pose and one in the writing; of two
    in the writing; and of one in the table with one in the recipe."""
    at = _At(arm, q, frame)
    befores, afters = [*at.recipes(), *at.tables()], list(at.afters())
    stack = np.stack([J for _, J in befores])
    causes, made = [], []
    for second, after in afters:
        causes += [(first, second) for first, _ in befores]
        made.append(after(stack))
    for (first, one), (second, two) in combinations(
        [x for x in afters if x[0].keys[0] in _WRITING], 2
    ):
        causes += [(first, second), (first, second)]
        made.append(np.stack([at.unseen(two, one), at.unseen(one, two)]))
    for second, J in at.twice():
        causes += second
        made.append(at.seen(J))
    return Catalogue(at.seen(at.right), Pairs(causes), np.concatenate(made))


_WRITING = (
    "J.halves",
    "J.millimetres",
    "J.per degree",
    "J.all signs",
    "J.cross",
    "J.frame",
    "J.angular zero",
    "J.transposed",
)


class _At:
    """One arm at one pose, with its rows in the axes of one frame."""

    def __init__(self, arm: Arm, q: Array, frame: int) -> None:
        self.arm, self.frame = arm, frame
        self.chain = chain(arm, q)
        self.T = self.chain.frames
        self.axes = self.T[frame, :3, :3]
        self.right = columns(self.chain)
        self.turning = arm.turning

    def seen(self, J: Array) -> Array:
        """A Jacobian in base axes as it reads in the declared frame."""
        return _turned(J, self.axes.T)

    def unseen(self, one, two) -> Array:
        """Two ways of writing it down, one upon the other; each takes base axes and gives the
        declared frame's.
        """
        return two(_turned(one(self.right), self.axes))

    # The recipe

    def recipes(self) -> Iterator[tuple[Cause, Array]]:
        yield from wrong_recipes(self.chain)
        for found, wrong in self.other_units():
            yield found, columns(wrong)

    def other_units(self) -> Iterator[tuple[Cause, Chain]]:
        """q taken in degrees, and in radians where degrees were meant; and its slides in
        millimetres, or in metres where they are so long.
        """
        q = self.chain.q
        for change in (np.radians, np.degrees):
            yield cause("J.degrees"), self.chain.with_(q=np.where(self.turning, change(q), q))
        if not self.turning.all():
            factor = 1e-3 if np.abs(q[~self.turning]).max() > _MILLIMETRES else 1e3
            wrong = self.chain.with_(q=np.where(self.turning, q, factor * q))
            yield cause("ik.slide in millimetres"), wrong

    # The table

    def tables(self) -> Iterator[tuple[Cause, Array]]:
        """The right recipe on a wrong table: one entry's sign, one entry forgotten, the pen, all
        the offsets of theta.
        """
        causes, wrong = zip(*wrong_tables(self.arm, self.chain), strict=True)
        yield from zip(causes, columns(_stacked(wrong)), strict=True)

    def twice(self) -> Iterator[tuple[list[tuple[Cause, Cause]], Array]]:
        """The wrong recipes on the wrong tables, and on q in other units."""
        wrong = [*self.other_units(), *wrong_tables(self.arm, self.chain)]
        for second, J in wrong_recipes(_stacked([c for _, c in wrong])):
            yield [(first, second) for first, _ in wrong], J

    # The writing

    def afters(self):
        """Each a function of a Jacobian in base axes, or a stack of them, to the declared
        frame's.
        """
        turns = self.turning

        def after(change):
            return lambda J: self.seen(change(J))

        def half(v: float, w: float):
            return after(lambda J: J * np.repeat([v, w], 3)[:, None])

        yield cause("J.halves"), lambda J: _swapped(self.seen(J))
        yield (
            cause("J.cross"),
            after(lambda J: np.where(turns & (np.arange(6) < 3)[:, None], -J, J)),
        )
        yield cause("J.all signs"), half(-1, -1)
        yield cause("J.angular sign"), half(1, -1)
        yield cause("J.millimetres"), half(1000, 1)
        yield cause("J.centimetres"), half(100, 1)
        yield cause("J.angular zero"), half(1, 0)
        yield cause("J.linear zero"), half(0, 1)
        yield cause("J.per degree"), after(lambda J: np.where(turns, J * RAD, J))
        yield cause("J.per degree"), after(lambda J: np.where(turns, J / RAD, J))
        if self.arm.dof == 6:
            yield cause("J.transposed"), lambda J: np.swapaxes(self.seen(J), -1, -2)
        for k, i in enumerate(self.arm.joints):
            one = np.where(np.arange(self.arm.dof) == k, -1.0, 1.0)
            yield cause("J.column sign", i=i), after(lambda J, s=one: J * s)
        yield cause("J.reversed order"), after(lambda J: J[..., ::-1])
        yield from self._frames()
        for i, j in combinations(range(self.arm.dof), 2):
            order = np.arange(self.arm.dof)
            order[[i, j]] = j, i
            names = dict(i=self.arm.joints[i], j=self.arm.joints[j])
            yield cause("J.columns exchanged", **names), after(lambda J, o=order: J[..., o])

    def _frames(self):
        rows = len(self.T) - 1
        for k in [rows, *range(rows)]:
            R = self.T[k, :3, :3]
            if k != self.frame:
                fields = dict(k=k, _name=frame_name(k), _wanted=frame_name(self.frame))
                yield cause("J.frame", **fields), lambda J, R=R: _turned(J, R.T)
                yield cause("J.frame angular", **fields), self._one_half(R, slice(3, 6))
                yield cause("J.frame linear", **fields), self._one_half(R, slice(0, 3))
        k = self.frame or rows
        yield cause("J.frame turned back", _k=k), lambda J: _turned(J, self.T[k, :3, :3])

    def _one_half(self, R: Array, rows: slice):
        def half(J: Array) -> Array:
            seen = np.array(self.seen(J))
            seen[..., rows, :] = _turned(J, R.T)[..., rows, :]
            return seen

        return half


def wrong_recipes(at: Chain) -> Iterator[tuple[Cause, Array]]:
    """The Jacobian with one step of its recipe done otherwise, in base axes, for one pose or
    many.
    """
    T, usual = at.frames, np.array(at.joints) - 1
    right = columns(at)
    late = columns(at, axis=usual + 1, origin=usual + 1)
    v, w = slice(0, 3), slice(3, 6)
    yield cause("J.z_i angular"), _halves(right[..., v, :], late[..., w, :])
    yield cause("J.one frame late"), late
    yield cause("J.z_i"), columns(at, axis=usual + 1)
    count = np.arange(len(usual))
    if (count != usual).any():
        remaining = columns(at, axis=count)
        yield cause("J.z counted on angular"), _halves(right[..., v, :], remaining[..., w, :])
        yield cause("J.z counted on"), columns(at, axis=count, origin=count)
    yield cause("J.origin late"), columns(at, origin=usual + 1)
    yield cause("J.lever tip"), columns(at, lever="tip")
    yield cause("J.lever origin"), columns(at, lever="o")
    yield cause("J.lever link"), columns(at, lever="link")
    # Axes and origins along the rows of T, whose last row (0, 0, 0, 1) has the origin.
    yield cause("J.rows of T"), columns(at, frames=np.swapaxes(T, -1, -2))
    if not at.turning.all():
        yield cause("J.slide turns"), columns(at, slides=False)
    for k in range(T.shape[-3] - 1):
        yield cause("J.point", k=k), columns(at, point=k)


def wrong_tables(arm: Arm, right: Chain) -> Iterator[tuple[Cause, Chain]]:
    """Usual mistakes in a table's numbers, whatever it is used for: in its lengths, in all its
    offsets or twists, then in one entry, row by row.
    """
    for found, wrong in wrong_lengths(arm):
        yield found, chain(wrong, right.q)
    rows = np.arange(1, len(right.a) + 1)
    turning = np.isin(rows, np.array(right.joints)[right.turning])
    yield cause("table.offsets"), right.with_(theta=np.where(turning, 0.0, right.theta))
    yield cause("table.twists"), right.with_(alpha=-right.alpha)
    for row in rows:
        yield from _wrong_row(right, int(row), rows == row)


def _wrong_row(right: Chain, row: int, one: NDArray[np.bool_]) -> Iterator[tuple[Cause, Chain]]:
    """One entry of a row forgotten, or its sign; `one` is where this row is."""
    if np.abs(np.sin(right.alpha[one])) > 1e-9:
        twist = right.alpha
        yield cause("table.twist", row=row), right.with_(alpha=np.where(one, -twist, twist))
        yield cause("table.no twist", row=row), right.with_(alpha=np.where(one, 0.0, twist))
    for column in ("a", "d"):
        lengths = getattr(right, column)
        if lengths[one]:
            at = dict(column=column, row=row)
            yield (
                cause("table.sign", **at),
                right.with_(**{column: np.where(one, -lengths, lengths)}),
            )
            yield (
                cause("table.missing", **at),
                right.with_(**{column: np.where(one, 0.0, lengths)}),
            )
    if right.theta[one]:
        yield cause("table.offset", row=row), right.with_(theta=np.where(one, 0.0, right.theta))


def _stacked(chains: Sequence[Chain]) -> Chain:
    """Tables of one arm as one of many."""
    names = ("a", "alpha", "d", "theta", "q")
    return chains[0].with_(**{n: np.stack([getattr(c, n) for c in chains]) for n in names})


def frame_name(k: int) -> str:
    """How a sentence calls a link frame."""
    return f"frame {k}" if k else "the base"


def _halves(v: Array, w: Array) -> Array:
    return np.concatenate([v, w], axis=-2)


def _swapped(J: Array) -> Array:
    return np.concatenate([J[..., 3:, :], J[..., :3, :]], axis=-2)


def _turned(J: Array, R: Array) -> Array:
    return np.concatenate([R @ J[..., :3, :], R @ J[..., 3:, :]], axis=-2)
