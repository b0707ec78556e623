"""Are my joint torques wrong, and how? One torque vector or a whole run of them."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks import door
from helpers.checks.digits import RIGHT, ROUNDED, SO_FAR, WRONG, Typed, of_floats
from helpers.checks.entries import Margins, graded, margins
from helpers.checks.functions import best, results
from helpers.checks.ranking import Cause, Found, better, complete, explain, lower, several
from helpers.checks.torques_causes import Load, catalogue, mended, paper_centres, reversed_joints
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be
from helpers.reading.sentences import listed, say, size
from helpers.statics import GRAVITY, forces, static_torque

Array = NDArray[Any]

_NO_WRENCH = (0.0,) * 6
_ODD = 1.2  # a torque that stays unexplained weighs more than a second mistake
_SAMPLE = 25  # poses of a run on which causes are tried


def compare_torques(
    mine: object,
    arm: Arm,
    q: ArrayLike | str,
    wrench: ArrayLike = _NO_WRENCH,
    gravity: ArrayLike = GRAVITY,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
) -> Report:
    """Compare your torques at q, shape (..., dof), with g(q) - J^T F, and name the mistake.

    Args:
        mine: torques (..., dof) as an array, lists, SymPy columns or text; one list per joint and
            column vectors are turned round. A function of q, or of the arm's table and q, is called
            at each pose.
        arm: with masses.
        q: joints of shape (..., dof), or text.
        wrench: on the tool, by the world, shape (6,), or (..., 6) with one for each pose.
        gravity: the vector of its acceleration in base axes (m/s^2).
        angles: "deg" where `q` is in degrees.
        tolerance: the largest deviation (N m); inferred from the digits typed unless given.

    One pose can hide a mistake that a whole path shows. Raises ArmError where `mine` is not numbers
    or the arm has no masses.
    """
    must_be(arm, Arm, "arm")
    tolerance = door.settings(angles, tolerance)
    at, F = _poses(q, arm, angles), forces(wrench)
    F = F.reshape(-1, 6) if F.ndim > 2 else F
    right = np.atleast_2d(static_torque(arm, at.values, F, gravity))
    if len(right) > len(np.atleast_2d(at.values)):  # one pose under several loads
        at = Typed(np.tile(at.values, (len(right), 1)), np.tile(at.units, (len(right), 1)))
    what = f"{arm.name}: your torques"
    where = _Where(arm, at, F, np.array(gravity, float), right)
    reports = (
        _reported(typed, where, tolerance, said, not n)
        for n, (typed, said) in enumerate(_held(mine, arm, at.values, what))
    )
    return best(reports)


@dataclass(frozen=True)
class _Where:
    """An arm under its load at some poses: what is right there, and what mistakes make of it, the
    same for each way of calling a function.
    """

    arm: Arm
    at: Typed
    wrench: Array
    gravity: Array
    right: Array

    @cached_property
    def pick(self) -> Array:
        """The poses on which causes are tried."""
        return np.unique(np.linspace(0, len(self.right) - 1, _SAMPLE).astype(int))

    @cached_property
    def load(self) -> Load:
        wrench = np.broadcast_to(self.wrench, (len(self.right), 6))[self.pick]
        return Load(self.arm, np.atleast_2d(self.at.values)[self.pick], wrench, self.gravity)

    @cached_property
    def singles(self) -> tuple[list[Cause], Array]:
        return catalogue(self.load, 1)

    @cached_property
    def slop(self) -> Array | float:
        """What the unwritten digits of q may change in each torque: those of q with three decimals
        or more.
        """
        units = self.at.unwritten
        if not units.any():
            return 0.0
        q, units, step = np.atleast_2d(self.at.values), np.atleast_2d(units), 1e-6
        here, *there = (
            static_torque(self.arm, q + x, self.wrench, self.gravity)
            for x in (0.0, *(step * np.eye(self.arm.dof)))
        )
        rates = (np.abs(torques - here) / step for torques in there)
        return 0.51 * sum(rate * units[:, k, None] for k, rate in enumerate(rates))


def _held(mine: object, arm: Arm, q: Array, what: str) -> Iterator[tuple[Typed, tuple[str, ...]]]:
    """The torques as numbers; a function is called pose by pose, or with the whole run where it
    wants that.
    """
    if not callable(mine):
        yield door.numbers(door.unnamed(mine), what), ()
        return
    poses = np.atleast_2d(q)
    try:
        ways = list(zip(*(results(mine, arm, x, what) for x in poses), strict=False))
    except ArmError:
        ways = []
    if not ways or np.size(ways[0][0][0]) != arm.dof:
        ways = [(way,) for way in results(mine, arm, q, what)]
    for found in ways:
        rows = [door.numbers(torques, what).values for torques, _ in found]
        values = rows[0] if len(rows) == 1 else np.array([row.ravel() for row in rows])
        yield Typed(values, of_floats(values)), found[0][1]


def _reported(typed: Typed, where: _Where, tolerance, said, why: bool) -> Report | None:
    """The report; None where no single mistake explains what is wrong, unless `why` is asked."""
    upright, taken = _upright(typed, where.right)
    if upright is None or upright.values.shape != where.right.shape:
        return _misshapen(typed.values, where, said)
    return _judged(upright, where, tolerance, (*said, *taken), why)


def _poses(q: ArrayLike | str, arm: Arm, angles: str) -> Typed:
    typed = door.numbers(door.unnamed(q), f"{arm.name}: q", wanted=door.one_value_each(arm))
    values, units = typed.values, typed.units
    if values.ndim == 2 and values.shape[0] == arm.dof != values.shape[1]:
        values, units = values.T, units.T
    if values.shape[:1] == (1,) and values.ndim == 2:
        values, units = values[0], units[0]
    if angles == "deg" and values.shape[-1:] == (arm.dof,):
        factor = np.where(arm.turning, np.pi / 180, 1.0)
        values, units = values * factor, units * factor
    values = arm.joint_vector(values)
    if values.ndim > 2:
        values, units = (x.reshape(-1, arm.dof) for x in (values, units))
    return Typed(values, units)


def _upright(typed: Typed, right: Array) -> tuple[Typed | None, tuple[str, ...]]:
    """The torques with a row per pose: columns, lists per joint and a leading column of zeros are
    set right, and said.
    """
    M, steps = np.squeeze(typed.values), np.squeeze(typed.units)
    poses, dof = right.shape
    if M.shape == (dof,) and poses == 1:
        return Typed(M[None], steps[None]), ()
    if M.ndim != 2:
        return None, ()
    said: tuple[str, ...] = ()
    if M.shape == (dof, poses) and (poses != dof or _fits_turned(M, right)):
        M, steps, said = M.T, steps.T, (say("taken: list per joint"),)
    if M.shape == (poses, dof + 1) and not M[:, 0].any():
        M, steps, said = M[:, 1:], steps[:, 1:], (*said, say("taken: leading zeros"))
    return Typed(M, steps), said


def _fits_turned(M: Array, right: Array) -> bool:
    """Whether a square of torques is meant by columns: only then is it anywhere near."""
    return bool(np.abs(M.T - right).max() < 0.05 * np.abs(M - right).max())


def _misshapen(M: Array, where: _Where, said: tuple[str, ...]) -> Report:
    arm, right = where.arm, where.right
    poses, dof = right.shape
    one_each = M.size == poses and M.size != right.size
    key = "tau.energy" if one_each else "tau.shape"
    shape = "x".join(map(str, M.shape if poses > 1 else np.squeeze(M).shape)) or "1"
    wanted = f"{poses}x{dof}" if poses > 1 else str(dof)
    words = say(key, shape=shape, wanted=wanted, dof=dof)
    finding = Finding("shape", "", M.shape, right.shape, words)
    return Report(
        "torques",
        arm.name,
        WRONG,
        say("tau wrong", arm=arm.name, cause=lower(words)),
        (finding,),
        (key,),
        said,
    )


def _judged(typed: Typed, where: _Where, tolerance, taken, why: bool) -> Report | None:
    arm, right, pick = where.arm, where.right, where.pick
    causes, made = where.singles
    scale = max(float(np.abs(right).max()), 1e-3)
    m = margins(typed.units, np.full(right.shape, scale), where.slop, tolerance)
    part = m.at(pick)
    grade = graded(typed.values[pick], right[pick], part, made)
    grade = _whole(grade, typed.values, right, m)
    off = np.abs(typed.values - right)
    good = int((off <= m.band).all(axis=0).sum())
    figures = {"worst": float(off.max(initial=0.0)), "right": good, "of": arm.dof}
    if grade != WRONG:
        return _good(grade, typed, arm, taken, figures)
    if not why:
        one = explain(typed.values[pick], right[pick], part.band, causes, made)
        return _bad(one, (), arm, taken, figures) if complete(one) else None
    more, also = catalogue(where.load, 2)
    known = (causes + more, np.concatenate([made, also]))
    found = _found(typed.values[pick], right[pick], part, known, where.load)
    if found:
        symptoms = tuple(_besides(found, arm, len(right)))
    else:
        symptoms = tuple(_joints(typed.values, right, m, arm))
    return _bad(found, symptoms, arm, taken, figures)


def _whole(grade: str, mine: Array, right: Array, m: Margins) -> str:
    """The grade of the sample, unless a pose between its poses is worse."""
    off = np.abs(mine - right)
    if grade in (RIGHT, SO_FAR) and (off > m.allowed + m.slop).any():
        grade = ROUNDED
    return (
        WRONG
        if grade == ROUNDED and (off > np.maximum(m.loose, m.band + 2 * m.slop)).any()
        else grade
    )


def _good(grade: str, typed: Typed, arm: Arm, taken, figures) -> Report:
    digits = typed.decimals
    precision = "" if digits is None or digits > 6 else say("to decimals", digits=digits)
    key = {RIGHT: "tau right", SO_FAR: "tau so far", ROUNDED: "tau rounded"}[grade]
    words = say(key, arm=arm.name, precision=precision, digits=digits or 0)
    return Report("torques", arm.name, grade, words, (), (), taken, (), figures)


def _found(mine, right, m: Margins, known, load: Load) -> Found | None:
    causes, made = known
    others, papers = (
        cache(partial(reversed_joints, load, right)),
        cache(partial(paper_centres, load)),
    )
    for band in m.bands:
        found = explain(mine, right, band, causes, made, odd=_ODD)
        if not complete(found):
            more = (explain(mine, right, band, *made()) for made in (others, papers))
            simplest = (Found(f.causes[:1], f.odd, f.rest) for f in more if complete(f))
            found = better(found, *simplest, odd=_ODD)
        if found:
            return found
    return None


def _joints(mine: Array, right: Array, m: Margins, arm: Arm) -> Iterator[Finding]:
    """Each wrong joint."""
    wrong = (np.abs(mine - right) > m.band).any(axis=0)
    if not wrong.any():
        wrong = (np.abs(mine - right) > m.allowed).any(axis=0)
    for k in np.flatnonzero(wrong):
        flipped = np.abs(mine + right)[:, k]
        key = "tau other way" if (flipped <= m.band[:, k]).all() else "tau off"
        yield _off(key, arm, k, mine - right)


def _besides(found: Found, arm: Arm, count: int) -> Iterator[Finding]:
    """Each joint that a cause leaves unexplained, by how much once the cause is mended."""
    rest = mended(found.causes[0], np.where(found.odd, found.rest, 0.0))
    tried = say("at poses tried", count=len(rest)) if len(rest) < count else ""
    for k in np.flatnonzero(rest.any(axis=0)):
        yield _off("tau besides", arm, k, rest, tried=tried)


def _off(key: str, arm: Arm, k: Any, off: Array, **fields: str) -> Finding:
    most = round(float(np.abs(off[:, k]).max()), 9)  # ties in both languages alike
    said = say(
        key,
        joint=arm.joints[k],
        most=say("up to") if len(off) > 1 else "",
        off=size(most, 3),
        unit="N m" if arm.turning[k] else "N",
        **fields,
    )
    return Finding("joint", f"joint {arm.joints[k]}", None, None, said)


def _bad(found: Found | None, symptoms, arm: Arm, taken, figures) -> Report:
    if found:
        words = several(found.causes)
        findings = (Finding("cause", "", None, None, f"{words}."), *symptoms)
        headline = say("tau wrong", arm=arm.name, cause=f"{lower(words)}.")
        names = tuple(c.name for c in found.causes)
        return Report("torques", arm.name, WRONG, headline, findings, names, taken, (), figures)
    headline = say("tau wrong places", arm=arm.name, places=listed([f.where for f in symptoms]))
    return Report("torques", arm.name, WRONG, headline, symptoms, (), taken, (), figures)
