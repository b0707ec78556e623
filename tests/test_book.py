"""Test the built pages: complete, with working links, and with no file from another server."""

import json
import os
import re
import time
from functools import cache
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urldefrag

import pytest
from fontTools.ttLib import TTFont

from tools.numbering import list_notebooks, page_name

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
NAMES = re.findall(
    r"(?:file|root): (\S+)", (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
)

# Ids in the pages of commit e0e3bff4, except those generated from Python names or by scripts.
OLD_IDS = json.loads((ROOT / "book" / "old_anchors.json").read_text(encoding="utf-8"))

SHEETS = [name for name in NAMES if name.startswith("answers/")]

every_page = pytest.mark.parametrize("name", NAMES)


class Page(HTMLParser):
    """Parse a page's kinds of elements, ids, links, loaded files, pictures and meta tags."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids, self.links, self.loads, self.pictures, self.meta = set(), [], [], [], {}
        self.moved, self.left = {}, None  # target of each part that has left the page, by its id
        self.kinds = set()  # tag, class and names of attributes
        self.span_classes = []  # classes of the last <span> before this point
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.kinds.add((tag, attrs.get("class"), *sorted(attrs)))
        self.ids |= {attrs[key] for key in ("id", "name") if attrs.get(key)}
        if tag == "ul":
            self.left = "" if attrs.get("class") == "moved" else None
        if tag == "li" and self.left is not None:
            self.left = attrs["id"]
        if tag == "a" and self.left:
            self.moved[self.left] = attrs["href"]
        if tag == "a" and attrs.get("href"):
            self.links.append(attrs["href"])
        if tag == "link" and attrs.get("rel") != "canonical":
            self.loads.append(attrs.get("href", ""))
        if tag in ("script", "img", "iframe", "source") and attrs.get("src"):
            self.loads.append(attrs["src"])
        if tag == "img":
            self.pictures.append(attrs | {"in": self.span_classes})
        if attrs.get("role") == "img":
            self.pictures.append({"alt": attrs["aria-label"], "src": "", "in": []})
        if tag == "meta" and "name" in attrs:
            self.meta[attrs["name"]] = attrs.get("content", "")
        parts = (attrs.get("class") or "").split()
        self.span_classes = parts if tag == "span" else self.span_classes

    def handle_endtag(self, tag):
        if tag == "ul":
            self.left = None


@cache
def page(path: Path) -> Page:
    """Return the parsed page from a cache."""
    return Page(path.read_text(encoding="utf-8"))


def local_path(url: str) -> str:
    """Return the file part of a URL, without query and fragment."""
    return unquote(urldefrag(url)[0].split("?")[0])


def wait_until_built():
    """Wait for `make test` to finish the book, which it builds while the first tests run.

    It then writes the exit status of the build into the file that BUILT names.
    """
    status_file = os.environ.get("BUILT")
    while status_file and not (ROOT / status_file).exists():
        time.sleep(0.2)
    assert not status_file or (ROOT / status_file).read_text("utf-8").strip() == "0", (
        "`make book` has failed"
    )
    assert (HTML / "index.html").exists(), "the book is not built: run `make book` first"


@pytest.fixture(scope="module", autouse=True)
def _built():
    wait_until_built()


@every_page
def test_page_is_built_and_up_to_date(name):
    assert (HTML / f"{name}.html").exists()
    source = next(p for p in (ROOT / f"book/{name}.ipynb", ROOT / f"book/{name}.md") if p.exists())
    is_generated = source.parent.name == "answers"  # written after the build's stamp
    stamp = (HTML / ".whole").stat().st_mtime
    assert is_generated or stamp >= source.stat().st_mtime, "run `make book`"


@every_page
def test_page_loads_only_local_files(name):
    here = HTML / f"{name}.html"
    for url in page(here).loads:
        assert not re.match(r"(https?:)?//", url), url
        assert url.startswith(("data:", "#")) or (here.parent / local_path(url)).exists(), url


@every_page
def test_page_links_have_targets(name):
    here = HTML / f"{name}.html"
    for url in page(here).links:
        if re.match(r"(https?|mailto|javascript):", url):
            continue
        target = here.parent / local_path(url) if local_path(url) else here
        assert target.exists(), url
        anchor = urldefrag(url)[1]
        if (
            anchor and target.suffix == ".html" and "=" not in anchor
        ):  # "=" marks a state of the explorer
            assert unquote(anchor) in page(target).ids, url


@every_page
def test_pictures_have_alt_text(name):
    """The panels of a drawing take the alternative text of their span."""
    for picture in page(HTML / f"{name}.html").pictures:
        alt = picture.get("alt")
        assert alt is not None, picture
        assert alt.strip() or {"picture", "panel"} & {*picture["in"]}, picture
        assert not re.search(r"_images/|\.svg$|[0-9a-f]{20}", alt), picture


@every_page
def test_page_has_a_description(name):
    assert len(page(HTML / f"{name}.html").meta.get("description", "")) > 40


@every_page
def test_page_has_no_unrendered_markup(name):
    text = (HTML / f"{name}.html").read_text(encoding="utf-8")
    body = re.sub(r"(?s)<(pre|script|style|code)\b.*?</\1>", "", text)
    assert not re.search(r"\{(ref|eq|doc|numref|cite|footcite:p)\}`", body)
    assert not re.search(
        r"```\{|Alias for field number", body
    )  # the last text is a default docstring of namedtuple
    assert not re.search(r"\(\(\d+\.\d+\)\)", re.sub(r"<[^>]+>", "", body)), "brackets in brackets"


@pytest.mark.parametrize("name", OLD_IDS)
def test_address_of_the_fifth_edition_leads_somewhere(name):
    """An old anchor exists on its page, or the page links to the place where that section is now.

    A heading that changes keeps its old id in an empty anchor: ``<a id="old"></a>``.
    """
    here = HTML / f"{name}.html"
    assert not set(OLD_IDS[name]) - page(here).ids
    for anchor in set(OLD_IDS[name]) & set(page(here).moved):
        url = page(here).moved[anchor]
        target = here.parent / local_path(url) if local_path(url) else here
        part = unquote(urldefrag(url)[1])
        assert target.exists(), url
        assert not part or part in page(target).ids - set(page(target).moved), url


def test_stylesheets_load_only_local_files():
    for sheet in HTML.rglob("*.css"):
        for url in re.findall(r"url\(['\"]?([^'\")]+)", sheet.read_text(encoding="utf-8")):
            assert not re.match(r"(https?:)?//", url), f"{sheet.name}: {url}"


@pytest.mark.parametrize("path", list_notebooks(), ids=page_name)
def test_page_offers_the_notebook_of_the_repository(path):
    here = HTML / f"{page_name(path)}.html"
    (link,) = [url for url in page(here).links if re.search(rf"_sources/.*{path.name}$", url)]
    assert (here.parent / link).read_bytes() == path.read_bytes()


@pytest.mark.parametrize("name", SHEETS[1:])
def test_sheet_has_the_kinds_of_elements_of_the_first(name):
    """Therefore browser/test_pages.py tests only the first sheet with axe."""
    first, sheet = (
        Page(re.sub(r"(?s)<math\b.*?</math>", "", (HTML / f"{name}.html").read_text("utf-8")))
        for name in (SHEETS[0], name)
    )
    assert sheet.kinds == first.kinds


NOT_TEXT = re.compile(r"(?s)<(pre|script|style|code|math|svg)\b.*?</\1>|<[^>]*>")
TEX = re.compile(r"\\[(\[A-Za-z]|\$")


@every_page
def test_formulas_are_mathml_not_tex(name):
    """No TeX is left in the text or as an annotation of the MathML."""
    text = (HTML / f"{name}.html").read_text(encoding="utf-8")
    assert TEX.findall(NOT_TEXT.sub(" ", text)) == []
    assert "<annotation" not in text


def test_math_font_has_every_character_used():
    """The font file was once reduced to a list of characters, so a new formula may need another."""
    text = " ".join(path.read_text(encoding="utf-8") for path in HTML.rglob("*.html"))
    characters = {*unescape("".join(re.findall("<m[ino]\\b[^>]*>(.*?)</m", text)))}
    invisible = {*"\u2061\u200b"}  # function application, zero-width space
    font = TTFont(HTML / "_static" / "vendor" / "stix" / "stix-two-math.woff2")
    assert characters - invisible <= {*map(chr, font.getBestCmap())}
