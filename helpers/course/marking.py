"""An answer judged by the checkers, with its credit."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers import checks, symbolic
from helpers.checks.compare import Typed, numbers
from helpers.inputs import ArmError
from helpers.variants import Part, Question, Sheet, topics

Array = NDArray[np.float64]

_FEW_DIGITS = 0.9  # the credit of an answer that is right as far as its digits go
_MOST = 8000  # characters: the longest right column has 3473
_COARSE = 0.05  # of the largest right entry: a finest last place above it tells nothing
_ANYTHING = re.compile(r"[^\W0_]")  # a letter or a digit but 0


@dataclass(frozen=True)
class Mark:
    """What a part is worth, 0 to 1, the verdict in one sentence, all of its words, and causes."""

    part: str
    credit: float
    headline: str
    words: str
    causes: tuple[str, ...] = ()


def mark_sheet(sheet: Sheet, answers: Mapping[str, Any]) -> tuple[Mark, ...]:
    """A mark for every part of a sheet; one that is not answered gets 0."""
    return tuple(mark(sheet, name, answers.get(name)) for name in sheet.parts)


def mark(sheet: Sheet, name: str, answer: Any) -> Mark:
    """One answer judged. Nothing is raised for what stands in an answer: what cannot be read gets
    0, and so do blanks, dots and zeros alone, which need no work.
    """
    if isinstance(answer, Mapping):
        answer = list(answer.values())
    part = sheet.parts[name]
    question = next(q for q in sheet.questions if part in q.parts)
    judged = {"column": _column, "numbers": _numbers}.get(part.kind, _compared)
    try:
        text = str(answer)
        if len(text) > _MOST:
            return _none(name, f"Not read: it has more than {_MOST} characters.")
        if not _ANYTHING.search(text.replace("None", "")):
            return _none(name, "Not answered.")
        return judged(question, part, answer)
    except ArmError as error:
        return _none(name, f"Not read: {error}")
    except Exception as error:  # whatever breaks a reader, it costs its own part only
        words = f"Not read ({type(error).__name__}): write numbers or formulas as on the sheet."
        return _none(name, words)


def _none(name: str, words: str) -> Mark:
    return Mark(name, 0.0, words, words)


# Tables, Jacobians, torques, branches and poses: the book's own checkers


def _compared(question: Question, part: Part, answer: Any) -> Mark:
    """By the tolerance of the sheet, else by the digits given or the share that is right."""
    report = _report(question, part, answer, part.tolerance)
    credit = 1.0
    if not report.agrees:
        typed = _typed(part, answer)
        credit = _share(part, typed, report)
        report = _report(question, part, answer, None)
        fine = typed is None or typed.units.min() <= _COARSE * np.abs(part.value).max()
        if report.grade != "wrong" and fine and (part.kind != "branches" or credit == 1):
            credit = _FEW_DIGITS
    causes = () if credit == 1 else report.causes
    return Mark(part.name, credit, report.headline, str(report), causes)


def _report(question: Question, part: Part, answer: Any, tolerance: float | None) -> checks.Report:
    given, arm = question.given, question.arm
    if part.kind == "table":
        return checks.compare_tables(
            answer, part.value, columns="a alpha d theta", lengths="m", angles="rad",
            convention="standard", tolerance=tolerance,
        )  # fmt: skip
    if part.kind == "jacobian":
        return checks.compare_jacobian(answer, arm, given["q"], tolerance=tolerance)
    if part.kind == "torques":
        wrench = np.r_[given["force"] if part.name == "tau" else [0, 0, 0], 0, 0, 0]
        return checks.compare_torques(answer, arm, given["q"], wrench, tolerance=tolerance)
    target = topics.pose_of(np.array(given["target"]))
    if part.kind == "pose":
        return checks.compare_pose(answer, arm, target, tolerance=tolerance)
    known = topics.closed_form(arm)(arm, target)  # type: ignore[misc]  # there is one
    asked = replace(known, valid=known.within_limits)
    return checks.compare_branches(answer, asked, tolerance=tolerance)


def _typed(part: Part, answer: Any) -> Typed | None:
    """The numbers and the units of their last places; None for formulas and tables."""
    try:
        return None if part.kind == "table" else numbers(answer, part.name)
    except ArmError:
        return None


def _share(part: Part, typed: Typed | None, report: checks.Report) -> float:
    """How much is right by itself, 0 to 1: columns of a Jacobian, torques but zeros, branches."""
    if part.kind == "jacobian" and typed and typed.values.size == part.value.size:
        off = np.abs(typed.values.reshape(part.value.shape) - part.value)
        return float((off <= part.tolerance).all(axis=0).mean())
    if "of" not in report.figures:
        return 0.0
    right, every = report.figures["right"], report.figures["of"]
    if part.kind == "torques":
        counting = np.abs(part.value) > part.tolerance
        return max(0.0, 1 - (every - right) / counting.sum())
    return right / max(every, right + report.figures["wrong"])


def _column(question: Question, part: Part, answer: Any) -> Mark:
    """Six formulas, judged as that column of an otherwise right Jacobian at a generic pose."""
    if not (isinstance(answer, list) and len(answer) == 6):
        return _none(part.name, "Expected a list of six formulas.")
    column, arm = int(question.given["column"]) - 1, question.arm
    J = [[str(entry) for entry in row] for row in symbolic.jacobian(arm).tolist()]
    for row, formula in zip(J, answer, strict=True):
        (row[column],) = formula if isinstance(formula, list) else (str(formula),)
    report = checks.compare_jacobian(J, arm)
    return Mark(part.name, float(report.agrees), report.headline, str(report), report.causes)


def _numbers(_: Question, part: Part, answer: Any) -> Mark:
    """Numbers such as a place: right, short of digits, or a usual mistake."""
    typed, right = numbers(answer, f"`{part.name}`"), np.asarray(part.value, dtype=float)
    if typed.values.size != right.size:
        return _none(part.name, f"It has shape {typed.values.shape}; expected {right.shape}.")
    mine, units = typed.values.reshape(right.shape), typed.units.reshape(right.shape)
    off = np.abs(mine - right)
    if (off <= part.tolerance).all():
        return Mark(part.name, 1.0, "Right.", "Right.")
    far = off > np.maximum(part.tolerance, 0.51 * np.minimum(units, _COARSE * np.abs(right).max()))
    if not far.any():
        words = "Right as far as it goes: give more digits."
        return Mark(part.name, _FEW_DIGITS, words, words)
    for cause, words, meant in _usual(mine):
        if (np.abs(meant - right) <= np.maximum(part.tolerance, np.abs(right) * 1e-3)).all():
            return Mark(part.name, 0.0, words, words, (cause,))
    words = f"Not right: {far.sum()} of {right.size} entries are off, by up to {off.max():.3g}."
    return _none(part.name, words)


def _usual(mine: Array) -> Iterator[tuple[str, str, Array]]:
    """Mistakes in any numbers: the name, what is said, and the numbers with it undone."""
    yield "numbers.millimetres", "Right in millimetres; metres were asked.", mine / 1000
    yield "numbers.degrees", "Right in degrees; radians were asked.", np.radians(mine)
    yield "numbers.sign", "Every sign is the other way round.", -mine
    if mine.shape == mine.T.shape:
        yield "numbers.transposed", "It is the transpose of what was asked.", mine.T
