"""Does the net hold where mutmut does not reach? Tables, figures' words, and every stored output.

Each case makes one thing wrong in a copy of the project, and the part of the suite that must notice
has to turn red; the unchanged copy must pass. `make mutants` runs it first.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
NBVAL = ["--nbval", "--nbval-current-env", "-p", "no:xdist"]
CHAPTER, ROBOTS = "book/01_dh_tables.ipynb", "helpers/robots.py"
NOTEBOOKS, KINEMATICS = ["tests/test_notebooks.py"], ["tests/test_kinematics.py"]

# What: the file, what to change in it, into what, and the tests that must notice.
CASES = {
    "a cell's outputs emptied": (CHAPTER, r'("execution_count": )12,', r"\1null,", NOTEBOOKS),
    "a figure's words removed": (CHAPTER, r'"alt": "[^"]*"', '"alt": ""', NOTEBOOKS),
    "a digit of the Panda's table": (ROBOTS, r"d_5=0\.384", "d_5=0.394", KINEMATICS),
    "a twist of the UR10e's table": (
        *(ROBOTS, r'revolute\(alpha="-pi/2", d="d_1"', 'revolute(alpha="pi/2", d="d_1"'),
        [*NBVAL, CHAPTER],
    ),
}


def main() -> None:
    with tempfile.TemporaryDirectory() as place:
        unseen = [case for case in cases(Path(place)) if case]
    print("\n".join(unseen) or "every break was noticed")
    sys.exit(bool(unseen))


def cases(place: Path) -> Iterator[str]:
    """What went unnoticed, or nothing, case by case."""
    if suite(copy(place), [*NOTEBOOKS, "tests/test_checks.py"]).returncode:
        yield "the unchanged copy fails"
    for what, (name, pattern, replacement, arguments) in CASES.items():
        folder = copy(place)
        text = (folder / name).read_text(encoding="utf-8")
        changed, count = re.subn(pattern, replacement, text, count=1)
        (folder / name).write_text(changed, encoding="utf-8")
        if not count or changed == text:
            yield f"{what}: the change no longer fits {name}"
        elif suite(folder, ["-x", *arguments]).returncode != 1:
            yield f"{what}: unnoticed"
    for path in sorted((ROOT / "book").glob("*.ipynb")):
        yield stored_outputs(copy(place), path.name)


def stored_outputs(folder: Path, name: str) -> str:
    """One character of one output of each cell changed, the kinds in turn: each must turn red."""
    path = folder / "book" / name
    notebook = json.loads(path.read_text(encoding="utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    seen: Counter[str] = Counter()
    changed = set()
    for number, cell in enumerate(cells):
        if texts := list(stored_texts(cell)):
            kind, holder, key = min(texts, key=lambda text: seen[text[0]])
            holder[key] = other("".join(holder[key]))
            seen[kind] += 1
            changed.add(number)
    path.write_text(json.dumps(notebook), encoding="utf-8")
    told = suite(folder, [*NBVAL, "-rf", f"book/{name}"]).stdout
    missed = changed - {int(n) for n in re.findall(r"FAILED book/\S+::Cell (\d+)", told)}
    return f"{name}: cells {sorted(missed)} may say anything" if missed else ""


def stored_texts(cell: dict) -> Iterator[tuple[str, dict, str]]:
    """The stored texts of a cell that nbval compares: their kind, and where they are."""
    for output in cell["outputs"]:
        if output["output_type"] == "stream":
            yield "stdout", output, "text"
        for kind in output.get("data", {}):
            yield kind, output["data"], kind


def other(text: str) -> str:
    """The text with its last letter or digit changed."""
    at = max(k for k, letter in enumerate(text) if letter.isalnum())
    return text[:at] + ("1" if text[at] != "1" else "2") + text[at + 1 :]


def copy(place: Path) -> Path:
    """A fresh copy of what the tests read."""
    folder = Path(tempfile.mkdtemp(dir=place))
    leave = shutil.ignore_patterns("_build", "vendor", "__pycache__")
    for name in ("helpers", "tests", "book"):
        shutil.copytree(ROOT / name, folder / name, ignore=leave)
    shutil.copy(ROOT / "pyproject.toml", folder)
    return folder


def suite(folder: Path, arguments: list[str]) -> subprocess.CompletedProcess[str]:
    """Part of the suite, run in a copy."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    own = {"PYTHONPATH": str(folder), "HYPOTHESIS_STORAGE_DIRECTORY": str(folder / ".h")}
    return subprocess.run(
        command, cwd=folder, env=os.environ | own, capture_output=True, text=True, check=False
    )


if __name__ == "__main__":
    main()
