"""Run notebooks in place and store their outputs.

The command is `python -m tools.refresh book/02_jacobian.ipynb`. Outputs that differ
between machines are dropped. Then figures, formulas and exercises of the whole book are numbered
anew, with all links to them.
"""

import re
import sys
from itertools import pairwise
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from tools.citations import write_citations
from tools.numbering import find_mistakes, page_name, renumber
from tools.setup_note import write_setup_note

KERNEL = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
WIDGET = "application/vnd.jupyter.widget-view+json"
CAPTION = re.compile(r"(?m)^\*\*Fig\. ")
REPORTS_RESULT = re.compile(r"\b(check|print|display|compare_\w+)\(")


def hide_drawing_code(notebook: nbformat.NotebookNode) -> None:
    """Fold the code of each cell whose only result is a figure."""
    for cell, below in pairwise(notebook.cells):
        tags = cell.metadata.get("tags", [])
        if draws_only(cell, below) and "hide-input" not in tags:
            cell.metadata["tags"] = [*tags, "hide-input"]


def draws_only(cell: nbformat.NotebookNode, below: nbformat.NotebookNode) -> bool:
    """Return whether a cell has a caption below it and prints no result."""
    has_caption = below.cell_type == "markdown" and CAPTION.search(below.source)
    is_code = cell.cell_type == "code"
    return bool(is_code and has_caption and not REPORTS_RESULT.search(cell.source))


def write_derived_cells(notebook: nbformat.NotebookNode, path: Path) -> None:
    """Write the setup note, folds and citations of a notebook, which depend on its cells."""
    page = page_name(path)
    write_setup_note(notebook, page)
    hide_drawing_code(notebook)
    write_citations(notebook, "../" * page.count("/"))


def refresh_notebook(path: Path) -> None:
    """Run a notebook in its own folder and write it back with its outputs."""
    notebook = nbformat.read(path, as_version=4)
    about = {key: notebook.metadata[key] for key in ("myst",) if key in notebook.metadata}
    resources = {"metadata": {"path": path.parent}}
    NotebookClient(
        notebook, timeout=300, kernel_name="python3", resources=resources, coalesce_streams=True
    ).execute()
    notebook.metadata = {**KERNEL, **about}
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        for output in cell.get("outputs", []):
            output.get("data", {}).pop(WIDGET, None)  # a stored notebook has no live widget
            if "metadata" in output:
                output["metadata"] = {}
        if cell.cell_type == "code":
            cell.metadata.pop("jupyter", None)
    write_derived_cells(notebook, path)
    nbformat.write(notebook, path)


if __name__ == "__main__":
    for changed_path in renumber():
        print(f"renumbered {changed_path.name}")
    for name in sys.argv[1:]:
        refresh_notebook(Path(name))
        print(name)
    sys.exit("\n".join(find_mistakes()) or None)
