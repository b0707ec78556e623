# beside matrix
# Another length: the table's numbers, the frames at home and the Jacobian follow.
from IPython.display import display
from ipywidgets import interact

from helpers import kinematics, show
from helpers.robots import ELBOW


@interact(a_2=(0.1, 0.8, 0.05), d=(0, 0.3, 0.05))
def with_lengths(a_2=0.4, d=0.1):
    arm = ELBOW.with_values(a_2=a_2, d=d)
    frames = kinematics.link_frames(arm, arm.home)
    display(arm, show.frames(frames), show.matrices({"J": kinematics.jacobian(arm, arm.home)}))
