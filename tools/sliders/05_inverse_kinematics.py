# beside triangles
# Another target and another offset (m), and every way there.
import matplotlib.pyplot as plt
import numpy as np
from ipywidgets import interact

from helpers import inverse, plotting
from helpers.robots import ELBOW


@interact(x=(-0.8, 0.8, 0.05), y=(-0.8, 0.8, 0.05), z=(-0.2, 1.2, 0.05), d=(0, 0.2, 0.04))
def reached(x=0.35, y=0.25, z=0.7, d=0.12):
    arm = ELBOW.with_values(d=d)
    found = inverse.elbow(arm, [x, y, z])
    if not found.ways:
        print(f"out of reach by {found.distance:.3f} m")
        return
    axes = plt.figure(figsize=(8, 2.7)).subplots(1, len(found.ways), squeeze=False)[0]
    plotting.postures(axes, arm, list(found.ways.values()), found.ways, (-25, 25))
    plt.show()
    for name, q in found.ways.items():
        print(f"{name:17} q = {np.degrees(q).round(1) + 0.0}°")
    if found.free.any():
        print("joint 1 is free: any other angle does as well")
