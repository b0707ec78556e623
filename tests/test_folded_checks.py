"""Test which cells are folded, and which line a folded cell shows."""

from docutils import nodes

from tools.checks import fold, mark_output, read_labels, stays_open


def make_cell(*outputs, classes=()):
    block = [nodes.literal_block("", text, classes=["output", "stream"]) for text in outputs]
    code = nodes.container("", nodes.literal_block("", "check(...)"), classes=["cell_input"])
    output = nodes.container("", *block, classes=["cell_output"])
    return nodes.container("", code, output, classes=["cell", *classes])


def test_folded_line_names_the_compared_values():
    cell = make_cell("✔ the tip (m) (within 1e-12)\n✔ all eight\n✔ all eight\n")
    assert read_labels(cell) == ["the tip (m)", "all eight"]


def test_cell_with_another_output_stays_open():
    assert read_labels(make_cell("4 branches\n✔ the tip\n")) == []
    assert read_labels(make_cell("")) == []


def test_tag_and_solutions_keep_code_open():
    assert stays_open(make_cell("✔ a", classes=["tag_show-code"]))
    cell = make_cell("✔ a")
    nodes.admonition("", cell, classes=["solution"])
    assert stays_open(cell)
    assert not stays_open(make_cell("✔ a"))


def test_folded_cell_lists_three_checks_and_how_many_more():
    cell = make_cell("✔ a\n")
    fold(cell, ["a < b", "b", "c", "d"])
    assert "<summary>✔ a &lt; b; b; c; and 1 more</summary>" in cell[0].astext()


def list_marked(cell):
    """Return the classes of a cell's output, and the text below each class within it."""
    output = cell[1]
    mark_output(output)
    marked = [(part["classes"], part.astext()) for part in output.findall(nodes.inline)]
    return output["classes"][1:], [(classes[0], text) for classes, text in marked if classes]


def test_checks_that_hold_have_lines_of_their_own():
    cell = make_cell("✔ torque: 3 N m (within 1e-12)\n✔ tip\n")
    line = "✔ torque: 3 N\N{NO-BREAK SPACE}m (within 1e-12)\n"
    assert list_marked(cell) == (
        ["proof"],
        [("holds", line), ("number", "1e-12"), ("holds", "✔ tip\n")],
    )


def test_only_checks_are_marked_in_other_outputs():
    assert list_marked(make_cell("a  b\n1  2\n")) == (["columns"], [])
    assert list_marked(make_cell("4 N m\n", "✔ tip\n")) == ([], [("holds", "✔ tip\n")])
    assert list_marked(make_cell()) == ([], [])
