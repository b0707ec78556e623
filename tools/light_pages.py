"""A Sphinx extension: lighter pages. It takes out of the built HTML what the theme loads and the book does not use.

The theme draws its few icons twice, by a font and by 1.5 MB of script; the font does. It loads the search index on every
page for a search-as-you-type that is off. Its small scripts hold up the first paint. And pictures get their size, so that nothing moves when they arrive.
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
    r'<script (src="[^"]*/(?:doctools|sphinx_highlight|clipboard\.min|copybutton|sphinx-book-theme|togglebutton)\.js)'
)
PICTURE = re.compile(r'<img (?![^>]*\bheight=)([^>]*\bsrc="([^"]+\.svg)"[^>]*?)\s*/?>')
POINT = {"pt": 4 / 3, "px": 1.0, "": 1.0}


def lighter(html: str, folder: Path, search: bool = False) -> str:
    """A page without unused scripts, its SVG pictures with width and height; `folder` is where it stands."""
    html = WAITING.sub(r"<script defer \1", ICONS.sub("", html))
    if not search:
        html = SEARCH.sub("", html)
    return PICTURE.sub(lambda found: _sized(*found.groups(), folder), html)


def _sized(attributes: str, source: str, folder: Path) -> str:
    size = _size(folder / source)
    return f"<img {attributes} {size}/>" if size else f"<img {attributes}/>"


@cache
def _size(path: Path) -> str:
    """The width and height attributes of an SVG file, in CSS pixels; nothing where it does not say."""
    root = ET.parse(path).getroot() if path.exists() else ET.Element("svg")
    sides = [re.fullmatch(r"([\d.]+)(pt|px|)", root.get(name, "")) for name in ("width", "height")]
    if None in sides:
        return ""
    width, height = (round(float(s[1]) * POINT[s[2]]) for s in sides)
    return f'width="{width}" height="{height}"'


def rewrite(app, error) -> None:
    """Rewrite every page that was built."""
    if error is None and app.builder.format == "html":
        for path in Path(app.outdir).glob("*.html"):
            old = path.read_text(encoding="utf-8")
            new = lighter(old, path.parent, search=path.stem == "search")
            if new != old:
                path.write_text(new, encoding="utf-8")


def setup(app) -> dict[str, bool]:
    app.connect("build-finished", rewrite)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
