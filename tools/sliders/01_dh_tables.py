# beside matrix
# Other lengths (m) of the elbow arm: its frames at home, its pose and its Jacobian follow.
import matplotlib.pyplot as plt
from IPython.display import display
from ipywidgets import interact

from helpers import kinematics, plotting, show
from helpers.robots import ELBOW


@interact(a_2=(0.1, 0.8, 0.05), d=(0, 0.3, 0.05))
def with_lengths(a_2=0.4, d=0.1):
    arm = ELBOW.with_values(a_2=a_2, d=d)
    ax = plt.figure(figsize=(5, 4)).add_subplot()
    plotting.arm_drawing(ax, arm, arm.home, (-60, 18))
    plotting.frames(ax, arm, arm.home, (-60, 18), 0.16)
    plt.show()
    T, J = kinematics.forward_kinematics(arm, arm.home), kinematics.jacobian(arm, arm.home)
    display(show.matrices({"{}^0T_3": T, "J": J}))
