"""Write the still form of live figures and answer forms into the book's pages.

The page's own scripts build each of them here, in a document that only writes HTML (paper.js). The
page shows this HTML until its scripts have loaded, without JavaScript, and on paper.
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
LIGHT_THEME = ' data-theme="light"'  # marks a card that is built without a browser
PAPER = Path(__file__).with_name("paper.js")
EXPLORER_START = re.compile(r'<div class="arm-explorer[^>]*>')
FIGURE_KIND = re.compile(r'data-figure="(\w+)"')
BOOK_PAGE = re.compile(r'href="((?:check_your_homework|explorer)\.html)')  # links of a form
STYLE = re.compile(r"<style>(.*?)</style>", re.S)
JSON_DATA = re.compile(r'<script type="application/json">(.*)</script>', re.S)

# Builds a live figure, or an answer form if the judge's bundle is loaded. READ_HTML reads its HTML
# once all promises are settled.
BUILD = """(figureKind, data, number) => {
    globalThis.container = document.createElement("div");
    container.append(Object.assign(document.createElement("script"), { textContent: data }));
    if (figureKind) container.dataset.figure = figureKind;
    if (globalThis.ArmExplorer) ArmExplorer.mount(container);
    else ArmJudge.mount(container, "", `still-${number}`);
}"""
READ_HTML = "JSON.stringify(container.shadowRoot?.outerHTML ?? container.innerHTML)"
STACK_BYTES = 8 << 20  # the judge's search for pairs of mistakes exceeds QuickJS' own 256 KiB

BuildHtml = Callable[[str, str, int], str]


class PageScripts:
    """The scripts of a page, and the style sheets that its figures share.

    Args:
        root: Path from the page to the top folder of the book, as "../".
    """

    def __init__(self, root: str = "") -> None:
        self.root = root
        self.form_count = 0
        self.styles: dict[str, str] = {}  # style sheets by name: "figure", "panel"

    @cached_property
    def build_explorer(self) -> BuildHtml:
        return load_script(ROOT / "helpers/explorer/static/explorer.js")

    @cached_property
    def build_form(self) -> BuildHtml:
        return load_script(ROOT / "helpers/checks/judge.js")

    def add_still_figure(self, html: str) -> str:
        """Return the HTML of a live figure with its still form inside."""
        start = EXPLORER_START.search(html)
        if start is None:
            return html
        kind = FIGURE_KIND.search(start[0])
        still = self.build_explorer(kind[1] if kind else "", JSON_DATA.search(html)[1], 0)
        still = still.replace(LIGHT_THEME, "", 1)  # the page's colours hold until the script runs
        style_name = "figure" if kind else "panel"
        self.styles[style_name] = STYLE.search(still)[1]
        link = f'<link rel="stylesheet" href="{self.root}_static/{style_name}.css">'
        page_html = html.replace(RUN_HINT, "", 1)  # a page has no cell to run
        return page_html[: start.end()] + STYLE.sub(link, still, count=1) + page_html[start.end() :]

    def add_form(self, html: str) -> str:
        """Return the end of a judge's HTML with the answer form before it."""
        self.form_count += 1
        form = self.build_form("", JSON_DATA.search(html)[1], self.form_count)
        return BOOK_PAGE.sub(rf'href="{self.root}\1', form) + html


def load_script(script: Path) -> BuildHtml:
    """Load a bundle, and return the function that builds the HTML of a live part.

    The function takes the kind of figure ("" for an explorer or a form), the part's data as JSON,
    and its number on the page.
    """
    context = quickjs.Context()
    context.set_max_stack_size(STACK_BYTES)
    for path in (PAPER, script):
        context.eval(path.read_text(encoding="utf-8"))
    build = context.eval(BUILD)

    def build_html(figure_kind: str, data: str, number: int) -> str:
        build(figure_kind, data, number)
        while context.execute_pending_job():
            pass
        return json.loads(context.eval(READ_HTML))

    return build_html


def add_stills(app: Sphinx, doctree: nodes.document, page_name: str) -> None:
    """Add the still form of each live part to a page, and write the style sheets they share."""
    scripts = PageScripts("../" * page_name.count("/"))
    for raw in list(doctree.findall(nodes.raw)):
        if raw.get("format") == "html":
            add_still = scripts.add_form if "judge" in raw else scripts.add_still_figure
            raw.replace_self(nodes.raw("", add_still(raw.astext()), format="html"))
    for style_name, rules in scripts.styles.items():
        sheet = Path(app.outdir, "_static", f"{style_name}.css")
        sheet.parent.mkdir(exist_ok=True)
        sheet.write_text(rules, "utf-8")
