"""Is my Jacobian wrong, and how? The answer names the mistake and gives no numbers away."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks import door
from helpers.checks.chains import chain, columns
from helpers.checks.digits import (
    HAND,
    RIGHT,
    ROUNDED,
    SLOPPY,
    SO_FAR,
    TELLING,
    WRONG,
    Typed,
)
from helpers.checks.entries import Margins, graded, margins
from helpers.checks.functions import best, results
from helpers.checks.jacobian_causes import Catalogue, pairs, singles
from helpers.checks.ranking import Cause, Found, better, cause, complete, explain, lower, several
from helpers.checks.verdict import Finding, Report
from helpers.inputs import ArmError, must_be, shown, whole
from helpers.reading.sentences import listed, say

Array = NDArray[Any]

_CLOSE = 0.05  # what columns may be off by, however few their digits, to be known as some joints'
_ROWS = ("vx", "vy", "vz", "wx", "wy", "wz")
_HALVES = (("linear", slice(0, 3)), ("angular", slice(3, 6)))


def compare_jacobian(
    mine: object,
    arm: Arm,
    q: ArrayLike | str | None = None,
    *,
    angular_first: bool = False,
    frame: int = 0,
    angles: str = "rad",
    values: Mapping[str, float] | None = None,
    tolerance: float | None = None,
) -> Report:
    """Compare your Jacobian of an arm's tip with the right one, and name the mistake.

    Args:
        mine: a function of q, of q_1, q_2, ... one by one, or of the arm's table and q; a SymPy
            matrix or a text in q_1, theta1, c_1, s_23, ... and the arm's symbols; or numbers at
            `q`: an array, lists, or pasted from NumPy, MATLAB, LaTeX, a spreadsheet.
        arm: whose Jacobian it should be; a locked joint as ``arm.lock(3)``.
        q: where to compare, shape (dof,); a pose without symmetry unless given. Numbers need it.
        angular_first: whether your rows are (omega, v) rather than (v, omega).
        frame: the link frame in whose axes your rows are, 0 for the base.
        angles: "deg" where `q` is in degrees.
        values: numbers for symbols of yours that the arm does not have.
        tolerance: the largest deviation of an entry; inferred from the digits typed unless given.

    Raises ArmError where `mine` gives no matrix of numbers, or holds numbers and q is missing.
    """
    must_be(arm, Arm, "arm")
    tolerance = door.settings(angles, tolerance, values)
    if not isinstance(angular_first, int | np.bool_):
        raise ArmError(f"angular_first is {shown(angular_first)}; expected True or False")
    frame = _checked_frame(frame, arm)
    at = Typed(_generic_pose(arm), np.zeros(arm.dof)) if q is None else door.pose(q, arm, angles)
    held = _held(mine, arm, at.values, q is not None, values)
    where = _Where(arm, at, frame)
    reports = (
        _reported(typed, where, angular_first, tolerance, taken, callable(mine), not n)
        for n, (typed, taken) in enumerate(held)
    )
    return best(reports)


@dataclass(frozen=True)
class _Where:
    """An arm at one pose, its rows in the axes of one frame: what is right there, and what mistakes
    make of it, the same for each way of calling a function.
    """

    arm: Arm
    at: Typed
    frame: int

    @property
    def q(self) -> Array:
        return self.at.values

    @cached_property
    def known(self) -> Catalogue:
        return singles(self.arm, self.q, self.frame)

    @cached_property
    def slop(self) -> Array:
        """What the unwritten digits of q may change in each entry: those of q with three decimals
        or more.
        """
        units = self.at.unwritten
        if not units.any():
            return np.zeros((6, self.arm.dof))
        step = 1e-6
        beside = self.q + step * np.eye(self.arm.dof)
        there, here = (columns(chain(self.arm, q)) for q in (beside, self.q))
        rates = np.abs(there - here) / step
        if self.frame:
            rates = np.broadcast_to(rates.max(axis=1, keepdims=True), rates.shape)
        return 0.51 * np.einsum("k,kij->ij", units, rates)


def _reported(
    typed: Typed, where: _Where, angular_first: bool, tolerance, taken, function, why: bool
) -> Report | None:
    """The report; None where no single mistake explains what is wrong, unless `why` is asked."""
    if typed.values.shape not in ((6, where.arm.dof), (3, where.arm.dof)):
        return _misshapen(typed, where, taken)
    if not typed.values.any():
        return _empty(where.arm, taken)
    if angular_first and len(typed.values) == 6:
        typed = typed.at([3, 4, 5, 0, 1, 2])
        taken = (*taken, say("taken: angular first"))
    at_pose = not (typed.symbolic or function)
    return _judged(typed, where, tolerance, taken, at_pose, why)


def _generic_pose(arm: Arm) -> Array:
    lower, upper = arm.limits
    lower, upper = np.maximum(lower, -1.5), np.minimum(upper, 1.5)
    return lower + (upper - lower) * np.random.default_rng(19).uniform(0.55, 0.95, arm.dof)


def _held(
    mine: object, arm: Arm, q: Array, given: bool, values: Mapping | None
) -> Iterator[tuple[Typed, tuple[str, ...]]]:
    """The matrix as numbers and what to say of how it was taken; several where a function may be
    called in several ways.
    """
    what = f"{arm.name}: your Jacobian"
    lookup = door.Joints(arm, q, values)
    if callable(mine) and not hasattr(mine, "free_symbols"):
        for found, said in results(mine, arm, q, what):
            typed = replace(door.numbers(found, what, lookup), symbolic=True)
            yield _matrix(typed, arm, what), (*said, *lookup.said)
        return
    typed = door.numbers(mine, what, lookup)
    if not (given or typed.symbolic):
        raise ArmError(say("J needs q"))
    yield _matrix(typed, arm, what), lookup.said


def _matrix(typed: Typed, arm: Arm, what: str) -> Typed:
    if typed.values.ndim == 3 and 1 in typed.values.shape:
        axis = typed.values.shape.index(1)
        values, units = (x.take(0, axis) for x in (typed.values, typed.units))
        typed = replace(typed, values=values, units=units)
    if typed.values.ndim == 2 and typed.values.size == 6 * arm.dof == max(typed.values.shape):
        values, units = (x.reshape(6, arm.dof) for x in (typed.values, typed.units))
        typed = replace(typed, values=values, units=units)
    if typed.values.ndim != 2:
        raise ArmError(say("no matrix", what=what, shape=typed.values.shape))
    return typed


# The shape


def _misshapen(typed: Typed, where: _Where, taken: tuple[str, ...]) -> Report:
    M, arm = typed.values, where.arm
    key, joint = _shape_cause(M, arm), _left_out(typed, where)
    key = "J.column missing" if joint else key
    words = say(key, shape="x".join(map(str, M.shape)), dof=arm.dof, joint=joint)
    words = f"{words.rstrip('.')}."
    finding = Finding("shape", "", M.shape, (6, arm.dof), words)
    return Report(
        "Jacobian",
        arm.name,
        WRONG,
        say("J wrong", arm=arm.name, cause=lower(words)),
        (finding,),
        (f"{key}:{joint}" if joint else key,),
        taken,
    )


def _empty(arm: Arm, taken: tuple[str, ...]) -> Report:
    words = say("J.empty")
    finding = Finding("cause", "", None, None, words)
    headline = say("J wrong", arm=arm.name, cause=lower(words))
    return Report("Jacobian", arm.name, WRONG, headline, (finding,), ("J.empty",), taken)


def _left_out(typed: Typed, where: _Where) -> int:
    """The only joint without which the columns are right; 0 where there is none."""
    arm = where.arm
    if typed.values.shape != (6, arm.dof - 1):
        return 0
    right = where.known.right
    band = np.clip(HAND * typed.units, SLOPPY, _CLOSE)
    without = (np.delete(right, k, axis=1) for k in range(arm.dof))
    fits = [bool((np.abs(typed.values - J) <= band).all()) for J in without]
    return arm.joints[fits.index(True)] if fits.count(True) == 1 else 0


def _shape_cause(M: Array, arm: Arm) -> str:
    rows = len(arm.rows)
    if M.shape == (arm.dof, 6):
        return "J.transposed"
    if rows > arm.dof and M.shape == (5, rows):
        return "J.row for column"
    if rows > arm.dof and M.shape == (6, rows):
        return "J.locked column kept"
    return "J.shape"


# The verdict


def _judged(
    typed: Typed,
    where: _Where,
    tolerance: float | None,
    taken: tuple[str, ...],
    at_pose: bool,
    why: bool,
) -> Report | None:
    arm, known = where.arm, where.known
    rows = slice(0, 6)
    if len(typed.values) == 3:
        rows = _rows_meant(typed.values, known.right)
        taken = (*taken, say("taken: half", half="linear" if rows.start == 0 else "angular"))
    right, made = known.right[rows], known.made[:, rows]
    sizes = [max(1e-3, np.abs(known.right[half]).max()) for _, half in _HALVES]
    scale = np.repeat(sizes, 3)[rows, None] + 0 * right
    m = margins(typed.units, scale, where.slop[rows], tolerance)
    grade = graded(typed.values, right, m, made)
    if grade != WRONG:
        notes = tuple(_hidden(known)) if at_pose else ()
        return _good(grade, typed, arm, rows, taken, notes, at_pose)
    if not why:
        one = explain(typed.values, right, m.band, known.causes, made)
        return _bad(one.causes, (), arm, taken) if complete(one) else None
    found, more = _causes(typed.values, right, m, rows, where)
    return _bad(found, more, arm, taken)


def _checked_frame(frame: int, arm: Arm) -> int:
    number = whole(frame, f"{arm.name}: frame")
    if number > len(arm.rows):
        raise ArmError(
            f"{arm.name}: frame is {number}; expected a whole number from 0 to {len(arm.rows)}"
        )
    return number


def _rows_meant(M: Array, right: Array) -> slice:
    """Which half three rows are: the one they are nearer to."""
    off = [np.linalg.norm(M - right[rows]) for _, rows in _HALVES]
    return _HALVES[int(off[1] < off[0])][1]


def _hidden(known: Catalogue) -> Iterator[str]:
    """A word on the mistakes that this pose does not show."""
    effect = np.abs(known.made - known.right).max(axis=(1, 2))
    method = np.array(
        [c.keys[0].startswith("J.") and c.keys[0] != "J.columns exchanged" for c in known.causes]
    )
    blind = int((method & (effect < TELLING)).sum())
    if blind:
        yield say("J hidden", count=blind, all=int(method.sum()))


def _good(grade, typed: Typed, arm: Arm, rows: slice, taken, notes, at_pose: bool) -> Report:
    whole = rows == slice(0, 6)
    digits = typed.decimals
    key = {RIGHT: "J right", SO_FAR: "J so far", ROUNDED: "J rounded"}[grade]
    key = key if whole or grade != RIGHT else "J half right"
    where = say("at this pose") if at_pose else ""
    precision = "" if digits is None or digits > 6 else say("to decimals", digits=digits)
    half, other = ("linear", "angular") if rows.start == 0 else ("angular", "linear")
    words = say(
        key,
        arm=arm.name,
        where=where,
        precision=precision,
        digits=digits or 0,
        half=half,
        other=other,
    )
    missing = (
        ()
        if whole
        else (Finding("missing", f"{other} rows", None, None, say("J half missing", other=other)),)
    )
    grade = grade if whole or grade != RIGHT else SO_FAR
    return Report("Jacobian", arm.name, grade, words, missing, (), taken, notes)


def _bad(found: tuple[Cause, ...], symptoms: tuple[Finding, ...], arm: Arm, taken) -> Report:
    if found:
        words = several(found)
        findings = (Finding("cause", "", None, None, f"{words}."), *symptoms)
        headline = say("J wrong", arm=arm.name, cause=f"{lower(words)}.")
        return Report(
            "Jacobian", arm.name, WRONG, headline, findings, tuple(c.name for c in found), taken
        )
    if all(_everything(f) for f in symptoms) and len(symptoms) == arm.dof:
        key = "J turns" if arm.turning[0] else "J slides"
        question = say(key, joint=arm.joints[0])
        headline = say("J wrong everywhere", arm=arm.name, question=question)
        return Report("Jacobian", arm.name, WRONG, headline, (), (), taken)
    headline = (
        say("J wrong place", arm=arm.name, words=lower(symptoms[0].words))
        if len(symptoms) == 1
        else say("J wrong places", arm=arm.name, places=listed([f.where for f in symptoms]))
    )
    causes = tuple(dict.fromkeys(f.what for f in symptoms if "." in f.what))
    return Report("Jacobian", arm.name, WRONG, headline, symptoms, causes, taken)


def _everything(f: Finding) -> bool:
    """Whether a column is wrong in every row, for no reason that is known."""
    return f.what == "column" and all(name in f.words for name in _ROWS)


# The causes


def _causes(M, right, m: Margins, rows: slice, where: _Where):
    """What explains the whole, then both halves apart, then each column."""
    known, arm, at = where.known, where.arm, (where.arm, where.q, where.frame)
    two, ways = (cache(partial(make, *at)) for make in (pairs, _other_ways))
    for band in m.bands:
        found = explain(M, right, band, known.causes, known.made[:, rows])
        if not complete(found):
            other = explain(M, right, band, two().causes, two().made[:, rows])
            turned = explain(M, right, band, ways().causes, ways().made[:, rows])
            found = better(found, other, turned if complete(turned) else None)
        if found:
            return found.causes, tuple(_odd_columns(found, arm))
        if len(M) == 6 and (halves := _by_halves(M, right, band, known)):
            return halves, ()
    band = m.band if (np.abs(M - right) > m.band).any() else m.allowed
    return (), tuple(_columns(M, right, band, rows, where))


def _by_halves(M, right, band, known: Catalogue) -> tuple[Cause, ...]:
    """One cause for each wrong half, as a pair, if each half has one."""
    said = []
    for half, rows in _HALVES:
        if (np.abs(M[rows] - right[rows]) <= band[rows]).all():
            continue
        found = explain(M[rows], right[rows], band[rows], known.causes, known.made[:, rows])
        if not complete(found):
            return ()
        first = next((c for c in found.causes if half in c.keys[0]), found.causes[0])
        inside = f"{half} rows" in first.words
        said.append(
            first if inside else cause("J in half", half=half, words=first.words, _of=first.name)
        )
    return (sum(said[1:], said[0]),) if said else ()


def _other_ways(arm: Arm, q: Array, frame: int) -> Catalogue:
    """Joints counted the other way, in the matrix and in q; fewest first."""
    ways = [s for s in product((1.0, -1.0), repeat=arm.dof) if min(s) < 0]
    signs = np.array(sorted(ways, key=lambda s: -sum(s)))
    at = chain(arm, signs * q)
    J = columns(at) * signs[:, None, :]
    if frame:
        R = np.swapaxes(at.frames[:, frame, :3, :3], -1, -2)
        J = np.concatenate([R @ J[:, :3], R @ J[:, 3:]], axis=1)
    names = [
        listed([f"q_{i}" for i, s in zip(arm.joints, row, strict=True) if s < 0]) for row in signs
    ]
    return Catalogue(J[0], [cause("joints reversed", joints=n) for n in names], J)


def _odd_columns(found: Found, arm: Arm) -> Iterator[Finding]:
    for k in np.flatnonzero(found.odd.any(axis=0)):
        where = f"column {k + 1}"
        names = ", ".join(n for n, odd in zip(_ROWS, found.odd[:, k], strict=False) if odd)
        words = say("J besides", column=k + 1, joint=arm.joints[k], rows=names)
        yield Finding("column", where, None, None, words)


def _columns(M, right, band, rows: slice, where: _Where) -> Iterator[Finding]:
    arm, others = where.arm, list(_all_columns(where))
    for k in range(arm.dof):
        if (np.abs(M[:, k] - right[:, k]) > band[:, k]).any():
            key, words = _column(k, M, right, band, rows, where, others)
            said = say("J column", column=k + 1, joint=arm.joints[k], words=words)
            yield Finding(key, f"column {k + 1}", None, None, said)


def _column(k: int, M, right, band, rows: slice, where: _Where, others: list) -> tuple[str, str]:
    arm, known = where.arm, where.known
    mine, wanted, width = M[:, k], right[:, k], band[:, k]

    def same(other: Array) -> bool:
        return bool((np.abs(mine - other) <= width).all())

    if same(-wanted):
        return f"J.column sign:{arm.joints[k]}", say("J sign of column")
    if len(mine) == 6 and same(np.roll(wanted, 3)):
        return "J.column halves", say("J.column halves")
    for joint, other in others:
        if joint != arm.joints[k] and same(other[rows]):
            key = "J.column of" if joint in arm.joints else "J.column of locked"
            return key, say(key, joint=joint)
    fits = (np.abs(known.made[:, rows, k] - mine) <= width).all(axis=1)
    for c in (known.causes[int(n)] for n in np.flatnonzero(fits)):
        if c.keys[0].startswith("J."):
            return c.name, lower(c.words)
    off = np.abs(mine - wanted) > width
    names = [n for n, wrong in zip(_ROWS[rows], off, strict=True) if wrong]
    turned = bool((np.abs(mine + wanted) <= width)[off].all())
    return "column", say("J.entry signs" if turned else "J.entries", rows=listed(names))


def _all_columns(where: _Where) -> Iterator[tuple[int, Array]]:
    """Each joint's column in the declared frame, then those that locked joints would have."""
    arm, at = where.arm, chain(where.arm, where.q)
    R = at.frames[where.frame, :3, :3].T
    free = [i for i, row in enumerate(arm.rows, 1) if row.joint.kind == "fixed"]
    parts = [(list(arm.joints), columns(at))]
    if free:
        turning = np.ones(len(free), dtype=bool)
        loose = at.with_(q=np.zeros(len(free)), joints=tuple(free), turning=turning)
        parts.append((free, columns(loose, frames=at.frames)))
    for joints, J in parts:
        yield from zip(joints, np.concatenate([R @ J[:3], R @ J[3:]]).T, strict=True)
