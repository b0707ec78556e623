"""Write the still form of live figures into the book's pages.

The page's own script builds each of them here, in a document that only writes HTML (paper.js). The
page shows this HTML until the script has loaded, without JavaScript, and on paper.
"""

import json
import re
from collections.abc import Callable
from functools import cached_property
from pathlib import Path

import quickjs
from docutils import nodes
from sphinx.application import Sphinx

from helpers.explorer.stub import RUN_HINT

ROOT = Path(__file__).parents[1]
LIGHT_THEME = ' data-theme="light"'  # attribute of a card that is built without a browser
PAPER = Path(__file__).with_name("paper.js")
EXPLORER_START = re.compile(r'<div class="arm-explorer[^>]*>')
FIGURE_KIND = re.compile(r'data-figure="(\w+)"')
STYLE = re.compile(r"<style>(.*?)</style>", re.S)
JSON_DATA = re.compile(r'<script type="application/json">(.*)</script>', re.S)

# Script that builds a live figure. READ_HTML returns its HTML after all promises are settled.
BUILD = """(figureKind, data) => {
    globalThis.container = document.createElement("div");
    container.append(Object.assign(document.createElement("script"), { textContent: data }));
    if (figureKind) container.dataset.figure = figureKind;
    ArmExplorer.mount(container);
}"""
READ_HTML = "JSON.stringify(container.shadowRoot.outerHTML)"

BuildHtml = Callable[[str, str], str]


class PageScripts:
    """The live figures of a page, and the style sheets that its figures share.

    Args:
        root: Path from the page to the top folder of the book, as "../".
    """

    def __init__(self, root: str = "") -> None:
        self.root = root
        self.styles: dict[str, str] = {}  # style sheets by name: "figure", "panel"

    @cached_property
    def build_explorer(self) -> BuildHtml:
        return load_script(ROOT / "helpers/explorer/static/explorer.js")

    def add_still_figure(self, html: str) -> str:
        """Return the HTML of a live figure with its still form inside."""
        start = EXPLORER_START.search(html)
        if start is None:
            return html
        kind = FIGURE_KIND.search(start[0])
        still = self.build_explorer(kind[1] if kind else "", JSON_DATA.search(html)[1])
        still = still.replace(LIGHT_THEME, "", 1)  # the page sets the theme until the script runs
        style_name = "figure" if kind else "panel"
        self.styles[style_name] = STYLE.search(still)[1]
        link = f'<link rel="stylesheet" href="{self.root}_static/{style_name}.css">'
        page_html = html.replace(RUN_HINT, "", 1)  # pages have no cells to run
        return page_html[: start.end()] + STYLE.sub(link, still, count=1) + page_html[start.end() :]


def load_script(script: Path) -> BuildHtml:
    """Load a bundle, and return the function that builds the HTML of a live figure.

    The function takes the kind of figure ("" for an explorer) and its data as JSON.
    """
    context = quickjs.Context()
    for path in (PAPER, script):
        context.eval(path.read_text(encoding="utf-8"))
    build = context.eval(BUILD)

    def build_html(figure_kind: str, data: str) -> str:
        build(figure_kind, data)
        while context.execute_pending_job():
            pass
        return json.loads(context.eval(READ_HTML))

    return build_html


def add_stills(app: Sphinx, doctree: nodes.document, page_name: str) -> None:
    """Add the still form of each live figure to a page, and write the style sheets they share."""
    scripts = PageScripts("../" * page_name.count("/"))
    for raw in list(doctree.findall(nodes.raw)):
        if raw.get("format") == "html":
            html = scripts.add_still_figure(raw.astext())
            raw.replace_self(nodes.raw("", html, format="html"))
    for style_name, rules in scripts.styles.items():
        sheet = Path(app.outdir, "_static", f"{style_name}.css")
        sheet.parent.mkdir(exist_ok=True)
        sheet.write_text(rules, "utf-8")
