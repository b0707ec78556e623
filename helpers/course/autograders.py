"""The same marking inside other systems: Gradescope, nbgrader."""

import base64
import hashlib
import io
import json
import sys
import zipfile
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path
from typing import Any

import helpers
from helpers.course import gradebook, sheets, store
from helpers.course.answers import PREFIX, collected
from helpers.course.arms import from_json, to_json
from helpers.course.files import within
from helpers.course.handed_in import read_hand_in
from helpers.course.marking import Rules, mark, mark_sheet
from helpers.course.roster import People
from helpers.course.store import Course
from helpers.inputs import ArmError
from helpers.variants import Part, Sheet

_NAME = "manipulator-homework-helpers"

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
/autograder/env/bin/pip install --quiet ./*.whl
"""
_RUN = """#!/usr/bin/env bash
exec /autograder/env/bin/python -m helpers.course.autograders /autograder
"""


def gradescope_zip(course: Course, path: Path) -> None:
    """Gradescope's autograder: the course, the helpers as a wheel, set-up and start; no secret.

    Only answers.json is read there, so no student's program runs where the course lies.
    """
    name, packed = wheel()
    files = {name: packed, store.FILE: store.text(course).encode()}
    scripts = {"setup.sh": _SETUP.encode(), "run_autograder": _RUN.encode()}
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in {**scripts, **files}.items():
            entry = zipfile.ZipInfo(name)
            entry.external_attr = (0o100000 | (0o755 if name in scripts else 0o644)) << 16
            file.writestr(entry, content, zipfile.ZIP_DEFLATED)


def wheel() -> tuple[str, bytes]:
    """The helpers that run here as a wheel (PEP 427): its name and its content.

    Raises ArmError where they are not installed, so that nothing says what they need.
    """
    try:
        found = distribution(_NAME)
    except PackageNotFoundError:
        raise ArmError(f"{_NAME} is not installed; say pip install . in its folder") from None
    package, stem = Path(helpers.__file__).parent, f"{_NAME.replace('-', '_')}-{found.version}"
    info = f"{stem}.dist-info"
    needs = "".join(f"Requires-Dist: {words}\n" for words in found.requires or ())
    about = f"Metadata-Version: 2.1\nName: {_NAME}\nVersion: {found.version}\n{needs}"
    kind = "Wheel-Version: 1.0\nGenerator: helpers.course\nRoot-Is-Purelib: true\n"
    files = {
        f"helpers/{path.relative_to(package).as_posix()}": path.read_bytes()
        for path in sorted(package.rglob("*"))
        if path.is_file() and "__pycache__" not in path.parts
    }
    files |= {f"{info}/METADATA": about.encode()}
    files |= {f"{info}/WHEEL": f"{kind}Tag: py3-none-any\n".encode()}
    record = [f"{name},sha256={_digest(content)},{len(content)}" for name, content in files.items()]
    files[f"{info}/RECORD"] = "\n".join([*record, f"{info}/RECORD,,\n"]).encode()
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as file:
        for name, content in files.items():
            file.writestr(name, content)
    return f"{stem}-py3-none-any.whl", packed.getvalue()


def _digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def run_gradescope(root: Path) -> dict[str, Any]:
    """Mark the one submission that lies under /autograder, and write results/results.json,
    always.
    """
    try:
        results = _gradescope_results(root)
    except Exception as error:  # Gradescope calls a crash its own failure; say it in words instead
        words = f"Marking stopped ({type(error).__name__}); please tell your instructor."
        results = {"score": 0, "output": words, "tests": []}
    store.write(root / "results" / "results.json", store.as_json(results))
    return results


def _gradescope_results(root: Path) -> dict[str, Any]:
    course = store.load(root / "source")
    users = json.loads((root / "submission_metadata.json").read_bytes())["users"]
    people = People(course.names)
    meant = people.by_id(str(user.get("email", "")) for user in users)
    meant = meant or {s for user in users for s in people.by_name(str(user.get("name", "")))}
    if len(meant) != 1:
        who = "No sheet" if not meant else "More than one sheet"
        words = (
            f"{who} of this course belongs to your name and e-mail address; tell your instructor."
        )
        return {"score": 0, "output": words, "tests": []}
    student = meant.pop()
    sheet = course.unsigned(student)
    handed = read_hand_in(within(root / "submission"), sheet.parts)
    results = gradebook.gradescope(mark_sheet(sheet, handed.answers, course.rules), handed.trouble)
    return {**results, "output": f"Marked as the sheet of {student}. {results['output']}"}


def nbgrader_notebook(course: Course, sheet: Sheet) -> dict[str, Any]:
    """A source notebook for `nbgrader generate_assignment`: the same sheet for everybody.

    Each answer cell is a solution; the locked cell after it holds a hidden test whose last line is
    the credit, which nbgrader takes as partial points.
    """
    book = sheets.notebook(sheet, course, "all")
    cells = []
    for cell in book["cells"]:
        name = cell["id"].removeprefix("answer-").replace("-", "_")
        if name in sheet.parts:
            cells += [_solution(cell, sheet.parts[name]), _test(sheet, sheet.parts[name])]
        elif cell["id"] not in ("hand-in", "write"):
            cells.append(_marked(cell, locked=True) if cell["id"] == "setup" else cell)
    return {**book, "cells": cells}


def _marked(cell: dict[str, Any], **kind: Any) -> dict[str, Any]:
    about: dict[str, Any] = dict.fromkeys(("grade", "solution", "task", "locked"), False)
    about |= {"schema_version": 3, "grade_id": cell["id"], **kind}
    return {**cell, "metadata": {**cell["metadata"], "nbgrader": about}}


def _solution(cell: dict[str, Any], part: Part) -> dict[str, Any]:
    """nbgrader puts its stub in place of the solution; the line above it keeps the name."""
    lines = [f"# {PREFIX}{part.name}: {part.what}", "### BEGIN SOLUTION"]
    lines += [f"{PREFIX}{part.name} = None", "### END SOLUTION"]
    return _marked({**cell, "source": "\n".join(lines)}, solution=True)


def _test(sheet: Sheet, part: Part) -> dict[str, Any]:
    stored = {"arm": to_json(sheet.arm), "drawn": dict(sheet.drawn)}
    code = (
        "### BEGIN HIDDEN TESTS\nfrom helpers.course.autograders import credit\n\n"
        f"stored = {stored!r}\ncredit({part.name!r}, {PREFIX}{part.name}, stored)\n"
        "### END HIDDEN TESTS"
    )
    cell = sheets.code_cell(f"test-{part.name}", code)
    return _marked(cell, locked=True, grade=True, points=1)


def credit(name: str, answer: Any, stored: Mapping[str, Any]) -> float:
    """The credit of one answer, for nbgrader's hidden tests: as if it had been handed in."""
    sheet = Sheet(from_json(stored["arm"]), stored["drawn"])
    typed = json.loads(collected({f"{PREFIX}{name}": answer}))
    return mark(sheet, sheet.parts[name], typed.get(name), Rules()).credit


if __name__ == "__main__":
    run_gradescope(Path(sys.argv[1]))
