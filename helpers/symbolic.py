"""The SymPy view: exact transforms, forward kinematics and Jacobians, short enough to read.

Nothing here calls ``simplify``. The work is done on polynomials in the cosines and sines of the
joint angles, each sin² replaced by 1 - cos², and angles about parallel axes are added before their
cosine is taken (q_2 + q_3 rather than c_2 c_3 - s_2 s_3). That form is unique, so equal expressions
are identical. A symbol whose value is 0 is left out of the formulas.
"""

from operator import mul

import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.rings import PolyElement

from helpers.arm import Arm
from helpers.formulas import must_be_expression, short
from helpers.inputs import ArmError, must_be, number
from helpers.polynomials import Frame, Matrix, Ring, cross, formula_of, frames_of, transposed

__all__ = [
    "body_numbers",
    "determinant",
    "forward_kinematics",
    "gravity_torque",
    "jacobian",
    "jacobian_by_differentiation",
    "joint_symbols",
    "link_frames",
    "link_transforms",
    "potential_energy",
    "short",
    "with_numbers",
]


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
    """The transforms T_00 .. T_0n from base to each link frame, each 4x4 (lengths in m, angles in
    rad)."""
    ring = Ring(arm)
    return [ring.matrix([*transposed(frame), [0, 0, 0, 1]]) for frame in frames_of(arm, ring)]


def forward_kinematics(arm: Arm) -> Matrix:
    """The tip's pose T_0n in the base frame, 4x4."""
    return link_frames(arm)[-1]


def jacobian(arm: Arm) -> Matrix:
    """The tip's Jacobian by geometry, 6 x dof: z_{i-1} x (o_n - o_{i-1}) over z_{i-1}.

    Rows are (vx, vy, vz, wx, wy, wz) in the base frame; a prismatic joint has z_{i-1} over 0.
    Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    ring = Ring(arm)
    frames = frames_of(arm, ring)
    tip = frames[-1].origin
    columns = []
    for i in arm.joints:
        z, origin = frames[i - 1].z, frames[i - 1].origin
        if arm.rows[i - 1].joint.kind == "revolute":
            columns.append(cross(z, [t - o for t, o in zip(tip, origin, strict=True)]) + z)
        else:
            columns.append(z + [ring.zero] * 3)
    return ring.matrix(transposed(columns))


def jacobian_by_differentiation(arm: Arm) -> Matrix:
    """The tip's Jacobian, 6 x dof, from derivatives of its pose; no joint axis has a part in it.

    Above, the derivatives of the position. Below, the angular velocity w in dR/dq_i R^T = S(w),
    with S(w) the skew matrix of w x: three of its entries are w. Source: Spong, Hutchinson and
    Vidyasagar, section 4.4.
    """
    ring = Ring(arm)
    tip = frames_of(arm, ring)[-1]
    R = transposed([tip.x, tip.y, tip.z])
    columns = []
    for i in arm.joints:
        linear = [ring.derivative(component, i) for component in tip.origin]
        rates = [[ring.derivative(entry, i) for entry in row] for row in R]
        angular = [sum(map(mul, rates[j], R[k]), ring.zero) for j, k in ((2, 1), (0, 2), (1, 0))]
        columns.append(linear + angular)
    return ring.matrix(transposed(columns))


def determinant(arm: Arm) -> sp.Expr:
    """The determinant of the Jacobian, factored; singular poses are where a factor is 0.

    For an arm of six joints det J, for one of three the determinant of the tip's linear rows. Both
    are the same in the axes of any frame, and det J for any point of the last link too, so that it
    is taken halfway up the arm, where entries are short. Raises ArmError for another number of
    joints. Source: Spong, Hutchinson and Vidyasagar, section 4.9.
    """
    must_be(arm, Arm, "arm")
    if arm.dof not in (3, 6):
        raise ArmError(
            f"{arm.name} has {arm.dof} joints; a determinant needs 3 (position only) or 6"
        )
    ring = Ring(arm, joined=False)
    frames = frames_of(arm, ring)
    middle = frames[len(frames) // 2 if arm.dof == 6 else -1]
    columns = [_column_in(middle, arm, ring, frames[i - 1], i)[: arm.dof] for i in arm.joints]
    matrix = DomainMatrix(transposed(columns), (arm.dof, arm.dof), ring.zero.ring.to_domain())
    content, factors = (
        matrix.det().factor_list()
    )  # before sin² is replaced: that would hide factors
    joined = Ring(arm)
    choices = [
        (ring.expression(f), joined.expression(joined.taken_over(f, ring)), n) for f, n in factors
    ]
    return sp.Mul(content, *(min(own, other, key=sp.count_ops) ** n for own, other, n in choices))


def _column_in(frame: Frame, arm: Arm, ring: Ring, before: Frame, i: int) -> list[PolyElement]:
    """A Jacobian column for the point and the axes of a frame, reduced at once so that it stays
    short."""
    lever = [t - o for t, o in zip(frame.origin, before.origin, strict=True)]
    turns = arm.rows[i - 1].joint.kind == "revolute"
    halves = (cross(before.z, lever), before.z) if turns else (before.z, [ring.zero] * 3)
    return [ring.reduced(sum(map(mul, axis, half))) for half in halves for axis in frame[:3]]


def potential_energy(arm: Arm) -> sp.Expr:
    """P = g sum m_i h_i in the symbols g, m_i and (x_i, y_i, z_i), h_i being the height of link i's
    centre of mass.

    A coordinate or mass that is 0 is left out; ``body_numbers(arm)`` gives the others' values.
    Raises ArmError where the arm has no masses.
    """
    ring = Ring(arm, extra=_body_symbols(arm))
    return ring.expression(_energy(arm, ring))


def gravity_torque(arm: Arm) -> Matrix:
    """g(q) = dP/dq, dof x 1, in the symbols of `potential_energy`."""
    ring = Ring(arm, extra=_body_symbols(arm))
    energy = _energy(arm, ring)
    return ring.matrix([[ring.derivative(energy, i)] for i in arm.joints])


def body_numbers(arm: Arm, gravity: float = 9.81) -> dict[sp.Symbol, float]:
    """The numbers (kg, m, m/s^2) of the symbols m_i, x_i, y_i, z_i and g, to substitute in a
    formula."""
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


def _energy(arm: Arm, ring: Ring) -> PolyElement:
    """g sum m_i (o_z + x_i x_z + y_i y_z + z_i z_z), the third components of the link frames'
    columns."""
    known = set(_body_symbols(arm))

    def letter(name: str) -> PolyElement:
        return ring.length(sp.Symbol(name)) if sp.Symbol(name) in known else ring.zero

    total = ring.zero
    for i, frame in enumerate(frames_of(arm, ring)[1:], 1):
        height = frame.origin[2] + sum(
            letter(f"{c}_{i}") * axis[2] for c, axis in zip("xyz", frame[:3], strict=True)
        )
        total += letter(f"m_{i}") * height
    return ring.reduced(ring.length(sp.Symbol("g")) * total)


def with_numbers(arm: Arm, expression):
    """`expression` with the arm's values (m, rad, kg) for its symbols; only joint variables are
    left."""
    must_be(arm, Arm, "arm")
    must_be_expression(expression)
    return expression.xreplace(
        {sp.Symbol(name): sp.Float(value) for name, value in arm.values.items()}
    )


def _link_transform(arm: Arm, i: int) -> Matrix:
    row = arm.rows[i]
    a, alpha, d, theta = (formula_of(arm, e) for e in (row.a, row.alpha, row.d, row.theta))
    variable = sp.Symbol(f"q_{i + 1}")
    theta += variable if row.joint.kind == "revolute" else 0
    d += variable if row.joint.kind == "prismatic" else 0
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return Matrix(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )
