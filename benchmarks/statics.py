"""Gravity torques of the Panda."""

from functools import partial

import casadi
import numpy as np
import pinocchio
from kinematics import SIGNS, Pinocchio, mapped

from helpers.kinematics import link_frames
from helpers.robots import PANDA
from helpers.statics import centres_in, gravity_torque

MASSES = [PANDA.number(body.mass) for body in PANDA.bodies]
CENTRES = np.array([[PANDA.number(c) for c in body.com] for body in PANDA.bodies])


def casadi_gravity() -> casadi.Function:
    """dP/dq by CasADi's automatic differentiation of the potential energy."""
    q, T, energy = casadi.SX.sym("q", 7), casadi.SX.eye(4), 0
    for k, (row, mass, centre) in enumerate(zip(PANDA.numeric, MASSES, CENTRES, strict=True)):
        c, s, ca, sa = casadi.cos(q[k]), casadi.sin(q[k]), row.cos_alpha, row.sin_alpha
        A = [
            [c, -s * ca, s * sa, row.a * c],
            [s, c * ca, -c * sa, row.a * s],
            [0, sa, ca, row.d],
            [0, 0, 0, 1],
        ]
        T = T @ casadi.vertcat(*(casadi.horzcat(*line) for line in A))
        energy += 9.81 * mass * (T @ casadi.DM([*centre, 1]))[2]
    return casadi.Function("gravity", [q], [casadi.gradient(energy, q)])


def pinocchio_gravity(q: np.ndarray) -> np.ndarray:
    """Pinocchio's Panda with the same masses, called once per configuration."""
    pin = Pinocchio()
    home = np.array(PANDA.home)
    frames = np.array([pin_frame.homogeneous for pin_frame in _placements(pin, home)])
    for joint, (mass, centre) in enumerate(
        zip(MASSES, centres_in(frames, link_frames(PANDA, home)[1:], CENTRES), strict=True), 1
    ):
        pin.model.inertias[joint] = pinocchio.Inertia(mass, centre, np.zeros((3, 3)))
    data = pin.model.createData()

    def work():
        found = np.empty_like(q)
        for k, maker in enumerate(q * SIGNS):
            found[k] = pinocchio.computeGeneralizedGravity(pin.model, data, maker)
        return found * SIGNS

    return work


def _placements(pin: Pinocchio, q: np.ndarray):
    pinocchio.forwardKinematics(pin.model, pin.data, SIGNS * q)
    return list(pin.data.oMi)[1:]


def cases(Case):
    q = np.random.default_rng(0).uniform(*PANDA.limits, size=(1000, 7))
    over = mapped(casadi_gravity(), 1000)
    peers = {
        "CasADi Function.map": lambda: over(q)[..., 0],
        "Pinocchio, in a loop": pinocchio_gravity(q),
    }
    yield Case("gravity torque, 1 000 poses", partial(gravity_torque, PANDA, q), peers, 1e-9, 31)
