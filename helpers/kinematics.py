"""The numeric view: frames, forward kinematics and Jacobians, of one joint vector or of whole
batches.

One recursion over the links serves everything. It is written for one pose, on components, and
recorded once for each arm (see `helpers.program`): one pose then takes microseconds, and a batch
runs in contiguous rows, in chunks that stay in the processor's cache.
"""

import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, number, numbers, one_of, whole
from helpers.program import Program, Value, record, workspace
from helpers.rows import NumericRow

__all__ = [
    "forward_kinematics",
    "jacobian",
    "jacobian_in_frame",
    "link_frames",
    "lost_directions",
    "manipulability",
    "tip",
]

Array = NDArray[np.float64]
Vector = Sequence[Value]
Step = tuple[NumericRow, Value, Value, Value]  # a row, and its motion: cosine, sine, offset
Recursion = Callable[..., Sequence[Value]]

_CACHE = 1 << 17  # so many numbers at a time, 1 MiB, stay in a level-2 cache


def link_frames(arm: Arm, q: ArrayLike) -> Array:
    """Base-to-link transforms T_00 .. T_0n, shape (..., rows + 1, 4, 4), for q of shape (..., dof).

    Raises ArmError for a q of another length, or with NaN or infinity in it.
    Source: Spong, Hutchinson and Vidyasagar, section 3.1.
    """
    must_be(arm, Arm, "arm")
    return evaluated(arm, q, _frame_entries, (len(arm.rows) + 1, 4, 4))


def forward_kinematics(arm: Arm, q: ArrayLike) -> Array:
    """The tip's pose T_0n in the base frame, shape (..., 4, 4), for q of shape (..., dof)."""
    must_be(arm, Arm, "arm")
    return evaluated(arm, q, tip_entries, (4, 4))


def tip(arm: Arm, q: ArrayLike) -> Array:
    """Where the tip is, shape (..., 3), in m in the base frame, for q of shape (..., dof)."""
    return forward_kinematics(arm, q)[..., :3, 3]


def jacobian(arm: Arm, q: ArrayLike) -> Array:
    """The tip's Jacobian, shape (..., 6, dof): rows (vx, vy, vz, wx, wy, wz) in the base frame.

    A revolute joint i has the column z_{i-1} x (o_n - o_{i-1}) over z_{i-1}, a prismatic one
    z_{i-1} over 0. Source: Spong, Hutchinson and Vidyasagar, section 4.6.
    """
    must_be(arm, Arm, "arm")
    return evaluated(arm, q, jacobian_entries, (6, arm.dof))


def jacobian_in_frame(arm: Arm, q: ArrayLike, frame: int) -> Array:
    """The same Jacobian, shape (..., 6, dof), of the same tip, its rows in the axes of a link
    frame.

    Frame 0 is the base, frame n the tool. Raises ArmError for a frame that does not exist.
    """
    must_be(arm, Arm, "arm")
    if whole(frame, "frame") > len(arm.rows):
        raise ArmError(f"{arm.name}: frame {frame!r} does not exist; expected 0 to {len(arm.rows)}")
    R = link_frames(arm, q)[..., frame, :3, :3]
    J = jacobian(arm, q)
    return np.concatenate(
        [np.swapaxes(R, -1, -2) @ half for half in (J[..., :3, :], J[..., 3:, :])], axis=-2
    )


def manipulability(arm: Arm, q: ArrayLike, part: str = "all") -> Array:
    """Yoshikawa's measure, shape (...): the product of the Jacobian's singular values, 0 at a
    singular pose.

    `part` is "all", "linear" (rows v) or "angular" (rows omega). With as many rows as joints it is
    the size of det J. With fewer joints than rows it is the volume of what the joints can reach,
    sqrt(det J^T J). The unit of "all" mixes m and rad, so compare it only between poses of one arm.
    Source: Yoshikawa (1985).
    """
    rows = {"all": [0, 1, 2, 3, 4, 5], "linear": [0, 1, 2], "angular": [3, 4, 5]}
    chosen = rows[one_of(part, "part", rows)]
    return np.linalg.svd(jacobian(arm, q)[..., chosen, :], compute_uv=False).prod(axis=-1)


def lost_directions(J: ArrayLike, cutoff: float = 1e-9) -> Array:
    """The velocities that no joint motion can give, as orthonormal rows of shape (lost, rows of J).

    They are the left singular vectors whose singular value is not above `cutoff` times the largest.
    """
    J = numbers(J, "J", "one matrix of finite numbers", (None, None))
    cutoff = number(cutoff, "cutoff", "a number of 0 or more", least=0)
    U, sizes, _ = np.linalg.svd(J, full_matrices=True)
    return U.T[(sizes > cutoff * sizes.max(initial=0.0)).sum() :]


def skeleton(arm: Arm, T: Array) -> Array:
    """The points o_0, o_0 + d z_0, o_1, o_1 + d z_1, ...: what the table's lengths draw, for T of
    shape (rows + 1, 4, 4)."""
    points = [T[0, :3, 3]]
    for row, frame in zip(arm.numeric, T[1:], strict=True):
        points += [frame[:3, 3] - row.a * frame[:3, 0], frame[:3, 3]]
    return np.array(points)


def evaluated(
    arm: Arm,
    q: ArrayLike,
    recursion: Recursion,
    shape: tuple[int, ...],
    given: Sequence[float] = (),
) -> Array:
    """What a recursion over the links gives at each q (..., dof), in the shape `(..., *shape)`."""
    q = arm.joint_vector(q)
    program = recorded(arm, recursion, given)
    if q.ndim == 1:
        return np.array(_of_one(program, q, given)).reshape(shape)
    flat = q.reshape(math.prod(q.shape[:-1]), arm.dof)
    out = np.empty((len(flat), len(program.places)))
    chunk = max(1, _CACHE // (3 * arm.dof + program.rows + 1))
    for start in range(0, len(flat), chunk):
        part = slice(start, start + chunk)
        out[part] = rows_of(program, flat[part].T, given).T
    return out.reshape(*q.shape[:-1], *shape)


def recorded(arm: Arm, recursion: Recursion, given: Sequence[float] = ()) -> Program:
    """The program of a recursion for this arm, recorded when it is first asked for; what is given
    as 0 stays 0."""
    present = tuple(x != 0 for x in given)
    if (recursion, present) not in arm.programs:
        n = arm.dof

        def compute(*terms: Value) -> Sequence[Value]:
            steps = list(row_motions(arm, terms[:n], terms[n : 2 * n], terms[2 * n : 3 * n]))
            rest = (x if there else 0.0 for x, there in zip(terms[3 * n :], present, strict=True))
            return recursion(arm, steps, *rest)

        arm.programs[recursion, present] = record(compute, 3 * n + len(given))
    return arm.programs[recursion, present]


def rows_of(program: Program, q: Array, given: Sequence[float] = ()) -> Array:
    """The program's results, one row each, for joint vectors in columns (dof, batch); good until
    the next are asked for."""
    n, batch = q.shape
    if batch == 1:
        return np.array(_of_one(program, q[:, 0], given))[:, None]
    space = workspace(3 * n + program.rows, batch)
    cosines, sines, values = space[: 3 * n].reshape(3, n, batch)
    values[...] = q
    cosines_and_sines(values, cosines, sines)
    return program.of_rows([*space[: 3 * n], *map(np.array, given)], space[3 * n :])


def _of_one(program: Program, q: Array, given: Sequence[float]) -> list[float]:
    one = q.tolist()
    return program.of_numbers([*map(math.cos, one), *map(math.sin, one), *one, *given])


def cosines_and_sines(
    q: Array, c: Array | None = None, s: Array | None = None
) -> tuple[Array, Array]:
    """Both, into c and s where given; from the half angle, to 3.4e-16: of the three only NumPy's
    tan is vectorised."""
    t = np.multiply(0.5, q, out=s)
    t = np.tan(t, out=t)
    r = np.multiply(t, t, out=c)
    r += 1.0
    r = np.divide(2.0, r, out=r)
    t *= r
    r -= 1.0
    return r, t


def row_motions(
    arm: Arm, cosines: Sequence[Value], sines: Sequence[Value], q: Sequence[Value]
) -> Iterator[Step]:
    """Each row with the cosine and sine of its angle and its offset, its joint's motion put in."""
    joint = 0
    for row in arm.numeric:
        c, s, d = row.cos_theta, row.sin_theta, row.d
        if row.kind == "revolute":
            c, s = (
                cosines[joint] * c - sines[joint] * s,
                sines[joint] * c + cosines[joint] * s,
            )
        elif row.kind == "prismatic":
            d = q[joint] + d
        joint += row.kind != "fixed"
        yield row, c, s, d


_BASE: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0))


def frame_columns(steps: Sequence[Step]) -> Iterator[tuple[Vector, Vector, Vector, Vector]]:
    """The columns (x, y, z, origin) of each link frame in turn."""
    x, y, z, origin = _BASE
    yield x, y, z, origin
    for row, c, s, d in steps:
        x, y = mixed(c, x, s, y), mixed(c, y, -s, x)
        origin = mixed(1.0, origin, 1.0, mixed(d, z, row.a, x))
        y, z = tilted(row, y, z)
        yield x, y, z, origin


def tilted(row: NumericRow, y: Vector, z: Vector) -> tuple[Vector, Vector]:
    """Two columns seen after the row's turn about x."""
    c, s = row.cos_alpha, row.sin_alpha
    return mixed(c, y, s, z), mixed(c, z, -s, y)


def mixed(a: Value, u: Vector, b: Value, v: Vector) -> Vector:
    """a u + b v."""
    return tuple(a * x + b * y for x, y in zip(u, v, strict=True))


def cross(u: Vector, v: Vector) -> Vector:
    """u x v."""
    return tuple(u[j] * v[k] - u[k] * v[j] for j, k in ((1, 2), (2, 0), (0, 1)))


def _frame_entries(arm: Arm, steps: Sequence[Step]) -> Sequence[Value]:
    return [x for frame in frame_columns(steps) for x in _entries(frame)]


def tip_entries(arm: Arm, steps: Sequence[Step]) -> Sequence[Value]:
    """The 16 entries of the tip's pose, row by row."""
    *_, frame = frame_columns(steps)
    return _entries(frame)


def _entries(frame: tuple[Vector, Vector, Vector, Vector]) -> list[Value]:
    return [x for line in zip(*frame, strict=True) for x in line] + [0.0, 0.0, 0.0, 1.0]


def jacobian_entries(arm: Arm, steps: Sequence[Step]) -> Sequence[Value]:
    """The 6 dof entries of the Jacobian, row by row."""
    frames = list(frame_columns(steps))
    tip, columns = frames[-1][3], []
    for i in arm.joints:
        _, _, z, origin = frames[i - 1]
        if arm.numeric[i - 1].kind == "revolute":
            columns.append((*cross(z, mixed(1.0, tip, -1.0, origin)), *z))
        else:
            columns.append((*z, 0.0, 0.0, 0.0))
    return [x for line in zip(*columns, strict=True) for x in line]
