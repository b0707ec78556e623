"""Test what nbval does not check in the notebooks.

nbval compares text, LaTeX, HTML, Markdown and SVG outputs byte for byte. It passes a notebook that
was never run, and does not compare PNG pictures or cells with certain tags.
"""

import re
import xml.etree.ElementTree as ET
from itertools import pairwise
from statistics import median

import nbformat
import pytest

from tools.numbering import list_notebooks, page_name
from tools.refresh import hide_drawing_code, write_derived_cells
from tools.setup_note import IMPORT_COMMENT, format_setup_note

NOTEBOOKS = list_notebooks()
PICTURES = {"image/svg+xml", "image/png", "image/jpeg"}
CHAPTERS = [path for path in NOTEBOOKS if path.stem[:2].isdigit()]
ALLOWED_TAGS = {
    *("hide-input", "hide-output", "hide-cell", "remove-input", "remove-cell", "show-code")
}
CAPTION = r'(?s)(?:<a id="[\w-]+"></a>\s+)+\*\*Fig\. [\d.]+\.\*\* .{30,}'
SLIDERS = "from ipywidgets import interactive\n"  # the second line of a cell with sliders

every_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=page_name)


def read(path):
    return nbformat.read(path, as_version=4)


def code_cells(path):
    return [cell for cell in read(path).cells if cell.cell_type == "code"]


def outputs(path):
    return [(cell, output) for cell in code_cells(path) for output in cell.outputs]


def on_the_page(path):
    return [(c, output) for c, output in outputs(path) if "remove-cell" not in tags(c)]


def tags(cell):
    return cell.metadata.get("tags", [])


def is_live(cell):
    """Return whether a cell shows a live figure, with its still picture for other readers."""
    return any(
        "arm-explorer" in o.get("data", {}).get("text/html", "") for o in cell.get("outputs", [])
    )


@every_notebook
def test_live_figure_stores_a_still_picture_before_it(path):
    for cell in filter(is_live, code_cells(path)):
        still, live = (output.data for output in cell.outputs[-2:])
        assert ET.fromstring(still["image/svg+xml"]).tag.endswith("svg")
        assert set(live) == {"text/html", "text/plain"}
        assert "Run the cell to move it." in live["text/html"]


def test_book_has_five_chapters():
    assert [path.stem[:2] for path in CHAPTERS] == ["01", "02", "03", "04", "05"]


def test_pages_have_no_control_characters():
    """A Python string that is not raw turns the start of \\theta into a tab."""
    pages = [path.read_text(encoding="utf-8") for path in NOTEBOOKS[0].parent.glob("*.md")]
    pages += [cell.source for path in NOTEBOOKS for cell in read(path).cells]
    assert not re.findall(r"[\x00-\x09\x0b-\x1f].{0,9}", "\n".join(pages))


@every_notebook
def test_notebook_was_run_in_order(path):
    counts = [cell.execution_count for cell in code_cells(path)]
    anew = f"say: make refresh NOTEBOOKS=book/{page_name(path)}.ipynb"
    assert counts == list(range(1, len(counts) + 1)), anew


@every_notebook
def test_notebook_starts_with_its_only_title(path):
    cells = read(path).cells
    titles = [
        i
        for i, cell in enumerate(cells)
        if cell.cell_type == "markdown" and re.search(r"^# ", cell.source, re.M)
    ]
    assert titles == [0]
    assert cells[0].source.startswith("# ")


@every_notebook
def test_code_cells_are_short(path):
    for cell in code_cells(path):
        lines = cell.source.splitlines()
        most = 45 if "use_book_style()" in lines else 20 if "remove-cell" in tags(cell) else 15
        assert len(lines) <= most + (IMPORT_COMMENT in cell.source), cell.source
        assert max(map(len, lines), default=0) <= 100, cell.source
    if path in CHAPTERS:
        sizes = [len(cell.source.splitlines()) for cell in code_cells(path)]
        assert sizes[0] <= 14, "the imports"
        assert median(sizes) <= 5


@every_notebook
def test_cells_have_only_allowed_tags(path):
    for cell in code_cells(path):
        assert set(tags(cell)) <= ALLOWED_TAGS
        assert ("remove-cell" in tags(cell)) == (SLIDERS in cell.source), cell.source


@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_chapter_imports_arms_only_in_first_cell(path):
    """A later import would undo a reader's change of the arm in the first cell."""
    for cell in code_cells(path)[1:]:
        takes_arm = r"import.*robots|robots import|robots\.[A-Z]|\bnamed\("
        assert not re.search(takes_arm, cell.source), cell.source


@every_notebook
def test_solution_assigns_no_name_that_the_exercise_gives_the_reader(path):
    """Otherwise Run All would check the solution's value in place of the reader's answer."""
    folded = False
    for cell in read(path).cells:
        heading = re.search(r"(?m)^#+ ", cell.source) if cell.cell_type == "markdown" else None
        folded = "#### Solution" in cell.source if heading else folded
        if folded and cell.cell_type == "code":
            assert not re.search(r"(?m)^mine = ", cell.source), cell.source


@every_notebook
def test_cells_do_not_measure_time(path):
    """Times depend on the machine's load, so printed times would differ in each run."""
    clock = r"(import|from) +(time|timeit|datetime)\b|^ *%%?time"
    assert not [cell.source for cell in code_cells(path) if re.search(clock, cell.source, re.M)]


@every_notebook
def test_cells_have_no_errors(path):
    assert not [output for _, output in outputs(path) if output.output_type == "error"]
    assert not [output for _, output in outputs(path) if output.get("name") == "stderr"]


@every_notebook
def test_pictures_are_svg_with_alt_and_caption(path):
    for cell, below in pairwise(read(path).cells):
        outputs = [] if "remove-cell" in tags(cell) or is_live(cell) else cell.get("outputs", [])
        formats = {kind for output in outputs for kind in output.get("data", {})} & PICTURES
        if not formats:
            continue
        assert formats == {"image/svg+xml"}, "nbval compares SVG, not PNG"
        (svg,) = [o.data["image/svg+xml"] for o in outputs if "image/svg+xml" in o.get("data", {})]
        assert ET.fromstring(svg).tag.endswith("svg")
        assert len(cell.metadata.mystnb.image.alt) > 30
        assert re.fullmatch(CAPTION, below.source), f"a caption belongs below {cell.source!r}"


@every_notebook
def test_drawing_cell_has_no_other_output(path):
    """If the cell ended in the value of a drawing call, its text would appear above the figure."""
    for cell, drawn in on_the_page(path):
        if PICTURES & set(drawn.get("data", {})) and not is_live(cell):
            (output,) = cell.outputs
            assert re.match("<Figure|<IPython.core.display.SVG", output.data["text/plain"]), (
                cell.source
            )


@every_notebook
def test_cell_with_caption_has_picture(path):
    for cell in code_cells(path):
        if "mystnb" in cell.metadata:
            has_picture = any(PICTURES & set(output.get("data", {})) for output in cell.outputs)
            assert has_picture, f"cell {cell.id} has alt text and no picture"


@every_notebook
def test_every_check_printed_its_result(path):
    lines = [line for _, output in outputs(path) for line in output.get("text", "").splitlines()]
    proofs = [line for line in lines if line.startswith("✔")]
    assert not [line for line in lines if line.startswith("○")], "a number that is not the book's"
    calls = sum(len(re.findall(r"\bcheck\(", cell.source)) for cell in code_cells(path))
    assert calls
    assert len(proofs) >= calls


@every_notebook
def test_notebook_holds_no_machine_details(path):
    text = path.read_text(encoding="utf-8")
    assert not re.search(r"/home/|/root/|/work/|/Users/|C:\\\\|/\.venv|site-packages", text)
    assert not re.search(r" at 0x[0-9a-f]{6,}", text)
    notebook = read(path)
    assert set(notebook.metadata) <= {"kernelspec", "language_info", "myst"}
    assert notebook.metadata.kernelspec.name == "python3"
    assert notebook.metadata.myst.html_meta.description
    metadata = [output.metadata for _, output in outputs(path) if output.get("metadata")]
    assert not metadata, "remove the metadata of these outputs"


@every_notebook
def test_notebook_is_below_750_kb(path):
    assert path.stat().st_size < 750_000


@every_notebook
def test_notebook_is_as_refresh_leaves_it(path):
    """Its note on `helpers`, the folded code of drawings, citations with their list."""
    notebook = read(path)
    write_derived_cells(notebook, path)
    assert notebook == read(path), f"run: make refresh NOTEBOOKS=book/{page_name(path)}.ipynb"


@pytest.mark.parametrize(
    ("addresses", "link", "source"),
    [
        (("", ""), "the *Robot homework companion*.", '"./companion[explorer]"'),
        (("https://a.b/", "https://g.h/o"), "](https://a.b/02_x.html)", "@ git+https://g.h/o"),
    ],
)
def test_setup_note_says_where_book_and_helpers_are(addresses, link, source):
    note = format_setup_note("02_x", *addresses)
    assert link in note
    assert source in note


def test_hide_drawing_code_leaves_cells_that_print_a_result():
    cells = []
    for source in ("draw(ax)", "check('length', 1, 1)"):
        cells.append(nbformat.v4.new_code_cell(source))
        cells.append(nbformat.v4.new_markdown_cell("**Fig. 1.** One."))
    hide_drawing_code(nbformat.v4.new_notebook(cells=cells))
    assert [cell.metadata.get("tags", []) for cell in cells[::2]] == [["hide-input"], []]


@pytest.mark.parametrize("chapter", CHAPTERS, ids=lambda path: path.stem)
def test_intro_states_reading_time(chapter):
    """At 200 words a minute and two minutes for each cell that prints a result, up to the
    exercises."""
    cells = read(chapter).cells
    last = next(i for i, cell in enumerate(cells) if re.search(r"^## Exercises", cell.source, re.M))
    text = "\n".join(cell.source for cell in cells[: last + 1] if cell.cell_type == "markdown")
    text = re.sub(
        r"<[^>]*>|\]\([^)]*\)|\$\$.*?\$\$|\$[^$]*\$", " ", text.partition("## Exercises")[0]
    )
    code = [cell for cell in cells[:last] if cell.cell_type == "code"]
    prints = [c for c in code if c.outputs and not {"remove-cell", "remove-input"} & set(tags(c))]
    results = sum(not PICTURES & set(c.outputs[0].get("data", {})) for c in prints)
    told = (chapter.parent / "intro.md").read_text(encoding="utf-8")
    ((whole, part),) = re.findall(rf"\({chapter.name}\) \|.*\| (\d)([¼½¾]?)&nbsp;h", told)
    hours = int(whole) + {"": 0, "¼": 0.25, "½": 0.5, "¾": 0.75}[part]
    assert hours == pytest.approx((len(text.split()) / 200 + 2 * results) / 60, abs=0.3)
