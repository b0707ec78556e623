"""Test that nothing depends on the working folder or on the operating system."""

import json
import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path, PurePosixPath
from string import Template

import nbformat
import numpy as np
import pytest

from tools.numbering import list_notebooks

ROOT = Path(__file__).parents[1]
ELSEWHERE = ROOT / "tools/elsewhere"
NOTEBOOKS = list_notebooks()
LISTED = subprocess.run(
    ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False, encoding="utf-8"
).stdout.split("\0")[:-1]
COPY = [path.relative_to(ROOT).as_posix() for path in ROOT.glob("helpers/**/*.py")]
FILES = sorted(set(LISTED or COPY))  # a copy of the project without a repository
RESERVED = {
    "con",
    "prn",
    "aux",
    "nul",
    *(f"{port}{n}" for port in ("com", "lpt") for n in range(1, 10)),
}


def code(path):
    cells = nbformat.read(path, as_version=4).cells
    return "\n".join(cell.source for cell in cells if cell.cell_type == "code")


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_opens_no_files(path):
    """A notebook that opens no files runs in any folder.

    The instructors' page writes files of a course, but only in a temporary folder.
    """
    text = code(path)
    if path.stem == "instructors":
        before, after = text.split("folder = TemporaryDirectory()\nos.chdir(folder.name)\n")
        assert not re.search(r"(?<![.\w])Path\(", before)
        text = re.sub(r"(?<![.\w])Path\((?=\")", "", before + after)
    assert not re.search(
        r"\bopen\(|(?<![.\w])Path\(|savefig|np\.(load|save)|os\.|sys\.path|%cd", text
    )


def test_file_names_are_valid_on_windows():
    assert "helpers/arm.py" in FILES
    for name in FILES:
        assert len(name) < 150, name
        for part in PurePosixPath(name).parts:
            assert not re.search(r'[<>:"|?*\\]|[. ]$', part), name
            assert part.split(".")[0].casefold() not in RESERVED, name
    assert max(Counter(map(str.casefold, FILES)).values()) == 1, "two names differ by case alone"


def test_simulated_processor_changes_only_the_last_digit():
    """`make test` runs the notebooks in the kernel of this simulation."""
    kernel = ELSEWHERE / "kernels/elsewhere/kernel.json"
    simulation = json.loads(kernel.read_text(encoding="utf-8"))["env"]
    assert simulation.keys() == {"OPENBLAS_CORETYPE", "PYTHONPATH"}
    simulation = {
        key: Template(x).substitute(JUPYTER_PATH=ELSEWHERE) for key, x in simulation.items()
    }
    code = "from math import sin; import numpy as np; x = np.arange(1.0, 99.0);"
    code += "print(*np.cos(x).tolist(), *map(sin, x), np.einsum('i,i', x, x / 7), np.sin(0.0))"

    def run_code(environment):
        done = subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | environment,
            capture_output=True,
            check=True,
            text=True,
        )
        return np.array(done.stdout.split(), float)

    here, there = run_code({}), run_code(simulation)
    units = np.abs(there - here) / np.spacing(np.abs(here))
    assert 1 <= units.max() <= 2
    assert 50 < (units > 0).sum() < 170
    assert (there == run_code(simulation)).all()
