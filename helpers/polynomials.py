"""Compute an arm's frames as polynomials in the cosines and sines of its angles.

Each sin² is replaced by 1 - cos², and angles about parallel axes are added before their cosine is
taken (q_2 + q_3 rather than c_2 c_3 - s_2 s_3). This form is unique: equal expressions are
identical, so nothing has to be simplified. A symbol whose value is 0 is left out.
"""

from collections.abc import Sequence
from functools import reduce
from operator import mul
from typing import NamedTuple

import numpy as np
import sympy as sp
from sympy.polys.rings import PolyElement, PolyRing

from helpers.arm import Arm
from helpers.expressions import Entry, symbol_names
from helpers.inputs import ArmError, require_type
from helpers.rows import quarter_turns

Matrix = sp.ImmutableMatrix


def exact_formula(arm: Arm, entry: Entry) -> sp.Expr:
    """Convert a table entry to an exact SymPy expression.

    A symbol of value 0 becomes 0.
    """
    values = dict(arm.values)
    symbols = {name: sp.Symbol(name) if values[name] else sp.S.Zero for name in symbol_names(entry)}
    return sp.sympify(str(entry), locals=symbols, rational=True)


def exact_angle(arm: Arm, entry: Entry) -> tuple[sp.Expr, int]:
    """Convert an angle to (formula, quarter turns), one of which is 0."""
    turns = None if symbol_names(entry) else quarter_turns(arm.number(entry))
    return (exact_formula(arm, entry), 0) if turns is None else (sp.S.Zero, turns)


class SymbolicFrame(NamedTuple):
    """The columns of a link frame, each a list of three polynomials."""

    x: list[PolyElement]
    y: list[PolyElement]
    z: list[PolyElement]
    origin: list[PolyElement]


class GroupAngle(NamedTuple):
    """The sum of joint angles by which a group of parallel axes has turned at a row.

    Attributes:
        angle: The angle as (formula, quarter turns).
        starts_group: Whether a new group begins with this row.
    """

    angle: tuple[sp.Expr, int]
    starts_group: bool


def group_angles(arm: Arm, add_parallel: bool = True) -> list[GroupAngle]:
    """Return, for each row, the angle by which its group of parallel axes has turned.

    Args:
        arm: The arm.
        add_parallel: Whether joints about parallel axes form one group; else each is a group.
    """
    angles, since, formula, quarters = [], np.eye(3), sp.S.Zero, 0
    for i, (row, numeric) in enumerate(zip(arm.rows, arm.numeric, strict=True), 1):
        # `since` is the constant rotation since the last joint. The axes of both joints are
        # parallel if it keeps the z axis parallel.
        is_parallel = add_parallel and abs(since[2, 2]) > 1 - 1e-12
        starts_group = numeric.kind == "revolute" and not is_parallel
        if starts_group:
            since, formula, quarters = np.eye(3), sp.S.Zero, 0
        if numeric.kind == "revolute":
            sign, (offset, more) = round(since[2, 2]), exact_angle(arm, row.theta)
            formula, quarters = (
                formula + sign * (sp.Symbol(f"q_{i}") + offset),
                quarters + sign * more,
            )
        else:
            since = since @ np.array(_rotation_z(numeric.cos_theta, numeric.sin_theta))
        since = since @ np.array(_rotation_x(numeric.cos_alpha, numeric.sin_alpha))
        angles.append(GroupAngle((formula, quarters), starts_group))
    return angles


# Measured sizes of sheets: five joints about skew axes (`expansion_factor` 2^9) need 0.8 to 1.6 MB;
# Kinova's Gen3, seven joints about perpendicular axes (2^6), needs 0.36 MB.
_LONGEST_READ = 2**8
_LONGEST_COMPUTED = 2**14  # seven skew joints (2^13) take 13 s, eight over 100 s


def expansion_factor(arm: Arm) -> int:
    """Estimate the factor by which the arm's last frame grows when it is written out.

    Each group of parallel axes doubles the number of terms, and so does each constant angle that is
    no multiple of a quarter turn.
    """
    skew = 0
    for row in arm.rows:
        constant = [row.alpha] if row.joint.kind == "revolute" else [row.alpha, row.theta]
        skew += sum(bool(exact_angle(arm, entry)[0]) for entry in constant)
    return 2 ** (skew + sum(angle.starts_group for angle in group_angles(arm)))


def is_long(arm: Arm) -> bool:
    """Return whether the arm's written-out formulas are too long to read."""
    return expansion_factor(arm) > _LONGEST_READ


class Ring:
    """Polynomials in an arm's lengths and the cosines and sines of its angles, in a unique form.

    Args:
        arm: The arm.
        add_parallel: Whether angles about parallel axes are added before their cosine is taken.
        extra: Further symbols of the ring, such as masses.
    """

    def __init__(
        self, arm: Arm, add_parallel: bool = True, extra: Sequence[sp.Symbol] = ()
    ) -> None:
        require_type(arm, Arm, "arm")
        if expansion_factor(arm) > _LONGEST_COMPUTED:
            raise ArmError(
                f"{arm.name} has too many joints about skew axes to write its formulas out;"
                " expected fewer, or stepwise.stepwise_formulas, which gives them in named steps"
            )
        self.group_angles = group_angles(arm, add_parallel)
        formulas = {angle.angle[0] for angle in self.group_angles}
        formulas |= {exact_angle(arm, e)[0] for row in arm.rows for e in (row.alpha, row.theta)}
        angles = sorted(formulas - {sp.S.Zero}, key=sp.default_sort_key)
        symbols = {
            s
            for row in arm.rows
            for e in (row.a, row.d)
            for s in exact_formula(arm, e).free_symbols
        }
        symbols |= {
            sp.Symbol(f"q_{i}") for i in arm.joints if arm.rows[i - 1].joint.kind == "prismatic"
        }
        lengths = sorted(symbols | set(extra), key=sp.default_sort_key)
        # Sines come first, so that sin² is the leading term of sin² + cos² - 1, and division by
        # this polynomial removes it.
        self._symbols = [f(angle) for f in (sp.sin, sp.cos) for angle in angles] + lengths
        self._ring = PolyRing([sp.Dummy() for _ in self._symbols], sp.QQ, sp.lex)
        gens, n = self._ring.gens, len(angles)
        self._pairs = dict(zip(angles, zip(gens[n : 2 * n], gens[:n], strict=True), strict=True))
        self._lengths = dict(zip(lengths, gens[2 * n :], strict=True))
        self._units = [c**2 + s**2 - 1 for c, s in self._pairs.values()]
        self.zero, self.one = self._ring.zero, self._ring.one

    def cos_sin(self, angle: tuple[sp.Expr, int]) -> tuple[PolyElement, PolyElement]:
        """Return the cosine and sine of an angle given as (formula, quarter turns)."""
        formula, turns = angle
        c, s = self._pairs[formula] if formula else (self.one, self.zero)
        return ((c, s), (-s, c), (-c, -s), (s, -c))[turns % 4]

    def length(self, formula: sp.Expr) -> PolyElement:
        """Return a length as a polynomial.

        Raises ArmError if it is no polynomial in the arm's symbols.
        """
        if not formula.is_polynomial() or formula.has(sp.pi):
            raise ArmError(
                f"the length {formula} is no polynomial in the arm's symbols; expected sums and"
                " products"
            )
        total = self.zero
        for term in sp.Add.make_args(sp.expand(formula)):
            number, factors = term.as_coeff_mul()
            powers = [
                self._lengths[base] ** int(n) for base, n in (f.as_base_exp() for f in factors)
            ]
            total += reduce(mul, powers, self.one * number)
        return total

    def derivative(self, poly: PolyElement, joint: int) -> PolyElement:
        """Differentiate with respect to the variable of a joint, counted from 1."""
        variable = sp.Symbol(f"q_{joint}")
        total = poly.diff(self._lengths[variable]) if variable in self._lengths else self.zero
        for angle, (c, s) in self._pairs.items():
            if rate := int(angle.diff(variable)):
                total += rate * (poly.diff(s) * c - poly.diff(c) * s)
        return total

    def matrix(self, rows: list[list[PolyElement | int]]) -> sp.ImmutableMatrix:
        """Convert rows of polynomials to a matrix of expressions."""
        return Matrix([[self.expression(self._ring(entry)) for entry in row] for row in rows])

    def expression(self, poly: PolyElement) -> sp.Expr:
        """Convert a polynomial to a SymPy expression in its unique form."""
        return self.reduced(poly).as_expr(*self._symbols)

    def reduced(self, poly: PolyElement) -> PolyElement:
        """Replace each sin² by 1 - cos², which gives a polynomial's unique form."""
        return self._ring(poly).rem(self._units) if self._units else self._ring(poly)

    def convert(self, poly: PolyElement, other: "Ring") -> PolyElement:
        """Convert a polynomial of the same arm's ring that was made with add_parallel=False."""
        values = dict(zip(self._symbols, self._ring.gens, strict=True)) | self._single_joints()
        powers = [values[symbol] for symbol in other._symbols]
        terms = (
            reduce(mul, (g**n for g, n in zip(powers, monomial, strict=True)), self.one * number)
            for monomial, number in poly.terms()
        )
        return self.reduced(sum(terms, self.zero))

    def _single_joints(self) -> dict[sp.Expr, PolyElement]:
        """Return cos(q_i) and sin(q_i), q_i being the difference of two angles of its group."""
        values, before = {}, sp.S.Zero
        for i, angle_so_far in enumerate(self.group_angles, 1):
            formula = angle_so_far.angle[0]
            start = sp.S.Zero if angle_so_far.starts_group else before
            if sign := int((formula - start).coeff(sp.Symbol(f"q_{i}"))):
                (c, s), (c_0, s_0) = self.cos_sin((formula, 0)), self.cos_sin((start, 0))
                angle = sp.expand(sign * (formula - start))
                values[sp.cos(angle)], values[sp.sin(angle)] = (
                    c * c_0 + s * s_0,
                    sign * (s * c_0 - c * s_0),
                )
            before = formula
        return values


def symbolic_frames(arm: Arm, ring: Ring) -> list[SymbolicFrame]:
    """Compute the link frames from the base to the tip.

    A frame's rotation is start * Rot_z(angle) * since: `start` is the rotation at which the group
    of parallel axes begins, `angle` what the group has turned by so far, and `since` the product of
    the constant rotations since then.
    """
    unit = _rotation_z(ring.one, ring.zero)
    start, since, rotation, origin = unit, unit, unit, [ring.zero] * 3
    frames = [_frame(unit, origin)]
    for i, (row, group) in enumerate(zip(arm.rows, ring.group_angles, strict=True), 1):
        before, d = transpose(rotation)[2], ring.length(exact_formula(arm, row.d))
        if group.starts_group:
            start, since = rotation, unit
        if row.joint.kind == "prismatic":
            d += ring.length(sp.Symbol(f"q_{i}"))
        if row.joint.kind != "revolute":
            since = _product(since, _rotation_z(*ring.cos_sin(exact_angle(arm, row.theta))))
        turned = _product(start, _rotation_z(*ring.cos_sin(group.angle)))
        x, a = transpose(_product(turned, since))[0], ring.length(exact_formula(arm, row.a))
        origin = [o + d * z + a * x for o, z, x in zip(origin, before, x, strict=True)]
        since = _product(since, _rotation_x(*ring.cos_sin(exact_angle(arm, row.alpha))))
        rotation = _product(turned, since)
        frames.append(_frame(rotation, origin))
    return frames


def _frame(rotation: list[list], origin: list[PolyElement]) -> SymbolicFrame:
    x, y, z = transpose(rotation)
    return SymbolicFrame(x, y, z, origin)


def _rotation_z(c, s) -> list[list]:
    zero, one = 0 * c, 0 * c + 1
    return [[c, -s, zero], [s, c, zero], [zero, zero, one]]


def _rotation_x(c, s) -> list[list]:
    zero, one = 0 * c, 0 * c + 1
    return [[one, zero, zero], [zero, c, -s], [zero, s, c]]


def _product(left: list[list], right: list[list]) -> list[list]:
    columns = transpose(right)
    return [[sum(map(mul, row, column)) for column in columns] for row in left]


def transpose(rows: Sequence[list]) -> list[list]:
    """Transpose a matrix given as a list of rows."""
    return [list(column) for column in zip(*rows, strict=True)]


def cross_product(u: list, v: list) -> list:
    """Compute u x v."""
    return [u[j] * v[k] - u[k] * v[j] for j, k in ((1, 2), (2, 0), (0, 1))]
