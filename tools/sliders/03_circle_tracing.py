# beside winds
# Another circle from another start: its radius (m), and where joint 3 is locked (rad).
import matplotlib.pyplot as plt
import numpy as np
from ipywidgets import interact

from helpers import kinematics, motion, plotting
from helpers.robots import PANDA_HOMEWORK


@interact(radius=(0.02, 0.15, 0.01), q_3=(-1.5, 1.5, 0.1))
def round_a_circle(radius=0.1, q_3=0.0):
    arm = PANDA_HOMEWORK.lock(3, at=q_3)
    top = kinematics.tip(arm, arm.home)
    path = motion.circle(top - [0, 0, radius], radius, "zy", 5, 200)
    try:
        run = motion.trace(arm, arm.home, path)
    except motion.SingularError as error:
        print(error)
        return
    plotting.path_2d(plt.gca(), run)
    plt.show()
    print(f"off by at most {1000 * run.report.position_error:.2f} mm; ", end="")
    print(f"smallest singular value {run.report.smallest_singular_value:.4f}")
    moved = np.degrees(run.q[-1] - run.q[0]).round(1) + 0.0
    for joint, turned in zip(arm.joints, moved, strict=True):
        print(f"joint {joint} ends {turned:6.1f}° from where it began")
