"""What the live parts of a page look like before their scripts have come: as the same scripts build
them, in a document that only writes HTML (paper.js). Without a script and on paper it stays so."""

import json
import re
from functools import cached_property
from pathlib import Path

import quickjs
from docutils import nodes
from sphinx.application import Sphinx

ROOT = Path(__file__).parents[1]
PAPER = Path(__file__).with_name("paper.js")
PLACE = re.compile(r'<div class="arm-explorer[^>]*>')
FIGURE = re.compile(r'data-figure="(\w+)"')
STYLE = re.compile(r"<style>(.*?)</style>", re.S)
DATA = re.compile(r'<script type="application/json">(.*)</script>', re.S)

# A live part, by the JSON that stands in its place, and its HTML once its long work is done.
BUILT = """(figure, data, number) => {
    globalThis.place = document.createElement("div");
    place.append(Object.assign(document.createElement("script"), { textContent: data }));
    if (figure) place.dataset.figure = figure;
    if (globalThis.ArmExplorer) ArmExplorer.mount(place);
    else ArmJudge.mount(place, "", `still-${number}`);
}"""
WRITTEN = "JSON.stringify(place.shadowRoot?.outerHTML ?? place.innerHTML)"


class Scripts:
    """The scripts of one page, whose parts are numbered from 1; `root` leads to the book's top."""

    def __init__(self, root: str = "") -> None:
        self.root, self.count = root, 0
        self.styles: dict[str, str] = {}  # of explorers, by the name of their sheet

    @cached_property
    def explorer(self):
        return self._started(ROOT / "helpers/explorer/static/explorer.js")

    @cached_property
    def judge(self):
        return self._started(ROOT / "helpers/checks/judge.js")

    @staticmethod
    def _started(script: Path):
        context = quickjs.Context()
        context.set_max_stack_size(8 << 20)
        for path in (PAPER, script):
            context.eval(path.read_text(encoding="utf-8"))
        build = context.eval(BUILT)

        def html(*given: object) -> str:
            build(*given)
            while context.execute_pending_job():
                pass
            return json.loads(context.eval(WRITTEN))

        return html

    def drawn(self, html: str) -> str:
        """An arm's place, with what it looks like in it."""
        place = PLACE.search(html)
        if place is None:
            return html
        figure = FIGURE.search(place[0])
        still = self.explorer(figure[1] if figure else "", DATA.search(html)[1], 0)
        styles = "figure" if figure else "panel"
        self.styles[styles] = STYLE.search(still)[1]
        link = f'<link rel="stylesheet" href="{self.root}_static/{styles}.css">'
        return html[: place.end()] + STYLE.sub(link, still, count=1) + html[place.end() :]

    def form(self, html: str) -> str:
        """The end of a judge's place, with its form before it."""
        self.count += 1
        return self.judge("", DATA.search(html)[1], self.count) + html


def draw(app: Sphinx, doctree: nodes.document, name: str) -> None:
    """Draw every live part of a page; the styles of all stand in a sheet each."""
    scripts = Scripts("../" * name.count("/"))
    for raw in list(doctree.findall(nodes.raw)):
        if raw.get("format") == "html":
            make = scripts.form if "judge" in raw else scripts.drawn
            raw.replace_self(nodes.raw("", make(raw.astext()), format="html"))
    for styles, text in scripts.styles.items():
        sheet = Path(app.outdir, "_static", f"{styles}.css")
        sheet.parent.mkdir(exist_ok=True)
        sheet.write_text(text, "utf-8")
