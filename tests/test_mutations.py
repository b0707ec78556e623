"""The net holds: one thing made wrong in a copy of the project turns the suite red.

Each case names a file, what to change in it, and the part of the suite that must notice. The unchanged copy must pass.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
NBVAL = ["--nbval", "--nbval-current-env", "-p", "no:xdist"]
CHAPTER = "book/01_dh_tables.ipynb"

MUTANTS = {
    "a cell's outputs emptied": (CHAPTER, r'("execution_count": )12,', r"\1null,", ["tests/test_notebooks.py"]),
    "a figure's words removed": (CHAPTER, r'"alt": "[^"]*"', '"alt": ""', ["tests/test_notebooks.py"]),
    "a sign in the recursion": ("helpers/kinematics.py", r"mixed\(c, x, s, y\)", "mixed(c, x, -s, y)", ["tests/test_kinematics.py"]),
    "an axis one too far": ("helpers/kinematics.py", r"frames\[i - 1\]\n", "frames[i]\n", ["tests/test_kinematics.py"]),
    "a sign in the polynomials": ("helpers/symbolic.py", r"\[s, c, zero\]", "[-s, c, zero]", ["tests/test_symbolic.py"]),
    "a digit of the Panda's table": ("helpers/robots.py", r"d_5=0\.384", "d_5=0.394", ["tests/test_kinematics.py"]),
    "a twist of the UR10e's table": (
        "helpers/robots.py", r'revolute\(alpha="-pi/2", d="d_1"', 'revolute(alpha="pi/2", d="d_1"', [*NBVAL, CHAPTER],
    ),
    "a checker that is always content": (
        "helpers/checks/line.py", r"difference <= tolerance", "True", ["tests/test_checks.py"],
    ),
    "a table checker that sees no lengths": (
        "helpers/checks/differences.py", r"abs\(mine\.length - reference\.length\) > WITHIN_LENGTH", "False", ["tests/test_tables.py"],
    ),
}  # fmt: skip


def run(folder: Path, arguments: list[str]) -> int:
    """pytest's exit code for part of the suite, in a copy of the project."""
    return pytest_in(folder, ["-x", *arguments]).returncode


def pytest_in(folder: Path, arguments: list[str]) -> subprocess.CompletedProcess:
    environment = {
        **os.environ,
        "PYTHONPATH": str(folder),
        "HYPOTHESIS_STORAGE_DIRECTORY": str(folder / ".h"),
    }
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False
    )


@pytest.fixture
def copy(tmp_path):
    for name in ("helpers", "tests", "book"):
        shutil.copytree(
            ROOT / name,
            tmp_path / name,
            ignore=shutil.ignore_patterns("_build", "vendor", "__pycache__"),
        )
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    return tmp_path


def test_the_unchanged_copy_passes(copy):
    """With `test_every_stored_output_counts`, where only the changed cells may turn red."""
    assert run(copy, ["tests/test_notebooks.py", "tests/test_checks.py"]) == 0


@pytest.mark.parametrize("mutant", MUTANTS)
def test_a_mutant_is_caught(copy, mutant):
    name, pattern, replacement, arguments = MUTANTS[mutant]
    text = (copy / name).read_text(encoding="utf-8")
    changed, count = re.subn(pattern, replacement, text, count=1)
    assert count == 1, "the mutation no longer fits the file"
    assert changed != text
    (copy / name).write_text(changed, encoding="utf-8")
    assert run(copy, arguments) == 1, "the suite did not notice"


@pytest.mark.parametrize("name", sorted(path.name for path in (ROOT / "book").glob("*.ipynb")))
def test_every_stored_output_counts(copy, name):
    """One character of one output of each cell is changed, the kinds taking turns: every such cell must turn red."""
    path = copy / "book" / name
    notebook = json.loads(path.read_text(encoding="utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    seen, changed = Counter(), set()
    for number, cell in enumerate(cells):
        if texts := list(stored_texts(cell)):
            kind, holder, key = min(texts, key=lambda text: seen[text[0]])
            holder[key] = other("".join(holder[key]))
            seen[kind] += 1
            changed.add(number)
    path.write_text(json.dumps(notebook), encoding="utf-8")
    report = pytest_in(copy, [*NBVAL, "-rf", f"book/{name}"]).stdout
    assert {int(n) for n in re.findall(r"FAILED book/\S+::Cell (\d+)", report)} == changed
    assert seen.keys() <= KINDS


KINDS = {"stdout", "text/plain", "text/markdown", "text/latex", "text/html", "image/svg+xml"}


def stored_texts(cell):
    """(kind, holder, key) of each output of a cell that can be told apart from another."""
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            yield output["name"], output, "text"
        for kind in output.get("data", {}):
            yield kind, output["data"], kind


def other(text: str) -> str:
    """The text with its last digit changed, or its last letter where it has none."""
    last = [*re.finditer(r"[a-z]", text), *re.finditer(r"\d", text)][-1]
    return text[: last.start()] + ("1" if last[0] == "0" else "0") + text[last.end() :]
