"""Derive a Denavit-Hartenberg table from joint axes, row by row, as by hand.

Draw the arm in some configuration, and give each joint's axis, the base and the tip. `derive` then
places the frames: z_{i-1} on axis i, x_i along the common normal from z_{i-1} to z_i, o_i where
that normal meets z_i. The four numbers of a row take frame i-1 to frame i. Choices that the
convention leaves open are always made in the same way. The drawn configuration is q = 0.

Source: Spong,
Hutchinson and Vidyasagar, Robot Modeling and Control, section 3.2.2; Craig, Introduction to
Robotics, section 3.4, for the modified table, which has the same common normals.
"""

from helpers.derive.steps import derive
from helpers.derive.values import Axis, Derivation, DerivationStep, Line

__all__ = ["Axis", "Derivation", "DerivationStep", "Line", "derive"]
