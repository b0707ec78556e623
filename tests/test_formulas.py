"""Test the short form of formulas: it keeps the value and reads as in a textbook."""

import re

import numpy as np
import pytest
import sympy as sp

from helpers import kinematics, statics, symbolic
from helpers.arm import ArmError
from helpers.checks import check
from helpers.formulas import abbreviate, formula_latex
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
    """Return the matrix of numbers that a short formula gives at a configuration."""
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
        ("cos(2*q_1) + sin(q_1 + 1)", r"\cos{(2 q_{1})} + \sin{(1 + q_{1})}"),
        ("cos(x) + sin(q_1)", r"s_{1} + \cos{(x)}"),
        ("a*cos(q_1) - b*cos(q_1)", "(a - b) c_{1}"),
        ("-a*cos(q_1) - b*sin(q_1)", "- a c_{1} - b s_{1}"),
        ("2*a*cos(q_1) + 2*b*cos(q_1)", "2 (a + b) c_{1}"),
        ("2*a + 2*b", "2 (a + b)"),
        ("-a/2 - b/2", r"- \frac{a + b}{2}"),
        ("(b - a)*(a_2 - 1)*cos(q_2)", "(a - b) (1 - a_{2}) c_{2}"),
        ("(a + cos(q_1)*b)**2*a", "a (a + b c_{1})^{2}"),
        ("sqrt(2)*cos(q_1)/2 + a**2*q_3", r"a^{2} q_{3} + \frac{\sqrt{2} c_{1}}{2}"),
        ("m_2*(a_2*a_2*cos(q_1) + 2*a_2*cos(q_1))", "a_{2} (2 + a_{2}) m_{2} c_{1}"),
        ("(d_6 + l_pen)*cos(q_1) + (d_6 + l_pen)*sin(q_1)", "(d_{6} + l_{pen}) (c_{1} + s_{1})"),
        ("a*b/(c*cos(q_1))", r"\frac{a b}{c c_{1}}"),
        ("1/a", r"\frac{1}{a}"),
        ("0.5*cos(q_1)*a", "0.5 a c_{1}"),
        ("3", "3"),
        ("-3/2", r"- \frac{3}{2}"),
        ("0", "0"),
        ("x", "x"),
        ("pi/2", r"\frac{\pi}{2}"),
    ],
)
def test_latex_of_formula(given, shown):
    assert formula_latex(abbreviate(sp.sympify(given))) == shown


def test_short_form_equals_the_formula_typed_by_hand():
    a_2, a_3, c_1, c_2, c_23, s_1, s_2, s_23 = sp.symbols("a_2 a_3 c_1 c_2 c_23 s_1 s_2 s_23")
    reach = a_2 * c_2 + a_3 * c_23
    by_hand = sp.Matrix([
        [-s_1 * reach, -c_1 * (a_2 * s_2 + a_3 * s_23), -a_3 * c_1 * s_23],
        [c_1 * reach, -s_1 * (a_2 * s_2 + a_3 * s_23), -a_3 * s_1 * s_23],
        [0, reach, a_3 * c_23],
    ])  # fmt: skip
    by_helpers = abbreviate(symbolic.jacobian(ELBOW)[:3, :])
    assert by_helpers == by_hand
    assert by_helpers - by_hand == sp.zeros(3, 3)
    check("the linear rows of J", by_helpers, by_hand)


@every_arm
def test_abbreviated_formula_is_plain_sympy(arm):
    parts = sp.preorder_traversal(sp.ImmutableMatrix(abbreviate(symbolic.jacobian(arm))))
    assert all(type(part).__module__.startswith("sympy.") for part in parts)


def test_short_form_of_short_form_is_the_same():
    a, b, c_1 = sp.symbols("a b c_1")
    formula = abbreviate((a + b) * sp.cos(sp.Symbol("q_1")))
    assert formula == (a + b) * c_1 == abbreviate(formula)


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
