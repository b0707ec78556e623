"""Every hand-in of a course marked, each in a process of its own: what breaks costs its author."""

import csv
import hashlib
import io
import json
import multiprocessing
import os
import threading
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from course import store
from course.answers import SHEET
from course.files import read_files
from course.handed_in import HandIn, compare_sheet_names, read_hand_in
from course.marking import mark_sheet
from course.store import Course
from helpers.inputs import whole_number

_PATIENCE = 600  # seconds for a student: then something hangs
_HOW = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
_STOPPED = "marking it stopped; please look at it by hand"
# A spreadsheet runs a cell that begins with one of these (OWASP, CSV injection).
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")


def grade(folder: Path, out: Path, jobs: int = 1) -> list[dict[str, Any]]:
    """Mark what every student of a course handed in; the rows of grades.csv, in the course's order.

    Writes `out/grades.csv`, and for each student `feedback.txt` and `mark.json`, by which nobody is
    marked twice: who handed in the same files as when it was written keeps the mark.
    """
    whole_number(jobs, "jobs", least=1)
    course = store.load(folder)
    alone = [
        replace(course, secret="", sheets={student: sheet})
        for student, sheet in course.sheets.items()
    ]
    if _HOW == "forkserver":
        multiprocessing.set_forkserver_preload([__name__])  # NumPy and all are read once
    with ThreadPoolExecutor(jobs) as threads:
        rows = list(threads.map(partial(_marked, folder, out), alone))
    store.write(out / "grades.csv", table(rows))
    return rows


def _marked(folder: Path, out: Path, course: Course) -> dict[str, Any]:
    """The row of a course's only student, as it was or marked anew."""
    (student,) = course.sheets
    kept, now = out / student / "mark.json", _as_it_is(folder / student, course)
    try:
        before = json.loads(kept.read_bytes())
        if before["of"] == now:
            return dict(before["row"])
    except (OSError, ValueError, KeyError, TypeError):
        pass  # there is none yet
    row = _apart(folder, out, course)
    store.write(kept, store.as_json({"of": now, "row": row}))
    return row


def _as_it_is(folder: Path, course: Course) -> str:
    """What a mark depends on, in a word: the sheet, the files as the disk knows them."""
    paths = sorted(Path(place, name) for place, _, names in os.walk(folder) for name in names)
    told = [(str(path), (s := path.lstat()).st_size, s.st_mtime_ns, s.st_mode) for path in paths]
    words = repr((told, store.text(course)))
    return hashlib.sha256(words.encode(errors="surrogateescape")).hexdigest()


def _apart(folder: Path, out: Path, course: Course) -> dict[str, Any]:
    """The row of a course's only student, from a process of its own that is ended when it hangs."""
    context: Any = multiprocessing.get_context(_HOW)
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=_alone, args=(theirs, folder, out, course))
    process.start()
    theirs.close()
    try:
        if ours.poll(_PATIENCE):
            return dict(ours.recv())
    except EOFError:
        pass  # it ended without a word
    finally:
        process.kill()
        process.join()
    return _written(course, out, HandIn(trouble=_STOPPED))


def _alone(answer: Any, *work: Any) -> None:
    """Mark in a process of its own, which ends when whoever began it does."""
    threading.Thread(target=_end_with_parent, daemon=True).start()
    answer.send(mark_one(*work))


def _end_with_parent() -> None:
    if (parent := multiprocessing.parent_process()) is not None:
        parent.join()
        os._exit(1)


def mark_one(folder: Path, out: Path, course: Course) -> dict[str, Any]:
    """The row of a course's only student."""
    (student,) = course.sheets
    try:
        handed = read_hand_in(read_files(folder / student), course.sheet(student).parts)
        return _written(course, out, handed)
    except Exception as error:  # a hand-in may break what reads it in ways nobody thought of
        return _written(course, out, HandIn(trouble=f"{_STOPPED} ({type(error).__name__})"))


def _written(course: Course, out: Path, handed: HandIn) -> dict[str, Any]:
    """The row of a hand-in: id, name, total, a column for each part, and what went wrong; what
    was asked and what the checkers say, no solution, goes into the student's feedback.
    """
    ((student, name),) = course.names.items()
    sheet = course.sheet(student)
    marks = mark_sheet(sheet, handed.answers)
    trouble = "; ".join(
        filter(None, [compare_sheet_names(handed.answers.get(SHEET), student), handed.trouble])
    )
    credits = {mark.part: round(mark.credit, 4) for mark in marks}
    total = round(sum(credits.values()), 4)
    lines = [f"{course.title}, {name} ({student}): {total:.4g} of {len(marks)}"]
    lines += [f"Note: {trouble}."] if trouble else []
    for part, mark in zip(sheet.parts.values(), marks, strict=True):
        lines += ["", f"{mark.part}: {mark.credit:.3g} of 1 for {part.what}"]
        lines += [f"    {line}" for line in mark.message.splitlines()]
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
