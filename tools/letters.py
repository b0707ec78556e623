"""A Sphinx extension: of KaTeX's faces a page fetches only the letters that the book's formulas
have, half of their bytes.
"""

import re
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from sphinx.application import Sphinx

FACES = Path("vendor", "katex")
FORMULA = re.compile(r"<var.*?>(.*?)</var>")
HEARD = re.compile(r"<math.*?</math>")
SLANTED = re.compile(r"<i[^>]*>(.*?)</i>")


def letters(pages: list[str]) -> tuple[str, str]:
    """What stands upright in the formulas of pages, and what is slanted."""
    seen = HEARD.sub("", " ".join(formula for page in pages for formula in FORMULA.findall(page)))
    return re.sub("<.*?>", "", SLANTED.sub("", seen)), "".join(SLANTED.findall(seen))


def cut(source: Path, text: str, target: Path) -> None:
    """Write a face with the letters of a text alone."""
    font, subsetter = TTFont(source), Subsetter(Options())
    subsetter.populate(text=text)
    subsetter.subset(font)
    font.flavor = "woff2"
    font.save(target)


def cut_all(app: Sphinx, error: Exception | None) -> None:
    if error or app.builder.format != "html":
        return
    built = Path(app.outdir)
    upright, slanted = letters([page.read_text("utf-8") for page in built.rglob("*.html")])
    for source in Path(app.srcdir, "assets", FACES).glob("*.woff2"):
        text = slanted if "Italic" in source.name else upright
        cut(source, text, built / "_static" / FACES / source.name)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("build-finished", cut_all)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
