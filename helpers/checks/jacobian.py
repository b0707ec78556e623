"""Is my Jacobian wrong, and how? The answer names the mistake and gives no numbers away."""

import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Joint
from helpers.checks.mistakes import rotated, usual_mistakes
from helpers.checks.verdict import Verdict
from helpers.inputs import ArmError, floats, must_be
from helpers.kinematics import jacobian, jacobian_in_frame, link_frames

Array = NDArray[np.float64]
Usual = tuple[tuple[str, Array], ...]

_WITHIN = 1e-6
_ROWS = ("vx", "vy", "vz", "wx", "wy", "wz")


@dataclass(frozen=True, repr=False)
class JacobianReport(Verdict):
    """What `compare_jacobian` found: nothing if the Jacobian is right, everywhere or `at_one_pose`
    only."""

    arm: str
    findings: tuple[str, ...]
    at_one_pose: bool = False

    def __str__(self) -> str:
        verdict = "is right" if self.agrees else "is not right"
        where = " at this pose" if self.agrees and self.at_one_pose else ""
        head = f"The Jacobian of {self.arm} {verdict}{where}."
        return "\n".join([head, *(f"- {f}" for f in self.findings)])


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
        mine: a function of q (or of q_1, q_2, ... one by one), a SymPy matrix in q_1, q_2, ... or
            c_1, s_23, ... and the arm's symbols, or a 6 x dof array at `q`.
        arm: whose Jacobian it should be; a locked joint as ``arm.lock(3)``.
        q: where to compare, shape (dof,); a pose without symmetry unless given. An array needs it.
        angular_first: whether your rows are (omega, v) rather than (v, omega).
        frame: the link frame in whose axes your rows are, 0 for the base.

    Raises ArmError where `mine` gives no matrix of numbers, or is an array and q is missing.
    """
    must_be(arm, Arm, "arm")
    pose = _generic_pose(arm) if q is None else arm.joint_vector(q, many=False)
    M = _numbers(mine, arm, pose, given=q is not None)
    if M.shape != (6, arm.dof):
        return JacobianReport(arm.name, (_shape_finding(M, arm),))
    if angular_first:
        M = np.vstack([M[3:], M[:3]])
    agrees = _same(M, jacobian_in_frame(arm, pose, frame))
    findings = () if agrees else _diagnosis(M, arm, pose, frame)
    at_one_pose = not (callable(mine) or hasattr(mine, "free_symbols"))
    return JacobianReport(arm.name, findings, at_one_pose)


def _generic_pose(arm: Arm) -> Array:
    lower, upper = arm.limits
    lower, upper = np.maximum(lower, -1.5), np.minimum(upper, 1.5)
    return lower + (upper - lower) * np.random.default_rng(19).uniform(0.55, 0.95, arm.dof)


def _numbers(mine: object, arm: Arm, q: Array, given: bool) -> Array:
    if hasattr(mine, "free_symbols"):
        mine = _evaluated(mine, arm, q)
    elif callable(mine):
        mine = mine(*q) if _takes_each(mine, arm.dof) else mine(q)
    elif not given:
        raise ArmError(
            "an array is a Jacobian at one pose; say which: compare_jacobian(mine, arm, q)"
        )
    M = floats(mine, f"{arm.name}: your Jacobian", "a matrix of numbers")
    if M.ndim != 2 or not np.isfinite(M).all():
        raise ArmError(
            f"{arm.name}: your Jacobian has shape {M.shape}; expected a matrix of finite numbers"
        )
    return M


def _takes_each(function: Callable, dof: int) -> bool:
    """Whether a function wants the joint values one by one, as ``sympy.lambdify`` makes them."""
    parameters = inspect.signature(function).parameters.values()
    return (
        1 < dof == sum(p.default is p.empty and p.kind is not p.VAR_POSITIONAL for p in parameters)
    )


def _evaluated(expression, arm: Arm, q: Array) -> object:
    joints = dict(zip(arm.variables, q, strict=True))
    short = {str(s): _short_value(str(s), joints) for s in expression.free_symbols}
    known = {name: value for name, value in short.items() if value is not None}
    result = expression.subs({**known, **joints, **arm.values})
    unknown = sorted(map(str, result.free_symbols))
    if unknown:
        names = ", ".join([*arm.variables, *arm.values])
        raise ArmError(f"{arm.name}: no value for {', '.join(unknown)}; known are {names}")
    return result.tolist() if hasattr(result, "tolist") else result


def _short_value(name: str, joints: dict[str, float]) -> float | None:
    """The number behind c_23 or s_{2-3}, or None for another name."""
    if not re.fullmatch(r"[cs]_\{?([+-]?\d)+\}?", name):
        return None
    terms = [(sign, joints.get(f"q_{digit}")) for sign, digit in re.findall(r"([+-]?)(\d)", name)]
    if any(angle is None for _, angle in terms):
        return None
    total = sum(-angle if sign == "-" else angle for sign, angle in terms)
    return float(np.cos(total) if name[0] == "c" else np.sin(total))


def _same(left: Array, right: Array) -> bool:
    return left.shape == right.shape and bool(np.abs(left - right).max(initial=0.0) < _WITHIN)


def _shape_finding(M: Array, arm: Arm) -> str:
    loose = _unlocked(arm)
    wide = loose.dof > arm.dof
    if M.shape == (arm.dof, 6):
        return "It is transposed: one column per joint, six rows."
    if wide and M.shape == (5, loose.dof):
        return (
            "A row is missing where a column should be: locking a joint removes its column; all"
            " six velocity components stay."
        )
    if wide and M.shape == (6, loose.dof):
        return "It still has a column for a joint that is locked: that column must go."
    if M.shape == (3, arm.dof):
        return "It has three rows; the other three, linear or angular, are missing."
    return (
        f"Its shape is {M.shape}; expected (6, {arm.dof}): rows vx, vy, vz, wx, wy, wz, a"
        " column per free joint."
    )


def _unlocked(arm: Arm) -> Arm:
    """The arm with every row that does not move free to turn."""
    rows = [replace(row, joint=Joint()) if row.joint.kind == "fixed" else row for row in arm.rows]
    return replace(arm, rows=rows, home=())


def _diagnosis(M: Array, arm: Arm, q: Array, frame: int) -> tuple[str, ...]:
    """One mistake that explains the whole matrix, or one for each half, or else what is wrong with
    each wrong column."""
    M, right = rotated(M, link_frames(arm, q)[frame, :3, :3]), jacobian(arm, q)
    usual = tuple(usual_mistakes(arm, q, frame))
    if whole := _named(M, usual):
        return (f"{whole}.",)
    linear, angular = slice(0, 3), slice(3, 6)
    halves = [_half(M, right, usual, rows) for rows in (linear, angular)]
    if None not in halves:
        return tuple(words for words in halves if words)
    wrong = [k for k in range(arm.dof) if not _same(M[:, k], right[:, k])]
    return tuple(
        f"Column {k + 1} (joint {arm.joints[k]}): {_column(k, M[:, k], right, usual, arm, q)}."
        for k in wrong
    )


def _named(mine: Array, usual: Usual, part: object = ...) -> str | None:
    """The first mistake whose matrix has this part, such as three rows or a column."""
    return next((mistake for mistake, wrong in usual if _same(mine, wrong[part])), None)


def _half(M: Array, right: Array, usual: Usual, rows: slice) -> str | None:
    """What explains three rows: nothing to say where they are right, None where no mistake does."""
    if _same(M[rows], right[rows]):
        return ""
    mistake = _named(M[rows], usual, rows)
    if mistake is None:
        return None
    where = "angular rows" if rows.start else "linear rows"
    return f"{mistake}." if where in mistake else f"In the {where}: {_lower(mistake)}."


def _column(k: int, mine: Array, right: Array, usual: Usual, arm: Arm, q: Array) -> str:
    wanted = right[:, k]
    if _same(mine, -wanted):
        return "its sign is reversed, as if the joint counted the other way"
    if _same(mine, np.roll(wanted, 3)):
        return "its linear and angular halves are exchanged"
    for joint, other in _other_columns(k, arm, q):
        if _same(mine, other):
            locked = "" if joint in arm.joints else ", which is locked"
            return f"this is the column of joint {joint}{locked}"
    mistake = _named(mine, usual, (slice(None), k))
    return _lower(mistake) if mistake else _parts(mine, wanted)


def _other_columns(k: int, arm: Arm, q: Array) -> Iterator[tuple[int, Array]]:
    """The columns of the other joints, then those that locked joints would have."""
    loose = _unlocked(arm)
    values = dict(zip(arm.joints, q, strict=True))
    J = jacobian(loose, [values.get(i, 0.0) for i in loose.joints])
    rows = sorted(set(loose.joints) - {arm.joints[k]}, key=lambda i: i not in values)
    return ((i, J[:, i - 1]) for i in rows)


def _parts(mine: Array, wanted: Array) -> str:
    rows = [name for name, a, b in zip(_ROWS, mine, wanted, strict=True) if abs(a - b) >= _WITHIN]
    halves = {"linear" if name.startswith("v") else "angular": None for name in rows}
    parts = "parts are" if len(halves) > 1 else "part is"
    return f"its {' and '.join(halves)} {parts} wrong, in {', '.join(rows)}"


def _lower(sentence: str) -> str:
    return sentence[0].lower() + sentence[1:]
