"""Test trajectories that are joined end to end."""

from dataclasses import replace

import numpy as np
import pytest

from helpers.arm import ArmError
from helpers.kinematics import forward_kinematics
from helpers.motion import circle, join_traces, trace
from helpers.robots import PANDA_HOMEWORK

ARM = PANDA_HOMEWORK.lock(3)
TOP = np.array([0.679, 0, 0.825])


def halves():
    """Trace a quarter of the homework's circle, then back in half the steps' length."""
    there = circle(TOP - [0, 0, 0.1], 0.1, "zy", 20.0, 40)
    there = replace(there, times=there.times[:11] + 0.0)
    first = trace(ARM, ARM.home, there, method="exact")
    back = replace(
        there,
        times=np.linspace(3.0, 5.5, 21),
        position=lambda t: there.position(5 - 2 * (np.asarray(t) - 3)),
        velocity=lambda t: -2 * there.velocity(5 - 2 * (np.asarray(t) - 3)),
    )
    return first, trace(ARM, first.q[-1], back, method="exact")


def test_joined_trace_has_all_steps():
    first, second = halves()
    run = join_traces([first, second])
    assert run.q.shape == run.q_dot.shape == (31, 6)
    assert run.t[0] == 0
    assert np.diff(run.t) == pytest.approx([0.5] * 10 + [0.125] * 20)
    assert run.q[10] == pytest.approx(first.q[-1])
    assert run.q[-1] == pytest.approx(first.q[0], abs=1e-9)
    assert run.poses == pytest.approx(forward_kinematics(ARM, run.q))
    assert run.report.position_error < 1e-12
    assert run.report.joint_gap < 1e-9


def test_joined_rates_match_following_steps():
    first, second = halves()
    run = join_traces([first, second, first])
    steps = np.diff(run.q, axis=0) / np.diff(run.t)[:, None]
    assert run.q_dot[:-1] == pytest.approx(steps)
    changes = np.abs(np.diff(steps, axis=0)) / np.diff(run.t)[:-1, None]
    assert run.report.largest_acceleration == pytest.approx(changes.max())


def test_joined_path_uses_the_piece_of_each_time():
    path = join_traces(halves()).path
    t = np.array([[1.0, 4.9], [5.1, 7.3]])
    h = 1e-6
    slope = (path.position(t + h) - path.position(t - h)) / (2 * h)
    assert path.velocity(t) == pytest.approx(slope, abs=1e-8)
    assert path.position(7.5) == pytest.approx(TOP, abs=1e-12)
    there = circle(TOP - [0, 0, 0.1], 0.1, "zy", 20.0, 40)
    assert path.position([4.9, 5.1]) == pytest.approx(there.position([4.9, 4.8]), abs=1e-12)
    twice = join_traces(2 * halves()).path
    assert twice.times[-1] == pytest.approx(15)
    assert twice.position([8.5, 14.5]) == pytest.approx(there.position([1.0, 1.0]), abs=1e-12)


def test_joined_traces_must_fit():
    first, second = halves()
    assert join_traces([first]).q == pytest.approx(first.q)
    with pytest.raises(ArmError, match="runs are none"):
        join_traces([])
    with pytest.raises(ArmError, match="runs are 3; expected one or more runs"):
        join_traces(3)
    away = replace(second, q=second.q + 0.1)
    beside = replace(second, q=second.q + 2e-6 * (np.abs(second.q) > 1))
    other = replace(second, arm=PANDA_HOMEWORK.lock(3, at=0.1))
    for runs, message in (
        ([first, first], "run 1 ends at [^;]*; expected the same"),
        ([first, replace(second, q=second.q * 1.5)], "run 1 ends at [^;]*; expected the same"),
        ([first, beside], "run 1 ends at [^;]*; expected the same"),
        ([first, second, away], "run 2 ends at [^;]*; expected the same"),
        ([first, other], "run 1 is .* expected one arm"),
    ):
        with pytest.raises(ArmError, match=message):
            join_traces(runs)
