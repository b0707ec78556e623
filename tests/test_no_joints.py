"""Test that an arm without joints, or of the wrong kind, is refused with a message."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from helpers import motion, plotting
from helpers.arm import Arm, ArmError, Body, fixed
from helpers.checks import compare_torques
from helpers.inverse import solve
from helpers.robots import ELBOW, PANDA, UR10E

BRACKET = Arm("bracket", [fixed(d=0.3)], bodies=[Body(1, (0, 0, 0))])
PATH = motion.line([0, 0, 0.3], [0, 0.1, 0.3], period=1, steps=4)


@pytest.mark.parametrize(
    "call",
    [
        lambda: motion.trace(BRACKET, [], PATH),
        lambda: motion.self_motion_directions(BRACKET, []),
        lambda: motion.self_motion(BRACKET, [], [], 0.1),
        lambda: compare_torques([], BRACKET, []),
        lambda: solve(BRACKET, [0, 0, 0.3]),
    ],
)
def test_arm_without_joints_is_refused(call):
    with pytest.raises(ArmError, match="bracket has no joints; expected an arm with one joint"):
        call()


def test_drawings_refuse_other_kinds_of_arm():
    ax = Figure().add_subplot()
    with pytest.raises(ArmError, match="Elbow arm is no arm of the UR family; expected 6 turning"):
        plotting.draw_ur_triangle(ax, ELBOW, ELBOW.home)
    with pytest.raises(ArmError, match="Panda is no elbow arm; expected 3 turning joints"):
        plotting.draw_law_of_cosines(ax, PANDA, PANDA.home)


def test_solve_refuses_an_array_of_limits():
    with pytest.raises(ArmError, match=r"(?s)limits is array.* expected True or False. .*with_r"):
        solve(UR10E, np.eye(4), limits=np.ones((2, 6)))
