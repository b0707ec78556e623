"""Is my table wrong, or only different?"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import product

from helpers.arm import Arm, ArmError, Row
from helpers.checks.axes import Step, base_height, canonical, open_signs
from helpers.conventions import standard_from_modified

_WITHIN = 1e-6  # m and rad


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong: the row and quantity it shows in, and what it is in both tables (m or rad)."""

    row: int
    quantity: str
    mine: float | str
    reference: float | str
    text: str

    def __str__(self) -> str:
        return f"Row {self.row}, {self.quantity}: {self.text}"


@dataclass(frozen=True)
class TableReport:
    """What `compare_tables` found; `notes` are differences that are free choices, or a hint at the cause."""

    mine: str
    reference: str
    findings: tuple[Finding, ...]
    notes: tuple[str, ...] = ()

    @property
    def agrees(self) -> bool:
        """Whether both tables describe the same arm."""
        return not self.findings

    def __str__(self) -> str:
        verdict = "describes the same arm as" if self.agrees else "is another arm than"
        lines = [*map(str, self.findings), *(f"Note: {note}" for note in self.notes)]
        return "\n".join(
            [f"{self.mine} {verdict} {self.reference}.", *(f"- {line}" for line in lines)]
        )

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        head, *lines = str(self).split("\n")
        return "\n".join([f"{'✔' if self.agrees else '✘'} **{head}**", "", *lines])


def compare_tables(mine: Arm, reference: Arm) -> TableReport:
    """Whether two standard DH tables describe the same arm, and if not, where they differ.

    Compared is what no choice of frames can change: the kind of each joint, distance and twist between neighbouring
    axes, the offsets along each axis (along parallel axes only their sum), and where the tip is on the last link, all to
    within 1e-6 m or rad. Directions of axes, the places of common normals between parallel axes, zeros of the
    joints, and the orientation of the last frame are free. So is the height of the base frame on axis 1: a
    difference there is a note. The zeros of sliding joints are free unless two of them are neighbours.

    Raises ArmError where an arm has no joint. Source: Siciliano et al., Robotics, section 2.8.2, on the free choices.
    """
    for arm in (mine, reference):
        if not isinstance(arm, Arm) or not arm.dof:
            raise ArmError(f"cannot compare {arm!r}; expected an Arm with one joint or more")
    findings = _differences(mine, reference)
    notes = _base_note(mine, reference) if not findings else _hints(mine, reference)
    return TableReport(mine.name, reference.name, findings, notes)


def _differences(mine: Arm, reference: Arm) -> tuple[Finding, ...]:
    if mine.dof != reference.dof:
        text = f"yours has {mine.dof} joints, the reference {reference.dof}"
        return (
            Finding(
                min(mine.dof, reference.dof), "joints", str(mine.dof), str(reference.dof), text
            ),
        )
    wanted = canonical(reference)
    kinds = [_kind(m, r) for m, r in zip(canonical(mine), wanted, strict=True) if m.kind != r.kind]
    if kinds:
        return tuple(kinds)
    tries = (canonical(mine, signs) for signs in product((1, -1), repeat=open_signs(mine)))
    return min((_compare(steps, wanted) for steps in tries), key=_size)


def _size(findings: tuple[Finding, ...]) -> tuple[int, float]:
    return len(findings), sum(abs(f.mine - f.reference) for f in findings)


def _compare(mine: tuple[Step, ...], reference: tuple[Step, ...]) -> tuple[Finding, ...]:
    pairs = list(zip(mine, reference, strict=True))
    return tuple(
        found
        for k, (m, r) in enumerate(pairs, 1)
        for found in _compare_step(k, m, r, k == len(pairs))
    )


def _compare_step(k: int, mine: Step, reference: Step, last: bool):
    target = "the tip" if last else f"axis {k + 1}"
    if abs(mine.a - reference.a) > _WITHIN:
        yield _length(
            reference.row, "a", f"the distance from axis {k} to {target}", mine.a, reference.a
        )
    if reference.alpha is not None and _turned(mine.alpha, reference.alpha) > _WITHIN:
        yield _angle(
            reference.row,
            "alpha",
            f"the twist from axis {k} to {target}",
            mine.alpha,
            reference.alpha,
        )
    if mine.d is not None and reference.d is not None and abs(mine.d - reference.d) > _WITHIN:
        along = (
            f"axis {k}"
            if len(reference.axes) == 1
            else f"the parallel axes {reference.axes[0]} to {k}, added up,"
        )
        yield _length(reference.row, "d", f"the offset along {along}", mine.d, reference.d)
    if None not in (mine.theta, reference.theta) and _turned(mine.theta, reference.theta) > _WITHIN:
        yield _angle(
            reference.row, "theta", "the constant angle of the slide", mine.theta, reference.theta
        )


def _turned(left: float, right: float) -> float:
    return abs((left - right + math.pi) % (2 * math.pi) - math.pi)


def _length(row: int, quantity: str, what: str, mine: float, reference: float) -> Finding:
    error = f"{1000 * abs(mine - reference):.4g} mm too {'long' if abs(mine) > abs(reference) else 'short'}"
    if mine * reference < 0:
        error = "the sign, against the offsets before it, is wrong"
    text = f"{what} is {abs(mine):.6g} m in yours and {abs(reference):.6g} m in the reference: {error}."
    return Finding(row, quantity, mine, reference, text)


def _angle(row: int, quantity: str, what: str, mine: float, reference: float) -> Finding:
    off = math.degrees(_turned(mine, reference))
    degrees = (
        f"{math.degrees(mine):.6g}° in yours and {math.degrees(reference):.6g}° in the reference"
    )
    return Finding(row, quantity, mine, reference, f"{what} is {degrees}: {off:.4g}° off.")


def _kind(mine: Step, reference: Step) -> Finding:
    text = f"the joint is {mine.kind} in yours and {reference.kind} in the reference."
    return Finding(reference.row, "joint", mine.kind, reference.kind, text)


def _base_note(mine: Arm, reference: Arm) -> tuple[str, ...]:
    error = base_height(mine) - base_height(reference)
    if abs(error) <= _WITHIN:
        return ()
    return (
        f"your base frame stands {1000 * abs(error):.4g} mm {'lower' if error > 0 else 'higher'} on axis 1 than the reference's. "
        "That is a free choice, but positions in the two base frames differ by it.",
    )


# The usual causes, each a change to the rows that would put it right.
_CAUSES: dict[str, Callable[[tuple[Row, ...]], tuple[Row, ...]]] = {
    "the alpha and theta columns are exchanged": lambda rows: tuple(
        replace(row, alpha=row.theta, theta=row.alpha) for row in rows
    ),
    "the angles are in degrees; write radians": lambda rows: tuple(
        replace(row, alpha=f"({row.alpha}) * pi / 180", theta=f"({row.theta}) * pi / 180")
        for row in rows
    ),
    "the lengths are in millimetres; write metres": lambda rows: tuple(
        replace(row, a=f"({row.a}) / 1000", d=f"({row.d}) / 1000") for row in rows
    ),
    "the rows are in the modified (Craig) convention; convert them": standard_from_modified,
}


def _hints(mine: Arm, reference: Arm) -> tuple[str, ...]:
    return tuple(
        f"it would agree if {cause}." if ";" not in cause else f"it looks as if {cause}."
        for cause, mend in _CAUSES.items()
        if not _differences(replace(mine, rows=mend(mine.rows), bodies=()), reference)
    )
