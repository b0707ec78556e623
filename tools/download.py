"""A Sphinx extension: each notebook once more in plain Markdown, for readers elsewhere (Colab,
VS Code, a folder of one's own).

Directives become headings and quotes, references become links into the published book (or words,
where none is published), labels become the numbers that the book prints. The first cell says how
to get `helpers`; nothing installs itself.
"""

import re
from collections.abc import Callable
from pathlib import Path

import nbformat
from sphinx.application import Sphinx

BLOCK = re.compile(r"(?ms)^(`{3,}|:{3,})\{([\w-]+)\}[ \t]*([^\n]*)\n(.*?)^\1[ \t]*$\n?")
OPTION = re.compile(r"(?m)\A(?::([\w-]+):[ \t]*([^\n]*)\n)+\s*")
ROLE = re.compile(r"\{([a-z:]+)\}`([^`<]*?)\s*(?:<([^`>]*)>)?`")
LINK = re.compile(r"\[([^\]]+)\]\(#([\w-]+)\)")
EQUATION = re.compile(r"\$\$[ \t]*\(([\w-]+)\)")
TARGET = re.compile(r"(?m)^\([\w-]+\)=\n+")
FOLDED = {"jp-MarkdownHeadingCollapsed": True}  # JupyterLab and Notebook 7 fold what is below


class Book:
    """What a notebook alone does not know: numbers, titles, and where the book is."""

    def __init__(self, app: Sphinx) -> None:
        self.env = app.env
        self.repository = app.config.html_theme_options.get("repository_url", "")
        self.address = app.config.html_baseurl

    def link(self, text: str, page: str, anchor: str = "") -> str:
        if not self.address:
            return text
        return f"[{text}]({self.address}{page}.html{'#' if anchor else ''}{anchor})"

    def section(self, label: str, text: str) -> str:
        page, anchor, title = self.env.domains["std"].labels.get(label) or (None, None, None)
        if page is None:
            page, anchor = self.env.domains["std"].anonlabels[label]
        number = self.env.toc_secnumbers.get(page, {}).get(f"#{anchor}", ())
        shown = text or f"{'.'.join(map(str, number))} {title or label}".strip()
        return self.link(shown, page, anchor)

    def figure(self, label: str, text: str = "") -> str:
        page, anchor = self.env.domains["std"].anonlabels[label]
        return self.link(f"Fig. {self._number(page, 'figure', anchor)}", page, anchor)

    def equation(self, label: str, text: str = "") -> str:
        return f"({self.equation_number(label)})"

    def equation_number(self, label: str) -> str:
        page, _ = self.env.domains["math"].equations[label]
        return self._number(page, "displaymath", f"equation-{label}")

    def page(self, name: str, text: str) -> str:
        return self.link(text or self.env.titles[name].astext(), name)

    def term(self, word: str, text: str) -> str:
        return self.link(text or word, "glossary", f"term-{re.sub(r'[^A-Za-z]+', '-', word)}")

    def _number(self, page: str, kind: str, anchor: str) -> str:
        return ".".join(map(str, self.env.toc_fignumbers[page][kind][anchor]))


ROLES: dict[str, Callable[[Book, str, str], str]] = {
    "ref": Book.section,
    "numref": Book.figure,
    "eq": Book.equation,
    "doc": Book.page,
    "term": Book.term,
}


def plain(text: str, book: Book) -> str:
    """Markdown that any reader shows, from the book's own."""
    text = BLOCK.sub(lambda block: _block(block[2], block[3], block[4], book), text)
    text = LINK.sub(lambda link: book.section(link[2], link[1]), text)
    text = EQUATION.sub(lambda label: rf"\tag{{{book.equation_number(label[1])}}}$$", text)
    return ROLE.sub(lambda role: _role(role, book), TARGET.sub("", text))


def _role(role: re.Match, book: Book) -> str:
    if role[1] not in ROLES:
        return role[0]
    return ROLES[role[1]](book, role[3] or role[2], role[2] if role[3] else "")


def _block(kind: str, title: str, body: str, book: Book) -> str:
    options = OPTION.match(body)
    body = body[options.end() :] if options else body
    match kind:
        case "exercise":
            return f"#### Exercise: {title}\n{body}"
        case "solution-start":
            return "#### Solution\n"
        case "solution-end":
            return ""
        case _:
            quoted = "\n".join(f"> {line}".rstrip() for line in body.strip().split("\n"))
            return f"> **{title}**\n>\n{quoted}\n" if title else f"{quoted}\n"


def first_cell(page: str, book: Book) -> str:
    """Where the notebook is from, and what to run in order to have what it imports."""
    name = book.link("*Robot homework companion*", page)
    what = f"manipulator-homework-helpers[explorer] @ git+{book.repository}"
    folder = ""
    if not book.repository:
        what = "./companion[explorer]"
        folder = ", with the folder of the book's repository in place of `companion`"
    return (
        f"> A notebook of the {name}, to run and to change. It needs the book's `helpers`. "
        f"If you do not have them, run this in a cell of its own{folder}:\n>\n"
        f'> ```\n> %pip install "{what}"\n> ```\n'
    )


def edition(notebook: nbformat.NotebookNode, page: str, book: Book) -> nbformat.NotebookNode:
    """The notebook in plain Markdown, solutions folded and captions below their figures."""
    cells = [nbformat.v4.new_markdown_cell(first_cell(page, book), id="get-helpers")]
    for cell in notebook.cells:
        figure = cell.metadata.get("mystnb", {}).get("figure")
        if cell.cell_type == "markdown":
            cells += _parts(cell, book)
            continue
        cells.append(cell)
        if figure:
            label = book.figure(figure["name"]) if "name" in figure else "Figure"
            text = f"*{label}. {plain(figure['caption'], book)}*"
            cells.append(nbformat.v4.new_markdown_cell(text, id=f"{cell.id}-caption"))
    notebook.cells = cells
    return notebook


def _parts(cell: nbformat.NotebookNode, book: Book) -> list[nbformat.NotebookNode]:
    """A cell's Markdown, divided where an exercise or a solution begins: each heading folds
    what is below it."""
    text = plain(cell.source, book)
    texts = [part.strip() for part in re.split(r"(?m)^(?=#### )|(?<=^#### Solution\n)", text)]
    parts = [nbformat.v4.new_markdown_cell(part) for part in texts if part]
    for number, part in enumerate(parts):
        part.id = f"{cell.id}-{number}"
        if part.source == "#### Solution":
            part.metadata = nbformat.from_dict(FOLDED)
    return parts


def write(app: Sphinx, error: Exception | None) -> None:
    """Write every notebook's edition beside the pages."""
    if error or app.builder.format != "html":
        return
    folder = Path(app.outdir, "notebooks")
    folder.mkdir(exist_ok=True)
    book = Book(app)
    for page in sorted(app.env.found_docs):
        path = Path(app.env.doc2path(page))
        if path.suffix == ".ipynb":
            notebook = nbformat.read(path, as_version=4)
            nbformat.write(edition(notebook, page, book), folder / f"{page}.ipynb")


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
