"""Write citations, links such as `[Craig 2018](#craig2018)` to a list at a notebook's end.

`tools/refresh.py` writes the labels of these links and the list below `## References` from
`book/references.bib`. An entry of the list leads to the whole entry on the page of references.
"""

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import nbformat
from docutils import nodes
from pybtex.database import Entry, parse_file
from sphinx.application import Sphinx

BIBLIOGRAPHY = Path(__file__).parents[1] / "book/references.bib"
LINK = re.compile(r"\[[^\]]*\]\(#(\w+)\)")
LIST = "## References\n"


@cache
def read_works() -> Mapping[str, Entry]:
    """Return the works of the bibliography by their keys."""
    return parse_file(BIBLIOGRAPHY).entries


def make_label(key: str) -> str:
    """Return a work's label such as Craig 2018, with the names of at most two authors."""
    work = read_works()[key]
    names = [" ".join(author.last_names) for author in work.persons["author"]]
    authors = f"{names[0]} and others" if len(names) > 2 else " and ".join(names)
    return re.sub(r"[{}]", "", f"{authors} {work.fields['year']}")


def format_list_item(key: str, to_book: str = "") -> str:
    """Return a work as an item of a notebook's list, with the anchor that citations link to.

    `to_book` leads from the notebook's folder to the book's, as ../ does.
    """
    title = re.sub(r"[{}]", "", read_works()[key].fields["title"]).replace("--", "–")
    return f'- <a id="{key}"></a>[{make_label(key)}]({to_book}references.md#{key}): *{title}*'


def write_citations(notebook: nbformat.NotebookNode, to_book: str = "") -> None:
    """Write the label of each citation, and the list of all cited works at the end."""
    cited: set[str] = set()

    def label_link(link: re.Match) -> str:
        if link[1] not in read_works():
            return link[0]
        cited.add(link[1])
        return f"[{make_label(link[1])}](#{link[1]})"

    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            text, heading, _ = cell.source.partition(LIST)
            cell.source = LINK.sub(label_link, text)
            if heading:
                keys = sorted(cited, key=make_label)
                cell.source += f"{heading}\n" + "\n".join(
                    format_list_item(key, to_book) for key in keys
                )


def register_works(app: Sphinx, _doctree: nodes.document) -> None:
    """Register the works as link targets, since sphinxcontrib-bibtex adds them too late."""
    if app.env.docname == "references":
        slugs = app.env.metadata["references"].setdefault("myst_slugs", {})
        slugs.update({key: (0, nodes.make_id(key), "") for key in read_works()})


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("doctree-read", register_works)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
