"""A reader's own copies of the notebooks, for JupyterLab: `python -m tools.lab my book/*.ipynb`.

JupyterLab runs no script of a text cell and knows no bibliography. So in a copy each small live
figure is a cell of code, a citation stands in words, and beside one figure of each chapter sliders
drive the chapter's own Python (`tools/sliders`). A copy that is there stays.
"""

import json
import re
import sys
from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell, new_markdown_cell

from helpers import robots
from tools.citations import in_words, listed

FIGURE = re.compile(
    r"<div class=\"arm-explorer\" data-figure=\"(\w+)\" data-options='(.*?)'>.*?</div>", re.S
)
CITATION = re.compile(r"\{footcite:p\}`([\w,]+)`")
LIST = re.compile(r"```\{(?:foot)?bibliography\}.*?```", re.S)
SLIDERS = Path(__file__).parent / "sliders"


def own_copy(path: Path) -> nbformat.NotebookNode:
    """A notebook of the book as a reader's own."""
    notebook = nbformat.read(path, as_version=4)
    texts = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    keys = dict.fromkeys(key for found in CITATION.findall(texts) for key in found.split(","))
    cited = "\n".join(map(listed, keys))
    cells = []
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = CITATION.sub(lambda found: f"({in_words(found[1])})", cell.source)
            cell.source = LIST.sub(lambda _: cited, cell.source)
        cells += alive(cell) if cell.cell_type == "markdown" else [cell]
    sliders = SLIDERS / f"{path.stem}.py"
    if sliders.exists():
        kind, code = sliders.read_text(encoding="utf-8").rstrip().split("\n", 1)
        figure = f'ArmFigure("{kind.removeprefix("# beside ")}"'
        place = next(i for i, cell in enumerate(cells) if figure in cell.source)
        cells.insert(place + 1, new_code_cell(code))
    notebook.cells = cells
    return notebook


def alive(cell: nbformat.NotebookNode) -> list[nbformat.NotebookNode]:
    """A text cell, cut where its figures stand, with a cell of code for each."""
    *parts, last = FIGURE.split(cell.source)
    cells = []
    for text, kind, options in zip(parts[::3], parts[1::3], parts[2::3], strict=True):
        cells += [new_markdown_cell(text.strip()), new_code_cell(figure(kind, json.loads(options)))]
    if not cells:
        return [cell]
    return [*cells, new_markdown_cell(last.strip())] if last.strip() else cells


def figure(kind: str, options: dict) -> str:
    """The lines that make a figure in Python."""
    arm = options.pop("arm", None)
    names = [name for name in robots.__all__ if getattr(getattr(robots, name), "name", "") == arm]
    given = [f'"{kind}"', *names, *(f"{name}={value!r}" for name, value in options.items())]
    imports = [f"from helpers.robots import {name}" for name in names]
    call = f"ArmFigure({', '.join(given)})"
    return "\n".join(["from helpers.explorer import ArmFigure", *imports, "", call])


def main(folder: Path, paths: list[Path]) -> None:
    """Write the copies that are missing in a folder, each whole or not at all."""
    folder.mkdir(exist_ok=True)
    for path in paths:
        if not (folder / path.name).exists():
            nbformat.write(own_copy(path), folder / ".copy")
            (folder / ".copy").replace(folder / path.name)


if __name__ == "__main__":
    main(Path(sys.argv[1]), [Path(path) for path in sys.argv[2:]])
