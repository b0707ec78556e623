"""Homework with numbers of its own: what is drawn stays drawn, and keys agree with other ways
of computing.
"""

import json
import re
from functools import cache

import numpy as np
import pytest
import sympy as sp

from course.marking import mark_part
from course.sheets import TOPICS, question, sheet, suiting, variant
from course.sheets import _generator as generator
from course.topics import (
    draw_numbers,
    find_closed_form,
    format_matrix,
    make_target_pose,
)
from helpers.arm import Arm, ArmError, Body, fixed, revolute
from helpers.motion import circle, trace
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import gravity_torque
from tests.laws import central_differences, complex_step_jacobian, slow_energy, slow_frames

# Other lengths of a machine make no other homework.
ARMS = [PANDA.lock(3), UR10E_HOMEWORK, STANFORD, ELBOW]
PLANE = Arm("plane", [revolute(a=0.5), revolute(a=0.4), revolute(a=0.3)])
WRISTED = Arm(
    "wristed",
    [*ELBOW.rows[:2], revolute(a=0.01, alpha="pi/2"), revolute(alpha="-pi/2", d=0.3),
     revolute(alpha="pi/2"), revolute(d=0.1)],
    ELBOW.values,
)  # fmt: skip
every_arm = pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)


def draw(topic, arm, seed):
    """What is drawn about the arm itself, its own lengths unchanged."""
    return draw_numbers(topic, arm, generator(seed, topic))


@cache
def drawn_once(arm):
    """A sheet of an arm, and its questions by their topics."""
    mine = sheet(arm, "ab12")
    return mine, {question.topic: question for question in mine.questions}


def asked(topic, arm):
    return drawn_once(arm)[1][topic]


def numbers(text):
    return np.array([float(x) for x in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", text)])


def matrices(text):
    return [numbers(found) for found in re.findall(r"begin\{bmatrix\}(.*?)\\end", text)]


def product(arm, q):
    """The tip by plain 4 x 4 matrices."""
    return slow_frames(arm, q)[-1]


def values(found):
    return {part.name: np.asarray(part.value, dtype=float) for part in found.parts}


@pytest.mark.parametrize("arm", [PANDA.lock(3), STANFORD], ids=lambda arm: arm.name)
def test_a_sheet_is_its_numbers_and_another_seed_draws_others(arm):
    (first, found), other = drawn_once(arm), sheet(arm, 4)
    stored = json.loads(json.dumps(first.drawn))
    for topic, mine in found.items():
        again = question(topic, first.arm, stored[topic])
        assert again.markdown == mine.markdown
        assert list(map(repr, again.parts)) == list(map(repr, mine.parts))
        assert stored[topic] != other.drawn[topic]
    assert sheet(arm, "ab12") == first


def test_lengths_are_the_arms_own_within_a_tenth():
    own = ELBOW.values
    found = [sheet(ELBOW, seed, ()).arm for seed in range(100)]
    assert {arm.name for arm in found} == {"Elbow arm, lengths of your own"}
    assert {arm.values["d"] for arm in found} == {0}
    for name in ("d_1", "a_2", "a_3"):
        new = np.array([arm.values[name] for arm in found])
        np.testing.assert_array_equal(new, new.round(3))
        assert new.min() == pytest.approx(0.9 * own[name], abs=0.005 * own[name])
        assert new.max() == pytest.approx(1.1 * own[name], abs=0.01 * own[name])
        assert (abs(new - own[name]) <= 0.1 * own[name] + 5e-4).all()
    assert all(len({arm.values[n] / own[n] for n in ("d_1", "a_2", "a_3")}) == 3 for arm in found)


@pytest.mark.parametrize("arm", [STANFORD, PANDA, PLANE], ids=lambda arm: arm.name)
def test_poses_are_drawn_inside_the_limits_and_away_from_singular_ones(arm):
    """The tip of a plane arm cannot leave its plane: two ways to go are all it has."""
    q = np.array([draw("forward kinematics", arm, seed)["q"] for seed in range(40)])
    lower, upper = np.clip(arm.limits, -2.4, 2.4)
    share, rounding = (q - lower) / (upper - lower), 0.0051 / (upper - lower)
    np.testing.assert_array_equal(q, q.round(2))
    assert (abs(share - 0.5) <= 0.4 + rounding).all()
    assert share.min() < 0.14
    assert share.max() > 0.86
    assert (np.ptp(share, axis=1) > 0.001).all()
    ways = 2 if arm is PLANE else min(arm.dof, 6)
    for pose in q[:8]:
        J = complex_step_jacobian(arm, pose)[: 6 if arm.dof >= 6 else 3]
        assert np.linalg.svd(J, compute_uv=False)[ways - 1] > 0.0399


def test_an_arm_that_is_always_near_singular_poses_is_refused():
    tiny = Arm("tiny", [revolute(a=0.03), revolute(a=0.03)])
    words = "tiny, lengths of your own: no pose away from a singular one was found in 500 tries"
    with pytest.raises(ArmError, match=words):
        sheet(tiny, 1)


@every_arm
def test_the_tip_and_the_jacobian_in_the_keys(arm):
    found = asked("forward kinematics", arm)
    (q,) = matrices(found.text)
    T = product(found.arm, q)
    assert values(found)["p"] == pytest.approx(T[:3, 3], abs=1e-12)
    assert values(found)["R"] == pytest.approx(T[:3, :3], abs=1e-12)
    found = asked("Jacobian", arm)
    q, q_dot, camera = matrices(found.text)
    J = complex_step_jacobian(found.arm, q)
    key = {part.name: part.value for part in found.parts}
    assert key["J"] == pytest.approx(J, abs=1e-8)
    assert key["xi"] == pytest.approx(J @ q_dot, abs=1e-8)
    put_in = {**found.arm.values, **dict(zip(found.arm.variables, q, strict=True))}
    formulas = found.parts[2].formulas
    column = [float(sp.sympify(entry).subs(put_in)) for entry in formulas]
    link, joint = found.numbers["link"], found.numbers["column"] - 1
    assert f"fixed to link {link}, at" in found.text
    assert f"`{found.arm.variables[joint]}` alone" in found.text

    def seen(q):
        T = slow_frames(found.arm, q)[link]
        return T[:3, :3] @ camera + T[:3, 3]

    assert column[:3] == pytest.approx(central_differences(seen, q)[:, joint], abs=1e-6)
    assert column[3:] == pytest.approx(J[3:, joint], abs=1e-8)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E], ids=lambda a: a.name)
def test_the_torques_in_the_key(arm):
    found = asked("static torque", arm)
    q, force = matrices(found.text)
    g = central_differences(lambda q: slow_energy(found.arm, q), q)
    reaction = central_differences(lambda q: product(found.arm, q)[:3, 3], q).T @ force
    assert values(found)["g"] == pytest.approx(g, abs=1e-6)
    assert values(found)["tau"] == pytest.approx(g - reaction, abs=1e-6)
    table = [numbers(line)[1:] for line in found.text.splitlines() if re.match(r"\| \d", line)]
    masses = [[found.arm.number(e) for e in (b.mass, *b.com)] for b in found.arm.bodies]
    assert np.array(table) == pytest.approx(np.array(masses), abs=1e-9)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E_HOMEWORK, STANFORD], ids=lambda a: a.name)
def test_the_circle_in_the_key_is_the_one_that_the_sentence_says(arm):
    """Built anew from the sentence, drawn by Runge and Kutta's method with other steps."""
    found = asked("circle tracing", arm)
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


@pytest.mark.parametrize("seed", range(3))
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
    assert suiting(PANDA.lock(3)) == TOPICS
    assert suiting(PANDA) == tuple(t for t in TOPICS if t != "circle tracing")
    assert "static torque" not in suiting(UR10E_HOMEWORK)
    assert len(drawn_once(ELBOW)[0].drawn) == 4


@every_arm
def test_a_question_can_be_solved_from_what_it_prints(arm):
    """The numbers in the text are those that are judged, to the last digit, centres of mass too."""
    printed, found = drawn_once(arm)
    told = re.findall(r"= (-?[\d.]+)\$", printed.arm._repr_markdown_())
    assert {*map(float, told)} <= {*printed.arm.values.values()}
    for mine in found.values():
        for name in ("q", "q_dot", "force"):
            if name in mine.numbers:
                assert any(
                    np.array_equal(m, np.array(mine.numbers[name], dtype=float))
                    for m in matrices(mine.text)
                )
    if arm.bodies:
        text = found["static torque"].text
        assert "each in the frame of its own link" in text
        lines = [numbers(line)[1:] for line in text.splitlines() if re.match(r"\| \d", line)]
        told = printed.arm.with_bodies([Body(m, c) for m, *c in np.array(lines).tolist()])
        q = np.full(arm.dof, 0.3)
        np.testing.assert_array_equal(gravity_torque(told, q), gravity_torque(printed.arm, q))


STIFF = Arm("stiff", [fixed(a=0.3)])


@pytest.mark.parametrize(
    ("topic", "arm", "words"),
    [
        ("Jacobian", STIFF, "stiff does not suit Jacobian; it needs a joint"),
        ("static torque", ELBOW, "does not suit static torque; it needs masses"),
        ("circle tracing", ELBOW, "does not suit circle tracing; it needs six joints"),
    ],
)
def test_what_cannot_be_asked_is_said(topic, arm, words):
    with pytest.raises(ArmError, match=words):
        variant(topic, arm, 1)


def test_a_matrix_has_four_digits_or_as_many_as_asked():
    begin, end = "\\begin{bmatrix}", "\\end{bmatrix}"
    assert format_matrix([1.23456789, -1e-5]) == f"{begin}1.2346 & 0{end}"
    assert format_matrix([[123.456789], [2]]) == f"{begin}123.46 \\\\ 2{end}"
    assert format_matrix([1.23456789], 6) == f"{begin}1.234568{end}"


@pytest.mark.parametrize("arm", [*ARMS, PANDA, WRISTED], ids=lambda arm: arm.name)
def test_a_target_is_a_pose_of_the_arm_and_its_limits_are_told(arm):
    """That no branch is missing is proved of the closed forms in test_inverse."""
    found = variant("inverse kinematics", arm, 3)
    target = np.array(found.numbers["target"])
    assert target.shape == ((3, 4) if arm.dof >= 6 else (3, 1))
    np.testing.assert_array_equal(target, target.round(6))
    (printed,) = matrices(found.text)
    assert printed == pytest.approx(target.ravel(), abs=1e-9)
    asked = "pose $[R\\ p]$" if arm.dof >= 6 else "position $p$"
    sought = (
        "every set of joint values within the limits" if find_closed_form(arm) else "joint values"
    )
    assert found.text.startswith(f"Find {sought} that give the tip the {asked} $= ")
    told = re.findall(r"\$q_\{(\d)\}\$ from (-?[\d.]*\d) to (-?[\d.]*\d)[;.]?", found.text)
    limits = zip(arm.joints, *arm.limits, strict=True) if find_closed_form(arm) else ()
    assert [(int(i), float(low), float(high)) for i, low, high in told] == [
        (i, float(f"{low:g}"), float(f"{high:g}")) for i, low, high in limits if np.isfinite(low)
    ]
    assert found.text.endswith("; whole turns count as the same.") == bool(told)
    (part,) = found.parts
    assert part.kind == ("branches" if find_closed_form(arm) else "pose")
    assert (part.name, part.unit) == ("q", 1e-3)
    lower, upper = found.arm.limits
    for q in np.atleast_2d(part.value):
        assert product(found.arm, q)[:3, -target.shape[1] :] == pytest.approx(target, abs=5e-6)
        assert (q >= lower - 1e-9).all()
        assert (q <= upper + 1e-9).all()
    if find_closed_form(arm):
        every = find_closed_form(arm)(found.arm, make_target_pose(target))
        assert len(part.value) == every.within_limits.sum()


def test_a_pose_as_printed_is_taken_for_the_nearest_rigid_motion():
    T = product(UR10E, [0.3, -1.1, 1.4, -0.8, 0.9, 0.2])
    found = make_target_pose(T[:3].round(3))
    np.testing.assert_allclose(found[:3, :3] @ found[:3, :3].T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(found[:3, :3], T[:3, :3], atol=2e-3)
    np.testing.assert_array_equal(found[:, 3], [*T[:3, 3].round(3), 1])
    np.testing.assert_array_equal(found[3], [0, 0, 0, 1])
    np.testing.assert_array_equal(make_target_pose(np.array([[1], [2], [3]])), [1, 2, 3])


def planted(arm):
    """The arm, and the signs of its joint values, of whoever makes one slip."""
    same = np.ones(arm.dof)
    for i, row in enumerate(arm.rows, 1):
        for name, entry in zip(("a", "alpha", "d", "theta"), row.entries, strict=True):
            if value := arm.number(entry):
                yield arm.with_row(i, **{name: 0}), same
                yield arm.with_row(i, **{name: -value}), same
    yield from ((arm, same - 2 * one) for one in np.eye(arm.dof))
    for i, body in enumerate(arm.bodies):
        bodies = [*arm.bodies[:i], Body(0, body.com), *arm.bodies[i + 1 :]]
        yield arm.with_bodies(bodies), same


def answers(topic, arm, given, q):
    if topic == "static torque":
        g = central_differences(lambda q: slow_energy(arm, q), q)
        linear = central_differences(lambda q: product(arm, q)[:3, 3], q)
        return {"g": g, "tau": g - linear.T @ given["force"]}
    T, J = product(arm, q), complex_step_jacobian(arm, q)
    if topic == "Jacobian":
        return {"J": J, "xi": J @ given["q_dot"]}
    return {"p": T[:3, 3], "R": T[:3, :3]}


@pytest.mark.parametrize(
    ("arm", "topic", "seed"),
    [(ELBOW, "Jacobian", 16), (PANDA, "static torque", 28)],
    ids=str,
)
def test_a_slip_that_the_first_draw_would_forgive_is_seen(arm, topic, seed):
    """Of each of these seeds the first draw hides one. What shows at neither of two other poses
    changes nothing anywhere."""
    mine = sheet(arm, f"fresh {seed}", (topic,))
    arm, given = mine.arm, mine.drawn[topic]
    elsewhere = np.random.default_rng(5).uniform(-2, 2, (2, arm.dof))
    poses = [np.array(given["q"]), *elsewhere]
    right = [answers(topic, arm, given, q) for q in poses]
    for other, signs in planted(arm):
        wrong = [answers(topic, other, given, signs * q) for q in poses]
        for name in right[0]:
            off = [abs(w[name] - r[name]).max() for w, r in zip(wrong, right, strict=True)]
            if (
                max(off) > 1e-6
            ):  # of central central_differences; what moves the energy alone is noise
                assert off[0] > 2 * mine.parts[name].unit
                assert mark_part(mine, name, wrong[0][name].round(4).tolist()).credit < 1
