# beside columns
# The Jacobian of another arm (m) in another pose (rad), and how near it is to losing rank.
import numpy as np
from IPython.display import display
from ipywidgets import interact

from helpers import kinematics, show
from helpers.robots import UR10E_HOMEWORK


@interact(a_3=(0.3, 0.8, 0.01), q_3=(-3.1, 3.1, 0.1), q_5=(-3.1, 3.1, 0.1))
def with_length_and_joints(a_3=0.57, q_3=-0.9, q_5=0.6):
    arm = UR10E_HOMEWORK.with_values(a_3=a_3)
    J = kinematics.jacobian(arm, [0.5, 0.5, q_3, -1.0, q_5, 0.3])
    display(show.matrices({"J": J}))
    print("smallest singular value:", np.linalg.svd(J, compute_uv=False)[-1].round(4))
