"""Test the tools beside the book: the PDF and the refreshing of notebooks."""

import re
import tomllib
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace

import nbformat
import pytest
import yaml
from playwright.sync_api import Error

import helpers
from tools import pdf
from tools.refresh import refresh_notebook

ROOT = Path(__file__).parents[1]


def test_pdf_pages_follow_the_contents():
    names = pdf.list_pages()
    toc = (pdf.ROOT / "book/_toc.yml").read_text(encoding="utf-8")
    assert names[0] == "intro"
    listed = re.findall(r"file: (\S+)", toc)
    assert names[1:] == [name for name in listed if name not in pdf.LEFT_OUT]
    assert len(names) == len(set(names))


def test_pdf_link_is_inserted_once(tmp_path):
    page = tmp_path / "intro.html"
    page.write_text(f"<article></article>{pdf.LINK_PLACEHOLDER}", encoding="utf-8")
    pdf.link_pdf(page)
    pdf.link_pdf(page)
    assert page.read_text(encoding="utf-8") == f"<article></article>{pdf.LINK}"
    page.write_text("<article></article>", encoding="utf-8")
    with pytest.raises(RuntimeError, match="no place"):
        pdf.link_pdf(page)


def test_pdf_references_use_pages_of_first_print(monkeypatch):
    """The second print must leave each link's target on the same page."""
    targets = iter([{"a": 3, "b": 1}, {"a": 3, "b": 1}, {"a": 3, "b": 1}, {"a": 4, "b": 1}])
    monkeypatch.setattr(pdf, "target_pages", lambda _: next(targets))
    page_numbers = []
    tab = SimpleNamespace(
        evaluate=lambda _, pages: page_numbers.append(pages), pdf=lambda **_: b"%PDF"
    )
    assert pdf.print_with_page_numbers(tab) == b"%PDF"
    assert page_numbers == [{}, {"a": 3, "b": 1}]
    with pytest.raises(RuntimeError, match=r"moves \['a'\]"):
        pdf.print_with_page_numbers(tab)


def test_pdf_without_browser_exits_with_message(monkeypatch):
    def launch(**_):
        raise Error("Chromium distribution 'chrome' is not found")

    playwright = SimpleNamespace(chromium=SimpleNamespace(launch=launch))
    monkeypatch.setattr(pdf, "sync_playwright", lambda: nullcontext(playwright))
    monkeypatch.setenv("PATH", "")
    with pytest.raises(SystemExit) as error:
        pdf.main()
    assert re.fullmatch("no browser is on the PATH; expected one of chromium.*", error.value.code)


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


def test_refresh_stores_outputs_without_machine_details(notebook):
    title_id, *ids = [cell.id for cell in nbformat.read(notebook, as_version=4).cells]
    refresh_notebook(notebook)
    first_bytes = notebook.read_bytes()
    refreshed = nbformat.read(notebook, as_version=4)
    title, setup_note, printing_cell, value_cell = refreshed.cells
    assert setup_note.metadata.tags == ["remove-cell"]
    assert [out.text for out in printing_cell.outputs] == ["a\n['one.ipynb']\n"], (
        "the notebook did not run in its own folder"
    )
    assert value_cell.outputs[0].data["text/plain"] == "42"
    assert value_cell.metadata == {"tags": ["hide-input"]}
    assert [title.id, printing_cell.id, value_cell.id] == [title_id, *ids]
    assert [printing_cell.execution_count, value_cell.execution_count] == [1, 2]
    assert set(refreshed.metadata) == {"kernelspec", "language_info", "myst"}
    assert refreshed.metadata.kernelspec.name == "python3"
    refresh_notebook(notebook)
    assert notebook.read_bytes() == first_bytes


def test_repository_url_agrees_in_all_files():
    url = yaml.safe_load((ROOT / "book/_config.yml").read_text("utf-8"))["repository"]["url"]
    citation = yaml.safe_load((pdf.ROOT / "CITATION.cff").read_text("utf-8"))
    project = tomllib.loads((pdf.ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    assert citation.get("repository-code", "") == project.get("urls", {}).get("Source", "") == url


def test_version_agrees_in_all_files():
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text("utf-8"))
    changelog = (ROOT / "CHANGELOG.md").read_text("utf-8")
    assert citation["version"] == helpers.__version__
    assert f"## {helpers.__version__} - {citation['date-released']}" in changelog
    config = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    assert config["project"]["dynamic"] == ["version"]
    assert config["tool"]["setuptools"]["dynamic"]["version"] == {"attr": "helpers.__version__"}
