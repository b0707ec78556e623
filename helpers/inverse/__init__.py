"""Solve inverse kinematics in closed form with every branch, or numerically for any arm.

`solutions` takes any arm whose axes meet or are parallel; the closed forms that the chapters teach
stand beside it.
"""

from helpers.inverse.any_arm import solutions
from helpers.inverse.numeric import NumericSolution, solve
from helpers.inverse.shoulder import elbow, rod
from helpers.inverse.solutions import Solutions, follow
from helpers.inverse.ur import ur
from helpers.inverse.wrist import spherical_wrist, stanford

__all__ = [
    "NumericSolution",
    "Solutions",
    "elbow",
    "follow",
    "rod",
    "solutions",
    "solve",
    "spherical_wrist",
    "stanford",
    "ur",
]
