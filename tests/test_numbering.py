"""Test the numbers of figures, formulas and exercises, and the references to them."""

import nbformat
import pytest

from tools.numbering import BOOK, find_mistakes, renumber

FIGURE = '<a id="fig-{}"></a>\n\n**Fig. {}.** An arm.'
FORMULA = '<a id="eq-{}"></a>\n\n$$\nx\n\\tag{{{}}}\n$$'
EXERCISE = '<a id="ex-{}"></a>\n\n### Exercise {}: Pull · ten minutes\n\nPull.'
FOLD = {"jp-MarkdownHeadingCollapsed": True}


def write_notebook(folder, name, *texts):
    """Write a notebook of Markdown cells; a code cell stands above each caption."""
    cells = []
    for text in texts:
        if "**Fig" in text:
            cells.append(nbformat.v4.new_code_cell("draw()"))
        cells.append(nbformat.v4.new_markdown_cell(text))
        if text.endswith("#### Solution"):
            cells[-1].metadata.update(FOLD)
    nbformat.write(nbformat.v4.new_notebook(cells=cells), folder / name)


def read_texts(folder, name):
    cells = nbformat.read(folder / name, as_version=4).cells
    return [cell.source for cell in cells if cell.cell_type == "markdown"]


def test_book_has_no_mistakes():
    assert find_mistakes(BOOK) == []


def test_renumber_counts_each_kind_by_chapter(tmp_path):
    texts = [form.format(name, "9.9") for name in "ab" for form in (FIGURE, FORMULA, EXERCISE)]
    write_notebook(tmp_path, "02_two.ipynb", *texts)
    renumber(tmp_path)
    expected = [
        form.format(name, number)
        for name, number in (("a", "2.1"), ("b", "2.2"))
        for form in (FIGURE, FORMULA, EXERCISE)
    ]
    assert read_texts(tmp_path, "02_two.ipynb") == expected


def test_renumber_counts_other_pages_from_1(tmp_path):
    (tmp_path / "more.md").write_text(FORMULA.format("a", "7") + "\n", encoding="utf-8")
    assert [path.name for path in renumber(tmp_path)] == ["more.md"]
    assert (tmp_path / "more.md").read_text("utf-8") == FORMULA.format("a", "1") + "\n"


def test_renumber_rewrites_mentions_in_all_files(tmp_path):
    write_notebook(tmp_path, "02_two.ipynb", FIGURE.format("b", "2.2"), FORMULA.format("b", "2.2"))
    write_notebook(tmp_path, "03_three.ipynb", "By [(2.2)](02_two.ipynb#eq-b) and 2.2 m.")
    (tmp_path / "where.md").write_text("[Fig. 2.2](02_two.ipynb#fig-b) (right)", encoding="utf-8")
    renumber(tmp_path)
    assert read_texts(tmp_path, "03_three.ipynb") == ["By [(2.1)](02_two.ipynb#eq-b) and 2.2 m."]
    assert (tmp_path / "where.md").read_text("utf-8") == "[Fig. 2.1](02_two.ipynb#fig-b) (right)"


def test_renumber_leaves_right_files_untouched(tmp_path):
    write_notebook(tmp_path, "02_two.ipynb", FIGURE.format("a", "2.1"))
    assert renumber(tmp_path) == []


@pytest.mark.parametrize(
    ("texts", "message"),
    [
        (['<a id="fig-a"></a>\n\n*Fig. 2.1.* An arm.'], "cell 0: malformed figure"),
        (["**Fig. 2.1.** No anchor."], "cell 1: malformed figure"),
        (["$$\nx\n\\tag{2.1}\n$$"], "cell 0: malformed formula"),
        (['<a id="ex-a"></a>\n\n### Exercise 2.1: No time'], "cell 0: malformed exercise"),
        (["#### Solution", "## End"], "cell 0: a solution without an exercise"),
        (
            [EXERCISE.format("a", "2.1") + "\n\n#### Solution\n\nSo.", "## End"],
            "cell 0: malformed so",
        ),
        ([EXERCISE.format("a", "2.1"), "#### Solution"], "cell 1: no heading follows"),
        ([FIGURE.format(name, "2.1") for name in "ab"], "cell 3: figure 2.1 occurs twice"),
        ([FORMULA.format("a", "2.2")], "cell 0: formula 2.2 should be 2.1"),
        (["[here](#sec-a)"], "cell 0: dead link: no anchor sec-a"),
        (["[there](01_one.ipynb)"], "cell 0: dead link to 01_one.ipynb"),
        (
            ["[Fig. 2.2](#fig-a)", FIGURE.format("a", "2.1")],
            "cell 0: Fig. 2.2 leads to figure 2.1",
        ),
        (["See Fig. 2.1.", FIGURE.format("a", "2.1")], "cell 0: Fig. 2.1 is no link"),
        (['<a id="a"></a>', '<a id="a"></a>'], "cell 1: anchor a occurs twice"),
        (["As {ref}`sec-a` says."], "cell 0: MyST markup"),
        (["```{note}\nMind.\n```"], "cell 0: MyST markup"),
        (["(sec-a)=\n## A"], "cell 0: MyST markup"),
    ],
)
def test_mistake_is_reported_with_file_and_cell(tmp_path, texts, message):
    write_notebook(tmp_path, "02_two.ipynb", *texts)
    mistakes = find_mistakes(tmp_path)
    assert any(mistake.startswith(f"02_two.ipynb, {message}") for mistake in mistakes), mistakes


@pytest.mark.parametrize(
    "text", ["`[x](#none)` and `Fig. 2.1`", "$f(2.1) = [x](3)$", "```python\nA[0](#x)\n```"]
)
def test_code_and_formulas_hold_no_links(tmp_path, text):
    write_notebook(tmp_path, "02_two.ipynb", text)
    assert find_mistakes(tmp_path) == []


def test_mistake_on_a_page_is_reported_with_its_line(tmp_path):
    (tmp_path / "where.md").write_text("# Where\n\n[x](#none)\n", encoding="utf-8")
    assert find_mistakes(tmp_path) == ["where.md, line 3: dead link: no anchor none in where.md"]


def test_exercises_beside_a_chapter_continue_its_numbers(tmp_path):
    (tmp_path / "exercises").mkdir()
    write_notebook(tmp_path, "02_two.ipynb", EXERCISE.format("a", "2.1"))
    write_notebook(tmp_path / "exercises", "two.ipynb", EXERCISE.format("b", "9.9"))
    renumber(tmp_path)
    assert read_texts(tmp_path / "exercises", "two.ipynb") == [EXERCISE.format("b", "2.2")]
