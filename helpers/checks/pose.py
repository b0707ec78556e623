"""Do these joint angles reach that pose? For any arm, also where the book has no closed form."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks import door, inverse_causes
from helpers.checks.branches import answers
from helpers.checks.digits import HALF, HAND, RIGHT, ROUNDED, SO_FAR, WRONG, Typed
from helpers.checks.lengths import wrong_lengths
from helpers.checks.ranking import Cause, cause, lower, several
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be
from helpers.kinematics import forward_kinematics, jacobian
from helpers.reading.sentences import listed, millimetres, say, size

Array = NDArray[Any]

_EXACT = 1e-6  # m or rad
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
    door.settings(angles, tolerance)
    typed, taken = answers(q, arm, angles)
    if len(typed.values) != 1:
        raise ArmError(say("one answer", arm=arm.name, count=len(typed.values)))
    lookup = door.Joints(arm, typed.values[0])
    target = door.numbers(T, f"{arm.name}: T", lookup, wanted="a pose (4, 4) or a point (3,)")
    formulas = target.symbolic
    if formulas:
        typed = Typed(typed.values, 0 * typed.units)
    target = Typed(np.squeeze(target.values), np.squeeze(target.units))
    if target.values.shape not in ((4, 4), (3, 4), (3,)):
        raise ArmError(
            say("pose shape", arm=arm.name, shape="x".join(map(str, target.values.shape)))
        )
    target = replace(target, symbolic=formulas)
    return _judged(Typed(typed.values[0], typed.units[0]), arm, target, tolerance, taken)


def _judged(q: Typed, arm: Arm, T: Typed, tolerance: float | None, taken) -> Report:
    miss = _miss(forward_kinematics(arm, q.values), T.values)
    figures = {"position_error": miss[0], "orientation_error": miss[1]}
    notes = tuple(_limits(arm, q))
    fine = Typed(q.values, np.where(q.units > _COARSE, 0.0, q.units))
    for grade, digits, share in ((RIGHT, fine, HALF), (ROUNDED, fine, HAND)):
        margin = _margins(digits, arm, T, share, tolerance)
        if _within(miss, margin):
            return Report(
                "pose",
                arm.name,
                grade,
                say(f"pose {grade}", arm=arm.name),
                (),
                (),
                taken,
                notes,
                figures,
            )
    turn = _turn(T, miss[1]) if miss[1] > margin[1] else ""
    off = say("ik off", millimetres=millimetres(miss[0]), turn=turn)
    found = _causes(q, arm, T, margin, miss, tolerance)
    if not found and _within(miss, _margins(q, arm, T, HALF, tolerance)):
        return Report(
            "pose",
            arm.name,
            SO_FAR,
            say("pose so far", arm=arm.name),
            (),
            (),
            taken,
            notes,
            figures,
        )
    if not found:
        findings = tuple(_entries(forward_kinematics(arm, q.values), T))
        causes = tuple(dict.fromkeys(f.what for f in findings))
        words = say("pose wrong", arm=arm.name, off=off)
        return Report("pose", arm.name, WRONG, words, findings, causes, taken, (), figures)
    cause_words = several(found)
    words = say("pose cause", arm=arm.name, off=off, cause=lower(cause_words))
    finding = Finding("cause", "", None, None, f"{cause_words}.")
    names = tuple(c.name for c in found)
    return Report("pose", arm.name, WRONG, words, (finding,), names, taken, (), figures)


def _turn(T: Typed, angle: float) -> str:
    return (
        say("ik turn", degrees=size(round(float(np.degrees(angle)), 3)))
        if T.values.ndim == 2
        else ""
    )


def _miss(here: Array, T: Array) -> tuple[float, float]:
    """Distance (m) and angle (rad) between poses; no angle where T is a point."""
    if T.ndim == 1:
        return float(np.linalg.norm(here[:3, 3] - T)), 0.0
    R = here[:3, :3].T @ T[:3, :3]
    off = np.linalg.norm([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return float(np.linalg.norm(here[:3, 3] - T[:3, 3])), float(np.arctan2(off, np.trace(R) - 1))


def _margins(
    q: Typed, arm: Arm, T: Typed, share: float, tolerance: float | None
) -> tuple[float, float]:
    if tolerance is not None:
        return max(tolerance, 1e-9), max(tolerance, 1e-9)  # below it rounding decides
    J = np.abs(jacobian(arm, q.values)) @ (share * q.units)
    last = T.units if T.values.ndim == 1 else T.units[:3, 3]
    turn = 0.0 if T.values.ndim == 1 else 2 * share * float(T.units[:3, :3].max())
    return _EXACT + float(np.linalg.norm(J[:3]) + share * np.linalg.norm(last)), _EXACT + float(
        np.linalg.norm(J[3:])
    ) + turn


def _within(miss: tuple[float, float], margin: Sequence[float]) -> bool:
    return miss[0] <= margin[0] and miss[1] <= margin[1]


def _causes(
    q: Typed, arm: Arm, T: Typed, margin, miss: tuple[float, float], tolerance: float | None
) -> tuple[Cause, ...]:
    """The single slips that explain a miss, or else the first pair that does; none that helps by
    less than half, nor a scale where zero would fit as well.
    """
    found: list[Any] = []
    for c, other, values, target in _slips(q.values, arm, T.values):
        if len(c.keys) > 1 and found:
            break
        least: Sequence[float] = [
            m if off <= m else min(m, off / 2) for m, off in zip(margin, miss, strict=True)
        ]
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
            signs = np.where(np.arange(3) == axis, 1.0, -1.0)
            yield cause("pose.half turn", axis="xyz"[axis]), arm, q, _rotated(T, T[:3, :3] * signs)
    for c, mended in inverse_causes.double(arm, q):
        yield c, arm, mended, T


def _rotated(T: Array, R: Array) -> Array:
    turned = T.copy()
    turned[:3, :3] = R
    return turned


def _entries(here: Array, T: Typed) -> Iterator[Finding]:
    """The entries of T that differ, where they are few: then T is wrong, not q. Of a point in
    numbers they do not tell which of the two it is.
    """
    if T.values.ndim == 1:
        wrong = np.flatnonzero(np.abs(here[:3, 3] - T.values) > _COARSE)
        if T.symbolic and wrong.size == 1:
            axis = "xyz"[wrong[0]]
            words = say("pose.coordinate", axis=axis)
            yield Finding("pose.coordinate", axis, float(T.values[wrong[0]]), None, words)
        return
    off = np.abs(here[:3] - T.values[:3]) > np.maximum(HAND * T.units[:3], _COARSE)
    if off.sum() <= 3:
        for i, j in np.argwhere(off):
            where = f"entry ({i + 1}, {j + 1})"
            yield Finding(
                "pose.entry",
                where,
                float(T.values[i, j]),
                None,
                say("pose.entry", row=i + 1, column=j + 1),
            )


def _scaled(T: Array, factor: float) -> Array:
    if T.ndim == 1:
        return T * factor
    scaled = T.copy()
    scaled[:3, 3] *= factor
    return scaled


def _limits(arm: Arm, q: Typed) -> Iterator[str]:
    lower_, upper = arm.limits
    beyond = [
        f"q_{i}"
        for i, x, a, b in zip(arm.joints, q.values, lower_, upper, strict=True)
        if not a <= x <= b
    ]
    if beyond:
        yield say("beyond limits", joints=listed(beyond))
