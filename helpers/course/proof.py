"""The proof that a sheet can be marked, before it is given out."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm, Body
from helpers.course.marking import Rules, mark
from helpers.inputs import ArmError
from helpers.kinematics import jacobian
from helpers.statics import gravity_torque, static_torque
from helpers.variants import Part, Question, Sheet

Array = NDArray[np.float64]


def prove(sheet: Sheet) -> None:
    """Show that right work at four decimals gets all, and that each slip which a generic pose
    would show is farther off than the tolerance forgives.

    Raises ArmError that names the part and what it cannot tell apart.
    """
    for name, part in sheet.parts.items():
        found = mark(sheet, part, rounded(part), Rules())
        if found.credit != 1:
            raise ArmError(f"`{name}` cannot be marked: its own key is judged {found.headline!r}")
    for question in sheet.questions:
        for part in question.parts:
            if hidden := sorted(unseen(question, part) - unseen(_generic(question), part)):
                words = f"`{part.name}` cannot be marked: it does not show {', '.join(hidden)}"
                raise ArmError(words)


def rounded(part: Part) -> Any:
    """A part of the key as a student would write it: four decimals, a table's rows, formulas."""
    if isinstance(part.value, Arm):
        return [[str(entry) for entry in row.entries] for row in part.value.rows]
    return part.value if part.kind == "column" else np.round(part.value, 4).tolist()


def unseen(question: Question, part: Part) -> set[str]:
    """The single slips that a part's tolerance would forgive."""
    if part.kind not in ("jacobian", "torques"):
        return set()
    arm, q, answer = question.arm, np.array(question.given["q"]), _answer(question, part)
    right = answer(arm, q)
    made = {name: answer(other, q) for name, other in _slips(arm)}
    made |= {"angles in degrees": answer(arm, np.where(arm.turning, np.degrees(q), q))}
    made |= {"all signs": -right, "halves exchanged": np.roll(right, 3, axis=0)}
    return {name for name, wrong in made.items() if np.abs(wrong - right).max() <= part.tolerance}


def _answer(question: Question, part: Part) -> Callable[[Arm, Array], Array]:
    """What one answers who believes in an arm and its joint values."""
    if part.kind == "jacobian":
        return jacobian
    if part.name == "g":
        return gravity_torque
    wrench = np.r_[question.given["force"], 0, 0, 0]
    return lambda arm, q: static_torque(arm, q, wrench)


def _slips(arm: Arm) -> Iterator[tuple[str, Arm]]:
    """The arm with one entry of its table left out or with the other sign, or without a mass."""
    for i, row in enumerate(arm.rows, 1):
        for name in ("a", "alpha", "d", "theta"):
            if value := arm.number(getattr(row, name)):
                yield f"no {name}_{i}", arm.with_row(i, **{name: 0})
                yield f"the sign of {name}_{i}", arm.with_row(i, **{name: -value})
    for i, body in enumerate(arm.bodies):
        bodies = [*arm.bodies[:i], Body(0, body.com), *arm.bodies[i + 1 :]]
        yield f"no mass of link {i + 1}", arm.with_bodies(bodies)


def _generic(question: Question) -> Question:
    """The same question at joint values that have nothing special: what it hides, every pose
    hides.
    """
    q = question.given.get("q", [])
    here = [0.37 + 0.23 * i for i in range(len(q))]
    return replace(question, given={**question.given, "q": here})
