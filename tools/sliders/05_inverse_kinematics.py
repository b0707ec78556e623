# beside triangles
# Another target (m), and every branch that reaches it.
import matplotlib.pyplot as plt
import numpy as np
from ipywidgets import interact

from helpers import inverse, plotting
from helpers.robots import ELBOW


@interact(x=(-0.8, 0.8, 0.05), y=(-0.8, 0.8, 0.05), z=(-0.2, 1.2, 0.05))
def reached(x=0.4, y=0.3, z=0.6):
    found = inverse.elbow(ELBOW, [x, y, z])
    print(np.round(found.q, 4))
    print("within the arm's limits:", found.within_limits)
    ax = plt.figure(figsize=(4, 4)).add_subplot()
    for q in found.q[found.valid]:
        plotting.arm_drawing(ax, ELBOW, q, (30, 18))
    plt.show()
