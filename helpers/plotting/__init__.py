"""Draw arms, paths and torques with Matplotlib in the style of the book.

Every function draws on the axes that it is given and returns None.
"""

from helpers.plotting.branches import (
    law_of_cosines,
    regions,
    shoulder_triangles,
    ur_triangle,
    wrist_triangles,
)
from helpers.plotting.dh import dh_numbers
from helpers.plotting.drawing import (
    angle,
    arm_drawing,
    axis_lines,
    dimension,
    frames,
    lengths,
    postures,
    row_drawing,
    seen,
)
from helpers.plotting.plane import arm_2d, arrow_2d
from helpers.plotting.style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, use_book_style
from helpers.plotting.torques import torque_shares, torques
from helpers.plotting.traces import joints, moving_picture, path_2d

__all__ = [
    "BLUE",
    "GREEN",
    "GREY",
    "ORANGE",
    "PURPLE",
    "RED",
    "SKY",
    "angle",
    "arm_2d",
    "arm_drawing",
    "arrow_2d",
    "axis_lines",
    "dh_numbers",
    "dimension",
    "frames",
    "joints",
    "law_of_cosines",
    "lengths",
    "moving_picture",
    "path_2d",
    "postures",
    "regions",
    "row_drawing",
    "seen",
    "shoulder_triangles",
    "torque_shares",
    "torques",
    "ur_triangle",
    "use_book_style",
    "wrist_triangles",
]
