"""Is my table wrong, or only different?"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import chain, product

import numpy as np

from helpers.arm import Arm, Row
from helpers.checks.axes import Gap, gaps, tool_tilt
from helpers.checks.differences import (
    WITHIN_ANGLE,
    WITHIN_LENGTH,
    Finding,
    angle_between,
    arc,
    by_signs,
)
from helpers.checks.verdict import Verdict
from helpers.conventions import standard_from_modified
from helpers.expressions import Entry
from helpers.inputs import ArmError, shown
from helpers.kinematics import forward_kinematics

_RIGHT_ANGLES = {-2: "-pi", -1: "-pi/2", 0: "0", 1: "pi/2", 2: "pi"}


@dataclass(frozen=True, repr=False)
class TableReport(Verdict):
    """What `compare_tables` found; `notes` are differences that are free choices, or a hint at the
    cause."""

    mine: str
    reference: str
    findings: tuple[Finding, ...]
    notes: tuple[str, ...] = ()

    def __str__(self) -> str:
        verdict = "describes the same arm as" if self.agrees else "is another arm than"
        lines = [*map(str, self.findings), *(f"Note: {note}" for note in self.notes)]
        head = f"{self.mine} {verdict} {self.reference}."
        return "\n".join([head, *(f"- {line}" for line in lines)])


def compare_tables(mine: Arm, reference: Arm) -> TableReport:
    """Whether two standard DH tables describe the same arm, and if not, where they differ.

    Compared is what no choice of frames can change: the kind of each joint, distance and twist
    between neighbouring axes, the offset along each axis (along parallel axes only the sum), and
    where the tip is on the last link, lengths to within 1e-6 m and angles to within 1e-4 rad. Free
    are the directions of the axes, the places of common normals between parallel axes, the zeros of
    the joints, the place of a sliding axis and the number of fixed rows. Other zeros or directions
    of the joints, another height of the base frame on axis 1 and another tilt of the tool's frame
    are notes. Rows are counted in `mine`.

    Raises ArmError where an arm has no joint. Source: Siciliano et al., Robotics, section 2.8.2, on
    the free choices.
    """
    for arm in (mine, reference):
        if not isinstance(arm, Arm) or not arm.dof:
            raise ArmError(f"cannot compare {shown(arm)}; expected an Arm with one joint or more")
    findings, notes = _compared(_squared(mine), _squared(reference))
    more = _hints(mine, reference) or notes if findings else (*notes, *_zeros_note(mine, reference))
    return TableReport(mine.name, reference.name, findings, (*more, *_rounded(mine)))


def _squared(arm: Arm) -> Arm:
    """The arm with angles near a multiple of a right angle taken as that: 1.5708 is meant as
    pi/2."""
    rows = [replace(r, alpha=_square(arm, r.alpha), theta=_square(arm, r.theta)) for r in arm.rows]
    return replace(arm, rows=rows)


def _square(arm: Arm, angle: Entry) -> Entry:
    turns = arm.number(angle) / (math.pi / 2)
    near = abs(turns - round(turns)) * math.pi / 2 < WITHIN_ANGLE
    return _RIGHT_ANGLES.get(round(turns), f"{round(turns)} * pi / 2") if near else angle


def _compared(mine: Arm, reference: Arm) -> tuple[tuple[Finding, ...], tuple[str, ...]]:
    """Findings and notes for the directions of the reference's axes that make them fewest and
    smallest."""
    unlike = tuple(_unlike_joints(mine, reference))
    if unlike:
        return unlike, ()
    ours, theirs, tilts = gaps(mine), gaps(reference), (tool_tilt(mine), tool_tilt(reference))
    local = [by_signs(mine, m, r) for m, r in zip(ours, theirs, strict=True)]
    tries = (
        (
            _at(ours, local, signs),
            (*_tool_note(*tilts, signs), *_base_note(mine, ours, theirs, signs)),
        )
        for signs in product((1, -1), repeat=mine.dof)
    )
    return min(tries, key=_size)


def _at(walk: list[Gap], local: list[dict], signs: tuple[int, ...]) -> tuple[Finding, ...]:
    chosen = (tuple(signs[k] for k in gap.joints) for gap in walk)
    return tuple(chain(*(found[signs] for found, signs in zip(local, chosen, strict=True))))


def _size(found: tuple[tuple[Finding, ...], tuple[str, ...]]) -> tuple[int, float, int]:
    findings, notes = found
    return len(findings), round(sum(abs(f.mine - f.reference) for f in findings), 9), len(notes)


def _unlike_joints(mine: Arm, reference: Arm) -> Iterator[Finding]:
    if mine.dof != reference.dof:
        text = f"yours has {mine.dof}, the reference {reference.dof}."
        row = mine.joints[min(mine.dof, reference.dof) - 1]
        yield Finding(row, "number of joints", mine.dof, reference.dof, text)
        return
    for i, j in zip(mine.joints, reference.joints, strict=True):
        kind, wanted = mine.rows[i - 1].joint.kind, reference.rows[j - 1].joint.kind
        if kind != wanted:
            text = f"the joint is {kind} in yours and {wanted} in the reference."
            yield Finding(i, "joint", kind, wanted, text)


def _tool_note(mine: float, reference: float, signs: tuple[int, ...]) -> Iterator[str]:
    m, r = arc(mine), arc(signs[-1] * reference)
    if angle_between(m, r) > WITHIN_ANGLE:
        yield (
            f"the last frame's z axis stands at {math.degrees(m):.4g}° to the last joint axis in"
            " yours"
            f" and at {math.degrees(r):.4g}° in the reference. The tip's place does not depend on"
            " it,"
            " the tool's orientation does."
        )


def _zeros_note(mine: Arm, reference: Arm) -> Iterator[str]:
    """Says so if the same q means another pose: then the tips' distance changes from one q to the
    next."""
    q = np.outer([0, 0.3, 0.7], np.arange(1, mine.dof + 1))
    tips, wanted = (forward_kinematics(_squared(arm), q)[:, :3, 3] for arm in (mine, reference))
    if np.ptp(tips - wanted, axis=0).max() > WITHIN_LENGTH:
        yield (
            "the same q is another pose: some of your joints count from another zero, or the"
            " other way."
        )


def _base_note(
    arm: Arm, mine: list[Gap], reference: list[Gap], signs: tuple[int, ...]
) -> Iterator[str]:
    m, r = (next((gap for gap in walk if gap.places_base), None) for walk in (mine, reference))
    if m is None or r is None or m.bunch != r.bunch:
        return
    higher = signs[m.bunch[-1]] * r.offset - m.offset
    if abs(higher) > WITHIN_LENGTH:
        yield (
            f"your base frame stands {1000 * abs(higher):.4g} mm"
            f" {'higher' if higher > 0 else 'lower'} on"
            f" axis 1 (d in row {arm.joints[m.bunch[-1]]}) than the reference's. That is a free"
            " choice, but"
            " positions in the two base frames differ by it."
        )


def _rounded(arm: Arm) -> tuple[str, ...]:
    """A word on each angle that was taken as a multiple of a right angle though it is not quite
    one."""
    entries = [
        (i, n, getattr(row, n)) for i, row in enumerate(arm.rows, 1) for n in ("alpha", "theta")
    ]
    return tuple(
        f"{name} in row {i}, {arm.number(angle):g}, is taken as {_square(arm, angle)}; write it so."
        for i, name, angle in entries
        if angle_between(arm.number(angle), arm.number(_square(arm, angle))) > 1e-9
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
        f"it looks as if {cause}."
        for cause, mend in _CAUSES.items()
        if _agree(replace(mine, rows=mend(mine.rows), bodies=()), reference)
    )


def _agree(mine: Arm, reference: Arm) -> bool:
    return not _compared(_squared(mine), _squared(reference))[0]
