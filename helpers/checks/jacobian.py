"""Is my Jacobian wrong, and how? The answer names the mistake and gives no numbers away."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError, Joint
from helpers.kinematics import forward_kinematics, jacobian, jacobian_in_frame, link_frames

Array = NDArray[np.float64]

_WITHIN = 1e-6


@dataclass(frozen=True)
class JacobianReport:
    """What `compare_jacobian` found: nothing if the Jacobian is right."""

    arm: str
    findings: tuple[str, ...]

    @property
    def agrees(self) -> bool:
        """Whether the Jacobian is right."""
        return not self.findings

    def __str__(self) -> str:
        verdict = "is right" if self.agrees else "is not right"
        return "\n".join(
            [f"The Jacobian of {self.arm} {verdict}.", *(f"- {f}" for f in self.findings)]
        )

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        head, *lines = str(self).split("\n")
        return "\n".join([f"{'✔' if self.agrees else '✘'} **{head}**", "", *lines])


def compare_jacobian(
    mine: object,
    arm: Arm,
    q: ArrayLike | None = None,
    *,
    angular_first: bool = False,
    frame: int = 0,
) -> JacobianReport:
    """Compare your Jacobian of an arm's tip with the right one, and name the mistake.

    Args:
        mine: a function of q, a SymPy matrix in q_1, q_2, ... and the arm's symbols, or a 6 x dof array at `q`.
        arm: whose Jacobian it should be; a locked joint as ``arm.lock(3)``.
        q: where to compare, shape (dof,); a pose without symmetry unless given. An array needs it.
        angular_first: whether your rows are (omega, v) rather than (v, omega).
        frame: the link frame in whose axes your rows are, 0 for the base.

    Raises ArmError where `mine` gives no matrix of numbers, or is an array and q is missing.
    """
    pose = _generic_pose(arm) if q is None else arm.joint_vector(q)
    if pose.ndim != 1:
        raise ArmError(f"q has shape {pose.shape}; expected one pose, ({arm.dof},)")
    M = _numbers(mine, arm, pose, given=q is not None)
    if M.shape != (6, arm.dof):
        return JacobianReport(arm.name, (_shape_finding(M, arm, pose),))
    if angular_first:
        M = np.vstack([M[3:], M[:3]])
    right = jacobian_in_frame(arm, pose, frame)
    return JacobianReport(arm.name, () if _same(M, right) else _diagnosis(M, right, arm, pose))


def _generic_pose(arm: Arm) -> Array:
    lower, upper = arm.limits
    lower, upper = np.maximum(lower, -1.5), np.minimum(upper, 1.5)
    return lower + (upper - lower) * np.random.default_rng(19).uniform(0.55, 0.95, arm.dof)


def _numbers(mine: object, arm: Arm, q: Array, given: bool) -> Array:
    if hasattr(mine, "free_symbols"):
        mine = _evaluated(mine, arm, q)
    elif callable(mine):
        mine = mine(q)
    elif not given:
        raise ArmError(
            "an array is a Jacobian at one pose; say which: compare_jacobian(mine, arm, q)"
        )
    try:
        M = np.asarray(mine, dtype=float)
    except (TypeError, ValueError):
        raise ArmError(
            f"{arm.name}: your Jacobian gives {mine!r}; expected a matrix of numbers"
        ) from None
    if M.ndim != 2 or not np.isfinite(M).all():
        raise ArmError(
            f"{arm.name}: your Jacobian has shape {M.shape}; expected a matrix of finite numbers"
        )
    return M


def _evaluated(expression, arm: Arm, q: Array) -> object:
    numbers = {**dict(arm.values), **dict(zip(arm.variables, q, strict=True))}
    result = expression.subs(numbers)
    unknown = sorted(map(str, result.free_symbols))
    if unknown:
        names = ", ".join([*arm.variables, *dict(arm.values)])
        raise ArmError(f"{arm.name}: no value for {', '.join(unknown)}; known are {names}")
    return result.tolist()


def _same(left: Array, right: Array) -> bool:
    return left.shape == right.shape and bool(np.abs(left - right).max(initial=0.0) < _WITHIN)


def _shape_finding(M: Array, arm: Arm, q: Array) -> str:
    rows = [replace(row, joint=Joint()) if row.joint.kind == "fixed" else row for row in arm.rows]
    loose = replace(arm, rows=rows, home=())
    wide = loose.dof > arm.dof
    if M.shape == (arm.dof, 6):
        return "It is transposed: one column per joint, six rows."
    if wide and M.shape == (5, loose.dof):
        return "A row is missing where a column should be: locking a joint removes its column; all six velocity components stay."
    if wide and M.shape == (6, loose.dof):
        return "It still has a column for a joint that is locked: that column must go."
    if M.shape == (3, arm.dof):
        return "It has three rows; the other three, linear or angular, are missing."
    return f"Its shape is {M.shape}; expected (6, {arm.dof}): rows vx, vy, vz, wx, wy, wz, a column per free joint."


def _diagnosis(M: Array, right: Array, arm: Arm, q: Array) -> tuple[str, ...]:
    """One mistake that explains the whole matrix, or else what is wrong with each wrong column."""
    suspects = dict(_suspects(right, arm, q))
    for mistake, wrong in suspects.items():
        if _same(M, wrong):
            return (f"{mistake}.",)
    return tuple(
        _column(k, M[:, k], right, suspects, arm)
        for k in range(arm.dof)
        if not _same(M[:, k], right[:, k])
    )


def _suspects(right: Array, arm: Arm, q: Array) -> Iterator[tuple[str, Array]]:
    """What the usual mistakes make of the whole Jacobian."""
    v, w = right[:3], right[3:]
    yield (
        "Linear and angular rows are exchanged; if you mean (omega, v), say angular_first=True",
        np.vstack([w, v]),
    )
    yield "Every sign is reversed", -right
    yield (
        "The cross product is taken the wrong way round: z x (o_n - o), not (o_n - o) x z",
        np.vstack([_flipped(v, arm), w]),
    )
    yield (
        "The linear rows are in millimetres, the angular ones are not: use metres throughout",
        np.vstack([1000 * v, w]),
    )
    yield (
        "The linear rows are in metres per degree or q is taken in degrees: use radians",
        jacobian(arm, np.radians(q)),
    )
    yield "It is per degree: angles are in radians", np.radians(right)
    yield from _axis_mistakes(arm, q)
    yield (
        "The lever arm is o_n alone: subtract o_{i-1}, the point on the joint's axis",
        _built(arm, q, lever=lambda o, tip: tip),
    )
    yield (
        "The lever arm is o_{i-1} alone: it goes from o_{i-1} to the tip, o_n - o_{i-1}",
        _built(arm, q, lever=lambda o, tip: o),
    )
    yield (
        "Axes and origins are read from the rows of T: they are its columns",
        _built(arm, q, read=lambda T: np.swapaxes(T, -1, -2)),
    )
    yield (
        "A joint that slides is treated as one that turns: its column is z over 0",
        _built(arm, q, slides=False),
    )
    yield (
        "The angular rows are zero: a joint that turns contributes its axis z_{i-1}",
        np.vstack([v, 0 * w]),
    )
    for k in range(1, len(arm.rows) + 1):
        yield (
            f"The rows are in the axes of frame {k}, not of the base; if you mean that, say frame={k}",
            jacobian_in_frame(arm, q, k),
        )
    for k in range(len(arm.rows)):
        point = link_frames(arm, q)[k, :3, 3]
        yield (
            f"The linear rows are the velocity of a point at o_{k}, not of the tip",
            _built(arm, q, lever=lambda o, tip, p=point: p - o),
        )


def _flipped(v: Array, arm: Arm) -> Array:
    turns = [arm.rows[i - 1].joint.kind == "revolute" for i in arm.joints]
    return np.where(turns, -v, v)


def _axis_mistakes(arm: Arm, q: Array) -> Iterator[tuple[str, Array]]:
    right, late = _built(arm, q), _built(arm, q, late=True)
    yield (
        "The angular rows use z_i where z_{i-1} belongs: joint i turns about the axis of the frame before it",
        np.vstack([right[:3], late[3:]]),
    )
    yield (
        "Axes and origins are one frame too far: joint i has z_{i-1} and o_{i-1}, not z_i and o_i",
        late,
    )
    mixed = _built(arm, q, late=True, lever_late=False)
    yield "The axes are one frame too far: joint i turns about z_{i-1}, not z_i", mixed


def _built(
    arm: Arm,
    q: Array,
    *,
    late: bool = False,
    lever_late: bool | None = None,
    lever: Callable = lambda o, tip: tip - o,
    read: Callable = lambda T: T,
    slides: bool = True,
) -> Array:
    """The Jacobian built column by column, with one step done otherwise."""
    T, tip = read(link_frames(arm, q)), read(forward_kinematics(arm, q))[:3, 3]
    columns = []
    for i in arm.joints:
        z = T[i - 1 + late, :3, 2]
        o = T[i - 1 + (late if lever_late is None else lever_late), :3, 3]
        turns = arm.rows[i - 1].joint.kind == "revolute" or not slides
        columns.append(np.concatenate([np.cross(z, lever(o, tip)), z] if turns else [z, 0 * z]))
    return np.stack(columns, axis=1)


def _column(k: int, column: Array, right: Array, suspects: dict[str, Array], arm: Arm) -> str:
    where = f"Column {k + 1} (joint {arm.joints[k]})"
    wanted = right[:, k]
    if _same(column, -wanted):
        return f"{where}: its sign is reversed, as if the joint counted the other way."
    if _same(column, np.concatenate([wanted[3:], wanted[:3]])):
        return f"{where}: its linear and angular halves are exchanged."
    for other in range(arm.dof):
        if other != k and _same(column, right[:, other]):
            return f"{where}: this is the column of joint {arm.joints[other]}."
    for mistake, wrong in suspects.items():
        if _same(column, wrong[:, k]):
            return f"{where}: {mistake[0].lower()}{mistake[1:]}."
    halves = [
        name
        for name, rows in (("linear", slice(0, 3)), ("angular", slice(3, 6)))
        if not _same(column[rows], wanted[rows])
    ]
    rows = [
        name
        for name, a, b in zip(("vx", "vy", "vz", "wx", "wy", "wz"), column, wanted, strict=True)
        if abs(a - b) >= _WITHIN
    ]
    return f"{where}: its {' and its '.join(halves)} part is wrong, in {', '.join(rows)}."
