"""An answer judged by the checkers, with its credit; and the proof that a sheet can be marked."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers import symbolic, variants
from helpers.arm import Arm
from helpers.checks import (
    compare_branches,
    compare_jacobian,
    compare_pose,
    compare_tables,
    compare_torques,
    jacobian_causes,
    torques_causes,
)
from helpers.checks.door import numbers
from helpers.checks.torques_causes import Load
from helpers.checks.verdict import Report
from helpers.course.store import Rules
from helpers.inputs import ArmError
from helpers.statics import GRAVITY
from helpers.variants import Part, Question, Sheet

Array = NDArray[np.float64]

_MOST = 8000  # characters of a text, or entries of a list: the longest right column has 3473
_HARMLESS = {"tau.gravity:9.80665"}  # standard gravity, 0.03 % beside 9.81: nobody's mistake
_SLIGHT = 1e-9  # rad or m beyond a limit that rounding explains


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
    0.
    """
    if answer is None or answer == [] or answer == "":
        return _none(part, "Not answered.")
    if _size(answer) > _MOST:
        return _none(part, f"Not read: it has more than {_MOST} entries or characters.")
    question = next(q for q in sheet.questions if part in q.parts)
    try:
        return _KINDS[part.kind](question, part, answer, rules)
    except ArmError as error:
        return _none(part, f"Not read: {error}")
    except Exception as error:  # whatever breaks a reader, it costs its own part only
        return _none(
            part, f"Not read ({type(error).__name__}): write numbers or formulas as on the sheet."
        )


def _none(part: Part, words: str) -> Mark:
    return Mark(part.name, 0.0, words, words)


def _size(answer: Any, depth: int = 0) -> int:
    """How much there is to read; lists nested deeper than any matrix count as too much."""
    if isinstance(answer, str):
        return len(answer)
    if isinstance(answer, Mapping):
        answer = list(answer.values())
    if isinstance(answer, list | tuple):
        return _MOST + 1 if depth > 4 else sum(_size(entry, depth + 1) for entry in answer) + 1
    return int(getattr(answer, "size", 1))


def _judged(part: Part, rules: Rules, checker: Callable[..., Report], *asked: Any) -> Mark:
    """The mark from a checker's report with the tolerance that the sheet promises, and where that
    does not agree from the one by the digits given.
    """
    near = checker(*asked, tolerance=part.tolerance)
    if near.agrees:
        return Mark(part.name, 1.0, near.headline, str(near))
    exact = checker(*asked)
    return Mark(part.name, _credit(exact, rules), exact.headline, str(exact), exact.causes)


def _credit(report: Report, rules: Rules) -> float:
    """By the rules: digits, a named cause, or the share that is right."""
    share = report.figures.get("right", 0) / max(1, report.figures.get("of", 1))
    if report.grade in ("right", "rounded") or (report.grade == "so far" and not share):
        return rules.digits  # right to the digits given, which are fewer than the sheet asks
    if report.grade == "so far":
        return share
    known = [
        rules.causes[key] for cause in report.causes for key in _keys(cause) if key in rules.causes
    ]
    return max([*known[:1], rules.columns * share])


def _keys(cause: str) -> Iterator[str]:
    """The names by which the rules may speak of a cause: whole, and without its fields."""
    yield cause
    yield " + ".join(part.split(":")[0] for part in cause.split(" + "))


def _table(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    return _judged(part, rules, compare_tables, _with_kinds(answer, part.value), part.value)


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


def _numbers(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    typed, right = numbers(answer, f"`{part.name}`"), np.asarray(part.value, dtype=float)
    if typed.values.size != right.size:
        return _none(part, f"It has shape {typed.values.shape}; expected {right.shape}.")
    mine, units = typed.values.reshape(right.shape), typed.units.reshape(right.shape)
    off = np.abs(mine - right)
    far = off > np.maximum(part.tolerance, 0.51 * units)
    if (off <= part.tolerance).all():
        return Mark(part.name, 1.0, "Right.", "Right.")
    if not far.any():
        words = "Right as far as it goes: give more digits."
        return Mark(part.name, rules.digits, words, words)
    for key, sentence, meant in _usual(mine):
        if (np.abs(meant - right) <= np.maximum(part.tolerance, np.abs(right) * 1e-3)).all():
            credit = rules.causes.get(key, 0.0)
            return Mark(part.name, credit, sentence, sentence, (key,))
    words = f"Not right: {far.sum()} of {right.size} entries are off, by up to {off.max():.3g}."
    return _none(part, words)


def _usual(mine: Array) -> Iterator[tuple[str, str, Array]]:
    """Mistakes that any list of numbers, or square matrix, may hold: its name, what is said, and
    the numbers with it undone.
    """
    yield "numbers.millimetres", "Right in millimetres; metres were asked.", mine / 1000
    yield "numbers.degrees", "Right in degrees; radians were asked.", np.radians(mine)
    yield "numbers.sign", "Every sign is the other way round.", -mine
    if mine.shape == mine.T.shape:
        yield "numbers.transposed", "It is the transpose of what was asked.", mine.T


def _jacobian(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    return _judged(part, rules, compare_jacobian, answer, question.arm, question.given["q"])


def _column(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    """Six formulas, judged as that column of an otherwise right Jacobian at a generic pose."""
    if not (isinstance(answer, list) and len(answer) == 6):
        return _none(part, "Expected a list of six formulas.")
    column, arm = int(question.given["column"]) - 1, question.arm
    J = [[str(entry) for entry in row] for row in symbolic.jacobian(arm).tolist()]
    for row, formula in zip(J, answer, strict=True):
        (row[column],) = formula if isinstance(formula, list) else (str(formula),)
    report = compare_jacobian(J, arm)
    return Mark(
        part.name, 1.0 if report.agrees else 0.0, report.headline, str(report), report.causes
    )


def _torques(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    given = question.given
    wrench = np.r_[given["force"] if part.name == "tau" else [0, 0, 0], 0, 0, 0]
    return _judged(part, rules, compare_torques, answer, question.arm, given["q"], wrench)


def _branches(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    """Every branch within the limits; one beyond them is none."""
    arm, solver = question.arm, variants.closed_form(question.arm)
    assert solver is not None
    known = solver(arm, variants.pose_of(np.array(question.given["target"])))
    asked = replace(known, valid=known.within_limits)
    found = _judged(part, rules, compare_branches, answer, asked)
    return _within_limits(arm, part, answer, found)


def _pose(question: Question, part: Part, answer: Any, rules: Rules) -> Mark:
    arm, target = question.arm, variants.pose_of(np.array(question.given["target"]))
    found = _judged(part, rules, compare_pose, answer, arm, target)
    return _within_limits(arm, part, answer, found)


def _within_limits(arm: Arm, part: Part, answer: Any, found: Mark) -> Mark:
    """The mark, or none where joint values that would count lie beyond the limits."""
    beyond = _beyond_limits(arm, answer) if found.credit and not found.causes else ""
    return _none(part, beyond) if beyond else found


def _beyond_limits(arm: Arm, answer: Any) -> str:
    """Words for the first joint value that lies beyond its limits even after whole turns; "" if
    none does.
    """
    rows = numbers(answer, "the joint values").values
    if rows.size % arm.dof:
        return ""  # another shape: the checker says so
    q, (low, high) = rows.reshape(-1, arm.dof), arm.limits
    turned = q + 2 * np.pi * np.arange(-3, 4)[:, None, None] * arm.turning
    within = ((turned >= low - _SLIGHT) & (turned <= high + _SLIGHT)).any(axis=0)
    for k, i in np.argwhere(~within)[:1]:
        found = f"{arm.variables[i]} = {q[k, i]:.4g}"
        return f"{found} lies beyond its limits, {low[i]:g} to {high[i]:g}."
    return ""


def prove(sheet: Sheet) -> None:
    """Show that a sheet can be marked: right work at four decimals gets all, and each mistake of
    the checkers' catalogues that a generic pose would show is farther off than the tolerance
    forgives.

    Raises ArmError that names the part and what it cannot tell apart.
    """
    for name, part in sheet.parts.items():
        found = mark(sheet, part, rounded(part), Rules())
        if found.credit != 1:
            raise ArmError(f"`{name}` cannot be marked: its own key is judged {found.headline!r}")
    for question in sheet.questions:
        for part in question.parts:
            if hidden := sorted(unseen(question, part) - unseen(_generic(question), part)):
                raise ArmError(
                    f"`{part.name}` cannot be marked: it does not show {', '.join(hidden)}"
                )


def rounded(part: Part) -> Any:
    """A part of the key as a student would write it: four decimals, a table's rows, formulas."""
    if part.kind == "table":
        return [[str(entry) for entry in row.entries] for row in part.value.rows]
    return part.value if part.kind == "column" else np.round(part.value, 4).tolist()


def unseen(question: Question, part: Part) -> set[str]:
    """The single mistakes of a part's catalogue that its tolerance would forgive."""
    arm, q = question.arm, np.array(question.given.get("q", []))
    if part.kind == "jacobian":
        known = jacobian_causes.singles(arm, q, 0)
        causes, made, right = list(known.causes), known.made, known.right
    elif part.kind == "torques":
        force = question.given["force"] if part.name == "tau" else [0, 0, 0]
        load = Load(arm, q[None], np.r_[force, 0, 0, 0], np.array(GRAVITY))
        causes, made = torques_causes.catalogue(load, 1)
        right = load.torques()
    else:
        return set()
    off = np.abs(made - right).reshape(len(causes), -1).max(axis=1)
    near = [c for c, far in zip(causes, off, strict=True) if far <= part.tolerance]
    return {c.name for c in near if len(c.keys) == 1} - _HARMLESS


def _generic(question: Question) -> Question:
    """The same question at joint values that have nothing special: what it hides, every pose
    hides.
    """
    q = question.given.get("q", [])
    return replace(
        question, given={**question.given, "q": [0.37 + 0.23 * i for i in range(len(q))]}
    )


_KINDS = {
    "table": _table,
    "numbers": _numbers,
    "jacobian": _jacobian,
    "column": _column,
    "torques": _torques,
    "branches": _branches,
    "pose": _pose,
}
