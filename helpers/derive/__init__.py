"""From the joint axes of an arm to its Denavit-Hartenberg table, row by row, as one does it by
hand.

Draw the arm in some pose, say where each joint's axis lies and where the base and the tip are, and
`derive` lays the frames: z_{i-1} on axis i, x_i along the common normal from z_{i-1} to z_i, o_i
where that normal meets z_i. The four numbers of a row take frame i-1 to frame i. Where the
convention leaves a choice it is always made the same way. The drawn pose is q = 0. Source: Spong,
Hutchinson and Vidyasagar, Robot Modeling and Control, section 3.2.2; Craig, Introduction to
Robotics, section 3.4, for the modified table, which has the same common normals.
"""

from helpers.derive.steps import derive
from helpers.derive.values import Axis, Derivation, Line, Step

__all__ = ["Axis", "Derivation", "Line", "Step", "derive"]
