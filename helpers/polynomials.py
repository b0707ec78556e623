"""An arm's frames as polynomials in the cosines and sines of its angles, in a form that is unique.

Each sin² is replaced by 1 - cos², and angles about parallel axes are added before their cosine is
taken (q_2 + q_3 rather than c_2 c_3 - s_2 s_3). Equal expressions are then identical, and nothing
has to be simplified. A symbol whose value is 0 is left out.
"""

from collections.abc import Sequence
from functools import reduce
from operator import mul
from typing import NamedTuple

import numpy as np
import sympy as sp
from sympy.polys.rings import PolyElement, PolyRing

from helpers.arm import Arm
from helpers.expressions import Entry, names
from helpers.inputs import ArmError, must_be
from helpers.rows import quarter_turns

Matrix = sp.ImmutableMatrix


def formula_of(arm: Arm, entry: Entry) -> sp.Expr:
    """A table entry in SymPy, exact; a symbol stays a symbol unless its value is 0."""
    values = dict(arm.values)
    symbols = {name: sp.Symbol(name) if values[name] else sp.S.Zero for name in names(entry)}
    return sp.sympify(str(entry), locals=symbols, rational=True)


def angle_of(arm: Arm, entry: Entry) -> tuple[sp.Expr, int]:
    """An angle as (rest, quarter turns): one of the two is 0."""
    turns = None if names(entry) else quarter_turns(arm.number(entry))
    return (formula_of(arm, entry), 0) if turns is None else (sp.S.Zero, turns)


class Frame(NamedTuple):
    """A link frame's columns, each a list of three polynomials."""

    x: list[PolyElement]
    y: list[PolyElement]
    z: list[PolyElement]
    origin: list[PolyElement]


class Turn(NamedTuple):
    """How far a run of parallel axes has turned at a row, as (formula, quarter turns)."""

    angle: tuple[sp.Expr, int]
    starts: bool


def turns_of(arm: Arm, joined: bool = True) -> list[Turn]:
    """How far each row has turned; unless `joined`, every joint starts a run of its own."""
    turns, held, formula, quarters = [], np.eye(3), sp.S.Zero, 0
    for i, (row, numeric) in enumerate(zip(arm.rows, arm.numeric, strict=True), 1):
        starts = numeric.kind == "revolute" and not (joined and abs(held[2, 2]) > 1 - 1e-12)
        if starts:
            held, formula, quarters = np.eye(3), sp.S.Zero, 0
        if numeric.kind == "revolute":
            sign, (rest, more) = round(held[2, 2]), angle_of(arm, row.theta)
            formula, quarters = (
                formula + sign * (sp.Symbol(f"q_{i}") + rest),
                quarters + sign * more,
            )
        else:
            held = held @ np.array(_rotation_z(numeric.cos_theta, numeric.sin_theta))
        held = held @ np.array(_rotation_x(numeric.cos_alpha, numeric.sin_alpha))
        turns.append(Turn((formula, quarters), starts))
    return turns


class Ring:
    """Polynomials in an arm's lengths and in the cosines and sines of its angles, in a unique
    form."""

    def __init__(self, arm: Arm, joined: bool = True, extra: Sequence[sp.Symbol] = ()) -> None:
        must_be(arm, Arm, "arm")
        self.turns = turns_of(arm, joined)
        found = {turn.angle[0] for turn in self.turns}
        found |= {angle_of(arm, e)[0] for row in arm.rows for e in (row.alpha, row.theta)}
        angles = sorted(found - {sp.S.Zero}, key=sp.default_sort_key)
        symbols = {
            s for row in arm.rows for e in (row.a, row.d) for s in formula_of(arm, e).free_symbols
        }
        symbols |= {
            sp.Symbol(f"q_{i}") for i in arm.joints if arm.rows[i - 1].joint.kind == "prismatic"
        }
        letters = sorted(symbols | set(extra), key=sp.default_sort_key)
        # Sines come first, so that sin² is the leading term of sin² + cos² - 1 and division removes
        # it.
        self._symbols = [f(angle) for f in (sp.sin, sp.cos) for angle in angles] + letters
        self._ring = PolyRing([sp.Dummy() for _ in self._symbols], sp.QQ, sp.lex)
        gens, n = self._ring.gens, len(angles)
        self._pairs = dict(zip(angles, zip(gens[n : 2 * n], gens[:n], strict=True), strict=True))
        self._letters = dict(zip(letters, gens[2 * n :], strict=True))
        self._units = [c**2 + s**2 - 1 for c, s in self._pairs.values()]
        self.zero, self.one = self._ring.zero, self._ring.one

    def cos_sin(self, angle: tuple[sp.Expr, int]) -> tuple[PolyElement, PolyElement]:
        """Cosine and sine of an angle given as (formula, quarter turns)."""
        formula, turns = angle
        c, s = self._pairs[formula] if formula else (self.one, self.zero)
        return ((c, s), (-s, c), (-c, -s), (s, -c))[turns % 4]

    def length(self, formula: sp.Expr) -> PolyElement:
        """A length, which ArmError says must be a polynomial in the arm's symbols."""
        if not formula.is_polynomial() or formula.has(sp.pi):
            raise ArmError(
                f"the length {formula} is no polynomial in the arm's symbols; expected sums and"
                " products"
            )
        total = self.zero
        for term in sp.Add.make_args(sp.expand(formula)):
            number, factors = term.as_coeff_mul()
            powers = [
                self._letters[base] ** int(n) for base, n in (f.as_base_exp() for f in factors)
            ]
            total += reduce(mul, powers, self.one * number)
        return total

    def derivative(self, poly: PolyElement, joint: int) -> PolyElement:
        """The derivative with respect to the variable of a joint, counted from 1."""
        variable = sp.Symbol(f"q_{joint}")
        total = poly.diff(self._letters[variable]) if variable in self._letters else self.zero
        for angle, (c, s) in self._pairs.items():
            if rate := int(angle.diff(variable)):
                total += rate * (poly.diff(s) * c - poly.diff(c) * s)
        return total

    def matrix(self, rows: list[list[PolyElement | int]]) -> sp.ImmutableMatrix:
        """A matrix of expressions from rows of polynomials."""
        return Matrix([[self.expression(self._ring(entry)) for entry in row] for row in rows])

    def expression(self, poly: PolyElement) -> sp.Expr:
        """A polynomial as a SymPy expression in its unique form."""
        return self.reduced(poly).as_expr(*self._symbols)

    def reduced(self, poly: PolyElement) -> PolyElement:
        """The unique form of a polynomial: no sine squared."""
        return self._ring(poly).rem(self._units) if self._units else self._ring(poly)

    def taken_over(self, poly: PolyElement, other: "Ring") -> PolyElement:
        """A polynomial of another ring of the same arm, in which every joint turned by itself."""
        values = dict(zip(self._symbols, self._ring.gens, strict=True)) | self._single_joints()
        powers = [values[symbol] for symbol in other._symbols]
        terms = (
            reduce(mul, (g**n for g, n in zip(powers, monomial, strict=True)), self.one * number)
            for monomial, number in poly.terms()
        )
        return self.reduced(sum(terms, self.zero))

    def _single_joints(self) -> dict[sp.Expr, PolyElement]:
        """cos(q_i) and sin(q_i), where q_i is the difference of two angles of a run."""
        found, before = {}, sp.S.Zero
        for i, turn in enumerate(self.turns, 1):
            formula, start = turn.angle[0], sp.S.Zero if turn.starts else before
            if sign := int((formula - start).coeff(sp.Symbol(f"q_{i}"))):
                (c, s), (c_0, s_0) = self.cos_sin((formula, 0)), self.cos_sin((start, 0))
                angle = sp.expand(sign * (formula - start))
                found[sp.cos(angle)], found[sp.sin(angle)] = (
                    c * c_0 + s * s_0,
                    sign * (s * c_0 - c * s_0),
                )
            before = formula
        return found


def frames_of(arm: Arm, ring: Ring) -> list[Frame]:
    """The link frames from base to tip.

    A frame's rotation is start * Rot_z(angle) * held: `start` is where the run of parallel axes
    began, `angle` what the run has turned by so far, `held` the constant rotations since.
    """
    unit = _rotation_z(ring.one, ring.zero)
    start, held, rotation, origin = unit, unit, unit, [ring.zero] * 3
    frames = [_frame(unit, origin)]
    for i, (row, turn) in enumerate(zip(arm.rows, ring.turns, strict=True), 1):
        before, d = transposed(rotation)[2], ring.length(formula_of(arm, row.d))
        if turn.starts:
            start, held = rotation, unit
        if row.joint.kind == "prismatic":
            d += ring.length(sp.Symbol(f"q_{i}"))
        if row.joint.kind != "revolute":
            held = _product(held, _rotation_z(*ring.cos_sin(angle_of(arm, row.theta))))
        turned = _product(start, _rotation_z(*ring.cos_sin(turn.angle)))
        x, a = transposed(_product(turned, held))[0], ring.length(formula_of(arm, row.a))
        origin = [o + d * z + a * x for o, z, x in zip(origin, before, x, strict=True)]
        held = _product(held, _rotation_x(*ring.cos_sin(angle_of(arm, row.alpha))))
        rotation = _product(turned, held)
        frames.append(_frame(rotation, origin))
    return frames


def _frame(rotation: list[list], origin: list[PolyElement]) -> Frame:
    x, y, z = transposed(rotation)
    return Frame(x, y, z, origin)


def _rotation_z(c, s) -> list[list]:
    zero, one = 0 * c, 0 * c + 1
    return [[c, -s, zero], [s, c, zero], [zero, zero, one]]


def _rotation_x(c, s) -> list[list]:
    zero, one = 0 * c, 0 * c + 1
    return [[one, zero, zero], [zero, c, -s], [zero, s, c]]


def _product(left: list[list], right: list[list]) -> list[list]:
    columns = transposed(right)
    return [[sum(map(mul, row, column)) for column in columns] for row in left]


def transposed(rows: Sequence[list]) -> list[list]:
    return [list(column) for column in zip(*rows, strict=True)]


def cross(u: list, v: list) -> list:
    return [u[j] * v[k] - u[k] * v[j] for j, k in ((1, 2), (2, 0), (0, 1))]
