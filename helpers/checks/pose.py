"""Do these joint angles reach that pose? For any arm, also where the book has no closed form."""

from collections.abc import Iterator
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks import door, inverse_causes
from helpers.checks.branches import answers, turned
from helpers.checks.digits import HALF, HAND, RIGHT, ROUNDED, SO_FAR, WRONG, Typed
from helpers.checks.lengths import wrong_lengths
from helpers.checks.ranking import Cause, cause, lower, several
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be
from helpers.kinematics import forward_kinematics, jacobian
from helpers.reading.sentences import listed, millimetres, say

Array = NDArray[Any]

_EXACT = 1e-6  # m or rad
_FAR = 10  # margins: what is missed by less may be several joints, each a little off
_ROUGH = 0.1  # the largest unit of a rotation's entries: a whole 0 or 1 may stand for no other
_COARSE = (
    2e-3  # rad or m: angles with fewer than three decimals are taken as meant, unless that fails
)


def compare_pose(
    q: object, arm: Arm, T: ArrayLike | str, *, angles: str = "rad", tolerance: float | None = None
) -> Report:
    """Whether joint values take an arm's tip to a pose T, shape (4, 4), or to a point (3,), and if
    not, what slip would.

    Args:
        q: one joint vector, as an array, list, text or pairs such as ('theta1', 0.3).
        arm: any arm.
        T: where the tip should be, in base axes (m); numbers or formulas of the joints.
        angles: "deg" where q is in degrees.
        tolerance: the largest miss (m and rad); inferred from the digits of q and T unless given.

    Raises ArmError for another shape.
    """
    must_be(arm, Arm, "arm")
    tolerance = door.settings(angles, tolerance)
    typed, taken = answers(q, arm, angles)
    if len(typed.values) != 1:
        raise ArmError(say("one answer", arm=arm.name, count=len(typed.values)))
    lookup = door.Joints(arm, typed.values[0])
    target = door.numbers(T, f"{arm.name}: T", lookup, wanted="a pose (4, 4) or a point (3,)")
    if target.symbolic:
        typed = Typed(typed.values, 0 * typed.units)
    target = Typed(np.squeeze(target.values), np.squeeze(target.units), symbolic=target.symbolic)
    if target.values.shape not in ((4, 4), (3, 4), (3,)):
        raise ArmError(
            say("pose shape", arm=arm.name, shape="x".join(map(str, target.values.shape)))
        )
    return _judged(Typed(typed.values[0], typed.units[0]), arm, target, tolerance, taken)


def _judged(q: Typed, arm: Arm, T: Typed, tolerance: float | None, taken) -> Report:
    here = forward_kinematics(arm, q.values)
    miss = _miss(here, T.values)
    figures = {"position_error": miss[0], "orientation_error": miss[1]}

    def reported(grade: str, words: str, findings=(), causes=(), notes=()) -> Report:
        parts = tuple(findings), tuple(causes), taken, tuple(notes)
        return Report("pose", arm.name, grade, words, *parts, figures)

    def good(grade: str) -> Report:
        return reported(grade, say(f"pose {grade}", arm=arm.name), notes=_limits(arm, q))

    fine = Typed(q.values, np.where(q.units > _COARSE, 0.0, q.units))
    for grade, share in ((RIGHT, HALF), (ROUNDED, HAND)):
        margin = _margins(fine, arm, T, share, tolerance)
        if _within(miss, margin):
            return good(grade)
    turn = turned(miss[1]) if miss[1] > margin[1] else ""
    off = say("ik off", millimetres=millimetres(miss[0]), turn=turn)
    found = _causes(q, arm, T, margin, miss, tolerance)
    if not found and _within(miss, _margins(q, arm, T, HALF, tolerance)):
        return good(SO_FAR)
    if not found and not _within(miss, _FAR * np.array(margin)):
        found = _alone(q.values, arm, T.values, _margins(fine, arm, T, HALF, tolerance))
    if found:
        words = several(found)
        headline = say("pose cause", arm=arm.name, off=off, cause=lower(words))
        finding = Finding("cause", "", None, None, f"{words}.")
        return reported(WRONG, headline, [finding], [c.name for c in found])
    findings = list(_entries(here, T, miss[1] <= margin[1]))
    causes = dict.fromkeys(f.what for f in findings)
    return reported(WRONG, say("pose wrong", arm=arm.name, off=off), findings, causes)


def _miss(here: Array, T: Array) -> tuple[float, float]:
    """Distance (m) and angle (rad) between poses; no angle where T is a point, half a turn where
    its axes are left-handed.
    """
    if T.ndim == 1:
        return float(np.linalg.norm(here[:3, 3] - T)), 0.0
    R = here[:3, :3].T @ T[:3, :3]
    off = np.linalg.norm([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    angle = np.arctan2(off, np.trace(R) - 1) if np.linalg.det(R) > 0 else np.pi
    return float(np.linalg.norm(here[:3, 3] - T[:3, 3])), float(angle)


def _margins(
    q: Typed, arm: Arm, T: Typed, share: float, tolerance: float | None
) -> tuple[float, float]:
    if tolerance is not None:
        return max(tolerance, 1e-9), max(tolerance, 1e-9)  # below it rounding decides
    J = np.abs(jacobian(arm, q.values)) @ (share * q.units)
    last = T.units if T.values.ndim == 1 else T.units[:3, 3]
    turn = 0.0 if T.values.ndim == 1 else 2 * share * min(float(T.units[:3, :3].max()), _ROUGH)
    return _EXACT + float(np.linalg.norm(J[:3]) + share * np.linalg.norm(last)), _EXACT + float(
        np.linalg.norm(J[3:])
    ) + turn


def _within(miss: tuple[float, float], margin) -> bool:
    return miss[0] <= margin[0] and miss[1] <= margin[1]


def _causes(
    q: Typed, arm: Arm, T: Typed, margin, miss: tuple[float, float], tolerance: float | None
) -> tuple[Cause, ...]:
    """The single slips that explain a miss, or else the first pair that does; none that helps by
    less than half, nor a scale where zero would fit as well.
    """
    found: list[Any] = []
    half = np.where(np.array(miss) <= margin, margin, np.minimum(margin, np.array(miss) / 2))
    for c, other, values, target in _slips(q.values, arm, T.values):
        if len(c.keys) > 1 and found:
            break
        least = half
        if inverse_causes.scales(c):
            typed = Typed(values, q.units * inverse_causes.scale(c, arm))
            least = _margins(typed, arm, T, HAND, tolerance)
            zero = forward_kinematics(arm, np.where(values == q.values, q.values, 0.0))
            if _within(_miss(zero, target), least):
                continue
        if _within(_miss(forward_kinematics(other, values), target), least):
            found.append(c)
            if len(c.keys) > 1:
                break
    return tuple(found)


def _alone(q: Array, arm: Arm, T: Array, margin: tuple[float, float]) -> tuple[Cause, ...]:
    """The one joint of which another value, or the one pair whose exchange, takes the tip to T;
    nothing where more than one would, or for a point, which leaves more to chance.
    """
    if T.ndim == 1:
        return ()
    found = tuple(
        c
        for c, mended in _other_values(q, arm, T)
        if _within(_miss(forward_kinematics(arm, mended), T), margin)
    )
    return found if len(found) == 1 else ()


def _other_values(q: Array, arm: Arm, T: Array) -> Iterator[tuple[Cause, Array]]:
    """Each joint in turn moved as near to T as it can, then each pair exchanged."""
    here, J = forward_kinematics(arm, q), jacobian(arm, q)
    R = T[:3, :3] @ here[:3, :3].T
    turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    names = [f"q_{i}" for i in arm.joints]
    for k, joint in enumerate(names):
        turned = np.arctan2(J[3:, k] @ turn, np.trace(R) - 1)
        mended = q.copy()
        mended[k] += turned if arm.turning[k] else J[:3, k] @ (T[:3, 3] - here[:3, 3])
        yield cause("pose.joint", joint=joint), mended
    for i, j in combinations(range(arm.dof), 2):
        mended = q.copy()
        mended[[i, j]] = q[[j, i]]
        yield cause("pose.exchanged", first=names[i], second=names[j]), mended


def _slips(q: Array, arm: Arm, T: Array) -> Iterator[tuple[Cause, Arm, Array, Array]]:
    for key, factor in (("pose.millimetres", 1e-3), ("pose.centimetres", 1e-2)):
        yield cause(key), arm, q, _scaled(T, factor)
    for c, mended in (*inverse_causes.single(arm, q), *inverse_causes.whole(arm, q)):
        yield c, arm, mended, T
    for found, other in wrong_lengths(arm):
        yield found, other, q, T
    if T.ndim == 2:
        yield cause("pose.transposed"), arm, q, _rotated(T, T[:3, :3].T)
        for axis in range(3):
            R = np.where(np.arange(3) == axis, T[:3, :3], -T[:3, :3])
            yield cause("pose.half turn", axis="xyz"[axis]), arm, q, _rotated(T, R)
    for c, mended in inverse_causes.double(arm, q):
        yield c, arm, mended, T


def _rotated(T: Array, R: Array) -> Array:
    turned = T.copy()
    turned[:3, :3] = R
    return turned


def _entries(here: Array, T: Typed, upright: bool) -> Iterator[Finding]:
    """The entries of T that differ, where they are few and no joints give the others with them: its
    axes are not square, or are `upright`, as they should be. Then T is wrong, not q; of a point in
    numbers they do not tell which of the two it is.
    """
    if T.values.ndim == 1:
        wrong = np.flatnonzero(np.abs(here[:3, 3] - T.values) > _COARSE)
        if T.symbolic and wrong.size == 1:
            axis = "xyz"[wrong[0]]
            words = say("pose.coordinate", axis=axis)
            yield Finding("pose.coordinate", axis, None, None, words)
        return
    off = np.abs(here[:3] - T.values[:3]) > np.maximum(HAND * T.units[:3], _COARSE)
    if off.sum() <= 3 and (upright or not _square(T)):
        for i, j in np.argwhere(off):
            words = say("pose.entry", row=i + 1, column=j + 1)
            yield Finding("pose.entry", f"entry ({i + 1}, {j + 1})", None, None, words)


def _square(T: Typed) -> bool:
    """Whether the axes of a pose are those of a right-handed frame, to their digits."""
    R, unit = T.values[:3, :3], float(T.units[:3, :3].max())
    off = float(np.abs(R.T @ R - np.eye(3)).max())
    return off <= 2 * unit + _EXACT and np.linalg.det(R) > 0


def _scaled(T: Array, factor: float) -> Array:
    if T.ndim == 1:
        return T * factor
    scaled = T.copy()
    scaled[:3, 3] *= factor
    return scaled


def _limits(arm: Arm, q: Typed) -> Iterator[str]:
    least, most = arm.limits
    beyond = np.flatnonzero((q.values < least) | (q.values > most))
    if beyond.size:
        yield say("beyond limits", joints=listed([f"q_{arm.joints[k]}" for k in beyond]))
