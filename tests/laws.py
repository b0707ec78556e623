"""What the tests share: the arms, the batch shapes, and a second, slow definition of a link's
matrix."""

import ast
from pathlib import Path

import nbformat
import numpy as np
from hypothesis import strategies as st

from helpers.arm import Arm, fixed, prismatic, revolute
from helpers.robots import ARMS, PANDA


def instructors_arm() -> Arm:
    """The arm that the instructors' page adds, read from its cell: under every law."""
    page = Path(__file__).parents[1] / "book" / "instructors.ipynb"
    cells = [cell.source for cell in nbformat.read(page, as_version=4).cells]
    (cell,) = (source for source in cells if source.startswith("SCARA = Arm("))
    made = ast.Expression(ast.parse(cell).body[0].value)
    return eval(
        compile(made, "instructors", "eval"), dict(Arm=Arm, revolute=revolute, prismatic=prismatic)
    )


ALL_ARMS = (*ARMS, PANDA.lock(3), instructors_arm())
SHAPES = ((), (1,), (3, 2), (0,))


def ids(arm: Arm) -> str:
    return f"{arm.name}, {arm.dof} joints"


def joint_vectors(arm: Arm, shape: tuple[int, ...], seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (*shape, arm.dof))


def motions(arm: Arm, q: np.ndarray):
    """What each row says, written out here and nowhere else: a turn about z and a step along it,
    then a tilt about x and a step along it, 4x4 each."""
    rest = list(q)
    for row in arm.rows:
        a, alpha, d, theta = (arm.number(e) for e in (row.a, row.alpha, row.d, row.theta))
        if row.joint.kind == "revolute":
            theta += rest.pop(0)
        elif row.joint.kind == "prismatic":
            d += rest.pop(0)
        c, s = np.cos([theta, alpha]), np.sin([theta, alpha])
        turn = np.array([[c[0], -s[0], 0, 0], [s[0], c[0], 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
        tilt = np.array([[1, 0, 0, a], [0, c[1], -s[1], 0], [0, s[1], c[1], 0], [0, 0, 0, 1]])
        yield turn, tilt


def slow_frames(arm: Arm, q: np.ndarray) -> list[np.ndarray]:
    """T_00 .. T_0n as products of the elementary motions."""
    frames = [np.eye(4)]
    for turn, tilt in motions(arm, q):
        frames.append(frames[-1] @ turn @ tilt)
    return frames


def slow_energy(arm: Arm, q: np.ndarray, gravity=(0, 0, -9.81)) -> float:
    """Each mass times its height, link by link."""
    energy = 0.0
    for frame, body in zip(slow_frames(arm, q)[1:], arm.bodies, strict=True):
        point = frame @ [*(arm.number(c) for c in body.com), 1.0]
        energy -= arm.number(body.mass) * np.dot(gravity, point[:3])
    return energy


def differences(f, x: np.ndarray, h: float = 1e-6) -> np.ndarray:
    """The slope of f at x by central differences, its last axis that of x."""
    steps = h * np.eye(len(x))
    return np.stack([(f(x + step) - f(x - step)) / (2 * h) for step in steps], axis=-1)


def by_complex_steps(arm: Arm, q: np.ndarray, h: float = 1e-30) -> np.ndarray:
    """The Jacobian: f(q + ih) has the imaginary part h f'(q), with nothing subtracted."""
    rates = [slow_frames(arm, q + step)[-1].imag / h for step in 1j * h * np.eye(arm.dof)]
    return twists(np.reshape(rates, (-1, 4, 4)), slow_frames(arm, q)[-1])


def twists(rates: np.ndarray, T: np.ndarray) -> np.ndarray:
    """Columns (v, w): the position's rate, and w from the skew matrix of the rotation's rate times
    R^T."""
    skew = rates[:, :3, :3] @ T[:3, :3].T
    omega = np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1)
    return np.concatenate([rates[:, :3, 3], omega], axis=1).T


_LENGTH = st.one_of(st.just(0.0), st.floats(-1, 1).map(lambda x: round(x, 3)))
_ANGLE = st.one_of(
    st.sampled_from([0, "pi/2", "-pi/2", "pi"]), st.floats(-3, 3).map(lambda x: round(x, 3))
)
_ROW = st.builds(
    lambda make, a, alpha, d, theta: make(a, alpha, d, theta),
    st.sampled_from([revolute, revolute, prismatic, fixed]),
    _LENGTH,
    _ANGLE,
    _LENGTH,
    _ANGLE,
)
random_arms = st.lists(_ROW, min_size=1, max_size=6).map(lambda rows: Arm("random", rows))
