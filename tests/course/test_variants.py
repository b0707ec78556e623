"""Test drawn sheets: they are reproducible, and answer keys agree with independent computations."""

import json
import re
from functools import cache

import numpy as np
import pytest
import sympy as sp

from course.marking import mark_part
from course.sheets import (
    TOPICS,
    Exercise,
    _make_generator,
    draw_question,
    draw_sheet,
    list_part_names,
    list_suitable_topics,
    make_question,
)
from course.topics import (
    draw_numbers,
    find_closed_form_solver,
    format_matrix,
    make_target_pose,
)
from helpers.arm import Arm, ArmError, Body, fixed, revolute
from helpers.motion import circle, trace
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import gravity_torque
from tests.laws import central_differences, complex_step_jacobian, slow_energy, slow_frames

ARMS = [PANDA.lock(3), UR10E_HOMEWORK, STANFORD, ELBOW]
PLANE = Arm("plane", [revolute(a=0.5), revolute(a=0.4), revolute(a=0.3)])
WRISTED = Arm(
    "wristed",
    [*ELBOW.rows[:2], revolute(a=0.01, alpha="pi/2"), revolute(alpha="-pi/2", d=0.3),
     revolute(alpha="pi/2"), revolute(d=0.1)],
    ELBOW.values,
)  # fmt: skip
every_arm = pytest.mark.parametrize("arm", ARMS, ids=lambda arm: arm.name)


def draw_section(arm, seed, topics=None):
    """Draw the section of a sheet about a single arm."""
    return draw_sheet(arm, seed, topics).sections[0]


def draw(topic, arm, seed):
    """Draw numbers for the arm with unchanged lengths."""
    return draw_numbers(topic, arm, _make_generator(seed, topic))


@cache
def draw_once(arm):
    """Draw a sheet of an arm, or take it from a cache; return it with its questions by topic."""
    own = draw_section(arm, "ab12")
    return own, {question.topic: question for question in own.questions}


def get_question(topic, arm):
    return draw_once(arm)[1][topic]


def read_numbers(text):
    return np.array([float(x) for x in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", text)])


def read_matrices(text):
    return [read_numbers(matrix) for matrix in re.findall(r"begin\{bmatrix\}(.*?)\\end", text)]


def compute_tip(arm, q):
    """Compute the tip's pose as a product of plain 4 x 4 matrices."""
    return slow_frames(arm, q)[-1]


def list_values(question):
    return {part.name: np.asarray(part.value, dtype=float) for part in question.parts}


@pytest.mark.parametrize("arm", [PANDA.lock(3), STANFORD], ids=lambda arm: arm.name)
def test_sheet_follows_from_its_numbers(arm):
    (first, found), other = draw_once(arm), draw_section(arm, 4)
    stored = json.loads(json.dumps(first.drawn))
    for topic, mine in found.items():
        again = make_question(topic, first.arm, stored[topic])
        assert again.markdown == mine.markdown
        assert list(map(repr, again.parts)) == list(map(repr, mine.parts))
        assert stored[topic] != other.drawn[topic]
    assert draw_section(arm, "ab12") == first


def test_lengths_change_by_at_most_a_tenth():
    own = ELBOW.values
    found = [draw_section(ELBOW, seed, ()).arm for seed in range(100)]
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
def test_configurations_keep_limits_and_avoid_singularities(arm):
    q = np.array([draw("forward kinematics", arm, seed)["q"] for seed in range(40)])
    lower, upper = np.clip(arm.limits, -2.4, 2.4)
    share, rounding = (q - lower) / (upper - lower), 0.0051 / (upper - lower)
    np.testing.assert_array_equal(q, q.round(2))
    assert (abs(share - 0.5) <= 0.4 + rounding).all()
    assert share.min() < 0.14
    assert share.max() > 0.86
    assert (np.ptp(share, axis=1) > 0.001).all()
    rank = 2 if arm is PLANE else min(arm.dof, 6)  # a planar arm stays in its plane
    for configuration in q[:8]:
        J = complex_step_jacobian(arm, configuration)[: 6 if arm.dof >= 6 else 3]
        assert np.linalg.svd(J, compute_uv=False)[rank - 1] > 0.0399


def test_arm_without_regular_configurations_is_refused():
    tiny = Arm("tiny", [revolute(a=0.03), revolute(a=0.03)])
    message = "no configuration away from a singular one was found in 500 tries"
    with pytest.raises(ArmError, match=message):
        draw_sheet(tiny, 1)


@every_arm
def test_right_tip_and_jacobian_match_numeric_derivatives(arm):
    found = get_question("forward kinematics", arm)
    (q,) = read_matrices(found.text)
    T = compute_tip(found.arm, q)
    assert list_values(found)["p"] == pytest.approx(T[:3, 3], abs=1e-12)
    assert list_values(found)["R"] == pytest.approx(T[:3, :3], abs=1e-12)
    found = get_question("Jacobian", arm)
    q, q_dot, camera = read_matrices(found.text)
    J = complex_step_jacobian(found.arm, q)
    key = {part.name: part.value for part in found.parts}
    assert key["J"] == pytest.approx(J, abs=1e-8)
    assert key["xi"] == pytest.approx(J @ q_dot, abs=1e-8)
    substitutions = {**found.arm.values, **dict(zip(found.arm.variables, q, strict=True))}
    formulas = found.parts[2].formulas
    column = [float(sp.sympify(entry).subs(substitutions)) for entry in formulas]
    link, joint = found.numbers["link"], found.numbers["column"] - 1
    assert f"fixed to link {link}, at" in found.text
    assert f"`{found.arm.variables[joint]}` alone" in found.text

    def locate_camera(q):
        T = slow_frames(found.arm, q)[link]
        return T[:3, :3] @ camera + T[:3, 3]

    assert column[:3] == pytest.approx(central_differences(locate_camera, q)[:, joint], abs=1e-6)
    assert column[3:] == pytest.approx(J[3:, joint], abs=1e-8)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E], ids=lambda a: a.name)
def test_right_torques_match_numeric_derivatives(arm):
    found = get_question("static torque", arm)
    q, force = read_matrices(found.text)
    g = central_differences(lambda q: slow_energy(found.arm, q), q)
    reaction = central_differences(lambda q: compute_tip(found.arm, q)[:3, 3], q).T @ force
    assert list_values(found)["g"] == pytest.approx(g, abs=1e-6)
    assert list_values(found)["tau"] == pytest.approx(g - reaction, abs=1e-6)
    table = [read_numbers(line)[1:] for line in found.text.splitlines() if re.match(r"\| \d", line)]
    masses = [[found.arm.number(e) for e in (b.mass, *b.com)] for b in found.arm.bodies]
    assert np.array(table) == pytest.approx(np.array(masses), abs=1e-9)


@pytest.mark.parametrize("arm", [PANDA.lock(3), UR10E_HOMEWORK, STANFORD], ids=lambda a: a.name)
def test_right_circle_matches_a_runge_kutta_trace(arm):
    """The circle is read from the question's text and traced by Runge-Kutta with other steps."""
    found = get_question("circle tracing", arm)
    (q,) = read_matrices(found.text)
    radius, plane, period, first = re.search(
        r"radius (\S+) m in the (\w\w) plane in (\S+) s.*?\$\+(\w)\$", found.text
    ).groups()
    assert plane[0] == first
    centre = compute_tip(found.arm, q)[:3, 3] - float(radius) * np.eye(3)["xyz".index(first)]
    path = circle(centre, float(radius), plane, float(period), 400)
    run = trace(found.arm, q, path, method="rk4")
    assert list_values(found)["centre"] == pytest.approx(centre, abs=1e-12)
    assert list_values(found)["quarter"] == pytest.approx(run.q[100], abs=1e-6)
    assert list_values(found)["half"] == pytest.approx(run.q[200], abs=1e-6)
    assert run.report.executable


@pytest.mark.parametrize("seed", range(3))
def test_right_table_has_the_printed_axes(seed):
    found = draw_question("DH table", ELBOW, seed)
    arm = found.parts[0].value
    lines = [line for line in found.text.splitlines() if re.match(r"\| \d", line)]
    assert len(lines) == arm.dof
    for joint, line in enumerate(lines):
        point, direction = read_matrices(line)
        moved = [compute_tip(arm, 0.3 * np.eye(arm.dof)[joint] * s)[:3, 3] for s in (1, 0)]
        if "slides" in line:
            assert moved[0] - moved[1] == pytest.approx(0.3 * direction, abs=1e-12)
        else:  # turning about the axis keeps distance and height
            levers = [m - point for m in moved]
            lengths = np.linalg.norm(levers, axis=1)
            assert lengths[0] == pytest.approx(lengths[1], abs=1e-9)
            assert direction @ levers[0] == pytest.approx(direction @ levers[1], abs=1e-9)


def test_topics_list_their_parts():
    for arm in ARMS:
        section, questions = draw_once(arm)
        names = [part.name for question in questions.values() for part in question.parts]
        assert names == list_part_names([Exercise(arm, tuple(section.drawn))])


def test_suitable_topics_are_listed_for_each_arm():
    assert list_suitable_topics(PANDA.lock(3)) == TOPICS
    assert list_suitable_topics(PANDA) == tuple(t for t in TOPICS if t != "circle tracing")
    assert "static torque" not in list_suitable_topics(UR10E_HOMEWORK)
    assert len(draw_once(ELBOW)[0].drawn) == 4


@every_arm
def test_printed_numbers_equal_the_judged_numbers(arm):
    printed, found = draw_once(arm)
    lengths = re.findall(r"= (-?[\d.]+)\$", printed.arm._repr_markdown_())
    assert {*map(float, lengths)} <= {*printed.arm.values.values()}
    for mine in found.values():
        for name in ("q", "q_dot", "force"):
            if name in mine.numbers:
                assert any(
                    np.array_equal(m, np.array(mine.numbers[name], dtype=float))
                    for m in read_matrices(mine.text)
                )
    if arm.bodies:
        text = found["static torque"].text
        assert "each in the frame of its own link" in text
        lines = [read_numbers(line)[1:] for line in text.splitlines() if re.match(r"\| \d", line)]
        printed_arm = printed.arm.with_bodies([Body(m, c) for m, *c in np.array(lines).tolist()])
        q = np.full(arm.dof, 0.3)
        np.testing.assert_array_equal(
            gravity_torque(printed_arm, q), gravity_torque(printed.arm, q)
        )


STIFF = Arm("stiff", [fixed(a=0.3)])


@pytest.mark.parametrize(
    ("topic", "arm", "message"),
    [
        ("Jacobian", STIFF, "stiff does not suit Jacobian; it needs a joint"),
        ("static torque", ELBOW, "does not suit static torque; it needs masses"),
        ("circle tracing", ELBOW, "does not suit circle tracing; it needs six joints"),
    ],
)
def test_unsuitable_topic_is_refused(topic, arm, message):
    with pytest.raises(ArmError, match=message):
        draw_question(topic, arm, 1)


def test_format_matrix_rounds_to_digits():
    begin, end = "\\begin{bmatrix}", "\\end{bmatrix}"
    assert format_matrix([1.23456789, -1e-5]) == f"{begin}1.2346 & 0{end}"
    assert format_matrix([[123.456789], [2]]) == f"{begin}123.46 \\\\ 2{end}"
    assert format_matrix([1.23456789], 6) == f"{begin}1.234568{end}"


@pytest.mark.parametrize("arm", [*ARMS, PANDA, WRISTED], ids=lambda arm: arm.name)
def test_target_is_reachable_and_limits_are_printed(arm):
    """test_inverse.py tests that the closed forms find every branch."""
    found = draw_question("inverse kinematics", arm, 3)
    target = np.array(found.numbers["target"])
    assert target.shape == ((3, 4) if arm.dof >= 6 else (3, 1))
    np.testing.assert_array_equal(target, target.round(6))
    (printed,) = read_matrices(found.text)
    assert printed == pytest.approx(target.ravel(), abs=1e-9)
    asked = "pose $[R\\ p]$" if arm.dof >= 6 else "position $p$"
    sought = (
        "every set of joint values within the limits"
        if find_closed_form_solver(arm)
        else "joint values"
    )
    assert found.text.startswith(f"Find {sought} that give the tip the {asked} $= ")
    printed_limits = re.findall(
        r"\$q_\{(\d)\}\$ from (-?[\d.]*\d) to (-?[\d.]*\d)[;.]?", found.text
    )
    limits = zip(arm.joints, *arm.limits, strict=True) if find_closed_form_solver(arm) else ()
    assert [(int(i), float(low), float(high)) for i, low, high in printed_limits] == [
        (i, float(f"{low:g}"), float(f"{high:g}")) for i, low, high in limits if np.isfinite(low)
    ]
    assert found.text.endswith("; whole turns count as the same.") == bool(printed_limits)
    (part,) = found.parts
    assert part.kind == ("branches" if find_closed_form_solver(arm) else "pose")
    assert (part.name, part.unit) == ("q", 1e-3)
    lower, upper = found.arm.limits
    for q in np.atleast_2d(part.value):
        assert compute_tip(found.arm, q)[:3, -target.shape[1] :] == pytest.approx(target, abs=5e-6)
        assert (q >= lower - 1e-9).all()
        assert (q <= upper + 1e-9).all()
    if find_closed_form_solver(arm):
        every = find_closed_form_solver(arm)(found.arm, make_target_pose(target))
        assert len(part.value) == every.within_limits.sum()


def test_rounded_pose_becomes_nearest_rigid_motion():
    T = compute_tip(UR10E, [0.3, -1.1, 1.4, -0.8, 0.9, 0.2])
    found = make_target_pose(T[:3].round(3))
    np.testing.assert_allclose(found[:3, :3] @ found[:3, :3].T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(found[:3, :3], T[:3, :3], atol=2e-3)
    np.testing.assert_array_equal(found[:, 3], [*T[:3, 3].round(3), 1])
    np.testing.assert_array_equal(found[3], [0, 0, 0, 1])
    np.testing.assert_array_equal(make_target_pose(np.array([[1], [2], [3]])), [1, 2, 3])


def list_wrong_arms(arm):
    """List arms, and signs of joint values, that follow from one mistake."""
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


def compute_answers(topic, arm, drawn, q):
    if topic == "static torque":
        g = central_differences(lambda q: slow_energy(arm, q), q)
        linear = central_differences(lambda q: compute_tip(arm, q)[:3, 3], q)
        return {"g": g, "tau": g - linear.T @ drawn["force"]}
    T, J = compute_tip(arm, q), complex_step_jacobian(arm, q)
    if topic == "Jacobian":
        return {"J": J, "xi": J @ drawn["q_dot"]}
    return {"p": T[:3, 3], "R": T[:3, :3]}


@pytest.mark.parametrize(
    ("arm", "topic", "seed"),
    [(ELBOW, "Jacobian", 16), (PANDA, "static torque", 28)],
    ids=str,
)
def test_every_mistake_changes_the_answer_of_a_sheet(arm, topic, seed):
    """For these seeds the first random numbers would hide a mistake.

    A mistake that changes nothing at two other configurations changes nothing anywhere.
    """
    own = draw_sheet(arm, f"fresh {seed}", (topic,))
    arm, drawn = own.sections[0].arm, own.sections[0].drawn[topic]
    elsewhere = np.random.default_rng(5).uniform(-2, 2, (2, arm.dof))
    configurations = [np.array(drawn["q"]), *elsewhere]
    right = [compute_answers(topic, arm, drawn, q) for q in configurations]
    for other, signs in list_wrong_arms(arm):
        wrong = [compute_answers(topic, other, drawn, signs * q) for q in configurations]
        for name in right[0]:
            off = [abs(w[name] - r[name]).max() for w, r in zip(wrong, right, strict=True)]
            if max(off) > 1e-6:  # above the error of central differences
                assert off[0] > 2 * own.parts[name].unit
                assert mark_part(own, name, wrong[0][name].round(4).tolist()).credit < 1
