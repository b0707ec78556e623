"""Run each notebook that lets a reader change an arm with a changed arm.

A reader may change a length, a mass or a limit in the cell `lengths` below a notebook's imports.
Run All must then reach the last cell, the numbers must follow, and a check of the book's own
numbers must only print a note. A notebook that needs a length other than 0 warns and goes on with
the book's. All changes take hours, so a law chooses: `make test` tries one change in two of the
notebooks, `make changed` every tenth change of every notebook. A notebook's checksum says where to
begin, so that an edited notebook is tried with other changes. `CHANGES=all` tries all of them.
"""

import ast
import os
from itertools import pairwise
from zlib import crc32

import nbformat
import pytest
from nbclient import NotebookClient

from helpers import robots
from tools.numbering import list_notebooks


def has_lengths(path):
    """Return whether a notebook has a cell in which a reader can change an arm's lengths."""
    cells = nbformat.read(path, as_version=4).cells
    return path.stem[:2].isdigit() or any(cell.id == "lengths" for cell in cells)


NOTEBOOKS = [path for path in list_notebooks() if has_lengths(path)]
STEP = {"all": 1, "tenth": 10}.get(os.environ.get("CHANGES", ""))
SAMPLE_SIZE = 2  # number of notebooks; each takes about 25 s of processor time
SHRUNK = "{name}.with_values(**{{key: 0.3 * x for key, x in {name}.values.items()}})"


def imported_names(path):
    """Return the names that a notebook's first cell imports, by module."""
    first = next(c for c in nbformat.read(path, as_version=4).cells if c.cell_type == "code")
    lines = (node for node in ast.parse(first.source).body if isinstance(node, ast.ImportFrom))
    return {line.module: [name.name for name in line.names] for line in lines}


def list_changes(name, uses_masses):
    """Yield every change of an arm as a line of code that a reader could type."""
    arm = getattr(robots, name)
    lengths = {key: value for key, value in arm.values.items() if value}
    yield SHRUNK.format(name=name)  # so that the circle is out of reach
    for key, next_key in pairwise(lengths):  # two neighbouring lengths are equal
        yield f"{name}.with_values({key}={lengths[next_key]:.6g})"
    for factor in (0, 0.5, 2):
        for key, value in lengths.items():
            yield f"{name}.with_values({key}={factor * value:.6g})"
        for number, body in enumerate(arm.bodies if uses_masses else (), 1):
            yield f"{name}.with_row({number}, mass={factor * body.mass:.6g})"
    for number, at in zip(arm.joints, arm.home, strict=True):
        yield f"{name}.with_row({number}, limits=({at - 0.3:.6g}, {at + 0.2:.6g}))"
    yield f"{name}.with_row({arm.joints[-1]}, speed=0.1, effort=0.1)"


def checksum(path):
    """Return a number that changes with the file."""
    return crc32(path.read_bytes())


def chosen_changes():
    """Yield notebook and changed line: one line of each sampled one, or every STEP-th of all."""
    sample = sorted(NOTEBOOKS, key=checksum)[:SAMPLE_SIZE]
    for path in NOTEBOOKS if STEP else sample:
        names = imported_names(path)
        arms = [name for name in names["helpers.robots"] if name.isupper()]
        uses_masses = "statics" in names["helpers"]
        lines = [
            f"{name} = {change}" for name in arms for change in list_changes(name, uses_masses)
        ]
        first = checksum(path)
        lines = lines[first % STEP :: STEP] if STEP else [lines[first % len(lines)]]
        yield from (pytest.param(path, line, id=f"{path.stem} {line}") for line in lines)


@pytest.mark.parametrize(("path", "line"), [*chosen_changes()])
def test_notebook_runs_with_changed_arm(path, line):
    notebook = nbformat.read(path, as_version=4)
    stored = [cell.get("outputs") for cell in notebook.cells]
    imports, below = [cell for cell in notebook.cells if cell.cell_type == "code"][:2]
    (below if below.id == "lengths" else imports).source += f"\n{line}"
    folder = {"metadata": {"path": path.parent}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=folder).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    printed = "\n".join(output.text for output in outputs if output.output_type == "stream")
    # The only warning that a notebook may print is that it needs a length other than 0.
    warned = [line for line in printed.split("\n") if "Warning:" in line]
    assert all("what follows needs" in line for line in warned), warned
    for mark in filter(lambda text: text.startswith("○"), printed.split("\n")):
        assert mark.endswith("it holds for the book's own numbers only")
    if "values" in line:
        assert stored != [cell.get("outputs") for cell in notebook.cells], "no output has changed"
