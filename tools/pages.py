"""A Sphinx extension that prepares the document tree of the book's pages.

Folded boxes become `<details>`, which work without a script; tables get a box to scroll in;
formulas become MathML. Pictures are in `pictures.py`.
"""

import re
from html import escape

from docutils import nodes
from myst_nb.sphinx_ import HideCodeCellNode
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

from answers import typeset
from helpers import robots
from helpers.explorer import ArmExplorer
from helpers.inputs import ArmError
from tools import stills

LOGGER = logging.getLogger(__name__)

SIGN = re.compile(r"\\[a-zA-Z]+|[^\s{}\\^_]")
WITHIN = re.compile(r"\\begin\{(\w+\*?)\}.*?\\end\{\1\}", re.S)
LINE = 18  # length of a formula, in characters, that fits on any phone
UNIT = r"(?:%|N m|kg m²|m/s²|rad/s|m/s|rad|kg|mm|cm|ms|N|J|g|m|s|h)(?![\w/²])"
MEASURED = re.compile(rf"(?<=\d) (?:{UNIT}|\d{{3}}(?!\w))|N m(?!\w)")  # and 1 000
AFTER = re.compile(rf"(?: {UNIT})?[.,;:!?)\]’”]*(?!\w)")
OPENED = re.compile(r"[(\[“‘]+$")
INDEXED = re.compile(r"([^\s-]*_\{[^\s}]*-[^\s}]*\}[^\s-]*)")  # z_{i-1}
OPTION = re.compile(r"((?<![\w-])--[a-z][a-z-]*)")
TYPED = re.compile(r"(?<=\w[=\[])[“”]([^“”\s]*)[“”]")  # convention="craig", to be copied
SPACE = "\N{NO-BREAK SPACE}"


class LiveArm(SphinxDirective):
    """An arm of the catalogue, live."""

    required_arguments = 1
    option_spec = {"views": lambda words: words.split()}  # noqa: RUF012

    def run(self) -> list[nodes.Node]:
        explorer = ArmExplorer(getattr(robots, self.arguments[0]), **self.options)
        html = explorer._repr_mimebundle_()["text/html"]
        return [nodes.raw("", html, format="html")]


def is_long(tex: str) -> bool:
    """Return whether a formula may be as long as a phone's line."""
    return len(SIGN.findall(tex)) > LINE


def convert_formula(node: nodes.Element, tex: str, display: bool = False) -> str:
    """Convert a formula to MathML, which may break between its parts if it is long.

    A formula that cannot be converted gets a warning and stays TeX.
    """
    try:
        html = typeset.convert_to_mathml(tex, display)
        if display or "<mtable" in html or not is_long(tex):
            return html
        return "<wbr>".join(typeset.convert_parts(tex))
    except ArmError as problem:
        LOGGER.warning("%s", problem, location=node)
        return escape(tex)


def visit_math(translator, node) -> None:
    """Write a formula within a line, with a box that scrolls around a matrix."""
    html = convert_formula(node, node.astext())
    scrolls = "<mtable" in html
    translator.body.append(f'<span class="matrix">{html}</span>' if scrolls else html)
    raise nodes.SkipNode


def visit_math_block(translator, node) -> None:
    """Write a display formula, its number and a link to it."""
    tex = node.astext().strip()
    first, other = node["ids"][:1], node["ids"][1:]
    node["ids"] = first  # a second id would add an element to the formula's grid
    translator.body.append(translator.starttag(node, "div", "", CLASS="math"))
    if node.get("number"):
        anchors = "".join(f'<span id="{name}"></span>' for name in other)
        translator.body.append(f'<span class="eqno">{anchors}({node["number"]})')
        translator.add_permalink_ref(node, "Link to this equation")
        translator.body.append("</span>")
    rows = r"\\" in WITHIN.sub("", tex) and not node.get("no-wrap")
    html = convert_formula(node, rf"\begin{{split}}{tex}\end{{split}}" if rows else tex, True)
    translator.body.append(f'<div class="display">{html}</div></div>\n')
    raise nodes.SkipNode


def visit_folded_code(translator, _node) -> None:
    translator.body.append('<details class="hide"><summary>Code</summary>')


def depart_folded_code(translator, _node) -> None:
    translator.body.append("</details>\n")


def fold_box(box: nodes.Element) -> None:
    """Turn a box with a title into a box that a click on the title opens."""
    title, *rest = box.children
    # A click on the summary opens its box, so the summary must not contain links.
    for link in list(title.findall(nodes.reference)):
        link.replace_self(link.children)
    names = " ".join(name for name in box["classes"] if name != "dropdown")
    first, more = box["ids"][:1], box["ids"][1:]
    ids = "".join(f' id="{name}"' for name in first)
    others = "".join(f'<span id="{name}"></span>' for name in more)
    start = f'<details class="admonition {names}"{ids}><summary class="admonition-title">{others}'
    raw = [nodes.raw("", text, format="html") for text in (start, "</summary>", "</details>")]
    index = box.parent.index(box)
    box.parent[index : index + 1] = [
        raw[0],
        nodes.inline("", "", *title.children),
        raw[1],
        *rest,
        raw[2],
    ]


def join_to_neighbours(formula: nodes.math) -> None:
    """Keep a formula on a line with the bracket before it and the unit or comma after it."""
    position, parent = formula.parent.index(formula), formula.parent
    before, after = (
        parent[k] if 0 <= k < len(parent) and isinstance(parent[k], nodes.Text) else nodes.Text("")
        for k in (position - 1, position + 1)
    )
    opened, closed = OPENED.search(before), AFTER.match(after)
    front, behind = opened[0] if opened else "", closed[0] if closed else ""
    if not front and not behind:
        return
    kept = [nodes.Text(front), formula.deepcopy(), nodes.Text(behind.replace(" ", SPACE))]
    formula.replace_self(nodes.inline("", "", *kept, classes=["together"]))
    # Insert by position, because `replace` would replace the first of several equal texts.
    if front:
        parent[position - 1] = nodes.Text(before[: -len(front)])
    if behind:
        parent[position + 1] = nodes.Text(after[len(behind) :])


def keep_words_unbroken(text: nodes.Text) -> None:
    """Keep units with their numbers, and indices and options of commands unbroken.

    Code that is to be typed keeps its straight quotes.
    """
    if isinstance(text.parent, nodes.FixedTextElement | nodes.math):
        return
    changed, unbroken = text, OPTION
    if not isinstance(text.parent, nodes.literal):
        typed = TYPED.sub(r'"\1"', text)
        changed = MEASURED.sub(lambda match: match[0].replace(" ", SPACE), typed)
        unbroken = INDEXED
    parts = [
        nodes.inline("", part, classes=["unbroken"]) if k % 2 else nodes.Text(part)
        for k, part in enumerate(unbroken.split(changed))
    ]
    if changed != text or len(parts) > 1:
        text.parent.replace(text, parts)


def drop_alignment_classes(table: nodes.table) -> None:
    """Remove default alignment classes, and move a class shared by all cells to the table."""
    cells = list(table.findall(nodes.entry))
    for cell in cells:
        cell["classes"] = [name for name in cell["classes"] if name != "text-left"]
    if all(cell["classes"] == ["text-center"] for cell in cells):
        table["classes"].append("text-center")
        for cell in cells:
            cell["classes"] = []


def prepare_page(app: Sphinx, doctree: nodes.document, name: str) -> None:
    """Fold boxes, keep formulas and numbers with their units, and put tables into a box."""
    for box in list(
        doctree.findall(lambda n: "dropdown" in getattr(n, "attributes", {}).get("classes", ()))
    ):
        fold_box(box)
    for formula in list(doctree.findall(nodes.math)):
        join_to_neighbours(formula)
    for text in list(doctree.findall(nodes.Text)):
        keep_words_unbroken(text)
    for table in list(doctree.findall(nodes.table)):
        drop_alignment_classes(table)
        table.replace_self(nodes.container("", table.deepcopy(), classes=["table"]))
    stills.add_stills(app, doctree, name)


def setup(app: Sphinx) -> dict[str, bool]:
    # Jupyter Book sets this option, which only an unused extension would define.
    app.add_config_value("comments_config", {}, "html")
    app.add_directive("arm", LiveArm)
    app.add_node(HideCodeCellNode, override=True, html=(visit_folded_code, depart_folded_code))
    app.add_node(nodes.math, override=True, html=(visit_math, None))
    app.add_node(nodes.math_block, override=True, html=(visit_math_block, None))
    app.connect("doctree-resolved", prepare_page, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
