"""Typical calls of a user, which only the type checker of `make lint` reads."""

from helpers.arm import Arm, prismatic, revolute
from helpers.kinematics import forward_kinematics
from helpers.motion import circle_below, trace

arm = Arm("mine", [revolute(a="a_1"), prismatic(alpha="pi/2")], values={"a_1": 0.3}, home=[0, 0.1])
length: float = arm.values["a_1"]
pose = forward_kinematics(arm.with_values(a_1=0.4), [0.1, 0.2])
run = trace(arm, arm.home, circle_below(arm, arm.home, 0.1, "zy", 5.0, 10))
report: str = str(run.report)
