"""Homework with numbers of its own: what is drawn stays drawn, and keys agree with other ways
of computing.
"""

import json
import re

import numpy as np
import pytest
import sympy as sp

from helpers.arm import ArmError
from helpers.motion import circle, trace
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.variants import TOPICS, question, sheet, variant

ARMS = [PANDA.lock(3), PANDA_HOMEWORK.lock(3), UR10E, UR10E_HOMEWORK, STANFORD, ELBOW]
every_arm = pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)


def numbers(text):
    return np.array([float(x) for x in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", text)])


def matrices(text):
    return [numbers(found) for found in re.findall(r"begin\{bmatrix\}(.*?)\\end", text)]


def product(arm, q):
    """The tip by plain 4 x 4 matrices, written out here."""
    T, values = np.eye(4), dict(zip(arm.joints, q, strict=True))
    for i, row in enumerate(arm.rows, 1):
        a, alpha, d, theta = (arm.number(e) for e in (row.a, row.alpha, row.d, row.theta))
        moved = values.get(i, 0.0)
        theta, d = (theta + moved, d) if row.joint.kind != "prismatic" else (theta, d + moved)
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        T = T @ [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0, sa, ca, d],
            [0, 0, 0, 1],
        ]
    return T


def differences(f, q, h=1e-6):
    """The slope of f at q by central differences, its last axis the joints'."""
    steps = h * np.eye(len(q))
    return np.stack([(f(q + step) - f(q - step)) / (2 * h) for step in steps], axis=-1)


def energy(arm, q):
    """Weight times height, link by link, each height from the table's rows up to that link."""
    total, values = 0.0, dict(zip(arm.joints, q, strict=True))
    for k, body in enumerate(arm.bodies, 1):
        part = type(arm)(arm.name, arm.rows[:k], arm.values)
        com = [arm.number(c) for c in body.com]
        T = product(part, [values[i] for i in part.joints])
        total += 9.81 * arm.number(body.mass) * (T @ [*com, 1])[2]
    return np.array(total)


def values(found):
    return {part.name: np.asarray(part.value, dtype=float) for part in found.parts}


@every_arm
@pytest.mark.parametrize("seed", [4, "ab12"])
def test_a_sheet_is_its_numbers_and_another_seed_draws_others(arm, seed):
    first, other = sheet(arm, seed), sheet(arm, f"{seed} too")
    stored = json.loads(json.dumps(first.drawn))
    for asked, elsewhere in zip(first.questions, other.questions, strict=True):
        again = question(asked.topic, first.arm, stored[asked.topic])
        assert (again.markdown, again.key) == (asked.markdown, asked.key)
        assert asked.text != elsewhere.text
    assert sheet(arm, seed) == first


@every_arm
def test_lengths_stay_near_the_arms_own(arm):
    for name, new in sheet(arm, 9).arm.values.items():
        assert abs(new - arm.values[name]) <= 0.1 * arm.values[name] + 5e-4, name


@every_arm
@pytest.mark.parametrize("seed", range(3))
def test_the_tip_and_the_jacobian_in_the_keys(arm, seed):
    found = variant("forward kinematics", arm, seed)
    (q,) = matrices(found.text)
    T = product(found.arm, q)
    assert values(found)["p"] == pytest.approx(T[:3, 3], abs=1e-12)
    assert values(found)["R"] == pytest.approx(T[:3, :3], abs=1e-12)
    found = variant("Jacobian", arm, seed)
    q, q_dot = matrices(found.text)
    linear = differences(lambda q: product(found.arm, q)[:3, 3], q)
    slope = differences(lambda q: product(found.arm, q)[:3, :3], q)
    turning = np.einsum("ijk,lj->ilk", slope, product(found.arm, q)[:3, :3])
    J = np.vstack([linear, turning[2, 1], turning[0, 2], turning[1, 0]])
    key = {part.name: part.value for part in found.parts}
    assert key["J"] == pytest.approx(J, abs=1e-8)
    assert key["xi"] == pytest.approx(J @ q_dot, abs=1e-8)
    put_in = {**found.arm.values, **dict(zip(found.arm.variables, q, strict=True))}
    column = [float(sp.sympify(entry).subs(put_in)) for entry in key["J_column"]]
    assert column == pytest.approx(J[:, found.given["column"] - 1], abs=1e-8)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E, PANDA], ids=["locked", "UR10e", "Panda"])
@pytest.mark.parametrize("seed", range(3))
def test_the_torques_in_the_key(arm, seed):
    found = variant("static torque", arm, seed)
    q, force = matrices(found.text)
    g = differences(lambda q: energy(found.arm, q), q)
    reaction = differences(lambda q: product(found.arm, q)[:3, 3], q).T @ force
    assert values(found)["g"] == pytest.approx(g, abs=1e-6)
    assert values(found)["tau"] == pytest.approx(g - reaction, abs=1e-6)
    table = [numbers(line)[1:] for line in found.text.splitlines() if re.match(r"\| \d", line)]
    masses = [[found.arm.number(e) for e in (b.mass, *b.com)] for b in found.arm.bodies]
    assert np.array(table) == pytest.approx(np.array(masses), abs=1e-9)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E_HOMEWORK, STANFORD], ids=lambda a: a.name)
@pytest.mark.parametrize("seed", range(2))
def test_the_circle_in_the_key_is_the_one_that_the_sentence_says(arm, seed):
    """Built anew from the sentence, drawn by Runge and Kutta's method with other steps."""
    found = variant("circle tracing", arm, seed)
    (q,) = matrices(found.text)
    radius, plane, period, first = re.search(
        r"radius (\S+) m in the (\w\w) plane in (\S+) s.*?\$\+(\w)\$", found.text
    ).groups()
    assert plane[0] == first
    centre = product(found.arm, q)[:3, 3] - float(radius) * np.eye(3)["xyz".index(first)]
    path = circle(centre, float(radius), plane, float(period), 400)
    run = trace(found.arm, q, path, method="rk4")
    assert values(found)["centre"] == pytest.approx(centre, abs=1e-12)
    assert values(found)["quarter"] == pytest.approx(run.q[100], abs=1e-6)
    assert values(found)["half"] == pytest.approx(run.q[200], abs=1e-6)
    assert run.report.executable


@every_arm
def test_branches_in_the_key_reach_the_target_within_the_limits_and_newton_finds_no_other(arm):
    found = variant("inverse kinematics", arm, 6)
    wanted, (part,) = np.array(found.given["target"]), found.parts
    lower, upper = found.arm.limits
    for q in np.atleast_2d(part.value):
        assert product(found.arm, q)[:3, -wanted.shape[1] :] == pytest.approx(wanted, abs=5e-6)
        assert (q >= lower - 1e-9).all()
        assert (q <= upper + 1e-9).all()
    if part.kind == "pose":
        return
    rng = np.random.default_rng(6)
    for _ in range(40):  # Newton's method from random starts, by numeric slopes
        q = rng.uniform(np.clip(lower, -2.5, 2.5), np.clip(upper, -2.5, 2.5))
        for _ in range(30):
            error = (product(found.arm, q)[:3, -wanted.shape[1] :] - wanted).ravel()
            slope = differences(lambda q: product(found.arm, q)[:3, -wanted.shape[1] :].ravel(), q)
            q = q - np.linalg.pinv(slope, rcond=1e-6) @ error
            if np.abs(error).max() < 1e-9:
                break
        turned = np.where(found.arm.turning, (q + np.pi) % (2 * np.pi) - np.pi, q)
        if np.abs(error).max() > 1e-5 or ((turned < lower) | (turned > upper)).any():
            continue
        off = np.abs(np.exp(1j * part.value) - np.exp(1j * turned)).max(axis=1)
        assert off.min() < 1e-3


@pytest.mark.parametrize("seed", range(6))
def test_the_table_in_the_key_is_the_arm_that_the_axes_describe(seed):
    found = variant("DH table", ELBOW, seed)
    arm = found.parts[0].value
    lines = [line for line in found.text.splitlines() if re.match(r"\| \d", line)]
    assert len(lines) == arm.dof
    for joint, line in enumerate(lines):
        point, direction = matrices(line)
        moved = [product(arm, 0.3 * np.eye(arm.dof)[joint] * s)[:3, 3] for s in (1, 0)]
        if "slides" in line:
            assert moved[0] - moved[1] == pytest.approx(0.3 * direction, abs=1e-12)
        else:  # a turn about the axis keeps distance and height
            arms = [m - point for m in moved]
            assert np.linalg.norm(arms[0]) == pytest.approx(np.linalg.norm(arms[1]), abs=1e-9)
            assert direction @ arms[0] == pytest.approx(direction @ arms[1], abs=1e-9)


def test_the_sheet_has_what_the_arm_can_do():
    assert list(sheet(PANDA.lock(3), 1).drawn) == list(TOPICS)
    assert list(sheet(PANDA, 1).drawn) == [t for t in TOPICS if t != "circle tracing"]
    assert "static torque" not in sheet(UR10E_HOMEWORK, 1).drawn
    assert len(sheet(ELBOW, 1).drawn) == 4


@pytest.mark.parametrize(
    ("topic", "arm", "seed", "words"),
    [
        ("statics", PANDA, 1, "topic is 'statics'; expected one of DH table"),
        ("Jacobian", PANDA, -1, "seed is -1; expected a whole number"),
        ("Jacobian", PANDA, 1.5, "seed is 1.5; expected a whole number"),
        ("static torque", ELBOW, 1, "does not suit static torque; it needs masses"),
        ("circle tracing", ELBOW, 1, "does not suit circle tracing; it needs six joints"),
    ],
)
def test_what_cannot_be_asked_is_said(topic, arm, seed, words):
    with pytest.raises(ArmError, match=words):
        variant(topic, arm, seed)
