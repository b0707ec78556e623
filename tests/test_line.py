"""Test straight paths of the tip."""

import numpy as np
import pytest

from helpers.arm import ArmError
from helpers.kinematics import tip
from helpers.motion import line, rest_to_rest, trace
from helpers.robots import UR10E

START = [0.0, -1.0, 1.2, -1.0, -1.5, 0.0]


def test_line_is_straight_at_constant_speed():
    path = line([1, 2, 3], [1, 2, 5], period=4, steps=8)
    assert path.positions == pytest.approx(np.linspace([1, 2, 3], [1, 2, 5], 9))
    assert path.velocities == pytest.approx(np.tile([0, 0, 0.5], (9, 1)))
    assert path.normal @ [0, 0, 1] == pytest.approx(0)
    assert np.linalg.norm(path.normal) == pytest.approx(1)


def test_traced_line_ends_at_its_last_point():
    first = tip(UR10E, START)
    last = first + np.array([0.1, -0.2, 0.05])
    run = trace(UR10E, START, rest_to_rest(line(first, last, period=3, steps=300)), method="rk4")
    assert tip(UR10E, run.q[-1]) == pytest.approx(last, abs=1e-7)
    assert run.report.off_wall < 1e-7


def test_line_needs_two_points():
    with pytest.raises(ArmError, match=r"start and end are both .*; expected two different"):
        line([1, 2, 3], [1, 2, 3], period=1, steps=1)
