"""Grade every hand-in of a course, with reasons, so that grading again gives the same marks.

`mark.json` in a student's folder of results keeps the marks, a digest of what they depend on (the
contents of the files and the sheet), and every mark that was given for it with its reason.
Feedback and tables are written from it.
"""

import csv
import hashlib
import io
import json
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Future, as_completed
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from course import store
from course.answers import NOTEBOOK_FILE, SHEET_ANSWER
from course.collect import LATE_FILE, read_unread_files
from course.files import HandedFile, read_files
from course.handed_in import HandIn, compare_sheet_names, read_hand_in
from course.marking import mark_sheet
from course.processes import make_pool
from course.roster import read_csv_rows
from course.store import Course
from helpers.inputs import ArmError, whole_number

_STOPPED = "marking it stopped; please look at it by hand"
# Files in the folder of the course.
_MARKS, _LATE = "marks.csv", "late.csv"
_NOT_MARKED = "Not marked yet."
# A spreadsheet executes a cell that begins with such a character (OWASP, CSV injection). Some
# spreadsheets separate cells by semicolons or tabs, so a cell may also begin after these.
_FORMULA_START = re.compile(r"(^|[;\t\r\n]\s*)(?=[=+\-@|%\t\r\n])")

Record = dict[str, Any]  # the contents of mark.json
Marks = Sequence[Mapping[str, Any]]
Rows = Sequence[Mapping[str, Any]]  # of a table, by column header
MarksByHand = dict[str, tuple[float, str]]  # credits and remarks by part


class GradingResult(NamedTuple):
    """The rows of grades.csv, and the changes since the last marking."""

    rows: list[dict[str, Any]]
    changes: list[dict[str, Any]]


def grade_hand_ins(
    folder: Path, out: Path, jobs: int = 0, *, again: bool = False, hints: int = 0,
    report: Callable[[str], None] = lambda _: None,
) -> GradingResult:  # fmt: skip
    """Mark all hand-ins of a course and write grades.csv and the feedback.

    Args:
        folder: The course.
        out: Folder of the results.
        jobs: Processes that mark; 0 for one for each processor.
        again: Mark everybody anew, as after a fix of the judge.
        hints: Before the deadline, write hints in place of marks into the feedback of so many
            hand-ins of a student.
        report: Receives a line of progress after each student.
    """
    jobs, hints = whole_number(jobs, "jobs"), whole_number(hints, "hints")
    course = store.load_course(folder)
    with store.lock_folder(folder):
        by_hand, late = read_marks_by_hand(folder, course), read_late(folder, course)
        old_records = {student: _read_record(out, student) for student in course.sheets}
        records = _mark_all(folder, out, course, jobs, again=again, report=report)
        rows = []
        for student, record in records.items():
            marks = _apply_marks_by_hand(course, record["marks"], by_hand.get(student, {}))
            _remember_marks(out, student, record, marks)
            rows.append(_make_row(course, student, marks, late[student], record["note"]))
            text = (
                _format_hints(course, student, marks, record, hints)
                if hints
                else _format_feedback(course, student, marks, record)
            )
            store.write_text(out / student / "feedback.txt", text)
        _write_tables(folder, out, course, rows, by_hand)
        changes = [c for s in records for c in _list_changes(s, old_records[s], records[s])]
        if changes:
            store.write_text(out / "changes.csv", format_csv(changes))
    return GradingResult(rows, changes)


def _write_tables(
    folder: Path, out: Path, course: Course, rows: Rows, by_hand: Mapping[str, MarksByHand]
) -> None:
    """Write grades.csv, the tables for platforms, and marks.csv to fill in."""
    store.write_text(out / "grades.csv", format_csv(rows))
    for platform, table in make_exports(course, rows).items():
        store.write_text(out / f"grades-{platform}.csv", format_csv(table))
    if course.by_hand:
        to_fill_in = _list_marks_by_hand(folder, course, by_hand)
        store.write_text(out / _MARKS, format_csv(to_fill_in))


def _mark_all(
    folder: Path, out: Path, course: Course, jobs: int, *, again: bool, report: Callable
) -> dict[str, Record]:
    """Mark all students by several processes.

    A hand-in that breaks its process is marked alone, and its record says so.
    """
    single_courses = {
        s: replace(course, secret="", sheets={s: x}) for s, x in course.sheets.items()
    }
    records = dict[str, Record]()
    broken = False
    with make_pool(jobs, __name__) as pool:
        futures: dict[Future, str] = {
            pool.submit(mark_student, folder, out, single, again): student
            for student, single in single_courses.items()
        }
        for future in as_completed(futures):
            try:
                records[futures[future]] = future.result()
                report(f"{len(records)} of {len(single_courses)} marked")
            except BrokenProcessPool:
                broken = True
    for student in single_courses if broken else ():
        if student not in records:
            records[student] = _mark_in_new_process(folder, out, single_courses[student], again)
    return {student: records[student] for student in course.sheets}


def _mark_in_new_process(folder: Path, out: Path, course: Course, again: bool) -> Record:
    """Mark a student in a process of its own."""
    try:
        with make_pool(1, __name__) as pool:
            return pool.submit(mark_student, folder, out, course, again).result()
    except BrokenProcessPool:
        (student,) = course.sheets
        record = make_record(course, student, HandIn(trouble=_STOPPED))
        return _save_record(out, student, record, _read_record(out, student), is_handed_in=True)


def mark_student(folder: Path, out: Path, course: Course, again: bool = False) -> Record:
    """Mark the only student of a course, unless nothing changed since the last marking."""
    (student,) = course.sheets
    stored, digest = _read_record(out, student), ""
    is_handed_in = True
    try:
        files = [f for f in read_files(folder / student) if not f.name.startswith(".")]
        files += read_unread_files(folder / student)
        digest = _make_digest(files, course.sheets[student])
        if stored and stored["digest"] == digest and not again:
            return stored
        hand_in = read_hand_in(files, course.sheet(student).parts)
        is_handed_in = bool(hand_in.answers) or any(file.name != NOTEBOOK_FILE for file in files)
        record = make_record(course, student, hand_in, digest)
    except Exception as error:  # a hand-in may raise exceptions that nobody expected
        trouble = f"{_STOPPED} ({type(error).__name__})"
        record = make_record(course, student, HandIn(trouble=trouble), digest)
    return _save_record(out, student, record, stored, is_handed_in)


def make_record(course: Course, student: str, hand_in: HandIn, digest: str = "") -> Record:
    """Mark the answers of a hand-in, unless they belong to another sheet."""
    other = compare_sheet_names(
        hand_in.answers.get(SHEET_ANSWER), store.name_sheet(course, student)
    )
    marks = mark_sheet(course.sheet(student), {} if other else hand_in.answers)
    note = "; ".join(filter(None, [other, hand_in.trouble]))
    return {"digest": digest, "marks": [vars(mark) for mark in marks], "note": note}


def _save_record(
    out: Path, student: str, record: Record, stored: Record | None, is_handed_in: bool
) -> Record:
    """Save a record, which counts each hand-in that differs from the previous one."""
    is_same = stored is not None and stored["digest"] == record["digest"]
    record["hand_ins"] = (stored or {}).get("hand_ins", 0) + (is_handed_in and not is_same)
    record["given"] = stored.get("given", {}) if stored and is_same else {}
    _write_record(out, student, record)
    return record


def _remember_marks(out: Path, student: str, record: Record, marks: Marks) -> None:
    """Append each part's mark to the earlier marks of this hand-in, if it differs from the last."""
    changed = False
    for mark in marks:
        given = record.setdefault("given", {}).setdefault(mark["part"], [])
        if mark["message"] != _NOT_MARKED and (not given or given[-1]["credit"] != mark["credit"]):
            given.append({"credit": mark["credit"], "why": mark["message"]})
            changed = True
    if changed:
        _write_record(out, student, record)


def _write_record(out: Path, student: str, record: Record) -> None:
    store.write_text(out / student / "mark.json", store.format_json(record))


def _read_record(out: Path, student: str) -> Record | None:
    try:
        record = json.loads((out / student / "mark.json").read_bytes())
        return record if {"digest", "marks", "note", "hand_ins"} <= {*record} else None
    except (OSError, ValueError, TypeError):
        return None


def _make_digest(files: Iterable[HandedFile], sheet: Mapping[str, Any]) -> str:
    """Return a digest of a sheet and of the contents of files, but not of the files' dates."""
    digest = hashlib.sha256(json.dumps(sheet, sort_keys=True).encode())
    for file in files:
        text = f"{file.name}\n{file.trouble}\n{len(file.content)}\n"
        digest.update(text.encode(errors="surrogateescape") + file.content)
    return digest.hexdigest()


# Marks by hand


def read_marks_by_hand(folder: Path, course: Course) -> dict[str, MarksByHand]:
    """Read the points given by hand in marks.csv, by student and part.

    Without the file there are none, and a line without points is a part that is not marked yet.

    Raises ArmError with every line that names no student, no part or no points of it.
    """
    path, old = folder / _MARKS, folder / "overrides.csv"
    if old.exists():
        raise ArmError(
            f"{old} is of an earlier edition; expected {_MARKS}, which has the columns id, part,"
            " points (credit times the weight of the part) and remark"
        )
    marks, problems = dict[str, MarksByHand](), list[str]()
    for line, row in read_csv_rows(path) if path.exists() else ():
        student, part, points, remark = (row.get(x, "") for x in ("id", "part", "points", "remark"))
        if student not in course.sheets or part not in course.part_names:
            problems.append(f"line {line}: no student {student!r} with the part {part!r}")
            continue
        if not points:
            continue
        weight = course.weight(part)
        try:
            value = float(points.replace(",", "."))
        except ValueError:
            value = -1.0
        if not 0 <= value <= weight:
            expected = f"expected a number from 0 to {weight:g}"
            problems.append(f"line {line}: points is {points!r}; {expected}")
            continue
        marks.setdefault(student, {})[part] = value / (weight or 1), remark
    if problems:
        raise ArmError(f"{path} cannot be used; {'; '.join(problems)}")
    return marks


def _list_marks_by_hand(folder: Path, course: Course, by_hand: Mapping[str, MarksByHand]) -> Rows:
    """List for each student the parts marked by hand, with points, remark and files, to fill in."""
    rows = []
    for student in course.sheets:
        names = [file.name for file in read_files(folder / student) if file.name[0] != "."]
        for part in course.by_hand:
            credit, remark = by_hand.get(student, {}).get(part, (None, ""))
            points = "" if credit is None else round(credit * course.weight(part), 4)
            rows.append({"id": student, "part": part, "points": points, "remark": remark,
                         "files": "; ".join(names)})  # fmt: skip
    return rows


def read_marks(folder: Path, out: Path, course: Course) -> dict[str, list[dict[str, Any]]]:
    """Read the marks that `grade` stored or an instructor entered by hand, by student."""
    by_hand = read_marks_by_hand(folder, course)
    records = {student: _read_record(out, student) for student in course.sheets}
    return {
        s: _apply_marks_by_hand(course, x["marks"], by_hand.get(s, {}))
        for s, x in records.items()
        if x
    }


def read_late(folder: Path, course: Course) -> dict[str, str]:
    """Read the remark on each student's lateness; it is "" if the hand-in counts as in time.

    A line of late.csv counts before the platform's mark, so that an empty cell is an extension.
    Raises ArmError with every line that names no student.
    """
    late = {s: "late" if (folder / s / LATE_FILE).exists() else "" for s in course.sheets}
    path = folder / _LATE
    rows = [*read_csv_rows(path)] if path.exists() else []
    unknown = [f"line {n}: no student {r.get('id')!r}" for n, r in rows if r.get("id") not in late]
    if unknown:
        raise ArmError(f"{path} cannot be used; {'; '.join(unknown)}")
    return late | {row["id"]: row.get("late", "") for _, row in rows}


def _apply_marks_by_hand(course: Course, marks: Marks, by_hand: MarksByHand) -> list[dict]:
    """Add the parts marked by hand, and replace the judge's credit by credit given by hand."""
    parts = [{"part": part, "credit": 0.0, "message": _NOT_MARKED} for part in course.by_hand]
    result = [dict(mark) for mark in (*marks, *parts)]
    for mark in result:
        if mark["part"] in by_hand:
            mark["credit"], remark = by_hand[mark["part"]]
            judged = "" if mark["part"] in course.by_hand else f"\n{mark['message']}"
            mark["message"] = f"Marked by hand: {remark or 'no remark is given'}{judged}"
    return result


# Files that are written


def _make_row(course: Course, student: str, marks: Marks, late: str, note: str) -> dict[str, Any]:
    """Make a student's row of grades.csv."""
    credits = {
        mark["part"]: "" if mark["message"] == _NOT_MARKED else round(mark["credit"], 4)
        for mark in marks
    }
    columns = {"id": student, "name": course.names[student], "total": compute_total(course, marks)}
    return {**columns, **credits, "late": late, "note": note}


def compute_total(course: Course, marks: Marks) -> float:
    """Compute the weighted sum of credits, to four decimals."""
    return round(sum(course.weight(mark["part"]) * mark["credit"] for mark in marks), 4)


def make_exports(course: Course, rows: Rows) -> dict[str, list[dict[str, Any]]]:
    """Make the tables of totals that Canvas and Moodle import, by platform.

    Canvas (lib/gradebook_importer.rb of instructure/canvas-lms) expects five columns about the
    student, finds students by the login where the ID is empty, and takes the points possible from
    a row of that name. Moodle (docs.moodle.org, Grade import) asks for the meaning of each column.
    """
    columns = dict.fromkeys(("Student", "ID", "SIS User ID", "SIS Login ID", "Section"), "")
    max_total = sum(map(course.weight, course.part_names))
    canvas = [{**columns, "Student": "    Points Possible", course.title: max_total}]
    totals = [{course.title: row["total"]} for row in rows]
    pairs = [*zip(rows, totals, strict=True)]
    canvas += [{"Student": row["name"], "SIS Login ID": row["id"], **x} for row, x in pairs]
    moodle = [{"Username": row["id"], **x} for row, x in pairs]
    return {"canvas": canvas, "moodle": moodle}


def _format_feedback(course: Course, student: str, marks: Marks, record: Record) -> str:
    """Return the reasons for each mark, without the solution, and the earlier marks."""
    parts = course.sheet(student).parts
    total, max_total = compute_total(course, marks), sum(map(course.weight, course.part_names))
    lines = [f"{course.title}, {course.names[student]} ({student}): {total:.4g} of {max_total:g}"]
    lines += [f"Note: {record['note']}."] if record["note"] else []
    for mark in marks:
        part, weight = mark["part"], course.weight(mark["part"])
        description = parts[part].description if part in parts else "what is marked by hand"
        lines += ["", f"{part}: {weight * mark['credit']:.3g} of {weight:g} for {description}"]
        lines += [f"    {line}" for line in mark["message"].splitlines()]
        for earlier in record["given"][part][:-1]:
            points = f"{weight * earlier['credit']:.3g} of {weight:g}"
            lines.append(f"    Earlier mark: {points}. {' '.join(earlier['why'].split())}")
    return "\n".join(lines) + "\n"


def _format_hints(
    course: Course, student: str, marks: Marks, record: Record, max_hints: int
) -> str:
    """Return the hints that a student gets for the first hand-ins before the deadline."""
    lines = [f"{course.title}, {course.names[student]} ({student}): before the deadline"]
    lines += [f"Note: {record['note']}."] if record["note"] else []
    lines += list_hints(marks, record["hand_ins"], max_hints)
    return "\n".join(lines) + "\n"


def list_hints(marks: Marks, hand_ins: int, max_hints: int) -> list[str]:
    """Return a line with the hint for each part, or a note after `max_hints` hand-ins."""
    if hand_ins > max_hints:
        return [f"Hints are given for {max_hints} hand-ins; this one is read after the deadline."]
    return [f"{mark['part']}: {mark['hint']}" for mark in marks if "hint" in mark]


def _list_changes(student: str, old: Record | None, new: Record) -> list[dict[str, Any]]:
    """List the parts whose credit changed although the hand-in did not."""
    if not old or old["digest"] != new["digest"]:
        return []
    before = {mark["part"]: mark["credit"] for mark in old["marks"]}
    changed = [mark for mark in new["marks"] if before.get(mark["part"]) != mark["credit"]]
    return [
        {"id": student, "part": mark["part"], "before": before.get(mark["part"]),
         "now": mark["credit"], "why": mark["message"].replace("\n", " ")}
        for mark in changed
    ]  # fmt: skip


def format_csv(rows: Rows) -> str:
    """Format rows as CSV (RFC 4180), so that spreadsheets read no text as a formula."""
    file = io.StringIO()
    names = list(dict.fromkeys(name for row in rows for name in row))
    writer = csv.DictWriter(file, names, restval="")
    writer.writeheader()
    for row in rows:
        texts = {k: _FORMULA_START.sub(r"\1'", x) for k, x in row.items() if isinstance(x, str)}
        writer.writerow({**row, **texts})
    return file.getvalue()
