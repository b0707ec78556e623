"""Every hand-in of a course marked, each in a process of its own: what breaks costs its author."""

import csv
import io
import multiprocessing
import os
import threading
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from helpers.course import store
from helpers.course.answers import SHEET
from helpers.course.files import within
from helpers.course.handed_in import HandIn, read_hand_in
from helpers.course.marking import mark_sheet
from helpers.course.store import Course
from helpers.inputs import whole

_PATIENCE = 600  # seconds for a student beyond those of the notebook: then something hangs
_HOW = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
_STOPPED = "marking it stopped; please look at it by hand"
# A spreadsheet runs a cell that begins with one of these (OWASP, CSV injection).
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")


def grade(folder: Path, out: Path, jobs: int = 1, seconds: int = 0) -> list[dict[str, Any]]:
    """Mark what every student of a course handed in; the rows of grades.csv, in the course's order.

    Writes `out/grades.csv`, and for each student `feedback.txt`. Notebooks are run for so many
    seconds, and not at all for 0.
    """
    whole(jobs, "jobs", least=1)
    course = store.load(folder)
    alone = [
        replace(course, secret="", sheets={student: sheet})
        for student, sheet in course.sheets.items()
    ]
    if _HOW == "forkserver":
        multiprocessing.set_forkserver_preload([__name__])  # NumPy and all are read once
    with ThreadPoolExecutor(jobs) as threads:
        rows = list(threads.map(partial(_marked, folder, out, seconds), alone))
    store.write(out / "grades.csv", table(rows))
    return rows


def _marked(folder: Path, out: Path, seconds: int, course: Course) -> dict[str, Any]:
    """The row of a course's only student, from a process of its own that is ended when it hangs."""
    context: Any = multiprocessing.get_context(_HOW)
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_alone, args=(theirs, folder, out, seconds, course))
    process.start()
    theirs.close()
    try:
        if ours.poll(_PATIENCE + seconds):
            return dict(ours.recv())
    except EOFError:
        pass  # it ended without a word
    finally:
        process.kill()
        process.join()
    return _written(course, out, HandIn({}, _STOPPED))


def _alone(answer: Any, *work: Any) -> None:
    """Mark in a process of its own, which ends when whoever began it does."""
    threading.Thread(target=_end_with_parent, daemon=True).start()
    answer.send(mark_one(*work))


def _end_with_parent() -> None:
    if (parent := multiprocessing.parent_process()) is not None:
        parent.join()
        os._exit(1)


def mark_one(folder: Path, out: Path, seconds: int, course: Course) -> dict[str, Any]:
    """The row of a course's only student."""
    (student,) = course.sheets
    try:
        handed = read_hand_in(within(folder / student), course.sheet(student).parts, seconds)
        return _written(course, out, handed)
    except Exception as error:  # a hand-in may break what reads it in ways nobody thought of
        return _written(course, out, HandIn({}, f"{_STOPPED} ({type(error).__name__})"))


def _written(course: Course, out: Path, handed: HandIn) -> dict[str, Any]:
    """The row of a hand-in: id, name, total, a column for each part, and what went wrong; what
    was asked and what the checkers say, no solution, goes into the student's feedback.
    """
    ((student, name),) = course.names.items()
    sheet = course.sheet(student)
    marks = mark_sheet(sheet, handed.answers)
    other = str(handed.answers.get(SHEET, student))
    wrong = f"this answers the sheet of {other[:64]!r}, not of {student!r}"
    trouble = "; ".join(filter(None, [wrong if other != student else "", handed.trouble]))
    credits = {mark.part: round(mark.credit, 4) for mark in marks}
    total = round(sum(credits.values()), 4)
    lines = [f"{course.title}, {name} ({student}): {total:g} of {len(marks)}"]
    lines += [f"Note: {trouble}."] if trouble else []
    for part, mark in zip(sheet.parts.values(), marks, strict=True):
        lines += ["", f"{mark.part}: {mark.credit:g}  ({part.what})"]
        lines += [f"    {line}" for line in mark.words.splitlines()]
    store.write(out / student / "feedback.txt", "\n".join(lines) + "\n")
    return {"id": student, "name": name, "total": total, **credits, "note": trouble}


def table(rows: Sequence[Mapping[str, Any]]) -> str:
    """CSV of rows with the same keys, line ends as RFC 4180 wants; no word is a formula."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(rows[0]))
    writer.writeheader()
    for row in rows:
        risky = [key for key, v in row.items() if isinstance(v, str) and v.startswith(_FORMULA)]
        writer.writerow({**row, **{key: f"'{row[key]}" for key in risky}})
    return file.getvalue()
