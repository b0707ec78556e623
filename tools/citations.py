"""Citations: a text links to a work by its key, `[Craig 2018](#craig2018)`, in any notebook reader.

`tools/refresh.py` writes the words and the list at a notebook's end from `book/references.bib`; in
the built book the links lead to the works on the page of references.
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
def works() -> Mapping[str, Entry]:
    return parse_file(BIBLIOGRAPHY).entries


def in_words(key: str) -> str:
    """A work as Craig 2018: the last names of up to two authors, or the first and others."""
    work = works()[key]
    names = [" ".join(who.last_names) for who in work.persons["author"]]
    authors = f"{names[0]} and others" if len(names) > 2 else " and ".join(names)
    return re.sub(r"[{}]", "", f"{authors} {work.fields['year']}")


def listed(key: str) -> str:
    """A work as a line of a list."""
    title = re.sub(r"[{}]", "", works()[key].fields["title"]).replace("--", "–")
    return f"- [{in_words(key)}](#{key}): *{title}*"


def cite(notebook: nbformat.NotebookNode) -> None:
    """Write the words of each link to a work, and at the end the list of all that are cited."""
    cited: set[str] = set()

    def link(found: re.Match) -> str:
        if found[1] not in works():
            return found[0]
        cited.add(found[1])
        return f"[{in_words(found[1])}](#{found[1]})"

    for cell in notebook.cells:
        if cell.cell_type == "markdown":
            text, heading, _ = cell.source.partition(LIST)
            cell.source = LINK.sub(link, text)
            if heading:
                cell.source += f"{heading}\n" + "\n".join(sorted(map(listed, cited)))


def label(app: Sphinx, _tree: nodes.document) -> None:
    """Let links find the works, whose places sphinxcontrib-bibtex calls by their keys."""
    if app.env.docname == "references":
        places = {key: ("references", nodes.make_id(key)) for key in works()}
        app.env.domains["std"].data["anonlabels"].update(places)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("doctree-read", label)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
