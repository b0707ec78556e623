"""The homework's Euler loop of 1000 steps, written with each program."""

from functools import partial

import numpy as np
import pinocchio
from kinematics import BARE, SIGNS, Pinocchio, ets

from helpers.motion import circle, trace
from helpers.robots import PANDA

FREE = [0, 1, 3, 4, 5, 6]  # joint 3 is locked
STEP = 5.0 / 1000


def looped(jacobian_of, path, start: np.ndarray) -> np.ndarray:
    """q_{k+1} = q_k + dt J^-1 xi with another program's 6 x 7 Jacobian, column 3 left out."""
    q, run = np.array(start), np.empty((len(path.times), 7))
    run[0] = q
    for k, v in enumerate(path.velocities[:-1]):
        J = jacobian_of(q)[:, FREE]
        q[FREE] += STEP * np.linalg.solve(J, np.concatenate([v, np.zeros(3)]))
        run[k + 1] = q
    return np.delete(run, 2, axis=1)


def cases(Case):
    pin, chain, arm = Pinocchio(), ets(), BARE.lock(3)
    path = circle([0.5735, 0, 0.7195], 0.1, "zy", 5.0, 1000)
    axes = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED

    def with_pinocchio(q):
        return (
            pinocchio.computeFrameJacobian(pin.model, pin.data, SIGNS * q, pin.frame, axes) * SIGNS
        )

    peers = {
        "the loop with Pinocchio": partial(looped, with_pinocchio, path, PANDA.home),
        "the loop with roboticstoolbox": partial(looped, chain.jacob0, path, PANDA.home),
    }
    yield Case("Euler trace, 1000 steps", lambda: trace(arm, arm.home, path).q, peers, 1e-9, 5)
