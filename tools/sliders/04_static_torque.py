# beside loads
# Another force on the pen (N), and the torques (N m) that it asks of the joints.
from ipywidgets import interact

from helpers import statics
from helpers.robots import PANDA


@interact(F_x=(-60, 60, 5), F_y=(-60, 60, 5), F_z=(-60, 60, 5))
def pushed(F_x=-5, F_y=0, F_z=0):
    tau = statics.static_torque(PANDA, PANDA.home, [F_x, F_y, F_z, 0, 0, 0])
    for i, (torque, most) in enumerate(zip(tau, PANDA.effort_limits, strict=True), 1):
        bar = "#" * round(40 * abs(torque) / most)
        print(f"joint {i}: {torque:8.3f} N m, {abs(torque) / most:4.0%} of its limit {bar}")
