"""Execute notebooks in place and keep only what belongs to them: `python tools/refresh.py
book/*.ipynb`."""

import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

KERNEL = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
WIDGET = "application/vnd.jupyter.widget-view+json"


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
    nbformat.write(notebook, path)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        refresh(Path(name))
        print(name)
