"""Test which nodes each form of plain Markdown becomes on the built pages."""

import re

import nbformat
import pytest
from docutils import nodes
from sphinx.application import Sphinx

CELLS = (
    '# Page\n\n<a id="sec-a"></a>\n\n## Alpha\n\nSee [(1)](#eq-a), [that](other.md#term-Tip).',
    '<a id="eq-a"></a>\n\n$$\nx\n\\tag{1}\n$$',
    '<a id="slip-1"></a>\n\n> **Slip 1: two rows**\n>\n> > said\n>\n> Wrong.',
    "> A quotation, **not** a box.",
    "draw()",
    '<a id="fig-old"></a>\n\n<a id="fig-a"></a>\n\n**Fig. 1.** An $x$.',
    '<a id="ex-a"></a>\n\n### Exercise 1: Pull $x$ · ten minutes\n\nPull.\n\n'
    '<div class="judge" data-ask="pose" data-arm="PANDA" data-configuration="0">\n\n'
    "No script.\n\n</div>",
    '<a id="old-solution"></a>\n\n#### Solution',
    "So.",
    "## End\n\n**Bold** text.",
)
OTHER = '# Other\n\n- <a id="term-Tip"></a>**Tip**: The end.\n- <a id="term-b"></a>**b**: More.\n'


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Return the trees of a notebook and a page, and the notebook's HTML."""
    folder = tmp_path_factory.mktemp("plain")
    notebook = nbformat.v4.new_notebook(
        metadata={"language_info": {"name": "python", "pygments_lexer": "ipython3"}}
    )
    for text in CELLS:
        code = text == "draw()"
        make = nbformat.v4.new_code_cell if code else nbformat.v4.new_markdown_cell
        notebook.cells.append(make(text))
        if code:
            picture = {"image/svg+xml": '<svg xmlns="http://www.w3.org/2000/svg"/>'}
            notebook.cells[-1].outputs = [nbformat.v4.new_output("display_data", picture)]
    nbformat.write(notebook, folder / "index.ipynb")
    (folder / "other.md").write_text("---\norphan: true\n---\n\n" + OTHER, encoding="utf-8")
    settings = {
        "extensions": ["myst_nb", "tools.plain_markdown"],
        "nb_execution_mode": "off",
        "myst_enable_extensions": ["dollarmath"],
    }
    out = folder / "out"
    app = Sphinx(
        folder, None, out, out / "trees", "html", settings, status=None, warningiserror=True
    )
    app.build()
    return {
        "page": app.env.get_doctree("index"),
        "other": app.env.get_doctree("other"),
        "html": (out / "index.html").read_text(encoding="utf-8"),
    }


def find_class(tree, name):
    (node,) = tree.findall(lambda node: name in getattr(node, "attributes", {}).get("classes", ()))
    return node


def test_anchor_names_the_block_below_it(built):
    section = next(s for s in built["page"].findall(nodes.section) if s[0].astext() == "Alpha")
    assert "sec-a" in section["ids"]


def test_formula_gets_its_number_and_both_ids(built):
    (formula,) = built["page"].findall(nodes.math_block)
    assert (formula.astext().strip(), formula["number"]) == ("x", "1")
    assert formula["ids"] == ["eq-a", "equation-eq-a"]


def test_links_lead_to_anchors_here_and_elsewhere(built):
    targets = re.findall(r'href="([^"]*#(?:eq|term)[^"]*)"', built["html"])
    assert targets[:2] == ["#eq-a", "other.html#term-Tip"]


def test_quotation_with_bold_title_becomes_a_box(built):
    box = find_class(built["page"], "slip")
    assert box["ids"] == ["slip-1"]
    assert [part.astext() for part in box] == ["Slip 1: two rows", "said", "Wrong."]


def test_ordinary_quotations_stay_unchanged(built):
    quotes = [quote.astext() for quote in built["page"].findall(nodes.block_quote)]
    assert quotes == ["said", "A quotation, not a box."]


def test_caption_joins_its_picture(built):
    (figure,) = built["page"].findall(nodes.figure)
    assert {"fig-a", "fig-old"} == {*figure["ids"]}
    assert figure[-1].astext() == "Fig. 1 An x."
    assert len(figure) == 2


def test_exercise_becomes_a_box_and_leaves_the_contents(built):
    box = find_class(built["page"], "exercise")
    assert box["ids"] == ["ex-a"]
    assert [part.astext() for part in box] == ["Exercise 1 Pull x · ten minutes", "Pull."]
    assert find_class(box, "time").astext() == " · ten minutes"
    assert "Exercise" not in str([s[0] for s in built["page"].findall(nodes.section)])


def test_solution_folds_beside_its_exercise(built):
    solution = find_class(built["page"], "solution")
    assert solution["ids"] == ["solution-ex-a", "old-solution"]
    assert [part.astext() for part in solution] == ["Solution to Exercise 1: Pull x", "So."]
    assert "dropdown" in solution["classes"]


def test_judge_replaces_its_div_and_keeps_the_text(built):
    text = find_class(built["page"], "unscripted")
    assert text.astext() == "No script."
    end = text.parent[text.parent.index(text) + 1]
    assert '"given":{"ask":"pose","q":"0"}' in end.astext()


def test_terms_become_a_definition_list(built):
    (terms,) = built["other"].findall(nodes.definition_list)
    assert [term.astext() for term in terms.findall(nodes.term)] == ["Tip", "b"]
    assert terms[0][0]["ids"] == ["term-Tip"]
    assert terms[1][1].astext() == "More."
