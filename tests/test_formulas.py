"""Test the short form of formulas: it keeps the value and reads as in a textbook."""

import re

import numpy as np
import pytest
import sympy as sp

from helpers import kinematics, statics, symbolic
from helpers.arm import ArmError
from helpers.formulas import abbreviate
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK

ARMS = {
    "Panda": PANDA,
    "Panda, joint 3 locked": PANDA.lock(3),
    "UR10e": UR10E,
    "UR10e of the homework": UR10E_HOMEWORK,
    "Stanford": STANFORD,
    "elbow": ELBOW,
    "elbow with an offset": ELBOW.with_values(d=0.1),
}
every_arm = pytest.mark.parametrize("arm", ARMS.values(), ids=ARMS)


def value_of(letter, q):
    """Return the value of a symbol such as c_{2-3}, from its name and the joint angles."""
    function, _, index = letter.name.partition("_")
    index = index.strip("{}")
    joints = [int(x) for x in re.findall(r"[+-]?\d+", index if "-" in index else "+".join(index))]
    angle = sum(np.sign(joint) * q[f"q_{abs(joint)}"] for joint in joints)
    return {"c": np.cos, "s": np.sin}[function](angle)


def numbers(arm, formula, q):
    """Return the matrix of numbers that a short formula gives at a pose."""
    known = {**arm.values, **dict(zip(arm.variables, q, strict=True))}
    if arm.bodies:
        known |= {symbol.name: value for symbol, value in symbolic.body_numbers(arm).items()}
    letters = sorted(formula.free_symbols, key=str)
    values = [known.get(x.name) if x.name in known else value_of(x, known) for x in letters]
    return np.array(sp.lambdify(letters, formula)(*values), dtype=float)


@every_arm
def test_short_form_has_the_numeric_value(arm):
    q = np.random.default_rng(4).uniform(-3, 3, arm.dof)
    pairs = [
        (symbolic.forward_kinematics(arm), kinematics.forward_kinematics(arm, q)),
        (symbolic.jacobian(arm), kinematics.jacobian(arm, q)),
    ]
    if arm.bodies:
        pairs.append((symbolic.gravity_torque(arm), statics.gravity_torque(arm, q)[:, None]))
    if arm.dof in (3, 6):
        det = np.linalg.det(kinematics.jacobian(arm, q)[: arm.dof])
        pairs.append((sp.Matrix([symbolic.determinant(arm)]), [[det]]))
    for formula, expected in pairs:
        np.testing.assert_allclose(
            numbers(arm, abbreviate(formula), q), expected, rtol=0, atol=1e-10
        )


@every_arm
def test_short_form_is_shorter_and_equal(arm):
    J = symbolic.jacobian(arm)
    named = J.xreplace({f: abbreviate(f) for f in J.atoms(sp.cos, sp.sin)})
    assert sp.count_ops(abbreviate(J)) < sp.count_ops(named)
    assert abbreviate(J).expand() == named.expand()


def test_short_form_of_random_polynomial_is_equal():
    letters = sp.symbols("g a_2 d_6 l_pen m_6 c_1 s_1 c_23 s_5 q_3")
    rng = np.random.default_rng(7)
    for _ in range(200):
        powers = rng.integers(0, 3, (rng.integers(2, 9), len(letters))) * (
            rng.random(len(letters)) < 0.6
        )
        numbers = rng.integers(-3, 4, len(powers))
        poly = sum(
            int(n) * sp.Mul(*(x ** int(k) for x, k in zip(letters, row, strict=True)))
            for n, row in zip(numbers, powers, strict=True)
        )
        poly = sp.sympify(poly) / int(rng.integers(1, 4))
        assert abbreviate(poly).expand() == poly.expand()


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ("cos(q_2 - q_3 + q_4)", "c_{2-3+4}"),
        ("cos(2*q_1) + sin(q_1 + 1)", "cos(2*q_1) + sin(q_1 + 1)"),
        ("cos(x) + sin(q_1)", "s_1 + cos(x)"),
        ("a*cos(q_1) - b*cos(q_1)", "(a - b)*c_1"),
        ("-a*cos(q_1) - b*sin(q_1)", "-a*c_1 - b*s_1"),
        ("2*a*cos(q_1) + 2*b*cos(q_1)", "2*(a + b)*c_1"),
        ("(b - a)*(a_2 - 1)*cos(q_2)", "(a - b)*(1 - a_2)*c_2"),
        ("(a + cos(q_1)*b)**2*a", "a*(a + b*c_1)**2"),
        ("sqrt(2)*cos(q_1)/2 + a**2*q_3", "a**2*q_3 + sqrt(2)*c_1/2"),
        ("m_2*(a_2*a_2*cos(q_1) + 2*a_2*cos(q_1))", "a_2*(2 + a_2)*m_2*c_1"),
        ("(d_6 + l_pen)*cos(q_1) + (d_6 + l_pen)*sin(q_1)", "(d_6 + l_pen)*(c_1 + s_1)"),
        ("3", "3"),
        ("0", "0"),
        ("x", "x"),
        ("pi/2", "pi/2"),
    ],
)
def test_short_form_of_formula(given, shown):
    assert str(abbreviate(sp.sympify(given))) == shown


def test_short_form_is_ordinary_sympy():
    a, b, c_1 = sp.symbols("a b c_1")
    formula = abbreviate((a + b) * sp.cos(sp.Symbol("q_1")))
    assert formula.subs(b, 2) == (a + 2) * c_1
    assert formula.diff(a) == c_1
    assert type(sp.expand(formula)) is sp.Add
    assert abbreviate(formula) == formula


def test_short_form_keeps_matrix_type():
    x = sp.cos(sp.Symbol("q_1"))
    assert isinstance(abbreviate(sp.Matrix([x])), sp.MutableDenseMatrix)
    assert isinstance(abbreviate(sp.ImmutableMatrix([x])), sp.ImmutableMatrix)


def test_ambiguous_joint_name_is_not_shortened():
    """c_12 is cos(q_1 + q_2), so cos(q_12) stays as it is."""
    q_1, q_2, q_12 = sp.symbols("q_1 q_2 q_12")
    assert str(abbreviate(sp.cos(q_1 + q_2) * sp.cos(q_12))) == "c_12*cos(q_12)"


@pytest.mark.parametrize("given", ["x", 3, None, np.eye(2)])
def test_short_rejects_other_types(given):
    with pytest.raises(ArmError, match="expected one of SymPy, or a matrix of them"):
        abbreviate(given)
