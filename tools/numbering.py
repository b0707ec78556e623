"""Check and update the numbers of figures, formulas and exercises in the sources.

`python -m tools.numbering` reports mistakes; `python -m tools.numbering --write` renumbers. The
numbers are written in the text, so that every reader of a notebook shows them:

- a caption, alone in its cell: ``<a id="fig-x"></a>``, then ``**Fig. 2.1.** Text``
- a formula: ``<a id="eq-x"></a>``, then ``$$``, TeX, ``\\tag{2.1}``, ``$$`` on lines of their own
- an exercise, first in its cell: ``<a id="ex-x"></a>``, then ``### Exercise 2.1: Title · time``
- a mention: a link, ``[Fig. 2.1](#fig-x)``, ``[(2.1)](02_jacobian.ipynb#eq-x)``
"""

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import nbformat
from sphinx.application import Sphinx
from sphinx.util import logging

LOGGER = logging.getLogger(__name__)
BOOK = Path(__file__).parents[1] / "book"
FOLDERS = ("exercises", "further")  # folders of notebooks other than chapters

ANCHOR = re.compile(r'<a id="([\w.-]+)"></a>')
HEADING = re.compile(r"(?m)^(#+) +(.+)$")
LINK = re.compile(r"\[((?:[^][]|\[[^][]*\])*)\]\((?!\w+:)([^()#\s]*)(?:#([^()\s]+))?\)")
SOLUTION = re.compile(r'(?:<a id="[\w.-]+"></a>\n+)*#### Solution')
MYST = re.compile(r"(?m)\{[a-z:_-]+\}`|^ *[`:]{3,}\{[\w-]+\}|^\([\w.-]+\)=\s*$")
CODE = re.compile(r"(?ms)^```.*?^```$|``.+?``|`[^`\n]+`")
MATH = re.compile(r"(?s)\$\$.*?\$\$|\$[^$\n]+(?:\n[^$\n]+)?\$")
IDS_FROM_SPHINX = re.compile(r"\{(eval-rst|bibliography)\}")  # their anchors come from Sphinx


class Kind(NamedTuple):
    """The notation of a kind of numbered item."""

    name: str
    item: re.Pattern  # groups: anchor, text up to the number, number
    attempt: re.Pattern  # text that looks like such an item, even if malformed
    form: str
    mention: re.Pattern


OLD_ANCHORS = r'\A(?:<a id="[\w.-]+"></a>\s+)*?'  # earlier anchors of an item
KINDS = (
    Kind(
        "figure",
        re.compile(rf'{OLD_ANCHORS}<a id="(fig-[\w-]+)"></a>(\n\n\*\*Fig\. )([\d.]+)\.\*\* (?=\S)'),
        re.compile(r'(?m)^\*+Fig\b|<a id="fig-'),
        'a cell of its own: <a id="fig-x"></a>, an empty line, **Fig. 2.1.** Text',
        re.compile(r"(Fig\. )([\d.]*\d)"),
    ),
    Kind(
        "formula",
        re.compile(
            r'<a id="(eq-[\w-]+)"></a>(\n\n\$\$\n(?:(?!\$\$)[^\0])*?\n\\tag\{)([\d.]+)\}\n\$\$'
        ),
        re.compile(r'\\tag\b|<a id="eq-'),
        r'<a id="eq-x"></a>, an empty line, then $$, the TeX, \tag{2.1} and $$ on their own lines',
        re.compile(r"(\()([\d.]*\d)(?=\))"),
    ),
    Kind(
        "exercise",
        re.compile(
            rf'{OLD_ANCHORS}<a id="(ex-[\w-]+)"></a>(\n\n### Exercise )([\d.]+)(?=: \S.* · \S)'
        ),
        re.compile(r'(?m)^#+ +Exercise\b|<a id="ex-'),
        'at the start of a cell: <a id="ex-x"></a>, an empty line, ### Exercise 2.1: Title · time',
        re.compile(r"([Ee]xercise )([\d.]*\d)"),
    ),
)
BARE_MENTION = re.compile(r"Fig\. [1-9]\.\d+|\([1-9]\.\d+\)|[Ee]xercise [1-9]\.\d+")


@dataclass(frozen=True)
class Cell:
    """A Markdown cell of a notebook, or a whole Markdown page."""

    path: Path
    index: int | None  # None for a page
    text: str
    is_folded: bool = False
    is_below_picture: bool = True

    def describe_position(self, offset: int = 0) -> str:
        """Describe the position of the text at an offset, for a message."""
        if self.index is None:
            return f"{self.path.name}, line {self.text.count(chr(10), 0, offset) + 1}"
        return f"{self.path.name}, cell {self.index}"


def read_cells(path: Path) -> list[Cell]:
    """Return the Markdown cells of a notebook, or a page as a single cell."""
    if path.suffix == ".md":
        return [Cell(path, None, path.read_text(encoding="utf-8"))]
    cells = nbformat.read(path, as_version=4).cells
    return [
        Cell(
            path,
            index,
            cell.source,
            cell.metadata.get("jp-MarkdownHeadingCollapsed", False),
            index > 0 and cells[index - 1].cell_type == "code",
        )
        for index, cell in enumerate(cells)
        if cell.cell_type == "markdown"
    ]


def list_notebooks(folder: Path = BOOK) -> list[Path]:
    """Return the book's notebooks: the chapters and pages, then those in FOLDERS."""
    return [path for name in ("", *FOLDERS) for path in sorted((folder / name).glob("*.ipynb"))]


def page_name(path: Path) -> str:
    """Return a notebook's name on the pages, such as further/limits."""
    folder = f"{path.parent.name}/" if path.parent.name in FOLDERS else ""
    return folder + path.stem


def read_book(folder: Path = BOOK) -> dict[Path, list[Cell]]:
    """Return the cells of every notebook and page, without the sheets in `answers`."""
    paths = [*list_notebooks(folder), *sorted(folder.glob("*.md"))]
    return {path.resolve(): read_cells(path) for path in paths}


def replace_with_spaces(pattern: re.Pattern, text: str) -> str:
    """Return the text with spaces in place of each match, so that offsets stay."""
    return pattern.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)


def find_items(kind: Kind, cells: list[Cell]) -> list[tuple[Cell, re.Match]]:
    """Return the well-formed items of a kind, in their order on the page."""
    return [
        (cell, match)
        for cell in cells
        for match in kind.item.finditer(replace_with_spaces(CODE, cell.text))
    ]


def number_items(kind: Kind, path: Path, book: dict[Path, list[Cell]]) -> list[str]:
    """Return the right numbers of a page's items of a kind, such as 2.1 in chapter 2.

    The exercises of a page in `exercises` continue those of the chapter of the same name.
    """
    source, before = path, 0
    if kind.name == "exercise" and path.parent.name == "exercises":
        source = next((file for file in book if re.fullmatch(rf"\d+_{path.name}", file.name)), path)
        before = len(find_items(kind, book[source])) if source != path else 0
    chapter = re.match(r"0*(\d+)_", source.name)
    prefix = f"{chapter[1]}." if chapter else ""
    count = len(find_items(kind, book[path]))
    return [f"{prefix}{before + position}" for position in range(1, count + 1)]


def count_items(book: dict[Path, list[Cell]]) -> dict[tuple[Path, str], str]:
    """Return the right number of each item, by its page and anchor."""
    return {
        (path, match[1]): number
        for path, cells in book.items()
        for kind in KINDS
        for number, (_, match) in zip(
            number_items(kind, path, book), find_items(kind, cells), strict=True
        )
    }


def find_target(link: re.Match, path: Path) -> tuple[Path, str]:
    """Return the file and the anchor that a link in a file at `path` leads to."""
    return ((path.parent / link[2]).resolve() if link[2] else path), link[3] or ""


def renumber(folder: Path = BOOK) -> list[Path]:
    """Update every number and its mentions, and return the changed files."""
    book = read_book(folder)
    numbers = count_items(book)
    changed = []
    for path, cells in book.items():
        texts = {cell.index: renumber_text(cell.text, path, numbers) for cell in cells}
        if all(texts[cell.index] == cell.text for cell in cells):
            continue
        changed.append(path)
        if path.suffix == ".md":
            path.write_text(texts[None], encoding="utf-8")
            continue
        notebook = nbformat.read(path, as_version=4)
        for index, text in texts.items():
            notebook.cells[index].source = text
        nbformat.write(notebook, path)
    return changed


def renumber_text(text: str, path: Path, numbers: dict[tuple[Path, str], str]) -> str:
    """Return a text with the right numbers in its items and in the links to items."""

    def rewrite_item(item: re.Match) -> str:
        start, end = item.start(3) - item.start(), item.end(3) - item.start()
        return item[0][:start] + numbers[path, item[1]] + item[0][end:]

    def rewrite_mention(link: re.Match) -> str:
        number = numbers.get(find_target(link, path))
        label = link[1]
        for kind in KINDS if number else ():
            label = kind.mention.sub(lambda mention: mention[1] + number, label)
        return f"[{label}]" + link[0][len(link[1]) + 2 :]

    for kind in KINDS:
        text = kind.item.sub(rewrite_item, text)
    return LINK.sub(rewrite_mention, text)


def find_mistakes(folder: Path = BOOK) -> list[str]:
    """Return a message for each mistake in the forms, numbers and links of the sources."""
    book = read_book(folder)
    numbers = count_items(book)
    anchors = {path: set(find_anchors(cells)) for path, cells in book.items()}
    mistakes: list[str] = []
    for path, cells in book.items():
        for kind in KINDS:
            mistakes += check_forms(kind, cells)
            mistakes += check_order(kind, cells, number_items(kind, path, book))
        mistakes += check_anchors(cells)
        mistakes += check_solutions(cells)
        for cell in cells:
            mistakes += check_links(cell, anchors, book, numbers)
            mistakes += check_plain(cell)
    return mistakes


def find_anchors(cells: list[Cell]) -> Iterator[str]:
    for cell in cells:
        yield from ANCHOR.findall(replace_with_spaces(CODE, cell.text))


def check_forms(kind: Kind, cells: list[Cell]) -> Iterator[str]:
    """Report text that looks like an item of a kind and is malformed."""
    for cell in cells:
        text = replace_with_spaces(CODE, cell.text)
        rest = kind.attempt.search(kind.item.sub(lambda item: " " * len(item[0]), text))
        if rest:
            line = text[rest.start() :].partition("\n")[0][:60]
            problem = f"malformed {kind.name} at {line!r}; expected {kind.form}"
            yield f"{cell.describe_position(rest.start())}: {problem}"
        elif kind.name == "figure" and kind.item.search(text) and not cell.is_below_picture:
            yield f"{cell.describe_position()}: a caption without a code cell right above it"


def check_order(kind: Kind, cells: list[Cell], right_numbers: list[str]) -> Iterator[str]:
    """Report numbers that occur twice or are out of order."""
    seen: dict[str, str] = {}
    for right, (cell, match) in zip(right_numbers, find_items(kind, cells), strict=True):
        number = match[3]
        place = cell.describe_position(match.start())
        if number in seen:
            problem = f"{kind.name} {number} occurs twice, first in {seen[number]}"
            yield f"{place}: {problem}; run make refresh"
        elif number != right:
            yield f"{place}: {kind.name} {number} should be {right}; run make refresh"
        seen.setdefault(number, place)


def check_anchors(cells: list[Cell]) -> Iterator[str]:
    """Report anchors that occur twice on a page."""
    seen: dict[str, str] = {}
    for cell in cells:
        for anchor in ANCHOR.finditer(replace_with_spaces(CODE, cell.text)):
            place = cell.describe_position(anchor.start())
            if anchor[1] in seen:
                yield f"{place}: anchor {anchor[1]} occurs twice, first in {seen[anchor[1]]}"
            seen.setdefault(anchor[1], place)


def check_solutions(cells: list[Cell]) -> Iterator[str]:
    """Report solutions without an exercise, that do not fold, or that end with the notebook."""
    heading, last = "", None
    for cell in cells:
        text = replace_with_spaces(CODE, cell.text)
        for match in HEADING.finditer(text):
            if match[2].strip() == "Solution":
                position = cell.describe_position(match.start())
                if not heading.startswith("Exercise "):
                    yield f"{position}: a solution without an exercise above it"
                if not SOLUTION.fullmatch(cell.text) or not cell.is_folded:
                    yield (
                        f"{position}: malformed solution; expected a cell with"
                        ' "#### Solution" alone and "jp-MarkdownHeadingCollapsed": true'
                    )
                last = cell
            heading = match[2]
    if last is not None and heading == "Solution":
        position = last.describe_position()
        yield f"{position}: no heading follows the last solution, which folds all below it"


def check_links(
    cell: Cell,
    anchors: dict[Path, set[str]],
    book: dict[Path, list[Cell]],
    numbers: dict[tuple[Path, str], str],
) -> Iterator[str]:
    """Report links that lead nowhere, and mentions with a wrong number or without a link."""
    text = replace_with_spaces(MATH, replace_with_spaces(CODE, cell.text))
    path = cell.path.resolve()
    for link in LINK.finditer(text):
        place = cell.describe_position(link.start())
        file, anchor = find_target(link, path)
        if file.parent.name == "answers":  # the build writes these pages and checks links to them
            continue
        if file not in book:
            if not file.exists():
                yield f"{place}: dead link to {link[2]}: there is no such file"
        elif anchor and anchor not in anchors[file] and not has_ids_from_sphinx(book[file]):
            yield f"{place}: dead link: no anchor {anchor} in {file.name}"
        number = numbers.get((file, anchor))
        for kind in KINDS if number else ():
            mention = kind.mention.search(link[1])
            if mention and mention[2] != number:
                problem = f"{link[1]} leads to {kind.name} {number}"
                yield f"{place}: {problem}; run make refresh"
    prose = replace_with_spaces(LINK, replace_with_spaces(CODE, cell.text))
    for kind in KINDS:
        prose = replace_with_spaces(kind.item, prose)
    prose = replace_with_spaces(MATH, prose)
    for mention in BARE_MENTION.finditer(prose):
        place = cell.describe_position(mention.start())
        yield f"{place}: {mention[0]} is no link; expected [{mention[0]}](#its-anchor)"


def has_ids_from_sphinx(cells: list[Cell]) -> bool:
    """Return whether Sphinx adds anchors to a page that its source does not contain."""
    return bool(IDS_FROM_SPHINX.search(cells[0].text))


def check_plain(cell: Cell) -> Iterator[str]:
    """Report directives, roles and labels in notebooks, which only Sphinx understands."""
    if cell.index is not None and (myst := MYST.search(cell.text)):
        position = cell.describe_position()
        yield f"{position}: MyST markup {myst[0].strip()!r}; expected plain Markdown"


def report_mistakes(app: Sphinx, *_: object) -> None:
    """Warn of each mistake at the start of a build, which `-W` turns into an error."""
    for mistake in find_mistakes(Path(app.srcdir)):
        LOGGER.warning("book/%s", mistake)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("env-before-read-docs", report_mistakes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


if __name__ == "__main__":
    if "--write" in sys.argv:
        for changed_path in renumber():
            print(f"renumber_text {changed_path.name}")
    mistakes = find_mistakes()
    print("\n".join(mistakes), end="\n" if mistakes else "")
    sys.exit(bool(mistakes))
