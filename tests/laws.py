"""Define the arms, batch shapes and slow reference formulas that many tests share.

The reference formulas multiply elementary motions one by one and share no code with `helpers`. The
errors of inverse kinematics are measured by `helpers.kinematics`.
"""

import ast
from pathlib import Path

import nbformat
import numpy as np
from hypothesis import strategies as st

from helpers.arm import Arm, fixed, prismatic, revolute
from helpers.kinematics import forward_kinematics
from helpers.robots import ARMS, PANDA


def instructors_arm() -> Arm:
    """Return the SCARA arm that the instructors' page defines in a cell."""
    page = Path(__file__).parents[1] / "book" / "instructors.ipynb"
    cells = [cell.source for cell in nbformat.read(page, as_version=4).cells]
    (cell,) = (source for source in cells if source.startswith("SCARA = Arm("))
    expression = ast.Expression(ast.parse(cell).body[0].value)
    return eval(
        compile(expression, "instructors", "eval"),
        dict(Arm=Arm, revolute=revolute, prismatic=prismatic),
    )


ALL_ARMS = (*ARMS, PANDA.lock(3), instructors_arm())
SHAPES = ((), (1,), (3, 2), (0,))


def arm_id(arm: Arm) -> str:
    """Return the name under which pytest lists a test of this arm."""
    return f"{arm.name}, {arm.dof} joints"


def joint_vectors(arm: Arm, shape: tuple[int, ...], seed: int = 0) -> np.ndarray:
    """Return random joint vectors, (*shape, dof), within 1.5 rad or 1.5 m."""
    return np.random.default_rng(seed).uniform(-1.5, 1.5, (*shape, arm.dof))


def elementary_motions(arm: Arm, q: np.ndarray):
    """Yield two 4x4 matrices per row: the screw motion along z, then the one along x."""
    joint_values = list(q)
    for row in arm.rows:
        a, alpha, d, theta = (arm.number(e) for e in (row.a, row.alpha, row.d, row.theta))
        if row.joint.kind == "revolute":
            theta += joint_values.pop(0)
        elif row.joint.kind == "prismatic":
            d += joint_values.pop(0)
        c, s = np.cos([theta, alpha]), np.sin([theta, alpha])
        turn = np.array([[c[0], -s[0], 0, 0], [s[0], c[0], 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
        tilt = np.array([[1, 0, 0, a], [0, c[1], -s[1], 0], [0, s[1], c[1], 0], [0, 0, 0, 1]])
        yield turn, tilt


def slow_frames(arm: Arm, q: np.ndarray) -> list[np.ndarray]:
    """Return the frames T_00 to T_0n as products of the elementary motions."""
    frames = [np.eye(4)]
    for turn, tilt in elementary_motions(arm, q):
        frames.append(frames[-1] @ turn @ tilt)
    return frames


def slow_modified_frames(rows, q: np.ndarray) -> list[np.ndarray]:
    """Return Craig's frames 0 to n, whose steps are Rot_x Trans_x Rot_z Trans_z."""
    frames = [np.eye(4)]
    for turn, tilt in elementary_motions(Arm("modified", rows), q):
        frames.append(frames[-1] @ tilt @ turn)
    return frames


def slow_energy(arm: Arm, q: np.ndarray, gravity=(0, 0, -9.81)) -> float:
    """Return the potential energy (J), summed link by link as -m g . p."""
    energy = 0.0
    for frame, body in zip(slow_frames(arm, q)[1:], arm.bodies, strict=True):
        point = frame @ [*(arm.number(c) for c in body.com), 1.0]
        energy -= arm.number(body.mass) * np.dot(gravity, point[:3])
    return energy


def central_differences(f, x: np.ndarray, h: float = 1e-6) -> np.ndarray:
    """Return the derivative of f at x by central differences, (..., len(x))."""
    steps = h * np.eye(len(x))
    return np.stack([(f(x + step) - f(x - step)) / (2 * h) for step in steps], axis=-1)


def complex_step_jacobian(arm: Arm, q: np.ndarray, h: float = 1e-30) -> np.ndarray:
    """Return the 6 x dof Jacobian by complex steps.

    The imaginary part of f(q + ih) is h f'(q), so that no digits are lost by a subtraction.
    """
    rates = [slow_frames(arm, q + step)[-1].imag / h for step in 1j * h * np.eye(arm.dof)]
    return twist_columns(np.reshape(rates, (-1, 4, 4)), slow_frames(arm, q)[-1])


def twist_columns(rates: np.ndarray, T: np.ndarray) -> np.ndarray:
    """Return one column (v, w) per joint from the rates of the pose T.

    v is the rate of the position. w is read from the skew matrix dR/dq R^T.
    """
    skew = rates[:, :3, :3] @ T[:3, :3].T
    omega = np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1)
    return np.concatenate([rates[:, :3, 3], omega], axis=1).T


def joint_difference(arm: Arm, q: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return the largest difference of a joint, ignoring whole turns."""
    turns = np.array([arm.rows[i - 1].joint.kind == "revolute" for i in arm.joints])
    gap = q - other
    return np.abs(np.where(turns, np.angle(np.exp(1j * gap)), gap)).max(axis=-1)


def tip_errors(arm: Arm, found, targets: np.ndarray) -> np.ndarray:
    """Return for each existing branch the largest difference between its tip and the target."""
    T = forward_kinematics(arm, np.where(found.valid[..., None], found.q, 0.0))
    if targets.shape[-1] == 3:
        error = np.abs(T[..., :3, 3] - targets[..., None, :]).max(axis=-1)
    else:
        error = np.abs(T - targets[..., None, :, :]).max(axis=(-1, -2))
    return error[found.valid]


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
