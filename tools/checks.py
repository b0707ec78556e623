"""A Sphinx extension that folds cells whose only outputs are checks, and marks checks that hold.

A cell whose outputs are lines of `helpers.checks.check` alone shows one line on its page, with what
was compared; its code and its full output open with a click. Solutions stay as they are, since
their code is what the reader asked for, and so do cells with the tag `show-code`. In every output a
check that holds has a line of its own, with its continuation indented; no script does so later,
which would move what a reader sees.
"""

import re
from html import escape

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

from tools.plain_markdown import is_of_class

PRECISION = re.compile(r" \(within [^()]*\)$")
MAX_LABELS = 3  # labels shown for a cell; more labels are only counted
IN_COLUMNS = re.compile(r"\S {2,}\S.*\n.*\S {2,}\S")
SMALL_NUMBER = re.compile(r"(\d[\d.]*e-\d+)")  # which would break behind its minus


class FoldChecks(SphinxTransform):
    default_priority = 310  # after boxes of solutions are made, at priority 300

    def apply(self, **_: object) -> None:
        for cell in list(self.document.findall(lambda node: is_of_class(node, "cell"))):
            labels = read_labels(cell)
            if labels and not stays_open(cell):
                fold(cell, labels)


def read_labels(cell: nodes.Element) -> list[str]:
    """Return the labels of a cell's checks, or nothing if it has another output."""
    outputs = [part for part in cell if is_of_class(part, "cell_output")]
    blocks = [block for output in outputs for block in output]
    if not all(is_of_class(block, "stream") for block in blocks):
        return []
    lines = "\n".join(block.astext() for block in blocks).strip().split("\n")
    if not all(line.startswith("✔ ") for line in lines):
        return []
    return list(dict.fromkeys(PRECISION.sub("", line.removeprefix("✔ ")) for line in lines))


def stays_open(cell: nodes.Element) -> bool:
    """Return whether a cell has the tag `show-code` or is in a solution."""
    around = cell
    while around is not None and not is_of_class(around, "solution"):
        around = around.parent
    return around is not None or is_of_class(cell, "tag_show-code")


def fold(cell: nodes.Element, labels: list[str]) -> None:
    """Put a cell into `<details>`, whose summary names the compared values."""
    more = f"; and {len(labels) - MAX_LABELS} more" if len(labels) > MAX_LABELS else ""
    line = escape("; ".join(labels[:MAX_LABELS]) + more)
    start = f'<details class="check"><summary>✔ {line}</summary>'
    raw = [nodes.raw("", html, format="html") for html in (start, "</details>")]
    cell[:] = [raw[0], *cell.children, raw[1]]


def mark_output(output: nodes.Element) -> None:
    """Give an output a class if it only checks or prints columns, and its checks their lines."""
    blocks = list(output.findall(nodes.literal_block))
    lines = "\n".join(block.astext().strip() for block in blocks).split("\n")
    others = [line for line in lines if not line.startswith("✔")]
    if not others:
        output["classes"].append("proof")
    elif IN_COLUMNS.search("\n".join(others)):
        output["classes"].append("columns")
    if len(others) < len(lines):
        for block in blocks:
            block.rawsource = ""  # Sphinx then writes the block's nodes
            block[:] = [mark_line(line) for line in block.astext().rstrip().split("\n")]


def mark_line(line: str) -> nodes.inline:
    """Return a line of an output, in which a unit and an exponent stay with their number."""
    holds = line.startswith("✔")
    text = line.replace("N m", "N\N{NO-BREAK SPACE}m") if holds else line
    parts = [
        nodes.inline("", part, classes=["number"]) if k % 2 else nodes.Text(part)
        for k, part in enumerate(SMALL_NUMBER.split(f"{text}\n"))
    ]
    return nodes.inline("", "", *parts, classes=["holds"] if holds else [])


def mark_outputs(_app: Sphinx, doctree: nodes.document, _name: str) -> None:
    for output in doctree.findall(lambda node: is_of_class(node, "cell_output")):
        mark_output(output)


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_transform(FoldChecks)
    app.connect("doctree-resolved", mark_outputs, priority=901)  # after `tools.pages`
    return {"parallel_read_safe": True, "parallel_write_safe": True}
