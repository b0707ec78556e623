"""Time gravity torques of the Panda."""

from collections.abc import Callable
from functools import partial

import casadi
import jax
import jax.numpy as jnp
import mujoco
import numpy as np
import pinocchio
from kinematics import SIGNS, Pinocchio, list_casadi_calls, make_link_matrix, multiply_matrices

from helpers.kinematics import link_frames
from helpers.robots import PANDA
from helpers.statics import centres_in, gravity_torque

MASSES = [PANDA.number(body.mass) for body in PANDA.bodies]
CENTRES = np.array([[PANDA.number(c) for c in body.com] for body in PANDA.bodies])


def build_casadi_gravity() -> tuple[casadi.SX, casadi.SX]:
    """Build q and dP/dq by CasADi's automatic differentiation of the potential energy."""
    q, T, energy = casadi.SX.sym("q", 7), casadi.SX.eye(4), 0
    for k, (row, mass, centre) in enumerate(zip(PANDA.numeric, MASSES, CENTRES, strict=True)):
        T = T @ casadi.vertcat(
            *(
                casadi.horzcat(*line)
                for line in make_link_matrix(row, casadi.cos(q[k]), casadi.sin(q[k]))
            )
        )
        energy += 9.81 * mass * (T @ casadi.DM([*centre, 1]))[2]
    return q, casadi.gradient(energy, q)


def make_pinocchio_panda() -> pinocchio.Model:
    """Build Pinocchio's Panda with the same masses."""
    pin = Pinocchio()
    home = np.array(PANDA.home)
    frames = np.array([pin_frame.homogeneous for pin_frame in _compute_placements(pin, home)])
    for joint, (mass, centre) in enumerate(
        zip(MASSES, centres_in(frames, link_frames(PANDA, home)[1:], CENTRES), strict=True), 1
    ):
        pin.model.inertias[joint] = pinocchio.Inertia(mass, centre, np.zeros((3, 3)))
    return pin.model


def make_pinocchio_gravity(q: np.ndarray) -> Callable[[], np.ndarray]:
    """Return a function that calls Pinocchio once per configuration."""
    model = make_pinocchio_panda()
    data = model.createData()

    def work():
        torques = np.empty_like(q)
        for k, maker in enumerate(q * SIGNS):
            torques[k] = pinocchio.computeGeneralizedGravity(model, data, maker)
        return torques * SIGNS

    return work


def make_newton_euler_at_rest(q: np.ndarray, threads: int) -> Callable[[], np.ndarray]:
    """Return a function that runs Newton-Euler at rest for all configurations at once."""
    pool = pinocchio.ModelPool(make_pinocchio_panda(), threads)
    at_rest, torques = np.zeros(q.T.shape, order="F"), np.empty(q.T.shape, order="F")

    def work():
        pinocchio.rneaInParallel(threads, pool, (q * SIGNS).T, at_rest, at_rest, torques)
        return torques.T * SIGNS

    return work


def _compute_placements(pin: Pinocchio, q: np.ndarray):
    pinocchio.forwardKinematics(pin.model, pin.data, SIGNS * q)
    return list(pin.data.oMi)[1:]


def make_mujoco_gravity(q: np.ndarray) -> np.ndarray:
    """Return a function that runs MuJoCo's Newton-Euler at rest for each configuration."""
    model = mujoco.MjModel.from_xml_string(write_mujoco_panda())
    data = mujoco.MjData(model)

    def work():
        torques = np.empty_like(q)
        for k, joints in enumerate(q):
            data.qpos[:] = joints
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_rne(model, data, 0, torques[k])
        return torques

    return work


def write_mujoco_panda() -> str:
    """Write the table as nested MuJoCo bodies, each turning about its own z axis."""
    bodies = ""
    for row, mass, (x, y, z) in reversed(list(zip(PANDA.numeric, MASSES, CENTRES, strict=True))):
        c, s, half = row.cos_alpha, row.sin_alpha, np.arctan2(row.sin_alpha, row.cos_alpha) / 2
        nested = (
            f'<body pos="{row.a} 0 {row.d}" quat="{np.cos(half)} {np.sin(half)} 0'
            f' 0">{bodies}</body>'
        )
        bodies = (
            f'<joint axis="0 0 1"/><inertial pos="{row.a + x} {c * y - s * z}'
            f' {row.d + s * y + c * z}"'
            f' mass="{mass}" diaginertia="1 1 1"/>{nested if bodies else ""}'
        )
    return f"<mujoco><worldbody><body>{bodies}</body></worldbody></mujoco>"


def list_jax_calls(q: np.ndarray) -> dict[str, Callable[[], np.ndarray]]:
    """Compute dP/dq in JAX by 4 x 4 matrices and entry by entry over the batch."""
    jax.config.update("jax_enable_x64", True)

    def of_matrices(q):
        T, total = jnp.eye(4), 0.0
        for joint, row, mass, centre in zip(q, PANDA.numeric, MASSES, CENTRES, strict=True):
            T = T @ jnp.array(make_link_matrix(row, jnp.cos(joint), jnp.sin(joint)))
            total += 9.81 * mass * (T @ jnp.array([*centre, 1.0]))[2]
        return total

    def of_entries(q):
        T, total = np.eye(4).tolist(), 0.0
        for joint, row, mass, centre in zip(q, PANDA.numeric, MASSES, CENTRES, strict=True):
            T = multiply_matrices(T, make_link_matrix(row, jnp.cos(joint), jnp.sin(joint)))
            total += 9.81 * mass * sum(x * y for x, y in zip(T[2], [*centre, 1.0], strict=True))
        return total.sum()

    plain, best = jax.jit(jax.vmap(jax.grad(of_matrices))), jax.jit(jax.grad(of_entries))
    return {
        "JAX, jit of vmap of grad": lambda: np.asarray(plain(q)),
        "JAX, jit of grad, entry by entry over the batch": lambda: np.asarray(best(q.T)).T,
    }


def list_cases(Case):
    q = np.random.default_rng(0).uniform(*PANDA.limits, size=(1000, 7))
    of_casadi = {
        label: (lambda work=work: work(q)[..., 0])
        for label, work in list_casadi_calls(*build_casadi_gravity()).items()
    }
    peers = {
        **of_casadi,
        **list_jax_calls(q),
        "Pinocchio, in a loop": make_pinocchio_gravity(q),
        "Pinocchio, rneaInParallel at rest, 1 thread": make_newton_euler_at_rest(q, 1),
        "Pinocchio, rneaInParallel at rest, 2 threads": make_newton_euler_at_rest(q, 2),
        "MuJoCo, in a loop": make_mujoco_gravity(q),
    }
    yield Case(
        "gravity torque, 1 000 configurations", partial(gravity_torque, PANDA, q), peers, 1e-9, 31
    )
    single_pose = q[:1]
    peers = {
        "Pinocchio": make_pinocchio_gravity(single_pose),
        "MuJoCo": make_mujoco_gravity(single_pose),
    }
    ours = partial(gravity_torque, PANDA, single_pose)
    yield Case("gravity torque, one configuration", ours, peers, 1e-9, 31, calls=100)
