"""What an answer is worth, and why.

Numbers are measured against the right ones and against what every known slip makes of them. Let u
be the unit of the last place asked, or of the last place given where that is coarser. An answer
within u of some of them is worth what the worst of these is worth; one within u of none, the share
of its numbers that are right. What a slip is worth is that share too. So the right numbers, in the
decimals asked, are worth 1, since these tell them from every slip; and a slip that is rounded more
coarsely stays within u of itself, and is worth no more than before.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course import topics
from course.sheets import Part, Question, Sheet
from helpers import checks, symbolic
from helpers.checks.compare import TypedNumbers, read_numbers
from helpers.inputs import ArmError

Array = NDArray[np.float64]

_MOST = 8000  # characters: the longest right column has 3473
_ROUNDING = 1 + 1e-9
_NO_WORK = "Not answered."
# What the checkers say of their options, which nobody can set on a sheet.
_HINT = re.compile(r"(\n- | )If that is what you mean, say .*")
_BLANK = (None, "", "...", ".", "-")


@dataclass(frozen=True)
class Mark:
    """What a part is worth, 0 to 1, and why, in sentences to the student."""

    part: str
    credit: float
    words: str


def mark_sheet(sheet: Sheet, answers: Mapping[str, Any]) -> tuple[Mark, ...]:
    """A mark for every part of a sheet; one that is not answered gets 0."""
    return tuple(mark(sheet, name, answers.get(name)) for name in sheet.parts)


def mark(sheet: Sheet, name: str, answer: Any) -> Mark:
    """One answer judged. Nothing is raised for what stands in it: what cannot be read gets 0."""
    part = sheet.parts[name]
    question = next(q for q in sheet.questions if part in q.parts)
    judged = _JUDGED.get(part.kind, _numbers)
    try:
        filled = _filled(answer)
        if len(str(filled)) > _MOST:
            return Mark(name, 0.0, f"Not read: it has more than {_MOST} characters.")
        if not any(c.isalnum() and c != "0" for c in str(filled)):
            return Mark(name, 0.0, _NO_WORK)
        credit, words = judged(question, part, filled)
        return Mark(name, credit, _HINT.sub("", words))
    except ArmError as error:
        return Mark(name, 0.0, _HINT.sub("", f"Not read: {error}"))
    except Exception as error:  # whatever breaks a reader, it costs its own part only
        words = f"Not read ({type(error).__name__}): write numbers or formulas as on the sheet."
        return Mark(name, 0.0, words)


def _filled(answer: Any) -> Any:
    """The answer with 0 for each entry that was left blank, and no names of entries."""
    if isinstance(answer, Mapping):
        answer = list(answer.values())
    if isinstance(answer, list):
        return [_filled(entry) for entry in answer]
    return 0 if answer in _BLANK or answer != answer else answer


# Numbers


def _numbers(question: Question, part: Part, answer: Any) -> tuple[float, str]:
    right = np.asarray(part.value, dtype=float)
    typed = _shaped(read_numbers(answer, f"`{part.name}`"), right, part)
    mine, unit = typed.values, max(part.unit, typed.units.min()) * _ROUNDING
    alike = [
        (_share(part, wrong), words)
        for words, wrong in part.slips
        if np.abs(mine - wrong).max() <= unit
    ]
    fits = np.abs(mine - right).max() <= unit
    if fits and not alike:
        return 1.0, "Right."
    if fits:
        worth, slip = min(alike)
        words = (
            f"Right to the decimals that you gave, but {part.digits} were asked. In so few, a usual"
        )
        return (
            worth,
            f"{words} mistake looks the same ({slip}); this earns what that does, {worth:.2g}.",
        )
    causes = sorted({slip for _, slip in alike})
    named = [f"These are the numbers of a usual mistake: {'; or '.join(causes)}."] if causes else []
    credit = min(alike)[0] if alike else _share(part, mine)
    return credit, "\n".join([*named, *_where(question, part, typed, answer)])


def _shaped(typed: TypedNumbers, right: Array, part: Part) -> TypedNumbers:
    """The answer in the shape of the right one; half a Jacobian with zeros for the other half.

    Raises ArmError where it has another number of entries.
    """
    mine, units = typed.values, typed.units
    if mine.size == right.size:
        return TypedNumbers(mine.reshape(right.shape), units.reshape(right.shape))
    if part.kind == "jacobian" and mine.shape == (3, right.shape[1]):
        zeros = np.zeros_like(mine)
        halves = (np.r_[mine, zeros], np.r_[zeros, mine])
        return TypedNumbers(max(halves, key=lambda half: _share(part, half)), np.r_[units, units])
    given, wanted = (" × ".join(map(str, x.shape)) or "one" for x in (mine, right))
    words = f"{given} numbers given, expected {wanted}; write 0 for what you do not have"
    raise ArmError(words)


def _blocks(part: Part, x: Array) -> Array:
    """What counts by itself, one row each: halves of columns, columns, or numbers."""
    if part.kind == "jacobian":
        return x.reshape(2, 3, -1).transpose(2, 0, 1).reshape(-1, 3)
    return x.T if part.kind == "rotation" else x.reshape(-1, 1)


def _wrong(part: Part, mine: Array) -> NDArray[np.bool_]:
    return np.abs(_blocks(part, mine - part.value)).max(axis=1) > part.unit * _ROUNDING


def _share(part: Part, mine: Array) -> float:
    """How much is right, 0 to 1. What is right without any work costs where it is wrong, and earns
    nothing."""
    counting = np.abs(_blocks(part, part.value - part.idle)).max(axis=1) > part.unit
    return float(max(0.0, 1 - _wrong(part, mine).sum() / counting.sum()))


def _where(question: Question, part: Part, typed: TypedNumbers, answer: Any) -> list[str]:
    """Which blocks are not right, as the student would point at them, and why if that is known."""
    own = np.maximum(part.unit, typed.units) * _ROUNDING
    surely = _blocks(part, np.abs(typed.values - part.value) - own).max(axis=1) > 0
    wrong = _wrong(part, typed.values)
    coarse = f"Too few decimals, {part.digits} were asked"
    told = [("Not right", surely), (coarse, wrong & ~surely)]
    lines = [f"{words}: {_places(part, found)}." for words, found in told if found.any()]
    return [*lines, *(_judged(question, part, answer) if surely.any() else [])]


def _places(part: Part, found: NDArray[np.bool_]) -> str:
    """Blocks in words, such as "the linear half of columns 1, 3"."""
    if part.kind != "jacobian":
        return _counted("column" if part.kind == "rotation" else "number", found)
    halves = zip(("linear", "angular"), found.reshape(-1, 2).T, strict=True)
    return "; ".join(f"the {half} half of {_counted('column', c)}" for half, c in halves if c.any())


def _counted(noun: str, found: NDArray[np.bool_]) -> str:
    places = [str(n + 1) for n in np.flatnonzero(found)]
    return f"{noun}{'s' * (len(places) > 1)} {', '.join(places)}"


def _judged(question: Question, part: Part, answer: Any) -> list[str]:
    """What the book's own checker says of a Jacobian or torques."""
    given = question.given
    if part.kind == "jacobian":
        return str(checks.compare_jacobian(answer, question.arm, given["q"])).splitlines()
    if part.kind == "torques":
        wrench = np.r_[given["force"] if part.name == "tau" else [0, 0, 0], 0, 0, 0]
        return str(checks.compare_torques(answer, question.arm, given["q"], wrench)).splitlines()
    return []


# What has no one right value: tables, formulas, joint values


def _table(_: Question, part: Part, answer: Any) -> tuple[float, str]:
    """Every choice of frames is right. Otherwise, where the checker names the slips, the rows
    without one count."""
    report = checks.compare_tables(
        answer, part.value, columns="a alpha d theta", lengths="m", angles="rad",
        convention="standard",
    )  # fmt: skip
    if report.grade == "so far":  # the rows of the last joints are missing
        return report.figures["right"] / report.figures["of"], str(report)
    if report.grade != "wrong":
        return 1.0, str(report)
    named = report.causes[0].split(" + ") if report.causes else []
    rows = {cause.rpartition(":")[2] for cause in named}  # such as table.sign:d:1
    told = rows and all(row.isdecimal() for row in rows)
    return (1 - len(rows) / len(part.value.rows) if told else 0.0), str(report)


def _column(question: Question, part: Part, answer: Any) -> tuple[float, str]:
    """Six formulas, judged as that column of an otherwise right Jacobian at a generic pose, each
    half by itself."""
    if not (isinstance(answer, list) and len(answer) == 6):
        raise ArmError("expected a list of six formulas, one text for each of v and ω")
    mine = [str(entry[0] if isinstance(entry, list) and entry else entry) for entry in answer]
    column, arm = int(question.given["column"]) - 1, topics.camera_arm(question.arm, question.given)

    def judged(six: list[str]) -> checks.Verdict:
        J = [[str(entry) for entry in row] for row in symbolic.jacobian(arm).tolist()]
        for row, formula in zip(J, six, strict=True):
            row[column] = formula
        return checks.compare_jacobian(J, arm)

    whole = judged(mine)
    if whole.agrees:
        return 1.0, str(whole)
    halves = [[*mine[:3], *part.value[3:]], [*part.value[:3], *mine[3:]]]
    counting = sum(set(half) != {"0"} for half in (part.value[:3], part.value[3:]))
    wrong = sum(not judged(half).agrees for half in halves)
    return max(0.0, 1 - wrong / counting), str(whole)


def _branches(question: Question, part: Part, answer: Any) -> tuple[float, str]:
    """The share of the ways that were found; one that is none counts where there are too many."""
    known = topics.closed_form(question.arm)(question.arm, _target(question))  # type: ignore[misc]
    asked = replace(known, valid=known.within_limits)
    report = checks.compare_branches(answer, asked, tolerance=part.unit)
    right, every = report.figures.get("right", 0), len(part.value)
    share = right / max(every, right + report.figures.get("wrong", 0))
    return (1.0 if report.agrees else share), str(report)


def _pose(question: Question, part: Part, answer: Any) -> tuple[float, str]:
    """Whether joint values reach the target: any that do are right."""
    report = checks.compare_pose(answer, question.arm, _target(question), tolerance=part.unit)
    return float(report.agrees), str(report)


def _target(question: Question) -> Array:
    return topics.pose_of(np.array(question.given["target"]))


_JUDGED = {"table": _table, "column": _column, "branches": _branches, "pose": _pose}
