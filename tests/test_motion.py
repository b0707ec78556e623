"""Test traced paths: orders of the methods, remedies at singular configurations, and reports."""

from contextlib import nullcontext
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.arm import ArmError
from helpers.inverse import elbow, follow, ur
from helpers.kinematics import forward_kinematics, jacobian, tip
from helpers.motion import (
    Path,
    SingularError,
    UnreachableError,
    at_once,
    circle,
    circle_below,
    damped,
    levenberg,
    line,
    plain_inverse,
    pseudo_inverse,
    rest_to_rest,
    trace,
    tracing,
)
from helpers.motion.report import report_trace as summary
from helpers.motion.steps import sample_path
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK

HOMEWORK, REAL = PANDA_HOMEWORK.lock(3), PANDA.lock(3)
TOP = np.array([0.679, 0, 0.825])


def panda_circle(steps, period=5.0):
    return circle(TOP - [0, 0, 0.1], 0.1, "zy", period, steps)


def ur_circle(steps=1000):
    return circle([0, 0.3561, 1.328], 0.1, "xz", 20.0, steps, phase=np.pi / 2)


def test_circle_has_constant_radius_and_speed():
    path = circle([0.4, -0.1, 0.2], 0.07, "yx", 3.0, 60, phase=0.4)
    out = path.positions - [0.4, -0.1, 0.2]
    np.testing.assert_allclose(np.linalg.norm(out, axis=1), 0.07, atol=1e-15)
    np.testing.assert_allclose(path.positions[0], path.positions[-1], atol=1e-15)
    np.testing.assert_allclose(
        np.linalg.norm(path.velocities, axis=1), 2 * np.pi * 0.07 / 3, atol=1e-15
    )
    np.testing.assert_array_equal(path.normal, [0, 0, -1])  # y x x
    h = 1e-6
    slope = (path.position(path.times + h) - path.position(path.times - h)) / (2 * h)
    np.testing.assert_allclose(path.velocities, slope, atol=1e-9)


@pytest.mark.parametrize(
    ("plane", "aside"), [("zy", [0, 0.1]), ("yz", [0, -0.1]), ("zx", [0.1, 0]), ("xz", [-0.1, 0])]
)
def test_circle_below_has_start_tip_as_top(plane, aside):
    path = circle_below(HOMEWORK, HOMEWORK.home, 0.1, plane, 5.0, 4)
    (x, y, z), lowest = tip(HOMEWORK, HOMEWORK.home), path.positions[2]
    np.testing.assert_allclose(path.positions[0], [x, y, z], atol=1e-15)
    np.testing.assert_allclose(lowest, [x, y, z - 0.2], atol=1e-15)
    np.testing.assert_allclose(path.positions[1], [x + aside[0], y + aside[1], z - 0.1], atol=1e-15)


@pytest.mark.parametrize(
    ("method", "gain", "order"), [("euler", 0.0, 1), ("rk4", 0.0, 4), ("rk4", 2.0, 4)]
)
def test_error_order_of_each_method(method, gain, order):
    """Chapter 3 checks the size of the errors; this test checks their order."""
    traces = [
        trace(HOMEWORK, HOMEWORK.home, panda_circle(n), method=method, gain=gain) for n in (50, 100)
    ]
    error = [run.report.position_error for run in traces]
    assert error[0] / error[1] == pytest.approx(2**order, rel=0.15)


@settings(max_examples=15)
@given(
    bend=st.floats(-0.4, 0.4),
    turn=st.floats(-2, 2),
    radius=st.floats(0.01, 0.06),
    plane=st.sampled_from(["yz", "xy", "zx"]),
)
def test_random_circle_is_traced_exactly(bend, turn, radius, plane):
    start = np.array([turn, -1.2 + bend, 1.6, -0.9, 1.2, 0.3])
    tip = forward_kinematics(UR10E, start)[:3, 3]
    first = np.eye(3)["xyz".index(plane[0])]
    run = trace(UR10E, start, circle(tip - radius * first, radius, plane, 4.0, 60), method="exact")
    assert run.report.position_error < 1e-11
    assert run.report.pen_tilt < 1e-10
    np.testing.assert_allclose(run.q_dot[:-1], np.diff(run.q, axis=0) / (4 / 60), atol=1e-10)
    np.testing.assert_allclose(
        run.poses[:, :3, :3], np.broadcast_to(run.poses[0, :3, :3], (61, 3, 3)), atol=1e-10
    )


def test_plain_inverse_raises_below_cutoff_ratio():
    J, one, last = np.diag([5.0, 5, 5, 5, 5, 4e-9]), np.eye(6)[0], np.eye(6)[5]
    words = "its smallest singular value is 4e-09, its largest 5;"
    for twist in (last, 1e-9 * last, one, 0 * one):  # for any twist, even a tiny or zero one
        with pytest.raises(SingularError, match=words):
            plain_inverse()(J, twist, None)
    for cutoff in (7.9e-10, 1e-10, 0.0):
        np.testing.assert_allclose(plain_inverse(cutoff)(J, last, None), 2.5e8 * last)
    with pytest.raises(SingularError, match=words):
        plain_inverse(8.1e-10)(J, last, None)
    with pytest.raises(SingularError, match="its smallest singular value is below 1e-12"):
        plain_inverse(0.0)(np.diag([1.0, 1, 1, 1, 1, 0]), one, None)


@pytest.mark.parametrize("cutoff", [1e-9, 1e-3, 0.05])
def test_plain_inverse_raises_exactly_when_singular(cutoff):
    """The quick bound must agree with the singular values, even for twists without the lost axis.

    At q_5 = 0 the arm loses a direction; `J @ ones` has no component in it.
    """
    q = np.random.default_rng(14).uniform(-np.pi, np.pi, (400, 6))
    q[:200, 4] *= 1e-2
    q[:50, 4] = 0.0
    J = jacobian(UR10E_HOMEWORK, q)
    sizes = np.linalg.svd(J, compute_uv=False)
    for one, singular in zip(J, sizes[:, 5] <= cutoff * sizes[:, 0], strict=True):
        with pytest.raises(SingularError) if singular else nullcontext():
            plain_inverse(cutoff)(one, one @ np.ones(6), None)
        if singular:
            with pytest.raises((SingularError, np.linalg.LinAlgError)):
                plain_inverse(cutoff).inverses(np.array([np.eye(6), one]))


def test_regularity_check_refuses_nearby_singular_jacobian():
    """The check knows only a nearby inverse. It must refuse a singular J and may refuse others."""
    known = np.array([np.eye(6)])
    nearby = np.array([np.diag([1.0, 1, 1, 1, 1, 0.9])])
    plain_inverse(0.05).require_regular_near(nearby, known, known)
    for smallest, cutoff in ((0.0, 1e-9), (0.9, 0.3)):
        nearby[0, 5, 5] = smallest
        with pytest.raises(SingularError):
            plain_inverse(cutoff).require_regular_near(nearby, known, known)


def test_levenberg_damping_grows_with_error():
    J, error = np.diag([1.0, 2, 3, 1, 1, 0.3]), np.array([0, 0, 0, 0, 0, 0.5])
    np.testing.assert_allclose(levenberg(0.2)(J, error, None)[5], 0.3 * 0.5 / (0.3**2 + 0.1))


@pytest.mark.parametrize("size", [1e-6, 1e-3, 0.02, 0.03, 1.0])
def test_rates_at_small_singular_value(size):
    J, last = np.diag([1.0, 1, 1, 1, 1, size]), np.eye(6)[5]
    rates = [remedy(J, last, None)[5] for remedy in (damped(0.02), pseudo_inverse(1e-2))]
    assert rates == pytest.approx([size / (size**2 + 0.02**2), (size > 1e-2) / size])


def make_report(q, q_dot, poses):
    """Return the report on invented joint values and poses of the locked Panda along a circle."""
    path = circle([0, 0, 0], 0.1, "zy", 2.0, len(q) - 1)
    return summary(REAL, path, np.asarray(q, float), np.asarray(q_dot, float), poses)


def test_report_matches_hand_calculation():
    q = np.tile(REAL.home, (5, 1))
    q_dot, poses = np.zeros((5, 6)), np.tile(np.eye(4), (5, 1, 1))
    poses[:, :3, 3] = [[0, 0, 0.1], [0, 0.1, 0], [0, 0, -0.1], [0, -0.1, 0], [0, 0, 0.1]]
    clean = make_report(q, q_dot, poses)
    assert clean.executable
    assert clean.position_error == pytest.approx(0, abs=1e-15)
    assert (clean.pen_tilt, clean.closing_gap, clean.joint_gap) == (0, 0, 0)
    poses[0, :3, 3] += [0, 0, 0.003]
    poses[2, :3, 3] += [-0.004, 0.002, 0]
    poses[3, :3, :3] = [
        [1, 0, 0],
        [0, -0.5, -np.sqrt(0.75)],
        [0, np.sqrt(0.75), -0.5],
    ]  # 120 deg about x
    poses[1, :3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]  # a roll is no tilt
    q[1, 3], q[2, 4], q[4, 0] = -3.0, 3.9, -0.25
    q_dot[2] = [0, -3.5, 0, 0, 1.305, 0]
    q_dot[[0, 3, 4]] = np.outer([1.5, 3, 1], [0.25, 0, 0, 0, 0, -0.125])
    found = make_report(q, q_dot, poses)
    assert found.position_error == pytest.approx(np.hypot(0.004, 0.002))
    assert found.off_wall == pytest.approx(0.004)
    back = poses.copy()
    back[:, 0, 3] *= -1
    assert make_report(q, q_dot, back).off_wall == pytest.approx(0.004)
    assert found.pen_tilt == pytest.approx(np.radians(120))
    assert found.closing_gap == pytest.approx(0.003)
    assert found.joint_gap == pytest.approx(0.25)
    assert [joint for joint, _ in found.beyond_limits] == [5, 6]
    assert [over for _, over in found.beyond_limits] == pytest.approx([3.0 - 2.8973, 3.9 - 3.7525])
    assert [joint for joint, _ in found.beyond_speed] == [2]
    assert found.beyond_speed[0][1] == pytest.approx(3.5 - 2.175)
    assert found.largest_speed == 3.5
    assert found.speed_share == pytest.approx(3.5 / 2.175)
    assert found.largest_acceleration == pytest.approx(3.5 / 0.5)
    assert found.speed_from_rest == make_report(q, q_dot[::-1], poses).speed_from_rest == 0.375
    assert (clean.largest_acceleration, clean.speed_from_rest) == (0, 0)
    assert "joint 5 by 0.1 rad, joint 6 by 0.15 rad" in str(found)
    assert not make_report(np.tile(REAL.home, (5, 1)), q_dot, poses).executable
    assert not make_report(q, 0 * q_dot, poses).executable
    assert "below 1e-10 m" in str(clean)


def test_report_shows_singular_configuration():
    """Chapter 3 checks reports near singular configurations."""
    home = trace(UR10E_HOMEWORK, np.zeros(6), ur_circle(10), rates=damped(0.1)).report
    assert home.largest_condition > 1e12
    assert "above 1e12" in str(home)


def same_jacobian(arm, q):
    """Return the arm's Jacobian; as a function of the caller it makes `trace` use the slow loop."""
    return jacobian(arm, q)


ELBOW_OUT = PANDA.lock(3, at=np.radians(70))
OUT = np.radians([-107.7, 44.5, 81.8, 100.0, 147.4, 50.9])  # Newton overshoots first
RUNS = {
    "elbow out": (ELBOW_OUT, OUT, circle_below(ELBOW_OUT, OUT, 0.1, "zy", 5.0, 300)),
    "UR10e": (UR10E, [0.4, -1.2, 1.6, -0.9, 1.2, 0.3], None),
    "uneven": (HOMEWORK, HOMEWORK.home, replace(panda_circle(200), times=5 * np.linspace(0, 1,
    151) ** 2)),
}  # fmt: skip


@pytest.mark.parametrize("method", ["euler", "rk4", "exact"])
@pytest.mark.parametrize("name", RUNS)
def test_vectorized_trace_matches_stepwise_trace(name, method, monkeypatch):
    arm, start, path = RUNS[name]
    if path is None:
        tip = forward_kinematics(arm, start)[:3, 3]
        path = circle(tip - [0, 0, 0.05], 0.05, "zx", 4.0, 200)
    slow = trace(arm, start, path, method=method, jacobian=same_jacobian)
    monkeypatch.delattr(tracing, "_steps_in_turn")
    fast = trace(arm, start, path, method=method)
    np.testing.assert_allclose(fast.q, slow.q, atol=3e-12)
    np.testing.assert_allclose(fast.q_dot, slow.q_dot, atol=1e-9)


def test_homework_circle_is_traced_without_the_loop(monkeypatch):
    monkeypatch.delattr(tracing, "_steps_in_turn")
    trace(HOMEWORK, HOMEWORK.home, panda_circle(1000))


def test_vectorized_trace_fails_like_stepwise_trace():
    """The circle straightens the UR10e's elbow, so both must fail at the same step with the same
    message."""
    start = np.array([0.0, -1.2, 0.5, -0.9, 1.2, 0.3])
    tip = forward_kinematics(UR10E, start)[:3, 3]
    path = circle(tip + np.array([0.3, 0, 0]), 0.3, "xz", 4.0, 300, phase=np.pi)
    errors = []
    for how in ({}, {"jacobian": same_jacobian}):
        with pytest.raises(ArmError) as error:
            trace(UR10E, start, path, method="exact", **how)
        errors.append((error.type, str(error.value)))
    assert errors[0] == errors[1]
    assert "UR10e, step " in errors[0][1]


def test_circle_out_of_reach_raises():
    path = circle([1.3, 0, 0.5], 0.3, "yz", 5.0, 200)
    start = np.array([0.0, -1.2, 1.6, -0.9, 1.2, 0.3])
    with pytest.raises(
        UnreachableError, match="step 0 of 200: after 30 iterations of Newton's method the tip is"
    ):
        trace(UR10E, start, path, method="exact")
    whole = circle(forward_kinematics(UR10E, start)[:3, 3] - [0, 0, 0.9], 0.9, "zy", 5.0, 400)
    with pytest.raises(UnreachableError, match=r"step [1-9]\d* of 400: .* out of reach"):
        trace(UR10E, start, whole, method="exact")


def test_joint_jump_raises():
    """The rates turn joint 4 by an extra whole turn, so the tip is right but the motion is not."""

    def once_more(J, error, q):
        return np.linalg.solve(J, error) + 2 * np.pi * (np.abs(error).max() > 1e-6) * np.eye(6)[3]

    with pytest.raises(
        UnreachableError,
        match=r"step 0 of 50: joint 5 would turn by [\d.]+ rad at once; expected half",
    ):
        trace(HOMEWORK, HOMEWORK.home, panda_circle(50), method="exact", rates=once_more)


def test_branch_change_is_detected():
    """The second half uses the other elbow: each pose is right, but the joints jump once."""
    start = [0.4, -1.2, 1.6, -0.9, 1.2, 0.3]
    tip = forward_kinematics(UR10E, start)[:3, 3]
    path = circle(tip - [0, 0, 0.05], 0.05, "zx", 4.0, 100)
    run = trace(UR10E, start, path, method="exact")
    course = sample_path(path, "exact", run.poses[0, :3, :3])
    assert at_once._is_on_branch(UR10E, run.q, course, plain_inverse())
    flipped = run.q.copy()
    flipped[50:] = follow(partial(ur, UR10E), run.poses[50:], ur(UR10E, run.poses[50]).q[0])
    np.testing.assert_allclose(forward_kinematics(UR10E, flipped), run.poses, atol=1e-9)
    assert np.abs(flipped[50] - run.q[50]).max() > 0.5
    assert not at_once._is_on_branch(UR10E, flipped, course, plain_inverse())
    for share, near in ((0.1, True), (0.5, False)):
        moved = run.q.copy()
        moved[51] += share * (run.q[51] - run.q[50])
        assert at_once._is_on_branch(UR10E, moved, course, plain_inverse()) == near


def test_exact_method_uses_given_jacobian():
    """With J too large by a tenth, Newton's method converges slowly; with the identity it fails."""
    seen = []

    def too_large(arm, q):
        seen.append(q)
        return 1.1 * jacobian(arm, q)

    path = panda_circle(40)
    run = trace(HOMEWORK, HOMEWORK.home, path, method="exact", jacobian=too_large)
    assert len(seen) > 9 * 40
    assert run.report.position_error < 1e-11
    with pytest.raises(UnreachableError):
        trace(HOMEWORK, HOMEWORK.home, path, method="exact", jacobian=lambda arm, q: np.eye(6))


def spoil_inputs(function):
    """Return a function that calls `function` and then overwrites its array arguments."""

    def spoiling(*given):
        found = function(*given)
        for array in given:
            if np.ndim(array):
                array += 1.0
        return found

    return spoiling


@pytest.mark.parametrize("method", ["euler", "rk4", "exact"])
def test_callbacks_cannot_change_arrays_of_trace(method):
    path = panda_circle(30)
    spoilt = replace(
        path,
        velocity=spoil_inputs(path.velocity),
        position=spoil_inputs(path.position),
    )
    how = {
        "jacobian": spoil_inputs(same_jacobian),
        "rates": spoil_inputs(plain_inverse()),
    }
    run = trace(HOMEWORK, HOMEWORK.home, spoilt, method=method, **how)
    expected = trace(HOMEWORK, HOMEWORK.home, path, method=method, jacobian=same_jacobian)
    np.testing.assert_array_equal(run.q, expected.q)
    np.testing.assert_array_equal(spoilt.times, path.times)


def test_path_copies_its_arrays():
    centre, times = np.array([0.5, 0.0, 0.6]), np.array([0.0, 1.0])
    round_it = circle(centre, 0.1, "yz", 5.0, 4)
    clock = spoil_inputs(lambda t: np.stack([t, t, t], axis=-1))
    path = Path(times, clock, clock, [1, 0, 0])
    expected = round_it.positions
    centre += 1.0
    times += 1.0
    np.testing.assert_array_equal(round_it.positions, expected)
    for found in (path.positions, path.velocities):
        np.testing.assert_array_equal(found[:, 0], [0, 1])


@pytest.mark.parametrize("method", ["euler", "rk4"])
def test_path_with_constant_velocity_is_traced(method):
    """The velocity function returns a single vector for any number of times."""
    straight = Path(
        np.linspace(0, 1, 61),
        lambda t: TOP + 0.1 * np.asarray(t)[..., None] * [0, 1, 0],
        lambda t: np.array([0, 0.1, 0]),
        [1, 0, 0],
    )
    run = trace(HOMEWORK, HOMEWORK.home, straight, method=method)
    assert run.report.position_error < 1e-3
    np.testing.assert_allclose(run.poses[-1, :3, 3], TOP + np.array([0, 0.1, 0]), atol=1e-3)


@pytest.mark.parametrize(
    ("arm", "start", "how", "words"),
    [
        (HOMEWORK, HOMEWORK.home, {"method": "exact", "gain": 5.0}, "gain is 5.0; expected 0 with"),
        (PANDA, PANDA.home, {}, "J is 6 x 7 and has no inverse; lock a joint"),
        (ELBOW, [0.1, 0.4, -0.9], {}, "J is 6 x 3 and has no inverse: 3 joints cannot give a tip"),
        (UR10E_HOMEWORK, [0] * 6, {}, "step 0 of 10: J has no inverse here: its smallest singular"
         " value is below 1e-12, its largest 2.3"),
    ],
)  # fmt: skip
def test_untraceable_task_raises_with_reason(arm, start, how, words):
    with pytest.raises(ArmError) as error:
        trace(arm, start, circle_below(arm, start, 0.1, "zx", 5.0, 10), **how)
    assert words in str(error.value)
    assert isinstance(error.value, SingularError) == ("J" in words)


def test_zero_damping_raises_at_singular_configuration():
    rank_one = np.outer(np.arange(1.0, 7), np.ones(6)) * [1, 0, 0, 0, 0, 0]
    with pytest.raises(SingularError, match="the damping is 0"):
        damped(0.0)(rank_one, np.ones(6), np.zeros(6))
    assert np.isfinite(damped(0.1)(rank_one, np.ones(6), np.zeros(6))).all()


def test_rest_to_rest_follows_quintic():
    """The conditions of the quintic are checked, not its formula.

    The path rests at both ends without acceleration, has 15/8 of the even speed halfway, and its
    velocities are the slopes of its positions.
    """
    even = circle([1, 2, 3], 0.1, "zy", 5.0, 10)
    path = rest_to_rest(even)
    np.testing.assert_allclose(path.position([0, 5]), even.position([0, 5]), atol=1e-15)
    np.testing.assert_allclose(path.position(2.5), even.position(2.5), atol=1e-15)
    np.testing.assert_array_equal(path.velocity([0, 5]), np.zeros((2, 3)))
    np.testing.assert_allclose(path.velocity(2.5), 15 / 8 * even.velocity(2.5), atol=1e-15)
    t, h = np.linspace(0.1, 4.9, 20), 1e-6
    slope = (path.position(t + h) - path.position(t - h)) / (2 * h)
    np.testing.assert_allclose(path.velocity(t), slope, atol=1e-8)
    for end in (h, 5 - h):
        assert np.linalg.norm(path.velocity(end)) < 1e-10  # error of order h squared
    off_circle = np.linalg.norm(path.position(t) - [1, 2, 3], axis=1)
    np.testing.assert_allclose(off_circle, 0.1, atol=1e-15)


def test_rest_to_rest_keeps_start_time():
    line = Path([2.0, 3.0, 6.0], lambda t: np.multiply.outer(np.asarray(t), [1.0, 0, 0]),
                lambda t: np.broadcast_to([1.0, 0, 0], (*np.shape(t), 3)), [0, 0, 1])  # fmt: skip
    path = rest_to_rest(line)
    np.testing.assert_array_equal(path.times, line.times)
    np.testing.assert_allclose(path.position([2, 4, 6])[:, 0], [2, 4, 6], atol=1e-14)
    np.testing.assert_allclose(path.velocity([2, 4, 6])[:, 0], [0, 15 / 8, 0], atol=1e-14)


def test_range_violations_use_unit_of_joint():
    """Chapter 3 prints the other lines of the report."""
    report = make_report(
        np.tile(REAL.home, (5, 1)), np.zeros((5, 6)), np.tile(np.eye(4), (5, 1, 1))
    )
    slid = replace(report, beyond_limits=((2, 0.125), (4, 1.0)), sliding=(4, 5))
    assert dict(slid.rows())["joints beyond their range"] == "joint 2 by 0.12 rad, joint 4 by 1 m"
    assert not slid.executable
    assert not replace(report, beyond_speed=((1, 0.1),)).executable


def test_report_says_if_no_limits_are_known():
    path = circle_below(STANFORD, [0.1, 0.8, 0.5, 0.3, 0.9, 0.2], 0.02, "yz", 5.0, 20)
    run = trace(STANFORD, [0.1, 0.8, 0.5, 0.3, 0.9, 0.2], path)
    lines = dict(run.report.rows())
    assert lines["largest joint speed"].endswith("rad/s, no limit is known")
    assert lines["joints beyond their speed"] == "no limit is known"
    assert lines["joints beyond their range"] == "none", "the slide has a range"
    assert repr(run).startswith("Stanford arm, 20 steps in 5 s\nlargest position error")


def test_report_contains_distance_out_of_reach():
    start = np.array([0.2, 0.6, -1.0])
    first = tip(ELBOW, start)
    end = first + 0.8 * np.array([np.cos(0.2), np.sin(0.2), 0])
    path = line(first, end, period=2, steps=100)
    report = trace(ELBOW, start, path, rates=pseudo_inverse()).report
    assert report.out_of_reach == pytest.approx(elbow(ELBOW, end).distance, abs=1e-4)
    assert "the path leads 711 mm out of the arm's reach" in str(report)


def test_report_of_a_path_within_reach_gives_no_reason():
    start = np.array([0.2, 0.6, -1.0])
    first = tip(ELBOW, start)
    path = line(first, first - [0.2, 0, 0], period=2, steps=3)
    report = trace(ELBOW, start, path, rates=pseudo_inverse()).report
    assert report.position_error > 1e-3
    assert report.out_of_reach == 0
    assert "reason" not in str(report)
