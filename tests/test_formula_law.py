"""Test that the judge compares formulas symbolically, for any configuration in the form.

The wrong formulas are right ones with one term changed. That a change matters is decided by
numbers of SymPy and NumPy, not by the judge.
"""

from random import Random

import numpy as np
import pytest
import sympy as sp

from helpers import checks, robots, symbolic
from helpers.checks.arms import judge_data
from helpers.checks.engine import ask_judge
from helpers.inputs import ArmError
from helpers.kinematics import jacobian
from tests.laws import ALL_ARMS, arm_id

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


@pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
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


def test_verdict_on_formula_names_no_configuration():
    report = checks.compare_jacobian(symbolic.jacobian(robots.ELBOW), robots.ELBOW, [0, 0, 0])
    assert report.headline == "The Jacobian of Elbow arm is right."
    assert report.notes == ()


def test_verdict_on_lengths_alone_names_the_configuration():
    """At home the elbow arm's tip is at (a_2 + a_3, 0, d_1)."""
    lengths = "0 0 0\na_2+a_3 0 0\n0 a_2+a_3 a_3\n0 0 0\n0 -1 -1\n1 0 0"
    report = checks.compare_jacobian(lengths, robots.ELBOW, [0, 0, 0])
    assert report.headline == "The Jacobian of Elbow arm is right at q = (0, 0, 0)."


def test_note_on_hidden_mistakes_leaves_out_other_q_if_the_page_fixes_it():
    arm, q = judge_data(robots.PANDA), [0.0] * 7
    J = jacobian(robots.PANDA, q).tolist()
    for is_fixed in (False, True):
        options = {"isConfigurationFixed": is_fixed}
        note = ask_judge("jacobian", mine=J, arm=arm, q=q, options=options)["notes"][0]
        assert "usual mistakes would not change the Jacobian" in note
        assert ("try q = " in note) is not is_fixed


# Tables in symbols

_COLUMNS = ("theta", "d", "a", "alpha")


def list_joint_symbols(arm):
    return list(sp.symbols(" ".join(arm.variables), seq=True))


def list_symbolic_rows(arm):
    """Return the arm's table, where theta or d of a joint contains the joint's symbol."""
    symbols, rows = iter(list_joint_symbols(arm)), []
    for row in arm.rows:
        entries = {column: sp.sympify(getattr(row, column)) for column in _COLUMNS}
        variable = {"revolute": "theta", "prismatic": "d"}.get(row.joint.kind)
        if variable:
            entries[variable] += next(symbols)
        rows.append(entries)
    return rows


def format_rows(rows):
    lines = [" ".join(str(row[column]).replace(" ", "") for column in _COLUMNS) for row in rows]
    return "\n".join([" ".join(_COLUMNS), *lines])


def change_entry(arm, rows, rng):
    """Return the rows with one term of one entry changed: its sign, dropped, or another symbol."""
    places = [(i, column) for i, row in enumerate(rows) for column in _COLUMNS if row[column] != 0]
    i, column = rng.choice(places)
    entry = rows[i][column]
    term, change = rng.choice(sp.Add.make_args(entry)), rng.choice(("sign", "dropped", "symbol"))
    kinds = (list_joint_symbols(arm), [sp.Symbol(name) for name in arm.values])
    swaps = [
        (old, new)
        for kind in kinds
        for old in kind
        for new in kind
        if old in entry.free_symbols and new not in entry.free_symbols
    ]
    if change == "symbol" and swaps:
        changed = entry.subs(*rng.choice(swaps))
    else:
        changed = entry - (term if change == "dropped" else 2 * term)
    return [{**row, column: changed} if k == i else row for k, row in enumerate(rows)]


def compute_tip(arm, rows, q):
    """Return the tip's position and z z^T, which is the same for z and -z."""
    numbers = {sp.Symbol(name): value for name, value in arm.values.items()}
    numbers |= dict(zip(list_joint_symbols(arm), q, strict=True))
    T = np.eye(4)
    for row in rows:
        theta, d, a, alpha = (float(row[column].subs(numbers)) for column in _COLUMNS)
        (c, s), (ca, sa) = ((np.cos(x), np.sin(x)) for x in (theta, alpha))
        T = T @ [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0, sa, ca, d],
            [0, 0, 0, 1],
        ]
    return np.vstack([T[:3, 3], np.outer(T[:3, 2], T[:3, 2])])


def is_right_as_stated(arm, rows, changed, verdict):
    """Return whether the tip moves as the reference's if the joints count as the verdict states."""
    signs, offsets = np.ones(arm.dof), np.zeros(arm.dof)
    if verdict.joint_map:
        signs, offsets = np.array(verdict.joint_map.signs), np.array(verdict.joint_map.offsets)
    if "count backwards" in " ".join(verdict.taken):
        joints = list_joint_symbols(arm)
        backwards = [
            any(row[c].coeff(q) == -1 for row in changed for c in _COLUMNS) for q in joints
        ]
        signs = np.where(backwards, -signs, signs)
    return all(
        np.allclose(
            compute_tip(arm, changed, q), compute_tip(arm, rows, signs * q + offsets), atol=1e-9
        )
        for q in np.random.default_rng(2).uniform(-1.2, 1.2, (3, arm.dof))
    )


@pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
def test_right_table_with_changed_entry_moves_the_tip_alike(arm):
    rng, rows = Random(74), list_symbolic_rows(arm)
    assert checks.compare_tables(format_rows(rows), arm).grade == "right"
    passed = []
    for _ in range(3 * _CHANGES_PER_ARM):
        changed = change_entry(arm, rows, rng)
        try:
            verdict = checks.compare_tables(format_rows(changed), arm)
        except ArmError:
            continue
        right = verdict.grade not in ("wrong", "so far")
        if right and not is_right_as_stated(arm, rows, changed, verdict):
            passed.append((verdict.grade, format_rows(changed)))
    assert passed == []


# Torques in symbols


@pytest.mark.parametrize("arm", ALL_ARMS, ids=arm_id)
def test_torque_formula_with_changed_term_is_never_right(arm):
    """At q = 0 many changed terms are 0, for instance those with a sine."""
    weight = [0, 0, -20, 0, 0, 0]
    tau = -symbolic.jacobian(arm).T * sp.Matrix(weight)
    k = max(range(arm.dof), key=lambda i: (tau[i] != 0, len(tau[i].free_symbols)))
    for factor in (-1, 0, 2):
        changed = tau.as_mutable()
        changed[k] *= factor
        for answer in (changed, ", ".join(map(str, changed))):
            try:
                verdict = checks.compare_torques(
                    answer, arm, np.zeros(arm.dof), weight, gravity=[0, 0, 0]
                )
            except ArmError:
                continue
            assert verdict.grade == "wrong"
