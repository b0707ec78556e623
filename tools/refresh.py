"""Execute notebooks in place and keep only what belongs to them: `python -m tools.refresh
book/02_jacobian.ipynb`."""

import re
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

from tools.citations import cite

KERNEL = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
WIDGET = "application/vnd.jupyter.widget-view+json"
FIGURE = re.compile(r"\[Fig\. [\d.]+\]\(#(fig-[\w-]+)\)")


def dress(notebook: nbformat.NotebookNode) -> None:
    """Hide the code of cells that only draw on the page, and solutions in JupyterLab too."""
    solution = False
    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            ends = re.findall(r"\{solution-(start|end)\}", cell.source)
            solution = ends[-1] == "start" if ends else solution
            continue
        cell.metadata.pop("jupyter", None)
        if solution:
            cell.metadata["jupyter"] = {"outputs_hidden": True, "source_hidden": True}
        tags = cell.metadata.get("tags", [])
        if draws_only(cell) and "hide-input" not in tags:
            cell.metadata["tags"] = [*tags, "hide-input"]


def draws_only(cell: nbformat.NotebookNode) -> bool:
    """Whether a cell's figure is all that there is to see of it."""
    says = re.search(r"\b(check|print|display|compare_\w+)\(", cell.source)
    return "figure" in cell.metadata.get("mystnb", {}) and not says


def figure_numbers(folder: Path) -> dict[str, str]:
    """The numbers that the built book gives the chapters' figures."""
    numbers = {}
    for path in sorted(folder.glob("[0-9][0-9]_*.ipynb")):
        cells = nbformat.read(path, as_version=4).cells
        figures = [cell.metadata.get("mystnb", {}).get("figure") for cell in cells]
        for place, figure in enumerate(filter(None, figures), start=1):
            numbers[figure.get("name")] = f"{int(path.name[:2])}.{place}"
    return numbers


def number_figures(notebook: nbformat.NotebookNode, numbers: dict[str, str]) -> None:
    """Write figures' numbers into the links to them: JupyterLab cannot count them."""

    def link(found: re.Match) -> str:
        return f"[Fig. {numbers[found[1]]}](#{found[1]})" if found[1] in numbers else found[0]

    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            cell.source = FIGURE.sub(link, cell.source)


def refresh(path: Path) -> None:
    """Run one notebook in its own folder and write it back, its metadata as in every other one."""
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
            output.get("data", {}).pop(WIDGET, None)  # without a kernel there is none
            if "metadata" in output:
                output["metadata"] = {}
    dress(notebook)
    number_figures(notebook, figure_numbers(path.parent))
    cite(notebook)
    nbformat.write(notebook, path)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        refresh(Path(name))
        print(name)
