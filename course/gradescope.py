"""Mark inside Gradescope, as the command `grade` does."""

import json
import shutil
import sys
from dataclasses import replace
from importlib.metadata import requires
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import helpers
from course import store
from course.files import read_files
from course.grading import compute_total, list_hints, make_record
from course.handed_in import read_hand_in
from course.roster import StudentIndex
from course.store import Course

_SETTINGS = "settings.json"  # number of submissions for which a student gets hints
# Gradescope runs setup.sh and run_autograder in the zip's root. run_autograder must write
# /autograder/results/results.json (docs/specs.md of gradescope/autograder_samples).
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
exec /autograder/env/bin/python -m course.gradescope /autograder
""",
    "requirements.txt": "{needed}\n",
}


def pack_autograder(course: Course, path: Path, hints: int = 0) -> None:
    """Write Gradescope's autograder with the helpers and the course without its secret.

    A student's first `hints` submissions get hints. Parts marked by hand are not in it: Gradescope
    has questions of its own for them.

    Raises ModuleNotFoundError if the helpers are not installed.
    """
    requirements = requires("manipulator-homework-helpers") or ()
    needed = [requirement for requirement in requirements if "extra ==" not in requirement]
    with TemporaryDirectory() as folder:
        root = Path(folder)
        for package in (Path(helpers.__file__).parent, Path(__file__).parent):
            ignored = shutil.ignore_patterns("__pycache__")
            shutil.copytree(package, root / package.name, ignore=ignored)
        store.save_course(replace(course, secret="", by_hand={}), root)
        store.write_text(root / _SETTINGS, store.format_json({"hints": hints}))
        for name, text in _FILES.items():
            store.write_text(root / name, text.format(needed="\n".join(needed)))
            (root / name).chmod(0o755)
        shutil.make_archive(str(path.with_suffix("")), "zip", root)


def run_autograder(root: Path) -> dict[str, Any]:
    """Mark the submission in a folder such as /autograder, and always write results.json."""
    try:
        results = _mark_submission(root)
    except Exception as error:  # Gradescope would report a crash as its own failure
        message = f"Marking stopped ({type(error).__name__}); please tell your instructor."
        results = {"score": 0, "output": message, "tests": []}
    store.write_text(root / "results" / "results.json", store.format_json(results))
    return results


def _mark_submission(root: Path) -> dict[str, Any]:
    course = store.load_course(root / "source")
    metadata = json.loads((root / "submission_metadata.json").read_bytes())
    labels = [str(user.get(key, "")) for user in metadata["users"] for key in ("email", "name")]
    candidates = StudentIndex(course.names).find_students(labels)
    if len(candidates) != 1:
        sheet_count = "More than one sheet" if candidates else "No sheet"
        message = f"{sheet_count} of this course belongs to your name and e-mail address"
        return {"score": 0, "output": f"{message}; tell your instructor.", "tests": []}
    student = candidates.pop()
    hand_in = read_hand_in(read_files(root / "submission"), course.sheet(student).parts)
    record = make_record(course, student, hand_in)
    marks = record["marks"]
    # Gradescope hides the total score as long as a single test is hidden.
    tests = [
        {
            "name": mark["part"],
            "score": round(course.weight(mark["part"]) * mark["credit"], 4),
            "max_score": course.weight(mark["part"]),
            "output": mark["message"],
            "visibility": "after_published",
        }
        for mark in marks
    ]
    sheet_line = f"Read as the sheet of {student}: {record['note'] or 'every part was read'}."
    max_hints = int(json.loads((root / "source" / _SETTINGS).read_bytes())["hints"])
    number = 1 + len(metadata.get("previous_submissions") or ())
    hints = list_hints(marks, number, max_hints) if max_hints else []
    score = compute_total(course, marks)
    return {"score": score, "output": "\n".join([sheet_line, *hints]), "tests": tests}


if __name__ == "__main__":
    run_autograder(Path(sys.argv[1]))
