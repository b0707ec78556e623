"""A Sphinx extension: lighter pages. It takes out of what was built what the theme loads and the book does not use.

The theme draws its few icons twice, by a font and by 1.5 MB of script; the font does. It loads the search index on every
page for a search-as-you-type that is off, brings rules for thousands of classes, and holds up the first paint with small scripts that can wait. And pictures get
their size, so that nothing moves when they arrive, and arrive when they are near. What stands right behind a formula stays
with it at the end of a line.
"""

import re
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path

ICONS = re.compile(r'\s*<script [^>]*src="[^"]*scripts/fontawesome\.js[^"]*"></script>')
SEARCH = re.compile(
    r'\s*<script src="[^"]*(?:searchtools|language_data|searchindex)\.js"></script>'
)
WAITING = re.compile(
    r'<script ((?:data-\S+ )?src="[^"]*/'
    r"(?:doctools|sphinx_highlight|clipboard\.min|copybutton|sphinx-book-theme|togglebutton|design-tabs)\.js)"
)
RULE = re.compile(r"([^{};]+)\{[^{}]*\}")
CLASS = re.compile(r"\.(-?[_a-zA-Z][\w-]*)")
PARENTHESES = re.compile(r":[\w-]+\([^()]*\)")
PICTURE = re.compile(r'<img (?![^>]*\bheight=)([^>]*\bsrc="([^"]+\.svg)"[^>]*?)\s*/?>')
FORMULA = re.compile(
    r'(?<!<span class="nowrap">)(<span class="math notranslate nohighlight">[^<]*</span>)([,.;:!?)”’]+)'
)
WIDE = 700  # CSS pixels: a figure of several panels, which a phone shows larger than itself
POINT = {"pt": 4 / 3, "px": 1.0, "": 1.0}


def lighter(html: str, folder: Path, search: bool = False) -> str:
    """A page without unused scripts, its SVG pictures with width and height, its formulas with their punctuation.

    `folder` is where it stands. The page of the search results keeps its scripts and their order.
    """
    html = ICONS.sub("", html)
    if not search:
        html = WAITING.sub(r"<script defer \1", SEARCH.sub("", html))
    html = FORMULA.sub(r'<span class="nowrap">\1\2</span>', html)
    return PICTURE.sub(lambda found: _sized(*found.groups(), folder), html)


def _sized(attributes: str, source: str, folder: Path) -> str:
    size = _size(folder / source)
    if not size:
        return f"<img {attributes}/>"
    width, height = size
    wide = ' class="wide"' if width > WIDE and "class=" not in attributes else ""
    return f'<img {attributes} width="{width}" height="{height}" loading="lazy"{wide}/>'


@cache
def _size(path: Path) -> tuple[int, int] | None:
    """The width and height of an SVG file, in CSS pixels; nothing where it does not say."""
    root = ET.parse(path).getroot() if path.exists() else ET.Element("svg")
    sides = [re.fullmatch(r"([\d.]+)(pt|px|)", root.get(name, "")) for name in ("width", "height")]
    if None in sides:
        return None
    width, height = (round(float(s[1]) * POINT[s[2]]) for s in sides)
    return width, height


def without_unused(css: str, words: set[str]) -> str:
    """A style sheet without the rules that need a class which no page and no script names."""
    css = re.sub(r"(?s)/\*.*?\*/", "", css)
    return RULE.sub(lambda rule: rule[0] if _may_match(rule[1], words) else "", css)


def _may_match(selectors: str, words: set[str]) -> bool:
    """Whether one of the selectors may; what is in parentheses may be an alternative or a negation, and is not asked."""
    while PARENTHESES.search(selectors):
        selectors = PARENTHESES.sub("", selectors)
    if "\\" in selectors or "@" in selectors:
        return True
    return any(words.issuperset(CLASS.findall(selector)) for selector in selectors.split(","))


def rewrite(app, error) -> None:
    """Rewrite the pages and the theme's style sheet, once all are built."""
    if error is not None or app.builder.format != "html":
        return
    out = Path(app.outdir)
    pages = {path: path.read_text(encoding="utf-8") for path in out.glob("*.html")}
    for path, html in pages.items():
        _write(path, lighter(html, out, search=path.stem == "search"))
    scripts = [path for path in out.glob("_static/**/*.js") if path.name != "fontawesome.js"]
    texts = [*pages.values(), *(path.read_text(encoding="utf-8") for path in scripts)]
    words = {word for text in texts for word in re.findall(r"[\w-]+", text)}
    for path in [*out.glob("_static/styles/*.css"), *out.glob("_static/*.css")]:
        _write(path, without_unused(path.read_text(encoding="utf-8"), words))


def _write(path: Path, text: str) -> None:
    if text != path.read_text(encoding="utf-8"):
        path.write_text(text, encoding="utf-8")


def without_repository(app, config) -> None:
    """Offer nothing to launch where no repository's address is configured; the theme would fail."""
    if not config.html_theme_options.get("repository_url"):
        config.html_theme_options["launch_buttons"] = {}


def setup(app) -> dict[str, bool]:
    app.connect("config-inited", without_repository)
    app.connect("build-finished", rewrite)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
