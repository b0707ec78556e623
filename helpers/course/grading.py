"""Every hand-in of a course marked, each in a process of its own: what breaks costs its author."""

import hashlib
import json
import multiprocessing
import os
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from multiprocessing.connection import wait
from pathlib import Path
from typing import Any

from helpers.course import gradebook, store
from helpers.course.feedback import feedback_page
from helpers.course.files import Found, within
from helpers.course.handed_in import SHEET, HandIn, read_hand_in
from helpers.course.marking import Rules, mark_sheet
from helpers.course.progress import counted
from helpers.course.sandbox import Limits
from helpers.inputs import whole
from helpers.variants import Sheet

_RESULTS = "results.json"
_PATIENCE = 600  # seconds for a student beyond those of the notebook: then something hangs
_HOW = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
_STOPPED = "marking it stopped; please look at it by hand"


@dataclass(frozen=True)
class Job:
    """What is needed to mark one student; no secret is."""

    student: str
    name: str
    title: str
    sheet: Sheet
    rules: Rules
    folder: Path
    out: Path
    limits: Limits | None


def grade(
    folder: Path, secret: bytes, out: Path, *, jobs: int = 1, limits: Limits | None = None
) -> list[dict[str, Any]]:
    """Mark what every student of a course handed in; the rows of grades.csv, in the course's order.

    Writes `out/grades.csv`, and for each student `feedback.html` and `results.json`. One whose
    hand-in has not changed since the last run is not marked again. Notebooks are run within the
    `limits`, and not at all without. Raises ArmError where a sheet is not signed by the secret.
    """
    whole(jobs, "jobs", least=1)
    course = store.load(folder)
    todo = [
        Job(s, n, course.title, course.sheet(s, secret), course.rules, folder / s, out / s, limits)
        for s, n in course.names.items()
    ]
    rows = {row["id"]: row for row in counted(_marked(todo, jobs), "students", len(todo))}
    ordered = [rows[job.student] for job in todo]
    store.write(out / "grades.csv", gradebook.table(ordered))
    return ordered


def _marked(todo: Sequence[Job], at_once: int) -> Iterator[dict[str, Any]]:
    """The rows as they come, each from a process of its own that is ended when it hangs."""
    context: Any = multiprocessing.get_context(_HOW)
    if _HOW == "forkserver":
        context.set_forkserver_preload([__name__])  # NumPy and all are read once
    waiting, running = list(reversed(todo)), dict[Any, tuple[Job, Any, float]]()
    try:
        while waiting or running:
            while waiting and len(running) < at_once:
                job = waiting.pop()
                process = context.Process(target=_alone, args=(job,))
                process.start()
                seconds = _PATIENCE + (job.limits.notebook if job.limits else 0)
                running[process.sentinel] = job, process, time.monotonic() + seconds
            first = min(end for _, _, end in running.values())
            wait(list(running), max(0, first - time.monotonic()))
            for sentinel, (job, process, end) in list(running.items()):
                if process.is_alive() and time.monotonic() < end:
                    continue
                process.kill()
                process.join()
                del running[sentinel]
                done = _known(job).get("row") if process.exitcode == 0 else None
                yield done or _write(job, HandIn({}, _STOPPED), "")
    finally:
        for _, process, _ in running.values():
            process.kill()


def _alone(job: Job) -> None:
    """Mark in a process of its own, which ends when whoever began it does."""
    threading.Thread(target=_end_with_parent, daemon=True).start()
    mark_one(job)


def _end_with_parent() -> None:
    if (parent := multiprocessing.parent_process()) is not None:
        parent.join()
        os._exit(1)


def mark_one(job: Job) -> dict[str, Any]:
    """One student's row: the known one where nothing has changed, else a new one."""
    files = within(job.folder)
    print_of = _fingerprint(job, files)
    known = _known(job)
    if known.get("fingerprint") == print_of:
        return known["row"]
    try:
        handed = read_hand_in(files, job.sheet.parts, job.limits)
        return _write(job, handed, print_of)
    except Exception as error:  # a hand-in may break what reads it in ways nobody thought of
        return _write(job, HandIn({}, f"{_STOPPED} ({type(error).__name__})"), "")


def _write(job: Job, handed: HandIn, print_of: str) -> dict[str, Any]:
    """Marks, words and row of a hand-in, into the student's folder of results."""
    marks = mark_sheet(job.sheet, handed.answers, job.rules)
    other = str(handed.answers.get(SHEET, job.student))
    wrong = f"this answers the sheet of {other[:64]!r}, not of {job.student!r}"
    trouble = "; ".join(filter(None, [wrong if other != job.student else "", handed.trouble]))
    row = gradebook.grade_row(job.student, job.name, marks, trouble)
    who = f"{job.name} ({job.student})"
    page = feedback_page(job.title, who, job.sheet, marks, trouble)
    store.write(job.out / "feedback.html", page)
    about = {"fingerprint": print_of, "row": row}
    results = {**gradebook.gradescope(marks, trouble), "extra_data": about}
    store.write(job.out / _RESULTS, store.as_json(results))
    return row


def _known(job: Job) -> Mapping[str, Any]:
    """The fingerprint and the row of the last run; empty where there was none."""
    try:
        return dict(json.loads((job.out / _RESULTS).read_bytes())["extra_data"])
    except (OSError, ValueError, KeyError, TypeError):
        return {}


def _fingerprint(job: Job, files: Sequence[Found]) -> str:
    """Of everything a mark depends on: the files, the sheet, the rules, how notebooks are run."""
    about = [
        job.name,
        job.title,
        dict(job.sheet.arm.values),
        job.sheet.drawn,
        job.rules,
        job.limits,
    ]
    digest = hashlib.sha256(repr(about).encode())
    for found in files:
        digest.update(f"{found}\n".encode() + hashlib.sha256(found.content).digest())
    return digest.hexdigest()
