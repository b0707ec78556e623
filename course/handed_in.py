"""Find the answers in the files of a student.

An answers file counts before a notebook. Names do not matter, since learning platforms rename
files. Nothing is raised for what a student may have done: `HandIn.trouble` reports it.
"""

import json
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from course.answers import (
    ANSWER_PREFIX,
    SHEET_ANSWER,
    find_printed_answers,
    list_code_cells,
    parse_answers,
    read_source,
)
from course.files import HandedFile

_SHEET_LINE = re.compile(rf"^\s*{ANSWER_PREFIX}{SHEET_ANSWER}\s*=\s*['\"]([^'\"]+)", re.M)
_ANSWER_LINE = re.compile(rf"^\s*{ANSWER_PREFIX}(\w+)(.*)$", re.M)
_MAX_NAMES = 5  # file names in a message


@dataclass(frozen=True)
class HandIn:
    """The answers by name, and the problems with reading them."""

    answers: Mapping[str, Any] = field(default_factory=dict)
    trouble: str = ""


def read_hand_in(files: Sequence[HandedFile], parts: Collection[str]) -> HandIn:
    """Return the answers in a student's files, from answers.json or else from printed lines."""
    # In this order messages first name files that could not be read, then files that are no JSON.
    files = [_check_json(file) for file in sorted(files, key=_is_readable)]
    files.sort(key=_is_readable)
    json_files = [file for file in files if file.kind in (".json", ".ipynb")]
    notebooks = {f.name: data for f in json_files if list_code_cells(data := _load_json(f))}
    texts = {f.name: parse_answers(f.content) for f in json_files if f.name not in notebooks}
    lines = {name: find_printed_answers(book) for name, book in notebooks.items()}
    written, printed = (
        {name: a for name, a in answers.items() if a and _answers_some_part(a, parts)}
        for answers in (texts, lines)
    )
    for kind, candidates in (("answers files", written), ("notebooks", printed)):
        if candidates:
            hand_in = _choose_answers(kind, candidates)
            others = [name for name, a in printed.items() if a != hand_in.answers]
            if kind == "answers files" and others and not hand_in.trouble:
                trouble = f"{others[0]} printed other answers; those of the answers file are marked"
                return replace(hand_in, trouble=trouble)
            return hand_in
    return HandIn(trouble=_explain_no_answers(files, notebooks))


def find_sheet_name(file: HandedFile) -> str:
    """Return the name of the sheet that a file answers, or "" if the file does not name it."""
    data = _load_json(file)
    cells = list_code_cells(data)
    if cells:
        match = _SHEET_LINE.search("\n".join(map(read_source, cells)))
        return match[1] if match else ""
    answers = parse_answers(file.content) or {}
    return str(answers.get(SHEET_ANSWER, ""))


def compare_sheet_names(sheet_name: object, expected: str) -> str:
    """Return a message if answers belong to another sheet, otherwise ""."""
    if sheet_name is None or str(sheet_name) == expected:
        return ""
    sheet_name = str(sheet_name)[:64]
    student = expected.rpartition("/")[2].partition("#")[0]
    other_student = sheet_name.rpartition("/")[2].partition("#")[0]
    if other_student != student:
        return f"this answers the sheet of {other_student!r}, not of {student!r}"
    if "/" in sheet_name and "/" in expected:
        return (
            f"this answers {sheet_name!r}, another sheet of the same student; {expected!r} is valid"
        )
    return ""


def _is_readable(file: HandedFile) -> bool:
    return not file.trouble


def _choose_answers(kind: str, candidates: Mapping[str, Mapping[str, Any]]) -> HandIn:
    """Return the answers of the candidates if they agree, otherwise the candidates' names."""
    first, *others = candidates.values()
    if any(other != first for other in others):
        names = ", ".join(candidates)
        return HandIn(
            trouble=f"there are {len(candidates)} different {kind} ({names}); hand in one"
        )
    return HandIn(first)


def _answers_some_part(answers: Mapping[str, Any], parts: Collection[str]) -> bool:
    return any(answers.get(part) is not None for part in parts)


def _explain_no_answers(files: Sequence[HandedFile], notebooks: Mapping[str, Any]) -> str:
    """Explain why a hand-in has no answers."""
    untouched = {name for name, book in notebooks.items() if _is_untouched(book)}
    begun = [name for name in notebooks if name not in untouched]
    if begun and not any(cell.get("outputs") for cell in list_code_cells(notebooks[begun[0]])):
        return f"{begun[0]} was never run: choose Restart and run all, save it, hand it in again"
    if begun:
        return f"{begun[0]} answers nothing: its last cell was not run after it was answered"
    names = [str(file) for file in files if file.name not in untouched]
    result = "nothing was answered" if untouched else "nothing was handed in"
    if not names:
        return result
    more = f" and {len(names) - _MAX_NAMES} more" if len(names) > _MAX_NAMES else ""
    return f"{result} that can be marked; seen: {', '.join(names[:_MAX_NAMES])}{more}"


def _is_untouched(notebook: Any) -> bool:
    """Return whether every answer cell still contains the dots of the empty sheet."""
    sources = "\n".join(map(read_source, list_code_cells(notebook)))
    lines = _ANSWER_LINE.findall(sources)
    return {rest.replace(" ", "") for name, rest in lines if name != SHEET_ANSWER} == {"=..."}


def _load_json(file: HandedFile) -> Any:
    try:
        return json.loads(file.content)
    except (ValueError, RecursionError):
        return None


def _check_json(file: HandedFile) -> HandedFile:
    """Add a reason to a file that should be JSON but is not."""
    if file.trouble or file.kind not in (".json", ".ipynb"):
        return file
    try:
        json.loads(file.content)
    except json.JSONDecodeError as error:
        return replace(file, trouble=f"this is no JSON: line {error.lineno}, {error.msg}")
    except (ValueError, RecursionError) as error:
        return replace(file, trouble=f"this is no JSON: {error}"[:100])
    return file
