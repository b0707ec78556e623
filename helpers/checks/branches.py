"""Is my inverse kinematics right and complete? Each of your answers is judged, and what is missing
is named.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks import door, inverse_causes
from helpers.checks.digits import HALF, HAND, RIGHT, ROUNDED, SO_FAR, WRONG, Typed
from helpers.checks.ranking import Cause, lower, several
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be
from helpers.inverse.numeric import solve
from helpers.inverse.solutions import Solutions
from helpers.kinematics import forward_kinematics, jacobian
from helpers.reading.sentences import listed, millimetres, say, size

Array = NDArray[Any]

_EXACT = 1.01e-4  # rad or m: answers copied from paper with four decimals still count
_REACHED = 1e-6  # m and rad: a pose this close is the target's, whatever the digits
_NEAR = 1e-3  # a singular value, or a sine, this small counts as 0
_BY_HAND = 0.0301  # rad or m: the most that rounding on the way is allowed
_OF_ONE_STEP = (
    "ik.sign",
    "ik.plus for minus",
)  # told rather than that joints of two branches are mixed
_COARSE = 5.1e-3  # rad or m: with a larger unit than this, branches and slips are not told apart


@dataclass(frozen=True)
class _Branches:
    """The right answers: joint vectors, names, which joints are free, and the tip's pose."""

    arm: Arm
    q: Array
    names: tuple[str, ...]
    free: NDArray[np.bool_]
    count: int  # with those that fall together

    @property
    def target(self) -> Array:
        return forward_kinematics(self.arm, self.q[0])


def compare_branches(
    mine: object, found: Solutions, *, angles: str = "rad", tolerance: float | None = None
) -> Report:
    """Judge your joint vectors, shape (answers, dof), for one target against all of its branches.

    Whole turns do not matter, nor does the order. A wrong answer is told how far off the tip is
    and, where one slip or two explain it, which; what is missing is named. Where a joint is free
    any one value of it stands for the branch.

    Args:
        mine: an array, lists, text, or pairs such as ('theta1', 0.3).
        found: what a closed form gives for the target.
        angles: "deg" where yours are in degrees.
        tolerance: the largest deviation of a joint (rad or m); inferred from the digits typed
            unless given.

    Raises ArmError for another shape, or where `found` holds many targets.
    """
    must_be(found, Solutions, "found")
    tolerance = door.settings(angles, tolerance)
    arm = found.arm
    if found.valid.ndim != 1:
        raise ArmError(say("one target", arm=arm.name, count=found.distance.size))
    typed, taken = answers(mine, arm, angles)
    right = _apart(found)
    if len(typed.values) == arm.dof > 1 and not _hits(right, typed, tolerance)[0]:
        columns, said = answers(mine, arm, angles, by_columns=True)
        if not _hits(right, columns, tolerance)[1]:
            typed, taken = columns, said
    if angles == "rad" and _only_as_degrees(right, typed, tolerance):
        degrees = door.in_radians(typed, arm)
        return _report(right, degrees, tolerance, taken, inverse_causes.cause("ik.degrees"))
    return _report(right, typed, tolerance, taken, None)


def _apart(found: Solutions) -> _Branches:
    """The branches that there are, those that fall together taken once."""
    valid = np.flatnonzero(found.valid)
    once = [
        k
        for n, k in enumerate(valid)
        if not (_gap(found.arm, found.q[k], found.q[valid[:n]]) < _REACHED).all(axis=1).any()
    ]
    names = tuple(str(found.branches[k]) for k in once)
    return _Branches(found.arm, found.q[once], names, found.free[once], len(valid))


def _only_as_degrees(right: _Branches, typed: Typed, tolerance: float | None) -> bool:
    """Whether answers are branches in degrees and none is in radians; angles so small that zero is
    as near to the branch tell nothing.
    """
    arm = right.arm
    if _hits(right, typed, tolerance)[0]:
        return False
    degrees = door.in_radians(typed, arm)
    hits = _hits(right, degrees, tolerance)[0]
    zero = np.where(arm.turning, 0.0, typed.values)
    return any(
        k not in _matches(right, zero[n - 1], _margins(degrees.units[n - 1], tolerance, hand=True))
        for k, n in hits.items()
    )


def answers(
    mine: object, arm: Arm, angles: str, *, by_columns: bool = False
) -> tuple[Typed, tuple[str, ...]]:
    """Joint vectors (answers, dof) with their units, however they were held; a square is read by
    rows unless told.
    """
    what = f"{arm.name}: q"
    typed = door.numbers(door.unnamed(mine), what, wanted=f"joint vectors (answers, {arm.dof})")
    said: tuple[str, ...] = ()
    if not typed.values.size:
        none = np.zeros((0, arm.dof))
        return Typed(none, none), ()
    values, units = (np.atleast_2d(np.squeeze(x)) for x in (typed.values, typed.units))
    if by_columns or values.shape[1] != arm.dof == values.shape[0]:
        values, units, said = values.T, units.T, (say("taken: answer per column"),)
    if values.shape[1:] != (arm.dof,):
        shape = "x".join(map(str, typed.values.shape))
        raise ArmError(say("answers shape", arm=arm.name, shape=shape, dof=arm.dof))
    found = Typed(values, units)
    return (door.in_radians(found, arm) if angles == "deg" else found), said


# Which branch an answer is


def _margins(units: Array, tolerance: float | None, hand: bool = False) -> Array:
    if tolerance is not None:
        return np.full(units.shape, max(tolerance, 1e-9))
    by_hand = np.maximum(HALF * units, np.minimum(HAND * units, _BY_HAND))
    return np.maximum(by_hand if hand else HALF * units, _EXACT)


def _each(typed: Typed) -> Array:
    """Each answer with its units, shape (answers, 2, dof)."""
    return np.stack([typed.values, typed.units], axis=1)


def _hits(
    right: _Branches, typed: Typed, tolerance: float | None
) -> tuple[dict[int, int], list[int], bool]:
    """The answer that gives each branch, the answers that give none, and whether all are right to
    their digits.
    """
    hits: dict[int, int] = {}
    astray, sharp = [], True
    for number, (q, units) in enumerate(_each(typed), 1):
        match = _matches(right, q, _margins(units, tolerance))
        if not match.size:
            match = _matches(right, q, _margins(units, tolerance, hand=True))
            sharp = False
        hits = {int(k): number for k in match} | hits
        if not match.size:
            astray.append(number)
    return hits, astray, sharp


def _matches(right: _Branches, q: Array, margin: Array) -> Array:
    """The branches that q is: the same joints, or, where a joint is free, another member of the
    branch's family.

    A member reaches the target too and differs only in joints that can move together without the
    tip. Where two families share those (a UR's elbows), the nearer one counts.
    """
    arm = right.arm
    gap = _gap(arm, q, right.q)
    same = (gap <= margin).all(axis=1)
    family = right.free.any(axis=1)
    if family.any() and _miss(arm, q, right.target, margin) is None:
        family &= ((gap <= margin) | _moving_in_place(arm, right.q)).all(axis=1)
        far = np.where(right.free, 0.0, gap).sum(axis=1)
        same |= family & (far < far[family].min(initial=np.inf) + margin.max())
    return np.flatnonzero(same)


def _moving_in_place(arm: Arm, branches: Array) -> NDArray[np.bool_]:
    """Which joints can move while the tip stands still, by the Jacobian's null space, shape
    (branches, dof). An arm with a closed form has three joints for a point or six for a pose.
    """
    _, sizes, directions = np.linalg.svd(jacobian(arm, branches)[:, : arm.dof])
    return (np.abs(directions) * (sizes < _NEAR)[..., None]).max(axis=1) > _NEAR


def _miss(arm: Arm, q: Array, target: Array, margin: Array) -> tuple[float, float] | None:
    """How far q's tip is from the target (m, rad), or None where the digits of q explain it."""
    here = solve(arm, target if arm.dof >= 6 else target[:3, 3], q, iterations=0, limits=False)
    errors = float(here.position_error), float(here.orientation_error)
    J = np.abs(jacobian(arm, q)) @ margin
    far, turned = (max(_REACHED, float(np.linalg.norm(half))) for half in (J[:3], J[3:]))
    return None if errors[0] <= far and errors[1] <= turned else errors


def _gap(arm: Arm, q: Array, other: Array) -> Array:
    gap = np.abs(q - other)
    return np.where(arm.turning, np.abs(gap - 2 * np.pi * np.rint(gap / (2 * np.pi))), gap)


# The report


def _report(
    right: _Branches, typed: Typed, tolerance: float | None, taken, whole: Cause | None
) -> Report:
    arm = right.arm
    hits, astray, sharp = _hits(right, typed, tolerance)
    judged = [_wrong(right, typed, number, tolerance) for number in astray]
    missing = [n for k, n in enumerate(right.names) if k not in hits]
    found = [n for k, n in enumerate(right.names) if k in hits]
    named = list(dict.fromkeys(c.name for causes, _ in judged for c in causes))
    findings = [f for _, f in judged]
    if (found and len(found) < len(right.names)) or astray:
        findings[:0] = [Finding("found", n, None, None, say("ik found", name=n)) for n in found]
    if missing and (found or not astray):
        words = say("ik missing", names="; ".join(missing))
        findings.append(Finding("missing", "", None, None, words))
    unreachable = _out_of_range(right, missing, found)
    one_sided = [] if unreachable else _one_sided(right, missing, found)
    findings += one_sided
    named += [f.what for f in one_sided]
    figures = {
        "found": tuple(found),
        "right": 0 if whole else len(found),  # as they were typed
        "of": len(right.names),
        "wrong": len(astray),
    }
    notes = (*_notes(right), *_twice(arm, typed), *unreachable)
    coarse = tolerance is None and _coarse(right, typed)
    grade = (
        WRONG if whole or astray else SO_FAR if missing or coarse else RIGHT if sharp else ROUNDED
    )
    if whole:
        named, findings = (
            [whole.name],
            [Finding("cause", "", None, None, f"{whole.words}."), *findings],
        )
    headline = _headline(grade, right, whole, judged, len(found), coarse and not missing)
    return Report(
        "branches", arm.name, grade, headline, tuple(findings), tuple(named), taken, notes, figures
    )


def _coarse(right: _Branches, typed: Typed) -> bool:
    """Whether an answer has too few digits to tell, and is not exact all the same, as whole degrees
    may be.
    """
    return any(
        units.max() > _COARSE and not _matches(right, q, np.full(q.shape, _REACHED)).size
        for q, units in _each(typed)
    )


def _headline(
    grade: str, right: _Branches, whole: Cause | None, judged: list, count: int, coarse: bool
) -> str:
    fields = dict(arm=right.arm.name, count=count, all=len(right.names))
    if not len(right.q):
        return say("ik none", **fields)
    if whole:
        return say("ik wrong", cause=lower(whole.words), **fields)
    if grade == WRONG:
        firsts = {causes[0].name if causes else "" for causes, _ in judged}
        one = judged[0][0][0] if len(firsts) == 1 and "" not in firsts else None
        key = "ik wrong" if one else "ik some wrong"
        return say(key, cause=lower(one.words) if one else "", **fields)
    if grade == SO_FAR:
        return say("ik so far digits" if coarse else "ik so far", **fields)
    return say("ik right" if grade == RIGHT else "ik rounded", **fields)


def _one_sided(right: _Branches, missing: list[str], found: list[str]) -> list[Finding]:
    """One sign of a root forgotten: a joint that has one sign in all that is there and the other in
    all that is missing.
    """
    there = np.isin(right.names, found)
    if not (found and missing):
        return []
    for k, i in enumerate(right.arm.joints):
        q = right.q[:, k]
        clear = (np.abs(np.sin(q)) if right.arm.turning[k] else np.abs(q)).min() > _NEAR
        if (
            clear
            and len(set(np.sign(q[there]))) == 1
            and (np.sign(q[~there]) == -np.sign(q[there][0])).all()
        ):
            key = "ik.one sign" if k or not right.arm.turning[0] else "ik one side"
            return [Finding("ik.one sign", "", None, None, say(key, joint=f"q_{i}"))]
    return []


def _out_of_range(right: _Branches, missing: list[str], found: list[str]) -> list[str]:
    """A word where what is missing has a slide beyond its range."""
    if not (found and missing):
        return []
    q, (least, most) = right.q[np.isin(right.names, missing)], right.arm.limits
    beyond = ((q < least) | (q > most)).all(axis=0) & ~right.arm.turning
    joints = [f"q_{right.arm.joints[k]}" for k in np.flatnonzero(beyond)]
    return [say("ik out of range", joints=listed(joints))] if joints else []


def _twice(arm: Arm, typed: Typed) -> Iterator[str]:
    """A word on the first answers that are the same."""
    for n, q in enumerate(typed.values):
        alike = [k for k, x in enumerate(typed.values, 1) if (_gap(arm, x, q) <= _EXACT).all()]
        if len(alike) > 1 and alike[0] == n + 1:
            yield say("ik twice", numbers=listed(list(map(str, alike))))


def _notes(right: _Branches) -> Iterator[str]:
    if len(right.q) < right.count:
        yield say("ik together", count=len(right.q), all=right.count)
    for k, i in enumerate(right.arm.joints):
        if len(right.q) and right.free[:, k].any():
            yield say("ik free", joint=f"q_{i}")


def _wrong(
    right: _Branches, typed: Typed, number: int, tolerance: float | None
) -> tuple[tuple[Cause, ...], Finding]:
    arm, q = right.arm, typed.values[number - 1]
    margin = _margins(typed.units[number - 1], tolerance, hand=True)
    where = f"answer {number}"
    if not len(right.q):
        return (), Finding("answer", where, None, None, say("ik no branch", number=number))
    miss = _miss(arm, q, right.target, np.zeros(arm.dof))
    if miss is None:
        return (), Finding("answer", where, None, None, say("ik unlisted", number=number))
    turn = turned(miss[1]) if arm.dof == 6 else ""
    off = say("ik off", millimetres=millimetres(miss[0]), turn=turn)
    causes, words = _why(right, q, margin)
    said = say("ik answer", number=number, off=off, words=words)
    return causes, Finding(causes[0].name if causes else "answer", where, None, None, said)


def turned(angle: float) -> str:
    """How far a tip is turned, as a word after how far it is away."""
    return say("ik turn", degrees=size(round(math.degrees(angle), 3)))


def _why(right: _Branches, q: Array, margin: Array) -> tuple[tuple[Cause, ...], str]:
    """What explains an answer: one slip, joints of two branches mixed, or two slips; or else the
    joints that are in no branch.
    """
    arm = right.arm
    fits = _gap(arm, q, right.q) <= margin
    single = [*inverse_causes.single(arm, q), *inverse_causes.whole(arm, q)]
    single += inverse_causes.kept(q, right.q)
    mixed = _mixed(right, fits)
    for slips in (single, inverse_causes.double(arm, q)):
        found = _fitting(right, q, slips, margin)
        if found:
            causes = tuple(dict.fromkeys(c.name for c, _ in found))
            named = tuple(next(c for c, _ in found if c.name == n) for n in causes)
            words = say(
                "ik slip", cause=lower(several(named, most=2)), branch=right.names[found[0][1]]
            )
            if mixed and named[0].keys[0] not in _OF_ONE_STEP and len(named[0].keys) == 1:
                return (*named, mixed[0]), say("ik or mixed", words=words, mixed=mixed[1])
            return named, words
        if mixed:
            return (mixed[0],), mixed[1]
    astray = [f"q_{arm.joints[k]}" for k in np.flatnonzero(~fits.any(axis=0))]
    key = "ik in no branch" if len(astray) > 1 else "ik one in no branch"
    return (), say(key, joints=listed(astray))


def _fitting(right: _Branches, q: Array, slips, margin: Array) -> list[tuple[Cause, int]]:
    """The slips without which an answer would be a branch, and which; none that helps by less than
    half, nor a scale where zero would fit as well.
    """
    arm, slips = right.arm, list(slips)
    mended = np.stack([m for _, m in slips])[:, None, :]
    gap = _gap(arm, mended, right.q)
    helps = gap.max(axis=2) <= 0.5 * _gap(arm, q, right.q).max(axis=1)
    scaled = np.array([inverse_causes.scales(c) for c, _ in slips])[:, None]
    zero = _gap(arm, np.where(mended == q, q, 0.0), right.q)
    fits = helps & (gap <= 1.5 * margin).all(axis=2)
    fits &= ~(scaled & (zero <= 1.5 * margin).all(axis=2))
    return [(slips[k][0], int(b)) for k, b in np.argwhere(fits)]


def _mixed(right: _Branches, fits: NDArray[np.bool_]) -> tuple[Cause, str] | None:
    """Every joint in some branch: the branch with most of them, and the one that the others are
    from.
    """
    if not fits.any(axis=0).all():
        return None
    most = int(fits.sum(axis=1).argmax())
    rest = np.flatnonzero(~fits[most])
    other = next((k for k in range(len(fits)) if fits[k, rest].all()), None)
    joints = [f"q_{right.arm.joints[k]}" for k in rest]
    if other is None:
        return inverse_causes.cause("ik.mixed"), lower(say("ik.mixed"))
    words = say("ik mixed", joints=listed(joints), other=right.names[other], most=right.names[most])
    return inverse_causes.cause("ik.mixed"), words
