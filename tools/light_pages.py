"""A Sphinx extension: lighter pages. It takes out of what was built what the theme loads and the
book does not use.

The theme draws its few icons twice, by a font and by 1.5 MB of script; the font does. It loads the
search index on every page for a search-as-you-type that is off, brings rules for thousands of
classes in ten files, and holds up the first paint with scripts that can wait. Half of a chapter is
spans around names and commas of code, in the colour that all code has. And pictures get their size,
so that nothing moves when they arrive, and arrive when they are near. What stands right behind a
formula stays with it at the end of a line.
"""

import os
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from functools import cache
from html import unescape
from pathlib import Path
from zlib import crc32

ICONS = re.compile(r'\s*<script [^>]*src="[^"]*scripts/fontawesome\.js[^"]*"></script>')
SEARCH = re.compile(
    r'\s*<script src="[^"]*(?:searchtools|language_data|searchindex)\.js"></script>'
)
WAITING = re.compile(
    r'<script ((?:data-\S+ )?src="[^"]*/'
    r"(?:doctools|sphinx_highlight|clipboard\.min|copybutton|sphinx-book-theme|togglebutton"
    r"|design-tabs)\.js)"
)
OPTIONS = re.compile(r'<script src="([^"?]*/documentation_options\.js)[^>]*></script>')
PRELOAD = re.compile(r'\s*<link rel="preload" as="script"[^>]*>')
SHEET = re.compile(r'\s*<link (?!data-of)[^>]*href="(_static/[^"?]+\.css)[^>]*>')
SHEETS = re.compile(r'<link data-of="([^"]+)"[^>]*>')
IMPORT = re.compile(r'@import "([^"]+)";')
ADDRESS = re.compile(r"url\(([\w./-]+)\)")
COLOUR = re.compile(
    r'data-theme="(\w+)"\] \.highlight (?:\.(\w+) )?\{ (?:background: #\w+; )?color: (#\w+) \}'
)
CODE = re.compile(r'(?s)<div class="highlight"><pre>.*?</pre>')
RULE = re.compile(r"([^{};]+)\{[^{}]*\}")
CLASS = re.compile(r"\.(-?[_a-zA-Z][\w-]*)")
PARENTHESES = re.compile(r":[\w-]+\([^()]*\)")
PICTURE = re.compile(r'<img (?![^>]*\bheight=)([^>]*\bsrc="([^"]+\.svg)"[^>]*?)\s*/?>')
PROPERTY = re.compile(r'(?<=[{;])\s*(--[\w-]+):(?:"[^"]*"|[^;{}"])*(?:;|(?=\}))')
FORMULA = re.compile(
    r'(?<!<span class="nowrap">)(<span class="math notranslate'
    r' nohighlight">[^<]*</span>)([,.;:!?)”’]+)'
)
UNSET = re.compile(r'(<span class="math notranslate nohighlight")>(\\\([^<]*\\\))')
SIGN = re.compile(r"\\[a-zA-Z]+|[^\s{}\\^_]")
ALL = "_static/all.css"
NEAR = 3000  # characters from an article's start: a picture there is seen at once
WIDE = 700  # CSS pixels: a figure of several panels, which a phone shows larger than itself
POINT = {"pt": 4 / 3, "px": 1.0, "": 1.0}


def lighter(html: str, folder: Path, search: bool = False) -> str:
    """A page without unused scripts, its SVG pictures with width and height, its formulas with
    their punctuation.

    `folder` is where it stands. The page of the search results keeps its scripts and their order.
    """
    html = PRELOAD.sub("", ICONS.sub("", html))
    html = OPTIONS.sub(lambda script: _inline(folder / script[1]), html)
    if not search:
        html = WAITING.sub(r"<script defer \1", SEARCH.sub("", html))
    html = FORMULA.sub(r'<span class="nowrap">\1\2</span>', html)
    html = UNSET.sub(lambda tex: f'{tex[1]} style="--unset:{size_unset(tex[2])}">{tex[2]}', html)
    near = html.find("<article") + NEAR
    return PICTURE.sub(
        lambda found: _sized(*found.groups(), folder, late=found.start() > near), html
    )


def size_unset(tex: str) -> str:
    """The size at which TeX with its delimiters is about as wide as the formula: for so many signs,
    so many characters."""
    tex = unescape(tex)
    return f"{1.5 * len(SIGN.findall(tex[2:-2])) / len(tex):.2f}em"


def _inline(script: Path) -> str:
    return f"<script>{' '.join(script.read_text(encoding='utf-8').split())}</script>"


def _sized(attributes: str, source: str, folder: Path, late: bool) -> str:
    size = _size(folder / source)
    if not size:
        return f"<img {attributes}/>"
    width, height = size
    wide = ' class="wide"' if width > WIDE and "class=" not in attributes else ""
    lazy = ' loading="lazy"' if late else ""
    return f'<img {attributes} width="{width}" height="{height}"{lazy}{wide}/>'


@cache
def _size(path: Path) -> tuple[int, int] | None:
    """The width and height of an SVG file, in CSS pixels; nothing where it does not say."""
    root = ET.parse(path).getroot() if path.exists() else ET.Element("svg")
    sides = [re.fullmatch(r"([\d.]+)(pt|px|)", root.get(name, "")) for name in ("width", "height")]
    if None in sides:
        return None
    width, height = (round(float(s[1]) * POINT[s[2]]) for s in sides)
    return width, height


def one_sheet(html: str) -> str:
    """A page that asks for one style sheet, which names those it is made of, where it asked for
    many."""
    names = SHEET.findall(html)
    if not names:
        return html
    return SHEET.sub("", SHEET.sub(f"\n{_link(' '.join(names))}", html, count=1))


def _link(names: str, version: int = 0) -> str:
    return f'<link data-of="{names}" rel="stylesheet" href="{ALL}?v={version:x}"/>'


def whole_sheet(path: Path, folder: Path) -> str:
    """A style sheet with those that it imports, its addresses seen from `folder`."""
    css = path.read_text(encoding="utf-8")
    css = ADDRESS.sub(lambda a: f"url({os.path.relpath(path.parent / a[1], folder)})", css)
    return IMPORT.sub(lambda other: whole_sheet(path.parent / other[1], folder), css)


def plain_classes(css: str) -> set[str]:
    """The classes of code which have, in every colour mode, the colour of code without a class."""
    colours: dict[str, dict[str, str]] = {}
    for mode, name, colour in COLOUR.findall(css):
        colours.setdefault(mode, {})[name] = colour
    plain = [{name for name in of if name and of[name] == of[""]} for of in colours.values()]
    return set.intersection(*plain)


def without_spans(html: str, classes: set[str]) -> str:
    """Code without the spans of these classes, and without the empty ones that start each block."""
    span = re.compile(rf'<span(?: class="(?:{"|".join(sorted(classes))})")?>([^<]*)</span>')
    return CODE.sub(lambda code: span.sub(r"\1", code[0]), html)


def without_unused(css: str, words: set[str]) -> str:
    """A style sheet without spaces, properties that nothing reads, and rules for classes that
    nothing names."""
    css = re.sub(r"(?s)/\*.*?\*/", "", css)
    css = RULE.sub(lambda rule: rule[0] if _may_match(rule[1], words) else "", css)
    return _without_unread(re.sub(r"\s*([{};])\s*", r"\1", css), words)


def _without_unread(css: str, words: set[str]) -> str:
    """Without the properties that nothing reads, nor any that only they read."""
    read = words.union(re.findall(r"var\((--[\w-]+)", css))
    less = PROPERTY.sub(lambda found: found[0] if found[1] in read else "", css)
    return less if less == css else _without_unread(less, words)


def _may_match(selectors: str, words: set[str]) -> bool:
    """Whether one of the selectors may; what is in parentheses may be an alternative or a negation,
    and is not asked."""
    while PARENTHESES.search(selectors):
        selectors = PARENTHESES.sub("", selectors)
    if "\\" in selectors or "@" in selectors:
        return True
    return any(words.issuperset(CLASS.findall(selector)) for selector in selectors.split(","))


def rewrite(app, error) -> None:
    """Rewrite the pages and join the style sheets, once all are built."""
    if error is not None or app.builder.format != "html":
        return
    out = Path(app.outdir)
    plain = plain_classes((out / "_static/pygments.css").read_text(encoding="utf-8"))
    pages = {path: path.read_text(encoding="utf-8") for path in out.glob("*.html")}
    for path, html in pages.items():
        light = lighter(html, out, search=path.stem == "search")
        pages[path] = one_sheet(without_spans(light, plain))
    names = next(found[1] for found in map(SHEETS.search, pages.values()) if found)
    css = "".join(whole_sheet(out / name, (out / ALL).parent) for name in names.split())
    css = without_unused(css, _words(out, pages.values()))
    (out / ALL).write_text(css, encoding="utf-8")
    for path, html in pages.items():
        _write(path, SHEETS.sub(_link(names, crc32(css.encode())), html))


def _words(out: Path, pages: Iterable[str]) -> set[str]:
    """Every word of the pages and of their scripts: what may be the name of a class."""
    scripts = [path for path in out.glob("_static/**/*.js") if path.name != "fontawesome.js"]
    texts = [*pages, *(path.read_text(encoding="utf-8") for path in scripts)]
    return {word for text in texts for word in re.findall(r"[\w-]+", text)}


def _write(path: Path, text: str) -> None:
    if text != path.read_text(encoding="utf-8"):
        path.write_text(text, encoding="utf-8")


def without_repository(app, config) -> None:
    """Offer nothing to launch where no repository's address is configured; the theme would fail."""
    if not config.html_theme_options.get("repository_url"):
        config.html_theme_options["launch_buttons"] = {}


def assets(folder: Path, config) -> list[int]:
    """What a change of any asset changes: Sphinx copies them only if it has a page to write, and
    then writes all."""
    paths = (path for of in config.html_static_path for path in (folder / of).rglob("*.*"))
    return [crc32(path.read_bytes()) for path in sorted(paths)]


def setup(app) -> dict[str, bool]:
    app.add_config_value("assets", lambda config: assets(Path(app.srcdir), config), "html")
    app.connect("config-inited", without_repository)
    app.connect("build-finished", rewrite, priority=900)  # after the theme has coloured the code
    return {"parallel_read_safe": True, "parallel_write_safe": True}
