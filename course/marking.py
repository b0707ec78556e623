"""Mark the answers of a sheet.

Right in the decimals asked is worth 1. Any other answer is worth half of its share that is right,
and half if a usual mistake explains all of it, a wrong unit included. The credit never depends on
the number of typed digits, since a unit of the last decimal asked is forgiven. So coarser digits
earn only where the rounded number is right by itself, a named mistake costs the same on every
sheet, and what is left out never earns more than what is written.

A table is worth 1, or half with one mistake, in any choice of frames; otherwise its right rows
before the first wrong row count. Of joint values for a target each branch counts by itself.
"""

import re
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course import topics
from course.mistakes import DEGREES, MILLIMETRES, Mistake
from course.sheets import Part, Question, Sheet
from helpers import checks
from helpers.checks.arms import judge_data
from helpers.checks.compare import TypedNumbers, read_numbers
from helpers.checks.engine import ask_judge
from helpers.checks.tables import format_table
from helpers.inputs import ArmError

Array = NDArray[np.float64]

MISTAKE_SHARE = 0.5  # credit for work with one mistake
_MAX_CHARACTERS = 8000  # the longest right column has 3473
_ROUND_OFF = 1 + 1e-9
_MAX_NAMED_MISTAKES = 3  # at most this many mistakes that give the same numbers are named
NOT_ANSWERED = "Not answered."
_RIGHT = "Right."
_NO_MISTAKE_SEEN = "It was read; no usual mistake explains all of it."
# The checkers' advice to set an option, which a sheet does not offer.
_OPTION_ADVICE = re.compile(r"(\n- | )If that is what you mean, say .*")
_BLANK = (None, "", "...", ".", "-")


@dataclass(frozen=True)
class Mark:
    """The mark of a part.

    Attributes:
        part: Name of the part.
        credit: From 0 to 1.
        message: The reasons, in sentences to the student.
        hint: Message before the deadline. It may name a mistake, but it contains no mark, no right
            or wrong entry and no number of the key.
        mistakes: Names of the mistakes in the judge's catalogue.
    """

    part: str
    credit: float
    message: str
    hint: str = ""
    mistakes: tuple[str, ...] = ()


def mark_sheet(sheet: Sheet, answers: Mapping[str, Any]) -> tuple[Mark, ...]:
    """Mark every part of a sheet, with 0 for a part without an answer."""
    return tuple(mark_part(sheet, name, answers.get(name)) for name in sheet.parts)


def mark_part(sheet: Sheet, name: str, answer: Any) -> Mark:
    """Mark an answer, with 0 for an answer that cannot be read.

    The function raises nothing.
    """
    part = sheet.parts[name]
    question = next(q for q in sheet.questions if part in q.parts)
    try:
        answer = _replace_mappings(answer)
        if len(str(answer)) > _MAX_CHARACTERS:
            return _make_refusal(name, f"Not read: it has more than {_MAX_CHARACTERS} characters.")
        if not any(c.isalnum() and c != "0" for c in str(_fill_blanks(answer))):
            return _make_refusal(name, NOT_ANSWERED)
        mark_kind = _MARK_BY_KIND.get(part.kind, _mark_numbers)
        return mark_kind(question, part, answer)
    except ArmError as error:
        return _make_refusal(name, _OPTION_ADVICE.sub("", f"Not read: {error}"))
    except Exception as error:  # an answer that raises any error costs only its own part
        message = f"Not read ({type(error).__name__}): write numbers or formulas as on the sheet."
        return _make_refusal(name, message)


def _make_refusal(name: str, message: str) -> Mark:
    return Mark(name, 0.0, message, message)


def _replace_mappings(answer: Any) -> Any:
    """Replace mappings of names to entries by lists of the entries."""
    if isinstance(answer, Mapping):
        answer = list(answer.values())
    return [_replace_mappings(entry) for entry in answer] if isinstance(answer, list) else answer


def _fill_blanks(answer: Any) -> Any:
    """Write 0 for each entry that the student left blank."""
    if isinstance(answer, list):
        return [_fill_blanks(entry) for entry in answer]
    return 0 if answer in _BLANK or answer != answer else answer


# Numbers and formulas


def _mark_numbers(question: Question, part: Part, answer: Any) -> Mark:
    """Mark numbers by blocks: entries, columns, or halves of columns."""
    typed = _read_answer(_fill_blanks(answer), f"`{part.name}`")
    candidates = _reshape_like_answer(typed, part)
    return max(
        (_mark_values(part, numbers) for numbers in candidates), key=lambda mark: mark.credit
    )


def _read_answer(answer: Any, name: str) -> TypedNumbers:
    """Read a list, or join its entries to a text if they contain units or decimal commas."""
    try:
        return read_numbers(answer, name)
    except ArmError:
        if not isinstance(answer, list):
            raise
        typed = read_numbers(_join_entries(answer), name)
        if typed.values.size != np.size(np.array(answer, dtype=object)):
            raise  # an entry is no number
        return typed


def _join_entries(answer: list[Any]) -> str:
    rows = answer if any(isinstance(row, list) for row in answer) else [answer]
    rows = [row if isinstance(row, list) else [row] for row in rows]
    return "\n".join("\t".join(map(str, row)) for row in rows)


def _reshape_like_answer(typed: TypedNumbers, part: Part) -> list[TypedNumbers]:
    """Return numbers in the shape of the right answer, or of either half of a Jacobian.

    Raises ArmError if their count differs.
    """
    shape, values, units = np.shape(part.value), typed.values, typed.units
    if values.size == np.size(part.value):
        return [TypedNumbers(values.reshape(shape), units.reshape(shape))]
    if part.kind == "jacobian" and values.shape == (3, shape[1]):
        zeros, all_units = np.zeros_like(values), np.r_[units, units]
        halves = (np.r_[values, zeros], np.r_[zeros, values])
        return [TypedNumbers(half, all_units) for half in halves]
    message = f"{values.size} numbers given, expected {np.size(part.value)}"
    raise ArmError(f"{message}; write 0 for what you do not have")


def _mark_values(part: Part, typed: TypedNumbers) -> Mark:
    """Mark numbers of the right shape."""
    tolerance = part.unit * _ROUND_OFF
    errors = np.abs(typed.values - part.value)
    if errors.max() <= tolerance:
        return Mark(part.name, 1.0, _RIGHT, _NO_MISTAKE_SEEN)
    is_right = _split_into_blocks(part, errors).max(axis=1) <= tolerance
    needs_work = (
        _split_into_blocks(part, np.abs(part.value - part.baseline)).max(axis=1) > tolerance
    )
    share = float((is_right & needs_work).sum() / max(1, needs_work.sum()))
    mistakes = [m for m in part.mistakes if _is_explained_by(part, typed.values, m)]
    credit = MISTAKE_SHARE if mistakes else MISTAKE_SHARE * share
    hint = _name_mistakes(mistakes) if mistakes else _NO_MISTAKE_SEEN
    lines = [*([hint] if mistakes else []), _describe_wrong_blocks(part, ~is_right)]
    coarse = np.maximum(typed.units, tolerance)
    if np.all(errors <= coarse * _ROUND_OFF) and part.kind != "column":
        lines.append(f"Too few decimals: {part.digits} were asked.")
    return Mark(part.name, credit, "\n".join(lines), hint, tuple(m.name for m in mistakes))


def _is_explained_by(part: Part, values: Array, mistake: Mistake) -> bool:
    """Return whether an answer has every block of a mistake that differs from the baseline."""
    # Numbers in millimetres have 1000 times the rounding error of metres.
    scale = max(1.0, np.abs(mistake.values).max() / np.abs(part.value).max())
    tolerance = part.unit * _ROUND_OFF * scale
    needed = (
        _split_into_blocks(part, np.abs(mistake.values - part.baseline)).max(axis=1) > tolerance
    )
    fits = _split_into_blocks(part, np.abs(values - mistake.values)).max(axis=1) <= tolerance
    return bool(needed.any() and fits[needed].all())


def _split_into_blocks(part: Part, values: Array) -> Array:
    """Split values into the blocks that earn credit separately, shape (blocks, numbers in each)."""
    values = np.broadcast_to(values, np.shape(part.value))
    if part.kind == "jacobian":  # halves of columns, the linear half first
        return values.reshape(2, 3, -1).transpose(2, 0, 1).reshape(-1, 3)
    if part.kind == "rotation":
        return values.T
    if part.kind == "column":  # the two halves, at all secret configurations
        return values.reshape(-1, 2, 3).transpose(1, 0, 2).reshape(2, -1)
    return values.reshape(-1, 1)


def _name_mistakes(mistakes: list[Mistake]) -> str:
    messages = list(dict.fromkeys(mistake.message for mistake in mistakes))[:_MAX_NAMED_MISTAKES]
    return f"This is what a usual mistake gives: {'; or: '.join(messages)}."


def _describe_wrong_blocks(part: Part, is_wrong: NDArray[np.bool_]) -> str:
    """Describe the wrong blocks, such as "the linear half of columns 1, 3"."""
    if part.kind == "column":
        names = np.array(["linear", "angular"])[is_wrong]
        return f"Not right: the {' and the '.join(names)} half."
    if part.kind != "jacobian":
        noun = "column" if part.kind == "rotation" else "number"
        return f"Not right: {_list_positions(noun, is_wrong)}."
    halves = [
        f"the {half} half of {_list_positions('column', wrong)}"
        for half, wrong in zip(("linear", "angular"), is_wrong.reshape(-1, 2).T, strict=True)
        if wrong.any()
    ]
    return f"Not right: {'; '.join(halves)}."


def _list_positions(noun: str, is_wrong: NDArray[np.bool_]) -> str:
    positions = [str(n + 1) for n in np.flatnonzero(is_wrong)]
    return f"{noun}{'s' * (len(positions) > 1)} {', '.join(positions)}"


def _mark_column(question: Question, part: Part, answer: Any) -> Mark:
    """Mark six formulas by their values at the secret configurations."""
    answer = _fill_blanks(answer)
    if isinstance(answer, list):
        answer = [row[0] if isinstance(row, list) and len(row) == 1 else row for row in answer]
        if len(answer) != 6:
            raise ArmError("expected six formulas, one for each of v and ω")
        answer = [str(entry) for entry in answer]
    camera = topics.make_camera_arm(question.arm, question.numbers)
    configurations = np.array(question.numbers["configurations"])[:, : camera.dof].tolist()
    values_by_configuration = ask_judge(
        "formulas", mine=answer, arm=judge_data(camera), configurations=configurations
    )
    if len(values_by_configuration) != np.size(part.value) or None in values_by_configuration:
        raise ArmError(
            "expected six formulas, one for each of v and ω, with a value at every configuration"
        )
    values = np.array(values_by_configuration, dtype=float).reshape(-1, 6)
    return _mark_values(part, TypedNumbers(values, np.zeros_like(values)))


# Tables and joint values, for which several answers are right


def _mark_table(_: Question, part: Part, answer: Any) -> Mark:
    """Mark a table, in any valid choice of frames, as right, with one mistake, or unfinished.

    A wrong row behind right rows costs as much as a missing row.
    """
    mine, arm = format_table(answer), judge_data(part.value)
    replies = dict[str, dict[str, Any]]()
    for mistake, units in _TABLE_UNITS.items():
        with suppress(ArmError):  # the table cannot have these units
            replies[mistake] = _compare_table(mine, arm, part.unit, **units)
            if replies[mistake]["right"] and not mistake:
                return Mark(part.name, 1.0, replies[""]["headline"], _NO_MISTAKE_SEEN)
            if replies[mistake]["right"]:
                message = f"This is what a mistake gives: {mistake}."
                return Mark(part.name, MISTAKE_SHARE, message, message, ("course.units",))
    reply = replies.get("") or _compare_table(mine, arm, part.unit)
    if not reply["name"]:
        first_rows = [_write_read_row(row, n) for n, row in enumerate(reply["rows"], 1)]
        beginnings = (first_rows[:n] for n in range(len(first_rows), 0, -1))
        of_beginnings = (_compare_table(format_table(rows), arm, part.unit) for rows in beginnings)
        begun = next((x for x in (reply, *of_beginnings) if "share" in x), None)
        credit = MISTAKE_SHARE * begun["share"] if begun else 0.0
        message = begun["headline"] if begun else "Not right: it describes another arm."
        if "share" not in reply:
            message = f"Not right, and no one mistake explains it. {message}"
        return Mark(part.name, credit, message, _NO_MISTAKE_SEEN)
    message = f"This is what a mistake gives: {reply['message'].rstrip('.')}."
    has_size = reply["name"].startswith("course.entry")
    hint = _NO_MISTAKE_SEEN if has_size else message
    return Mark(part.name, MISTAKE_SHARE, message, hint, (reply["name"],))


_TABLE_UNITS = {  # by the key of the mistake
    "": {},
    MILLIMETRES: {"lengths": "mm"},
    DEGREES: {"angles": "deg"},
    f"{MILLIMETRES}. {DEGREES}": {"lengths": "mm", "angles": "deg"},
}


def _compare_table(mine: str, arm: Any, unit: float, **units: str) -> dict[str, Any]:
    """Compare a table, by default in m and rad, with the arm of the question."""
    options = {
        "columns": "a alpha d theta", "lengths": "m", "angles": "rad", "convention": "standard",
        "tolerance": unit, **units,
    }  # fmt: skip
    return ask_judge("table mistake", mine=mine, arm=arm, options=options)


def _write_read_row(row: Mapping[str, Any], number: int) -> list[str]:
    """Write a row as the judge read it, with the joint's variable."""
    entries = {name: repr(row[name]) for name in ("a", "alpha", "d", "theta")}
    if moved := {"revolute": "theta", "prismatic": "d"}.get(row["kind"]):
        entries[moved] = f"q_{number} + {entries[moved]}"
    return list(entries.values())


def _mark_branches(question: Question, part: Part, answer: Any) -> Mark:
    """Give credit for the fraction of branches that are among the first rows."""
    typed = _read_answer(_fill_blanks(answer), f"`{part.name}`")
    if typed.values.size % question.arm.dof:
        raise ArmError(f"{typed.values.size} numbers given, expected rows of {question.arm.dof}")
    return _mark_joint_values(question, part, typed, _mark_rows)


def _mark_joint_values(
    question: Question, part: Part, typed: TypedNumbers, mark_rows: Callable[..., Mark]
) -> Mark:
    """Mark rows of joint values; rows that are right in other units earn half."""
    shape = (-1, question.arm.dof)
    rows, units = typed.values.reshape(shape), typed.units.reshape(shape)
    mark = mark_rows(question, part, rows, units)
    turning = np.asarray(question.arm.turning)
    for text, factors in (
        (DEGREES, np.where(turning, np.pi / 180, 1.0)),
        (MILLIMETRES, np.where(turning, 1.0, 0.001)),
    ):
        other = mark_rows(question, part, rows * factors, units * factors)
        if MISTAKE_SHARE * other.credit > mark.credit:
            message = f"This is what a mistake gives: {text}."
            credit = MISTAKE_SHARE * other.credit
            mark = Mark(part.name, credit, message, message, ("course.units",))
    return mark


def _mark_rows(question: Question, part: Part, rows: Array, units: Array) -> Mark:
    """Mark rows by the branches that they match."""
    count = len(part.value)
    hits = _match_branches(question, part, rows[:count], part.unit)
    credit = float(hits.any(axis=0).sum() / count)
    wrong = np.asarray(~hits.any(axis=1))
    if credit == 1:
        return Mark(part.name, 1.0, _RIGHT, _NO_MISTAKE_SEEN)
    lines = [f"{hits.any(axis=0).sum()} of {count} branches are right."]
    if len(rows) > count:
        lines.append(f"{len(rows)} rows are given; the first {count} count.")
    coarse = _match_branches(question, part, rows[:count], np.maximum(part.unit, units[:count]))
    if wrong.any() and coarse.any(axis=1).all():
        lines.append(f"Too few decimals: {part.digits} were asked.")
    elif wrong.any():
        lines.append(f"Not right: {_list_positions('row', wrong)}.")
    return Mark(part.name, credit, "\n".join(lines), _NO_MISTAKE_SEEN)


def _match_branches(question: Question, part: Part, rows: Array, tolerance: Any) -> NDArray:
    """Return which row equals which branch up to whole turns, shape (rows, branches)."""
    gaps = rows[:, None] - part.value[None]
    turns = np.asarray(question.arm.turning)
    gaps = np.where(turns, (gaps + np.pi) % (2 * np.pi) - np.pi, gaps)
    limits = np.broadcast_to(np.asarray(tolerance) * _ROUND_OFF, rows.shape)[:, None]
    return np.asarray((np.abs(gaps) <= limits).all(axis=2))


def _mark_pose(question: Question, part: Part, answer: Any) -> Mark:
    """Mark joint values by whether they reach the target."""
    target = topics.make_target_pose(np.array(question.numbers["target"]))
    typed = _read_answer(_fill_blanks(answer), f"`{part.name}`")
    if typed.values.size != question.arm.dof:
        raise ArmError(f"{typed.values.size} numbers given, expected {question.arm.dof}")
    return _mark_joint_values(question, part, typed, partial(_mark_reached, target))


def _mark_reached(target: Array, question: Question, part: Part, rows: Array, _: Array) -> Mark:
    """Mark a row of joint values by whether it reaches the target."""
    verdict = checks.compare_pose(rows[0], question.arm, target, tolerance=part.unit)
    if verdict.agrees:
        return Mark(part.name, 1.0, _OPTION_ADVICE.sub("", str(verdict)), _NO_MISTAKE_SEEN)
    return Mark(
        part.name, 0.0, _OPTION_ADVICE.sub("", str(verdict)), _NO_MISTAKE_SEEN, verdict.causes
    )


_MARK_BY_KIND = {
    "table": _mark_table,
    "column": _mark_column,
    "branches": _mark_branches,
    "pose": _mark_pose,
}
