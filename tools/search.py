"""A Sphinx extension: the words of every section, as a script that the search page loads.

Sphinx's own search fetches each page for the words around a hit, which a browser forbids on pages
opened from a file (sphinx-doc/sphinx#10407). Here the words come with the index. A section, a term
of the glossary, a function of the package and a row of the table of symptoms are one entry
each: its page, its place there, its title, its words. What ranks them is `book/assets/search.js`.
"""

import json
import re
from collections.abc import Iterator
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.builders.html import StandaloneHTMLBuilder
from sphinx.environment import BuildEnvironment

SCRIPT = "search-entries.js"
SYMPTOMS = "symptoms"  # the id of the table whose rows are entries
PLAIN = re.compile(r"[\w+=.^-]{1,12}")  # a formula that can be read in a line of plain text
LABEL = re.compile(r"\0(.+?)\0")  # a reference that is resolved when all pages have been read
UNREAD = (
    *(nodes.raw, nodes.comment, nodes.image, nodes.literal_block, nodes.footnote, nodes.math_block),
    *(nodes.section, addnodes.desc),
)
Entries = dict[str, list[dict[str, str]]]


def words(node: nodes.Node) -> Iterator[str]:
    """What a reader reads of a node; code, outputs, long formulas and parts that are entries of
    their own are left out."""
    if isinstance(node, nodes.Text):
        yield node.astext()
    elif node.get("reftype") == "ref" and not node["refexplicit"]:
        yield f"\0{node['reftarget']}\0"
    elif isinstance(node, nodes.math):
        tex = node.astext()
        yield tex if PLAIN.fullmatch(tex) else "…"
    elif not isinstance(node, UNREAD) and "cell_output" not in node.get("classes", ()):
        yield from (word for child in node.children for word in words(child))
        yield " " if isinstance(node, nodes.TextElement) else ""


def entry(title: nodes.Node, anchor: str, parts: list[nodes.Node]) -> dict[str, str]:
    text = " ".join("".join(words(part)) for part in parts)
    return {"anchor": anchor, "title": title.astext(), "text": " ".join(text.split())}


def entries(doctree: nodes.document) -> Iterator[dict[str, str]]:
    for section in doctree.findall(lambda node: type(node) is nodes.section):
        title, *parts = section.children
        if not isinstance(title, nodes.title):
            continue
        yield entry(title, section["ids"][0], parts)
    for item in doctree.findall(nodes.definition_list_item):
        terms = [term for term in item.findall(nodes.term) if term["ids"]]
        for term in terms[:1]:
            yield entry(term, term["ids"][0], [item.children[-1]])
    tables = (table for table in doctree.findall(nodes.table) if SYMPTOMS in table["ids"])
    for table in tables:
        for row in table.findall(nodes.row):
            symptom = entry(row.children[0], table.parent["ids"][0], row.children[1:])
            yield {**symptom, "symptom": "yes"}
    for function in doctree.findall(addnodes.desc):
        signature, content = function.children[0], function.children[-1]
        if signature.get("ids"):
            name = nodes.Text(signature.get("fullname") or signature["ids"][0])
            yield entry(name, signature["ids"][0], [content])


def collect(app: Sphinx, doctree: nodes.document) -> None:
    kept(app.env)[app.env.docname] = list(entries(doctree))


def kept(env: BuildEnvironment) -> Entries:
    """The entries of each page; they are stored with what else Sphinx knows of unchanged pages."""
    if not hasattr(env, "search_entries"):
        env.search_entries = {}
    return env.search_entries


def forget(_app: Sphinx, env: BuildEnvironment, page: str) -> None:
    kept(env).pop(page, None)


def write(app: Sphinx, problem: Exception | None) -> None:
    if problem or not isinstance(app.builder, StandaloneHTMLBuilder):
        return
    labels = app.env.get_domain("std").labels

    def title(label: re.Match) -> str:
        return labels[label[1]][2] if label[1] in labels else "…"

    found = [
        {"page": page, "of": app.env.titles[page].astext(), **each}
        | {"text": LABEL.sub(title, each["text"])}
        for page, of_page in sorted(kept(app.env).items())
        for each in of_page
    ]
    script = Path(app.outdir, "_static", SCRIPT)
    script.write_text(f"const ENTRIES = {json.dumps(found, ensure_ascii=False)};\n", "utf-8")


def instead(app: Sphinx) -> None:
    """Sphinx's own index is not made."""
    app.builder.search = False


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("builder-inited", instead)
    app.connect("doctree-read", collect)
    app.connect("env-purge-doc", forget)
    app.connect("build-finished", write)
    return {"parallel_write_safe": True}
