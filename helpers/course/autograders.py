"""The same marking inside other systems: Gradescope, nbgrader, GitHub Classroom."""

import json
import sys
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import helpers
from helpers.course import gradebook, sheets, store
from helpers.course.answers import FILE, collected, read_hand_in
from helpers.course.arms import from_json, to_json
from helpers.course.marking import Mark, mark, mark_sheet
from helpers.course.store import Course
from helpers.variants import Part, Sheet

# Gradescope (docs/specs.md of gradescope/autograder_samples): the zip's root holds setup.sh and the
# executable run_autograder; what it must write is /autograder/results/results.json.
_SETUP = """#!/usr/bin/env bash
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
/autograder/env/bin/pip install --quiet './package[course]'
"""
_RUN = """#!/usr/bin/env bash
cd /autograder/source
exec /autograder/env/bin/python -m helpers.course.autograders /autograder
"""

CLASSROOM = """# Judges answers.json at each push and says what it found, without a key of the
# course: what counts is what the instructor's own `python -m helpers.course grade` says.
name: Homework
on: [push, workflow_dispatch]
permissions:
  contents: read
jobs:
  look:
    runs-on: ubuntu-latest
    timeout-minutes: 10
    steps:
      - uses: actions/checkout@v4
      - uses: actions/setup-python@v5
        with:
          python-version: "3.12"
      # Set HELPERS under Settings, Variables: what pip installs, such as the address of a wheel.
      - run: python -m pip install "${{ vars.HELPERS }}"
      - run: python -m helpers.course look .
"""


def gradescope_zip(course: Course, path: Path) -> None:
    """Gradescope's autograder: the course, the helpers, set-up and start; no secret and no key in
    it.

    Only answers.json is read there, so no student's program runs where the course lies.
    """
    package = Path(helpers.__file__).parent
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        _add(file, "setup.sh", _SETUP, 0o755)
        _add(file, "run_autograder", _RUN, 0o755)
        _add(file, store.FILE, store.text(course), 0o644)
        _add(file, "package/pyproject.toml", _PROJECT, 0o644)
        for source in sorted(package.rglob("*")):
            if source.is_file() and "__pycache__" not in source.parts:
                file.write(source, f"package/helpers/{source.relative_to(package).as_posix()}")


_PROJECT = """[build-system]
requires = ["setuptools>=77"]
build-backend = "setuptools.build_meta"

[project]
name = "manipulator-homework-helpers"
version = "0"
dependencies = ["numpy>=2.0", "sympy>=1.13", "matplotlib>=3.10"]

[project.optional-dependencies]
course = []

[tool.setuptools.packages.find]
include = ["helpers*"]

[tool.setuptools.package-data]
"*" = ["*"]
"""


def _add(file: zipfile.ZipFile, name: str, text: str, mode: int) -> None:
    entry = zipfile.ZipInfo(name)
    entry.external_attr = (0o100000 | mode) << 16
    file.writestr(entry, text, zipfile.ZIP_DEFLATED)


def run_gradescope(root: Path) -> dict[str, Any]:
    """Mark the one submission that lies under /autograder, and write results/results.json,
    always.
    """
    try:
        results = _gradescope_results(root)
    except Exception as error:  # Gradescope calls a crash its own failure; say it in words instead
        words = f"Marking stopped ({type(error).__name__}); please tell your instructor."
        results = {"score": 0, "output": words, "tests": []}
    gradebook.write_results(root / "results", results)
    return results


def _gradescope_results(root: Path) -> dict[str, Any]:
    course = store.load(root / "source")
    handed = read_hand_in(root / "submission", "nothing")
    student = _who(course, _metadata(root))
    if student is None:
        words = (
            "No sheet of this course belongs to your name, e-mail address or id;"
            " tell your instructor."
        )
        return {"score": 0, "output": words, "tests": []}
    marks = mark_sheet(course.unsigned(student), handed.answers, course.rules)
    results = gradebook.gradescope(marks, handed.trouble)
    return {**results, "output": f"Marked as the sheet of {student}. {results['output']}"}


def _metadata(root: Path) -> list[Mapping[str, Any]]:
    try:
        return list(json.loads((root / "submission_metadata.json").read_bytes())["users"])
    except (OSError, ValueError, KeyError, TypeError):
        return []


def _who(course: Course, users: list[Mapping[str, Any]]) -> str | None:
    """The id in the course that belongs to whoever submitted: by e-mail, its part before @, or
    name.
    """
    ids = {student.casefold(): student for student in course.sheets}
    names = {str(e["name"]).casefold(): s for s, e in course.sheets.items()}
    for user in users:
        mail, name = str(user.get("email", "")).casefold(), str(user.get("name", "")).casefold()
        for found in (ids.get(mail), ids.get(mail.split("@")[0]), names.get(name)):
            if found:
                return found
    return None


def nbgrader_notebook(course: Course, sheet: Sheet) -> dict[str, Any]:
    """A source notebook for `nbgrader generate_assignment`: the same sheet for everybody.

    Each answer cell is a solution; the locked cell after it holds a hidden test whose last line is
    the credit, which nbgrader takes as partial points.
    """
    book = sheets.notebook(sheet, course, "all", "One sheet for everybody")
    parts, cells = sheet.parts, []
    for cell in book["cells"]:
        name = cell["id"].removeprefix("answer-").replace("-", "_")
        if cell["cell_type"] != "code" or name not in parts:
            cells.append(_marked(cell, locked=True) if cell["id"] in ("setup",) else cell)
            continue
        cells += [_solution(cell, parts[name]), _test(sheet, parts[name])]
    return {**book, "cells": [cell for cell in cells if cell["id"] not in ("hand-in", "write")]}


def _marked(cell: dict[str, Any], *, locked: bool = False, **kind: Any) -> dict[str, Any]:
    about = {
        "grade": False,
        "solution": False,
        "task": False,
        "locked": locked,
        "schema_version": 3,
    }
    about |= {"grade_id": cell["id"], **kind}
    return {**cell, "metadata": {**cell["metadata"], "nbgrader": about}}


def _solution(cell: dict[str, Any], part: Part) -> dict[str, Any]:
    """nbgrader puts its stub in place of the solution; the line above it keeps the name."""
    lines = [f"# answer_{part.name}: {part.what}", "### BEGIN SOLUTION"]
    lines += [f"answer_{part.name} = None", "### END SOLUTION"]
    return _marked({**cell, "source": "\n".join(lines)}, solution=True)


def _test(sheet: Sheet, part: Part) -> dict[str, Any]:
    stored = {"arm": to_json(sheet.arm), "drawn": dict(sheet.drawn)}
    code = (
        "### BEGIN HIDDEN TESTS\nfrom helpers.course.autograders import credit\n\n"
        f"stored = {stored!r}\ncredit({part.name!r}, answer_{part.name}, stored)\n"
        "### END HIDDEN TESTS"
    )
    name = part.name.replace("_", "-")
    cell: dict[str, Any] = {"cell_type": "code", "id": f"test-{name}", "metadata": {}}
    cell |= {"outputs": [], "execution_count": None, "source": code}
    return _marked(cell, locked=True, grade=True, points=1)


def credit(name: str, answer: Any, stored: Mapping[str, Any]) -> float:
    """The credit of one answer, for nbgrader's hidden tests: as if it had been handed in."""
    sheet = Sheet(from_json(stored["arm"]), stored["drawn"])
    typed = json.loads(collected({f"answer_{name}": answer}))
    return mark(sheet, sheet.parts[name], typed.get(name), store.Rules()).credit


def look(folder: Path) -> tuple[str, tuple[Mark, ...]]:
    """What the checkers say of a folder's answers.json, by the sheet.json beside it; no secret is
    needed.

    The words, and the marks. A student can change sheet.json: nothing that counts is decided by
    this.
    """
    stored = json.loads((folder / sheets.FILE).read_bytes())
    sheet = Sheet(from_json(stored["arm"]), stored["drawn"])
    handed = read_hand_in(folder, "nothing")
    marks = mark_sheet(sheet, handed.answers, store.Rules())
    lines = [f"{m.part}: {m.credit:g}\n{m.words}\n" for m in marks]
    return "\n".join([*([f"{handed.trouble} ({FILE})"] if handed.trouble else []), *lines]), marks


if __name__ == "__main__":
    run_gradescope(Path(sys.argv[1]))
