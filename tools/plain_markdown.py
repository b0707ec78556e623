"""A Sphinx extension that turns plain Markdown into the book's boxes, captions and fields.

Notebooks and pages contain no directives, roles or labels, so GitHub, VS Code, Colab and JupyterLab
show them as they are. This extension recognises these forms on the document tree:

- ``<a id="sec-x"></a>`` is a link target. Alone in a paragraph it names the block below it.
- ``> **Slip 3: a row for a column**``: a quotation that begins with a bold paragraph is a box.
- ``### Exercise 2.3: Title · ten minutes`` begins an exercise, ``#### Solution`` its solution.
- ``**Fig. 2.1.** Text`` is the caption of the cell above it.
- ``\\tag{2.1}`` in a display formula is its number.
- ``- <a id="term-x"></a>**x**: Text`` is a term of the glossary.
- ``<div class="judge" data-ask="table">`` up to ``</div>`` is the place of a judge.
- ``<div class="answer" data-answer="53" data-within="1" data-unit="mm">`` up to ``</div>`` is a
  field for the numbers that an exercise asks for; the text between them says which. Numbers of an
  answer are separated by blanks, answers that are right too by ``|``.
- ``> **Hint**`` begins a hint, which folds.

`tools/numbering.py` checks these forms in the sources and writes their numbers.
"""

import re
import sys
from itertools import takewhile

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.config import Config
from sphinx.transforms import SphinxTransform

from helpers.explorer import judge

OPEN_ANCHOR = re.compile(r'<a id="([\w.-]+)">')
OPEN_ANSWER = re.compile(r'<div class="answer"([^>]*)>\s*')
OPEN_JUDGE = re.compile(r'<div class="judge"([^>]*)>\s*')
DATA = re.compile(r'data-([\w-]+)="([^"]*)"')
EXERCISE = re.compile(r"(Exercise [\d.]+): (.*)", re.S)
DURATION = re.compile(r"(.*?)\s*( · .+)", re.S)
FIGURE = re.compile(r"(Fig\. [\d.]+)\.")
TAG = re.compile(r"\s*\\tag\{([\d.]+)\}\s*")


class NameTargets(SphinxTransform):
    """Turn ``<a id="x"></a>`` into a docutils target.

    docutils then hands the id of a target in a paragraph of its own to the next block.
    """

    default_priority = 250  # before docutils.transforms.references.PropagateTargets, at 260

    def apply(self, **_: object) -> None:
        for opening in list(self.document.findall(nodes.raw)):
            anchor = OPEN_ANCHOR.fullmatch(opening.astext())
            if anchor is None:
                continue
            parent = opening.parent
            closing = parent[parent.index(opening) + 1]
            target = nodes.target("", "", ids=[anchor[1]], names=[anchor[1]])
            self.document.note_explicit_target(target, opening)
            parent.remove(closing)
            opening.replace_self(target)
        for paragraph in list(self.document.findall(nodes.paragraph)):
            targets = [child for child in paragraph if isinstance(child, nodes.target)]
            if targets and not paragraph.astext().strip():
                paragraph.replace_self(targets)


class DressBlocks(SphinxTransform):
    """Turn plain Markdown for boxes, exercises, captions, formulas and terms into theme nodes."""

    default_priority = 300  # before Sphinx collects titles: the contents list no exercises

    def apply(self, **_: object) -> None:
        for node_type, dress in (
            (nodes.raw, self.place_judge),
            (nodes.raw, place_answer_field),
            (nodes.raw, drop_still),
            (nodes.block_quote, dress_box),
            (nodes.section, dress_exercise),
            (nodes.paragraph, dress_caption),
            (nodes.math_block, number_formula),
            (nodes.bullet_list, dress_terms),
        ):
            for node in list(self.document.findall(node_type)):
                dress(node)

    def place_judge(self, opening: nodes.raw) -> None:
        """Replace a ``<div class="judge">`` by the judge's stub.

        The text up to ``</div>`` stays for pages without JavaScript.
        """
        tag = OPEN_JUDGE.fullmatch(opening.astext())
        if tag is None:
            return
        for name, module in list(sys.modules.items()):
            if name.startswith("helpers."):  # the stub contains numbers of the arms
                self.env.note_dependency(module.__file__)
        content = remove_up_to_end(opening)
        opening.replace_self(judge_nodes(dict(DATA.findall(tag[1])), content))


def remove_up_to_end(opening: nodes.raw) -> list[nodes.Node]:
    """Remove the nodes between a ``<div>`` and its ``</div>``, and return them."""
    parent = opening.parent
    following = parent[parent.index(opening) + 1 :]
    content = list(takewhile(lambda node: node.astext().strip() != "</div>", following))
    for node in [*content, following[len(content)]]:
        parent.remove(node)
    return content


def place_answer_field(opening: nodes.raw) -> None:
    """Replace ``<div class="answer">`` by a field for an answer, which answer.js reads."""
    tag = OPEN_ANSWER.fullmatch(opening.astext())
    if tag is None:
        return
    (question,) = remove_up_to_end(opening)
    html = (
        f'<form class="answer"{tag[1]}><label>',
        '<input autocomplete="off" spellcheck="false"></label>'
        "<button>Check</button><output></output></form>",
    )
    start, end = (nodes.raw("", part, format="html") for part in html)
    label = nodes.inline("", "", *question.children)
    opening.replace_self([start, label, end])


def drop_still(html: nodes.raw) -> None:
    """Remove the still picture beside a live figure, since tools/stills.py draws another."""
    if '<div class="arm-explorer' not in html.astext():
        return
    output = html.parent
    while output is not None and not is_of_class(output, "cell_output"):
        output = output.parent
    for part in list(output or ()):
        if next(part.findall(nodes.image), None) is not None:
            output.remove(part)


def judge_nodes(question: dict[str, str], content: list[nodes.Node]) -> list[nodes.Node]:
    """Return the nodes of a judge that asks `question`.

    Args:
        question: the `data-` attributes; semicolons end table rows.
        content: what a page without JavaScript shows.
    """
    question = {"q" if name == "configuration" else name: text for name, text in question.items()}
    if "table" in question:
        question["table"] = question["table"].replace("; ", "\n")
    start, end = (nodes.raw("", html, format="html") for html in judge.form_html(question))
    return [start, nodes.container("", *content, classes=["unscripted"]), end]


def leading_bold_text(paragraph: nodes.Node) -> str:
    """Return the bold text that a paragraph begins with, or an empty string."""
    if not isinstance(paragraph, nodes.paragraph):
        return ""
    first = next(iter(visible_parts(paragraph)), None)
    return first.astext() if isinstance(first, nodes.strong) else ""


def dress_box(quote: nodes.block_quote) -> None:
    """Turn a quotation whose first paragraph is bold into a box with a title."""
    title = leading_bold_text(quote[0])
    if not title or title != quote[0].astext():
        return
    kinds = ["slip" if title.startswith("Slip ") else "important"]
    if title == "Hint":
        kinds = ["clue", "dropdown"]  # not the class `hint`, which the theme uses below wide boxes
    heading = nodes.title("", "", *quote[0].next_node(nodes.strong).children)
    box = nodes.admonition("", heading, *quote[1:], ids=quote["ids"], classes=kinds)
    quote.replace_self(box)


def dress_exercise(section: nodes.section) -> None:
    """Turn the section of an exercise into a box, followed by its folded solution."""
    heading = EXERCISE.match(section[0][0].astext())
    if heading is None:
        return
    rest = [nodes.Text(heading[2]), *section[0][1:]]
    duration = DURATION.fullmatch(rest[-1].astext())
    before, time = (duration[1], duration[2]) if duration else (rest[-1].astext(), "")
    name = [*rest[:-1], nodes.Text(before)]
    title = nodes.title(
        "",
        "",
        nodes.inline("", f"{heading[1]} ", classes=["caption-number"]),
        *[part.deepcopy() for part in name],
        nodes.inline("", time, classes=["time"]),
    )
    ids = explicit_ids(section) or section["ids"]
    solutions = [part for part in section if isinstance(part, nodes.section)]
    parts = [part for part in section[1:] if part not in solutions]
    text = list(takewhile(is_text, parts))
    box = nodes.admonition("", title, *text, ids=ids, classes=["exercise"])
    folded = [
        fold_solution(part, ids[0], [nodes.Text(f"{heading[1]}: "), *name]) for part in solutions
    ]
    section.parent.replace(section, [box, *parts[len(text) :], *folded])


def fold_solution(
    section: nodes.section, exercise: str, exercise_name: list[nodes.Node]
) -> nodes.admonition:
    """Return a solution as a box that tools/pages.py folds."""
    title = nodes.title("", "Solution to ", *[part.deepcopy() for part in exercise_name])
    solution = nodes.admonition("", title, *section[1:], classes=["solution", "dropdown"])
    solution["ids"] = [f"solution-{exercise}", *explicit_ids(section)]
    return solution


def explicit_ids(section: nodes.section) -> list[str]:
    """Return a section's ids from anchors, without the id from its title."""
    is_explicit = section.document.nametypes
    return [name for name in section["ids"] if is_explicit.get(name)]


def is_text(node: nodes.Node) -> bool:
    """Return whether a node is neither a code cell nor a judge."""
    return not isinstance(node, nodes.raw) and "cell" not in node.get("classes", ())


def dress_caption(paragraph: nodes.paragraph) -> None:
    """Join a picture and the caption below it in a figure."""
    label = FIGURE.fullmatch(leading_bold_text(paragraph))
    output = output_above(paragraph)
    if label is None or output is None:
        return
    number = nodes.inline("", label[1], classes=["caption-number"])
    paragraph.replace(paragraph.next_node(nodes.strong), number)
    caption = nodes.caption("", "", *paragraph.children)
    output[:] = [nodes.figure("", *output.children, caption, ids=paragraph["ids"])]
    paragraph.parent.remove(paragraph)


def output_above(paragraph: nodes.paragraph) -> nodes.Element | None:
    """Return the output of the code cell right above a paragraph."""
    before = paragraph.parent[: paragraph.parent.index(paragraph)]
    cell = next((node for node in reversed(before) if not isinstance(node, nodes.target)), None)
    if cell is None or "cell" not in cell.get("classes", ()):
        return None
    return next(cell.findall(lambda node: is_of_class(node, "cell_output")), None)


def is_of_class(node: nodes.Node, name: str) -> bool:
    """Return whether a node is an element of an HTML class."""
    return isinstance(node, nodes.Element) and name in node.get("classes", ())


def number_formula(block: nodes.math_block) -> None:
    r"""Remove ``\tag{2.1}`` from a formula, since the page adds the number.

    Sphinx's own form of the id, ``equation-eq-x``, stays valid for links from elsewhere.
    """
    tag = TAG.search(block.astext())
    if tag is None:
        return
    block[:] = [nodes.Text(TAG.sub("", block.astext()))]
    block["number"] = tag[1]
    block["ids"] += [f"equation-{name}" for name in block["ids"]]


def dress_terms(items: nodes.bullet_list) -> None:
    """Turn a list whose items begin with a named bold term into a definition list."""
    paragraphs = [item[0] for item in items if isinstance(item[0], nodes.paragraph)]
    if len(paragraphs) < len(items) or not all(map(is_definition, paragraphs)):
        return
    definitions = nodes.definition_list("", classes=["simple", "glossary"])
    for paragraph in paragraphs:
        target, name, *text = visible_parts(paragraph)
        term = nodes.term("", "", *name.children, ids=target["ids"])
        entry = ("single", name.astext(), target["ids"][0], "main", None)
        term += addnodes.index(entries=[entry])
        text[0] = nodes.Text(text[0].astext().removeprefix(": "))
        definition = nodes.definition("", nodes.paragraph("", "", *text))
        definitions += nodes.definition_list_item("", term, definition)
    items.replace_self(addnodes.glossary("", definitions, sorted=False))


def is_definition(paragraph: nodes.paragraph) -> bool:
    """Return whether a paragraph begins with a target, a bold term and a colon."""
    parts = visible_parts(paragraph)[:3]
    kinds = [type(part) for part in parts]
    return kinds == [nodes.target, nodes.strong, nodes.Text] and parts[2].startswith(": ")


def visible_parts(paragraph: nodes.paragraph) -> list[nodes.Node]:
    """Return a paragraph's children without the empty texts that MyST adds to bold text."""
    return [part for part in paragraph if part.astext() or isinstance(part, nodes.target)]


def register_targets(app: Sphinx, doctree: nodes.document) -> None:
    """Register every id as a link target, since MyST finds only slugs of headings."""
    places = {name: (0, name, "") for name in doctree.ids}
    app.env.metadata[app.env.docname].setdefault("myst_slugs", {}).update(places)


def disable_numbering(_app: Sphinx, config: Config) -> None:
    """Switch off Sphinx's own numbers, which sphinx-jupyterbook-latex switches on."""
    config.numfig = False


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("config-inited", disable_numbering, priority=900)
    app.add_transform(NameTargets)
    app.add_transform(DressBlocks)
    app.connect("doctree-read", register_targets, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
