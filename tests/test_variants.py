"""Homework with other numbers: the same seed the same sheet, and a key that an independent way of
computing agrees with."""

import re

import numpy as np
import pytest

from helpers.arm import ArmError
from helpers.motion import circle, trace
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.variants import TOPICS, sheet, variant

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


@every_arm
def test_the_same_seed_gives_the_same_sheet_and_another_seed_another(arm):
    first, again, other = sheet(arm, 4), sheet(arm, 4), sheet(arm, 5)
    for one, two, three in zip(first, again, other, strict=True):
        assert (one.question_text, one.key_text) == (two.question_text, two.key_text)
        assert one.question != three.question
        assert one.arm == two.arm == first[0].arm
        assert one.arm != arm


@every_arm
def test_lengths_stay_near_the_arms_own(arm):
    for (name, new), (_, old) in zip(
        sheet(arm, 9)[0].arm.values.items(), arm.values.items(), strict=True
    ):
        assert abs(new - old) <= 0.1 * old + 5e-4, name


@every_arm
@pytest.mark.parametrize("seed", range(3))
def test_the_pose_of_the_tip_in_the_key(arm, seed):
    found = variant("DH tables", arm, seed)
    (q,) = matrices(found.question)
    T = product(found.arm, q)
    assert found.marks({"p": T[:3, 3], "R": T[:3, :3]}) == {"p": True, "R": True}
    assert not any(found.marks({"p": T[:3, 3] + 0.002, "R": T[:3, :3].T}).values())


@every_arm
@pytest.mark.parametrize("seed", range(3))
def test_the_jacobian_in_the_key(arm, seed):
    found = variant("Jacobian", arm, seed)
    q, q_dot = matrices(found.question)
    linear = differences(lambda q: product(found.arm, q)[:3, 3], q)
    turning = np.einsum(
        "ijk,lj->ilk",
        differences(lambda q: product(found.arm, q)[:3, :3], q),
        product(found.arm, q)[:3, :3],
    )
    J = np.vstack([linear, turning[2, 1], turning[0, 2], turning[1, 0]])
    assert all(found.marks({"J": J, "xi": J @ q_dot}).values())
    assert not found.marks({"J": -J, "xi": J @ q_dot})["J"]


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E, PANDA], ids=["locked", "UR10e", "Panda"])
@pytest.mark.parametrize("seed", range(3))
def test_the_torques_in_the_key(arm, seed):
    found = variant("static torque", arm, seed)
    q, force = matrices(found.question)
    g = differences(lambda q: energy(found.arm, q), q)
    reaction = differences(lambda q: product(found.arm, q)[:3, 3], q).T @ force
    assert all(found.marks({"g": g, "tau": g - reaction}).values())
    assert not found.marks({"g": g, "tau": g + reaction})["tau"]
    table = [numbers(line)[1:] for line in found.question.splitlines() if re.match(r"\| \d", line)]
    masses = [[found.arm.number(e) for e in (b.mass, *b.com)] for b in found.arm.bodies]
    assert np.array(table) == pytest.approx(np.array(masses), abs=1e-9)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E_HOMEWORK, STANFORD], ids=lambda a: a.name)
@pytest.mark.parametrize("seed", range(2))
def test_the_circle_in_the_key_is_the_one_that_the_sentence_says(arm, seed):
    """Built anew from the sentence, drawn by Runge and Kutta's method with other steps."""
    found = variant("circle tracing", arm, seed)
    (q,) = matrices(found.question)
    radius, plane, period, first = re.search(
        r"radius (\S+) m in the (\w\w) plane in (\S+) s.*?\$\+(\w)\$", found.question
    ).groups()
    assert plane[0] == first
    top = product(found.arm, q)[:3, 3]
    centre = top - float(radius) * np.eye(3)["xyz".index(first)]
    run = trace(
        found.arm, q, circle(centre, float(radius), plane, float(period), 400), method="rk4"
    )
    assert all(found.marks({"centre": centre, "quarter": run.q[100], "half": run.q[200]}).values())
    assert not found.marks({"quarter": run.q[-101]})["quarter"]
    assert run.report.executable


@every_arm
def test_any_joint_vector_that_reaches_is_right(arm):
    seed = 6
    found = variant("inverse kinematics", arm, seed)
    wanted = found.key["q"].value
    lower, upper = (np.clip(limit, -2.5, 2.5) for limit in found.arm.limits)
    rng = np.random.default_rng(seed)
    for _ in range(200):  # Newton's method from random starts, by numeric slopes
        q = lower + (upper - lower) * rng.random(arm.dof)
        for _ in range(30):
            error = (product(found.arm, q)[:3, -wanted.shape[1] :] - wanted).ravel()
            slope = differences(lambda q: product(found.arm, q)[:3, -wanted.shape[1] :].ravel(), q)
            q = q - np.linalg.pinv(slope, rcond=1e-6) @ error
        if np.abs(error).max() < 1e-6:
            break
    assert found.marks({"q": q}) == {"q": True}
    assert found.marks({"q": q + 0.2}) == {"q": False}
    assert found.marks({"q": q[:-1]}) == {"q": False}


def test_a_missing_or_senseless_answer_is_wrong():
    found = variant("DH tables", ELBOW, 0)
    assert found.marks({}) == {"p": False, "R": False}
    assert found.marks({"p": "to the left", "R": None}) == {"p": False, "R": False}


def test_the_sheet_has_what_the_arm_can_do():
    assert [v.topic for v in sheet(PANDA.lock(3), 1)] == list(TOPICS)
    assert [v.topic for v in sheet(PANDA, 1)] == [t for t in TOPICS if t != "circle tracing"]
    assert "static torque" not in [v.topic for v in sheet(UR10E_HOMEWORK, 1)]
    assert len(sheet(ELBOW, 1)) == 3


@pytest.mark.parametrize(
    ("topic", "arm", "seed", "words"),
    [
        ("statics", PANDA, 1, "expected one of DH tables"),
        ("Jacobian", PANDA, -1, "whole number"),
        ("Jacobian", PANDA, 1.5, "whole number"),
        ("static torque", ELBOW, 1, "does not suit"),
        ("circle tracing", ELBOW, 1, "does not suit"),
    ],
)
def test_what_cannot_be_asked_is_said(topic, arm, seed, words):
    with pytest.raises(ArmError, match=words):
        variant(topic, arm, seed)
