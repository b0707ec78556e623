"""Inverse kinematics: closed forms with every branch, and a numeric solver for any arm."""

from helpers.inverse.shoulder import elbow, rod
from helpers.inverse.solutions import Solutions, follow
from helpers.inverse.ur import ur
from helpers.inverse.wrist import spherical_wrist, stanford

__all__ = ["Solutions", "elbow", "follow", "rod", "spherical_wrist", "stanford", "ur"]
