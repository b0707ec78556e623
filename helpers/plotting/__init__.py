"""Draw arms, paths and torques with Matplotlib in the style of the book.

Functions called `plot_...` label the axes with their units, functions called `draw_...` draw shapes
in m. Both draw on the axes that they receive and return None.
"""

from helpers.plotting.branches import (
    draw_law_of_cosines,
    draw_shoulder_triangles,
    draw_ur_triangle,
    draw_wrist_triangles,
    plot_regions,
)
from helpers.plotting.dh import draw_dh_numbers
from helpers.plotting.drawing import (
    draw_angle,
    draw_arm,
    draw_dimension,
    draw_frames,
    draw_joint_axes,
    draw_lengths,
    draw_postures,
    draw_row,
    project_points,
)
from helpers.plotting.plane import draw_arrow, plot_arm
from helpers.plotting.style import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, SKY, use_book_style
from helpers.plotting.torque_plots import plot_torque_shares, plot_torques
from helpers.plotting.traces import animate_trace, plot_joints, plot_path

__all__ = [
    "BLUE",
    "GREEN",
    "GREY",
    "ORANGE",
    "PURPLE",
    "RED",
    "SKY",
    "animate_trace",
    "draw_angle",
    "draw_arm",
    "draw_arrow",
    "draw_dh_numbers",
    "draw_dimension",
    "draw_frames",
    "draw_joint_axes",
    "draw_law_of_cosines",
    "draw_lengths",
    "draw_postures",
    "draw_row",
    "draw_shoulder_triangles",
    "draw_ur_triangle",
    "draw_wrist_triangles",
    "plot_arm",
    "plot_joints",
    "plot_path",
    "plot_regions",
    "plot_torque_shares",
    "plot_torques",
    "project_points",
    "use_book_style",
]
