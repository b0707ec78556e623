"""The tools beside the book: the PDF's order, bookmarks and link, and notebooks refreshed the same
on every machine."""

import re
import tomllib
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest
import yaml
from playwright.sync_api import Error

from tools import address, limits, pdf, screenshots
from tools.refresh import refresh

ROOT = Path(__file__).parents[1]


def test_the_pages_come_in_the_order_of_the_contents():
    names = pdf.names()
    contents = (pdf.ROOT / "book/_toc.yml").read_text(encoding="utf-8")
    assert names[0] == "intro"
    listed = re.findall(r"file: (\S+)", contents)
    assert names[1:] == [name for name in listed if name not in pdf.ALONE]
    assert len(names) == len(set(names))


def test_the_first_page_shows_its_link_once_there_is_a_pdf(tmp_path):
    page = tmp_path / "intro.html"
    page.write_text(f"<article></article>{pdf.PLACE}", encoding="utf-8")
    pdf.link(page)
    pdf.link(page)
    assert page.read_text(encoding="utf-8") == f"<article></article>{pdf.LINK}"
    page.write_text("<article></article>", encoding="utf-8")
    with pytest.raises(RuntimeError, match="no place"):
        pdf.link(page)


def test_references_are_printed_again_until_their_pages_hold(monkeypatch):
    """The second print moves a place that is named: it is named no more, and the third holds."""
    found = iter([{"a": 3, "b": 1}, {"a": 3, "b": 2}, {"a": 3, "b": 1}])
    monkeypatch.setattr(pdf, "places", lambda data: next(found))
    said = []

    def evaluate(_, pages):
        said.append(pages)
        return list(pages)

    page = SimpleNamespace(evaluate=evaluate, pdf=lambda **_: b"%PDF")
    assert pdf.printed(page) == b"%PDF"
    assert said == [{}, {"a": 3, "b": 1}, {"a": 3}]


def test_without_a_browser_nothing_is_printed_and_a_sentence_says_why(monkeypatch):
    def launch(**_):
        raise Error("Chromium distribution 'chrome' is not found")

    nothing = SimpleNamespace(chromium=SimpleNamespace(launch=launch))
    monkeypatch.setattr(pdf, "sync_playwright", lambda: nullcontext(nothing))
    monkeypatch.setenv("PATH", "")
    with pytest.raises(SystemExit) as ended:
        pdf.main()
    assert re.fullmatch("no browser is on the PATH; expected one of chromium.*", ended.value.code)


@pytest.fixture
def notebook(tmp_path):
    cells = [
        nbformat.v4.new_markdown_cell("# One"),
        nbformat.v4.new_code_cell("import os; print('a'); print(sorted(os.listdir()))"),
        nbformat.v4.new_code_cell(
            "6 * 7", metadata={"tags": ["hide-input"], "execution": {"x": "1"}}
        ),
    ]
    path = tmp_path / "one.ipynb"
    metadata = {"myst": {"a": 1}, "kernelspec": {"display_name": "Mine", "name": "mine"}}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=metadata), path)
    return path


def test_a_refreshed_notebook_holds_its_outputs_and_nothing_of_the_machine(notebook):
    ids = [cell.id for cell in nbformat.read(notebook, as_version=4).cells]
    refresh(notebook)
    first = notebook.read_bytes()
    read = nbformat.read(notebook, as_version=4)
    _, printed, valued = read.cells
    assert [out.text for out in printed.outputs] == ["a\n['one.ipynb']\n"], (
        "it runs in its own folder"
    )
    assert valued.outputs[0].data["text/plain"] == "42"
    assert valued.metadata == {"tags": ["hide-input"]}
    assert [cell.id for cell in read.cells] == ids
    assert [cell.execution_count for cell in read.cells[1:]] == [1, 2]
    assert set(read.metadata) == {"kernelspec", "language_info", "myst"}
    assert read.metadata.kernelspec.name == "python3"
    refresh(notebook)
    assert notebook.read_bytes() == first


def test_the_tests_weigh_less_than_what_they_test():
    def lines(*patterns):
        files = [path for pattern in patterns for path in ROOT.glob(pattern)]
        return sum(len(path.read_text(encoding="utf-8").splitlines()) for path in files)

    code = lines("helpers/**/*.py", "tools/*.py", "judge/**/*.js", "page/src/**/*.js")
    assert lines("tests/**/*.py", "tests/**/*.mjs") < 0.8 * code


def test_mutants_are_made_in_a_copy_that_holds_all_that_its_tests_read():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["tool"]["mutmut"]
    options = settings["pytest_add_cli_args_test_selection"]
    left_out = [ROOT / x.removeprefix("--ignore=") for x in options if x.startswith("--ignore=")]
    assert all(path.exists() for path in left_out)
    copied = {"tests", "pyproject.toml", *settings["source_paths"], *settings["also_copy"]}
    copied = {name.rstrip("/") for name in copied}
    name = re.compile(r'^\s*(?:from|import) (\w+)|(?:ROOT|parents\[1\]) / "([^"/]+)', re.M)
    for path in ROOT.glob("tests/**/*.py"):
        if not {path, *path.parents} & {*left_out}:
            named = {x for pair in name.findall(path.read_text("utf-8")) for x in pair if x}
            assert {x for x in named if (ROOT / x).exists()} <= copied, path


def test_what_is_too_long_is_named_with_its_place(tmp_path):
    def function(head, lines=1, words=""):
        return f"{head}:\n{words}" + "    x = 1\n" * lines

    within = [
        function("def public(a, b, c, d, e, *, f=1, g=2)", 40, '    """Words\n    and more."""\n'),
        function("class A:\n  def __init__(self, a, b, c, d, e, *, f)"),
    ]
    beyond = [
        function("def wide(a, b, c, d, e, f)"),
        function("def _private(a, b, c, d, e, *, f)"),
        function("async def long()", 41),
    ]
    path = tmp_path / "some.py"
    path.write_text("".join(within), "utf-8")
    assert list(limits.broken(path)) == []
    path.write_text("".join(beyond) + "\n" * 400, "utf-8")
    assert [line.removeprefix(str(path)) for line in limits.broken(path)] == [
        ": 446 lines; at most 400",
        ":1: wide takes 6 arguments; at most 5",
        ":3: _private takes 6 arguments; at most 5",
        ":5: long has 41 lines; at most 40",
    ]


@pytest.fixture
def root(tmp_path):
    """A copy of the files in which the repository's address stands."""
    for name in ("book/_config.yml", "CITATION.cff", "pyproject.toml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text((pdf.ROOT / name).read_text("utf-8"), "utf-8")
    address.write("", tmp_path)
    return tmp_path


def test_one_setting_says_everywhere_where_the_repository_is(root):
    names = ("book/_config.yml", "CITATION.cff", "pyproject.toml")
    before = [(root / name).read_text("utf-8") for name in names]
    for url in ("https://github.com/Other/old", "https://github.com/Owner/book"):
        address.write(url, root)
    assert address.setting(root) == "https://github.com/Owner/book"
    citation = yaml.safe_load((root / "CITATION.cff").read_text("utf-8"))
    assert citation["repository-code"] == "https://github.com/Owner/book"
    assert citation["url"] == "https://owner.github.io/book/"
    urls = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]["urls"]
    assert urls == {"Book": citation["url"], "Source": citation["repository-code"]}
    address.write("", root)
    assert [(root / name).read_text("utf-8") for name in names] == before


@pytest.mark.parametrize(
    "wrong",
    [
        "https://github.com/Owner/book.git",
        "https://github.com/Owner/..",
        "https://github.com/Owner/book/tree/main",
        "https://github.com/Öwner/book",
        "http://github.com/Owner/book",
    ],
)
def test_what_is_no_address_is_written_nowhere(root, wrong):
    before = {path: path.read_bytes() for path in root.rglob("*") if path.is_file()}
    with pytest.raises(ValueError, match="expected https://github"):
        address.write(wrong, root)
    assert {path: path.read_bytes() for path in root.rglob("*") if path.is_file()} == before


def test_an_owners_own_site_has_no_folder():
    assert address.pages("https://github.com/Owner/owner.github.io") == "https://owner.github.io/"


def test_the_files_that_name_the_repository_agree():
    url = address.setting()
    citation = yaml.safe_load((pdf.ROOT / "CITATION.cff").read_text("utf-8"))
    project = tomllib.loads((pdf.ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert citation.get("repository-code", "") == project.get("urls", {}).get("Source", "") == url
    assert citation["version"] == project["version"]


def test_the_readmes_pictures_are_of_this_theme():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    shown = re.findall(r"\]\(docs/(\w+\.png)\)", readme)
    assert shown == sorted(path.name for path in screenshots.DOCS.glob("*.png"))[::-1]
    assert screenshots.DIGEST.read_text("utf-8").strip() == screenshots.theme(), "make screenshots"
