"""Write the note below each notebook's title on how to get `helpers`.

`tools/refresh.py` writes it, with the addresses that `book/_config.yml` has by then. The pages
leave it out (tag `remove-cell`), since they are the readable book and run nothing.
"""

from pathlib import Path

import nbformat
import yaml

CONFIG = Path(__file__).parents[1] / "book/_config.yml"
CELL_ID = "setup-note"
PACKAGE = "manipulator-homework-helpers[explorer]"
IMPORT_COMMENT = "# If helpers is not installed, see the note below the notebook's title.\n"


def format_setup_note(
    page: str, book_address: str = "", repository: str = "", *, links_to_answers: bool = False
) -> str:
    """Return the note of a notebook.

    Args:
        page: the notebook's path in the book without its ending.
        book_address: where the book is published, with a slash at the end, if it is.
        repository: the address of the repository, if it has one.
        links_to_answers: whether the notebook links to answer sheets, which a build makes.
    """
    book = "*Robot homework companion*"
    if book_address:
        book = f"[{book}]({book_address}{page}.html), where it is easiest to read"
    source, hint = f"{PACKAGE} @ git+{repository}", ""
    if not repository:
        source = "./companion[explorer]"
        hint = ", with the folder of the book's repository in place of `./companion`"
    return (
        f"> A notebook of the {book}. Run it, change it, try things; *Run All* takes a minute."
        " It needs the package `helpers`, which `make lab` in the repository installs. Elsewhere"
        f" (Colab, VS Code, a folder of your own) run this in a new cell first{hint}:\n>\n"
        f'> ```\n> %pip install "{source}"\n> ```\n>\n'
        "> A file `helpers.py` of your own beside the notebook hides the package: rename it."
        + ("\n>\n> Its links to answer sheets work once the book is built." * links_to_answers)
    )


def read_addresses(config: Path = CONFIG) -> tuple[str, str]:
    """Return the addresses of the published book and of its repository, empty while not set."""
    settings = yaml.safe_load(config.read_text(encoding="utf-8"))
    return settings["html"]["baseurl"], settings["repository"]["url"]


def write_setup_note(notebook: nbformat.NotebookNode, page: str) -> None:
    """Write the note below the title, and a comment that points to it above the first import."""
    cells = [cell for cell in notebook.cells if cell.get("id") != CELL_ID]
    links_to_answers = any("answers/" in cell.source for cell in cells)
    text = format_setup_note(page, *read_addresses(), links_to_answers=links_to_answers)
    note = nbformat.v4.new_markdown_cell(text, id=CELL_ID)
    note.metadata["tags"] = ["remove-cell"]
    notebook.cells = [cells[0], note, *cells[1:]]
    code = next((cell for cell in cells if "from helpers" in cell.source), None)
    if code is not None and IMPORT_COMMENT not in code.source:
        code.source = code.source.replace("from helpers", f"{IMPORT_COMMENT}from helpers", 1)
