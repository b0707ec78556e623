"""Compute exact transforms, Jacobians and torques in SymPy, short enough to read.

No function calls ``simplify``. They compute with polynomials in the cosines and sines of the joint
angles (see `helpers.polynomials`), whose form is unique, so equal expressions are identical. A
symbol whose value is 0 is left out of the formulas.
"""

from operator import mul

import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.rings import PolyElement

from helpers.arm import Arm
from helpers.formulas import abbreviate, latex, latex_lines, require_expression
from helpers.inputs import ArmError, finite_number, require_type
from helpers.polynomials import (
    Matrix,
    Ring,
    SymbolicFrame,
    cross_product,
    exact_formula,
    is_long,
    symbolic_frames,
    transpose,
)

__all__ = [
    "abbreviate",
    "body_numbers",
    "determinant",
    "forward_kinematics",
    "gravity_torque",
    "jacobian",
    "jacobian_by_differentiation",
    "joint_symbols",
    "latex",
    "latex_lines",
    "link_frames",
    "link_transforms",
    "potential_energy",
    "with_numbers",
]


def joint_symbols(arm: Arm) -> tuple[sp.Symbol, ...]:
    """Return the joint variables as SymPy symbols, in the order of ``arm.variables``.

    Example:
        >>> from helpers.robots import ELBOW
        >>> joint_symbols(ELBOW)
        (q_1, q_2, q_3)
    """
    require_type(arm, Arm, "arm")
    return tuple(sp.Symbol(name) for name in arm.variables)


def link_transforms(arm: Arm) -> list[Matrix]:
    """Compute the matrices A_1 .. A_n, each 4x4, one for each row of the table.

    Example:
        >>> from helpers.robots import ELBOW
        >>> abbreviate(link_transforms(ELBOW)[2])
        Matrix([
        [c_3, -s_3, 0, a_3*c_3],
        [s_3,  c_3, 0, a_3*s_3],
        [  0,    0, 1,       0],
        [  0,    0, 0,       1]])

    Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, equation (3.10).
    """
    require_type(arm, Arm, "arm")
    return [_link_transform(arm, i) for i in range(len(arm.rows))]


def link_frames(arm: Arm) -> list[Matrix]:
    """Compute the transforms T_00 .. T_0n from the base to each link frame, each 4x4.

    Example:
        >>> from helpers.robots import ELBOW
        >>> abbreviate(link_frames(ELBOW)[2][:3, 3])
        Matrix([
        [  a_2*c_1*c_2],
        [  a_2*c_2*s_1],
        [a_2*s_2 + d_1]])
    """
    ring = Ring(arm)
    return [ring.matrix([*transpose(frame), [0, 0, 0, 1]]) for frame in symbolic_frames(arm, ring)]


def forward_kinematics(arm: Arm) -> Matrix:
    """Compute the tip's pose T_0n in the base frame, 4x4.

    Example:
        >>> from helpers.robots import ELBOW
        >>> abbreviate(forward_kinematics(ELBOW)[2, 3])
        a_2*s_2 + a_3*s_23 + d_1
    """
    return link_frames(arm)[-1]


def jacobian(arm: Arm) -> Matrix:
    """Compute the tip's geometric Jacobian in the base frame, 6 x dof.

    The column of a revolute joint i is z_{i-1} x (o_n - o_{i-1}) over z_{i-1}, that of a prismatic
    joint z_{i-1} over 0. The rows are (vx, vy, vz, wx, wy, wz).

    Example:
        >>> from helpers.robots import ELBOW
        >>> abbreviate(jacobian(ELBOW)[2, :])
        Matrix([[0, a_2*c_2 + a_3*c_23, a_3*c_23]])

    Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    ring = Ring(arm)
    frames = symbolic_frames(arm, ring)
    tip = frames[-1].origin
    columns = []
    for i in arm.joints:
        z, origin = frames[i - 1].z, frames[i - 1].origin
        if arm.rows[i - 1].joint.kind == "revolute":
            columns.append(cross_product(z, [t - o for t, o in zip(tip, origin, strict=True)]) + z)
        else:
            columns.append(z + [ring.zero] * 3)
    return ring.matrix(transpose(columns))


def jacobian_by_differentiation(arm: Arm) -> Matrix:
    """Compute the tip's Jacobian, 6 x dof, by differentiating its pose.

    The upper rows are the derivatives of the position. The lower rows are the angular velocities w
    in dR/dq_i R^T = S(w); three entries of the skew-symmetric matrix S(w) are w.

    Example:
        >>> from helpers.robots import ELBOW
        >>> jacobian_by_differentiation(ELBOW) == jacobian(ELBOW)
        True

    Source: Spong, Hutchinson and
    Vidyasagar, section 4.4.
    """
    ring = Ring(arm)
    tip = symbolic_frames(arm, ring)[-1]
    R = transpose([tip.x, tip.y, tip.z])
    columns = []
    for i in arm.joints:
        linear = [ring.derivative(component, i) for component in tip.origin]
        rates = [[ring.derivative(entry, i) for entry in row] for row in R]
        angular = [sum(map(mul, rates[j], R[k]), ring.zero) for j, k in ((2, 1), (0, 2), (1, 0))]
        columns.append(linear + angular)
    return ring.matrix(transpose(columns))


def determinant(arm: Arm) -> sp.Expr:
    """Compute the Jacobian's determinant in factors.

    The arm is singular where a factor is 0.

    For an arm of six joints it is det J, for one of three joints the determinant of the linear
    rows. The axes of every frame give the same determinant, and so does, for six joints, every
    point of the last link. It is therefore computed in the frame halfway up the arm, where the
    entries are short.

    Raises:
        ArmError: The arm has another number of joints, or so many about skew axes that the
            determinant would be too long to read.

    Example:
        >>> from helpers.robots import ELBOW
        >>> abbreviate(determinant(ELBOW))
        -a_2*a_3*s_3*(a_2*c_2 + a_3*c_23)

    Source: Spong, Hutchinson and Vidyasagar, section 4.9.
    """
    require_type(arm, Arm, "arm")
    if arm.dof not in (3, 6):
        raise ArmError(
            f"{arm.name} has {arm.dof} joints; a determinant needs 3 (position only) or 6"
        )
    if is_long(arm):
        raise ArmError(
            f"{arm.name} has too many joints about skew axes to write its determinant out; expected"
            " fewer, or kinematics.manipulability, which gives it in numbers"
        )
    ring = Ring(arm, add_parallel=False)
    frames = symbolic_frames(arm, ring)
    middle = frames[len(frames) // 2 if arm.dof == 6 else -1]
    columns = [_column_in(middle, arm, ring, frames[i - 1], i)[: arm.dof] for i in arm.joints]
    matrix = DomainMatrix(transpose(columns), (arm.dof, arm.dof), ring.zero.ring.to_domain())
    # Factor before sin² is replaced by 1 - cos², which would hide factors.
    content, factors = matrix.det().factor_list()
    sums = Ring(arm)
    choices = [(ring.expression(f), sums.expression(sums.convert(f, ring)), n) for f, n in factors]
    shortest = (min(single, added, key=sp.count_ops) ** n for single, added, n in choices)
    return sp.Mul(content, *shortest)


def _column_in(
    frame: SymbolicFrame, arm: Arm, ring: Ring, before: SymbolicFrame, i: int
) -> list[PolyElement]:
    """Compute joint i's Jacobian column for the point and the axes of a frame."""
    lever = [t - o for t, o in zip(frame.origin, before.origin, strict=True)]
    is_revolute = arm.rows[i - 1].joint.kind == "revolute"
    halves = (
        (cross_product(before.z, lever), before.z) if is_revolute else (before.z, [ring.zero] * 3)
    )
    return [ring.reduced(sum(map(mul, axis, half))) for half in halves for axis in frame[:3]]


def potential_energy(arm: Arm) -> sp.Expr:
    """Compute the potential energy P = g sum m_i h_i, h_i being the height of link i's centre.

    Its symbols are g, the masses m_i and the centres of mass (x_i, y_i, z_i) in the link frames. A
    coordinate or mass that is 0 is left out; `body_numbers` gives the values of the others.

    Raises:
        ArmError: The arm has no masses.
    """
    ring = Ring(arm, extra=_body_symbols(arm))
    return ring.expression(_compute_energy(arm, ring))


def gravity_torque(arm: Arm) -> Matrix:
    """Compute g(q) = dP/dq, dof x 1, in the symbols of `potential_energy`."""
    ring = Ring(arm, extra=_body_symbols(arm))
    energy = _compute_energy(arm, ring)
    return ring.matrix([[ring.derivative(energy, i)] for i in arm.joints])


def body_numbers(arm: Arm, gravity: float = 9.81) -> dict[sp.Symbol, float]:
    """Return the values of the symbols m_i, x_i, y_i, z_i and g, in kg, m and m/s^2."""
    require_type(arm, Arm, "arm")
    values = {sp.Symbol("g"): finite_number(gravity, "gravity", "a finite number of m/s^2")}
    for i, body in enumerate(arm.bodies, 1):
        for name, entry in zip("mxyz", (body.mass, *body.com), strict=True):
            if value := arm.number(entry):
                values[sp.Symbol(f"{name}_{i}")] = value
    return values


def _body_symbols(arm: Arm) -> list[sp.Symbol]:
    require_type(arm, Arm, "arm")
    if not arm.bodies:
        raise ArmError(f"{arm.name} has no masses; give bodies, one Body for each row")
    return list(body_numbers(arm))


def _compute_energy(arm: Arm, ring: Ring) -> PolyElement:
    """Compute g sum m_i (o_z + x_i x_z + y_i y_z + z_i z_z) in a ring with these symbols.

    x_z, y_z, z_z and o_z are the third components of the columns of link frame i.
    """
    symbols = set(_body_symbols(arm))

    def element(name: str) -> PolyElement:
        return ring.length(sp.Symbol(name)) if sp.Symbol(name) in symbols else ring.zero

    total = ring.zero
    for i, frame in enumerate(symbolic_frames(arm, ring)[1:], 1):
        height = frame.origin[2] + sum(
            element(f"{c}_{i}") * axis[2] for c, axis in zip("xyz", frame[:3], strict=True)
        )
        total += element(f"m_{i}") * height
    return ring.reduced(ring.length(sp.Symbol("g")) * total)


def with_numbers(arm: Arm, expression):
    """Substitute the arm's values (m, rad, kg) for its symbols, leaving joint variables.

    Args:
        arm: The arm.
        expression: An expression of SymPy, or a matrix of them.

    Example:
        >>> from helpers.robots import ELBOW
        >>> with_numbers(ELBOW, forward_kinematics(ELBOW)[2, 3])
        0.4*sin(q_2) + 0.3*sin(q_2 + q_3) + 0.5
    """
    require_type(arm, Arm, "arm")
    require_expression(expression)
    return expression.xreplace(
        {sp.Symbol(name): sp.Float(value) for name, value in arm.values.items()}
    )


def _link_transform(arm: Arm, i: int) -> Matrix:
    row = arm.rows[i]
    a, alpha, d, theta = (exact_formula(arm, e) for e in (row.a, row.alpha, row.d, row.theta))
    variable = sp.Symbol(f"q_{i + 1}")
    theta += variable if row.joint.kind == "revolute" else 0
    d += variable if row.joint.kind == "prismatic" else 0
    c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
    return Matrix(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )
