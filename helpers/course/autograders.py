"""The same marking inside other systems: Gradescope, nbgrader."""

import json
import shutil
import sys
from collections.abc import Mapping
from dataclasses import replace
from importlib.metadata import requires
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import helpers
from helpers.course import making, store
from helpers.course.answers import PREFIX, collected
from helpers.course.arms import from_json, to_json
from helpers.course.files import within
from helpers.course.handed_in import read_hand_in
from helpers.course.marking import mark, mark_sheet
from helpers.course.roster import People
from helpers.course.store import Course
from helpers.variants import Sheet

# Gradescope (docs/specs.md of gradescope/autograder_samples): the zip's root holds setup.sh and the
# executable run_autograder; what it must write is /autograder/results/results.json.
_FILES = {
    "setup.sh": """#!/usr/bin/env bash
set -euo pipefail
cd /autograder/source
python=python3
if ! $python -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
  apt-get update -qq && apt-get install -y -qq python3.11 python3.11-venv
  python=python3.11
elif ! $python -c 'import ensurepip'; then
  apt-get update -qq && apt-get install -y -qq python3-venv
fi
$python -m venv /autograder/env
/autograder/env/bin/pip install --quiet -r requirements.txt
""",
    "run_autograder": """#!/usr/bin/env bash
cd /autograder/source
exec /autograder/env/bin/python -m helpers.course.autograders /autograder
""",
    "requirements.txt": "{needed}\n",
}


def gradescope_zip(course: Course, path: Path) -> None:
    """Gradescope's autograder: the course without its secret, the helpers, set-up and start.

    Only answers.json is read there, so no student's program runs where the course lies. Raises
    ModuleNotFoundError where the helpers are not installed, so that nothing says what they need.
    """
    needs = requires("manipulator-homework-helpers") or ()
    needed = [need for need in needs if "extra ==" not in need]
    with TemporaryDirectory() as folder:
        root = Path(folder)
        shutil.copytree(
            Path(helpers.__file__).parent, root / "helpers",
            ignore=shutil.ignore_patterns("__pycache__"),
        )  # fmt: skip
        store.write(root / store.FILE, store.text(replace(course, secret="")))
        for name, text in _FILES.items():
            store.write(root / name, text.format(needed="\n".join(needed)))
            (root / name).chmod(0o755)
        shutil.make_archive(str(path.with_suffix("")), "zip", root)


def run_gradescope(root: Path) -> dict[str, Any]:
    """Mark the one submission under /autograder, and write results/results.json, always."""
    try:
        found = _gradescope_results(root)
    except Exception as error:  # Gradescope calls a crash its own failure; say it in words instead
        words = f"Marking stopped ({type(error).__name__}); please tell your instructor."
        found = {"score": 0, "output": words, "tests": []}
    store.write(root / "results" / "results.json", store.as_json(found))
    return found


def _gradescope_results(root: Path) -> dict[str, Any]:
    course = store.load(root / "source")
    users = json.loads((root / "submission_metadata.json").read_bytes())["users"]
    told = [str(user.get(key, "")) for user in users for key in ("email", "name")]
    meant = People(course.names).called(told)
    if len(meant) != 1:
        who = "More than one sheet" if meant else "No sheet"
        words = f"{who} of this course belongs to your name and e-mail address"
        return {"score": 0, "output": f"{words}; tell your instructor.", "tests": []}
    student = meant.pop()
    sheet = course.sheet(student)
    handed = read_hand_in(within(root / "submission"), sheet.parts)
    marks = mark_sheet(sheet, handed.answers)
    tests = [
        {"name": m.part, "score": round(m.credit, 4), "max_score": 1.0, "output": m.words}
        for m in marks
    ]
    words = f"Marked as the sheet of {student}. {handed.trouble or 'Every part is judged below.'}"
    score = round(sum(m.credit for m in marks), 4)
    return {"score": score, "output": words, "tests": tests}


def nbgrader_notebook(course: Course, student: str) -> dict[str, Any]:
    """A source notebook for `nbgrader generate_assignment`: one student's sheet for everybody.

    Each answer cell is a solution; the locked cell after it holds a hidden test whose last line is
    the credit, which nbgrader takes as partial points.
    """
    sheet, cells = course.sheet(student), list[dict[str, Any]]()
    entry = {**course.sheets[student], "name": "One sheet for everybody"}
    book = making.notebook(replace(course, sheets={"all": entry}), "all")
    for cell in book["cells"]:
        name = cell["id"].removeprefix("answer-").replace("-", "_")
        if name in sheet.parts:
            stub = f"### BEGIN SOLUTION\n{PREFIX}{name} = None\n### END SOLUTION"
            comment = cell["source"].splitlines()[0]
            cells.append(_marked({**cell, "source": f"{comment}\n{stub}"}, solution=True))
            cells.append(_marked(_test(sheet, name), locked=True, grade=True, points=1))
        elif cell["id"] not in ("hand-in", "write"):
            cells.append(_marked(cell, locked=True) if cell["id"] == "setup" else cell)
    return {**book, "cells": cells}


def _marked(cell: dict[str, Any], **kind: Any) -> dict[str, Any]:
    about: dict[str, Any] = dict.fromkeys(("grade", "solution", "task", "locked"), False)
    about |= {"schema_version": 3, "grade_id": cell["id"], **kind}
    return {**cell, "metadata": {**cell["metadata"], "nbgrader": about}}


def _test(sheet: Sheet, name: str) -> dict[str, Any]:
    stored = {"arm": to_json(sheet.arm), "drawn": dict(sheet.drawn)}
    code = (
        "### BEGIN HIDDEN TESTS\nfrom helpers.course.autograders import credit\n\n"
        f"stored = {stored!r}\ncredit({name!r}, {PREFIX}{name}, stored)\n"
        "### END HIDDEN TESTS"
    )
    return making.code_cell(f"test-{name}", code)


def credit(name: str, answer: Any, stored: Mapping[str, Any]) -> float:
    """The credit of one answer, for nbgrader's hidden tests: as if it had been handed in."""
    sheet = Sheet(from_json(stored["arm"]), stored["drawn"])
    typed = json.loads(collected({f"{PREFIX}{name}": answer}))
    return mark(sheet, name, typed.get(name)).credit


if __name__ == "__main__":
    run_gradescope(Path(sys.argv[1]))
