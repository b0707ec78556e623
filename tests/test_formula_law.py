"""Test that the judge compares formulas as formulas, whatever configuration stands in the form.

The wrong formulas are right ones of SymPy with one term changed. That a change matters is decided
by SymPy's numbers, not by the judge.
"""

from random import Random

import numpy as np
import pytest
import sympy as sp

from helpers import checks, robots, symbolic
from helpers.inputs import ArmError

_CHANGES_PER_ARM = 12
_CHANGES = ("sign", "dropped", "symbol", "factor")


def change_term(J, joints, rng):
    """Return J with one term of one entry changed."""
    places = [(i, j) for i in range(6) for j in range(J.cols) if J[i, j] != 0]
    i, j = rng.choice(places)
    terms = list(sp.Add.make_args(J[i, j]))
    k, change = rng.randrange(len(terms)), rng.choice(_CHANGES)
    term = terms[k]
    inside = sorted(set(joints) & term.free_symbols, key=str)
    if change == "symbol" and inside and len(joints) > 1:
        old = rng.choice(inside)
        terms[k] = term.subs(old, rng.choice([q for q in joints if q != old]))
    else:
        terms[k] = {"sign": -term, "dropped": sp.Integer(0)}.get(change, 2 * term)
    changed = J.as_mutable()
    changed[i, j] = sp.Add(*terms)
    return changed


def is_same(arm, J, changed):
    rng = np.random.default_rng(1)
    names = sp.symbols(" ".join(arm.variables), seq=True)
    symbols = {**{q: x for q, x in zip(names, rng.uniform(0.3, 1.2, arm.dof), strict=True)},
               **{sp.Symbol(name): value for name, value in arm.values.items()}}  # fmt: skip
    difference = np.array((J - changed).subs(symbols), dtype=float)
    return bool(np.abs(difference).max() < 1e-9)


@pytest.mark.parametrize("arm", [*robots.ARMS, robots.PANDA.lock(3)], ids=str)
def test_formula_with_changed_term_is_never_right(arm):
    rng, J = Random(67), symbolic.jacobian(arm)
    joints = list(sp.symbols(" ".join(arm.variables), seq=True))
    home = np.zeros(arm.dof)
    passed = []
    for _ in range(_CHANGES_PER_ARM):
        changed = change_term(J, joints, rng)
        if is_same(arm, J, changed):
            continue
        try:
            grade = checks.compare_jacobian(changed, arm, home).grade
        except ArmError:
            continue
        if grade != "wrong":
            passed.append((grade, changed))
    assert passed == []
    assert checks.compare_jacobian(J, arm, home).agrees


# The elbow arm's Jacobian with theta_1 left out; it equals the right one at q = 0.
WITHOUT_FIRST_JOINT = """0 -(a_2*s_2+a_3*s_23) -a_3*s_23
a_2*c_2+a_3*c_23 0 0
0 a_2*c_2+a_3*c_23 a_3*c_23
0 0 0
0 -1 -1
1 0 0"""


@pytest.mark.parametrize("q", ["0 0 0", "0 0.5 -0.4", None])
def test_formula_without_first_joint_is_wrong(q):
    assert checks.compare_jacobian(WITHOUT_FIRST_JOINT, robots.ELBOW, q).grade == "wrong"


def test_verdict_on_formula_names_no_configuration():
    report = checks.compare_jacobian(symbolic.jacobian(robots.ELBOW), robots.ELBOW, [0, 0, 0])
    assert report.headline == "The Jacobian of Elbow arm is right."
    assert report.notes == ()


def test_verdict_on_lengths_alone_names_the_configuration():
    """At home the elbow arm's tip is at (a_2 + a_3, 0, d_1)."""
    lengths = "0 0 0\na_2+a_3 0 0\n0 a_2+a_3 a_3\n0 0 0\n0 -1 -1\n1 0 0"
    report = checks.compare_jacobian(lengths, robots.ELBOW, [0, 0, 0])
    assert report.headline == "The Jacobian of Elbow arm is right at q = (0, 0, 0)."
    assert "usual mistakes would not change the Jacobian: try q = (" in report.notes[0]
