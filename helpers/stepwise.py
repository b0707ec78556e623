"""Compute formulas in named steps, for arms whose written-out formulas are too long.

A written-out pose grows by a factor with each joint. In steps, an entry of frame i is a sum of at
most three entries of frame i - 1, each of which has a name, so that all formulas of an arm of n
joints have a length that grows with n². `helpers.symbolic` writes formulas out.
"""

from typing import NamedTuple

import sympy as sp

from helpers.arm import Arm
from helpers.expressions import Entry
from helpers.inputs import require_type
from helpers.polynomials import (
    Matrix,
    cross_product,
    exact_angle,
    exact_formula,
    transpose,
)
from helpers.symbolic import body_numbers

Vector = list[sp.Expr]
Definitions = dict[sp.Symbol, sp.Expr]

__all__ = ["StepwiseFormulas", "stepwise_formulas"]


class StepwiseFormulas(NamedTuple):
    """Formulas of an arm in which names abbreviate entries of its frames.

    Attributes:
        definitions: Each name's formula in names before it: x_3y is entry y of x_3.
        frames: The transforms T_00 .. T_0n, each 4x4, in names of the frame before.
        jacobian: The tip's geometric Jacobian in the base frame, 6 x dof.
        energy: The potential energy, in the symbols of `symbolic.potential_energy`, or None.
        torque: The gravity torques, dof x 1, or None.
    """

    definitions: dict[sp.Symbol, sp.Expr]
    frames: list[Matrix]
    jacobian: Matrix
    energy: sp.Expr | None
    torque: Matrix | None


def stepwise_formulas(arm: Arm) -> StepwiseFormulas:
    """Compute the frames, the Jacobian and the gravity torques in named steps.

    Example:
        >>> from helpers.robots import ELBOW
        >>> steps = stepwise_formulas(ELBOW)
        >>> steps.frames[3][2, 3]
        a_3*x_3z + o_2z
        >>> steps.definitions[sp.Symbol("x_3z")]
        sin(q_2)*cos(q_3) + sin(q_3)*cos(q_2)
    """
    require_type(arm, Arm, "arm")
    definitions: Definitions = {}
    zero, one = sp.S.Zero, sp.S.One
    named = [[[one, zero, zero], [zero, one, zero], [zero, zero, one], [zero] * 3]]
    frames = [_join_columns(named[0])]
    for i in range(1, len(arm.rows) + 1):
        row, (x, y, z, origin) = arm.rows[i - 1], named[-1]
        is_revolute = row.joint.kind == "revolute"
        c, s = _cos_sin(arm, row.theta, sp.Symbol(f"q_{i}") if is_revolute else zero)
        c_alpha, s_alpha = _cos_sin(arm, row.alpha)
        turned = [c * v - s * u for u, v in zip(x, y, strict=True)]
        axes = [
            [c * u + s * v for u, v in zip(x, y, strict=True)],
            [c_alpha * v + s_alpha * w for v, w in zip(turned, z, strict=True)],
            [c_alpha * w - s_alpha * v for v, w in zip(turned, z, strict=True)],
        ]
        names = [
            _name_entries(axis, f"{c}_{i}", definitions)
            for c, axis in zip("xyz", axes, strict=True)
        ]
        d, a = exact_formula(arm, row.d), exact_formula(arm, row.a)
        if row.joint.kind == "prismatic":
            d += sp.Symbol(f"q_{i}")
        tip = [o + d * w + a * u for o, w, u in zip(origin, z, names[0], strict=True)]
        frames.append(_join_columns([*axes, tip]))
        named.append([*names, _name_entries(tip, f"o_{i}", definitions)])
    columns = []
    for i in arm.joints:
        _, _, z, origin = named[i - 1]
        lever = [t - o for t, o in zip(named[-1][3], origin, strict=True)]
        slides = arm.rows[i - 1].joint.kind == "prismatic"
        columns.append([*z, zero, zero, zero] if slides else [*cross_product(z, lever), *z])
    jacobian = Matrix(transpose(columns))
    energy, torque = _compute_gravity(arm, named, definitions) if arm.bodies else (None, None)
    return StepwiseFormulas(definitions, frames, jacobian, energy, torque)


def _cos_sin(arm: Arm, entry: Entry, variable: sp.Expr = sp.S.Zero) -> tuple[sp.Expr, sp.Expr]:
    """Compute the exact cosine and sine of a constant angle plus a joint variable."""
    formula, turns = exact_angle(arm, entry)
    c, s = sp.cos(formula + variable), sp.sin(formula + variable)
    return ((c, s), (-s, c), (-c, -s), (s, -c))[turns % 4]


def _name_entries(vector: Vector, name: str, definitions: Definitions) -> Vector:
    """Return names for a vector's entries, defined in `definitions`.

    Short entries stay.
    """
    names = []
    for axis, formula in zip("xyz", vector, strict=True):
        is_short = not isinstance(formula, sp.Add | sp.Mul) or (-formula).is_Atom
        names.append(formula if is_short else sp.Symbol(f"{name}{axis}"))
        if not is_short:
            definitions[names[-1]] = formula
    return names


def _join_columns(columns: list[Vector]) -> Matrix:
    """Return the 4x4 transform with these columns x, y, z and origin."""
    return Matrix([*transpose(columns), [0, 0, 0, 1]])


def _compute_gravity(
    arm: Arm, named: list[list[Vector]], definitions: Definitions
) -> tuple[sp.Expr, Matrix]:
    """Compute the potential energy and the gravity torques.

    The centre of mass of link i is named p_i. The torque of a revolute joint is the moment of the
    weights beyond it about its axis, the force of a prismatic joint their share along its axis.
    """
    symbols, g = {*body_numbers(arm)}, sp.Symbol("g")
    masses, centres = [], []
    for i, (*axes, origin) in enumerate(named[1:], 1):
        masses.append(m if (m := sp.Symbol(f"m_{i}")) in symbols else sp.S.Zero)
        offsets = [s if (s := sp.Symbol(f"{c}_{i}")) in symbols else sp.S.Zero for c in "xyz"]
        columns = transpose(axes)
        centre = [
            o + sum(u * v for u, v in zip(offsets, row, strict=True))
            for o, row in zip(origin, columns, strict=True)
        ]
        centres.append(_name_entries(centre, f"p_{i}", definitions) if masses[-1] else centre)
    torques = []
    for i in arm.joints:
        _, _, z, origin = named[i - 1]
        beyond = [*zip(masses, centres, strict=True)][i - 1 :]
        if arm.rows[i - 1].joint.kind == "prismatic":
            torques.append(g * z[2] * sum(masses[i - 1 :]))
        else:
            lever = [sum(m * (p[k] - origin[k]) for m, p in beyond) for k in (0, 1)]
            torques.append(g * (z[0] * lever[1] - z[1] * lever[0]))
    energy = g * sum(m * p[2] for m, p in zip(masses, centres, strict=True))
    return energy, Matrix(torques)
