"""Marks into the files that schools use: a plain table, exports of Canvas and Moodle, Gradescope's
JSON.
"""

import csv
import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from helpers.course.marking import Mark
from helpers.course.store import as_json, write
from helpers.inputs import ArmError

# A spreadsheet runs a cell that begins with one of these (OWASP, CSV injection).
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n", "|", "%")


def safe(text: str) -> str:
    """A text that no spreadsheet takes for a formula."""
    return f"'{text}" if text.startswith(_FORMULA) else text


def table(rows: Sequence[Mapping[str, Any]]) -> str:
    """CSV of rows with the same keys, line ends as RFC 4180 wants; every word made safe."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(rows[0]))
    writer.writeheader()
    writer.writerows(
        {k: safe(v) if isinstance(v, str) else v for k, v in row.items()} for row in rows
    )
    return file.getvalue()


def grade_row(student: str, name: str, marks: Sequence[Mark], trouble: str) -> dict[str, Any]:
    """A student's line: id, name, total, a column for each part, and what went wrong."""
    credits = {mark.part: round(mark.credit, 4) for mark in marks}
    total = round(sum(credits.values()), 4)
    return {"id": student, "name": name, "total": total, **credits, "note": trouble}


def fill_canvas(export: str, totals: Mapping[str, float], assignment: str) -> str:
    """A Canvas gradebook export with one column filled, matched by SIS login, SIS user id or name.

    The column is the one whose heading begins with the assignment's name. Rows that match nobody
    stay as they are; one of a student that ends early gets empty cells. Raises ArmError where the
    export lacks a column, naming it.
    """
    rows = _read(export)
    head = rows[0]
    for needed in ("Student", "ID"):
        if needed not in head:
            raise ArmError(
                f"the Canvas export has the columns {', '.join(head)}; expected {needed}"
            )
    columns = [i for i, title in enumerate(head) if title.split(" (")[0] == assignment]
    if len(columns) != 1:
        raise ArmError(
            f"the Canvas export has {len(columns)} columns called {assignment!r}; expected one;"
            f" it has {', '.join(head)}"
        )
    keys = [head.index(k) for k in ("SIS Login ID", "SIS User ID", "Student") if k in head]
    for row in rows[1:]:
        for key in keys:
            if key < len(row) and row[key] in totals:
                row += [""] * (len(head) - len(row))
                row[columns[0]] = f"{totals[row[key]]:g}"
                break
    return _written(rows)


def fill_moodle(export: str, totals: Mapping[str, float], maximum: float) -> str:
    """A Moodle grading worksheet with grades filled, matched by the e-mail address, its part before
    @, or the full name; grades are scaled from `maximum` to the worksheet's where a row gives
    one. Raises ArmError where a column is missing.
    """
    rows = _read(export)
    head = rows[0]
    for needed in ("Identifier", "Grade", "Maximum Grade", "Last modified (grade)"):
        if needed not in head:
            raise ArmError(
                f"the Moodle worksheet has the columns {', '.join(head)}; expected {needed} (the"
                " importer wants the language of the site to be English)"
            )
    grade, most = head.index("Grade"), head.index("Maximum Grade")
    for row in rows[1:]:
        names = dict(zip(head, row, strict=False))
        mail = names.get("Email address", "")
        for key in (mail, mail.split("@")[0], names.get("Full name", "")):
            if key in totals:
                row += [""] * (len(head) - len(row))
                row[grade] = f"{totals[key] / maximum * float(row[most] or maximum):.2f}"
                break
    return _written(rows)


def _read(export: str) -> list[list[str]]:
    rows = list(csv.reader(io.StringIO(export.removeprefix("\ufeff"))))
    if not rows:
        raise ArmError("the export is empty; expected a line of headings")
    return rows


def _written(rows: Sequence[Sequence[str]]) -> str:
    file = io.StringIO()
    csv.writer(file).writerows(rows)
    return file.getvalue()


def gradescope(marks: Sequence[Mark], trouble: str) -> dict[str, Any]:
    """Marks as Gradescope's results.json: one test a part, its words as output."""
    tests = [
        {
            "name": mark.part,
            "number": str(number),
            "score": round(mark.credit, 4),
            "max_score": 1.0,
            "status": "passed" if mark.credit == 1 else "failed",
            "output": mark.words,
            "output_format": "text",
            "visibility": "visible",
        }
        for number, mark in enumerate(marks, 1)
    ]
    score = round(sum(mark.credit for mark in marks), 4)
    output = trouble or "Every part is judged below."
    return {"score": score, "output": output, "output_format": "text", "tests": tests}


def read_results(folder: Path) -> dict[str, Any]:
    """results.json of a folder; empty where there is none or it cannot be read."""
    try:
        found = json.loads((folder / "results.json").read_bytes())
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def write_results(folder: Path, results: Mapping[str, Any]) -> None:
    """results.json into a folder."""
    write(folder / "results.json", as_json(results))
