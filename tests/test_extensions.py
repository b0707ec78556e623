"""Test the Sphinx extensions in tools: boxes, formulas, code and drawings."""

import re
import xml.etree.ElementTree as ET
from types import SimpleNamespace

import pytest
from docutils import nodes

from tools.pages import fold_box, join_to_neighbours, keep_words_unbroken, visit_math_block
from tools.pictures import svg_size, visit_image
from tools.search import write_formula

PANELS = ((12, 8, 93, 166), (207, 17, 186, 166))


def make_drawing(*panels, wide=400, high=200):
    """Return a drawing with these panels."""
    views = "".join(
        f'<view id="panel-{k}" viewBox="{" ".join(map(str, box))}"/>'
        for k, box in enumerate(panels, 1)
    )
    size = f'width="{wide}pt" height="{high}pt" viewBox="0 0 {wide} {high}"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {size}><defs/>{views}<g/></svg>'


@pytest.mark.parametrize(
    ("width", "expected"), [("300pt", (400, 200)), ("300", (300, 150)), ("100%", None)]
)
def test_svg_size_is_read_in_points_or_pixels(width, expected):
    height = width.replace("300", "150")
    assert svg_size(ET.fromstring(f'<svg width="{width}" height="{height}"/>')) == expected


def render_picture(tmp_path, svg, **attributes):
    """Return the HTML of a picture on a page."""
    (tmp_path / "a.svg").write_text(svg, encoding="utf-8")
    builder = SimpleNamespace(images={"a.svg": "b.svg"}, srcdir=tmp_path, imgpath="_images")
    translator = SimpleNamespace(builder=builder, body=[])
    with pytest.raises(nodes.SkipNode):
        visit_image(translator, nodes.image(uri="a.svg", alt='A "b"', **attributes))
    return "".join(translator.body)


def test_image_tag_has_size_and_label(tmp_path):
    html = render_picture(tmp_path, make_drawing(), width="70%")
    assert re.findall('src="(.*?)"', html) == ["_images/b.svg"]
    assert 'alt="" loading="lazy" src="_images/b.svg" width="533" height="267">' in html
    assert 'class="picture" style="width: 70%" role="img" aria-label="A &quot;b&quot;">' in html


def test_panels_are_views_of_one_file(tmp_path):
    html = render_picture(tmp_path, make_drawing(*PANELS))
    assert 'class="picture many"' in html
    views = re.findall(r'src="([^"]*)" class="panel" style="(.*?)"', html)
    assert views == [
        ("_images/b.svg#panel-1", "aspect-ratio: 93 / 166; max-width: 186px; --share: 50.0%"),
        ("_images/b.svg#panel-2", "aspect-ratio: 186 / 166; max-width: 372px; --share: 100.0%"),
    ]


@pytest.mark.parametrize(
    ("widths", "small"), [((90,) * 4, True), ((90,) * 3, False), ((90, 171) * 2, False)]
)
def test_four_small_panels_are_marked_small(tmp_path, widths, small):
    html = render_picture(tmp_path, make_drawing(*((0, 0, wide, 100) for wide in widths)))
    assert ('class="picture many small"' in html) == small


def test_dropdown_becomes_details_element():
    box = nodes.admonition("", nodes.title("", "Solution"), nodes.paragraph("", "Four."))
    box["classes"], box["ids"] = ["solution", "dropdown"], ["here"]
    around = nodes.section("", box)
    fold_box(box)
    start = '<details class="admonition solution" id="here"><summary class="admonition-title">'
    made = [part.astext() for part in around]
    assert made == [start, "Solution", "</summary>", "Four.", "</details>"]


@pytest.mark.parametrize("tex", [r"a \\ b", r"\begin{matrix}a \\ b\end{matrix}"])
def test_formula_gets_a_single_table(tex):
    translator = SimpleNamespace(body=[], starttag=lambda *_, **__: "")
    with pytest.raises(nodes.SkipNode):
        visit_math_block(translator, nodes.math_block("", tex))
    assert "".join(translator.body).count("<mtable") == 1


@pytest.mark.parametrize(
    ("words", "kept"),
    [
        ("in 5 s, 6 % of it", "in 5_s, 6_% of it"),
        ("4.9 N m at 9.81 m/s² and 2 kg m²", "4.9_N_m at 9.81_m/s² and 2_kg_m²"),
        ("2 springs and 3 masses, joint 2 grows", "2 springs and 3 masses, joint 2 grows"),
        ("FK, 1 000 000 poses, 2 at 100", "FK, 1_000_000 poses, 2 at 100"),
    ],
)
def test_unit_is_not_broken_from_its_number(words, kept):
    paragraph = nodes.paragraph("", "", nodes.Text(words), nodes.literal("", "5 s"))
    for text in list(paragraph.findall(nodes.Text)):
        keep_words_unbroken(text)
    assert paragraph.astext() == kept.replace("_", "\N{NO-BREAK SPACE}") + "5 s"


@pytest.mark.parametrize(
    ("before", "behind", "shown"),
    [
        ("", " N, along", ["+5 N,", " along"]),
        ("", ". So", ["+5.", " So"]),
        ("", ".5 m", ["+5", ".5 m"]),
        ("", " N m.", ["+5 N m."]),
        ("tip (“", " so)", ["tip ", "(“+5", " so)"]),
        ("", " apples", ["+5", " apples"]),
    ],
)
def test_text_touching_a_formula_stays_on_its_line(before, behind, shown):
    around = [nodes.Text(before)] if before else []
    paragraph = nodes.paragraph("", "", *around, nodes.math("", "+5"), nodes.Text(behind))
    join_to_neighbours(paragraph[len(around)])
    parts = [part.astext().replace("\N{NO-BREAK SPACE}", " ") for part in paragraph]
    assert re.sub("[{}]", "", "".join(parts)) == before + "+5" + behind
    assert [part for part in parts if part] == shown
    assert ("together" in str(paragraph)) == ("+5" not in shown)


def test_comma_after_formula_leaves_an_equal_comma_in_place():
    marked, formula = nodes.strong("", "Jacobian"), nodes.math("", "x")
    paragraph = nodes.paragraph(
        "", "", marked, nodes.Text(", "), formula, nodes.Text(", "), nodes.emphasis("", "y")
    )
    join_to_neighbours(formula)
    assert paragraph.astext() == "Jacobian, x, y"


@pytest.mark.parametrize(
    ("of", "words", "unbroken"),
    [
        (nodes.paragraph, "where z_{i-1}, 2 m-long, belongs", ["z_{i-1},"]),
        (nodes.literal, "grade --as-root z_{i-1} -", ["--as-root"]),
        (nodes.literal_block, "z_{i-1} --out", []),
    ],
)
def test_index_and_option_are_not_broken_at_hyphen(of, words, unbroken):
    paragraph = of("", "", nodes.Text(words))
    keep_words_unbroken(paragraph[0])
    assert paragraph.astext().replace("\N{NO-BREAK SPACE}", " ") == words
    assert [part.astext() for part in paragraph.findall(nodes.inline)] == unbroken


def test_typed_code_gets_straight_quotes():
    paragraph = nodes.paragraph("", "", nodes.Text("“so”: x=”craig” or f[“arm”]"))
    keep_words_unbroken(paragraph[0])
    assert paragraph.astext() == '“so”: x="craig" or f["arm"]'


@pytest.mark.parametrize(
    ("tex", "text"),
    [
        (r"\dot q", "q\N{COMBINING DOT ABOVE}"),
        (r"\ddot{q}", "q\N{COMBINING DIAERESIS}"),
        (r"\hat\omega", "ω\N{COMBINING CIRCUMFLEX ACCENT}"),
        (r"\bar x", "x\N{COMBINING MACRON}"),
        (r"\tilde{J}", "J\N{COMBINING TILDE}"),
        (r"\sin\theta_1", "sin θ_1"),
        (r"a_2\cos q_2", "a_2 cos q_2"),
        (r"d_3\sin(q_1)", "d_3 sin(q_1)"),
        (r"\tfrac{\lambda}{2}", "λ/2"),
        (r"90^\circ", "90°"),
        (r"\text{if} a\leq b", "if a≤b"),
        (r"{}^0T_n", "0T_n"),
        (r"\unknown", ""),
        ("q" * 31, ""),
    ],
)
def test_search_entry_contains_short_formula_as_text(tex, text):
    assert write_formula(tex) == text
