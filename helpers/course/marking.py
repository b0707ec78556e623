"""An answer judged by the checkers, with its credit; and the proof that a sheet can be marked."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers import symbolic
from helpers.arm import Arm
from helpers.checks import (
    Report,
    compare_branches,
    compare_jacobian,
    compare_pose,
    compare_tables,
    compare_torques,
)
from helpers.checks.compare import numbers
from helpers.checks.engine import cause_names
from helpers.inputs import ArmError, number
from helpers.variants import Part, Question, Sheet, topics

Array = NDArray[np.float64]

_MOST = 8000  # characters of a text, or entries of a list: the longest right column has 3473
_LARGEST = 1e6  # beyond any entry of a sheet, were it in millimetres
_COARSE = 0.05  # of the largest right entry: a unit of the last place above it tells nothing
_ANYTHING = re.compile(r"[^\W0_]")  # a letter or a digit but 0


@dataclass(frozen=True)
class Rules:
    """What an answer is worth: right 1; short of digits; a named mistake by its cause; else the
    share of it that is right, times `columns`. Raises ArmError unless all are from 0 to 1.
    """

    digits: float = 0.9
    columns: float = 1.0
    causes: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        every = {"digits": self.digits, "columns": self.columns, **self.causes}
        for name, credit in every.items():
            if number(credit, f"the credit of {name}", "0 to 1", least=0) > 1:
                raise ArmError(f"the credit of {name} is {credit}; expected 0 to 1")


@dataclass(frozen=True)
class Mark:
    """What one part is worth, 0 to 1, the verdict in one sentence, all of its words, and named
    causes.
    """

    part: str
    credit: float
    headline: str
    words: str
    causes: tuple[str, ...] = ()


def mark_sheet(sheet: Sheet, answers: Mapping[str, Any], rules: Rules) -> tuple[Mark, ...]:
    """A mark for every part of a sheet; one that is not answered gets 0."""
    return tuple(mark(sheet, part, answers.get(name), rules) for name, part in sheet.parts.items())


def mark(sheet: Sheet, part: Part, answer: Any, rules: Rules) -> Mark:
    """One answer judged. Nothing is raised for what stands in an answer: what cannot be read gets
    0, and so do blanks, dots and zeros alone, which need no work.
    """
    text = list(_texts(answer))
    if sum(map(len, text)) > _MOST or len(text) > _MOST:
        return _none(part, f"Not read: it has more than {_MOST} entries or characters.")
    if not any(map(_ANYTHING.search, text)):
        return _none(part, "Not answered.")
    question = next(q for q in sheet.questions if part in q.parts)
    try:
        return _judged(question, part, answer, rules)
    except ArmError as error:
        return _none(part, f"Not read: {error}")
    except Exception as error:  # whatever breaks a reader, it costs its own part only
        words = f"Not read ({type(error).__name__}): write numbers or formulas as on the sheet."
        return _none(part, words)


def _none(part: Part, words: str) -> Mark:
    return Mark(part.name, 0.0, words, words)


def _texts(answer: Any, depth: int = 0) -> Iterator[str]:
    """What there is to read, entry by entry; lists nested deeper than any matrix are too much."""
    if isinstance(answer, Mapping):
        answer = list(answer.values())
    if not isinstance(answer, list | tuple):
        yield "" if answer is None else str(answer)
    elif depth > 4:
        yield "x" * (_MOST + 1)
    else:
        for entry in answer:
            yield from _texts(entry, depth + 1)


def _judged(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    """By the checker with the tolerance that the sheet promises, and where that does not agree by
    the digits given, a named cause, or the share that is right.
    """
    if part.kind == "column":
        return _column(question, part, answer)
    typed = None if part.kind == "table" else _typed(answer, part)
    near = _report(question, part, answer, part.tolerance)
    if near.agrees:
        return _within_limits(question, part, typed, Mark(part.name, 1.0, near.headline, str(near)))
    exact = _report(question, part, answer)
    share, fine = (0.0, True) if typed is None else _share(question, part, typed)
    known = [
        rules.causes[key] for cause in exact.causes for key in _keys(cause) if key in rules.causes
    ]
    credit = max([rules.columns * share, *known[:1]])
    if exact.grade != "wrong" and fine and (part.kind != "branches" or share == 1):
        credit = rules.digits  # right to the digits given, which are fewer than the sheet asks
    found = Mark(part.name, credit, exact.headline, str(exact), exact.causes)
    return found if exact.causes else _within_limits(question, part, typed, found)


def _keys(cause: str) -> Iterator[str]:
    """The names by which the rules may speak of a cause: whole, and without its fields."""
    yield cause
    yield " + ".join(part.split(":")[0] for part in cause.split(" + "))


def known_causes() -> set[str]:
    """The names of mistakes that the checkers and this module can find."""
    own = {cause for cause, _, _ in _usual(np.eye(2))}
    return own | cause_names()


def _typed(answer: Any, part: Part) -> Any:
    """The values and the units of their last places; None for formulas. Raises ArmError for
    numbers that nothing on a sheet can have.
    """
    try:
        typed = numbers(answer, f"`{part.name}`")
    except ArmError:
        return None
    if (np.abs(typed.values) > _LARGEST).any():
        raise ArmError(f"`{part.name}` holds {np.abs(typed.values).max():g}; no answer is so large")
    return typed


def _share(question: Question, part: Part, typed: Any) -> tuple[float, bool]:
    """How much is right by itself, 0 to 1: columns of a Jacobian, torques that are not 0, branches;
    and whether the digits given are enough to tell anything.
    """
    right = np.asarray(part.value, dtype=float)
    size = np.abs(right).max() if part.kind != "pose" else np.pi
    fine = not (typed.units > _COARSE * size).any()
    if part.kind == "branches":
        return _found(question.arm, part, typed), fine
    if part.kind not in ("jacobian", "torques") or typed.values.size != right.size:
        return 0.0, fine
    mine, units = typed.values.reshape(right.shape), typed.units.reshape(right.shape)
    told = units <= _COARSE * np.abs(right)
    good = np.abs(mine - right) <= np.maximum(part.tolerance, 0.51 * units * told)
    counts = np.abs(right) > part.tolerance
    return float(good.all(axis=0).mean() if right.ndim == 2 else good[counts].mean()), fine


def _found(arm: Arm, part: Part, typed: Any) -> float:
    """The branches that were found, whole turns aside, among them or the answers, if those are
    more.
    """
    if typed.values.size % arm.dof:
        return 0.0
    rows, units = (x.reshape(-1, 1, arm.dof) for x in (typed.values, typed.units))
    off = rows - part.value
    off = np.where(arm.turning, (off + np.pi) % (2 * np.pi) - np.pi, off)
    hit = (np.abs(off) <= np.maximum(part.tolerance, np.minimum(0.51 * units, _COARSE))).all(axis=2)
    return float(hit.any(axis=0).sum() / max(hit.shape))


def _within_limits(question: Question, part: Part, typed: Any, found: Mark) -> Mark:
    """The mark, or none where joint values that would count lie beyond the limits."""
    arm = question.arm
    if part.kind not in ("branches", "pose") or not found.credit or typed.values.size % arm.dof:
        return found
    q, (low, high) = typed.values.reshape(-1, arm.dof), arm.limits
    turned = q + 2 * np.pi * np.arange(-3, 4)[:, None, None] * arm.turning
    near = (turned >= low - part.tolerance) & (turned <= high + part.tolerance)
    for k, i in np.argwhere(~near.any(axis=0))[:1]:
        words = f"{arm.variables[i]} = {q[k, i]:.4g} lies beyond its limits"
        return _none(part, f"{words}, {low[i]:g} to {high[i]:g}.")
    return found


# Each kind of part and its checker


def _report(question: Question, part: Part, answer: Any, tolerance: float | None = None) -> Report:
    given, arm = question.given, question.arm
    if part.kind == "numbers":
        return _numbers(part, answer, tolerance)
    if part.kind == "table":
        mine = _with_kinds(answer, part.value)
        return compare_tables(mine, part.value, tolerance=tolerance)
    if part.kind == "jacobian":
        return compare_jacobian(answer, arm, given["q"], tolerance=tolerance)
    if part.kind == "torques":
        wrench = np.r_[given["force"] if part.name == "tau" else [0, 0, 0], 0, 0, 0]
        return compare_torques(answer, arm, given["q"], wrench, tolerance=tolerance)
    target = topics.pose_of(np.array(given["target"]))
    if part.kind == "pose":
        return compare_pose(answer, arm, target, tolerance=tolerance)
    known = topics.closed_form(arm)(arm, target)  # type: ignore[misc]  # there is one
    asked = replace(known, valid=known.within_limits)
    return compare_branches(answer, asked, tolerance=tolerance)


def _with_kinds(answer: Any, drawn: Arm) -> Any:
    """Rows of four entries become an arm whose joints turn or slide as the sheet says."""
    try:
        rows = [
            replace(row, **dict(zip(("a", "alpha", "d", "theta"), given, strict=True)))
            for row, given in zip(drawn.rows, answer, strict=True)
        ]
        return Arm("the answer", tuple(rows))
    except (ArmError, TypeError, ValueError):
        return answer


def _column(question: Question, part: Part, answer: Any) -> Mark:
    """Six formulas, judged as that column of an otherwise right Jacobian at a generic pose."""
    if not (isinstance(answer, list) and len(answer) == 6):
        return _none(part, "Expected a list of six formulas.")
    column, arm = int(question.given["column"]) - 1, question.arm
    J = [[str(entry) for entry in row] for row in symbolic.jacobian(arm).tolist()]
    for row, formula in zip(J, answer, strict=True):
        (row[column],) = formula if isinstance(formula, list) else (str(formula),)
    report = compare_jacobian(J, arm)
    return Mark(part.name, float(report.agrees), report.headline, str(report), report.causes)


def _numbers(part: Part, answer: Any, tolerance: float | None) -> Report:
    """Numbers that no checker knows, such as a place: right, short of digits, or a usual
    mistake.
    """
    typed, right = numbers(answer, f"`{part.name}`"), np.asarray(part.value, dtype=float)
    if typed.values.size != right.size:
        shapes = f"It has shape {typed.values.shape}; expected {right.shape}."
        return Report("numbers", part.name, "wrong", shapes)
    mine, units = typed.values.reshape(right.shape), typed.units.reshape(right.shape)
    off = np.abs(mine - right)
    if tolerance is not None and (off <= tolerance).all():
        return Report("numbers", part.name, "right", "Right.")
    far = off > np.maximum(part.tolerance, 0.51 * np.minimum(units, _COARSE * np.abs(right).max()))
    if not far.any():
        return Report("numbers", part.name, "so far", "Right as far as it goes: give more digits.")
    for cause, sentence, meant in _usual(mine):
        if (np.abs(meant - right) <= np.maximum(part.tolerance, np.abs(right) * 1e-3)).all():
            return Report("numbers", part.name, "wrong", sentence, causes=(cause,))
    words = f"Not right: {far.sum()} of {right.size} entries are off, by up to {off.max():.3g}."
    return Report("numbers", part.name, "wrong", words)


def _usual(mine: Array) -> Iterator[tuple[str, str, Array]]:
    """Mistakes that any list of numbers, or square matrix, may hold: its name, what is said, and
    the numbers with it undone.
    """
    yield "numbers.millimetres", "Right in millimetres; metres were asked.", mine / 1000
    yield "numbers.degrees", "Right in degrees; radians were asked.", np.radians(mine)
    yield "numbers.sign", "Every sign is the other way round.", -mine
    if mine.shape == mine.T.shape:
        yield "numbers.transposed", "It is the transpose of what was asked.", mine.T
