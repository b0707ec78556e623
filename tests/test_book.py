"""The built pages: whole, linked, and needing nothing from elsewhere."""

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

ROOT = Path(__file__).parents[1]
HTML = ROOT / "book" / "_build" / "html"
NAMES = re.findall(
    r"(?:file|root): (\S+)", (ROOT / "book" / "_toc.yml").read_text(encoding="utf-8")
)

# Ids in the text of the pages of 0b8c1d9, without those that Python names and page scripts make.
OLD_IDS = json.loads((ROOT / "tests" / "page_ids.json").read_text(encoding="utf-8"))

every_page = pytest.mark.parametrize("name", NAMES)


class Page(HTMLParser):
    """What a test needs to know of a page: its ids, links, loaded files and pictures."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids, self.links, self.loads, self.pictures, self.meta = set(), [], [], [], {}
        self.within = []  # the last span
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.ids |= {attrs[key] for key in ("id", "name") if attrs.get(key)}
        if tag == "a" and attrs.get("href"):
            self.links.append(attrs["href"])
        if tag == "link" and attrs.get("rel") != "canonical":
            self.loads.append(attrs.get("href", ""))
        if tag in ("script", "img", "iframe", "source") and attrs.get("src"):
            self.loads.append(attrs["src"])
        if tag == "img":
            self.pictures.append(attrs | {"in": self.within})
        if attrs.get("role") == "img":
            self.pictures.append({"alt": attrs["aria-label"], "src": "", "in": []})
        if tag == "meta" and "name" in attrs:
            self.meta[attrs["name"]] = attrs.get("content", "")
        parts = (attrs.get("class") or "").split()
        self.within = parts if tag == "span" else self.within


@cache
def page(path: Path) -> Page:
    return Page(path.read_text(encoding="utf-8"))


def local(url: str) -> str:
    return unquote(urldefrag(url)[0].split("?")[0])


def wait_until_built():
    """`make test` builds the book beside the first tests, and then writes how that ended."""
    ended = os.environ.get("BUILT")
    while ended and not (ROOT / ended).exists():
        time.sleep(0.2)
    assert not ended or (ROOT / ended).read_text("utf-8").strip() == "0", "`make book` has failed"
    assert (HTML / "index.html").exists(), "the book is not built: run `make book` first"


@pytest.fixture(scope="module", autouse=True)
def _built():
    wait_until_built()


@every_page
def test_page_is_built_and_up_to_date(name):
    assert (HTML / f"{name}.html").exists()
    source = next(p for p in (ROOT / f"book/{name}.ipynb", ROOT / f"book/{name}.md") if p.exists())
    assert (HTML / ".whole").stat().st_mtime >= source.stat().st_mtime, "run `make book`"


@every_page
def test_page_loads_only_local_files(name):
    here = HTML / f"{name}.html"
    for url in page(here).loads:
        assert not re.match(r"(https?:)?//", url), url
        assert url.startswith(("data:", "#")) or (here.parent / local(url)).exists(), url


@every_page
def test_page_links_have_targets(name):
    here = HTML / f"{name}.html"
    for url in page(here).links:
        if re.match(r"(https?|mailto|javascript):", url):
            continue
        target = here if not local(url) else here.parent / local(url)
        assert target.exists(), url
        anchor = urldefrag(url)[1]
        if anchor and target.suffix == ".html" and "=" not in anchor:  # a state of the explorer
            assert unquote(anchor) in page(target).ids, url


@every_page
def test_pictures_have_alt_text(name):
    """A drawing, and all that is cut from it, has those of its place."""
    for picture in page(HTML / f"{name}.html").pictures:
        alt = picture.get("alt")
        assert alt is not None, picture
        assert alt.strip() or {"picture", "panel"} & {*picture["in"]}, picture
        assert not re.search(r"_images/|\.svg$|[0-9a-f]{20}", alt), picture


@every_page
def test_page_has_description_and_no_raw_markup(name):
    assert len(page(HTML / f"{name}.html").meta.get("description", "")) > 40
    text = (HTML / f"{name}.html").read_text(encoding="utf-8")
    body = re.sub(r"(?s)<(pre|script|style|code)\b.*?</\1>", "", text)
    assert not re.search(r"\{(ref|eq|doc|numref|cite|footcite:p)\}`", body)
    assert not re.search(r"```\{|Alias for field number", body)  # Python's, of a named tuple


@pytest.mark.parametrize("name", OLD_IDS)
def test_page_keeps_the_ids_of_the_fourth_edition(name):
    """A heading that changes keeps its old id in an empty anchor: ``<a id="old"></a>``."""
    assert not set(OLD_IDS[name]) - page(HTML / f"{name}.html").ids


def test_stylesheets_load_only_local_files():
    for sheet in HTML.rglob("*.css"):
        for url in re.findall(r"url\(['\"]?([^'\")]+)", sheet.read_text(encoding="utf-8")):
            assert not re.match(r"(https?:)?//", url), f"{sheet.name}: {url}"


@pytest.mark.parametrize("path", sorted((ROOT / "book").glob("*.ipynb")), ids=lambda p: p.stem)
def test_page_offers_the_notebook_of_the_repository(path):
    (link,) = [url for url in page(HTML / f"{path.stem}.html").links if url.endswith(path.name)]
    assert (HTML / link).read_bytes() == path.read_bytes()


UNREAD = re.compile(r"(?s)<(pre|script|style|code|math|svg)\b.*?</\1>|<[^>]*>")
TEX = re.compile(r"\\[(\[A-Za-z]|\$")


@every_page
def test_formulas_are_mathml_not_tex(name):
    """No TeX is left, beside it or within."""
    text = (HTML / f"{name}.html").read_text(encoding="utf-8")
    assert TEX.findall(UNREAD.sub(" ", text)) == []
    assert "<annotation" not in text


def test_math_font_has_every_character_used():
    """It was cut once, for more than this book says."""
    text = " ".join(path.read_text(encoding="utf-8") for path in HTML.rglob("*.html"))
    letters = {*unescape("".join(re.findall("<m[ino]\\b[^>]*>(.*?)</m", text)))}
    unseen = {*"\u2061\u200b"}  # marks of a function, and of an empty place
    face = TTFont(HTML / "_static" / "vendor" / "stix" / "stix-two-math.woff2")
    assert letters - unseen <= {*map(chr, face.getBestCmap())}
