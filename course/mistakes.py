"""List the wrong answers that usual mistakes give.

The judge has the list (judge/causes), so that marks and messages come from one place.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks.arms import judge_data
from helpers.checks.engine import ask_judge

Array = NDArray[np.float64]

MILLIMETRES = "The lengths are in millimetres: use metres"
DEGREES = "The angles are in degrees: use radians"
OTHER_SIDE = "The path is drawn on the other side of its start: check the sign of the velocity"
BACKWARDS = "The path is drawn in the opposite direction: check the sign of the velocity"
_ROUND_OFF = 1e-9  # smaller differences from the right answer are round-off


class Mistake(NamedTuple):
    """A usual mistake.

    Attributes:
        name: Key in the judge's catalogue, such as "table.sign:d:2".
        message: Sentence to the student, without a full stop.
        values: What it makes of the right answer, in the same shape.
    """

    name: str
    message: str
    values: Array


def list_mistakes(
    kind: str,
    arm: Arm,
    *,
    q: ArrayLike = (),
    configurations: ArrayLike = (),
    wrench: ArrayLike = (),
) -> list[Mistake]:
    """List the mistakes in a question of some kind.

    Args:
        kind: "tip" (position, then rotation row by row: 12 numbers), "jacobian" (6 x dof) or
            "torques" (dof).
        arm: The arm of the question.
        q: Joint values, shape (dof,).
        configurations: Several of them, shape (k, dof), in place of `q`; each mistake then has k
            answers.
        wrench: Force and moment on the tip, shape (6,), for torques.
    """
    question: dict[str, Any] = {"kind": kind, "arm": judge_data(arm)}
    for name, value in (("q", q), ("configurations", configurations), ("wrench", wrench)):
        if np.size(value):
            question[name] = np.asarray(value, dtype=float).tolist()
    answers = ask_judge("mistakes", **question)
    return [
        Mistake(answer["name"], answer["message"], np.array(answer["values"], dtype=float))
        for answer in answers
        if None not in answer["values"]  # this mistake gives no number
    ]


def list_other_units(right: Array, lengths: ArrayLike) -> list[Mistake]:
    """List a right answer in millimetres and in degrees, if it contains lengths or angles.

    Args:
        right: Right answer in metres, radians and units of them.
        lengths: Which numbers count a length; the others are angles. Broadcasts to `right`.
    """
    is_length = np.broadcast_to(np.asarray(lengths, dtype=bool), right.shape)
    units = [
        ("course.millimetres", MILLIMETRES, np.where(is_length, 1000.0, 1.0)),
        ("course.degrees", DEGREES, np.where(is_length, 1.0, 180 / np.pi)),
    ]
    return [Mistake(name, text, right * x) for name, text, x in units if (x != 1).any()]


def select_visible(mistakes: list[Mistake], right: Array) -> tuple[Mistake, ...]:
    """Return the mistakes that change the right answer, reshaped like it."""
    shaped = [m._replace(values=m.values.reshape(right.shape)) for m in mistakes]
    return tuple(m for m in shaped if np.abs(m.values - right).max() > _ROUND_OFF)
