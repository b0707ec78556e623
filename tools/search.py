"""Write the search index of the book as a script that the first search loads.

Sphinx's own search fetches each page for the text around a hit, which a browser forbids on pages
opened from a file (sphinx-doc/sphinx#10407). Here the text comes with the index. A section, an
exercise, a slip, a term or symbol of the glossary, a function of the package, a work of the
bibliography and a row of the table of symptoms are one entry each: its page, its anchor, its title,
its text. `book/assets/search.js` ranks them.

Readers have other words for a page or a section than its title: `book/search_names.yml` lists them.
"""

import json
import re
import unicodedata
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import yaml
from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.builders.html import StandaloneHTMLBuilder
from sphinx.environment import BuildEnvironment
from sphinx.errors import ExtensionError

from tools.citations import make_label, read_works

SCRIPT = "search-entries.js"
NAMES = Path(__file__).parents[1] / "book/search_names.yml"
BIBLIOGRAPHY_PAGE = "references"
SYMPTOMS = "symptoms"  # id of the table whose rows are entries
SYMBOLS_SECTION = "symbols"  # of the glossary; each row of its table is an entry
SHEETS = "answers/"
LIST_PAGES = ("api", "glossary", "where")
BOXES = ("exercise", "slip")  # classes of the boxes that are entries
OTHER_NAMES = re.compile(r"Also: ([^.]+)\.$")  # other names of a term in the glossary
REFERENCE = re.compile(r"\0(.+?)\0")  # reference, resolved after all pages are read
SKIPPED = (
    *(nodes.raw, nodes.comment, nodes.image, nodes.literal_block, nodes.footnote, nodes.math_block),
    *(nodes.section, addnodes.desc),
)
MAX_FORMULA_LENGTH = 30  # characters; longer formulas are unreadable as plain text
SYMBOLS = {
    **{"varphi": "φ", "vartheta": "ϑ", "varepsilon": "ε", "Delta": "Δ", "Sigma": "Σ"},
    **{"times": "×", "cdot": "·", "circ": "°", "partial": "∂", "pm": "±", "le": "≤", "ge": "≥"},
    **{"ne": "≠", "approx": "≈", "to": "→", "infty": "∞", "dots": "…", "top": "T", "quad": " "},
    **{"leq": "≤", "geq": "≥", "ldots": "…", "sqrt": "√", "sum": "Σ", "ell": "l"},
}
MARKS = {"dot": "\u0307", "ddot": "\u0308", "hat": "\u0302", "bar": "\u0304", "tilde": "\u0303"}
FUNCTIONS = {"sin", "cos", "tan", "det", "rank", "max", "min", "arccos", "arctan"}
Entry = dict[str, str]


def write_formula(tex: str) -> str:
    """Return a formula as plain text, or nothing if it is too long for that."""
    text = re.sub(r"\\(?:mathrm|text|operatorname|mathbf|mathit)\*?\{([^{}]*)\}", r"\1", tex)
    text = re.sub(r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}", r"\1/\2", text)
    text = re.sub(
        rf"\\({'|'.join(MARKS)})(?![A-Za-z])(?:\{{(\\?\w+)\}}|\s*(\\[A-Za-z]+|\w))",
        lambda mark: (mark[2] or mark[3]) + MARKS[mark[1]],
        text,
    )
    text = re.sub(r"\\(?:left|right|[,;:! ])", "", text)
    text = re.sub(rf"(?<=\w) ?\\({'|'.join(FUNCTIONS)})(?![A-Za-z])", r" \\\1", text)
    text = re.sub(rf"\\({'|'.join(FUNCTIONS)})(?![A-Za-z]) ?(?=[\\\w])", r"\1 ", text)
    text = re.sub(
        r"\\([A-Za-z]+) ?",
        lambda name: get_symbol(name[1]) or name[0],
        text,
    )
    text = re.sub(r"[{}]", "", text.replace("^°", "°")).lstrip("^_").replace("'", "′")
    return "" if len(text) > MAX_FORMULA_LENGTH or re.search(r"[\\&]", text) else text


def get_symbol(name: str) -> str:
    """Return the character of a TeX command, or nothing if it has none."""
    if name in FUNCTIONS:
        return name
    greek = f"GREEK SMALL LETTER {name.replace('lambda', 'lamda').upper()}"
    with suppress(KeyError):
        return SYMBOLS.get(name) or unicodedata.lookup(greek)
    return ""


def is_entry_box(node: nodes.Node) -> bool:
    """Return whether a node is a box with its own entry."""
    return isinstance(node, nodes.admonition) and bool({*node["classes"]} & {*BOXES})


def is_description(node: nodes.Node) -> bool:
    return isinstance(node, nodes.meta) and node.get("name") == "description"


def is_term(node: nodes.Node) -> bool:
    """Return whether a node is a term of the glossary with its definition."""
    return isinstance(node, nodes.definition_list_item) and any(
        term["ids"] for term in node.findall(nodes.term)
    )


def is_entry_table(node: nodes.Node) -> bool:
    """Return whether a node is a table whose rows are entries."""
    return isinstance(node, nodes.table) and (
        SYMPTOMS in node["ids"] or SYMBOLS_SECTION in node.parent["ids"]
    )


def is_solution(node: nodes.Node) -> bool:
    return isinstance(node, nodes.admonition) and "solution" in node["classes"]


def iterate_text(node: nodes.Node) -> Iterator[str]:
    """Yield the readable text of a node.

    Code, outputs, long formulas, solutions and parts that are separate entries are left out.
    """
    if isinstance(node, nodes.Text):
        yield node.astext()
    elif node.get("reftype") == "ref" and not node["refexplicit"]:
        yield f"\0{node['reftarget']}\0"
    elif isinstance(node, nodes.math):
        yield write_formula(node.astext())
    elif not (
        isinstance(node, SKIPPED)
        or is_entry_box(node)
        or is_term(node)
        or is_entry_table(node)
        or is_solution(node)
        or "cell_output" in node.get("classes", ())
    ):
        yield from (text for child in node.children for text in iterate_text(child))
        yield " " if isinstance(node, nodes.TextElement) else ""


def join_text(parts: list[nodes.Node]) -> str:
    """Return the readable text of nodes in a line."""
    text = " ".join(" ".join("".join(iterate_text(part)) for part in parts).split())
    return re.sub(r"\s+(?=[,.;:)])", "", text)  # spaces left by long formulas


def make_entry(title: nodes.Node, anchor: str, parts: list[nodes.Node]) -> Entry:
    """Make an entry from its title, its anchor and the nodes below the title."""
    name = "".join(text for child in title.children for text in iterate_text(child))
    return {
        "anchor": anchor,
        "title": " ".join((name or title.astext()).split()),
        "text": join_text(parts),
    }


def iterate_entries(doctree: nodes.document) -> Iterator[Entry]:
    """Yield the entries of a page, each with its own anchor.

    The first has the page's description, `about`, whose words readers use more than the title's.
    """
    description = next(doctree.findall(is_description), None)
    about = {"about": description["content"]} if description else {}
    for section in doctree.findall(nodes.section):
        title, *parts = section.children
        if isinstance(title, nodes.title) and title.astext() != "References":
            yield {**make_entry(title, section["ids"][0], parts), **about}
            about = {}
    for box in doctree.findall(is_entry_box):
        if box["ids"]:
            yield make_entry(box.children[0], box["ids"][0], box.children[1:])
    yield from iterate_terms(doctree)
    yield from iterate_rows(doctree)
    yield from iterate_functions(doctree)


def iterate_terms(doctree: nodes.document) -> Iterator[Entry]:
    """Yield an entry for each term of the glossary."""
    for item in doctree.findall(is_term):
        term = next(term for term in item.findall(nodes.term) if term["ids"])
        entry = make_entry(term, term["ids"][0], [item.children[-1]])
        also = OTHER_NAMES.search(entry["text"])
        yield {**entry, "also": also[1]} if also else entry


def iterate_rows(doctree: nodes.document) -> Iterator[Entry]:
    """Yield an entry for each row of the tables of symptoms and of symbols."""
    for table in doctree.findall(is_entry_table):
        anchor = table.parent["ids"][0]
        for body in table.findall(nodes.tbody):
            for first, *rest in (row.children for row in body.children):
                yield make_entry(first, anchor, rest)


def iterate_functions(doctree: nodes.document) -> Iterator[Entry]:
    """Yield an entry for each documented function or class."""
    for function in doctree.findall(addnodes.desc):
        signature, content = function.children[0], function.children[-1]
        if signature.get("ids"):
            name = nodes.inline("", signature.get("fullname") or signature["ids"][0])
            yield make_entry(name, signature["ids"][0], [content])


def collect_entries(app: Sphinx, doctree: nodes.document) -> None:
    """Store the entries of a page that Sphinx has just read."""
    stored_entries(app.env)[app.env.docname] = list(iterate_entries(doctree))


def stored_entries(env: BuildEnvironment) -> dict[str, list[Entry]]:
    """Return the entries of each page, which Sphinx stores with its data of unchanged pages."""
    if not hasattr(env, "search_entries"):
        env.search_entries = {}
    return env.search_entries


def forget_page(_app: Sphinx, env: BuildEnvironment, page: str) -> None:
    """Remove the entries of a page that is read again or deleted."""
    stored_entries(env).pop(page, None)


def get_kind(env: BuildEnvironment, page: str) -> str:
    """Return whether a page is a "chapter", an answer "sheet", a "list" or a "side" page."""
    if page in env.toc_secnumbers:
        return "chapter"
    if page.startswith(SHEETS):
        return "sheet"
    return "list" if page in LIST_PAGES else "side"


def read_names(entries: list[Entry]) -> dict[tuple[str, str], str]:
    """Return what readers call each entry, by its page and anchor."""
    first_anchors = {entry["page"]: entry["anchor"] for entry in reversed(entries)}
    names = {}
    for place, other_names in yaml.safe_load(NAMES.read_text("utf-8")).items():
        page, _, anchor = place.partition("#")
        names[page, anchor or first_anchors.get(page, "")] = other_names
    places = {(entry["page"], entry["anchor"]) for entry in entries}
    if unknown := [f"{page}#{anchor}" for page, anchor in names if (page, anchor) not in places]:
        message = f"{NAMES.name} names {', '.join(unknown)}; the search has no such page or section"
        raise ExtensionError(message)
    return names


def list_works() -> list[Entry]:
    """Return an entry for each work of the bibliography."""
    return [
        {
            "anchor": nodes.make_id(key),
            "title": make_label(key),
            "also": ", ".join(" ".join(person.last_names) for person in work.persons["author"]),
            "text": re.sub(r"[{}]", "", work.fields["title"]),
        }
        for key, work in read_works().items()
    ]


def write_index(app: Sphinx, problem: Exception | None) -> None:
    """Write the entries of all pages into the script, with references resolved."""
    if problem or not isinstance(app.builder, StandaloneHTMLBuilder):
        return
    env = app.env
    labels = env.get_domain("std").labels

    def get_title(reference: re.Match) -> str:
        return labels[reference[1]][2] if reference[1] in labels else ""

    stored = stored_entries(env)
    stored = {**stored, BIBLIOGRAPHY_PAGE: [*stored[BIBLIOGRAPHY_PAGE], *list_works()]}
    entries = [
        {"page": page, "kind": get_kind(env, page), "of": env.titles[page].astext(), **entry}
        | {"text": REFERENCE.sub(get_title, entry["text"])}
        for page, page_entries in sorted(stored.items())
        for entry in page_entries
    ]
    names = read_names(entries)
    for entry in entries:
        if also := names.pop((entry["page"], entry["anchor"]), ""):
            entry["also"] = also
    script = Path(app.outdir, "_static", SCRIPT)
    script.write_text(f"const ENTRIES = {json.dumps(entries, ensure_ascii=False)};\n", "utf-8")


def disable_own_search(app: Sphinx) -> None:
    """Stop Sphinx from making its own index."""
    app.builder.search = False


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("builder-inited", disable_own_search)
    app.connect("doctree-read", collect_entries)
    app.connect("env-purge-doc", forget_page)
    app.connect("build-finished", write_index)
    return {"parallel_write_safe": True}
