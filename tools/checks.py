"""A Sphinx extension that folds code cells whose only outputs are checks.

A cell whose outputs are lines of `helpers.checks.check` alone shows one line on its page, with what
was compared; its code and its full output open with a click. Solutions stay as they are, since
their code is what the reader asked for, and so do cells with the tag `show-code`.
"""

import re
from html import escape

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

from tools.plain_markdown import is_of_class

PRECISION = re.compile(r" \(within [^()]*\)$")
MAX_LABELS = 3  # labels shown for a cell; more labels are only counted


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


def setup(app: Sphinx) -> dict[str, bool]:
    app.add_transform(FoldChecks)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
