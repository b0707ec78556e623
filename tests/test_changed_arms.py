"""A reader may change an arm where a chapter takes it: a length, a mass, a limit. Run All then goes
to the last cell, numbers follow, and what held for the book's own arm only says so.

Each change is one more line in the chapter's first cell, and the chapter is really run. `make test`
tries one change of each chapter, which is another one whenever the chapter changes; `make changed`
tries them all.
"""

import ast
import os
from pathlib import Path
from zlib import crc32

import nbformat
import pytest
from nbclient import NotebookClient

from helpers import robots

CHAPTERS = sorted((Path(__file__).parents[1] / "book").glob("0*.ipynb"))
SHRUNK = "{name}.with_values(**{{key: 0.3 * x for key, x in {name}.values.items()}})"


def taken(path):
    """What a chapter takes from each module of the helpers, in its first cell."""
    first = next(c for c in nbformat.read(path, as_version=4).cells if c.cell_type == "code")
    lines = (node for node in ast.parse(first.source).body if isinstance(node, ast.ImportFrom))
    return {line.module: [name.name for name in line.names] for line in lines}


def changes(name, weighs):
    """Every change of an arm, as a reader writes it; of masses where the chapter `weighs` them."""
    arm = getattr(robots, name)
    yield SHRUNK.format(name=name)  # a circle as large as ever is then out of reach
    for factor in (0.7, 1.1):
        for key, value in arm.values.items():
            if value:
                yield f"{name}.with_values({key}={factor * value:.6g})"
        for number, body in enumerate(arm.bodies if weighs else (), 1):
            yield f"{name}.with_row({number}, mass={factor * body.mass:.6g})"
    for number, at in zip(arm.joints, arm.home, strict=True):
        yield f"{name}.with_row({number}, limits=({at - 0.3:.6g}, {at + 0.2:.6g}))"
    yield f"{name}.with_row({arm.joints[-1]}, speed=0.1, effort=0.1)"


def tried():
    for path in CHAPTERS:
        names = taken(path)
        arms, weighs = names["helpers.robots"], "statics" in names["helpers"]
        lines = [f"{name} = {change}" for name in arms for change in changes(name, weighs)]
        if os.environ.get("CHANGES") != "all":
            lines = [lines[crc32(path.read_bytes()) % len(lines)]]
        yield from (pytest.param(path, line, id=f"{path.stem[:2]} {line}") for line in lines)


@pytest.mark.parametrize(("path", "line"), [*tried()])
def test_chapter_runs_with_changed_arm(path, line):
    notebook = nbformat.read(path, as_version=4)
    stored = [cell.get("outputs") for cell in notebook.cells]
    next(cell for cell in notebook.cells if cell.cell_type == "code").source += f"\n{line}"
    place = {"metadata": {"path": path.parent}}
    NotebookClient(notebook, timeout=300, kernel_name="python3", resources=place).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    printed = "\n".join(output.text for output in outputs if output.output_type == "stream")
    assert "Warning" not in printed
    for mark in filter(lambda text: text.startswith("○"), printed.split("\n")):
        assert mark.endswith("it holds for the book's own numbers only")
    if "values" in line:
        assert stored != [cell.get("outputs") for cell in notebook.cells], "nothing has followed"
