"""The tools beside the book: the PDF's order, bookmarks and link, and notebooks refreshed the same
on every machine."""

import io
import re
import tomllib
from pathlib import Path

import nbformat
import pytest
import yaml
from pypdf import PdfReader, PdfWriter

from tools import address, pdf
from tools.refresh import refresh

ROOT = Path(__file__).parents[1]


def blank(pages):
    writer, data = PdfWriter(), io.BytesIO()
    for _ in range(pages):
        writer.add_blank_page(width=595, height=842)
    writer.write(data)
    return data.getvalue()


def test_the_pages_come_in_the_order_of_the_contents():
    names = pdf.names()
    assert names[:3] == [
        "intro",
        *re.findall(r"file: (\S+)", (pdf.ROOT / "book/_toc.yml").read_text(encoding="utf-8"))[:2],
    ]
    assert len(names) == len(set(names))
    for name in names:
        assert any((pdf.ROOT / "book" / f"{name}.{kind}").exists() for kind in ("md", "ipynb")), (
            name
        )


def test_the_parts_become_one_document_with_a_bookmark_each(tmp_path):
    path = tmp_path / "book.pdf"
    assert pdf.joined([("One", blank(2)), ("Two", blank(3))], path) == 5
    read = PdfReader(path)
    assert [(mark.title, read.get_destination_page_number(mark)) for mark in read.outline] == [
        ("One", 0),
        ("Two", 2),
    ]
    assert read.metadata.title == "Robot homework companion"


def test_the_link_stands_once_below_the_articles_title(tmp_path):
    page = tmp_path / "intro.html"
    page.write_text("<h1>Menu</h1><article><h1>Book</h1><h1>No</h1></article>", encoding="utf-8")
    pdf.link(page)
    pdf.link(page)
    html = page.read_text(encoding="utf-8")
    assert html == f"<h1>Menu</h1><article><h1>Book</h1>\n{pdf.LINK}<h1>No</h1></article>"


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

    code = lines("helpers/**/*.py", "tools/*.py", "explorer/src/**/*.js")
    assert lines("tests/**/*.py", "tests/**/*.mjs") < 0.8 * code


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


def test_the_files_that_name_the_repository_agree():
    url = address.setting()
    citation = yaml.safe_load((pdf.ROOT / "CITATION.cff").read_text("utf-8"))
    project = tomllib.loads((pdf.ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert citation.get("repository-code", "") == project.get("urls", {}).get("Source", "") == url
    assert citation["version"] == project["version"]
