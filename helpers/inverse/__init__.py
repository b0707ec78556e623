"""Inverse kinematics: closed forms with every branch, and a numeric solver for any arm."""

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
    "solve",
    "spherical_wrist",
    "stanford",
    "ur",
]
