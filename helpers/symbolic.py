"""The SymPy view: exact transforms, forward kinematics and Jacobians, short enough to read.

Nothing here calls ``simplify``. The work is done on polynomials in the cosines and sines of the joint
angles, each sin² replaced by 1 - cos², and angles about parallel axes are added before their cosine is
taken (q_2 + q_3 rather than c_2 c_3 - s_2 s_3). That form is unique, so equal expressions are identical.
A symbol whose value is 0 is left out of the formulas.
"""

from collections.abc import Sequence
from functools import reduce
from operator import mul
from typing import NamedTuple

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.rings import PolyElement, PolyRing

from helpers.arm import Arm, quarter_turns
from helpers.expressions import Entry, names
from helpers.inputs import ArmError, must_be, number, shown

Matrix = sp.ImmutableMatrix


def joint_symbols(arm: Arm) -> tuple[sp.Symbol, ...]:
    """The joint variables as SymPy symbols, in the order of ``arm.variables``."""
    must_be(arm, Arm, "arm")
    return tuple(sp.Symbol(name) for name in arm.variables)


def link_transforms(arm: Arm) -> list[Matrix]:
    """The matrices A_1 .. A_n, each 4x4, one per row of the table.

    Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, equation (3.10).
    """
    must_be(arm, Arm, "arm")
    return [_link_transform(arm, i) for i in range(len(arm.rows))]


def link_frames(arm: Arm) -> list[Matrix]:
    """The transforms T_00 .. T_0n from base to each link frame, each 4x4 (lengths in m, angles in rad)."""
    ring = _Ring(arm)
    return [ring.matrix([*_transposed(frame), [0, 0, 0, 1]]) for frame in _frames(arm, ring)]


def forward_kinematics(arm: Arm) -> Matrix:
    """The tip's pose T_0n in the base frame, 4x4."""
    return link_frames(arm)[-1]


def jacobian(arm: Arm) -> Matrix:
    """The tip's Jacobian by geometry, 6 x dof: z_{i-1} x (o_n - o_{i-1}) over z_{i-1}.

    Rows are (vx, vy, vz, wx, wy, wz) in the base frame; a prismatic joint has z_{i-1} over 0.
    Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    ring = _Ring(arm)
    frames = _frames(arm, ring)
    tip = frames[-1].origin
    columns = []
    for i in arm.joints:
        z, origin = frames[i - 1].z, frames[i - 1].origin
        if arm.rows[i - 1].joint.kind == "revolute":
            columns.append(_cross(z, [t - o for t, o in zip(tip, origin, strict=True)]) + z)
        else:
            columns.append(z + [ring.zero] * 3)
    return ring.matrix(_transposed(columns))


def jacobian_by_differentiation(arm: Arm) -> Matrix:
    """The tip's Jacobian, 6 x dof, from derivatives of the tip's pose alone; no joint axis has a part in it.

    Above, the derivatives of the position. Below, the angular velocity w in dR/dq_i R^T = S(w), with S(w) the skew matrix
    of w x: three of its entries are w. Source: Spong, Hutchinson and Vidyasagar, section 4.4.
    """
    ring = _Ring(arm)
    tip = _frames(arm, ring)[-1]
    R = _transposed([tip.x, tip.y, tip.z])
    columns = []
    for i in arm.joints:
        linear = [ring.derivative(component, i) for component in tip.origin]
        rates = [[ring.derivative(entry, i) for entry in row] for row in R]
        angular = [sum(map(mul, rates[j], R[k]), ring.zero) for j, k in ((2, 1), (0, 2), (1, 0))]
        columns.append(linear + angular)
    return ring.matrix(_transposed(columns))


def determinant(arm: Arm) -> sp.Expr:
    """The determinant of the Jacobian, factored; singular poses are where a factor is 0.

    For an arm of six joints det J, for one of three the determinant of the linear rows. It does not depend on the
    frame nor on the point that the Jacobian is taken in, so it is taken halfway up the arm, where entries are short.
    Raises ArmError for another number of joints. Source: Spong, Hutchinson and Vidyasagar, section 4.9.
    """
    must_be(arm, Arm, "arm")
    if arm.dof not in (3, 6):
        raise ArmError(
            f"{arm.name} has {arm.dof} joints; a determinant needs 3 (position only) or 6"
        )
    ring = _Ring(arm, joined=False)
    frames = _frames(arm, ring)
    middle = frames[len(frames) // 2 if arm.dof == 6 else -1]
    columns = [_column_in(middle, arm, ring, frames[i - 1], i)[: arm.dof] for i in arm.joints]
    matrix = DomainMatrix(_transposed(columns), (arm.dof, arm.dof), ring.zero.ring.to_domain())
    content, factors = (
        matrix.det().factor_list()
    )  # before sin² is replaced: that would hide factors
    joined = _Ring(arm)
    choices = [
        (ring.expression(f), joined.expression(joined.taken_over(f, ring)), n) for f, n in factors
    ]
    return sp.Mul(content, *(min(own, other, key=sp.count_ops) ** n for own, other, n in choices))


def _column_in(
    frame: "_Frame", arm: Arm, ring: "_Ring", before: "_Frame", i: int
) -> list[PolyElement]:
    """A Jacobian column for the point and the axes of a frame, reduced at once so that it stays short."""
    lever = [t - o for t, o in zip(frame.origin, before.origin, strict=True)]
    turns = arm.rows[i - 1].joint.kind == "revolute"
    halves = (_cross(before.z, lever), before.z) if turns else (before.z, [ring.zero] * 3)
    return [ring.reduced(sum(map(mul, axis, half))) for half in halves for axis in frame[:3]]


def potential_energy(arm: Arm) -> sp.Expr:
    """P = g sum m_i h_i in the symbols g, m_i and (x_i, y_i, z_i), h_i being the height of link i's centre of mass.

    A coordinate or mass that is 0 is left out; ``body_numbers(arm)`` gives the others' values. Raises ArmError where the
    arm has no masses.
    """
    ring = _Ring(arm, extra=_body_symbols(arm))
    return ring.expression(_energy(arm, ring))


def gravity_torque(arm: Arm) -> Matrix:
    """g(q) = dP/dq, dof x 1, in the symbols of `potential_energy`."""
    ring = _Ring(arm, extra=_body_symbols(arm))
    energy = _energy(arm, ring)
    return ring.matrix([[ring.derivative(energy, i)] for i in arm.joints])


def body_numbers(arm: Arm, gravity: float = 9.81) -> dict[sp.Symbol, float]:
    """The numbers (kg, m, m/s^2) of the symbols m_i, x_i, y_i, z_i and g, to substitute in a formula."""
    must_be(arm, Arm, "arm")
    numbers = {sp.Symbol("g"): number(gravity, "gravity", "a finite number of m/s^2")}
    for i, body in enumerate(arm.bodies, 1):
        for name, entry in zip("mxyz", (body.mass, *body.com), strict=True):
            if value := arm.number(entry):
                numbers[sp.Symbol(f"{name}_{i}")] = value
    return numbers


def _body_symbols(arm: Arm) -> list[sp.Symbol]:
    must_be(arm, Arm, "arm")
    if not arm.bodies:
        raise ArmError(f"{arm.name} has no masses; give bodies, one Body for each row")
    return list(body_numbers(arm))


def _energy(arm: Arm, ring: "_Ring") -> PolyElement:
    """g sum m_i (o_z + x_i x_z + y_i y_z + z_i z_z), the third components of the link frames' columns."""
    known = set(_body_symbols(arm))

    def letter(name: str) -> PolyElement:
        return ring.length(sp.Symbol(name)) if sp.Symbol(name) in known else ring.zero

    total = ring.zero
    for i, frame in enumerate(_frames(arm, ring)[1:], 1):
        height = frame.origin[2] + sum(
            letter(f"{c}_{i}") * axis[2] for c, axis in zip("xyz", frame[:3], strict=True)
        )
        total += letter(f"m_{i}") * height
    return ring.reduced(ring.length(sp.Symbol("g")) * total)


def short(expression):
    """`expression` with cos(q_2 + q_3) written c_23 and sin(q_1) written s_1, as textbooks do."""
    _must_be_expression(expression)
    functions = {f: _index(f.args[0]) for f in expression.atoms(sp.cos, sp.sin)}
    return expression.xreplace(
        {f: sp.Symbol(f"{f.func.__name__[0]}_{index}") for f, index in functions.items() if index}
    )


def with_numbers(arm: Arm, expression):
    """`expression` with the arm's values (m, rad, kg) for its symbols; only joint variables are left."""
    must_be(arm, Arm, "arm")
    _must_be_expression(expression)
    return expression.xreplace({sp.Symbol(name): sp.Float(value) for name, value in arm.values})


def _must_be_expression(given: object) -> None:
    if not isinstance(given, sp.Basic | sp.MatrixBase):
        raise ArmError(f"expression is {shown(given)}; expected one of SymPy, or a matrix of them")


# A link's own matrix


def _link_transform(arm: Arm, i: int) -> Matrix:
    row = arm.rows[i]
    a, alpha, d, theta = (_formula(arm, e) for e in (row.a, row.alpha, row.d, row.theta))
    variable = sp.Symbol(f"q_{i + 1}")
    theta += variable if row.joint.kind == "revolute" else 0
    d += variable if row.joint.kind == "prismatic" else 0
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return Matrix(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


def _formula(arm: Arm, entry: Entry) -> sp.Expr:
    """A table entry in SymPy, exact; a symbol stays a symbol unless its value is 0."""
    values = dict(arm.values)
    symbols = {name: sp.Symbol(name) if values[name] else sp.S.Zero for name in names(entry)}
    return sp.sympify(str(entry), locals=symbols, rational=True)


def _angle(arm: Arm, entry: Entry) -> tuple[sp.Expr, int]:
    """An angle as (rest, quarter turns): one of the two is 0."""
    turns = None if names(entry) else quarter_turns(arm.number(entry))
    return (_formula(arm, entry), 0) if turns is None else (sp.S.Zero, turns)


# The chain as polynomials


class _Frame(NamedTuple):
    """A link frame's columns, each a list of three polynomials."""

    x: list[PolyElement]
    y: list[PolyElement]
    z: list[PolyElement]
    origin: list[PolyElement]


class _Turn(NamedTuple):
    """How far a run of parallel axes has turned at a row, as (formula, quarter turns)."""

    angle: tuple[sp.Expr, int]
    starts: bool


def _turns(arm: Arm, joined: bool = True) -> list[_Turn]:
    """How far each row has turned; unless `joined`, every joint starts a run of its own."""
    turns, held, formula, quarters = [], np.eye(3), sp.S.Zero, 0
    for i, (row, numeric) in enumerate(zip(arm.rows, arm.numeric, strict=True), 1):
        starts = numeric.kind == "revolute" and not (joined and abs(held[2, 2]) > 1 - 1e-12)
        if starts:
            held, formula, quarters = np.eye(3), sp.S.Zero, 0
        if numeric.kind == "revolute":
            sign, (rest, more) = round(held[2, 2]), _angle(arm, row.theta)
            formula, quarters = (
                formula + sign * (sp.Symbol(f"q_{i}") + rest),
                quarters + sign * more,
            )
        else:
            held = held @ np.array(_rotation_z(numeric.cos_theta, numeric.sin_theta))
        held = held @ np.array(_rotation_x(numeric.cos_alpha, numeric.sin_alpha))
        turns.append(_Turn((formula, quarters), starts))
    return turns


class _Ring:
    """Polynomials in an arm's lengths and in the cosines and sines of its angles, in a unique form."""

    def __init__(self, arm: Arm, joined: bool = True, extra: Sequence[sp.Symbol] = ()) -> None:
        must_be(arm, Arm, "arm")
        self.turns = _turns(arm, joined)
        angles = {turn.angle[0] for turn in self.turns}
        angles |= {_angle(arm, e)[0] for row in arm.rows for e in (row.alpha, row.theta)}
        angles = sorted(angles - {sp.S.Zero}, key=sp.default_sort_key)
        letters = {
            s for row in arm.rows for e in (row.a, row.d) for s in _formula(arm, e).free_symbols
        }
        letters |= {
            sp.Symbol(f"q_{i}") for i in arm.joints if arm.rows[i - 1].joint.kind == "prismatic"
        }
        letters = sorted(letters | set(extra), key=sp.default_sort_key)
        # Sines come first, so that sin² is the leading term of sin² + cos² - 1 and division removes it.
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
                f"the length {formula} is no polynomial in the arm's symbols; expected sums and products"
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

    def matrix(self, rows: list[list[PolyElement | int]]) -> Matrix:
        """A matrix of expressions from rows of polynomials."""
        return Matrix([[self.expression(self._ring(entry)) for entry in row] for row in rows])

    def expression(self, poly: PolyElement) -> sp.Expr:
        """A polynomial as a SymPy expression in its unique form."""
        return self.reduced(poly).as_expr(*self._symbols)

    def reduced(self, poly: PolyElement) -> PolyElement:
        """The unique form of a polynomial: no sine squared."""
        return self._ring(poly).rem(self._units) if self._units else self._ring(poly)

    def taken_over(self, poly: PolyElement, other: "_Ring") -> PolyElement:
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


def _frames(arm: Arm, ring: _Ring) -> list[_Frame]:
    """The link frames from base to tip.

    A frame's rotation is start * Rot_z(angle) * held: `start` is where the run of parallel axes began,
    `angle` what the run has turned by so far, `held` the constant rotations since.
    """
    unit = _rotation_z(ring.one, ring.zero)
    start, held, rotation, origin = unit, unit, unit, [ring.zero] * 3
    frames = [_Frame(*_transposed(unit), origin)]
    for i, (row, turn) in enumerate(zip(arm.rows, ring.turns, strict=True), 1):
        before, d = _transposed(rotation)[2], ring.length(_formula(arm, row.d))
        if turn.starts:
            start, held = rotation, unit
        if row.joint.kind == "prismatic":
            d += ring.length(sp.Symbol(f"q_{i}"))
        if row.joint.kind != "revolute":
            held = _product(held, _rotation_z(*ring.cos_sin(_angle(arm, row.theta))))
        turned = _product(start, _rotation_z(*ring.cos_sin(turn.angle)))
        x, a = _transposed(_product(turned, held))[0], ring.length(_formula(arm, row.a))
        origin = [o + d * z + a * x for o, z, x in zip(origin, before, x, strict=True)]
        held = _product(held, _rotation_x(*ring.cos_sin(_angle(arm, row.alpha))))
        rotation = _product(turned, held)
        frames.append(_Frame(*_transposed(rotation), origin))
    return frames


def _rotation_z(c, s) -> list[list]:
    zero, one = 0 * c, 0 * c + 1
    return [[c, -s, zero], [s, c, zero], [zero, zero, one]]


def _rotation_x(c, s) -> list[list]:
    zero, one = 0 * c, 0 * c + 1
    return [[one, zero, zero], [zero, c, -s], [zero, s, c]]


def _product(left: list[list], right: list[list]) -> list[list]:
    columns = _transposed(right)
    return [[sum(map(mul, row, column)) for column in columns] for row in left]


def _transposed(rows: list[list]) -> list[list]:
    return [list(column) for column in zip(*rows, strict=True)]


def _cross(u: list, v: list) -> list:
    return [u[j] * v[k] - u[k] * v[j] for j, k in ((1, 2), (2, 0), (0, 1))]


def _index(angle: sp.Expr) -> str:
    """The index of a short name: ``23`` for q_2 + q_3, ``{2-3+4}`` where signs differ, nothing if it is no sum."""
    terms = [term.as_coeff_Mul() for term in sorted(sp.Add.make_args(angle), key=_joint_number)]
    if not all(c in (1, -1) and str(s).startswith("q_") for c, s in terms):
        return ""
    signs = "".join(("-" if c < 0 else "+") + str(s)[2:] for c, s in terms)
    return signs.replace("+", "") if "-" not in signs else "{" + signs.removeprefix("+") + "}"


def _joint_number(term: sp.Expr) -> str:
    return str(term.as_coeff_Mul()[1])
