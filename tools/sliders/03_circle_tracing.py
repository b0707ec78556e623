# beside winds
# Another circle from another start: its radius, and where joint 3 is locked.
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
    turned = np.degrees(run.q[-1] - run.q[0]).round(1)
    print("off by at most", f"{1000 * run.report.position_error:.2g} mm; joints turned {turned}°")
