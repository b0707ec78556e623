"""Time forward kinematics and Jacobians of the Panda."""

import shutil
import sysconfig
from collections.abc import Callable
from functools import partial
from pathlib import Path

import casadi
import jax
import jax.numpy as jnp
import numpy as np
import pinocchio
import roboticstoolbox as rtb

from helpers.arm import NumericRow
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import PANDA

SIGNS = np.array([1, -1, 1, -1, 1, 1, -1])
HALF_TURN = np.diag([1.0, -1.0, -1.0, 1.0])
BLOCK = 1000
BASE_AXES = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
BARE = PANDA.with_values(l_pen=0)  # the peers' tip is the flange


def make_toolbox_chain() -> rtb.ETS:
    """Return the table as roboticstoolbox's elementary transforms."""
    chain = rtb.ETS()
    for row in BARE.rows:
        a, alpha, d = (BARE.number(e) for e in (row.a, row.alpha, row.d))
        chain = chain * rtb.ET.Rz() * rtb.ET.tz(d) * rtb.ET.tx(a) * rtb.ET.Rx(alpha)
    return chain


def make_link_matrix(row: NumericRow, c, s) -> list[list]:
    """Return a row's transform for the cosine and sine of its joint angle."""
    ca, sa = row.cos_alpha, row.sin_alpha
    return [
        [c, -s * ca, s * sa, row.a * c],
        [s, c * ca, -c * sa, row.a * s],
        [0, sa, ca, row.d],
        [0, 0, 0, 1],
    ]


def build_casadi_expressions() -> tuple[casadi.SX, casadi.SX, casadi.SX]:
    """Build q, the pose and the Jacobian, with columns z x (o_n - o) over z, in CasADi."""
    q, T, frames = casadi.SX.sym("q", 7), casadi.SX.eye(4), []
    for k, row in enumerate(BARE.numeric):
        frames.append(T)
        T = T @ casadi.vertcat(
            *(
                casadi.horzcat(*line)
                for line in make_link_matrix(row, casadi.cos(q[k]), casadi.sin(q[k]))
            )
        )
    columns = [
        casadi.vertcat(casadi.cross(F[:3, 2], T[:3, 3] - F[:3, 3]), F[:3, 2]) for F in frames
    ]
    return q, T, casadi.horzcat(*columns)


def list_casadi_calls(
    q: casadi.SX, result: casadi.SX
) -> dict[str, Callable[[np.ndarray], np.ndarray]]:
    """Return functions that evaluate a CasADi expression for a batch, as users do and faster.

    The faster functions share equal steps (cse), fill in zeros, and work on the batch's own memory.
    CasADi stores matrices by column and NumPy by row, so the expression is transposed.
    """
    plain = casadi.Function("plain", [q], [result])
    dense = [casadi.cse(casadi.densify(result.T))]
    calls = {
        "CasADi, called with arrays, mapped": _call_with_arrays(plain.map(BLOCK), result.shape),
        "CasADi, shared steps, mapped, through buffers": _call_through_buffers(
            casadi.Function("dense", [q], dense), result.shape
        ),
    }
    if shutil.which("gcc"):
        flags = {
            "jit": True,
            "compiler": "shell",
            "jit_options": {"flags": ["-O3", "-march=native"]},
        }
        calls["CasADi, the same compiled by gcc"] = _call_through_buffers(
            casadi.Function("compiled", [q], dense, flags), result.shape
        )
    return calls


def _call_with_arrays(over: casadi.Function, shape: tuple[int, int]):
    rows, columns = shape

    def work(q):
        results = np.empty((len(q), rows, columns))
        for start in range(0, len(q), BLOCK):
            part = over(q[start : start + BLOCK].T).full()
            results[start : start + BLOCK] = part.T.reshape(-1, columns, rows).transpose(0, 2, 1)
        return results

    return work


def _call_through_buffers(function: casadi.Function, shape: tuple[int, int]):
    """Evaluate in blocks, which is faster than mapping a whole large batch."""
    over = function.map(BLOCK)
    buffer, run = over.buffer()

    def work(q):
        results = np.empty((len(q), *shape))
        for start in range(0, len(q), BLOCK):
            buffer.set_arg(0, memoryview(q[start : start + BLOCK]))
            buffer.set_res(0, memoryview(results[start : start + BLOCK]))
            run()
        return results

    return work


def multiply_matrices(left, right) -> list[list]:
    """Multiply two matrices as lists of rows, with numbers or batches as entries."""
    columns = list(zip(*right, strict=True))
    return [[sum(x * y for x, y in zip(line, c, strict=True)) for c in columns] for line in left]


def make_matrix_functions() -> tuple[Callable, Callable]:
    """Return functions that compute pose and Jacobian of a configuration from matrices."""

    def matrices(q):
        T = [jnp.eye(4)]
        for row, angle in zip(BARE.numeric, q, strict=True):
            A = make_link_matrix(row, jnp.cos(angle), jnp.sin(angle))
            T.append(T[-1] @ jnp.array(A))
        return T

    def pose(q):
        return matrices(q)[-1]

    def jac(q):
        *frames, tip = matrices(q)
        z = [F[:3, 2] for F in frames]
        arms = [jnp.cross(a, tip[:3, 3] - F[:3, 3]) for a, F in zip(z, frames, strict=True)]
        return jnp.concatenate([jnp.stack(arms, 1), jnp.stack(z, 1)])

    return pose, jac


def make_entry_functions() -> tuple[Callable, Callable]:
    """Return functions that compute poses and Jacobians of a batch entry by entry."""

    def entries(q):
        T = [np.eye(4).tolist()]
        for row, angle in zip(BARE.numeric, q, strict=True):
            T.append(
                multiply_matrices(T[-1], make_link_matrix(row, jnp.cos(angle), jnp.sin(angle)))
            )
        return T

    def stacked(lines, q):
        return jnp.stack([jnp.broadcast_to(x, q[0].shape) for line in lines for x in line])

    def pose_entries(q):
        return stacked(entries(q)[-1], q)

    def jac_entries(q):
        *frames, tip = entries(q)
        columns = []
        for F in frames:
            z, arm = [F[i][2] for i in range(3)], [tip[i][3] - F[i][3] for i in range(3)]
            turned = [z[j] * arm[k] - z[k] * arm[j] for j, k in ((1, 2), (2, 0), (0, 1))]
            columns.append([*turned, *z])
        return stacked(zip(*columns, strict=True), q)

    return pose_entries, jac_entries


def list_jax_calls() -> list[dict]:
    """Compute poses and Jacobians in JAX by 4 x 4 matrices and entry by entry."""
    jax.config.update("jax_enable_x64", True)

    def plain(function):
        over = jax.jit(jax.vmap(function))
        return lambda q: np.asarray(over(q))

    def best(function, shape):
        over = jax.jit(function)
        return lambda q: np.ascontiguousarray(over(q.T).T).reshape(-1, *shape)

    shapes = (4, 4), (6, 7)
    return [
        {
            "JAX, jit of vmap over 4 × 4 matrices": plain(slow),
            "JAX, jit, entry by entry over the batch": best(fast, shape),
        }
        for slow, fast, shape in zip(
            make_matrix_functions(), make_entry_functions(), shapes, strict=True
        )
    ]


class Pinocchio:
    """Call Pinocchio's Panda once per configuration."""

    def __init__(self) -> None:
        site = Path(sysconfig.get_paths()["purelib"])
        urdf = (
            site / "cmeel.prefix/share/example-robot-data/robots/panda_description/urdf/panda.urdf"
        )
        model = pinocchio.buildModelFromUrdf(str(urdf))
        fingers = [model.getJointId(f"panda_finger_joint{k}") for k in (1, 2)]
        self.model = pinocchio.buildReducedModel(model, fingers, pinocchio.neutral(model))
        self.data, self.frame = self.model.createData(), self.model.getFrameId("panda_link8")

    def compute_pose(self, maker: np.ndarray) -> np.ndarray:
        pinocchio.forwardKinematics(self.model, self.data, maker)
        return pinocchio.updateFramePlacement(self.model, self.data, self.frame).homogeneous

    def compute_jacobian(self, maker: np.ndarray) -> np.ndarray:
        return pinocchio.computeFrameJacobian(self.model, self.data, maker, self.frame, BASE_AXES)

    def compute_poses(self, q: np.ndarray) -> np.ndarray:
        results = np.empty((len(q), 4, 4))
        for k, maker in enumerate(q * SIGNS):
            results[k] = self.compute_pose(maker)
        return results @ HALF_TURN

    def compute_jacobians(self, q: np.ndarray) -> np.ndarray:
        results = np.empty((len(q), 6, 7))
        for k, maker in enumerate(q * SIGNS):
            results[k] = self.compute_jacobian(maker)
        return results * SIGNS


def list_batch_cases(Case):
    pin, chain = Pinocchio(), make_toolbox_chain()
    q, T, J = build_casadi_expressions()
    in_jax = list_jax_calls()
    poses = {
        **list_casadi_calls(q, T),
        **in_jax[0],
        "Pinocchio, in a loop": pin.compute_poses,
        "roboticstoolbox ETS.eval, batched": chain.eval,
        "roboticstoolbox ETS.fkine, in a loop": lambda q: np.array([chain.fkine(x).A for x in q]),
    }
    jacobians = {
        **list_casadi_calls(q, J),
        **in_jax[1],
        "Pinocchio, in a loop": pin.compute_jacobians,
        "roboticstoolbox ETS.jacob0, in a loop": lambda q: np.array([chain.jacob0(x) for x in q]),
    }
    for size, rounds in ((1000, 31), (100_000, 3)):
        batch = np.random.default_rng(0).uniform(*PANDA.limits, size=(size, 7))
        count = f"{size:,}".replace(",", " ")
        for name, ours, peers in (
            ("FK", forward_kinematics, poses),
            ("Jacobian", jacobian, jacobians),
        ):
            works = {peer: partial(work, batch) for peer, work in peers.items()}
            yield Case(
                f"{name}, {count} configurations", partial(ours, BARE, batch), works, 1e-12, rounds
            )


def list_single_pose_cases(Case):
    """Return calls that take a single joint vector as an array."""
    pin, chain = Pinocchio(), make_toolbox_chain()
    q, T, J = build_casadi_expressions()
    pose, jac = (casadi.Function("f", [q], [x]) for x in (T, J))
    x, maker = np.array(PANDA.home), SIGNS * PANDA.home
    poses = {
        "CasADi Function": lambda: pose(x).full(),
        "Pinocchio": lambda: pin.compute_pose(maker) @ HALF_TURN,
        "roboticstoolbox ETS.eval": lambda: chain.eval(x),
        "roboticstoolbox ETS.fkine": lambda: chain.fkine(x).A,
    }
    jacobians = {
        "CasADi Function": lambda: jac(x).full(),
        "Pinocchio": lambda: pin.compute_jacobian(maker) * SIGNS,
        "roboticstoolbox ETS.jacob0": lambda: chain.jacob0(x),
    }
    for name, ours, peers in (
        ("FK", forward_kinematics, poses),
        ("Jacobian", jacobian, jacobians),
    ):
        yield Case(
            f"{name}, one configuration", partial(ours, BARE, x), peers, 1e-12, 31, calls=100
        )


def list_cases(Case):
    yield from list_single_pose_cases(Case)
    yield from list_batch_cases(Case)
