"""Is my inverse kinematics right and complete? Each of your answers is judged, and what is missing
is named."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks.verdict import Verdict
from helpers.inputs import ArmError, floats, must_be
from helpers.inverse.numeric import solve
from helpers.inverse.solutions import Solutions
from helpers.kinematics import forward_kinematics, jacobian

Array = NDArray[np.float64]

_WITHIN = 1e-4  # rad or m: answers copied from paper with four decimals still count
_NEAR = 1e-3  # m and rad: a pose this close is the target's


@dataclass(frozen=True, repr=False)
class BranchReport(Verdict):
    """What `compare_branches` found: a line for each wrong answer and one for what is missing;
    nothing if all is right."""

    arm: str
    found: tuple[str, ...]
    findings: tuple[str, ...]

    def __str__(self) -> str:
        verdict = "are right and complete" if self.agrees else "are not right and complete"
        lines = [f"Your joint angles for {self.arm} {verdict}."]
        lines += [f"- found: {name}" for name in self.found]
        return "\n".join([*lines, *(f"- {finding}" for finding in self.findings)])


def compare_branches(mine: ArrayLike, found: Solutions) -> BranchReport:
    """Judge your joint vectors, shape (answers, dof), for one target against all of its branches.

    Whole turns do not matter, nor does the order. A wrong answer is told how far off the tip is
    and, where one slip explains it, which: a sign, half a turn (atan for atan2), degrees, or joints
    of different branches mixed. Where a joint is free any one value of it stands for the branch.
    Raises ArmError for another shape, or where `found` holds many targets.
    """
    must_be(found, Solutions, "found")
    arm = found.arm
    mine = floats(mine, f"{arm.name}: q", f"joint vectors, (answers, {arm.dof})")
    if found.valid.ndim != 1:
        raise ArmError(
            f"{arm.name}: found holds {found.distance.size} targets; expected the branches of one"
        )
    answers = np.atleast_2d(arm.joint_vector(mine)) if mine.size else np.zeros((0, arm.dof))
    if answers.ndim != 2:
        raise ArmError(
            f"{arm.name}: your answers have shape {answers.shape}; expected (answers, {arm.dof})"
        )
    branches, names = found.q[found.valid], np.array(found.branches)[found.valid]
    loose = found.free[found.valid]
    findings, hits = [], {}
    for number, q in enumerate(answers, 1):
        match = _matches(arm, q, branches, loose)
        if not match.size:
            findings.append(f"answer {number} {_what_is_wrong(arm, q, branches, names)}")
        else:
            hits.update({int(k): number for k in match if int(k) not in hits})
    missing = [str(name) for k, name in enumerate(names) if k not in hits]
    if missing:
        findings.append(f"missing: {'; '.join(missing)}")
    return BranchReport(arm.name, tuple(str(names[k]) for k in sorted(hits)), tuple(findings))


def _matches(arm: Arm, q: Array, branches: Array, loose: Array) -> Array:
    """The branches that q is: the same joints, or, where a joint is free, another member of the
    branch's family.

    A member reaches the target too and differs only in joints that can move together without the
    tip. Where two families share those (a UR's elbows), the nearer one counts.
    """
    gap = _gap(arm, q, branches)
    same = (gap < _WITHIN).all(axis=-1)
    family = loose.any(axis=-1)
    if family.any() and _misses(arm, q, branches) is None:
        family &= ((gap < _WITHIN) | _moving_in_place(arm, branches)).all(axis=-1)
        far = np.where(loose, 0.0, gap).sum(axis=-1)
        same |= family & (far < far[family].min(initial=np.inf) + _WITHIN)
    return np.flatnonzero(same)


def _moving_in_place(arm: Arm, branches: Array) -> NDArray[np.bool_]:
    """Which joints can move while the tip stands still, by the Jacobian's null space, shape
    (branches, dof)."""
    J = jacobian(arm, branches)[..., : 6 if arm.dof >= 6 else 3, :]
    _, sizes, directions = np.linalg.svd(J)
    return (np.abs(directions) * (sizes < _NEAR)[..., None]).max(axis=-2) > _NEAR


def _misses(arm: Arm, q: Array, branches: Array) -> tuple[float, float] | None:
    """How far q's tip is from the target (m, rad), or None where it is there."""
    if not len(branches):
        return np.inf, np.inf
    target = forward_kinematics(arm, branches[0])
    here = solve(arm, target if arm.dof >= 6 else target[:3, 3], q, iterations=0, limits=False)
    errors = float(here.position_error), float(here.orientation_error)
    return errors if max(errors) > _NEAR else None


def _gap(arm: Arm, q: Array, other: Array) -> Array:
    gap = np.abs(q - other)
    return np.where(arm.turning, np.abs(np.angle(np.exp(1j * gap))), gap)


def _what_is_wrong(arm: Arm, q: Array, branches: Array, names: Array) -> str:
    if not len(branches):
        return "cannot be right: no joint angles reach this target"
    missed = _misses(arm, q, branches)
    if missed is None:
        return "reaches the target by joint angles that are no branch of ours: please tell us"
    off = f"misses the target by {_rounded(1e3 * missed[0])} mm"
    off += f" and {_rounded(np.degrees(missed[1]))}°" if arm.dof >= 6 else ""
    for slip, corrected in _usual_slips(arm, q):
        found = np.flatnonzero((_gap(arm, corrected, branches) < _WITHIN).all(axis=-1))
        if found.size:
            return f"{off}: {slip}, or it would be '{names[found[0]]}'"
    parts = (_gap(arm, q, branches) < _WITHIN).any(axis=0)
    if parts.all():
        return f"{off}: each joint is right in some branch, but they belong to different ones"
    wrong = ", ".join(f"q_{i}" for i, right in zip(arm.joints, parts, strict=True) if not right)
    return f"{off}: {wrong} {'is' if (~parts).sum() == 1 else 'are'} in no branch"


def _rounded(number: float) -> str:
    """Three digits, and 0 for what is rounding only."""
    return f"{round(number, 3):.3g}"


def _usual_slips(arm: Arm, q: Array) -> Iterator[tuple[str, Array]]:
    """Each slip with what q would be without it."""
    yield "it is in degrees", np.where(arm.turning, np.radians(q), q)
    yield "every joint has the wrong sign", -q
    for k, i in enumerate(arm.joints):
        one = np.arange(arm.dof) == k
        yield f"q_{i} has the wrong sign", np.where(one, -q, q)
        if arm.turning[k]:
            yield f"q_{i} is half a turn off, as by atan for atan2", np.where(one, q + np.pi, q)
            yield (
                f"q_{i} is measured from the other axis (pi/2 less it)",
                np.where(one, np.pi / 2 - q, q),
            )
